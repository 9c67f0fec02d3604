"""Quantities on a grid of azimuths and elevations, looked up in any direction.

Rays that share an azimuth share a terrain profile, so that a grid that is finer than a
telescope's trajectories costs less than the trajectories themselves.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..radiography.aperture import MEMORY_LIMIT
from .directions import Pointing
from .geometry import TelescopeGeometry
from .quadrature import corner_tangents

#: Height in steps at which the lowest row above the horizon stands: on it the flux is
#: still known, and it is lost for the least possible part of the sky.
_ABOVE_HORIZON = 1e-6

#: Lowest elevation of a ray in degrees; straight down there is no tangent.
_LOWEST_DEG = -89.9

#: Arrays of float64 alive at once per ray.
_ARRAYS_PER_RAY = 30

#: Change of a logarithm across one step of the grid that counts as abrupt.
_ABRUPT = 0.35

#: Smallest value whose logarithm is taken.
_TINY = 1e-300


@dataclass(frozen=True)
class SkyGrid:
    """Directions of a regular grid that holds a telescope's field of view.

    Parameters
    ----------
    azimuth_deg
        (n_azimuth,) increasing, evenly spaced; around the whole sky where the zenith is
        in view.
    elevation_deg
        (n_elevation,) increasing; one of them just above the horizon where that is in
        view.
    """

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray


def grid_around(geometry: TelescopeGeometry, pointing: Pointing, rays_per_bar: float) -> SkyGrid:
    """Return a grid over everything that a telescope sees.

    Parameters
    ----------
    geometry, pointing
        The telescope.
    rays_per_bar
        Rays along a side for each step between two trajectories in the middle.

    Raises
    ------
    MuyscError
        If that is no number from 1 to 50 or takes too much memory.
    """
    if not 1 <= rays_per_bar <= 50:
        raise MuyscError(f"{rays_per_bar:g} rays a bar are impossible; give a number from 1 to 50.")
    x, y = corner_tangents(geometry)
    rim_x = np.concatenate([x, x, np.full(len(y), x[0]), np.full(len(y), x[-1])])
    rim_y = np.concatenate([np.full(len(x), y[0]), np.full(len(x), y[-1]), y, y])
    azimuth, elevation = pointing.sky(rim_x, rim_y)
    step = math.degrees(math.atan(geometry.step)) / rays_per_bar
    low, high = float(elevation.min()), float(elevation.max())
    left, right = float(azimuth.min()), float(azimuth.max())
    if _sees(geometry, pointing, 90.0):
        high = 90.0
    if _sees(geometry, pointing, -90.0):
        low = _LOWEST_DEG
    if _sees(geometry, pointing, 90.0) or _sees(geometry, pointing, -90.0) or right - left > 300:
        left, right = pointing.azimuth_deg - 180.0, pointing.azimuth_deg + 180.0
    low = max(low, _LOWEST_DEG)
    columns = max(2, math.ceil((right - left) / step) + 1)
    anchor = _ABOVE_HORIZON * step
    first = math.floor((low - anchor) / step)
    rows = max(2, math.ceil((high - anchor) / step) - first + 1)
    if rows * columns * _ARRAYS_PER_RAY * 8 > MEMORY_LIMIT:
        raise MuyscError(
            f"{rows:,} × {columns:,} rays would take more than the "
            f"{MEMORY_LIMIT / 2**30:.0f} GiB of memory allowed; use fewer rays a bar or a "
            "telescope with fewer bars."
        )
    rising = np.clip(anchor + step * (first + np.arange(rows)), _LOWEST_DEG, 90.0)
    return SkyGrid(np.linspace(left, right, columns), np.unique(rising))


def _sees(geometry: TelescopeGeometry, pointing: Pointing, elevation_deg: float) -> bool:
    x, y = pointing.plane(np.zeros(()), np.asarray(elevation_deg))
    step = geometry.step
    return bool(abs(x) <= geometry.bars_x * step and abs(y) <= geometry.bars_y * step)


@dataclass(frozen=True)
class SkyTable:
    """Quantities on a `SkyGrid`, ready to be looked up.

    Parameters
    ----------
    grid
        The directions.
    pointing
        Turns tangents into directions.
    sky
        (n_elevation, n_azimuth), true where there is no rock.
    logarithmic, linear
        (n, n_elevation, n_azimuth) quantities interpolated by their logarithm, except
        between rock and sky, and as they are; NaN where unknown.
    """

    grid: SkyGrid
    pointing: Pointing
    sky: np.ndarray
    logarithmic: np.ndarray
    linear: np.ndarray

    def __call__(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Return the quantities at tangents: the logarithmic ones, then the linear ones."""
        row, column, corners = self._locate(x, y)
        columns = self.sky.shape[1]
        flat = [row * columns + column, row * columns + column + 1]
        flat += [index + columns for index in flat]
        sky = self.sky.ravel()
        mixed = np.zeros(row.shape, dtype=bool)
        for index in flat[1:]:
            mixed |= sky[index] != sky[flat[0]]

        def mean(values: np.ndarray) -> np.ndarray:
            # What has no weight may be unknown.
            parts = (
                part * np.where(part > 0, values[index], 0.0)
                for part, index in zip(corners, flat)
            )
            return np.asarray(sum(parts))

        result = []
        for values in self.logarithmic.reshape(len(self.logarithmic), -1):
            smooth = np.exp(mean(np.log(np.maximum(values, _TINY))))
            result.append(np.where(mixed, mean(values), smooth))
        result += [mean(values) for values in self.linear.reshape(len(self.linear), -1)]
        return np.stack(result)

    def _locate(
        self, x: np.ndarray, y: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, list[np.ndarray]]:
        """Return row and column of the grid cells, and the weights of their corners."""
        azimuth, elevation = self.pointing.sky(x, y)
        columns, down = self.grid.azimuth_deg, self.grid.elevation_deg
        step = (columns[-1] - columns[0]) / (len(columns) - 1)
        place = np.clip((azimuth - columns[0]) / step, 0, len(columns) - 1)
        column = np.minimum(place.astype(int), len(columns) - 2)
        right = place - column
        row = np.clip(np.searchsorted(down, elevation, side="right") - 1, 0, len(down) - 2)
        high = np.clip((elevation - down[row]) / (down[row + 1] - down[row]), 0.0, 1.0)
        return row, column, [
            (1 - high) * (1 - right), (1 - high) * right, high * (1 - right), high * right,
        ]  # fmt: skip

    def rough_cells(self, geometry: TelescopeGeometry) -> np.ndarray:
        """Return the cells between trajectories in which something changes abruptly.

        Those that the border between rock and sky crosses, and those in which a
        logarithmic quantity changes by more than a third from one ray to the next.

        Returns
        -------
        numpy.ndarray
            (2 N_y, 2 N_x) of bool.
        """
        jump_x, jump_y = self.sky[:, 1:] != self.sky[:, :-1], self.sky[1:] != self.sky[:-1]
        for values in self.logarithmic:
            with np.errstate(invalid="ignore"):
                logarithm = np.log(np.maximum(values, _TINY))
                jump_x = jump_x | (np.abs(np.diff(logarithm, axis=1)) > _ABRUPT)
                jump_y = jump_y | (np.abs(np.diff(logarithm, axis=0)) > _ABRUPT)
        rough = np.zeros((2 * geometry.bars_y, 2 * geometry.bars_x), dtype=bool)
        azimuth, elevation = self.grid.azimuth_deg, self.grid.elevation_deg
        for jump, (down, right) in ((jump_x, (0, 1)), (jump_y, (1, 0))):
            row, column = np.nonzero(jump)
            # Both rays and the middle between them may lie in different cells.
            for share in (0.0, 0.5, 1.0):
                x, y = self.pointing.plane(
                    azimuth[column] * (1 - share) + azimuth[column + right] * share,
                    elevation[row] * (1 - share) + elevation[row + down] * share,
                )
                with np.errstate(invalid="ignore"):
                    i = np.floor(geometry.bars_y - y / geometry.step)
                    j = np.floor(geometry.bars_x + x / geometry.step)
                    inside = (i >= 0) & (i < rough.shape[0]) & (j >= 0) & (j < rough.shape[1])
                rough[i[inside].astype(int), j[inside].astype(int)] = True
        return rough
