"""Between the plane of a telescope's trajectories and directions in the sky.

The trajectory (m, n) runs along b + x r + y u, with the boresight b, the telescope's
right r and up u, and the tangents x = m d/D and y = n d/D: the gnomonic projection of
the sky. A roll turns r and u clockwise about the boresight, as seen looking along it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError


@dataclass(frozen=True)
class Pointing:
    """Where a telescope points.

    Parameters
    ----------
    azimuth_deg
        Of the boresight, clockwise from true north.
    elevation_deg
        Of the boresight above the horizontal, −90 to 90.
    roll_deg
        Clockwise turn about the boresight, seen looking along it: with 90° the
        telescope's right points down.

    Raises
    ------
    MuyscError
        If an angle cannot be used.
    """

    azimuth_deg: float
    elevation_deg: float
    roll_deg: float = 0.0

    def __post_init__(self) -> None:
        for name, angle, limit in (
            ("azimuth", self.azimuth_deg, 360.0),
            ("elevation", self.elevation_deg, 90.0),
            ("roll", self.roll_deg, 360.0),
        ):
            if not abs(angle) <= limit:
                what = "A roll" if name == "roll" else f"A boresight {name}"
                raise MuyscError(
                    f"{what} of {angle:g}° is impossible; give an angle from −{limit:g} to "
                    f"{limit:g}°."
                )

    def axes(self) -> np.ndarray:
        """Return boresight, right and up as rows of (east, north, up)."""
        azimuth, elevation, roll = (
            math.radians(angle) for angle in (self.azimuth_deg, self.elevation_deg, self.roll_deg)
        )
        sin_a, cos_a = math.sin(azimuth), math.cos(azimuth)
        sin_e, cos_e = math.sin(elevation), math.cos(elevation)
        level = np.array([cos_a, -sin_a, 0.0])
        above = np.array([-sin_e * sin_a, -sin_e * cos_a, cos_e])
        return np.array(
            [
                [cos_e * sin_a, cos_e * cos_a, sin_e],
                math.cos(roll) * level - math.sin(roll) * above,
                math.cos(roll) * above + math.sin(roll) * level,
            ]
        )

    def sky(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return azimuth and elevation in degrees of tangents to the right and up.

        The azimuth is within 180° of the boresight's, so that it is continuous across
        north.
        """
        boresight, right, up = self.axes()
        x, y = np.broadcast_arrays(np.asarray(x, dtype=float), np.asarray(y, dtype=float))
        east, north, high = (boresight[i] + x * right[i] + y * up[i] for i in range(3))
        azimuth = np.degrees(np.arctan2(east, north))
        turned = (azimuth - self.azimuth_deg + 180.0) % 360.0 - 180.0
        return self.azimuth_deg + turned, np.degrees(np.arctan2(high, np.hypot(east, north)))

    def plane(
        self, azimuth_deg: np.ndarray, elevation_deg: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the tangents to the right and up of directions, NaN behind the telescope."""
        azimuth, elevation = np.radians(azimuth_deg), np.radians(elevation_deg)
        direction = (
            np.cos(elevation) * np.sin(azimuth),
            np.cos(elevation) * np.cos(azimuth),
            np.sin(elevation),
        )
        along, x, y = (sum(axis[i] * direction[i] for i in range(3)) for axis in self.axes())
        ahead = np.where(along > 1e-9, along, np.nan)
        return x / ahead, y / ahead
