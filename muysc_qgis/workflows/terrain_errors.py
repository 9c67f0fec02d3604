"""How much longer or shorter rays in rock are where the terrain is higher than it is thought."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..tomography.ground import HeightField
from ..tomography.lattice import Lattice
from ..tomography.libraries import scipy_part
from ..tomography.rays import Rays
from ..tomography.voxels import VoxelGrid
from ..topography.dem import Dem
from .sightlines import Sightlines, rays_of
from .station_data import RockSeen, StationData
from .volume_ground import ground_below

#: Half the length (m) over which the slope of ground along a ray is taken.
_AROUND_M = 5.0

#: Distance (m) of the end of a stretch from the ground up to which it ends there, not at the
#: volume's side; and from the first or last rock on the ray up to which it is that.
_AT_GROUND_M = 1.0

#: Least angle (as a tangent) between ray and ground: what is unknown of the terrain has slopes of
#: its own, so that no ray grazes it more than that.
_LEAST_TANGENT = 0.05

#: Nodes of the terrain's errors over their correlation length, and the most of them.
_PER_LENGTH, _MOST_NODES = 2.0, 400_000


def terrain_changes(
    stations: Sequence[StationData],
    rock: Sequence[RockSeen],
    lines: Sightlines,
    dem: Dem,
    length_m: float,
) -> tuple[Any, Lattice]:
    """Return ∂L/∂z of sub-rays over heights of the terrain.

    Where ground is higher by δz a ray enters it earlier by δz over the depth that it gains a
    metre: the sine of the angle between ray and ground over the cosine of the slope. Counted are
    the first entry into rock, the last exit, and those between that are within the volume.

    Parameters
    ----------
    stations, rock
        All sub-rays, and the rock along them.
    lines
        Those of them that meet the volume.
    dem
        Terrain.
    length_m
        Over which errors of the terrain are alike, m; nodes are half of that apart.

    Returns
    -------
    tuple
        (n_sub, n_nodes) CSR, m of rock for a metre of height, and the lattice of the nodes.

    Raises
    ------
    MuyscError
        If the DEM cannot be read.
    """
    sparse = scipy_part("sparse")
    rays = rays_of(stations, lines.frame)
    crossings = _crossings(rays, rock, lines)
    ray, distance, sign = crossings
    place = rays.origin_m[ray] + distance[:, None] * rays.direction[ray]
    ground = _ground_over(place, lines, dem)

    def depth(along: np.ndarray) -> np.ndarray:
        point = rays.origin_m[ray] + along[:, None] * rays.direction[ray]
        return ground.at(point[:, 0], point[:, 1]) - point[:, 2]

    gain = sign * (depth(distance + _AROUND_M) - depth(distance - _AROUND_M)) / (2 * _AROUND_M)
    # What ends at a side of the volume does not end at the ground.
    at_ground = np.abs(depth(distance)) < _AT_GROUND_M
    change = np.where(at_ground, 1.0 / np.hypot(np.maximum(gain, 0.0), _LEAST_TANGENT), 0.0)
    low = place[:, :2].min(axis=0)
    span = np.ptp(place[:, :2], axis=0)
    step = length_m / _PER_LENGTH
    if np.prod(span / step + 2) > _MOST_NODES:
        step = math.sqrt(float(np.prod(span)) / _MOST_NODES)
    shape = tuple(math.ceil(one / step) + 2 for one in span)
    lattice = Lattice((step, step), np.ones(shape, bool))
    position = (place[:, :2] - low) / step
    cell = position.astype(int)
    share = position - cell
    rows, columns, values = [], [], []
    for east in (0, 1):
        for north in (0, 1):
            weight = (share[:, 0] if east else 1 - share[:, 0]) * (
                share[:, 1] if north else 1 - share[:, 1]
            )
            rows.append(ray)
            columns.append((cell[:, 0] + east) * shape[1] + cell[:, 1] + north)
            values.append(change * weight)
    matrix = sparse.csr_matrix(
        (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
        shape=(len(rays), lattice.count),
    )
    matrix.eliminate_zeros()
    return matrix, lattice


def _crossings(
    rays: Rays, rock: Sequence[RockSeen], lines: Sightlines
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return ray, distance (m) and sense (1 into rock, −1 out of it) of crossings of the ground."""
    first = np.concatenate([seen.distance_m for seen in rock])
    last = np.concatenate([seen.exit_m for seen in rock])
    stretch = lines.paths.stretches
    pixel = lines.pixel[stretch.ray]
    parts = [
        (np.flatnonzero(np.isfinite(first)), first[np.isfinite(first)], 1.0),
        (np.flatnonzero(np.isfinite(last)), last[np.isfinite(last)], -1.0),
    ]
    for distance, sign in ((stretch.start_m, 1.0), (stretch.end_m, -1.0)):
        between = (np.abs(distance - first[pixel]) > _AT_GROUND_M) & (
            np.abs(distance - last[pixel]) > _AT_GROUND_M
        )
        parts.append((pixel[between], distance[between], sign))
    # A ray that starts in the ground does not enter it.
    parts = [(ray[far > _AROUND_M], far[far > _AROUND_M], sign) for ray, far, sign in parts]
    return (
        np.concatenate([ray for ray, _, _ in parts]),
        np.concatenate([far for _, far, _ in parts]),
        np.concatenate([np.full(len(ray), sign) for ray, _, sign in parts]),
    )


def _ground_over(place: np.ndarray, lines: Sightlines, dem: Dem) -> HeightField:
    """Return the ground over all places in the frame where rays meet it."""
    frame, grid = lines.frame, lines.grid
    x = frame.middle[0] + frame.scale * place[:, 0]
    y = frame.middle[1] + frame.scale * place[:, 1]
    margin = 2 * _AROUND_M
    low = [min(float(axis.min()) - margin, grid.origin_m[n]) for n, axis in enumerate((x, y))]
    high = [max(float(axis.max()) + margin, grid.end_m[n]) for n, axis in enumerate((x, y))]
    counts = [math.ceil((b - a) / size) for a, b, size in zip(low, high, grid.size_m)]
    sizes = [(b - a) / count for a, b, count in zip(low, high, counts)]
    wide = VoxelGrid(
        (low[0], low[1], grid.origin_m[2]), (sizes[0], sizes[1], grid.size_m[2]),
        (counts[0], counts[1], grid.shape[2]),
    )  # fmt: skip
    return ground_below(wide, frame, dem)
