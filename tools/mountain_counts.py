"""What telescopes would count behind a mountain, by means that the product does not use.

Sub-rays drawn within even shares of every cell between trajectories (not the product's
quadrature), marched through the elevation model in small steps (not the product's exact tracing),
with the flux of `attenuate`, factors of stations and Poisson noise.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate
from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.directions import Pointing
from muysc_qgis.telescope.geometry import TelescopeGeometry

#: Length of a step, how far is marched, and how far positions are fitted, m.
STEP_M, REACH_M = 6.0, 4500.0

#: Depth (m) of the ground below a step within which it may rise above it in between.
_NEAR_M = 2.0

#: Rays marched at a time.
_BLOCK = 1 << 12

#: Densities (g/cm³) at points: longitude and latitude (°), height (m).
Density = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Site:
    """A telescope on a mountain."""

    name: str
    longitude: float
    latitude: float
    elevation_m: float
    geometry: TelescopeGeometry
    pointing: Pointing


class Terrain:
    """Heights of a raster in WGS 84, bilinear between cell centres; and how much they are off."""

    def __init__(self, path: str, off_m: np.ndarray | None = None) -> None:
        from osgeo import gdal

        file = gdal.Open(path)
        left, width, _, top, _, height = file.GetGeoTransform()
        self.corner, self.cell = (left + width / 2, top + height / 2), (width, height)
        self.height_m = file.ReadAsArray().astype(float)
        if off_m is not None:
            self.height_m = self.height_m + off_m

    def at(self, longitude: np.ndarray, latitude: np.ndarray) -> np.ndarray:
        """Return heights, m."""
        from scipy.ndimage import map_coordinates

        row = (latitude - self.corner[1]) / self.cell[1]
        column = (longitude - self.corner[0]) / self.cell[0]
        return map_coordinates(self.height_m, [row, column], order=1, mode="nearest")


def marched(
    site: Site, terrain: Terrain, azimuth: np.ndarray, elevation: np.ndarray, density: Density
) -> np.ndarray:
    """Return opacities along rays, (n,), g/cm²."""
    from pyproj import CRS, Geod, Transformer

    local = CRS.from_proj4(
        f"+proj=aeqd +lat_0={site.latitude} +lon_0={site.longitude} +ellps=WGS84"
    )
    back = Transformer.from_crs(local, "EPSG:4326", always_xy=True)
    side = np.linspace(-REACH_M, REACH_M, 41)
    east, north = (one.ravel() for one in np.meshgrid(side, side))
    powers = [(i, j) for i in range(5) for j in range(5 - i)]

    def terms(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return np.stack([(x / REACH_M) ** i * (y / REACH_M) ** j for i, j in powers], axis=-1)

    places = np.stack(back.transform(east, north), axis=1)
    fit = np.linalg.lstsq(terms(east, north), places, rcond=None)[0]
    geod = Geod(ellps="WGS84")
    latitude = np.radians(site.latitude)
    curve = 1 - geod.es * np.sin(latitude) ** 2
    radius = np.sqrt(geod.a**2 * (1 - geod.es) / curve**2)
    highest = float(terrain.height_m.max())
    slant = np.arange(0.0, REACH_M, STEP_M)
    result = np.empty(len(azimuth))
    order = np.argsort(elevation)
    for first in range(0, len(azimuth), _BLOCK):
        some = order[first : first + _BLOCK]
        rise = np.sin(np.radians(elevation[some]))
        level = np.cos(np.radians(elevation[some]))
        # Above all ground nothing more is met.
        least = max(float(rise.min()), 1e-3)
        steps = slant[: int(np.searchsorted(slant, (highest - site.elevation_m) / least)) + 2]
        flat = steps * level[:, None]
        x = flat * np.sin(np.radians(azimuth[some]))[:, None]
        y = flat * np.cos(np.radians(azimuth[some]))[:, None]
        up = site.elevation_m + steps * rise[:, None] + flat**2 / (2 * radius)
        lonlat = np.zeros((2, *x.shape))
        for (i, j), (one, other) in zip(powers, fit):
            power = (x / REACH_M) ** i * (y / REACH_M) ** j
            lonlat[0] += one * power
            lonlat[1] += other * power
        depth = terrain.at(*lonlat) - up
        low, high = depth[:, :-1], depth[:, 1:]
        with np.errstate(divide="ignore", invalid="ignore"):
            crossing = np.abs(np.maximum(low, high) / (low - high))
        share = np.where(
            (low > 0) & (high > 0), 1.0,
            np.where((low <= 0) & (high <= 0), 0.0, np.clip(crossing, 0, 1)),
        )  # fmt: skip
        # A ridge may rise between two points: looked at eight times as closely.
        close = np.nonzero((low <= 0) & (high <= 0) & (np.maximum(low, high) > -_NEAR_M))
        inner = np.linspace(0.0, 1.0, 9)
        ends = [(one[close][:, None], one[:, 1:][close][:, None]) for one in (*lonlat, up)]
        longitude, latitude, height = (one + inner * (other - one) for one, other in ends)
        share[close] = np.mean(terrain.at(longitude, latitude) > height, axis=1)
        # The telescope stands on the ground, not in it.
        share[:, steps[:-1] < 10.0] = 0.0
        ray, piece = np.nonzero(share)
        middle = [0.5 * (one[ray, piece] + one[ray, piece + 1]) for one in (*lonlat, up)]
        mass = share[ray, piece] * density(*middle) * (100.0 * STEP_M)
        result[some] = np.bincount(ray, mass, len(some))
    return result


def expected(
    site: Site,
    terrain: Terrain,
    density: Density,
    physics: Physics,
    days: float,
    efficiency: float = 1.0,
    rays: int = 16,
    seed: int = 0,
) -> np.ndarray:
    """Return μ of every trajectory, (2 N_y − 1, 2 N_x − 1); NaN where one reaches the horizon.

    Parameters
    ----------
    rays
        Sub-rays along a side of a cell between trajectories: four times as many squared in a
        trajectory. Each is drawn within its share of the cell.
    seed
        What these draws start from.
    """
    generator = np.random.default_rng(seed)
    geometry = site.geometry
    step = geometry.step / rays
    x = step * (np.arange(2 * geometry.bars_x * rays) + 0.5) - geometry.bars_x * geometry.step
    y = geometry.bars_y * geometry.step - step * (np.arange(2 * geometry.bars_y * rays) + 0.5)
    grid_x, grid_y = np.meshgrid(x, y)
    grid_x = grid_x + step * generator.uniform(-0.5, 0.5, grid_x.shape)
    grid_y = grid_y + step * generator.uniform(-0.5, 0.5, grid_x.shape)
    azimuth, elevation = site.pointing.sky(grid_x, grid_y)
    flux = np.full(grid_x.shape, np.nan)
    above = elevation > 0.05
    opacity = marched(site, terrain, azimuth[above], elevation[above], density)
    flux[above] = _flux(opacity, elevation[above], physics, site.elevation_m)
    obliquity = 1.0 / (1.0 + grid_x**2 + grid_y**2) ** 2
    above, below = np.zeros((2, 2 * geometry.bars_y - 1, 2 * geometry.bars_x - 1))
    for n in range(2 * geometry.bars_y - 1):
        for m in range(2 * geometry.bars_x - 1):
            part = np.s_[n * rays : (n + 2) * rays, m * rays : (m + 2) * rays]
            across = np.abs(grid_x[part] / geometry.step + geometry.bars_x - 1 - m)
            up = np.abs(grid_y[part] / geometry.step - geometry.bars_y + 1 + n)
            response = (1 - across) * (1 - up) * obliquity[part]
            above[n, m], below[n, m] = np.sum(response * flux[part]), np.sum(response)
    means = above, below
    collected = trajectories(geometry).acceptance_cm2_sr
    return efficiency * collected * days * means[0] / means[1]


def _flux(
    opacity: np.ndarray, elevation: np.ndarray, physics: Physics, altitude_m: float
) -> np.ndarray:
    """Return the flux of many rays, by elevations rounded to 0.02°."""
    rounded = np.maximum(np.round(elevation / 0.02), 1) * 0.02
    return attenuate(opacity, np.minimum(rounded, 90.0), physics, altitude_m).flux
