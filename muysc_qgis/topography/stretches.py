"""Stretches of paths over a window of the DEM, and the pieces of profiles they give.

Only where rays meet the ground does its detail count. Stretches that no ray of
their path can meet, because all of them pass over the highest ground around or
under the lowest, become level ground, which serves as well; the others are
divided for a closer look, and what is left is cut at every grid line.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from ..radiography.raytracing import ProfilePieces

#: Stretches longer than this many cells are worth a closer look; for shorter ones it costs more
#: than it saves.
_FINE_CELLS = 20
#: Parts into which a stretch is divided for it.
_PARTS = 3

#: Shortest piece kept (m). Two grid lines crossed at once leave slivers in which
#: slopes are all rounding error: the next piece takes their place.
_SLIVER_M = 1e-6
#: Heights (m) closer than this to the ground are on it.
_TOUCH_M = 1e-6


@dataclass(frozen=True)
class Stretches:
    """Stretches of paths, straight in the grid of a window of the DEM.

    All arrays have shape (n,), ordered by ray and then by distance.
    """

    ray: np.ndarray
    start_m: np.ndarray
    end_m: np.ndarray
    #: Grid position of the start, and its change along the path.
    column: np.ndarray
    row: np.ndarray
    columns_per_m: np.ndarray
    rows_per_m: np.ndarray
    #: Height (m) over the detector of level ground, NaN where the detail counts.
    level_m: np.ndarray

    @property
    def length_m(self) -> np.ndarray:
        """Horizontal length."""
        return self.end_m - self.start_m

    @property
    def detailed(self) -> np.ndarray:
        """Whether the detail of the ground counts."""
        return np.isnan(self.level_m)

    @property
    def cells(self) -> np.ndarray:
        """Number of grid lines passed, roughly."""
        return (np.abs(self.columns_per_m) + np.abs(self.rows_per_m)) * self.length_m

    def take(self, index: np.ndarray | slice) -> Stretches:
        """Return some of the stretches."""
        return Stretches(*(getattr(self, field.name)[index] for field in fields(self)))

    def divided(self, parts: np.ndarray) -> Stretches:
        """Return each stretch divided into (n,) numbers of equal parts."""
        source = np.repeat(np.arange(len(parts)), parts)
        part = np.arange(len(source)) - np.repeat(np.cumsum(parts) - parts, parts)
        whole = self.take(source)
        offset = whole.length_m * (part / parts[source])
        start = whole.start_m + offset
        last = part == parts[source] - 1
        end = np.where(last, whole.end_m, np.append(start[1:], 0.0))
        return Stretches(
            whole.ray, start, end,
            whole.column + whole.columns_per_m * offset, whole.row + whole.rows_per_m * offset,
            whole.columns_per_m, whole.rows_per_m, whole.level_m,
        )  # fmt: skip


def level_stretches(
    stretches: Stretches,
    ground: np.ndarray,
    lowest: np.ndarray,
    highest: np.ndarray,
    radius_m: float,
) -> Stretches:
    """Replace by level ground what no ray meets, dividing stretches for it.

    Parameters
    ----------
    stretches
        None of them level yet.
    ground
        (rows, columns) heights (m) of the window over the detector.
    lowest, highest
        (n_ray,) tangents of the lowest and the highest ray of each path.
    radius_m
        Radius of the Earth.
    """
    relief = [(ground, ground)]
    while True:
        rough = np.flatnonzero(stretches.detailed)
        part = stretches.take(rough)
        level = stretches.level_m.copy()
        level[rough] = _level(part, relief, lowest, highest, radius_m)
        stretches = replace(stretches, level_m=level)
        if np.max(part.cells, initial=0.0) <= _FINE_CELLS:
            return stretches
        stretches = stretches.divided(np.where(stretches.detailed, _PARTS, 1))


def _halved(values: np.ndarray, choose: Any) -> np.ndarray:
    """Return the extremes of tiles of two by two, of fewer at an odd edge."""
    for _ in (0, 1):
        pairs = len(values) // 2
        halved = values[::2].copy()
        choose(halved[:pairs], values[1::2], out=halved[:pairs])
        values = halved.T
    return values


def _level(
    stretches: Stretches,
    relief: list[tuple[np.ndarray, np.ndarray]],
    lowest: np.ndarray,
    highest: np.ndarray,
    radius_m: float,
) -> np.ndarray:
    """Return (n,) heights of level ground that serves, NaN where none does.

    Of ground that all rays pass over, or under, it matters only that it is lower,
    or higher: level ground as high as the highest around is both.

    Parameters
    ----------
    relief
        Lowest and highest ground in tiles of 1, 2, 4, … cells, NaN where any of it is
        unknown; sizes that are missing are added.
    """
    start, end = stretches.start_m, stretches.end_m
    low, high = lowest[stretches.ray], highest[stretches.ray]
    # Heights over level ground, to which the curvature drop brings rays up.
    least = np.minimum(low * start, low * end) + start**2 / (2 * radius_m)
    greatest = np.maximum(high * start, high * end) + end**2 / (2 * radius_m)

    # Tiles at least as wide as any stretch: two by two hold each.
    length = stretches.length_m
    spans = (stretches.rows_per_m * length, stretches.columns_per_m * length)
    widest = max(float(np.max(np.abs(span), initial=0.0)) for span in spans)
    size = int(widest + 1).bit_length()
    while len(relief) <= size:
        relief.append((_halved(relief[-1][0], np.minimum), _halved(relief[-1][1], np.maximum)))
    lows, highs = relief[size]
    top, bottom, left, right = (
        np.clip(np.floor(position), 0, cells - 1).astype(np.int64) >> size
        for first, span, cells in zip((stretches.row, stretches.column), spans, relief[0][0].shape)
        for position in (np.minimum(first, first + span), np.maximum(first, first + span) + 1)
    )
    corners = ((top, left), (top, right), (bottom, left), (bottom, right))
    highest_ground = np.max([highs[corner] for corner in corners], axis=0)
    lowest_ground = np.min([lows[corner] for corner in corners], axis=0)
    # Unknown ground may be as high and as low as it likes.
    serves = (least > highest_ground) | (greatest < lowest_ground)
    return np.where(serves, highest_ground, np.nan)


def _crossings(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Return stretch number + share of it at each whole number passed."""
    low, high = np.minimum(start, end), np.maximum(start, end)
    first = np.ceil(low)
    count = np.where(high > low, np.maximum(np.floor(high) - first + 1, 0), 0).astype(np.int64)
    number = np.repeat(np.arange(len(start)), count)
    running = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    share = (first[number] + running - start[number]) / (end - start)[number]
    return np.minimum(number + np.maximum(share, 0.0), np.nextafter(number + 1.0, 0.0))


def cut_stretches(stretches: Stretches, ground: np.ndarray, radius_m: float) -> ProfilePieces:
    """Cut stretches at every grid line and fit the quadratic of each piece.

    Parameters
    ----------
    stretches
        Level or not, one or more.
    ground
        (rows, columns) heights (m) of the window over the detector.
    radius_m
        Radius of the Earth, of which follows the curvature drop.
    """
    path = stretches
    length = np.where(path.detailed, path.length_m, 0.0)
    # One number orders all cuts of all paths: stretch plus share of it. The three parts
    # are in order, and a stable sort merges them.
    cut = np.sort(
        np.concatenate([
            np.arange(len(path.ray), dtype=float),
            _crossings(path.column, path.column + path.columns_per_m * length),
            _crossings(path.row, path.row + path.rows_per_m * length),
        ]),
        kind="stable",
    )  # fmt: skip
    at = cut.astype(np.int64)
    cut_m = path.start_m[at] + path.length_m[at] * (cut - at)
    last = np.append(np.flatnonzero(at[1:] != at[:-1]), len(at) - 1)
    first = np.append(0, last[:-1] + 1)
    end_m = np.append(cut_m[1:], 0.0)
    end_m[last] = path.end_m
    keep = end_m - cut_m > _SLIVER_M
    # A path that ends where it begins still says what is underfoot there.
    keep[first[path.end_m <= _SLIVER_M]] = True
    at, cut_m, end_m = at[keep], cut_m[keep], end_m[keep]
    path = path.take(at)
    begins = np.flatnonzero(np.append(True, path.ray[1:] != path.ray[:-1])[: len(at)])
    start_m = np.append(0.0, end_m)[: len(at)]
    start_m[begins] = path.start_m[begins]

    rows, columns = ground.shape
    u = path.column + path.columns_per_m * (cut_m - path.start_m)
    v = path.row + path.rows_per_m * (cut_m - path.start_m)
    du, dv, half = path.columns_per_m, path.rows_per_m, (end_m - cut_m) / 2
    cell_u = np.clip((u + du * half).astype(np.int64), 0, columns - 2)
    cell_v = np.clip((v + dv * half).astype(np.int64), 0, rows - 2)
    corner = cell_v * columns + cell_u
    flat = ground.ravel()
    h00, h10 = flat[corner], flat[corner + 1]
    h01, h11 = flat[corner + columns], flat[corner + columns + 1]
    u -= cell_u
    v -= cell_v
    slope_u, slope_v, twist = h10 - h00, h01 - h00, h11 - h10 - h01 + h00
    # Height over the detector at a distance x past the cut: here + there x + bend x².
    here = h00 + u * slope_u + v * slope_v + u * v * twist
    there = du * slope_u + dv * slope_v + (u * dv + v * du) * twist
    bend = du * dv * twist
    level = np.flatnonzero(~path.detailed)
    here[level], there[level], bend[level] = path.level_m[level], 0.0, 0.0
    constant = here - there * cut_m + bend * cut_m**2
    # A detector on the ground is on it, whatever rounding says.
    constant[(start_m == 0) & (np.abs(here) < _TOUCH_M)] = 0.0
    return ProfilePieces(
        path.ray, start_m, end_m, constant, there - 2 * bend * cut_m, bend - 1 / (2 * radius_m)
    )
