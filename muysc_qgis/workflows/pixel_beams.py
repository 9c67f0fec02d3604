"""Sub-rays through the pixels of a muogram."""

from __future__ import annotations

import numpy as np

from ..progress import Progress, silent
from ..tomography.libraries import scipy_part
from ..topography.frame import LocalFrame
from .beams import (
    LOWEST_DEG,
    RAYS_PER_CELL,
    SURELY_SKY_DEG,
    Beams,
    Cells,
    cells_of,
    nodes_of,
)

#: Times as many nodes along each side as a cell between trajectories has.
_FINER = 2.0


def look_at_pixels(
    azimuth_deg: np.ndarray,
    elevation_deg: np.ndarray,
    frame: LocalFrame,
    eye_m: float,
    max_range_m: float | None = None,
    near_field_m: float = 0.0,
    progress: Progress = silent,
) -> Cells:
    """Return what the pixels of a muogram hold; see `look_around`.

    Parameters
    ----------
    azimuth_deg, elevation_deg
        As in `pixel_beams`.
    frame, eye_m, max_range_m, near_field_m, progress
        As in `trace_terrain`.

    Raises
    ------
    MuyscError
        If the DEM cannot be read.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    rays, places = [], []
    for axis in (azimuth_deg, elevation_deg):
        step = _step(axis)
        count = round(RAYS_PER_CELL) * len(axis) + 1
        place = np.linspace(0.0, len(axis), count)
        if step < 0:
            place = place[::-1]
        rays.append(axis[0] + step * (place - 0.5))
        places.append(np.minimum(place, len(axis) - 1e-9))
    above = (rays[1] > LOWEST_DEG) & (rays[1] <= 90.0)
    column, row = np.meshgrid(places[0], places[1][above])
    return cells_of(
        rays[0], rays[1][above], (row.ravel(), column.ravel()),
        (len(elevation_deg), len(azimuth_deg)), (frame, eye_m),
        max_range_m, near_field_m, progress,
    )  # fmt: skip


def pixel_beams(
    azimuth_deg: np.ndarray, elevation_deg: np.ndarray, cells: Cells, finer: float = 1.0
) -> Beams:
    """Return the sub-rays of a muogram's pixels, each of which collects evenly over its face.

    Parameters
    ----------
    azimuth_deg, elevation_deg
        (n_azimuth,) and (n_elevation,) middles of the pixels, evenly spaced, in the order of
        the raster.
    cells
        What the pixels hold (`look_at_pixels`).
    finer
        Times as many nodes along each side of a pixel.
    """
    sparse = scipy_part("sparse")
    wide, tall = len(azimuth_deg), len(elevation_deg)
    across, up = (_step(axis) for axis in (azimuth_deg, elevation_deg))
    left, top = azimuth_deg - 0.5 * abs(across), elevation_deg + 0.5 * abs(up)
    found: list[list[np.ndarray]] = [[] for _ in range(7)]
    for kind in range(4):
        row, column = np.nonzero(cells.kinds == kind)
        which, a, b, product = nodes_of(
            kind, lambda x, y: (x, y), (abs(across), abs(up)), cells.line, left[column], top[row],
            _FINER * finer,
        )  # fmt: skip
        i, j = row[which], column[which]
        azimuth, elevation = left[j] + abs(across) * a, top[i] - abs(up) * b
        sky = np.full(len(i), kind == 0)
        if kind == 3:
            sky = cells.line.above(azimuth, elevation) > SURELY_SKY_DEG
        value = product * np.cos(np.radians(elevation))
        for part, one in zip(found, (azimuth, elevation, sky, i * wide + j, value, a, b)):
            part.append(one)
    azimuth, elevation, sky, datum, value, right, lower = (np.concatenate(one) for one in found)
    lost = np.bincount(datum, elevation < LOWEST_DEG, wide * tall) > 0
    lost |= np.bincount(datum, elevation > 90.0, wide * tall) > 0
    total = np.bincount(datum, value, wide * tall)
    value = np.where(lost[datum], 0.0, value / np.where(lost, 1.0, total)[datum])
    number = np.arange(len(value))
    weights = sparse.csr_matrix((value, (datum, number)), shape=(wide * tall, len(value)))
    # The slope of what is seen over the pixel's face, by least squares: 12 ∫ (s − ½) I ds.
    turns = []
    for slope in (12 * (right - 0.5) / abs(across), 12 * (0.5 - lower) / abs(up)):
        one = sparse.csr_matrix((value * slope, (datum, number)), shape=weights.shape)
        turns.append(one - sparse.diags(np.asarray(one.sum(axis=1)).ravel()) @ weights)
    return Beams(
        azimuth, np.clip(elevation, LOWEST_DEG, 90.0), sky, weights,
        *(one.tocsr() for one in turns),
    )  # fmt: skip


def _step(axis: np.ndarray) -> float:
    """Return the distance of neighbouring pixels, 1° of a single one."""
    return float(axis[-1] - axis[0]) / (len(axis) - 1) if len(axis) > 1 else 1.0
