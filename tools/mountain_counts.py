"""What telescopes would count behind a mountain, by means that the product does not use.

Sub-rays drawn within even shares of every cell between trajectories (not the product's
quadrature), marched through the elevation model in small steps (not the product's exact tracing),
with the flux of `attenuate`, factors of stations and Poisson noise.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
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

#: Lowest elevation of a sub-ray, degrees.
_LOWEST_DEG = 0.05

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


def rock_pieces(
    site: Site, terrain: Terrain, azimuth: np.ndarray, elevation: np.ndarray
) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Yield pieces of rays in rock: which ray, (3, n) longitude, latitude, height, and length (m).

    All pieces of a ray come together.
    """
    from pyproj import CRS, Geod, Transformer

    local = CRS.from_proj4(
        f"+proj=aeqd +lat_0={site.latitude} +lon_0={site.longitude} +ellps=WGS84"
    )
    back = Transformer.from_crs(local, "EPSG:4326", always_xy=True)
    side = np.linspace(-REACH_M, REACH_M, 41)
    east, north = (one.ravel() for one in np.meshgrid(side, side))
    powers = [(i, j) for i in range(3) for j in range(3 - i)]

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
        middle = np.stack([0.5 * (one[ray, piece] + one[ray, piece + 1]) for one in (*lonlat, up)])
        yield some[ray], middle, STEP_M * share[ray, piece]


def marched(
    site: Site, terrain: Terrain, azimuth: np.ndarray, elevation: np.ndarray, density: Density
) -> np.ndarray:
    """Return opacities along rays, (n,), g/cm²."""
    result = np.zeros(len(azimuth))
    for ray, middle, length in rock_pieces(site, terrain, azimuth, elevation):
        result += np.bincount(ray, 100.0 * length * density(*middle), len(azimuth))
    return result


@dataclass(frozen=True)
class Drawn:
    """Sub-rays of a telescope, and which share each has in which trajectory."""

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    #: (4, n) number of the trajectory, −1 for none, and share of it before it is normalised.
    trajectory: np.ndarray
    share: np.ndarray
    #: (n_trajectories,) sum of the shares, NaN where a part is below the horizon.
    total: np.ndarray

    def means(self, values: np.ndarray) -> np.ndarray:
        """Return the mean of values of sub-rays over each trajectory."""
        kept = self.trajectory >= 0
        weighted = (self.share * values)[kept]
        return np.bincount(self.trajectory[kept], weighted, len(self.total)) / self.total


def draw(site: Site, terrain: Terrain, rays: int = 8, seed: int = 0) -> Drawn:
    """Draw sub-rays.

    Parameters
    ----------
    rays
        Sub-rays along a side of a cell between trajectories, each drawn within its share of it;
        six times as many where it holds both rock and sky.
    seed
        What these draws start from.
    """
    generator = np.random.default_rng(seed)
    geometry = site.geometry
    tall, wide = 2 * geometry.bars_y, 2 * geometry.bars_x
    row, column = (one.ravel() for one in np.indices((tall, wide)))
    cells = np.arange(tall * wide)
    total = np.zeros((tall - 1) * (wide - 1))
    found: list[list[np.ndarray]] = [[], [], [], []]
    for count in (rays, rays * _FINER):
        down, across = (np.indices((count, count)).reshape(2, 1, -1) + generator.uniform(
            size=(2, len(cells), count**2)
        )) / count  # fmt: skip
        x = (column[cells, None] - geometry.bars_x + across) * geometry.step
        y = (geometry.bars_y - row[cells, None] - down) * geometry.step
        azimuth, elevation = site.pointing.sky(x, y)
        if count == rays:
            hit = _meets(site, terrain, azimuth, elevation)
            mixed = np.zeros((tall, wide), bool)
            mixed[row, column] = hit.any(axis=1) & ~hit.all(axis=1)
            wider = mixed.copy()
            wider[1:] |= mixed[:-1]
            wider[:-1] |= mixed[1:]
            chosen = np.flatnonzero(~wider.ravel())
        else:
            chosen = np.arange(len(cells))
        obliquity = 1.0 / (1.0 + x**2 + y**2) ** 2 / count**2
        numbers, shares = [], []
        for lower in (0, 1):
            for right in (0, 1):
                i, j = row[cells] + lower - 1, column[cells] + right - 1
                inside = (i >= 0) & (i < tall - 1) & (j >= 0) & (j < wide - 1)
                number = np.where(inside, i * (wide - 1) + j, -1)
                numbers.append(np.broadcast_to(number[:, None], x.shape)[chosen].ravel())
                share = (down if lower else 1 - down) * (across if right else 1 - across)
                shares.append((share * obliquity)[chosen].ravel())
        for part, one in zip(
            found, (azimuth[chosen].ravel(), elevation[chosen].ravel(), numbers, shares)
        ):
            part.append(np.asarray(one))
        if count == rays:
            cells = np.flatnonzero(wider.ravel())
    azimuth, elevation, number, share = (np.concatenate(one, axis=-1) for one in found)
    kept = number >= 0
    total = np.bincount(number[kept], share[kept], len(total))
    low = np.broadcast_to(elevation < _LOWEST_DEG, number.shape) & kept
    total[np.unique(number[low])] = np.nan
    # What reaches below the horizon is not marched.
    known = np.any(kept & np.isfinite(total[number]), axis=0)
    return Drawn(azimuth[known], elevation[known], number[:, known], share[:, known], total)


def _meets(site: Site, terrain: Terrain, azimuth: np.ndarray, elevation: np.ndarray) -> np.ndarray:
    """Return which rays meet rock; below the horizon all do."""
    above = elevation > _LOWEST_DEG
    hit = np.ones(azimuth.shape, bool)
    hit[above] = marched(site, terrain, azimuth[above], elevation[above], _one) > 0
    return hit


def _one(longitude: np.ndarray, latitude: np.ndarray, height: np.ndarray) -> np.ndarray:
    return np.ones(len(height))


def expected(
    site: Site, terrain: Terrain, drawn: Drawn, density: Density, physics: Physics, days: float
) -> np.ndarray:
    """Return μ of every trajectory, (2 N_y − 1, 2 N_x − 1); NaN where one reaches the horizon."""
    opacity = marched(site, terrain, drawn.azimuth_deg, drawn.elevation_deg, density)
    return counted(site, drawn, opacity, physics, days)


def counted(
    site: Site, drawn: Drawn, opacity: np.ndarray, physics: Physics, days: float
) -> np.ndarray:
    """Return μ of every trajectory behind known opacities of its sub-rays, g/cm²."""
    flux = _flux(opacity, np.maximum(drawn.elevation_deg, _LOWEST_DEG), physics, site.elevation_m)
    collected = trajectories(site.geometry).acceptance_cm2_sr
    return collected * days * drawn.means(flux).reshape(collected.shape)


def _flux(
    opacity: np.ndarray, elevation: np.ndarray, physics: Physics, altitude_m: float
) -> np.ndarray:
    """Return the flux of many rays, by elevations rounded to 0.02°."""
    rounded = np.maximum(np.round(elevation / 0.02), 1) * 0.02
    return attenuate(opacity, np.minimum(rounded, 90.0), physics, altitude_m).flux
