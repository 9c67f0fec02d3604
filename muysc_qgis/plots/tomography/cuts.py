"""Plane pictures out of a volume: slices, sections and views, and the ground along them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...errors import MuyscError
from ...tomography.voxels import VIEW_AXES
from ...topography.relief import Relief
from ...volume import Volume

#: Points of a ground line.
_GROUND_POINTS = 400

#: Points of a section along a line per voxel edge.
_PER_VOXEL = 2


@dataclass(frozen=True)
class Cut:
    """Values of cells in a plane.

    Parameters
    ----------
    values
        (n_across, n_up), NaN where unknown.
    limits_m
        Left, right, bottom and top edge of the cells.
    across, up
        What runs along the axes.
    """

    values: np.ndarray
    limits_m: tuple[float, float, float, float]
    across: str
    up: str

    @property
    def size_m(self) -> tuple[float, float]:
        """Width and height."""
        left, right, bottom, top = self.limits_m
        return right - left, top - bottom

    @property
    def is_vertical(self) -> bool:
        """Whether heights run upwards in it."""
        return self.up == ELEVATION

    def with_values(self, values: np.ndarray) -> Cut:
        """Return other values of the same cells."""
        return replace(self, values=values)


EASTING, NORTHING, DISTANCE, ELEVATION = "Easting", "Northing", "Distance", "Elevation"

_NAMES = (EASTING, NORTHING, ELEVATION)


def index_at(volume: Volume, axis: int, position_m: float) -> int:
    """Return which voxel along an axis holds a position, the outermost one beyond the volume."""
    grid = volume.grid
    place = (position_m - grid.origin_m[axis]) / grid.size_m[axis]
    return int(np.clip(np.floor(place), 0, grid.shape[axis] - 1))


def slice_at(volume: Volume, axis: int, position_m: float) -> Cut:
    """Return the slice of voxels that holds a position on an axis (0 east, 1 north, 2 up)."""
    return _cut(volume, axis, np.take(volume.values, index_at(volume, axis, position_m), axis))


def mean_view(volume: Volume, name: str) -> Cut:
    """Return the mean of the known voxels along an axis, for `top`, `front` or `side`."""
    axis = VIEW_AXES[name]
    known = volume.known
    count = known.sum(axis=axis)
    total = np.where(known, volume.values, 0.0).sum(axis=axis)
    mean = np.divide(total, count, out=np.full(total.shape, np.nan), where=count > 0)
    return _cut(volume, axis, mean)


def view_cut(volume: Volume, name: str, values: np.ndarray) -> Cut:
    """Return values of a view (`top`, `front` or `side`), such as sums, in their plane."""
    return _cut(volume, VIEW_AXES[name], values)


def _cut(volume: Volume, axis: int, values: np.ndarray) -> Cut:
    across, up = (other for other in range(3) if other != axis)
    low, high = volume.grid.origin_m, volume.grid.end_m
    limits = (low[across], high[across], low[up], high[up])
    return Cut(values, limits, _NAMES[across], _NAMES[up])


def along_line(volume: Volume, points_m: Sequence[tuple[float, float]] | np.ndarray) -> Cut:
    """Return the vertical section along a line, of the voxels that it crosses.

    Parameters
    ----------
    volume
        What is cut.
    points_m
        (n, 2) corners of the line in the CRS of the volume.

    Raises
    ------
    MuyscError
        If the line has no length.
    """
    grid = volume.grid
    distance, east, north = resampled(points_m, min(grid.size_m[:2]) / _PER_VOXEL)
    columns = []
    inside = np.ones(len(east), bool)
    for axis, place in ((0, east), (1, north)):
        number = np.floor((place - grid.origin_m[axis]) / grid.size_m[axis]).astype(int)
        inside &= (number >= 0) & (number < grid.shape[axis])
        columns.append(np.clip(number, 0, grid.shape[axis] - 1))
    values = np.where(inside[:, None], volume.values[columns[0], columns[1]], np.nan)
    half = (distance[1] - distance[0]) / 2
    limits = (
        float(distance[0] - half), float(distance[-1] + half), grid.origin_m[2], grid.end_m[2],
    )  # fmt: skip
    return Cut(values, limits, DISTANCE, ELEVATION)


def resampled(
    points_m: Sequence[tuple[float, float]] | np.ndarray, step_m: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return distances along a line, and the positions there, in equal steps of about a length.

    The points are the middles of the steps, (n,) each.

    Raises
    ------
    MuyscError
        If the line has no length.
    """
    points = np.asarray(points_m, float)
    lengths = np.hypot(*np.diff(points, axis=0).T) if len(points) > 1 else np.zeros(0)
    whole = float(lengths.sum())
    if not whole > 0:
        raise MuyscError(
            f"The line of the section has {len(points)} points and no length; draw one through "
            "the volume."
        )
    corners = np.concatenate([[0.0], np.cumsum(lengths)])
    count = max(2, round(whole / step_m))
    distance = whole * (np.arange(count) + 0.5) / count
    return (
        distance,
        np.interp(distance, corners, points[:, 0]),
        np.interp(distance, corners, points[:, 1]),
    )


def ground_between(
    relief: Relief, start_m: tuple[float, float], end_m: tuple[float, float]
) -> np.ndarray:
    """Return heights of the ground at evenly spaced points of a straight line, both ends in it."""
    share = np.linspace(0.0, 1.0, _GROUND_POINTS)
    return heights_along(
        relief,
        start_m[0] + share * (end_m[0] - start_m[0]),
        start_m[1] + share * (end_m[1] - start_m[1]),
    )


def heights_along(relief: Relief, east_m: np.ndarray, north_m: np.ndarray) -> np.ndarray:
    """Return the bilinear heights of a relief at points, NaN beyond it and where unknown."""
    column = _place(relief.east_m, east_m)
    row = _place(relief.north_m, north_m)
    rows, columns = relief.elevation_m.shape
    # Half a cell around the outermost heights they hold on.
    inside = (np.abs(column - (columns - 1) / 2) <= columns / 2) & (
        np.abs(row - (rows - 1) / 2) <= rows / 2
    )
    column, row = np.clip(column, 0, columns - 1), np.clip(row, 0, rows - 1)
    i = np.minimum(column.astype(int), columns - 2)
    j = np.minimum(row.astype(int), rows - 2)
    u, v = column - i, row - j
    cells = relief.elevation_m
    low = (1 - u) * cells[j, i] + u * cells[j, i + 1]
    high = (1 - u) * cells[j + 1, i] + u * cells[j + 1, i + 1]
    return np.where(inside, (1 - v) * low + v * high, np.nan)


def _place(centres: np.ndarray, positions: np.ndarray) -> np.ndarray:
    return (positions - centres[0]) / (centres[-1] - centres[0]) * (len(centres) - 1)
