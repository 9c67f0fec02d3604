"""A muon telescope made of parallel planes of crossed bars."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError

#: Most bars along one side: (2·1000 − 1)² trajectories fill 32 MB an array.
MAXIMUM_BARS = 1000

#: Sizes in cm beyond which a number is a slip of the unit.
MAXIMUM_LENGTH_CM = 1e5


@dataclass(frozen=True)
class TelescopeGeometry:
    """Parallel planes of crossed bars, one behind another.

    A muon is known by the pixel that it crosses in the front plane and in the back
    plane. Pairs of pixels with the same offset (m, n) look in the same direction and
    make one trajectory: m = −(N_x − 1) … N_x − 1 to the right and n alike upwards. A
    straight track through two pixels crosses every plane between them within its
    edges, so planes in between change neither directions nor acceptance.

    Parameters
    ----------
    bars_x, bars_y
        Number of bars side by side across and up, N_x and N_y.
    pixel_size_cm
        Width d of a bar, the side of a pixel.
    separation_cm
        Distance D between the front and the back plane.
    planes
        Number of planes, the outer two included.

    Raises
    ------
    MuyscError
        If a number cannot be that of a telescope.
    """

    bars_x: int
    bars_y: int
    pixel_size_cm: float
    separation_cm: float
    planes: int = 2

    def __post_init__(self) -> None:
        for name, bars in (("across", self.bars_x), ("up", self.bars_y)):
            if bars != int(bars) or not 1 <= bars <= MAXIMUM_BARS:
                raise MuyscError(
                    f"{bars:g} bars {name} make no telescope; give a whole number from 1 to "
                    f"{MAXIMUM_BARS}."
                )
        for name, length in (
            ("pixel size", self.pixel_size_cm),
            ("separation of the planes", self.separation_cm),
        ):
            if not 0 < length <= MAXIMUM_LENGTH_CM:
                raise MuyscError(
                    f"A {name} of {length:g} cm is impossible; give a length above 0 and up to "
                    f"{MAXIMUM_LENGTH_CM:g} cm."
                )
        if self.planes != int(self.planes) or not 2 <= self.planes <= 20:
            raise MuyscError(
                f"{self.planes:g} planes give no direction or too many layers; give a whole "
                "number from 2 to 20."
            )

        # A whole number may come as a float.
        for name in ("bars_x", "bars_y", "planes"):
            object.__setattr__(self, name, int(getattr(self, name)))

    @property
    def step(self) -> float:
        """Spacing d/D of the trajectories in the tangent of the angle."""
        return self.pixel_size_cm / self.separation_cm

    @property
    def offset_x(self) -> np.ndarray:
        """(2 N_x − 1,) pixel offsets m to the right, increasing."""
        return np.arange(1 - self.bars_x, self.bars_x)

    @property
    def offset_y(self) -> np.ndarray:
        """(2 N_y − 1,) pixel offsets n upwards, decreasing as the rows of a raster."""
        return np.arange(self.bars_y - 1, -self.bars_y, -1)

    @property
    def trajectories(self) -> int:
        """Number of distinct directions."""
        return (2 * self.bars_x - 1) * (2 * self.bars_y - 1)

    @property
    def half_aperture_deg(self) -> tuple[float, float]:
        """Largest angle from the boresight across and up, atan(N d/D), in degrees."""
        return (
            math.degrees(math.atan(self.bars_x * self.step)),
            math.degrees(math.atan(self.bars_y * self.step)),
        )
