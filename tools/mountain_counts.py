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

#: Times as many sub-rays along a side where the sky begins.
_FINER = 6

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
    rays: int = 8,
    seed: int = 0,
) -> np.ndarray:
    """Return μ of every trajectory, (2 N_y − 1, 2 N_x − 1); NaN where one reaches the horizon.

    Parameters
    ----------
    rays
        Sub-rays along a side of a cell between trajectories, each drawn within its share of it;
        six times as many where it holds both rock and sky.
    seed
        What these draws start from.
    """
    generator = np.random.default_rng(seed)
    geometry, step = site.geometry, site.geometry.step
    tall, wide = 2 * geometry.bars_y, 2 * geometry.bars_x
    row, column = (one.ravel() for one in np.indices((tall, wide)))
    cells = np.arange(tall * wide)
    sums = np.zeros((2, tall - 1, wide - 1))
    known = None
    for finer in (1, _FINER):
        count = rays * finer
        grid = (np.indices((count, count)).reshape(2, 1, -1) + generator.uniform(
            size=(2, len(cells), count**2)
        )) / count  # fmt: skip
        down, across = grid[0], grid[1]
        x = (column[cells, None] - geometry.bars_x + across) * step
        y = (geometry.bars_y - row[cells, None] - down) * step
        azimuth, elevation = site.pointing.sky(x, y)
        flux, rock = np.full(x.shape, np.nan), np.zeros(x.shape, bool)
        above = elevation > 0.05
        opacity = marched(site, terrain, azimuth[above], elevation[above], density)
        flux[above] = _flux(opacity, elevation[above], physics, site.elevation_m)
        rock[above] = opacity > 0
        if known is None:
            mixed = np.zeros((tall, wide), bool)
            mixed[row, column] = rock.any(axis=1) & ~rock.all(axis=1) & above.all(axis=1)
            wider = mixed.copy()
            wider[1:] |= mixed[:-1]
            wider[:-1] |= mixed[1:]
            known = ~wider.ravel()
            chosen = np.flatnonzero(known)
        else:
            chosen = np.arange(len(cells))
        obliquity = 1.0 / (1.0 + x**2 + y**2) ** 2 / count**2
        for lower in (0, 1):
            for right in (0, 1):
                response = (down if lower else 1 - down) * (across if right else 1 - across)
                response = response * obliquity
                i, j = row[cells[chosen]] + lower - 1, column[cells[chosen]] + right - 1
                inside = (i >= 0) & (i < tall - 1) & (j >= 0) & (j < wide - 1)
                for total, values in zip(sums, (response * flux, response)):
                    part = values.sum(axis=1)[chosen]
                    np.add.at(total, (i[inside], j[inside]), part[inside])
        cells = np.flatnonzero(~known)
    return trajectories(geometry).acceptance_cm2_sr * days * sums[0] / sums[1]


def _flux(
    opacity: np.ndarray, elevation: np.ndarray, physics: Physics, altitude_m: float
) -> np.ndarray:
    """Return the flux of many rays, by elevations rounded to 0.02°."""
    rounded = np.maximum(np.round(elevation / 0.02), 1) * 0.02
    return attenuate(opacity, np.minimum(rounded, 90.0), physics, altitude_m).flux
