"""The part of a mountain that a survey is about, as points of equal volume."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..topography.dem import Dem
from ..topography.frame import LocalFrame, ground_height, local_frame
from ..topography.sampling import heights_at

#: Columns of points from the middle of the body to its rim.
_COLUMNS = 8
#: Points of a body, roughly: shares of it are then exact to about 0.2 %.
_POINTS = 3000


@dataclass(frozen=True)
class TargetBody:
    """Points of equal volume in the rock under and around a target."""

    #: (n_column,) positions on the DEM's grid.
    column: np.ndarray
    row: np.ndarray
    #: (n_point,) which of these columns a point lies in, and its height (m).
    place: np.ndarray
    height_m: np.ndarray

    def seen_from(self, frame: LocalFrame, eye_m: float) -> tuple[np.ndarray, np.ndarray]:
        """Return azimuth and elevation (degrees) of every point from a detector, (n_point,)."""
        azimuth, distance = frame.polar(self.column, self.row)
        drop = eye_m + frame.drop(distance)
        rise = self.height_m - drop[self.place]
        return azimuth[self.place], np.degrees(np.arctan2(rise, distance[self.place]))


def target_body(
    dem: Dem, target: tuple[float, float], radius_m: float, depth_m: float
) -> TargetBody:
    """Return the rock around a target: a vertical cylinder under the ground.

    Parameters
    ----------
    dem
        Terrain.
    target
        (x, y) in the DEM's CRS, the cylinder's axis.
    radius_m
        Its radius.
    depth_m
        How far it reaches below the ground at the target.

    Raises
    ------
    MuyscError
        If a length is not above 0, or the target is off the DEM or on no-data.
    """
    for name, length in (("radius", radius_m), ("depth", depth_m)):
        if not 0 < length < np.inf:
            raise MuyscError(
                f"A target {name} of {length:g} m is impossible; give a length above 0 m."
            )
    base = ground_height(dem, *target, "target") - depth_m
    frame = local_frame(dem, *target, "target")
    step = radius_m / _COLUMNS
    east, north = np.mgrid[-_COLUMNS : _COLUMNS + 1, -_COLUMNS : _COLUMNS + 1] * step
    within = np.hypot(east, north) <= radius_m
    east, north = east[within], north[within]
    column, row = frame.ground_positions(np.degrees(np.arctan2(east, north)), np.hypot(east, north))
    thickness = heights_at(dem, column, row) - base
    rock = thickness > 0  # not NaN either
    column, row, thickness = column[rock], row[rock], thickness[rock]
    spacing = thickness.sum() / _POINTS
    levels = np.maximum(np.round(thickness / spacing), 1).astype(np.int64)
    place = np.repeat(np.arange(len(levels)), levels)
    level = np.arange(len(place)) - np.repeat(np.cumsum(levels) - levels, levels)
    height = base + thickness[place] * (level + 0.5) / levels[place]
    return TargetBody(column, row, place, height)
