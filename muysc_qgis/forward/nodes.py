"""Directions on a regular grid of the sky, few where the rock is even and many where it is not."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from .responses import Window

#: Rows of the grid from which one ray is taken where the rock is even. Odd, so that there is
#: one in the middle.
FINE_ROWS = 9

#: Parts of a row on either side of the skyline.
EDGE_PARTS = 8

#: Change of the logarithm of the thickness within `FINE_ROWS` rows up to which one ray stands
#: for them: the flux then changes by a seventh, and the middle is off by a thousandth of it.
_EVEN = 0.05


@dataclass(frozen=True)
class NodeGrid:
    """Columns of one azimuth each, and rows of one elevation, evenly spaced.

    Parameters
    ----------
    azimuth_deg
        (n_azimuth,) middles of the columns, increasing.
    elevation_deg
        (n_elevation,) middles of the rows, increasing; a multiple of `FINE_ROWS`.
    step_deg
        Width of a column and height of a row.
    """

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    step_deg: tuple[float, float]

    @classmethod
    def over(cls, window: Window, rays: float) -> NodeGrid:
        """Return a grid with some columns, and as many times `FINE_ROWS` rows, an element."""
        width, height = window.right_deg - window.left_deg, window.high_deg - window.low_deg
        # Pixels hold a whole number of columns, whatever rounding says.
        columns = max(2, math.ceil(width / window.step_deg[0] * rays - 1e-6))
        rows = max(2, math.ceil(height / window.step_deg[1] * rays - 1e-6)) * FINE_ROWS
        step = width / columns, height / rows
        return cls(
            window.left_deg + step[0] * (np.arange(columns) + 0.5),
            window.low_deg + step[1] * (np.arange(rows) + 0.5),
            step,
        )

    @property
    def size(self) -> int:
        """Number of directions."""
        return len(self.azimuth_deg) * len(self.elevation_deg)


@dataclass(frozen=True)
class Nodes:
    """Rays that stand for parts of columns, all (n,)."""

    #: Number of the column and of the row.
    column: np.ndarray
    row: np.ndarray
    #: Rows that the ray stands for.
    rows: np.ndarray
    thickness_m: np.ndarray
    #: Codes of `Outcome`.
    outcome: np.ndarray

    @classmethod
    def joined(cls, parts: list[Nodes]) -> Nodes:
        """Return several, one after the other."""
        names = ("column", "row", "rows", "thickness_m", "outcome")
        return cls(*(np.concatenate([getattr(one, name) for one in parts]) for name in names))


def even_and_uneven(thickness_m: np.ndarray, outcome: np.ndarray) -> tuple[Nodes, np.ndarray]:
    """Return one ray for even rock or sky, one a row for other rock, and where the skyline is.

    Parameters
    ----------
    thickness_m, outcome
        (n_azimuth, n_elevation) of a grid's columns.

    Returns
    -------
    nodes
        Without the rows on both sides of the skyline.
    edges
        (n, 2) column and row of the last row below a change from rock to sky or back.
    """
    blocks = thickness_m.reshape(len(thickness_m), -1, FINE_ROWS)
    with np.errstate(divide="ignore", invalid="ignore"):
        logarithm = np.log(blocks)
        span = logarithm.max(axis=2) - logarithm.min(axis=2)
    even = span < _EVEN
    even |= (blocks == 0).all(axis=2)
    sky = thickness_m == 0
    known = np.isfinite(thickness_m)
    change = (sky[:, 1:] != sky[:, :-1]) & known[:, 1:] & known[:, :-1]
    edges = np.argwhere(change)
    beside = np.zeros(thickness_m.shape, dtype=bool)
    beside[:, :-1] |= change
    beside[:, 1:] |= change
    even &= ~beside.reshape(blocks.shape).any(axis=2)
    column, block = np.nonzero(even)
    middle = block * FINE_ROWS + FINE_ROWS // 2
    single = np.repeat(~even, FINE_ROWS, axis=1) & ~beside
    other_column, other_row = np.nonzero(single)
    column, row = np.concatenate([column, other_column]), np.concatenate([middle, other_row])
    stands_for = np.repeat([float(FINE_ROWS), 1.0], [len(middle), len(other_row)])
    return (
        Nodes(column, row, stands_for, thickness_m[column, row], outcome[column, row]),
        edges,
    )


def edge_rows(grid: NodeGrid, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return finer rays for the rows on both sides of the skyline.

    Parameters
    ----------
    grid
        The directions.
    edges
        (n, 2) column and row, as in `even_and_uneven`.

    Returns
    -------
    column, row
        (n_pair,) distinct column and row of the grid.
    part
        (n_pair, `EDGE_PARTS`) number of the finer row, counted from the grid's lowest end.
    """
    rows = len(grid.elevation_deg)
    flat = edges[:, 0] * rows + edges[:, 1]
    column, row = np.divmod(np.unique(np.concatenate([flat, flat + 1])), rows)
    return column, row, row[:, None] * EDGE_PARTS + np.arange(EDGE_PARTS)


def part_elevation(grid: NodeGrid, part: np.ndarray) -> np.ndarray:
    """Return the elevation in degrees of finer rows."""
    low = grid.elevation_deg[0] - grid.step_deg[1] / 2
    return np.asarray(low + grid.step_deg[1] / EDGE_PARTS * (part + 0.5))
