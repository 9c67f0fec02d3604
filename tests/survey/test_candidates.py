"""Where candidates lie: grids, limits, roads, masks."""

import numpy as np
import pytest
from osgeo import gdal, osr
from pyproj import CRS

from muysc_qgis.errors import MuyscError
from muysc_qgis.survey.candidates import Limits, find_candidates
from muysc_qgis.survey.map_grid import grid_around, grid_over, survey_crs
from muysc_qgis.survey.masks import mask_of
from muysc_qgis.survey.roads import distance_to_lines
from muysc_qgis.topography.dem import open_dem

gdal.UseExceptions()
CENTRE = (500000.0, 4500000.0)


def write(path, values, epsg, geotransform):
    rows, columns = values.shape
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), columns, rows, 1, gdal.GDT_Float64)
    dataset.SetGeoTransform(geotransform)
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(epsg)
    dataset.SetSpatialRef(reference)
    dataset.GetRasterBand(1).WriteArray(values)
    dataset.GetRasterBand(1).SetNoDataValue(-1)
    dataset = None
    return str(path)


@pytest.fixture
def roof(tmp_path):
    """A DEM that rises 0.5 for each metre eastwards, west of the target; level east of it."""
    x = CENTRE[0] + (np.arange(401) - 200) * 10.0
    heights = np.minimum(x - CENTRE[0], 0.0) * 0.5 + 2000
    path = write(
        tmp_path / "roof.tif", np.broadcast_to(heights, (401, 401)).copy(), 32633,
        (CENTRE[0] - 2005, 10, 0, CENTRE[1] + 2005, 0, -10),
    )  # fmt: skip
    return open_dem(path)


def find(dem, limits, spacing=100.0, **keywords):
    grid = grid_around(dem, CENTRE, limits.farthest_m, spacing)
    return find_candidates(dem, CENTRE, grid, limits, **keywords)


def test_candidates_are_the_cell_centres_of_a_ring(roof):
    found = find(roof, Limits(300.0, 1000.0))
    # UTM shortens by 0.9996 on its central meridian.
    distance = np.hypot(found.x - CENTRE[0], found.y - CENTRE[1]) / 0.9996
    np.testing.assert_allclose(found.distance_m, distance, rtol=1e-6)
    assert len(found) == pytest.approx(np.pi * (1000**2 - 300**2) / 100**2, rel=0.03)
    assert found.removed["nearer than 300 m to the target"] == pytest.approx(28, abs=4)
    azimuth = np.degrees(np.arctan2(found.x - CENTRE[0], found.y - CENTRE[1])) % 360
    np.testing.assert_allclose(found.azimuth_deg, azimuth, atol=0.02)
    assert len(np.unique(found.cell)) == len(found)


def test_slopes_are_those_of_the_plane(roof):
    found = find(roof, Limits(300.0, 1000.0))
    west = found.x < CENTRE[0] - 20
    np.testing.assert_allclose(found.slope_deg[west], np.degrees(np.arctan(0.5)), rtol=1e-9)
    np.testing.assert_allclose(found.slope_deg[found.x > CENTRE[0] + 20], 0.0, atol=1e-9)
    flat = find(roof, Limits(300.0, 1000.0, slope_deg=20.0))
    assert np.all(flat.x > CENTRE[0] - 20)
    assert flat.removed["steeper than 20°"] == len(found) - len(flat)


def test_heights_above_and_below_the_target(roof):
    found = find(roof, Limits(0.0, 1000.0, below_m=100.0))
    assert np.all(found.x >= CENTRE[0] - 200)
    lower = find(roof, Limits(0.0, 1000.0, above_m=-100.0))
    assert np.all(lower.x <= CENTRE[0] - 200)


def test_roads_leave_what_is_near(roof):
    road = np.array([[CENTRE[0] - 900, CENTRE[1] + 500, CENTRE[0] + 900, CENTRE[1] + 500]])
    found = find(roof, Limits(0.0, 1000.0, road_m=150.0), roads=road)
    np.testing.assert_allclose(found.road_m, np.abs(found.y - CENTRE[1] - 500))
    assert found.road_m.max() <= 150.0


def test_a_mask_in_another_crs_leaves_what_it_allows(roof, tmp_path):
    # A degree raster: allowed in the north-east, no data in the north-west, 0 in the south.
    longitude, latitude = 15.0, 40.6508
    path = write(
        tmp_path / "mask.tif", np.array([[-1.0, 1.0], [0.0, 0.0]]), 4326,
        (longitude - 0.1, 0.1, 0, latitude + 0.1, 0, -0.1),
    )  # fmt: skip
    found = find(roof, Limits(0.0, 1000.0), mask=mask_of(path, "EPSG:4326"))
    assert np.all(found.x > CENTRE[0])
    assert np.all(found.y > CENTRE[1] - 120)
    assert found.removed["outside the mask"] > len(found)


def test_places_may_be_given(roof):
    x, y = np.array([0.0, 400.0, 5000.0]) + CENTRE[0], np.array([500.0, 0.0, 0.0]) + CENTRE[1]
    grid = grid_over(roof.crs, x, y, 50.0)
    found = find_candidates(roof, CENTRE, grid, Limits(0.0, 1e4), (x, y))
    np.testing.assert_array_equal(found.x, x[:2])
    assert found.removed["off the DEM or in a gap of it"] == 1
    column, row = found.cell % grid.columns, found.cell // grid.columns
    assert np.all(np.abs(grid.left + (column + 0.5) * 50 - x[:2]) <= 25)
    assert np.all(np.abs(grid.top - (row + 0.5) * 50 - y[:2]) <= 25)


def test_when_nothing_is_left_each_limit_says_how_many_it_removed(roof):
    with pytest.raises(MuyscError) as caught:
        find(roof, Limits(300.0, 1000.0, slope_deg=10.0, below_m=-1.0))
    said = str(caught.value)
    assert said.startswith("None of ")
    for words in ("nearer than 300 m", "steeper than 10°", "more than -1 m below", "loosen"):
        assert words in said
    assert said.count(".") == 1


def test_distances_to_lines_are_exact():
    """Against the distance to a dense polyline of the same segments."""
    rng = np.random.default_rng(7)
    x, y = rng.uniform(0, 1000, (2, 100))
    segments = rng.uniform(0, 1000, (30, 4))
    segments[3, 2:] = segments[3, :2]  # a point
    share = np.linspace(0, 1, 2001)[:, None]
    dense_x = segments[:, 0] + share * (segments[:, 2] - segments[:, 0])
    dense_y = segments[:, 1] + share * (segments[:, 3] - segments[:, 1])
    nearest = np.array(
        [np.hypot(dense_x - one_x, dense_y - one_y).min() for one_x, one_y in zip(x, y)]
    )
    found = distance_to_lines(x, y, segments, 60.0)
    within = nearest < 59.9
    np.testing.assert_allclose(found[within], nearest[within], atol=0.1)
    assert np.all(np.isinf(found[nearest > 60.1]))


@pytest.mark.parametrize(
    ("epsg", "place", "survey"),
    [
        (4326, (14.42, 40.82), 32633),
        (4326, (-75.39, 4.49), 32618),
        (4326, (170.2, -44.1), 32759),
        (3857, (1605500.0, 4985000.0), 32633),
        (32633, (452000.0, 4519000.0), 32633),
    ],
)
def test_maps_lie_in_a_projection_with_metres_on_the_ground(tmp_path, epsg, place, survey):
    step = 0.001 if epsg == 4326 else 100.0
    path = write(
        tmp_path / "dem.tif", np.full((11, 11), 500.0), epsg,
        (place[0] - 5.5 * step, step, 0, place[1] + 5.5 * step, 0, -step),
    )  # fmt: skip
    assert survey_crs(open_dem(path), place) == CRS.from_epsg(survey)
