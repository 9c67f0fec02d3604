"""Sub-rays through the trajectories of a telescope, and through the pixels of a muogram.

The response of a trajectory falls linearly from its middle to zero at the middles of its
neighbours (`telescope.quadrature`), so that a cell between four trajectories is seen by all of
them: nodes of Gauss–Legendre quadrature in each cell serve four trajectories at once. Cells of
the sky get few nodes, cells in which rock begins many.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..progress import Progress, silent
from ..telescope.directions import Pointing
from ..telescope.geometry import TelescopeGeometry
from ..telescope.merging import merge_sum
from ..telescope.quadrature import corner_tangents
from ..telescope.sky_table import grid_around
from ..tomography.libraries import scipy_part
from ..topography.frame import LocalFrame
from ..topography.tracing import trace_terrain
from .skyline import Skyline, skyline, split_columns

#: Nodes across a cell of sky, of rock, and of rock with a ridge.
NODES = (2, 3, 8)

#: Rays along a cell with which it is told which of these it is.
_RAYS_PER_CELL = 6.0

#: Share by which the rock of neighbouring rays may differ for the flux to be smooth.
_ABRUPT = 0.3

#: Turn of the boresight (degrees) over which derivatives are taken.
_TURN_DEG = 0.05

#: Degrees above the skyline from which on a sub-ray is not traced.
_SURELY_SKY_DEG = 0.02

#: Lowest elevation of a sub-ray, degrees.
_LOWEST_DEG = 0.05


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
    grid = grid_around(geometry, pointing, _RAYS_PER_CELL)
    limits = (max_range_m, near_field_m, progress)
    thickness = trace_terrain(
        frame, eye_m, grid.azimuth_deg, grid.elevation_deg, *limits
    ).thickness_m.T
    azimuth, elevation = np.meshgrid(grid.azimuth_deg, grid.elevation_deg)
    # What is not known is rock.
    is_rock = ~(thickness == 0)
    line = skyline(frame, eye_m, grid.azimuth_deg, grid.elevation_deg, is_rock, *limits)
    logarithm = np.log(np.maximum(thickness, 1.0))
    rough = np.zeros(is_rock.shape, bool)
    for axis in (0, 1):
        apart = ~(np.abs(np.diff(logarithm, axis=axis)) <= _ABRUPT)
        low = [slice(None)] * 2
        high = [slice(None)] * 2
        low[axis], high[axis] = slice(None, -1), slice(1, None)
        rough[tuple(low)] |= apart
        rough[tuple(high)] |= apart
    x, y = pointing.plane(azimuth.ravel(), elevation.ravel())
    shape = (2 * geometry.bars_y, 2 * geometry.bars_x)
    with np.errstate(invalid="ignore"):
        row = np.floor(geometry.bars_y - y / geometry.step)
        column = np.floor(geometry.bars_x + x / geometry.step)
        inside = (row >= 0) & (row < shape[0]) & (column >= 0) & (column < shape[1])
    cell = (row[inside] * shape[1] + column[inside]).astype(int)
    number = shape[0] * shape[1]

    def any_of(values: np.ndarray) -> np.ndarray:
        found = np.bincount(cell, values.ravel()[inside].astype(float), number) > 0
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
        which, a, b, product = _nodes_of(
            kind, geometry, pointing, cells.line, x_corner[column], y_corner[row]
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
            else cells.line.above(azimuth, elevation) > _SURELY_SKY_DEG
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
    low = np.asarray(matrices[0] @ (elevation < _LOWEST_DEG).astype(float)) > 0
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
        azimuth, np.maximum(elevation, _LOWEST_DEG), sky, *(one.tocsr() for one in matrices)
    )


def _nodes_of(
    kind: int,
    geometry: TelescopeGeometry,
    pointing: Pointing,
    line: Skyline,
    left: np.ndarray,
    top: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return cell, shares from left and top, and weight of the nodes in cells of one kind."""
    if kind == 3:
        return split_columns(geometry, pointing, line, left, top)
    node, weight = np.polynomial.legendre.leggauss(NODES[kind])
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


def pixel_beams(azimuth_deg: np.ndarray, elevation_deg: np.ndarray, nodes: int = 4) -> Beams:
    """Return the sub-rays of a muogram's pixels, each of which collects evenly over its face.

    Parameters
    ----------
    azimuth_deg, elevation_deg
        (n_azimuth,) and (n_elevation,) middles of the pixels, evenly spaced, in the order of
        the raster.
    nodes
        Nodes across a pixel.
    """
    sparse = scipy_part("sparse")
    node, weight = np.polynomial.legendre.leggauss(nodes)
    share, weight = node / 2, weight / 2
    wide, tall = len(azimuth_deg), len(elevation_deg)
    step = [
        float(axis[-1] - axis[0]) / (len(axis) - 1) if len(axis) > 1 else 1.0
        for axis in (azimuth_deg, elevation_deg)
    ]
    azimuth = (azimuth_deg[:, None] + abs(step[0]) * share).ravel()
    elevation = (elevation_deg[:, None] + abs(step[1]) * share).ravel()
    number = np.arange(len(elevation) * len(azimuth))
    row, column = np.divmod(number, len(azimuth))
    datum = (row // nodes) * wide + column // nodes
    value = weight[row % nodes] * weight[column % nodes] * np.cos(np.radians(elevation[row]))
    low = elevation[row] < _LOWEST_DEG
    lost = np.bincount(datum, low, wide * tall) > 0
    total = np.bincount(datum, value, wide * tall)
    value = np.where(lost[datum], 0.0, value / total[datum])
    weights = sparse.csr_matrix((value, (datum, number)), shape=(wide * tall, len(number)))
    turned = _differences(wide, tall, 1, step[0]) @ weights
    tilted = _differences(wide, tall, 0, step[1]) @ weights
    return Beams(
        azimuth[column], np.maximum(elevation[row], _LOWEST_DEG), np.zeros(len(number), bool),
        weights, turned.tocsr(), tilted.tocsr(),
    )  # fmt: skip


def _differences(wide: int, tall: int, axis: int, step: float) -> Any:
    """Return central differences of a raster along an axis, one-sided at its rim."""
    sparse = scipy_part("sparse")
    count = wide if axis else tall
    number = np.arange(count)
    low, high = np.maximum(number - 1, 0), np.minimum(number + 1, count - 1)
    value = 1.0 / (np.maximum(high - low, 1) * step)
    one = sparse.csr_matrix(
        (
            np.concatenate([value, -value]),
            (np.concatenate([number, number]), np.concatenate([high, low])),
        ),
        shape=(count, count),
    )
    pair = (sparse.identity(tall), one) if axis else (one, sparse.identity(wide))
    return sparse.kron(*pair, format="csr")


__all__ = ["NODES", "Beams", "Cells", "look_around", "pixel_beams", "telescope_beams"]
