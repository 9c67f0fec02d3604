"""The mean of a function of direction over each trajectory of a telescope.

The response of a trajectory falls linearly from its middle to zero at the middles of its
neighbours, across and up, times the obliquity 1/(1 + x² + y²)²: together the responses of
all trajectories make up the telescope's acceptance in every direction. The corners of a
cell of this grid are the middles of four trajectories.

Where the function is smooth, a trajectory takes a third of the value at its middle and a
sixth of those at the middles of its four cells: exact for cubic polynomials, so that the
error falls with the fourth power of the spacing, at two values a trajectory. Cells in
which the function changes abruptly are integrated by Gauss–Legendre quadrature.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .geometry import TelescopeGeometry

#: Values of some quantities, (n_quantities, …), at tangents to the right and up, (…).
Field = Callable[[np.ndarray, np.ndarray], np.ndarray]

#: Parts of a cell's response at one of its corners: for the values at this corner and in
#: the middle of the cell. The integral of (1 − s)(1 − t) over the cell is ¼.
_CORNER, _MIDDLE = 1 / 12, 1 / 6

#: Nodes across a cell in which the function changes abruptly.
ROUGH_NODES = 16

#: Rough cells worked on at a time, to bound the memory.
_BLOCK = 1 << 10


def corner_tangents(geometry: TelescopeGeometry) -> tuple[np.ndarray, np.ndarray]:
    """Return the tangents of the cells' corners.

    Returns
    -------
    tuple
        (2 N_x + 1,) to the right, increasing, and (2 N_y + 1,) upwards, decreasing. All
        but the outermost are the middles of trajectories.
    """
    x = geometry.step * np.arange(-geometry.bars_x, geometry.bars_x + 1)
    y = geometry.step * np.arange(geometry.bars_y, -geometry.bars_y - 1, -1)
    return x, y


def trajectory_means(
    geometry: TelescopeGeometry,
    field: Field,
    rough: np.ndarray | None = None,
    nodes: int = ROUGH_NODES,
) -> np.ndarray:
    """Return the mean of a field over the response of each trajectory.

    Parameters
    ----------
    geometry
        The telescope.
    field
        Quantities as a function of the tangents.
    rough
        (2 N_y, 2 N_x), true for the cells in which the field changes abruptly; None for
        none.
    nodes
        Nodes across such a cell.

    Returns
    -------
    numpy.ndarray
        (n_quantities, 2 N_y − 1, 2 N_x − 1); NaN where any value is.
    """
    x, y = corner_tangents(geometry)
    middle_x, middle_y = (x[:-1] + x[1:]) / 2, (y[:-1] + y[1:]) / 2
    shape = (len(middle_y), len(middle_x))
    smooth = np.ones(shape, dtype=bool) if rough is None else ~rough

    at_corner = _weighted(field, *np.meshgrid(x[1:-1], y[1:-1]))
    at_middle = _weighted(field, *np.meshgrid(middle_x, middle_y))
    around = sum(corner.astype(float) for corner in _four(smooth))
    total = _CORNER * at_corner * around
    total += sum(_four(np.where(smooth, _MIDDLE * at_middle, 0.0)))
    total = np.where(around == 0, 0.0, total)
    if not smooth.all():
        pieces = _rough_cells(geometry, field, np.argwhere(~smooth), len(total), nodes)
        total += sum(_four(piece)[k] for k, piece in enumerate(pieces))
    return total[:-1] / total[-1]


def _weighted(field: Field, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return the field times the obliquity, and the obliquity itself as the last quantity."""
    obliquity = 1.0 / (1.0 + x**2 + y**2) ** 2
    return np.concatenate([field(x, y) * obliquity, obliquity[None]])


def _four(cells: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return what the cells above left, above right, below left and below right hold."""
    return (
        cells[..., :-1, :-1], cells[..., :-1, 1:], cells[..., 1:, :-1], cells[..., 1:, 1:],
    )  # fmt: skip


def _rough_cells(
    geometry: TelescopeGeometry, field: Field, cells: np.ndarray, quantities: int, nodes: int
) -> np.ndarray:
    """Integrate cells with the response at each of their corners.

    Returns
    -------
    numpy.ndarray
        (4, n_quantities, 2 N_y, 2 N_x) for the corners below right, below left, above
        right and above left: those for which the cell is one of `_four`, in their order.
    """
    x, y = corner_tangents(geometry)
    node, weight = np.polynomial.legendre.leggauss(nodes)
    share, weight = (node + 1) / 2, weight / 2
    across, down = np.meshgrid(share, share)
    product = weight[None, :] * weight[:, None]
    responses = np.stack(
        [
            product * fx * fy
            for fy, fx in (
                (down, across),
                (down, 1 - across),
                (1 - down, across),
                (1 - down, 1 - across),
            )
        ]
    )
    result = np.zeros((4, quantities, len(y) - 1, len(x) - 1))
    for first in range(0, len(cells), _BLOCK):
        row, column = cells[first : first + _BLOCK].T
        values = _weighted(
            field,
            x[column, None, None] + geometry.step * across,
            y[row, None, None] - geometry.step * down,
        )
        result[:, :, row, column] = np.einsum("kij,qcij->kqc", responses, values)
    return result
