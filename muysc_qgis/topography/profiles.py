"""Terrain profiles along azimuths, window by window of the DEM.

Cut where it crosses the DEM's grid lines, a profile lies in one cell of the
bilinear surface between two cuts, where the height along a straight path is a
quadratic in the distance, exactly.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from ..progress import Progress, report, silent
from ..radiography.raytracing import ProfilePieces
from .dem import EDGE_CELLS, Dem
from .frame import PATH_STEP_M, LocalFrame
from .heights import PEAK_M
from .stretches import Stretches, cut_stretches, level_stretches

#: Profile pieces in one block: about 30 arrays of float64 that stay in the processor's cache.
MAX_PIECES = 1 << 13
#: DEM cells read at a time: 16 MiB of float64.
MAX_CELLS = 1 << 21
#: Points of paths laid at a time: with about 20 arrays of float64, 40 MiB.
MAX_KNOTS = 1 << 18


@dataclass(frozen=True)
class Paths:
    """Where rays run over the ground.

    Every azimuth has the same knots; `end_m` says how much of each is on the DEM.
    """

    dem: Dem
    azimuth_deg: np.ndarray
    #: (n_knots,) distances from the detector, increasing.
    knot_m: np.ndarray
    #: (n_azimuth, n_knots) grid positions.
    column: np.ndarray
    row: np.ndarray
    #: (n_azimuth,) distance at which the path leaves the DEM or the range.
    end_m: np.ndarray
    #: (n_azimuth,) the user's range where it ends the path, else infinite.
    range_m: np.ndarray
    #: (n_azimuth,) tangents of the lowest and of the highest ray on each path, None
    #: where they are not to be relied on.
    tangents: tuple[np.ndarray, np.ndarray] | None


def reach_m(frame: LocalFrame, eye_m: float, lowest_tangent: np.ndarray | float) -> np.ndarray:
    """Return the distances (m) beyond which no ray can meet terrain.

    That is the DEM's farthest edge, or where the lowest ray has climbed above
    any mountain on Earth.

    Parameters
    ----------
    frame
        Frame of the detector.
    eye_m
        Height of the detector, in the DEM's heights.
    lowest_tangent
        Tangents of the lowest elevation angles, any shape.
    """
    dem = frame.dem
    across = np.linspace(0, dem.columns - 1, 17)
    down = np.linspace(0, dem.rows - 1, 17)
    column = np.concatenate([across, across, np.zeros(17), np.full(17, dem.columns - 1.0)])
    row = np.concatenate([np.zeros(17), np.full(17, dem.rows - 1.0), down, down])
    _, distance = frame.polar(column, row)
    # A DEM larger than a hemisphere has edge points that cannot be projected.
    finite = distance[np.isfinite(distance)]
    farthest = float(finite.max()) if finite.size else np.pi * frame.radius_m / 2
    climb = max(PEAK_M - eye_m, 0.0)
    radius = frame.radius_m
    # climb = s t + s²/2R, solved for s.
    cleared = radius * (np.sqrt(lowest_tangent**2 + 2 * climb / radius) - lowest_tangent)
    return np.clip(cleared, PATH_STEP_M, farthest * 1.01 + PATH_STEP_M)


def lay_paths(
    frame: LocalFrame,
    azimuth_deg: np.ndarray,
    start_m: float,
    reach: np.ndarray | float,
    max_range_m: float | None,
    tangents: tuple[np.ndarray, np.ndarray] | None = None,
) -> Paths:
    """Lay the paths of all azimuths over the DEM.

    Parameters
    ----------
    frame
        Frame of the detector.
    azimuth_deg
        (n_azimuth,) directions.
    start_m
        Distance at which the paths begin.
    reach
        Distance beyond which nothing matters, of all azimuths or (n_azimuth,) of
        each, see `reach_m`.
    max_range_m
        Range set by the user, None for none.
    tangents
        (n_azimuth,) of the lowest and of the highest ray on each path: where no ray
        between them meets the ground, pieces are level. None for all the detail.
    """
    dem = frame.dem
    end = float(np.max(reach))
    if max_range_m is not None:
        end = min(end, max_range_m)
    start = min(start_m, end)
    # The same knots whatever the reach, so that no ray depends on the others.
    knots = start + PATH_STEP_M * np.arange(2 + max(0, np.ceil((end - start) / PATH_STEP_M - 1)))
    # A path ends past its reach; what comes then is as if it were off the DEM.
    azimuth = np.asarray(azimuth_deg, float)
    ray, knot = np.nonzero(
        np.append(-np.inf, knots[:-1]) < np.broadcast_to(reach, azimuth.shape)[:, None]
    )
    column, row = np.full((2, len(azimuth), len(knots)), np.nan)
    column[ray, knot], row[ray, knot] = frame.ground_positions(azimuth[ray], knots[knot])
    # So it is where the projection ends.
    off = ~(np.isfinite(column) & np.isfinite(row))
    column[off] = row[off] = np.nan
    if dem.wraps:
        column = np.unwrap(column, period=dem.turn_columns, axis=1)
    share = np.minimum(
        _share_inside(row, dem.rows - 1),
        np.inf if dem.wraps else _share_inside(column, dem.columns - 1),
    )
    leaves = share < 1
    first = np.argmax(leaves, axis=1)
    at_edge = knots[first] + PATH_STEP_M * share[np.arange(len(share)), first]
    leaves_m = np.where(leaves.any(axis=1), at_edge, np.inf)
    end_m = np.minimum(leaves_m, end)
    range_m = np.where((end_m == max_range_m) & (leaves_m >= end), end_m, np.inf)
    return Paths(dem, azimuth, knots, column, row, end_m, range_m, tangents)


def _share_inside(position: np.ndarray, last: int) -> np.ndarray:
    """Return for each knot interval the share of it before leaving 0 … last."""
    start, end = position[:, :-1], position[:, 1:]
    with np.errstate(divide="ignore", invalid="ignore"):
        over = np.where(end > last + EDGE_CELLS, (last - start) / (end - start), np.inf)
        under = np.where(end < -EDGE_CELLS, start / (start - end), np.inf)
    # Positions that cannot be projected are outside.
    share = np.where(np.isfinite(end), np.minimum(over, under), 0.0)
    return np.maximum(np.where(np.isfinite(start), share, 0.0), 0.0)


def azimuth_runs(azimuths: int, reach: float) -> list[slice]:
    """Split azimuths into runs whose paths fit one block of memory."""
    size = max(1, int(MAX_KNOTS // (2 + reach / PATH_STEP_M)))
    return [slice(start, min(start + size, azimuths)) for start in range(0, azimuths, size)]


def profile_pieces(
    paths: Paths, group: slice, eye_m: float, frame: LocalFrame, progress: Progress = silent
) -> Iterator[ProfilePieces]:
    """Yield the pieces of a run of azimuths, ring by ring, near to far.

    Heights are relative to the detector and lowered by the curvature drop.

    Parameters
    ----------
    paths
        Paths over the ground.
    group
        Which azimuths.
    eye_m
        Height of the detector, in the DEM's heights.
    frame
        Frame of the detector.
    progress
        Told the share done before each window.

    Raises
    ------
    MuyscError
        If the DEM cannot be read.
    Cancelled
        If `progress` asks for a stop.
    """
    blocks = [(group, 0, len(paths.knot_m) - 1)]
    total, done = (group.stop - group.start) * (len(paths.knot_m) - 1), 0
    while blocks:
        group, first, last = blocks.pop()
        start, size = paths.knot_m[first], group.stop - group.start
        if start > 0 and start >= paths.end_m[group].max():
            done += size * (last - first)
            continue
        window = _window(paths, group, first, last)
        too_large = window[2] * window[3] > MAX_CELLS
        if too_large and last - first > 1:
            middle = (first + last) // 2
            blocks += [(group, middle, last), (group, first, middle)]
        elif too_large and size > 1:
            half = group.start + size // 2
            blocks += [
                (slice(half, group.stop), first, last),
                (slice(group.start, half), first, last),
            ]
        else:
            report(progress, done / total)
            yield from _pieces_in(
                window, _stretches(paths, group, first, last), paths, eye_m, frame
            )
            done += size * (last - first)


def _window(paths: Paths, group: slice, first: int, last: int) -> tuple[int, int, int, int]:
    """Return the cells (column, row, columns, rows) under a stretch of paths."""
    dem = paths.dem
    inside = paths.knot_m[None, first : last + 1] < paths.end_m[group, None] + PATH_STEP_M
    column = np.where(inside, paths.column[group, first : last + 1], np.nan)
    row = np.where(inside, paths.row[group, first : last + 1], np.nan)
    left, right = int(np.floor(np.nanmin(column))), int(np.floor(np.nanmax(column))) + 1
    top, bottom = int(np.floor(np.nanmin(row))), int(np.floor(np.nanmax(row))) + 1
    if not dem.wraps:
        left, right = _clip(left, right, dem.columns)
    top, bottom = _clip(top, bottom, dem.rows)
    return left, top, right - left + 1, bottom - top + 1


def _clip(first: int, last: int, size: int) -> tuple[int, int]:
    """Clip a range of cells to the raster, at least two wide."""
    first = min(max(first, 0), size - 2)
    return first, max(min(last, size - 1), first + 1)


def _stretches(paths: Paths, group: slice, first: int, last: int) -> Stretches:
    """Return the stretches between knots of a run of azimuths, on the DEM's grid."""
    ray, knot = (index.ravel() for index in np.mgrid[group, first:last])
    start, step = paths.knot_m[knot], paths.knot_m[first + 1] - paths.knot_m[first]
    end = np.minimum(paths.knot_m[knot + 1], paths.end_m[ray])
    column, row = paths.column[ray, knot], paths.row[ray, knot]
    columns_per_m = (paths.column[ray, knot + 1] - column) / step
    rows_per_m = (paths.row[ray, knot + 1] - row) / step
    # A path that ends underfoot stays, for what is known there.
    on_dem = ((end > start) | (start == 0)) & np.isfinite(columns_per_m)
    return Stretches(
        ray, start, end, column, row, columns_per_m, rows_per_m, np.full(len(ray), np.nan)
    ).take(on_dem)


def _pieces_in(
    window: tuple[int, int, int, int],
    stretches: Stretches,
    paths: Paths,
    eye_m: float,
    frame: LocalFrame,
) -> Iterator[ProfilePieces]:
    """Yield the pieces of stretches within a window of the DEM, in blocks."""
    left, top, columns, rows = window
    ground = paths.dem.read(left, top, columns, rows) - eye_m
    stretches = replace(stretches, column=stretches.column - left, row=stretches.row - top)
    if paths.tangents is not None:
        stretches = level_stretches(stretches, ground, *paths.tangents, frame.radius_m)
    pieces = 1 + np.where(stretches.detailed, stretches.cells, 0)
    block = (np.cumsum(pieces) // MAX_PIECES).astype(np.int64)
    edges = [0, *(1 + np.flatnonzero(np.diff(block))), len(block)]
    for start, end in zip(edges, edges[1:]):
        if end > start:
            yield cut_stretches(stretches.take(slice(start, end)), ground, frame.radius_m)
