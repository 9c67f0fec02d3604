"""Rock crossed by straight rays from one point, exact on the given profiles.

On a profile the height over the detector divided by the distance is the tangent
of the elevation angle under which the ground is seen. A ray is in rock wherever
that tangent exceeds its own. So one pass over a profile serves all rays of its
azimuth: a piece of ground lies wholly above the rays below it, wholly under
those above it, and cuts only the few that meet it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import IntEnum

import numpy as np

#: Distances (m) closer than this are the same place.
_SAME_M = 1e-3


class Outcome(IntEnum):
    """What is known about a ray."""

    KNOWN = 0
    #: Still in rock where the user's range ends: the thickness is cut there.
    TRUNCATED = 1
    #: In rock at the edge of the terrain model.
    EDGE = 2
    #: Passes a gap in the terrain model, lower than the highest ground on its way.
    NO_DATA = 3


@dataclass(frozen=True)
class ProfilePieces:
    """Pieces of terrain profiles, on each of which the height is a quadratic.

    All arrays have shape (n,), ordered by ray and then by distance; successive
    blocks of the same rays follow each other outwards. The height above the
    detector at horizontal distance s, less the curvature drop, is
    constant + linear · s + quadratic · s² (m); all NaN where it is unknown.
    """

    ray: np.ndarray
    start_m: np.ndarray
    end_m: np.ndarray
    constant: np.ndarray
    linear: np.ndarray
    quadratic: np.ndarray


@dataclass(frozen=True)
class RockPaths:
    """What rays meet; all arrays (n_azimuth, n_elevation), lengths slant, in m."""

    #: Length in rock, NaN where it cannot be known.
    thickness_m: np.ndarray
    #: Length to the first rock, NaN where there is none or it lies past a gap.
    distance_m: np.ndarray
    #: Length to where the ray leaves the last rock, NaN where there is none or it
    #: cannot be known.
    exit_m: np.ndarray
    #: Codes of `Outcome`.
    outcome: np.ndarray

    def count(self, outcome: Outcome) -> int:
        """Return the number of rays with an outcome."""
        return int(np.count_nonzero(self.outcome == outcome))


def rock_along_rays(
    blocks: Iterable[ProfilePieces],
    elevation_deg: np.ndarray,
    range_m: np.ndarray,
) -> RockPaths:
    """Measure the rock on rays of several elevations over profiles of several azimuths.

    Parameters
    ----------
    blocks
        Pieces of the profiles of azimuths 0 … n_azimuth − 1, near to far.
    elevation_deg
        Elevation angles in (−90, 90], increasing: (n_elevation,) for the same in
        every azimuth, or (n_azimuth, 1) for one of its own in each.
    range_m
        (n_azimuth,) distance at which the user's range ends a profile: a ray in
        rock there is truncated. Infinite where the profile ends at the terrain
        model's edge, where a ray in rock is unknown.

    Returns
    -------
    RockPaths
        Cost: O(pieces + rays + ground crossings) in time and memory per block.
    """
    radians = np.radians(elevation_deg)
    tangent = np.tan(radians)
    tally = _Tally.empty(len(range_m), tangent.shape[-1])
    for pieces in blocks:
        tally.gaps.append(_gaps(pieces))
        _note_highest(tally, pieces)
        _add(tally, _monotone(pieces), tangent)
    return _finish(tally, tangent, np.cos(radians), range_m)


@dataclass
class _Tally:
    """Horizontal lengths added up so far, per azimuth and elevation."""

    length: np.ndarray
    first: np.ndarray
    last: np.ndarray
    #: (n_azimuth,) distance and tangent of the ground at the profile's known end.
    end_m: np.ndarray
    end_tangent: np.ndarray
    #: Runs of unknown ground: (ray, start, end) columns per block.
    gaps: list[np.ndarray]
    #: (n_azimuth,) highest known ground above the detector.
    highest: np.ndarray

    @classmethod
    def empty(cls, n_azimuth: int, n_elevation: int) -> _Tally:
        shape = (n_azimuth, n_elevation)
        return cls(
            np.zeros(shape),
            np.full(shape, np.inf),
            np.full(shape, -np.inf),
            np.zeros(n_azimuth),
            np.full(n_azimuth, -np.inf),
            [],
            np.full(n_azimuth, -np.inf),
        )


def _ground_tangent(
    distance: np.ndarray, constant: np.ndarray, linear: np.ndarray, quadratic: np.ndarray
) -> np.ndarray:
    """Return the tangent under which ground is seen; ±∞ straight above or below."""
    with np.errstate(divide="ignore", invalid="ignore"):
        vertical = constant / distance
    # At the detector's foot 0/0 means that it stands on the ground.
    return np.where(constant == 0, 0.0, vertical) + linear + quadratic * distance


@dataclass(frozen=True)
class _MonotonePieces:
    """Known pieces on which the ground's tangent only rises or only falls."""

    ray: np.ndarray
    start_m: np.ndarray
    end_m: np.ndarray
    constant: np.ndarray
    linear: np.ndarray
    quadratic: np.ndarray
    start_tangent: np.ndarray
    end_tangent: np.ndarray


def _monotone(pieces: ProfilePieces) -> _MonotonePieces:
    """Drop unknown pieces and split the others where their tangent turns."""
    known = np.isfinite(pieces.constant)
    with np.errstate(divide="ignore", invalid="ignore"):
        turn = np.sqrt(pieces.constant / pieces.quadratic)
    turns = known & (turn > pieces.start_m) & (turn < pieces.end_m)
    source = np.repeat(np.arange(len(known)), np.where(turns, 2, known))
    start, end = pieces.start_m[source], pieces.end_m[source]
    first = np.flatnonzero(source[1:] == source[:-1])
    end[first] = start[first + 1] = turn[turns]
    a, b, c = pieces.constant[source], pieces.linear[source], pieces.quadratic[source]
    return _MonotonePieces(
        pieces.ray[source], start, end, a, b, c,
        _ground_tangent(start, a, b, c), _ground_tangent(end, a, b, c),
    )  # fmt: skip


def _count_below(tangent: np.ndarray, ray: np.ndarray, value: np.ndarray) -> np.ndarray:
    """Return how many of the ray's tangents, which increase, are below a value."""
    if tangent.ndim == 1:
        return np.searchsorted(tangent, value)
    return (tangent[ray, 0] < value).astype(np.int64)


def _add(tally: _Tally, pieces: _MonotonePieces, tangent: np.ndarray) -> None:
    """Add the rock that pieces of ground put on the rays."""
    if not len(pieces.ray):
        return
    low = np.minimum(pieces.start_tangent, pieces.end_tangent)
    high = np.maximum(pieces.start_tangent, pieces.end_tangent)
    below = _count_below(tangent, pieces.ray, low)
    reached = _count_below(tangent, pieces.ray, high)

    # A block holds the profiles of neighbouring azimuths: only their share of
    # the tally is touched.
    origin = int(pieces.ray.min())
    touched = slice(origin, int(pieces.ray.max()) + 1)
    length, first, last = tally.length[touched], tally.first[touched], tally.last[touched]
    n_azimuth, n_elevation = length.shape

    # Rays below the whole piece: noted at the first elevation not below it, then
    # carried down over the elevations.
    stretch = _Stretches.of(
        (pieces.ray - origin) * (n_elevation + 1) + below,
        pieces.start_m,
        pieces.end_m,
        (n_azimuth, n_elevation + 1),
    )
    downwards = (slice(None), slice(None, 0, -1))
    upwards = (slice(None), slice(None, None, -1))
    length += np.cumsum(stretch.length[downwards], axis=1)[upwards]
    near = np.minimum.accumulate(stretch.first[downwards], axis=1)[upwards]
    far = np.maximum.accumulate(stretch.last[downwards], axis=1)[upwards]
    np.minimum(first, near, out=first)
    np.maximum(last, far, out=last)

    # Rays that meet the ground within the piece.
    count = reached - below
    piece = np.repeat(np.arange(len(count)), count)
    elevation = np.arange(len(piece)) - np.repeat(np.cumsum(count) - count, count) + below[piece]
    ray = pieces.ray[piece]
    met = _meeting(pieces, piece, tangent[elevation] if tangent.ndim == 1 else tangent[ray, 0])
    rising = pieces.end_tangent[piece] > pieces.start_tangent[piece]
    stretch = _Stretches.of(
        (ray - origin) * n_elevation + elevation,
        np.where(rising, met, pieces.start_m[piece]),
        np.where(rising, pieces.end_m[piece], met),
        (n_azimuth, n_elevation),
    )
    length += stretch.length
    np.minimum(first, stretch.first, out=first)
    np.maximum(last, stretch.last, out=last)

    tally.end_m[pieces.ray] = pieces.end_m
    tally.end_tangent[pieces.ray] = pieces.end_tangent


@dataclass(frozen=True)
class _Stretches:
    """Stretches of rock gathered by slot: total length, nearest start, farthest end."""

    length: np.ndarray
    first: np.ndarray
    last: np.ndarray

    @classmethod
    def of(
        cls, slot: np.ndarray, start: np.ndarray, end: np.ndarray, shape: tuple[int, int]
    ) -> _Stretches:
        size = shape[0] * shape[1]
        first, last = np.full(size, np.inf), np.full(size, -np.inf)
        # Of several stretches in one slot the one assigned last stays, and they
        # come ordered by distance: assigned from the far end the nearest stays.
        first[slot[::-1]] = start[::-1]
        last[slot] = end
        length = np.bincount(slot, end - start, size)
        return cls(length.reshape(shape), first.reshape(shape), last.reshape(shape))


def _meeting(pieces: _MonotonePieces, piece: np.ndarray, tangent: np.ndarray) -> np.ndarray:
    """Return the distance at which rays of given tangents meet pieces of ground.

    The one root of quadratic s² + (linear − tangent) s + constant = 0 within the
    piece, by the form of the quadratic formula without cancellation.
    """
    start, end = pieces.start_m[piece], pieces.end_m[piece]
    c, a = pieces.quadratic[piece], pieces.constant[piece]
    b = pieces.linear[piece] - tangent
    q = -0.5 * (b + np.copysign(np.sqrt(np.maximum(b * b - 4 * a * c, 0)), b))
    with np.errstate(divide="ignore", invalid="ignore"):
        one, other = q / c, a / q

    def outside(root: np.ndarray) -> np.ndarray:
        miss = np.maximum(start - root, root - end)
        return np.where(np.isnan(miss), np.inf, miss)

    return np.clip(np.where(outside(one) < outside(other), one, other), start, end)


def _gaps(pieces: ProfilePieces) -> np.ndarray:
    """Return (n, 3) ray, start and end of each run of unknown ground."""
    unknown = ~np.isfinite(pieces.constant)
    if not unknown.any():
        return np.empty((0, 3))
    ray = pieces.ray[unknown]
    start, end = pieces.start_m[unknown], pieces.end_m[unknown]
    goes_on = (ray[1:] == ray[:-1]) & (np.abs(start[1:] - end[:-1]) < _SAME_M)
    begins = np.append(True, ~goes_on)
    stops = np.append(~goes_on, True)
    return np.column_stack([ray[begins], start[begins], end[stops]])


def _note_highest(tally: _Tally, pieces: ProfilePieces) -> None:
    """Note the highest known ground above the detector, curvature drop included."""
    if not len(pieces.ray):
        return
    start, end = (
        pieces.constant + (pieces.linear + pieces.quadratic * distance) * distance
        for distance in (pieces.start_m, pieces.end_m)
    )
    first = np.flatnonzero(np.append(True, pieces.ray[1:] != pieces.ray[:-1]))
    ray = pieces.ray[first]
    highest = np.fmax.reduceat(np.fmax(start, end), first)  # NaN is unknown
    tally.highest[ray] = np.fmax(tally.highest[ray], highest)


def _finish(
    tally: _Tally, tangent: np.ndarray, cosine: np.ndarray, range_m: np.ndarray
) -> RockPaths:
    """Turn horizontal lengths into slant ones and say what is unknown."""
    outcome = np.full(tally.length.shape, Outcome.KNOWN, np.uint8)
    in_rock_at_end = tangent < tally.end_tangent[:, None]
    outcome[in_rock_at_end] = Outcome.EDGE
    at_range = np.abs(tally.end_m - range_m) < _SAME_M
    outcome[in_rock_at_end & at_range[:, None]] = Outcome.TRUNCATED
    gaps = np.concatenate(tally.gaps) if tally.gaps else np.empty((0, 3))
    # Unknown ground that goes on to the end of the profile is the terrain
    # model's edge: a ray that gets there through the air is in the sky, as it is
    # at the edge of the raster.
    order = np.lexsort((gaps[:, 1], gaps[:, 0]))
    for ray, start, end in gaps[order]:
        ray_index = int(ray)
        if start >= tally.end_m[ray_index] - _SAME_M:
            continue
        slope = tangent if tangent.ndim == 1 else tangent[ray_index]
        clear = np.minimum(slope * start, slope * end) > tally.highest[ray_index]
        outcome[ray_index, ~clear] = Outcome.NO_DATA
        # Rock beyond the gap need not be the first.
        tally.first[ray_index, ~clear & (tally.first[ray_index] > start)] = np.inf

    known = outcome <= Outcome.TRUNCATED
    # A ray that only touches the ground meets no rock.
    touches = known & (tally.length == 0)
    meets = np.isfinite(tally.first) & ~touches
    with np.errstate(invalid="ignore"):
        thickness = np.where(known, tally.length / cosine, np.nan)
        distance = np.where(meets, tally.first / cosine, np.nan)
        leave = np.where(known & meets, tally.last / cosine, np.nan)
    return RockPaths(thickness, distance, leave, outcome)
