"""Heights of a DEM at many points."""

from __future__ import annotations

import numpy as np

from .dem import Dem


def heights_at(dem: Dem, column: np.ndarray, row: np.ndarray) -> np.ndarray:
    """Return the bilinear heights (m) at grid positions, any shape, NaN where unknown.

    Reads the one window that holds all points: O(points + cells of that window).

    Raises
    ------
    MuyscError
        If the DEM cannot be read.
    """
    column, row = np.broadcast_arrays(np.asarray(column, float), np.asarray(row, float))
    result = np.full(column.shape, np.nan)
    inside = dem.contains(column, row)
    if not inside.any():
        return result
    column, row = column[inside], row[inside]
    i = np.floor(column).astype(int)
    if not dem.wraps:
        i = np.clip(i, 0, dem.columns - 2)
    j = np.clip(np.floor(row).astype(int), 0, dem.rows - 2)
    left, top = int(i.min()), int(j.min())
    cells = dem.read(left, top, int(i.max()) - left + 2, int(j.max()) - top + 2)
    u, v = column - i, row - j
    i, j = i - left, j - top
    total = np.zeros(column.shape)
    for down, weight_down in ((0, 1 - v), (1, v)):
        for right, weight_right in ((0, 1 - u), (1, u)):
            weight = weight_down * weight_right
            # A corner of weight 0 has no say, not even when it is unknown.
            total += np.where(weight == 0, 0.0, weight * cells[j + down, i + right])
    result[inside] = total
    return result
