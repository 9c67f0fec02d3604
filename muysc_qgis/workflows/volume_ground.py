"""The terrain of a DEM on a regular grid over a volume."""

from __future__ import annotations

import math

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, report, silent
from ..tomography.ground import HeightField
from ..tomography.voxels import VoxelGrid
from ..topography.dem import Dem
from ..topography.frame import transformed
from ..topography.sampling import heights_at
from .volume_frame import VolumeFrame

#: Nodes of the ground are at most this share of a DEM cell apart, where they cannot be its own.
_OF_CELL = 0.5

#: And at least this share of a voxel, because finer ground costs time that no voxel shows.
_OF_VOXEL = 0.25

#: Points sampled at a time; bounds the memory.
_BLOCK = 1 << 19


def ground_below(
    grid: VoxelGrid, frame: VolumeFrame, dem: Dem, progress: Progress = silent
) -> HeightField:
    """Return the ground over a volume, in the frame.

    A DEM in the volume's own projection keeps its cells, so that nothing is lost. Another is
    sampled, bilinear, twice per cell; one much finer than the voxels is averaged.

    Parameters
    ----------
    grid, frame
        The volume in the CRS of the frame.
    dem
        Terrain over the whole volume.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If the DEM ends or has a gap within the volume, or cannot be read.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    low, step = _nodes(grid, frame, dem)
    counts = [
        math.ceil((end - first) / width - 1e-9) + 1
        for first, width, end in zip(low, step, grid.end_m[:2])
    ]
    parts = _points_per_node(frame, dem, step)
    offsets = ((np.arange(parts) + 0.5) / parts - 0.5) * (parts > 1)
    east = low[0] + step[0] * (np.arange(counts[0])[:, None] + offsets).ravel()
    height = np.empty(counts)
    columns = max(1, _BLOCK // (len(east) * parts))
    for first in range(0, counts[1], columns):
        report(progress, first / counts[1])
        nodes = np.arange(first, min(first + columns, counts[1]))
        north = low[1] + step[1] * (nodes[:, None] + offsets).ravel()
        # What is averaged may lie beyond the last node, and the DEM ends there.
        x = np.clip(east, *_span(grid, 0))[:, None] if parts > 1 else east[:, None]
        y = np.clip(north, *_span(grid, 1))[None, :] if parts > 1 else north[None, :]
        points = transformed(frame.crs, dem.crs, *np.broadcast_arrays(x, y), by=dem.transformation)
        heights = heights_at(dem, *dem.grid_position(*points))
        heights = heights.reshape(counts[0], parts, len(nodes), parts).mean(axis=(1, 3))
        height[:, nodes] = heights
    if not np.isfinite(height).all():
        _refuse(height, dem)
    nodes_x, nodes_y = (first + width * np.arange(n) for first, width, n in zip(low, step, counts))
    east_m, north_m = frame.local(nodes_x[:, None], nodes_y[None, :])
    height -= frame.drop(east_m, north_m)
    origin = frame.local(*np.array(low))
    return HeightField(
        (float(origin[0]), float(origin[1])),
        (step[0] / frame.scale, step[1] / frame.scale),
        height,
    )


def _span(grid: VoxelGrid, axis: int) -> tuple[float, float]:
    return grid.origin_m[axis], grid.end_m[axis]


def _nodes(
    grid: VoxelGrid, frame: VolumeFrame, dem: Dem
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the first node and the distances of the nodes, in the CRS."""
    left, width, skew_x, top, skew_y, height = dem.geotransform
    fine = _OF_VOXEL * min(grid.size_m[:2])
    upright = not skew_x and not skew_y and width > 0 > height
    if dem.crs == frame.crs and upright and min(width, -height) >= fine:
        # The DEM's own cell centres, counted from the south-west.
        west, south = left + width / 2, top + (dem.rows - 0.5) * height
        low = [
            first + step * math.floor((start - first) / step + 1e-9)
            for first, step, start in zip((west, south), (width, -height), grid.origin_m[:2])
        ]
        return (low[0], low[1]), (width, -height)
    step = max(_OF_CELL * _cell_m(frame, dem), fine)
    # The rim itself is a node at both ends, so that nothing beyond it is needed.
    spans = [grid.end_m[axis] - grid.origin_m[axis] for axis in (0, 1)]
    steps = [span / math.ceil(span / step) for span in spans]
    return (grid.origin_m[0], grid.origin_m[1]), (steps[0], steps[1])


def _points_per_node(frame: VolumeFrame, dem: Dem, step: tuple[float, float]) -> int:
    """Return how many points of a fine DEM are averaged along each side of a node's cell."""
    return max(1, math.ceil(0.5 * max(step) / _cell_m(frame, dem)))


def _cell_m(frame: VolumeFrame, dem: Dem) -> float:
    """Return the shorter side of a DEM cell at the frame's middle, in metres of the CRS."""
    x, y = np.array([frame.middle[0]]), np.array([frame.middle[1]])
    column, row = dem.grid_position(*transformed(frame.crs, dem.crs, x, y, by=dem.transformation))
    there = dem.crs_position(np.concatenate([column + 1, column]), np.concatenate([row, row + 1]))
    beside_x, beside_y = transformed(dem.crs, frame.crs, *there, by=dem.transformation)
    return float(np.hypot(beside_x - x, beside_y - y).min())


def _refuse(height: np.ndarray, dem: Dem) -> None:
    share = np.count_nonzero(~np.isfinite(height)) / height.size
    raise MuyscError(
        f"The elevation model {dem.name} has no heights for {100 * share:.2g} % of the volume, "
        "which reaches beyond its edge or over a gap; choose a smaller extent, or a larger "
        "elevation model without gaps."
    )
