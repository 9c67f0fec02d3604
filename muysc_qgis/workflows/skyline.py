"""Where the sky begins: as an angle by azimuth, and along the columns of a telescope's cells."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..progress import Progress, silent
from ..topography.frame import LocalFrame
from ..topography.tracing import trace_terrain

#: Halvings of the step between two rays, one in rock and one in the sky.
_HALVINGS = 8

#: Points along a column at which it is looked for the skyline, and the most crossings.
_POINTS, _CROSSINGS = 17, 2

#: Azimuth and elevation in degrees of places across and up.
Sky = Callable[[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]

#: Nodes of quadrature across a cell, and along a part of a column in rock and in the sky.
ACROSS, IN_ROCK, IN_SKY = 10, 8, 3


@dataclass(frozen=True)
class Skyline:
    """The elevation above which a detector sees only sky, by azimuth.

    A terrain is below a ray at any distance if it is below a lower ray there: so there is one
    such elevation.
    """

    #: (n,) increasing.
    azimuth_deg: np.ndarray
    #: (n,)
    elevation_deg: np.ndarray

    def above(self, azimuth_deg: np.ndarray, elevation_deg: np.ndarray) -> np.ndarray:
        """Return how far directions are above the skyline, degrees."""
        return elevation_deg - np.interp(azimuth_deg, self.azimuth_deg, self.elevation_deg)


def skyline(
    frame: LocalFrame,
    eye_m: float,
    azimuth_deg: np.ndarray,
    elevation_deg: np.ndarray,
    rock: np.ndarray,
    max_range_m: float | None = None,
    near_field_m: float = 0.0,
    progress: Progress = silent,
) -> Skyline:
    """Return the skyline, to 1/256 of the step between rays already traced.

    Parameters
    ----------
    frame, eye_m, max_range_m, near_field_m, progress
        As in `trace_terrain`.
    azimuth_deg, elevation_deg
        (n_azimuth,) and (n_elevation,) directions already traced, increasing.
    rock
        (n_elevation, n_azimuth) whether they meet rock.

    Raises
    ------
    MuyscError
        If the DEM cannot be read.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    below = np.where(rock.any(axis=0), len(rock) - 1 - np.argmax(rock[::-1], axis=0), -1)
    padded = np.concatenate([[elevation_deg[0]], elevation_deg, [elevation_deg[-1]]])
    low, high = padded[below + 1].copy(), padded[below + 2].copy()
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        seen = trace_terrain(
            frame, eye_m, azimuth_deg, middle[:, None], max_range_m, near_field_m, progress
        ).thickness_m[:, 0]
        hit = ~(seen == 0)
        low, high = np.where(hit, middle, low), np.where(hit, high, middle)
    return Skyline(azimuth_deg, 0.5 * (low + high))


def split_columns(
    sky: Sky,
    step: tuple[float, float],
    line: Skyline,
    left: np.ndarray,
    top: np.ndarray,
    finer: float = 1.0,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return nodes of quadrature in cells that the skyline crosses.

    Each column of a cell is cut where it meets the skyline, and its parts are integrated apart,
    those in rock with nodes that crowd at the skyline: there the length in rock grows with the
    root of the depth.

    Parameters
    ----------
    sky
        Azimuth and elevation in degrees of places across and up, such as `Pointing.sky`.
    step
        Width and height of a cell.
    line
        Where the sky begins.
    left, top
        (n_cell,) places of the cells' left and upper sides.
    finer
        Times as many nodes along each side.

    Returns
    -------
    tuple
        Number of the cell, shares from the left and from the top, and weights of the nodes,
        which add up to 1 in each cell.
    """
    node, weight = _nodes(round(ACROSS * finer))
    cell = np.repeat(np.arange(len(left)), len(node))
    across = np.tile(node, len(left))
    width = np.tile(weight, len(left))
    # 0 at the top of the cell and 1 at its bottom.
    down = np.linspace(0.0, 1.0, _POINTS)
    height = line.above(
        *sky((left[cell] + step[0] * across)[:, None], top[cell][:, None] - step[1] * down[None, :])
    )
    ends = np.ones((len(cell), _CROSSINGS + 2))
    ends[:, 0] = 0.0
    changes = (height[:, :-1] > 0) != (height[:, 1:] > 0)
    row, place = np.nonzero(changes)
    order = np.arange(len(row)) - np.searchsorted(row, row)
    kept = order < _CROSSINGS
    row, place, order = row[kept], place[kept], order[kept]
    one, other = height[row, place], height[row, place + 1]
    ends[row, order + 1] = down[place] + (down[1] - down[0]) * one / (one - other)
    is_sky = height[:, :1] > 0
    found = []
    for number in range(_CROSSINGS + 1):
        begin, end = ends[:, number], ends[:, number + 1]
        of_sky = is_sky[:, 0] if number % 2 == 0 else ~is_sky[:, 0]
        # A part in rock ends at the skyline above it, below it, or at both.
        starts_at, ends_at = begin > 0, end < 1
        for kind, count in (("sky", IN_SKY), ("rock", IN_ROCK)):
            chosen = np.flatnonzero((end > begin) & (of_sky == (kind == "sky")))
            count = round(count * finer)
            share, part = _nodes(count)
            share = np.broadcast_to(share, (len(chosen), count))
            part = np.broadcast_to(part, (len(chosen), count))
            if kind == "rock":
                from_top = (starts_at & ~ends_at)[chosen][:, None]
                from_bottom = (ends_at & ~starts_at)[chosen][:, None]
                # y = t² from the skyline on, dy = 2 t dt.
                part = np.where(
                    from_top,
                    2 * share * part,
                    np.where(from_bottom, 2 * (1 - share) * part, part),
                )
                share = np.where(
                    from_top, share**2, np.where(from_bottom, 1 - (1 - share) ** 2, share)
                )
            length = (end - begin)[chosen][:, None]
            found.append((
                np.repeat(cell[chosen], count), np.repeat(across[chosen], count),
                (begin[chosen][:, None] + length * share).ravel(),
                (width[chosen][:, None] * length * part).ravel(),
            ))  # fmt: skip
    cells, right, lower, weights = (np.concatenate(one) for one in zip(*found))
    return cells, right, lower, weights


def _nodes(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return nodes and weights of Gauss–Legendre quadrature from 0 to 1."""
    node, weight = np.polynomial.legendre.leggauss(count)
    return (node + 1) / 2, weight / 2
