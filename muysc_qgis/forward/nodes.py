"""Directions on a regular grid of the sky, few where the rock is even and many where it is not."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

import numpy as np

from .responses import Window

#: Rows of the grid in a block, for which one ray is enough where the rock is even. Odd, so
#: that there is one in the middle.
FINE_ROWS = 9

#: Columns that a block is cut into where its neighbours are not like it: of this width, degrees, in
#: which few skylines bend, but from 3 to 12 of them.
_FINE_DEG = 0.05
_FEWEST, _MOST = 3, 12

#: Parts of each row that the skyline crosses there, odd in number like the rows.
ROW_PARTS = 3

#: Change of the logarithm of the thickness within a block up to which one ray stands for it: the
#: flux then changes by a seventh, and the middle is off by a thousandth of it.
_EVEN = 0.05

#: Change from one column to the next from which both are cut finer.
_STEEP = 0.25


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

    @property
    def finer_columns(self) -> int:
        """Number of parts of a column where the rock is uneven."""
        return int(np.clip(np.ceil(self.step_deg[0] / _FINE_DEG), _FEWEST, _MOST))

    def finer_azimuth_deg(self, column: np.ndarray) -> np.ndarray:
        """Return the middles of the `finer_columns` parts of columns, (n, parts)."""
        part = (np.arange(self.finer_columns) + 0.5) / self.finer_columns - 0.5
        return np.asarray(self.azimuth_deg[column][:, None] + self.step_deg[0] * part)

    def finer_elevation_deg(self, part: np.ndarray) -> np.ndarray:
        """Return the middles of parts of rows, counted from the grid's lowest end."""
        low = self.elevation_deg[0] - self.step_deg[1] / 2
        return np.asarray(low + self.step_deg[1] / ROW_PARTS * (part + 0.5))


@dataclass(frozen=True)
class Nodes:
    """Rays that stand for parts of the sky, all (n,)."""

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    #: What the ray stands for, degrees.
    width_deg: np.ndarray
    height_deg: np.ndarray
    thickness_m: np.ndarray
    #: Codes of `Outcome`.
    outcome: np.ndarray
    #: True in every other block, like the black fields of a chessboard.
    odd: np.ndarray

    @classmethod
    def joined(cls, parts: list[Nodes]) -> Nodes:
        """Return several, one after the other."""
        names = [one.name for one in fields(cls)]
        return cls(*(np.concatenate([getattr(one, name) for one in parts]) for name in names))

    @classmethod
    def on(
        cls,
        grid: NodeGrid,
        column: np.ndarray,
        row: np.ndarray,
        rows: np.ndarray | float,
        thickness_m: np.ndarray,
        outcome: np.ndarray,
        azimuth_deg: np.ndarray | None = None,
        columns: float = 1.0,
    ) -> Nodes:
        """Return rays on rows of a grid.

        Parameters
        ----------
        grid
            The directions.
        column, row
            (n,) where on it.
        rows
            What each stands for.
        thickness_m, outcome
            What each meets.
        azimuth_deg, columns
            Where it is and what it stands for, if it is not in the middle of its column.
        """
        block = row // FINE_ROWS
        return cls(
            grid.azimuth_deg[column] if azimuth_deg is None else azimuth_deg,
            grid.elevation_deg[row],
            np.full(len(row), columns * grid.step_deg[0]),
            np.broadcast_to(np.asarray(rows) * grid.step_deg[1], row.shape),
            thickness_m,
            outcome,
            (column + block) % 2 == 1,
        )


def uneven_blocks(thickness_m: np.ndarray) -> np.ndarray:
    """Return the blocks that are not like their neighbours to the left and right.

    Parameters
    ----------
    thickness_m
        (n_azimuth, n_elevation) of neighbouring columns.

    Returns
    -------
    numpy.ndarray
        (n_azimuth, n_block), true where the skyline crosses a block or one beside it, or the
        thickness is another one beside it.
    """
    blocks = thickness_m.reshape(len(thickness_m), -1, FINE_ROWS)
    sky = blocks == 0
    some, all_sky = sky.any(axis=2), sky.all(axis=2)
    crossed = some & ~all_sky
    with np.errstate(divide="ignore", invalid="ignore"):
        middle = np.log(blocks[:, :, FINE_ROWS // 2])
        steep = np.abs(np.diff(middle, axis=0)) > _STEEP
    other = (all_sky[1:] != all_sky[:-1]) | crossed[1:] | crossed[:-1] | steep
    crossed[1:] |= other
    crossed[:-1] |= other
    return crossed


def even_nodes(
    grid: NodeGrid, first: int, thickness_m: np.ndarray, outcome: np.ndarray, uneven: np.ndarray
) -> Nodes:
    """Return one ray for each block of even rock or sky, and one a row for other rock.

    Parameters
    ----------
    grid, first
        The directions, and the number of the first column.
    thickness_m, outcome
        (n_azimuth, n_elevation) of columns.
    uneven
        (n_azimuth, n_block) blocks that are left out.
    """
    blocks = thickness_m.reshape(len(thickness_m), -1, FINE_ROWS)
    with np.errstate(divide="ignore", invalid="ignore"):
        logarithm = np.log(blocks)
        even = logarithm.max(axis=2) - logarithm.min(axis=2) < _EVEN
    even |= (blocks == 0).all(axis=2)
    column, block = np.nonzero(even & ~uneven)
    single_column, single_row = np.nonzero(np.repeat(~even & ~uneven, FINE_ROWS, axis=1))
    rows = np.repeat([float(FINE_ROWS), 1.0], [len(column), len(single_column)])
    column = np.concatenate([column, single_column])
    row = np.concatenate([block * FINE_ROWS + FINE_ROWS // 2, single_row])
    return Nodes.on(grid, first + column, row, rows, thickness_m[column, row], outcome[column, row])


def finer_nodes(
    grid: NodeGrid,
    column: np.ndarray,
    block: np.ndarray,
    azimuth_deg: np.ndarray,
    thickness_m: np.ndarray,
    outcome: np.ndarray,
) -> Nodes:
    """Return the rays of blocks that are cut into finer columns.

    Parameters
    ----------
    grid
        The directions.
    column, block
        (n,) columns of the grid and blocks.
    azimuth_deg
        (n,) of the finer columns.
    thickness_m, outcome
        (n, `FINE_ROWS`, `ROW_PARTS`) along their rows' parts.
    """
    sky = thickness_m == 0
    # One part stands for a row that is all rock or all sky.
    whole = sky.all(axis=2) | ~sky.any(axis=2)
    middle = np.arange(ROW_PARTS) == ROW_PARTS // 2
    chosen = np.where(whole[:, :, None], middle, True)
    place, row, part = np.nonzero(chosen)
    rows = np.where(whole[place, row], 1.0, 1.0 / ROW_PARTS)
    return Nodes.on(
        grid,
        column[place],
        block[place] * FINE_ROWS + row,
        rows,
        thickness_m[place, row, part],
        outcome[place, row, part],
        azimuth_deg[place],
        1.0 / grid.finer_columns,
    )
