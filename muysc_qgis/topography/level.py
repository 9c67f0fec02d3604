"""Ground that no ray meets, of which only matters that it is above or below."""

from __future__ import annotations

from typing import Any

import numpy as np

from .frame import LocalFrame


def ray_heights(
    tangents: tuple[np.ndarray, np.ndarray], group: slice, knot_m: np.ndarray, frame: LocalFrame
) -> tuple[np.ndarray, np.ndarray]:
    """Return least and greatest height (m) over the detector of rays between knots.

    Over level ground, that is with the curvature drop; (n_azimuth · intervals,).
    """
    near, far = knot_m[:-1], knot_m[1:]
    lowest, highest = tangents[0][group, None], tangents[1][group, None]
    least = np.minimum(lowest * near, lowest * far) + frame.drop(near)
    greatest = np.maximum(highest * near, highest * far) + frame.drop(far)
    return least.ravel(), greatest.ravel()


def level_ground(
    heights: np.ndarray,
    path: tuple[np.ndarray, ...],
    rays: tuple[np.ndarray, np.ndarray],
) -> np.ndarray:
    """Return heights at which level ground serves as well as the ground there is.

    Where all rays of an interval pass over every height around it, or under, it
    only matters that the ground is lower, or higher: level ground as high as the
    highest around does both.

    Parameters
    ----------
    heights
        (rows, columns) of the window, over the detector.
    path
        (n_interval,) columns where the intervals start and end, and rows.
    rays
        (n_interval,) least and greatest height of the rays on each interval.

    Returns
    -------
    ndarray
        (n_interval,) heights, NaN where the ground counts.
    """
    u0, u1, v0, v1 = path
    # Tiles at least as wide as any interval: two by two hold each.
    spans = np.abs(np.concatenate([u1 - u0, v1 - v0]))
    tile = 2 + int(np.max(spans, initial=0, where=np.isfinite(spans)))
    boxes = [
        np.clip(np.nan_to_num(position), 0, size - 1).astype(np.int64) // tile
        for low, high, size in (
            (np.minimum(u0, u1), np.maximum(u0, u1), heights.shape[1]),
            (np.minimum(v0, v1), np.maximum(v0, v1), heights.shape[0]),
        )
        for position in (low, high + 1)
    ]

    def extreme(choose: Any, unknown: float) -> np.ndarray:
        known = np.where(np.isnan(heights), unknown, heights)
        for axis in (0, 1):
            known = choose.reduceat(known, np.arange(0, known.shape[axis], tile), axis=axis)
        left, right, top, bottom = boxes
        return choose(
            choose(known[top, left], known[top, right]),
            choose(known[bottom, left], known[bottom, right]),
        )

    highest, lowest = extreme(np.maximum, np.inf), extreme(np.minimum, -np.inf)
    least, greatest = rays
    return np.where((least > highest) | (greatest < lowest), highest, np.nan)
