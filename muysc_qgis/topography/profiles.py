"""Terrain profiles along azimuths, cut where they cross the DEM's grid lines.

Between two cuts a profile lies in one cell of the bilinear surface, where the
height along a straight path is a quadratic in the distance, exactly. Stretches
that none of a path's rays can meet, because they pass over all ground around or
under it, are not cut: level ground serves as well.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..radiography.raytracing import ProfilePieces
from .dem import EDGE_CELLS, Dem
from .frame import PATH_STEP_M, LocalFrame
from .heights import PEAK_M
from .level import level_ground, ray_heights

#: Profile pieces in one block: with about 30 arrays of float64, 60 MiB.
MAX_PIECES = 1 << 18
#: DEM cells read at a time: 64 MiB of float64.
MAX_CELLS = 1 << 23
#: Points of paths laid at a time: with about ten arrays of float64, 80 MiB.
MAX_KNOTS = 1 << 20

#: Shortest piece kept (m). Two grid lines crossed at once leave slivers in which
#: slopes are all rounding error: the next piece takes their place.
_SLIVER_M = 1e-6
#: Heights (m) closer than this to the ground are on it.
_TOUCH_M = 1e-6


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


def reach_m(frame: LocalFrame, eye_m: float, lowest_tangent: float) -> float:
    """Return a distance (m) beyond which no ray can meet terrain.

    That is the DEM's farthest edge, or where the lowest ray has climbed above
    any mountain on Earth.

    Parameters
    ----------
    frame
        Frame of the detector.
    eye_m
        Height of the detector, in the DEM's heights.
    lowest_tangent
        Tangent of the lowest elevation angle.
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
    return float(min(farthest * 1.01 + PATH_STEP_M, max(cleared, PATH_STEP_M)))


def lay_paths(
    frame: LocalFrame,
    azimuth_deg: np.ndarray,
    start_m: float,
    reach: float,
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
        Distance beyond which nothing matters, see `reach_m`.
    max_range_m
        Range set by the user, None for none.
    tangents
        (n_azimuth,) of the lowest and of the highest ray on each path: where no ray
        between them meets the ground, pieces are level. None for all the detail.
    """
    dem = frame.dem
    end = reach if max_range_m is None else min(reach, max_range_m)
    start = min(start_m, end)
    knots = start + (end - start) * np.linspace(
        0, 1, max(2, 1 + int(np.ceil((end - start) / PATH_STEP_M)))
    )
    column, row = frame.ground_positions(np.asarray(azimuth_deg)[:, None], knots)
    # Where the projection ends the path is off the DEM.
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
    any_leaves = leaves.any(axis=1)
    step = knots[1] - knots[0]
    at_edge = knots[first] + step * share[np.arange(len(share)), first]
    end_m = np.where(any_leaves, at_edge, end)
    by_range = ~any_leaves & (max_range_m is not None and end == max_range_m)
    range_m = np.where(by_range, end, np.inf)
    return Paths(dem, np.asarray(azimuth_deg), knots, column, row, end_m, range_m, tangents)


def _share_inside(position: np.ndarray, last: int) -> np.ndarray:
    """Return for each knot interval the share of it before leaving 0 … last."""
    start, end = position[:, :-1], position[:, 1:]
    with np.errstate(divide="ignore", invalid="ignore"):
        over = np.where(end > last + EDGE_CELLS, (last - start) / (end - start), np.inf)
        under = np.where(end < -EDGE_CELLS, start / (start - end), np.inf)
    # Positions that cannot be projected are outside.
    share = np.where(np.isfinite(end), np.minimum(over, under), 0.0)
    return np.maximum(np.where(np.isfinite(start), share, 0.0), 0.0)


def azimuth_parts(azimuths: int, reach: float) -> list[slice]:
    """Split azimuths into runs whose paths fit one block of memory."""
    size = max(1, int(MAX_KNOTS // (2 + reach / PATH_STEP_M)))
    return [slice(start, min(start + size, azimuths)) for start in range(0, azimuths, size)]


def azimuth_groups(paths: Paths) -> list[slice]:
    """Split the azimuths into runs whose profiles fit one block of memory."""
    pieces = 2 + np.sum(
        1
        + np.abs(np.nan_to_num(np.diff(paths.column, axis=1)))
        + np.abs(np.nan_to_num(np.diff(paths.row, axis=1))),
        axis=1,
    )
    group = (np.cumsum(pieces) - pieces) // MAX_PIECES
    starts = np.flatnonzero(np.diff(group, prepend=-1))
    ends = np.append(starts[1:], len(pieces))
    return [slice(int(start), int(end)) for start, end in zip(starts, ends)]


def profile_pieces(
    paths: Paths, group: slice, eye_m: float, frame: LocalFrame
) -> Iterator[ProfilePieces]:
    """Yield the pieces of a run of azimuths, ring by ring, near to far.

    Heights are relative to the detector and lowered by the curvature drop.

    Parameters
    ----------
    paths
        Paths over the ground.
    group
        Which azimuths, see `azimuth_groups`.
    eye_m
        Height of the detector, in the DEM's heights.
    frame
        Frame of the detector.
    """
    stretches = [(group, 0, len(paths.knot_m) - 1)]
    while stretches:
        group, first, last = stretches.pop()
        start = paths.knot_m[first]
        if start > 0 and start >= paths.end_m[group].max():
            continue
        window = _window(paths, group, first, last)
        too_large = window[2] * window[3] > MAX_CELLS
        if too_large and last - first > 1:
            middle = (first + last) // 2
            stretches += [(group, middle, last), (group, first, middle)]
        elif too_large and group.stop - group.start > 1:
            half = (group.start + group.stop) // 2
            stretches += [
                (slice(half, group.stop), first, last),
                (slice(group.start, half), first, last),
            ]
        else:
            yield _cut(paths, group, first, last, window, eye_m, frame)


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


def _crossings(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Return interval number + share of it at each whole number passed."""
    low, high = np.minimum(start, end), np.maximum(start, end)
    first = np.ceil(low)
    passed = np.isfinite(low) & np.isfinite(high) & (high > low)
    count = np.where(passed, np.maximum(np.floor(high) - first + 1, 0), 0).astype(np.int64)
    interval = np.repeat(np.arange(len(start)), count)
    running = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    share = (first[interval] + running - start[interval]) / (end - start)[interval]
    return interval + np.clip(share, 0.0, 1.0 - 1e-12)


def _cut(
    paths: Paths,
    group: slice,
    first: int,
    last: int,
    window: tuple[int, int, int, int],
    eye_m: float,
    frame: LocalFrame,
) -> ProfilePieces:
    """Cut a stretch of profiles at every grid line and fit each piece's quadratic."""
    left, top, columns, rows = window
    ground = paths.dem.read(left, top, columns, rows) - eye_m
    knots = paths.knot_m[first : last + 1]
    intervals = last - first
    u0 = (paths.column[group, first:last] - left).ravel()
    u1 = (paths.column[group, first + 1 : last + 1] - left).ravel()
    v0 = (paths.row[group, first:last] - top).ravel()
    v1 = (paths.row[group, first + 1 : last + 1] - top).ravel()
    level = np.full(len(u0), np.nan)
    if paths.tangents is not None:
        rays = ray_heights(paths.tangents, group, knots, frame)
        level = level_ground(ground, (u0, u1, v0, v1), rays)
    detailed = np.isnan(level)
    # One number orders all cuts of all azimuths: interval plus share of it.
    cut = np.sort(
        np.concatenate([
            np.arange(len(u0), dtype=float),
            _crossings(u0, np.where(detailed, u1, u0)),
            _crossings(v0, np.where(detailed, v1, v0)),
        ])
    )  # fmt: skip
    interval = cut.astype(np.int64)
    share = cut - interval
    end_share = np.append(share[1:], 1.0)
    end_share[np.append(interval[1:] != interval[:-1], True)] = 1.0
    ray = interval // intervals
    step = knots[1] - knots[0]
    base = knots[interval % intervals]
    path_end = paths.end_m[group][ray]
    end_m = np.minimum(base + step * end_share, path_end)
    keep = end_m - (base + step * share) > _SLIVER_M
    # A path that ends where it begins still says what is underfoot there.
    keep |= (path_end <= _SLIVER_M) & np.append(True, ray[1:] != ray[:-1])
    keep &= np.isfinite(u0[interval]) & np.isfinite(u1[interval])
    interval, share, ray, end_m = interval[keep], share[keep], ray[keep], end_m[keep]
    cut_m = knots[interval % intervals] + step * share
    begins = np.append(True, ray[1:] != ray[:-1])[: len(ray)]
    start_m = np.where(begins, knots[0], np.append(0.0, end_m[:-1])[: len(ray)])

    du, dv = ((u1 - u0) / step)[interval], ((v1 - v0) / step)[interval]
    length = end_m - cut_m
    u = u0[interval] + du * (step * share)
    v = v0[interval] + dv * (step * share)
    cell_u = np.clip(np.floor(u + du * length / 2).astype(np.int64), 0, columns - 2)
    cell_v = np.clip(np.floor(v + dv * length / 2).astype(np.int64), 0, rows - 2)
    flat = ground.ravel()
    corner = cell_v * columns + cell_u
    h00, h10 = flat[corner], flat[corner + 1]
    h01, h11 = flat[corner + columns], flat[corner + columns + 1]
    u -= cell_u
    v -= cell_v
    slope_u, slope_v, twist = h10 - h00, h01 - h00, h11 - h10 - h01 + h00
    # Height over the detector at a distance x past the cut: here + there x + bend x².
    detailed = detailed[interval]
    here = np.where(detailed, h00 + u * slope_u + v * slope_v + u * v * twist, level[interval])
    there = np.where(detailed, du * slope_u + dv * slope_v + (u * dv + v * du) * twist, 0.0)
    bend = np.where(detailed, du * dv * twist, 0.0)
    # A detector on the ground is on it, whatever rounding says.
    constant_is_rounding = (start_m == 0) & (np.abs(here) < _TOUCH_M)
    quadratic = bend - 1 / (2 * frame.radius_m)
    linear = there - 2 * bend * cut_m
    constant = here - there * cut_m + bend * cut_m**2
    constant[constant_is_rounding] = 0.0
    return ProfilePieces(ray + group.start, start_m, end_m, constant, linear, quadratic)
