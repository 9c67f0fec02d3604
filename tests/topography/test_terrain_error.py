"""Errors of thickness: a closed form, and terrain thinned on purpose."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.topography.terrain_error import TerrainErrors, thickness_error
from muysc_qgis.topography.tracing import trace_terrain

gdal = pytest.importorskip("osgeo.gdal")
gdal.UseExceptions()
pyproj = pytest.importorskip("pyproj")


def write(path, heights, left, top, step, wkt):
    rows, columns = heights.shape
    raster = gdal.GetDriverByName("GTiff").Create(str(path), columns, rows, 1, gdal.GDT_Float64)
    raster.SetGeoTransform((left, step, 0, top, 0, -step))
    raster.SetProjection(wkt)
    raster.GetRasterBand(1).WriteArray(np.ascontiguousarray(heights))
    del raster
    return open_dem(path)


@pytest.fixture(scope="module")
def ridge(tmp_path_factory):
    """Return a line of sight across an endless ridge of slope ½ that is 200 m high."""
    wkt = pyproj.CRS.from_epsg(32633).to_wkt("WKT1_GDAL")
    x = 10.0 * (np.arange(301) - 150)
    heights = np.broadcast_to(np.maximum(0.0, 200.0 - np.abs(x) / 2), (301, 301))
    dem = write(tmp_path_factory.mktemp("r") / "r.tif", heights, 499_000, 4_501_000, 10.0, wkt)
    middle = 499_000 + 1505.0
    return take_sight(dem, (middle - 1000, 4_499_500), (middle, 4_499_500), 0.0, -100.0)


def test_a_ridge_has_the_error_that_its_slopes_say(ridge):
    elevation = np.array([2.0, 4.0])
    azimuth = np.array([ridge.boresight_azimuth_deg])
    found = thickness_error(
        ridge.frame, ridge.detector_elevation_m, azimuth, elevation, TerrainErrors(3.0)
    )
    tangent, cosine = np.tan(np.radians(elevation)), np.cos(np.radians(elevation))
    # The ray rises by its tangent and the ground by ½ at the entry, −½ at the exit.
    entry, leave = 3.0 / (0.5 - tangent) / cosine, 3.0 / (0.5 + tangent) / cosine
    np.testing.assert_allclose(found[0], np.hypot(entry, leave), rtol=0.02)
    # Seven degrees of width at 700 m are 90 m.
    wide = thickness_error(
        ridge.frame, ridge.detector_elevation_m, azimuth, elevation,
        TerrainErrors(3.0), width_deg=7.0,
    )  # fmt: skip
    assert np.all(wide < 0.6 * found)
    assert np.all(wide > 0.2 * found)


def test_the_pointing_adds_what_tilting_changes(ridge):
    azimuth, elevation = np.array([ridge.boresight_azimuth_deg]), np.array([3.0])
    place = ridge.frame, ridge.detector_elevation_m, azimuth
    found = thickness_error(*place, elevation, TerrainErrors(0.0, 0.2))
    ends = trace_terrain(*place, np.array([2.8, 3.2])).thickness_m[0]
    assert found[0, 0] == pytest.approx(abs(ends[0] - ends[1]) / 2)
    both = thickness_error(*place, elevation, TerrainErrors(3.0, 0.2))
    alone = thickness_error(*place, elevation, TerrainErrors(3.0))
    assert both[0, 0] == pytest.approx(np.hypot(found, alone)[0, 0])


@pytest.mark.parametrize("times", [2, 4, 6])
def test_terrain_thinned_from_5_m_is_wrong_by_as_much_as_is_told(data_folder, tmp_path, times):
    path = data_folder / "maungawhau_linz5m.tif"
    source = gdal.Open(str(path))
    heights = source.ReadAsArray().astype(float)
    left, step, _, top, _, _ = source.GetGeoTransform()
    rows, columns = (size // times for size in heights.shape)
    heights = heights[: rows * times, : columns * times]
    coarse = heights.reshape(rows, times, columns, times).mean(axis=(1, 3))
    thin = write(tmp_path / "thin.tif", coarse, left, top, times * step, source.GetProjection())
    # How far the fine heights are off the bilinear surface of the coarse ones.
    row, column = np.indices(heights.shape)
    image = pytest.importorskip("scipy.ndimage")
    places = [(row + 0.5) / times - 0.5, (column + 0.5) / times - 0.5]
    off = heights - image.map_coordinates(coarse, places, order=1, mode="nearest")
    highest = np.unravel_index(np.argmax(heights), heights.shape)
    target = left + step * (highest[1] + 0.5), top - step * (highest[0] + 0.5)
    detector = left + step * 0.25 * heights.shape[1], top - step * 0.3 * heights.shape[0]
    fine = take_sight(open_dem(path), detector, target, 3.0)
    blurred = take_sight(thin, detector, target)
    azimuth = fine.boresight_azimuth_deg + np.linspace(-20, 20, 81)
    elevation = np.linspace(0.5, fine.boresight_elevation_deg + 1, 60)
    reach = None, 0.15 * fine.target_distance_m
    eye = fine.detector_elevation_m
    truth = trace_terrain(fine.frame, eye, azimuth, elevation, *reach).thickness_m
    found = trace_terrain(blurred.frame, eye, azimuth, elevation, *reach).thickness_m
    # Of heights whose errors have long tails the median says the standard error.
    errors = TerrainErrors(1.4826 * float(np.median(np.abs(off))), correlation_m=0.0)
    told = thickness_error(blurred.frame, eye, azimuth, elevation, errors, *reach)
    rock = np.isfinite(truth) & (found > 0) & (told > 0)
    within = np.mean(np.abs(truth - found)[rock] < told[rock])
    assert rock.sum() > 4000
    assert 0.60 < within < 0.77


@pytest.mark.parametrize(
    ("errors", "words"),
    [
        ({"terrain_m": -1.0}, "terrain error of -1 m"),
        ({"pointing_deg": 40.0}, "pointing error of 40 °"),
        ({"correlation_m": np.nan}, "correlation length of the terrain error of nan m"),
    ],
)
def test_errors_that_cannot_be_are_refused(errors, words):
    with pytest.raises(MuyscError, match=words):
        TerrainErrors(**errors)
