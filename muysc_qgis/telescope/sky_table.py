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

#: Lowest elevation of a ray in degrees. No flux model has an answer at or below the
#: horizon, and so little above it the flux is still known.
LOWEST_DEG = 1e-6

#: Memory that the rays take, and all quantities on them.
_BYTES_PER_RAY = 800

#: Change of a logarithm across one step of the grid that counts as abrupt.
_ABRUPT = 0.35

#: Rays between two rows of the grid, where something changes abruptly.
FINE_ROWS = 8

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
        (n_elevation,) increasing, evenly spaced, from just above the horizon where that is
        in view.
    """

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray

    @property
    def fine_elevation_deg(self) -> np.ndarray:
        """The elevations with `FINE_ROWS` − 1 more between any two."""
        count = FINE_ROWS * (len(self.elevation_deg) - 1) + 1
        return np.linspace(self.elevation_deg[0], self.elevation_deg[-1], count)

    @property
    def steps_deg(self) -> tuple[float, float]:
        """Spacing in azimuth and in elevation."""
        azimuth, elevation = self.azimuth_deg, self.elevation_deg
        return (
            float(azimuth[-1] - azimuth[0]) / (len(azimuth) - 1),
            float(elevation[-1] - elevation[0]) / (len(elevation) - 1),
        )

    def fine_part(self, steps: np.ndarray, fine: np.ndarray) -> np.ndarray:
        """Return what a fine array holds along steps from one row to the next.

        Parameters
        ----------
        steps
            (n, 2) row and column of the lower ends.
        fine
            (n_fine_elevation, n_azimuth).

        Returns
        -------
        numpy.ndarray
            (n, `FINE_ROWS` + 1) with both ends.
        """
        rows = FINE_ROWS * steps[:, :1] + np.arange(FINE_ROWS + 1)
        return np.asarray(fine[rows, steps[:, 1:]])


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
    check_rays(rays_per_bar)
    x, y = corner_tangents(geometry)
    rim_x = np.concatenate([x, x, np.full(len(y), x[0]), np.full(len(y), x[-1])])
    rim_y = np.concatenate([np.full(len(x), y[0]), np.full(len(x), y[-1]), y, y])
    azimuth, elevation = pointing.sky(rim_x, rim_y)
    step = math.degrees(math.atan(geometry.step)) / rays_per_bar
    low, high = float(elevation.min()), float(elevation.max())
    left, right = float(azimuth.min()), float(azimuth.max())
    if _sees_zenith(geometry, pointing):
        high = 90.0
        left, right = pointing.azimuth_deg - 180.0, pointing.azimuth_deg + 180.0
    if high < step:
        raise MuyscError(
            f"The telescope sees nothing above {high:.2g}° of elevation, where there are no muons "
            "to count; raise the boresight."
        )
    low = max(low, LOWEST_DEG)
    columns = max(2, math.ceil((right - left) / step) + 1)
    rows = max(2, math.ceil((high - low) / step) + 1)
    if rows * columns * _BYTES_PER_RAY > MEMORY_LIMIT:
        raise MuyscError(
            f"{rows:,} × {columns:,} rays would take more than the "
            f"{MEMORY_LIMIT / 2**30:.0f} GiB of memory allowed; use fewer rays a bar or a "
            "telescope with fewer bars."
        )
    return SkyGrid(np.linspace(left, right, columns), np.linspace(low, high, rows))


def reaches_horizon(geometry: TelescopeGeometry, pointing: Pointing) -> np.ndarray:
    """Return which trajectories look, in part, at or below the horizon.

    Returns
    -------
    numpy.ndarray
        (2 N_y − 1, 2 N_x − 1) of bool.
    """
    _, height = pointing.sky(*np.meshgrid(*corner_tangents(geometry)))
    below = height < LOWEST_DEG
    # A response reaches as far as the middles of the neighbours.
    across = below[:, :-2] | below[:, 1:-1] | below[:, 2:]
    return np.asarray(across[:-2] | across[1:-1] | across[2:])


def check_rays(rays_per_bar: float) -> None:
    """Refuse a number of rays that is too small to see anything or too large to trace.

    Raises
    ------
    MuyscError
        If it is no number from 1 to 50.
    """
    if not 1 <= rays_per_bar <= 50:
        raise MuyscError(f"{rays_per_bar:g} rays a bar are impossible; give a number from 1 to 50.")


def _sees_zenith(geometry: TelescopeGeometry, pointing: Pointing) -> bool:
    x, y = pointing.plane(np.zeros(()), np.asarray(90.0))
    step = geometry.step
    return bool(abs(x) <= geometry.bars_x * step and abs(y) <= geometry.bars_y * step)


@dataclass(frozen=True)
class Layers:
    """Values of the same quantities somewhere.

    Parameters
    ----------
    sky
        (…) true where there is no rock.
    logarithmic, linear
        (n, …) quantities interpolated by their logarithm, except between rock and sky,
        and as they are; NaN where unknown.
    """

    sky: np.ndarray
    logarithmic: np.ndarray
    linear: np.ndarray


def abrupt_steps(grid: SkyGrid, sky: np.ndarray, logarithmic: np.ndarray) -> np.ndarray:
    """Return the steps from row to row in which something changes abruptly.

    Parameters
    ----------
    grid
        The directions.
    sky
        (n_fine_elevation, n_azimuth), true where there is no rock.
    logarithmic
        (n, n_elevation, n_azimuth) quantities.

    Returns
    -------
    numpy.ndarray
        (n, 2) row and column of their lower ends.
    """
    rows = len(grid.elevation_deg) - 1
    inner = sky[:-1].reshape(rows, FINE_ROWS, -1)
    abrupt = np.any(inner != sky[FINE_ROWS::FINE_ROWS, None], axis=1)
    return np.argwhere(abrupt | _jumps(logarithmic, axis=0))


def _jumps(logarithmic: np.ndarray, axis: int) -> np.ndarray:
    """Return where any of some quantities changes by more than a third in a step."""
    logarithm = np.log(np.maximum(logarithmic, _TINY))
    return np.any(np.abs(np.diff(logarithm, axis=axis + 1)) > _ABRUPT, axis=0)


@dataclass(frozen=True)
class SkyTable:
    """Quantities on a `SkyGrid`, ready to be looked up.

    Parameters
    ----------
    grid
        The directions.
    pointing
        Turns tangents into directions.
    coarse
        Layers of (n_elevation, n_azimuth).
    steps
        (k, 2) row and column of the lower ends of those steps from row to row that are
        known in more detail …
    fine
        … and layers of (k, `FINE_ROWS` + 1) along them.
    """

    grid: SkyGrid
    pointing: Pointing
    coarse: Layers
    steps: np.ndarray
    fine: Layers

    def __call__(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Return the quantities at tangents: the logarithmic ones, then the linear ones.

        NaN at and below the horizon.
        """
        azimuth, elevation = self.pointing.sky(x, y)
        columns, rows = self.grid.azimuth_deg, self.grid.elevation_deg
        step_x, step_y = self.grid.steps_deg
        place = np.clip((azimuth - columns[0]) / step_x, 0, len(columns) - 1)
        column = np.minimum(place.astype(int), len(columns) - 2)
        right = place - column
        place = np.clip((elevation - rows[0]) / step_y, 0, len(rows) - 1)
        row = np.minimum(place.astype(int), len(rows) - 2)
        height = place - row
        index = np.full((len(rows) - 1, len(columns)), -1)
        index[tuple(self.steps.T)] = np.arange(len(self.steps))
        sides = [self._column(index, row, column + side, height) for side in (0, 1)]
        (left_sky, left), (right_sky, other) = sides
        alike = (left_sky == right_sky) & (left_sky >= 0)
        result = []
        for k, (one, two) in enumerate(zip(left, other)):
            # What has no weight may be unknown.
            one = np.where(right < 1, one, 0.0)
            two = np.where(right > 0, two, 0.0)
            mean = one + right * (two - one)
            if k < len(self.coarse.logarithmic):
                both = alike & (one > 0) & (two > 0)
                ratio = np.where(both, two, 1.0) / np.where(both, one, 1.0)
                mean = np.where(both, one * ratio**right, mean)
            result.append(mean)
        return np.where(elevation < LOWEST_DEG, np.nan, np.stack(result))

    def _column(
        self, index: np.ndarray, row: np.ndarray, column: np.ndarray, height: np.ndarray
    ) -> tuple[np.ndarray, list[np.ndarray]]:
        """Interpolate along the columns of the grid.

        Returns
        -------
        tuple
            0 where there is rock, 1 where there is none, −1 between the two; and the
            quantities.
        """
        fine = index[row, column]
        detailed = np.flatnonzero(fine >= 0)
        place = height.ravel()[detailed] * FINE_ROWS
        node = np.minimum(place.astype(int), FINE_ROWS - 1)
        shape = height.shape
        share = height.ravel().copy()
        share[detailed] = place - node

        def ends(coarse: np.ndarray, detail: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            low, high = coarse[row, column].ravel(), coarse[row + 1, column].ravel()
            low[detailed] = detail[fine.ravel()[detailed], node]
            high[detailed] = detail[fine.ravel()[detailed], node + 1]
            return low, high

        low_sky, high_sky = ends(self.coarse.sky, self.fine.sky)
        mixed = low_sky != high_sky
        result = []
        for coarse, detail in zip(self.coarse.logarithmic, self.fine.logarithmic):
            low, high = ends(coarse, detail)
            smooth = ~mixed & (low > 0) & (high > 0)
            ratio = np.where(smooth, high, 1.0) / np.where(smooth, low, 1.0)
            result.append(np.where(smooth, low * ratio**share, _between(low, high, share)))
        for coarse, detail in zip(self.coarse.linear, self.fine.linear):
            result.append(_between(*ends(coarse, detail), share))
        state = np.where(mixed, -1, low_sky.astype(int))
        return state.reshape(shape), [values.reshape(shape) for values in result]

    def rough_cells(self, geometry: TelescopeGeometry) -> np.ndarray:
        """Return the cells between trajectories in which something changes abruptly.

        Those that the border between rock and sky crosses, and those in which a
        logarithmic quantity changes by more than a third from one ray to the next.

        Returns
        -------
        numpy.ndarray
            (2 N_y, 2 N_x) of bool.
        """
        sky = self.coarse.sky
        beside = (sky[:, 1:] != sky[:, :-1]) | _jumps(self.coarse.logarithmic, axis=1)
        rough = np.zeros((2 * geometry.bars_y, 2 * geometry.bars_x), dtype=bool)
        azimuth, elevation = self.grid.azimuth_deg, self.grid.elevation_deg
        for (row, column), (down, right) in (
            (np.nonzero(beside), (0, 1)),
            (self.steps.T, (1, 0)),
        ):
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


def _between(low: np.ndarray, high: np.ndarray, share: np.ndarray) -> np.ndarray:
    """Interpolate linearly; what has no weight may be unknown."""
    low, high = np.where(share < 1, low, 0.0), np.where(share > 0, high, 0.0)
    return np.asarray(low + share * (high - low))
