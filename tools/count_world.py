"""Vesuvius, telescopes around it, and what they count; for `count_experiments`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from muysc_qgis.measurement.density import Scene, measure_density
from muysc_qgis.measurement.observation import from_counts
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.survey.ring import Ring, ring_places
from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.directions import Pointing
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.tomography.lattice import Lattice
from muysc_qgis.tomography.solvers import Options
from muysc_qgis.topography.dem import Dem, open_dem
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.count_lines import CountStation
from muysc_qgis.workflows.station_data import StationData, rock_seen
from muysc_qgis.workflows.tomography import TomographyChoices, tomography
from muysc_qgis.workflows.volume_frame import utm_zone
from muysc_qgis.workflows.volume_plan import VolumePlan
from tools.mountain_counts import Drawn, Site, Terrain, draw, expected

ROOT = Path(__file__).resolve().parents[1]
DEM = ROOT / "tests" / "data" / "vesuvius_srtmgl1.tif"

#: The highest ground, and a ring of stations around it; degrees and m.
SUMMIT, RADIUS_M, BORESIGHT_DEG = (14.429444, 40.822222), 1000.0, 12.0
ROCK, DAYS = 2.65, 100.0
#: Half of the volume's sides, its base and top, and its voxels, m.
HALF_M, BASE_M, TOP_M, VOXEL_M = 900.0, 800.0, 1300.0, 50.0
#: A body under the summit, m below the ground.
SPHERE_RADIUS_M, SPHERE_DEPTH_M, CONTRAST = 150.0, 190.0, -0.5
#: How far the terrain is off, and over which distance that is alike, m.
TERRAIN_M, TERRAIN_LENGTH_M = 5.0, 100.0


@dataclass(frozen=True)
class World:
    """A mountain, stations around it, and what they would count in a day."""

    dem: Dem
    sites: list[Site]
    drawn: list[Drawn]
    plan: VolumePlan
    physics: Physics

    def stations(self, counts: Sequence[np.ndarray]) -> list[CountStation]:
        """Return what the product is told."""
        result = []
        for site, values in zip(self.sites, counts):
            own = trajectories(site.geometry)
            result.append(
                CountStation(
                    site.name, site.longitude, site.latitude, site.elevation_m, values,
                    own.acceptance_cm2_sr * DAYS, self.physics, own, site.pointing,
                )
            )  # fmt: skip
        return result

    def expected(self, terrain: Terrain, contrast: float = 0.0) -> list[np.ndarray]:
        """Return μ of each station, of a uniform mountain or one with a sphere."""
        x, y, z = sphere_middle(terrain)
        from pyproj import Transformer

        to_map = Transformer.from_crs("EPSG:4326", utm_zone(*SUMMIT), always_xy=True)

        def density(longitude: np.ndarray, latitude: np.ndarray, up: np.ndarray) -> np.ndarray:
            if not contrast:
                return np.full(len(up), ROCK)
            east, north = to_map.transform(longitude, latitude)
            square = (east - x) ** 2 + (north - y) ** 2 + (up - z) ** 2
            return ROCK + contrast * (square < SPHERE_RADIUS_M**2)

        return [
            expected(site, terrain, drawn, density, self.physics, DAYS)
            for site, drawn in zip(self.sites, self.drawn)
        ]


def sphere_middle(terrain: Terrain) -> tuple[float, float, float]:
    """Return x and y in the UTM zone and the height of the middle of the body."""
    x, y = from_wgs84(utm_zone(*SUMMIT), *SUMMIT)
    ground = terrain.at(np.array([SUMMIT[0]]), np.array([SUMMIT[1]]))[0]
    return x, y, float(ground) - SPHERE_DEPTH_M


def build(geometry: TelescopeGeometry, stations: int, rays: int) -> World:
    """Return stations around the summit."""
    dem, terrain = open_dem(DEM), Terrain(str(DEM))
    places = ring_places(dem, SUMMIT, Ring(RADIUS_M, stations, sees_target=False))
    sites, drawn = [], []
    for number, place in enumerate(zip(places.x, places.y)):
        sight = take_sight(dem, place, SUMMIT, 2.0, 0.0)
        pointing = Pointing(sight.boresight_azimuth_deg, BORESIGHT_DEG)
        site = Site(
            f"site {number + 1}", *sight.detector_wgs84, sight.detector_elevation_m, geometry,
            pointing,
        )  # fmt: skip
        sites.append(site)
        drawn.append(draw(site, terrain, rays, number))
    crs = utm_zone(*SUMMIT)
    x, y = from_wgs84(crs, *SUMMIT)
    extent = (x - HALF_M, x + HALF_M, y - HALF_M, y + HALF_M)
    return World(
        dem, sites, drawn, VolumePlan(extent, VOXEL_M, None, BASE_M, TOP_M),
        Physics(density_g_cm3=ROCK),
    )  # fmt: skip


def poisson(means: Sequence[np.ndarray], seed: int) -> list[np.ndarray]:
    """Return counts, NaN where nothing is known."""
    generator = np.random.default_rng(seed)
    return [
        np.where(np.isfinite(one), generator.poisson(np.nan_to_num(one)), np.nan) for one in means
    ]


def terrain_off(world: World, terrain: Terrain, seed: int) -> np.ndarray:
    """Return a draw of errors of the terrain's heights, m; none where the telescopes stand."""
    latitude = np.radians(SUMMIT[1])
    step = (111_200 * abs(terrain.cell[1]), 111_300 * np.cos(latitude) * terrain.cell[0])
    lattice = Lattice(step, np.ones(terrain.height_m.shape, bool))
    covariance = lattice.covariance(TERRAIN_M, TERRAIN_LENGTH_M)
    noise = np.random.default_rng(100 + seed).standard_normal(covariance.root_size)
    off = lattice.expand(covariance.root(noise))
    row, column = np.indices(off.shape)
    for site in world.sites:
        north = (row - (site.latitude - terrain.corner[1]) / terrain.cell[1]) * step[0]
        east = (column - (site.longitude - terrain.corner[0]) / terrain.cell[0]) * step[1]
        off *= 1 - np.exp(-(north**2 + east**2) / (2 * TERRAIN_LENGTH_M**2))
    return off


def one_ray_a_pixel(world: World, counts: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Return densities, errors by way of each pixel's density along its middle, and the truth."""
    data = []
    for site, values in zip(world.sites, counts):
        geometry = site.geometry
        x, y = geometry.step * geometry.offset_x, geometry.step * geometry.offset_y
        azimuth, elevation = (one.ravel() for one in site.pointing.sky(*np.meshgrid(x, y)))
        bare = StationData(
            site.name, site.longitude, site.latitude, site.elevation_m, azimuth,
            np.maximum(elevation, 0.05),
        )  # fmt: skip
        thickness = rock_seen(bare, world.dem).thickness_m
        acceptance = trajectories(geometry).acceptance_cm2_sr
        found = measure_density(
            from_counts(values, DAYS, acceptance, 0.95),
            Scene(thickness.reshape(values.shape), bare.elevation_deg.reshape(values.shape),
                  world.physics, site.elevation_m),
            0.0,
        )  # fmt: skip
        known = np.isfinite(found.error) & (thickness.reshape(values.shape) > 0)
        scale = 100.0 * thickness.reshape(values.shape)
        opacity = np.where(known, found.density * scale, np.nan).ravel()
        data.append(
            bare.with_opacity(opacity, np.where(known, found.error * scale, np.nan).ravel())
        )
    choices = TomographyChoices(
        "bayes", Options(prior_deviation=0.2, correlation_length_m=200.0, deviation=True), ROCK,
        length_error_m=2.0,
    )  # fmt: skip
    result = tomography(data, world.dem, world.plan, choices, utm_zone(*SUMMIT))
    known = result.density.known
    errors = np.nan if result.deviation is None else result.deviation.values[known]
    return result.density.values[known], np.asarray(errors)
