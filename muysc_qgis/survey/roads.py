"""Distances from places to lines, such as roads."""

from __future__ import annotations

import numpy as np


def distance_to_lines(
    x: np.ndarray, y: np.ndarray, segments: np.ndarray, farthest_m: float
) -> np.ndarray:
    """Return the distance (m) from each place to the nearest segment, exact up to a limit.

    Parameters
    ----------
    x, y
        (n,) places in a plane in metres.
    segments
        (m, 4) x and y of one end and of the other.
    farthest_m
        Larger distances are infinite.

    Returns
    -------
    numpy.ndarray
        (n,). O(n log n + m × the places within the limit in x).
    """
    nearest = np.full(len(x), np.inf)
    if not len(x):
        return nearest
    order = np.argsort(x, kind="stable")
    x, y = x[order], y[order]
    west, east = np.sort(segments[:, [0, 2]]).T
    south, north = np.sort(segments[:, [1, 3]]).T
    first = np.searchsorted(x, west - farthest_m, side="left")
    last = np.searchsorted(x, east + farthest_m, side="right")
    close = (first < last) & (south <= y.max() + farthest_m) & (north >= y.min() - farthest_m)
    for index in np.flatnonzero(close):
        run = slice(first[index], last[index])
        distance = _to_segment(x[run], y[run], segments[index])
        np.minimum(nearest[run], distance, out=nearest[run])
    nearest[nearest > farthest_m] = np.inf
    result = np.empty_like(nearest)
    result[order] = nearest
    return result


def _to_segment(x: np.ndarray, y: np.ndarray, segment: np.ndarray) -> np.ndarray:
    """Return the distance of places to one segment."""
    x0, y0, x1, y1 = segment
    dx, dy = x1 - x0, y1 - y0
    square = dx * dx + dy * dy
    along = ((x - x0) * dx + (y - y0) * dy) / square if square > 0 else np.zeros(len(x))
    along = np.clip(along, 0.0, 1.0)
    return np.hypot(x - x0 - along * dx, y - y0 - along * dy)
