"""Trajectories taken together: less resolution, less time."""

from __future__ import annotations

import numpy as np

from ..errors import MuyscError
from .geometry import TelescopeGeometry


def merged_offsets(bars: int, merge: int) -> np.ndarray:
    """Return the pixel offsets in the middle of bins of `merge` trajectories, increasing.

    One bin has the boresight in its middle. The bins at the rim reach beyond the last
    trajectory where `merge` does not fit, and hold those that there are.

    Parameters
    ----------
    bars
        Number of bars N.
    merge
        Trajectories along a side of a bin.

    Raises
    ------
    MuyscError
        If that is not an odd number from 1 to 2 N − 1.
    """
    check_merge(bars, merge)
    most = (bars - 1 + merge // 2) // merge
    return merge * np.arange(-most, most + 1)


def check_merge(bars: int, merge: int) -> None:
    """Refuse bins that do not have the boresight in the middle of one.

    Raises
    ------
    MuyscError
        With the reason.
    """
    if merge != int(merge) or not 1 <= merge <= 2 * bars - 1 or merge % 2 == 0:
        raise MuyscError(
            f"{merge:g} trajectories along a side cannot be merged; give an odd number from 1 to "
            f"{2 * bars - 1}, so that the boresight stays in the middle of a bin."
        )


def merged_bins(geometry: TelescopeGeometry, merge: int) -> tuple[tuple[int, int], np.ndarray]:
    """Return rows and columns of bins of merge × merge trajectories, and the bin of each.

    Returns
    -------
    tuple
        (n_y, n_x), and the number of each trajectory's bin, both row by row.
    """
    places, shape = [], []
    for bars in (geometry.bars_y, geometry.bars_x):
        offsets = merged_offsets(bars, merge)
        shape.append(len(offsets))
        places.append((np.arange(1 - bars, bars) + merge // 2 - int(offsets[0])) // merge)
    return (shape[0], shape[1]), (places[0][:, None] * shape[1] + places[1]).ravel()


def merge_sum(values: np.ndarray, merge: int) -> np.ndarray:
    """Return the sum over bins of merge × merge trajectories.

    Parameters
    ----------
    values
        (…, 2 N_y − 1, 2 N_x − 1); what is lost at no bin: the total stays the same. A
        bin with an unknown value is unknown.
    merge
        Odd number of trajectories along a side.

    Returns
    -------
    numpy.ndarray
        (…, n_y, n_x), as many as `merged_offsets` has.
    """
    for axis in (-1, -2):
        bars = (values.shape[axis] + 1) // 2
        offsets = merged_offsets(bars, merge)
        # Where the first trajectory stands in the first bin.
        lead = 1 - bars - int(offsets[0]) + merge // 2
        padding = [(0, 0)] * values.ndim
        padding[axis] = (lead, lead)
        padded = np.moveaxis(np.pad(values, padding), axis, -1)
        summed = padded.reshape(*padded.shape[:-1], len(offsets), merge).sum(axis=-1)
        values = np.moveaxis(summed, -1, axis)
    return values
