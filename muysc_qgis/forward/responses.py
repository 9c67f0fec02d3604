"""Which directions a trajectory or a pixel sees, and how well it sees each of them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from ..errors import MuyscError
from ..telescope.directions import Pointing
from ..telescope.geometry import TelescopeGeometry
from ..telescope.sky import LOWEST_DEG, corner_tangents, reaches_horizon, sees_zenith


@dataclass(frozen=True)
class Window:
    """The part of the sky that is seen, in degrees, and the size of what resolves it."""

    left_deg: float
    right_deg: float
    low_deg: float
    high_deg: float
    #: Spacing of trajectories or pixels in azimuth and in elevation.
    step_deg: tuple[float, float]


class Responses(Protocol):
    """Elements, trajectories or pixels, and how they see the sky."""

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of the elements; numbered row by row."""

    @property
    def window(self) -> Window:
        """What all elements together see, above the horizon."""

    @property
    def below(self) -> np.ndarray:
        """(n_element,) true for elements that see too much below the horizon to be known."""

    def entries(
        self, azimuth_deg: np.ndarray, elevation_deg: np.ndarray, extent_deg: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return ray, element and response wherever a ray is seen, (n_entry,) each.

        The response is that to a flux by solid angle, in any unit that is the same for all rays.
        It is the mean over `extent_deg`, (n, 2) width and height around each ray; 0 for the ray
        itself.
        """


@dataclass(frozen=True)
class TelescopeResponses:
    """The trajectories of a telescope.

    The response falls linearly from the middle of a trajectory to zero at the middles of its
    neighbours, across and up, times the obliquity of the planes (see `pair_acceptance`).

    Parameters
    ----------
    geometry, pointing
        The telescope.

    Raises
    ------
    MuyscError
        If the telescope sees nothing above the horizon.
    """

    geometry: TelescopeGeometry
    pointing: Pointing

    def __post_init__(self) -> None:
        window = self.window
        if window.high_deg < window.step_deg[1]:
            raise MuyscError(
                f"The telescope sees nothing above {window.high_deg:.2g}° of elevation, where "
                "there are no muons to count; raise the boresight."
            )

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of the elements."""
        return 2 * self.geometry.bars_y - 1, 2 * self.geometry.bars_x - 1

    @property
    def window(self) -> Window:
        """What all elements together see, above the horizon."""
        geometry, pointing = self.geometry, self.pointing
        x, y = corner_tangents(geometry)
        rim_x = np.concatenate([x, x, np.full(len(y), x[0]), np.full(len(y), x[-1])])
        rim_y = np.concatenate([np.full(len(x), y[0]), np.full(len(x), y[-1]), y, y])
        azimuth, elevation = pointing.sky(rim_x, rim_y)
        step = math.degrees(math.atan(geometry.step))
        left, right = float(azimuth.min()), float(azimuth.max())
        low, high = float(elevation.min()), float(elevation.max())
        if sees_zenith(geometry, pointing):
            high = 90.0
            left, right = pointing.azimuth_deg - 180.0, pointing.azimuth_deg + 180.0
        return Window(left, right, max(low, LOWEST_DEG), high, (step, step))

    @property
    def below(self) -> np.ndarray:
        """(n_element,) which of them see too much below the horizon."""
        return reaches_horizon(self.geometry, self.pointing).ravel()

    def entries(
        self, azimuth_deg: np.ndarray, elevation_deg: np.ndarray, extent_deg: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return ray, element and response, as `Responses.entries` says."""
        geometry, step = self.geometry, self.geometry.step
        x, y = self.pointing.plane(azimuth_deg, elevation_deg)
        # Distance from the first trajectory, in trajectories.
        across, down = x / step + geometry.bars_x - 1, geometry.bars_y - 1 - y / step
        columns, rows = 2 * geometry.bars_x - 1, 2 * geometry.bars_y - 1
        with np.errstate(invalid="ignore"):
            inside = (across > -1.5) & (across < columns + 0.5)
            inside &= (down > -1.5) & (down < rows + 0.5)
        (ray,) = np.nonzero(inside)
        across, down = across[ray], down[ray]
        width, height = self._extent(azimuth_deg[ray], elevation_deg[ray], extent_deg[ray])
        obliquity = 1.0 / np.sqrt(1.0 + x[ray] ** 2 + y[ray] ** 2)
        column, row = np.rint(across).astype(np.int64), np.rint(down).astype(np.int64)
        shares = [
            [_hat(place - middle - one, size) for one in (-1, 0, 1)]
            for place, middle, size in ((down, row, height), (across, column, width))
        ]
        rays, elements, responses = [], [], []
        for up, share_y in zip((-1, 0, 1), shares[0]):
            (high,) = np.nonzero((share_y > 0) & (row + up >= 0) & (row + up < rows))
            base, part = (row[high] + up) * columns, share_y[high] * obliquity[high]
            for right, share_x in zip((-1, 0, 1), shares[1]):
                place = column[high] + right
                (seen,) = np.nonzero((share_x[high] > 0) & (place >= 0) & (place < columns))
                rays.append(ray[high[seen]])
                elements.append(base[seen] + place[seen])
                responses.append(part[seen] * share_x[high[seen]])
        return np.concatenate(rays), np.concatenate(elements), np.concatenate(responses)

    def _extent(
        self, azimuth_deg: np.ndarray, elevation_deg: np.ndarray, extent_deg: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return width and height of what rays stand for, in trajectories; 1 at most."""
        size = np.zeros((2, len(azimuth_deg)))
        (wide,) = np.nonzero(extent_deg.any(axis=1))
        for axis in (0, 1):
            half = np.zeros((2, len(wide)))
            half[axis] = extent_deg[wide, axis] / 2
            ends = [
                self.pointing.plane(
                    azimuth_deg[wide] + sign * half[0], elevation_deg[wide] + sign * half[1]
                )
                for sign in (-1, 1)
            ]
            for k in (0, 1):
                size[k, wide] += np.nan_to_num((ends[1][k] - ends[0][k]) / self.geometry.step) ** 2
        width, height = np.minimum(np.sqrt(size), 1.0)
        return width, height


@dataclass(frozen=True)
class PixelResponses:
    """The pixels of a muogram, each of which sees all directions within its edges alike.

    Parameters
    ----------
    azimuth_deg, elevation_deg
        (n_azimuth,) increasing and (n_elevation,) decreasing, evenly spaced centres.
    pixel_deg
        Width and height of a pixel.
    """

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    pixel_deg: tuple[float, float]

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of the elements."""
        return len(self.elevation_deg), len(self.azimuth_deg)

    @property
    def window(self) -> Window:
        """What all elements together see, above the horizon."""
        width, height = self.pixel_deg
        return Window(
            float(self.azimuth_deg[0]) - width / 2,
            float(self.azimuth_deg[-1]) + width / 2,
            max(float(self.elevation_deg[-1]) - height / 2, LOWEST_DEG),
            min(float(self.elevation_deg[0]) + height / 2, 90.0),
            self.pixel_deg,
        )

    @property
    def below(self) -> np.ndarray:
        """(n_element,) which of them see too much below the horizon."""
        return np.repeat(self.elevation_deg < LOWEST_DEG, len(self.azimuth_deg))

    def entries(
        self, azimuth_deg: np.ndarray, elevation_deg: np.ndarray, extent_deg: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return ray, element and response, as `Responses.entries` says."""
        rows, columns = self.shape
        column = np.rint((azimuth_deg - self.azimuth_deg[0]) / self.pixel_deg[0]).astype(np.int64)
        row = np.rint((self.elevation_deg[0] - elevation_deg) / self.pixel_deg[1]).astype(np.int64)
        (ray,) = np.nonzero((row >= 0) & (row < rows) & (column >= 0) & (column < columns))
        return ray, row[ray] * columns + column[ray], np.ones(len(ray))


def _hat(distance: np.ndarray, width: np.ndarray) -> np.ndarray:
    """Return the mean of max(0, 1 − |u|) over a width around a distance; sums to 1 over all u."""
    distance = np.abs(distance)
    wide = np.maximum(width, 1e-9)
    low, high = distance - wide / 2, distance + wide / 2

    def integral(u: np.ndarray) -> np.ndarray:
        u = np.clip(u, -1.0, 1.0)
        return np.asarray(u - u * np.abs(u) / 2)

    mean = (integral(high) - integral(low)) / wide
    return np.where(width > 1e-6, mean, np.maximum(0.0, 1.0 - distance))
