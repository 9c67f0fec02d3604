"""Places where a telescope might stand, and the limits that leave some of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..topography.dem import Dem
from ..topography.frame import ground_height, local_frame, transformed
from ..topography.relief import dem_cell_m
from ..topography.sampling import heights_at
from .map_grid import MapGrid
from .masks import Mask
from .roads import distance_to_lines


def check_slope(slope_deg: float | None) -> None:
    """Refuse a steepest slope, degrees or None for any, that leaves or limits nothing.

    Raises
    ------
    MuyscError
        If it is not above 0° and up to 90°.
    """
    if slope_deg is not None and not 0 < slope_deg <= 90:
        raise MuyscError(
            f"A slope of {slope_deg:g}° is no limit; give degrees above 0 and up to 90."
        )


@dataclass(frozen=True)
class Limits:
    """What a place must keep to; None is no limit.

    Raises
    ------
    MuyscError
        If a limit leaves nothing.
    """

    nearest_m: float = 0.0
    farthest_m: float = np.inf
    #: Steepest slope, degrees.
    slope_deg: float | None = None
    #: Most that the ground may be above and below the target's.
    above_m: float | None = None
    below_m: float | None = None
    #: Farthest from a road.
    road_m: float | None = None

    def __post_init__(self) -> None:
        if not 0 <= self.nearest_m < self.farthest_m:
            raise MuyscError(
                f"Distances from {self.nearest_m:g} to {self.farthest_m:g} m leave no place; give "
                "a first one of 0 m or more and a larger second one."
            )
        check_slope(self.slope_deg)
        if self.road_m is not None and not 0 < self.road_m < np.inf:
            raise MuyscError(
                f"A distance of {self.road_m:g} m to roads leaves no place; give one above 0 m."
            )


@dataclass(frozen=True)
class Candidates:
    """Places that keep to all limits. Arrays have shape (n,)."""

    grid: MapGrid
    #: Positions in the DEM's CRS.
    x: np.ndarray
    y: np.ndarray
    #: Cell of the grid that each lies in, counted row by row.
    cell: np.ndarray
    #: From the target: horizontal distance (m), and azimuth in degrees.
    distance_m: np.ndarray
    azimuth_deg: np.ndarray
    #: Slope of the ground, degrees.
    slope_deg: np.ndarray
    #: Distance to the nearest road (m), NaN where no roads are given.
    road_m: np.ndarray
    #: Number of places that each limit removed, in the order in which they were applied.
    removed: Mapping[str, int]

    def __len__(self) -> int:
        return len(self.x)

    @property
    def positions(self) -> np.ndarray:
        """(n, 2) positions in the DEM's CRS."""
        return np.column_stack([self.x, self.y])


def find_candidates(
    dem: Dem,
    target: tuple[float, float],
    grid: MapGrid,
    limits: Limits,
    places: tuple[np.ndarray, np.ndarray] | None = None,
    mask: Mask | None = None,
    roads: np.ndarray | None = None,
) -> Candidates:
    """Return the places that keep to all limits.

    Parameters
    ----------
    dem
        Terrain.
    target
        (x, y) in the DEM's CRS.
    grid
        Whose cell centres are the places, unless `places` are given.
    limits
        What places must keep to.
    places
        (n,) x and y in the grid's CRS.
    mask
        Where places may lie, None for everywhere.
    roads
        (m, 4) segments of roads in the grid's CRS, None for no limit.

    Raises
    ------
    MuyscError
        If no place is left, with the number that each limit removed, or the target is
        off the DEM.
    """
    map_x, map_y = grid.centres() if places is None else places
    x, y = transformed(grid.crs, dem.crs, map_x, map_y, by=dem.transformation)
    column, row = dem.grid_position(x, y)
    height = heights_at(dem, column, row)
    frame = local_frame(dem, *target, "target")
    azimuth, distance = frame.polar(column, row)
    above = height - ground_height(dem, *target, "target")
    slope = _slope_deg(dem, grid, map_x, map_y, dem_cell_m(frame))
    road = np.full(len(x), np.nan)
    if roads is not None and limits.road_m is not None:
        road = distance_to_lines(map_x, map_y, roads, limits.road_m)

    tests: dict[str, np.ndarray] = {}
    # Corners of the square around the circle are no places, so they are not counted.
    kept = distance <= limits.farthest_m if places is None else np.ones(len(x), bool)
    asked = int(kept.sum())
    tests["off the DEM or in a gap of it"] = np.isfinite(height)
    if mask is not None:
        tests["outside the mask"] = mask.holds(grid.crs, map_x, map_y, dem.transformation)
    tests[f"nearer than {limits.nearest_m:g} m to the target"] = distance >= limits.nearest_m
    tests[f"farther than {limits.farthest_m:g} m from the target"] = distance <= limits.farthest_m
    if limits.slope_deg is not None:
        # Where a neighbour is unknown so is the slope, and the place is not refused for it.
        tests[f"steeper than {limits.slope_deg:g}°"] = ~(slope > limits.slope_deg)
    if limits.above_m is not None:
        tests[f"more than {limits.above_m:g} m above the target"] = above <= limits.above_m
    if limits.below_m is not None:
        tests[f"more than {limits.below_m:g} m below the target"] = -above <= limits.below_m
    if limits.road_m is not None and roads is not None:
        tests[f"farther than {limits.road_m:g} m from a road"] = np.isfinite(road)
    removed = {}
    for name, passed in tests.items():
        removed[name] = int(np.count_nonzero(kept & ~passed))
        kept = kept & passed
    if not kept.any():
        raise MuyscError(_nothing_left(asked, removed))
    cell = grid.cell_of(map_x, map_y)
    x, y, cell, distance, azimuth, slope, road = (
        one[kept] for one in (x, y, cell, distance, azimuth, slope, road)
    )
    return Candidates(grid, x, y, cell, distance, azimuth, slope, road, removed)


def _slope_deg(dem: Dem, grid: MapGrid, x: np.ndarray, y: np.ndarray, step_m: float) -> np.ndarray:
    """Return the slope between points one step to each side, degrees."""

    def height(dx: float, dy: float) -> np.ndarray:
        moved = transformed(grid.crs, dem.crs, x + dx, y + dy, by=dem.transformation)
        return heights_at(dem, *dem.grid_position(*moved))

    east = (height(step_m, 0.0) - height(-step_m, 0.0)) / (2 * step_m)
    north = (height(0.0, step_m) - height(0.0, -step_m)) / (2 * step_m)
    return np.degrees(np.arctan(np.hypot(east, north)))


def _nothing_left(asked: int, removed: Mapping[str, int]) -> str:
    reasons = ", ".join(f"{count} are {name}" for name, count in removed.items() if count)
    return (
        f"None of {asked} places is left as a candidate: {reasons or 'there is none'}; loosen the "
        "limit that removes most."
    )
