"""How much longer or shorter rays in rock are where the terrain is higher than it is thought."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..tomography.lattice import Lattice
from ..tomography.libraries import scipy_part
from ..topography.dem import Dem
from .sightlines import Sightlines
from .volume_ground import ground_below

#: Half the length (m) over which the slope of ground along a ray is taken.
_AROUND_M = 5.0

#: Distance (m) of the end of a stretch from the ground up to which it ends there, not at the
#: volume's side.
_AT_GROUND_M = 1.0

#: Least angle (as a tangent) between ray and ground: what is unknown of the terrain has slopes of
#: its own, so that no ray grazes it more than that.
_LEAST_TANGENT = 0.05

#: Nodes of the terrain's errors over their correlation length.
_PER_LENGTH = 2.0


def terrain_changes(
    lines: Sightlines, dem: Dem, count: int, length_m: float
) -> tuple[Any, Lattice]:
    """Return ∂L/∂z of sub-rays over heights of the terrain.

    Where ground is higher by δz a ray enters it earlier by δz over the depth that it gains a
    metre: the sine of the angle between ray and ground over the cosine of the slope.

    Parameters
    ----------
    lines
        Rays in rock.
    dem
        Terrain.
    count
        Number of sub-rays, of which the lines are some (`lines.pixel`).
    length_m
        Over which errors of the terrain are alike, m; nodes are half of that apart.

    Returns
    -------
    tuple
        (count, n_nodes) CSR, m of rock for a metre of height, and the lattice of the nodes.

    Raises
    ------
    MuyscError
        If the DEM cannot be read.
    """
    sparse = scipy_part("sparse")
    ground = ground_below(lines.grid, lines.frame, dem)
    paths = lines.paths
    stretch, grid = paths.stretches, paths.grid
    step = length_m / _PER_LENGTH
    shape = tuple(math.ceil(size * n / step) + 1 for size, n in zip(grid.size_m[:2], grid.shape))
    lattice = Lattice((step, step), np.ones(shape, bool))
    rows, columns, values = [], [], []
    for distance, sign in ((stretch.start_m, 1.0), (stretch.end_m, -1.0)):
        origin = paths.rays.origin_m[stretch.ray]
        heading = paths.rays.direction[stretch.ray]

        def depth(
            along: np.ndarray, origin: np.ndarray = origin, heading: np.ndarray = heading
        ) -> np.ndarray:
            point = origin + along[:, None] * heading
            return ground.at(point[:, 0], point[:, 1]) - point[:, 2]

        gain = sign * (depth(distance + _AROUND_M) - depth(distance - _AROUND_M)) / (2 * _AROUND_M)
        # A ray that starts in the ground does not enter it.
        at_ground = (np.abs(depth(distance)) < _AT_GROUND_M) & (distance > _AROUND_M)
        change = np.where(at_ground, 1.0 / np.hypot(np.maximum(gain, 0.0), _LEAST_TANGENT), 0.0)
        point = origin + distance[:, None] * heading
        place = [
            np.clip((point[:, axis] - grid.origin_m[axis]) / step, 0, shape[axis] - 1.000001)
            for axis in (0, 1)
        ]
        cell = [one.astype(int) for one in place]
        share = [one - low for one, low in zip(place, cell)]
        for east in (0, 1):
            for north in (0, 1):
                weight = (share[0] if east else 1 - share[0]) * (
                    share[1] if north else 1 - share[1]
                )
                rows.append(lines.pixel[stretch.ray])
                columns.append((cell[0] + east) * shape[1] + cell[1] + north)
                values.append(change * weight)
    matrix = sparse.csr_matrix(
        (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
        shape=(count, lattice.count),
    )
    matrix.eliminate_zeros()
    return matrix, lattice
