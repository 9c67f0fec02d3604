"""Where straight lines cross the planes of a regular grid."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

#: Pieces shorter than this share of a grid step are what rounding leaves of none.
_NOTHING = 1e-7

#: Share of a grid step within which a plane counts as at the end of a stretch.
_AT_END = 1e-9


@dataclass(frozen=True)
class Stretches:
    """Parts of rays, sorted by ray and along each: distances from the ray's origin in m."""

    #: (n,) number of the ray, not decreasing.
    ray: np.ndarray
    start_m: np.ndarray
    end_m: np.ndarray

    def __len__(self) -> int:
        return len(self.ray)

    def take(self, which: np.ndarray | slice) -> Stretches:
        """Return some of the stretches."""
        return Stretches(self.ray[which], self.start_m[which], self.end_m[which])


@dataclass(frozen=True)
class Pieces:
    """Stretches cut at every grid plane; flat arrays, stretch by stretch and along each."""

    #: (n,) number of the stretch.
    stretch: np.ndarray
    start_m: np.ndarray
    length_m: np.ndarray
    #: Number of the grid cell along each axis.
    cells: tuple[np.ndarray, ...]


@dataclass(frozen=True)
class Lines:
    """A grid along one axis: bounds at low + step · (0 … count), in m."""

    low_m: float
    step_m: float
    count: int


def _planes(
    position: np.ndarray, direction: np.ndarray, start: np.ndarray, end: np.ndarray, lines: Lines
) -> tuple[np.ndarray, np.ndarray]:
    """Return the first plane that each stretch crosses, and how many it crosses."""
    one = (position + start * direction - lines.low_m) / lines.step_m
    other = (position + end * direction - lines.low_m) / lines.step_m
    # Planes at the ends themselves cut nothing off.
    first = np.floor(np.minimum(one, other) + _AT_END) + 1
    number = np.ceil(np.maximum(one, other) - _AT_END) - first
    # Along a plane nothing is crossed.
    number = np.where(direction == 0, 0, np.maximum(number, 0))
    return first, number.astype(np.int64)


def count_pieces(
    origin: np.ndarray, direction: np.ndarray, stretches: Stretches, axes: Sequence[Lines]
) -> np.ndarray:
    """Return the most pieces that each stretch can be cut into, (n,); O(stretches).

    Parameters
    ----------
    origin, direction, stretches, axes
        As in `cut`.
    """
    total = np.ones(len(stretches), np.int64)
    for axis, lines in enumerate(axes):
        total += _planes(
            origin[stretches.ray, axis], direction[stretches.ray, axis],
            stretches.start_m, stretches.end_m, lines,
        )[1]  # fmt: skip
    return total


def cut(
    origin: np.ndarray, direction: np.ndarray, stretches: Stretches, axes: Sequence[Lines]
) -> Pieces:
    """Cut stretches at every plane of a grid (after Siddon 1985, doi:10.1118/1.595715).

    The crossings with the planes of each axis are evenly spaced, so each stretch has them in
    closed form; sorting them along the ray leaves pieces that lie in one cell each, which their
    middle names.

    Parameters
    ----------
    origin, direction
        (n_rays, ≥ n_axes) start and unit direction of the rays.
    stretches
        What to cut; lies within the grid.
    axes
        The grid along each axis.

    Returns
    -------
    Pieces
        Cost: O(s · w log w) in time and O(s · w) in memory for s stretches of which the longest
        crosses w planes.
    """
    start, end = stretches.start_m, stretches.end_m
    positions = [origin[stretches.ray, axis] for axis in range(len(axes))]
    directions = [direction[stretches.ray, axis] for axis in range(len(axes))]
    planes = [
        _planes(position, heading, start, end, lines)
        for position, heading, lines in zip(positions, directions, axes)
    ]
    widths = [int(number.max(initial=0)) for _, number in planes]
    crossing = np.empty((len(stretches), sum(widths) + 2))
    crossing[:, 0] = start
    crossing[:, -1] = end
    column = 1
    for position, heading, lines, (first, number), width in zip(
        positions, directions, axes, planes, widths
    ):
        some = crossing[:, column : column + width]
        step = np.arange(width)
        with np.errstate(divide="ignore", invalid="ignore"):
            np.multiply(step, (lines.step_m / heading)[:, None], out=some)
            some += ((lines.low_m + first * lines.step_m - position) / heading)[:, None]
        np.copyto(some, end[:, None], where=step >= number[:, None])
        column += width
    np.clip(crossing, start[:, None], end[:, None], out=crossing)
    crossing.sort(axis=1)

    length = np.diff(crossing, axis=1)
    kept = length > _NOTHING * min(lines.step_m for lines in axes)
    stretch = np.repeat(np.arange(len(stretches)), np.count_nonzero(kept, axis=1))
    begins, length = crossing[:, :-1][kept], length[kept]
    middle = begins + 0.5 * length
    cells = []
    for position, heading, lines in zip(positions, directions, axes):
        cell = middle * (heading / lines.step_m)[stretch]
        cell += ((position - lines.low_m) / lines.step_m)[stretch]
        np.clip(cell, 0, lines.count - 1, out=cell)
        cells.append(cell.astype(np.int32))
    return Pieces(stretch, begins, length, tuple(cells))
