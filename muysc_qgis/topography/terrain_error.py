"""How wrong a thickness is when terrain and pointing are: from the derivatives of each ray."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, part, silent
from ..radiography.raytracing import RockPaths
from .frame import LocalFrame
from .tracing import trace_terrain

#: Errors of terrain (m), of pointing (°) and lengths (m) beyond which a number is a slip.
_HIGHEST_M, _WIDEST_DEG, _LONGEST_M = 1000.0, 30.0, 1e5


@dataclass(frozen=True)
class TerrainErrors:
    """How well terrain and pointing are known, one standard deviation each.

    Parameters
    ----------
    terrain_m
        Of the heights of the terrain.
    pointing_deg
        Of the elevation angle that the detector points at.
    correlation_m
        Distance within which heights are wrong alike.

    Raises
    ------
    MuyscError
        If a number is out of range.
    """

    terrain_m: float = 5.0
    pointing_deg: float = 0.0
    correlation_m: float = 100.0

    def __post_init__(self) -> None:
        for value, limit, name, unit in (
            (self.terrain_m, _HIGHEST_M, "terrain error", "m"),
            (self.pointing_deg, _WIDEST_DEG, "pointing error", "°"),
            (self.correlation_m, _LONGEST_M, "correlation length of the terrain error", "m"),
        ):
            if not 0 <= value <= limit:
                raise MuyscError(
                    f"A {name} of {value:g} {unit} cannot be used; give a number from 0 to "
                    f"{limit:g} {unit}."
                )


def thickness_error(
    frame: LocalFrame,
    eye_m: float,
    azimuth_deg: np.ndarray,
    elevation_deg: np.ndarray,
    errors: TerrainErrors,
    max_range_m: float | None = None,
    near_field_m: float = 0.0,
    width_deg: float = 0.0,
    progress: Progress = silent,
) -> np.ndarray:
    """Return the standard errors of the rock along rays, in m.

    Where a ray meets the ground, heights that are wrong by δz shift the place along it: by
    δz/|tan α − slope|, steeper ground by less. The shifts of entry and exit follow from rays
    through the terrain raised and lowered by one standard deviation; they are far apart and
    so independent, as is what other ridges add. Ground within the correlation length is wrong
    as that under the detector is, and so makes no difference. The pointing tilts all rays
    alike: half the difference of the thicknesses one standard deviation above and below.

    Parameters
    ----------
    frame, eye_m, azimuth_deg, elevation_deg, max_range_m, near_field_m
        As in `trace_terrain`.
    errors
        How well terrain and pointing are known.
    width_deg
        Width of what is averaged over, 0 for single rays. At a distance d it spans
        (1 + d·width/correlation length)² patches that are wrong each in its own way.
    progress
        Told the share done.

    Returns
    -------
    numpy.ndarray
        (n_azimuth, n_elevation); NaN where the rock is unknown, 0 where no error makes a
        difference.

    Raises
    ------
    MuyscError
        If the DEM cannot be read.
    Cancelled
        If `progress` asks for a stop.
    """
    near_m = max(near_field_m, errors.correlation_m)
    turns = 4 if errors.pointing_deg > 0 else 2

    def trace(turn: int, raised_m: float, tilted_deg: float) -> RockPaths:
        return trace_terrain(
            frame,
            eye_m - raised_m,
            azimuth_deg,
            np.clip(elevation_deg + tilted_deg, -89.999, 90.0),
            max_range_m,
            near_m,
            part(progress, turn / turns, (turn + 1) / turns),
        )

    up, down = trace(0, errors.terrain_m, 0.0), trace(1, -errors.terrain_m, 0.0)
    both = np.isfinite(up.distance_m) & np.isfinite(down.distance_m)
    both &= np.isfinite(up.exit_m) & np.isfinite(down.exit_m)
    whole = np.abs(up.thickness_m - down.thickness_m) / 2
    entry = np.where(both, down.distance_m - up.distance_m, 0.0) / 2
    leave = np.where(both, up.exit_m - down.exit_m, 0.0) / 2
    rest = np.where(both, np.maximum(whole - np.abs(entry) - np.abs(leave), 0.0), whole)
    near, far = (
        _patches(np.fmax(getattr(up, name), getattr(down, name)), width_deg, errors)
        for name in ("distance_m", "exit_m")
    )
    variance = (entry / near) ** 2 + (leave / far) ** 2 + (rest / far) ** 2
    if errors.pointing_deg > 0:
        above, below = trace(2, 0.0, errors.pointing_deg), trace(3, 0.0, -errors.pointing_deg)
        variance += ((above.thickness_m - below.thickness_m) / 2) ** 2
    return np.asarray(np.sqrt(np.where(np.isnan(whole), np.nan, variance)))


def _patches(distance_m: np.ndarray, width_deg: float, errors: TerrainErrors) -> np.ndarray:
    """Return the root of the number of patches of terrain within a width, at distances."""
    if width_deg <= 0 or errors.correlation_m <= 0:
        return np.ones(distance_m.shape)
    return 1.0 + np.nan_to_num(distance_m) * np.radians(width_deg) / errors.correlation_m
