"""Poisson draws of what telescopes count come back as the density, within their errors."""

import numpy as np
import pytest

from muysc_qgis.forward.responses import TelescopeResponses
from muysc_qgis.measurement.density import Flag, measure_density
from muysc_qgis.measurement.mean import mean_density
from muysc_qgis.measurement.observation import from_counts
from muysc_qgis.measurement.scene import Scene
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.directions import Pointing
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.forward_model import first_rays, trace_sub_rays

PHYSICS = Physics(flux_model="gaisser-tang")
DENSITY, DAYS, DRAWS = 2.65, 100.0, 100
MUTE, SIXTEEN = TelescopeGeometry(30, 30, 4.0, 250.0), TelescopeGeometry(16, 16, 5.0, 115.0)


@pytest.fixture(scope="module")
def sights(data_folder, tmp_path_factory):
    """Return the lines of sight at three mountains by name."""
    gdal = pytest.importorskip("osgeo.gdal")
    pyproj = pytest.importorskip("pyproj")
    vesuvius = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    helens = open_dem(data_folder / "st_helens_usgs.tif")
    to_helens = pyproj.Transformer.from_crs(4326, helens.crs, always_xy=True).transform
    # A steep cone with nine ribs, 1400 m high, on cells of 15 m.
    cells = np.arange(401) - 200
    x, y = np.meshgrid(cells, cells)
    distance = np.hypot(x, y) * 15.0
    ribs = 20 * np.sin(9 * np.arctan2(x, y)) * np.exp(-(((distance - 900) / 600) ** 2))
    path = str(tmp_path_factory.mktemp("cone") / "cone.tif")
    raster = gdal.GetDriverByName("GTiff").Create(path, 401, 401, 1, gdal.GDT_Float32)
    raster.SetGeoTransform((600_000, 15, 0, 2_160_000, 0, -15))
    raster.SetProjection(pyproj.CRS.from_epsg(32613).to_wkt("WKT1_GDAL"))
    raster.GetRasterBand(1).WriteArray(np.maximum(0, 1400 - 0.65 * distance) + ribs + 1500)
    del raster
    middle = np.array([603_007.5, 2_156_992.5])
    return {
        "vesuvius": take_sight(vesuvius, (14.410686, 40.810561), (14.424745, 40.823729)),
        "helens": take_sight(helens, to_helens(-122.205, 46.215), to_helens(-122.1885, 46.2)),
        "cone": take_sight(open_dem(path), tuple(middle - (1700, 300)), tuple(middle)),
    }


@pytest.mark.parametrize(
    ("site", "geometry", "up"),
    [
        ("vesuvius", SIXTEEN, 8.0), ("helens", SIXTEEN, 8.0), ("cone", SIXTEEN, 8.0),
        ("vesuvius", MUTE, 6.0),
    ],
)  # fmt: skip
def test_the_density_that_made_the_counts_comes_back(sights, site, geometry, up):
    sight = sights[site]
    pointing = Pointing(sight.boresight_azimuth_deg, sight.boresight_elevation_deg + up)
    responses = TelescopeResponses(geometry, pointing)
    height = sight.detector_elevation_m

    def traced(rays_per_bar):
        return trace_sub_rays(sight.frame, height, responses, rays_per_bar)

    acceptance = trajectories(geometry).acceptance_cm2_sr
    # Three times as many rays a side, nowhere the same as those that the density is found with.
    finer = traced(9.3 if geometry is MUTE else 13.7)
    expected = finer.mean(finer.muons(DENSITY, PHYSICS, height).flux) * acceptance * DAYS
    rays = traced(first_rays(3.0, responses.window.step_deg[0]))
    _, elevation = pointing.sky(*np.meshgrid(
        geometry.step * geometry.offset_x, geometry.step * geometry.offset_y
    ))  # fmt: skip
    scene = Scene(rays.mean_thickness_m, elevation, PHYSICS, height, rays=rays)

    def found_from(counts, expected):
        seen = from_counts(counts, DAYS, acceptance, 0.95, expected)
        found = measure_density(seen, scene, 20.0)
        return found, mean_density(seen, scene, found)

    found, mean = found_from(expected, True)
    rock = (rays.rock_share >= 0.1) & (found.flags == Flag.MEASURED)
    off = np.abs(found.density[rock] - DENSITY)
    assert np.percentile(off, 95) < 0.03
    assert abs(mean.density - DENSITY) < 0.01
    generator = np.random.default_rng(7)
    pulls, means, errors = [], [], []
    for _ in range(DRAWS):
        counts = generator.poisson(np.nan_to_num(expected)).astype(float)
        found, mean = found_from(np.where(np.isnan(expected), np.nan, counts), False)
        here = np.flatnonzero((found.flags == Flag.MEASURED) & (rays.rock_share >= 0.1))
        here = here[np.unique(found.region.ravel()[here], return_index=True)[1]]
        density, lower, upper = (
            one.ravel()[here] for one in (found.density, found.lower, found.upper)
        )
        side = np.where(density > DENSITY, density - lower, upper - density)
        pulls.append(np.abs(density - DENSITY) / side)
        means.append(mean.density)
        errors.append(mean.error)
    pulls = np.concatenate(pulls)
    pulls = pulls[np.isfinite(pulls)]
    assert 0.65 < np.mean(pulls < 1) < 0.72
    assert np.mean(pulls > 5) < 1e-3
    assert abs(np.mean(means) - DENSITY) < 0.01 + 2 * np.std(means) / np.sqrt(DRAWS)
    assert np.std(means) == pytest.approx(np.mean(errors), rel=0.25)
