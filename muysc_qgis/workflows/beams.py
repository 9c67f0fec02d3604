"""Sub-rays through the trajectories of a telescope.

The response of a trajectory falls linearly from its middle to zero at the middles of its
neighbours (`forward.responses`), so that a cell between four trajectories is seen by all of
them: nodes of Gauss–Legendre quadrature in each cell serve four trajectories at once. Cells of
the sky get few nodes, cells in which rock begins many.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..forward.responses import TelescopeResponses
from ..progress import Progress, silent
from ..telescope.directions import Pointing
from ..telescope.geometry import TelescopeGeometry
from ..telescope.merging import merge_sum
from ..telescope.sky import corner_tangents
from ..tomography.libraries import scipy_part
from ..topography.frame import LocalFrame
from ..topography.tracing import trace_terrain
from .skyline import Sky, Skyline, skyline, split_columns

#: Nodes across a cell of sky, of rock, and of rock with a ridge.
NODES = (2, 3, 8)

#: Rays along a cell with which it is told which of these it is.
RAYS_PER_CELL = 6.0

#: Share by which the rock of neighbouring rays may differ for the flux to be smooth.
_ABRUPT = 0.3

#: Turn of the boresight (degrees) over which derivatives are taken.
_TURN_DEG = 0.05

#: Degrees above the skyline from which on a sub-ray is not traced.
SURELY_SKY_DEG = 0.02

#: Lowest elevation of a sub-ray, degrees.
LOWEST_DEG = 0.05


@dataclass(frozen=True)
class Beams:
    """Sub-rays, and what share each has in which datum.

    Matrices are CSR of (n_data, n_sub); data are the pixels of a raster, row by row.
    """

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    #: Which sub-rays are known to be of the sky, without tracing.
    sky: np.ndarray
    #: Rows add up to 1, or to 0 where a datum cannot be known.
    weights: Any
    #: Derivatives over azimuth and elevation of the boresight, per degree.
    turned: Any
    tilted: Any

    @property
    def count(self) -> int:
        """Number of sub-rays."""
        return len(self.azimuth_deg)


@dataclass(frozen=True)
class Cells:
    """What the cells between a telescope's trajectories hold, and where the sky begins."""

    #: (2 N_y, 2 N_x): sky (0), rock (1), rock with a ridge (2), rock and sky (3).
    kinds: np.ndarray
    line: Skyline


def look_around(
    geometry: TelescopeGeometry,
    pointing: Pointing,
    frame: LocalFrame,
    eye_m: float,
    max_range_m: float | None = None,
    near_field_m: float = 0.0,
    progress: Progress = silent,
) -> Cells:
    """Return what the cells between a telescope's trajectories hold.

    Parameters
    ----------
    geometry, pointing
        The telescope.
    frame, eye_m, max_range_m, near_field_m, progress
        As in `trace_terrain`.

    Raises
    ------
    MuyscError
        If the DEM cannot be read or the telescope sees nothing above the horizon.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    window = TelescopeResponses(geometry, pointing).window
    step = window.step_deg[0] / RAYS_PER_CELL
    columns, rows = (
        np.linspace(low, high, max(2, math.ceil((high - low) / step) + 1))
        for low, high in (
            (window.left_deg, window.right_deg), (window.low_deg, window.high_deg),
        )
    )  # fmt: skip
    azimuth, elevation = np.meshgrid(columns, rows)
    x, y = pointing.plane(azimuth.ravel(), elevation.ravel())
    place = geometry.bars_y - y / geometry.step, geometry.bars_x + x / geometry.step
    return cells_of(
        columns, rows, place, (2 * geometry.bars_y, 2 * geometry.bars_x),
        (frame, eye_m), max_range_m, near_field_m, progress,
    )  # fmt: skip


def cells_of(
    azimuth_deg: np.ndarray,
    elevation_deg: np.ndarray,
    place: tuple[np.ndarray, np.ndarray],
    shape: tuple[int, int],
    eye: tuple[LocalFrame, float],
    max_range_m: float | None,
    near_field_m: float,
    progress: Progress,
) -> Cells:
    """Return what cells hold, from a grid of rays and the row and column that each is in."""
    thickness = trace_terrain(
        *eye, azimuth_deg, elevation_deg, max_range_m, near_field_m, progress
    ).thickness_m.T
    # What is not known is rock.
    is_rock = ~(thickness == 0)
    line = skyline(*eye, azimuth_deg, elevation_deg, is_rock, max_range_m, near_field_m, progress)
    logarithm = np.log(np.maximum(thickness, 1.0))
    rough = np.zeros(is_rock.shape, bool)
    for axis in (0, 1):
        apart = ~(np.abs(np.diff(logarithm, axis=axis)) <= _ABRUPT)
        low = [slice(None)] * 2
        high = [slice(None)] * 2
        low[axis], high[axis] = slice(None, -1), slice(1, None)
        rough[tuple(low)] |= apart
        rough[tuple(high)] |= apart
    with np.errstate(invalid="ignore"):
        row, column = (np.floor(one) for one in place)
        inside = (row >= 0) & (row < shape[0]) & (column >= 0) & (column < shape[1])
    cell = (row[inside] * shape[1] + column[inside]).astype(int)

    def any_of(values: np.ndarray) -> np.ndarray:
        found = np.bincount(cell, values.ravel()[inside].astype(float), shape[0] * shape[1]) > 0
        return found.reshape(shape)

    # A ray stands for its neighbours too, between which a summit may rise.
    has_rock, has_sky = any_of(_widened(is_rock)), any_of(_widened(~is_rock))
    kinds = np.where(has_rock, np.where(any_of(rough), 2, 1), 0)
    kinds[has_rock & has_sky] = 3
    return Cells(kinds, line)


def _widened(mask: np.ndarray) -> np.ndarray:
    """Return where a mask holds at a place or beside it."""
    wide = mask.copy()
    wide[1:] |= mask[:-1]
    wide[:-1] |= mask[1:]
    result = wide.copy()
    result[:, 1:] |= wide[:, :-1]
    result[:, :-1] |= wide[:, 1:]
    return result


def telescope_beams(
    geometry: TelescopeGeometry,
    pointing: Pointing,
    cells: Cells,
    acceptance: np.ndarray,
    merge: int = 1,
    finer: float = 1.0,
) -> Beams:
    """Return the sub-rays of a telescope's trajectories.

    Parameters
    ----------
    geometry, pointing
        The telescope.
    cells
        What the cells between trajectories hold (`look_around`).
    acceptance
        (2 N_y − 1, 2 N_x − 1) of the trajectories, by which those of a bin weigh.
    merge
        Trajectories along a side of a bin, odd.
    finer
        Times as many nodes along each side of a cell.
    """
    sparse = scipy_part("sparse")
    tall, wide = 2 * geometry.bars_y - 1, 2 * geometry.bars_x - 1
    x_corner, y_corner = corner_tangents(geometry)
    step = geometry.step
    parts: list[list[np.ndarray]] = [[] for _ in range(3)]
    entries: list[list[np.ndarray]] = [[] for _ in range(5)]
    first = 0
    for kind in range(4):
        row, column = np.nonzero(cells.kinds == kind)
        which, a, b, product = nodes_of(
            kind, pointing.sky, (step, step), cells.line, x_corner[column], y_corner[row], finer
        )
        i, j = row[which], column[which]
        x, y = x_corner[j] + step * a, y_corner[i] - step * b
        azimuth, elevation = pointing.sky(x, y)
        turn_x, turn_y, tilt_x, tilt_y = _velocities(pointing, azimuth, elevation)
        parts[0].append(azimuth)
        parts[1].append(elevation)
        parts[2].append(
            np.full(len(x), kind == 0)
            if kind < 3
            else cells.line.above(azimuth, elevation) > SURELY_SKY_DEG
        )
        collected = product / (1.0 + x**2 + y**2) ** 2
        number = first + np.arange(len(x))
        for lower in (0, 1):
            for right in (0, 1):
                fx, fy = (a if right else 1 - a), (b if lower else 1 - b)
                slope_x = (1.0 if right else -1.0) / step * fy
                # Down the rows y falls.
                slope_y = (-1.0 if lower else 1.0) / step * fx
                datum_row, datum_column = i + lower - 1, j + right - 1
                inside = (
                    (datum_row >= 0) & (datum_row < tall)
                    & (datum_column >= 0) & (datum_column < wide)
                )  # fmt: skip
                entries[0].append((datum_row * wide + datum_column)[inside])
                entries[1].append(number[inside])
                entries[2].append((collected * fx * fy)[inside])
                entries[3].append((collected * (slope_x * turn_x + slope_y * turn_y))[inside])
                entries[4].append((collected * (slope_x * tilt_x + slope_y * tilt_y))[inside])
        first += len(x)
    datum, sub, *values = (np.concatenate(one) for one in entries)
    shape = (tall * wide, first)
    matrices = [sparse.csr_matrix((one, (datum, sub)), shape=shape) for one in values]
    azimuth, elevation, sky = (np.concatenate(one) for one in parts)
    # Below the horizon no flux is known: what reaches there says nothing.
    low = np.asarray(matrices[0] @ (elevation < LOWEST_DEG).astype(float)) > 0
    total = np.asarray(matrices[0].sum(axis=1)).ravel()
    scale = np.where(low, 0.0, 1.0 / np.where(total > 0, total, 1.0))
    weights, *turns = (sparse.diags(scale) @ one for one in matrices)
    # Turning changes what is seen, not how much is collected of an even sky.
    drifts = (np.asarray(one.sum(axis=1)).ravel() for one in turns)
    matrices = [
        weights, *(one - sparse.diags(drift) @ weights for one, drift in zip(turns, drifts)),
    ]  # fmt: skip
    if merge > 1:
        joined = _bins(acceptance, merge)
        matrices = [joined @ one for one in matrices]
        lost = joined @ (scale == 0).astype(float) > 0
        matrices = [sparse.diags(np.where(lost, 0.0, 1.0)) @ one for one in matrices]
    return Beams(
        azimuth, np.maximum(elevation, LOWEST_DEG), sky, *(one.tocsr() for one in matrices)
    )


def nodes_of(
    kind: int,
    sky: Sky,
    step: tuple[float, float],
    line: Skyline,
    left: np.ndarray,
    top: np.ndarray,
    finer: float,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return cell, shares from left and top, and weight of the nodes in cells of one kind."""
    if kind == 3:
        return split_columns(sky, step, line, left, top, finer)
    node, weight = np.polynomial.legendre.leggauss(round(NODES[kind] * finer))
    share, weight = (node + 1) / 2, weight / 2
    across, down = (one.ravel() for one in np.meshgrid(share, share))
    product = (weight[:, None] * weight[None, :]).ravel()
    count = len(left)
    return (
        np.repeat(np.arange(count), len(product)), np.tile(across, count), np.tile(down, count),
        np.tile(product, count),
    )  # fmt: skip


def _velocities(
    pointing: Pointing, azimuth: np.ndarray, elevation: np.ndarray
) -> tuple[np.ndarray, ...]:
    """Return how tangents of fixed directions move as the boresight turns and rises, per degree."""
    result = []
    for turn, rise in ((_TURN_DEG, 0.0), (0.0, _TURN_DEG)):
        ends = []
        for sign in (1.0, -1.0):
            # Over the top of ±90° nothing is gained by going on.
            height = np.clip(pointing.elevation_deg + sign * rise, -90.0, 90.0)
            around = (pointing.azimuth_deg + sign * turn + 180.0) % 360.0 - 180.0
            ends.append(
                Pointing(around, float(height), pointing.roll_deg).plane(azimuth, elevation)
            )
        for one, other in zip(*ends):
            result.append(np.nan_to_num((one - other) / (2 * _TURN_DEG)))
    return tuple(result)


def _bins(acceptance: np.ndarray, merge: int) -> Any:
    """Return the matrix from trajectories to the means over bins, weighed by acceptance."""
    sparse = scipy_part("sparse")
    total = merge_sum(acceptance, merge)
    number = np.arange(acceptance.size).reshape(acceptance.shape)
    bars_y, bars_x = ((size + 1) // 2 for size in acceptance.shape)

    def bin_of(bars: int, count: int) -> np.ndarray:
        return (np.arange(1 - bars, bars) + (count // 2) * merge + merge // 2) // merge

    row, column = bin_of(bars_y, total.shape[0]), bin_of(bars_x, total.shape[1])
    which = row[:, None] * total.shape[1] + column[None, :]
    values = acceptance / total.ravel()[which]
    return sparse.csr_matrix(
        (values.ravel(), (which.ravel(), number.ravel())), shape=(total.size, acceptance.size)
    )
