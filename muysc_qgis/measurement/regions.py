"""Merging neighbouring pixels until each region has counted enough, and errors after it."""

from __future__ import annotations

import numpy as np

from ..progress import Progress, report, silent

#: Rectangles looked at between two reports of the progress.
_RECTANGLES = 256


def merge_pixels(
    counts: np.ndarray, usable: np.ndarray, minimum: float, progress: Progress = silent
) -> np.ndarray:
    """Cut a muogram into rectangles that each hold a minimum of counts.

    The whole picture is halved, each half is halved again and so on, across the longer
    side and where the counts on both sides are most nearly equal, as long as both sides
    keep the minimum.

    Parameters
    ----------
    counts
        (n_elevation, n_azimuth) counts of 0 or more.
    usable
        (n_elevation, n_azimuth), which pixels take part.
    minimum
        Counts that a region must hold; a picture with fewer stays one region.
    progress
        Told the share done.

    Returns
    -------
    numpy.ndarray
        (n_elevation, n_azimuth) number of each pixel's region from 0, −1 where not usable.

    Raises
    ------
    Cancelled
        If `progress` asks for a stop.
    """
    label = np.full(counts.shape, -1)
    # Sums over any rectangle from four corners.
    total = np.zeros((counts.shape[0] + 1, counts.shape[1] + 1))
    total[1:, 1:] = np.where(usable, counts, 0.0).cumsum(axis=0).cumsum(axis=1)
    number = looked_at = labelled = 0
    waiting = [(0, counts.shape[0], 0, counts.shape[1])]
    while waiting:
        if looked_at % _RECTANGLES == 0:
            report(progress, labelled / label.size)
        looked_at += 1
        top, bottom, left, right = _shrunk(waiting.pop(), usable)
        if bottom == top:
            continue
        cut = None
        sides = ((bottom - top, 0), (right - left, 1))
        for _, axis in sorted(sides, reverse=True):
            box = total[top : bottom + 1, left : right + 1]
            along = box[:, -1] - box[:, 0] if axis == 0 else box[-1] - box[0]
            cut = _cut(along - along[0], minimum)
            if cut is not None:
                break
        if cut is None:
            region = label[top:bottom, left:right]
            region[usable[top:bottom, left:right]] = number
            number += 1
            labelled += region.size
        elif axis == 0:
            waiting += [(top, top + cut, left, right), (top + cut, bottom, left, right)]
        else:
            waiting += [(top, bottom, left, left + cut), (top, bottom, left + cut, right)]
    return label


def errors_of_pixels(errors: np.ndarray, region: np.ndarray) -> np.ndarray:
    """Return errors with which the pixels of a region together weigh as much as it.

    Weights are 1/σ²: n pixels that all carry one measurement, with √n times its error, have
    the weight of that one.

    Parameters
    ----------
    errors
        Standard error of each pixel's region, any shape and unit.
    region
        Number of each pixel's region from 0, −1 for a pixel on its own; as many.
    """
    return errors / np.sqrt(shares_of_pixels(region))


def shares_of_pixels(region: np.ndarray) -> np.ndarray:
    """Return the share of an independent datum that each pixel is, 1/n in a region of n.

    Parameters
    ----------
    region
        As in `errors_of_pixels`.
    """
    members = np.bincount(region[region >= 0], minlength=1)
    return 1.0 / np.append(np.maximum(members, 1), 1)[region]


def _shrunk(box: tuple[int, int, int, int], usable: np.ndarray) -> tuple[int, int, int, int]:
    """Return a rectangle without the rows and columns at its edges that take no part."""
    top, bottom, left, right = box
    inside = usable[top:bottom, left:right]
    rows, columns = np.flatnonzero(inside.any(axis=1)), np.flatnonzero(inside.any(axis=0))
    if not rows.size:
        return top, top, left, left
    return (
        top + int(rows[0]), top + int(rows[-1]) + 1,
        left + int(columns[0]), left + int(columns[-1]) + 1,
    )  # fmt: skip


def _cut(running: np.ndarray, minimum: float) -> int | None:
    """Return where to cut a row of sums so that both sides keep the minimum, None if nowhere."""
    if len(running) < 3:
        return None
    lesser = np.minimum(running[1:-1], running[-1] - running[1:-1])
    best = int(np.argmax(lesser))
    return best + 1 if lesser[best] >= max(minimum, 1.0) else None
