"""What a raster's numbers mean: units, scale, no-data, masks, windows."""

import numpy as np
import pytest
from osgeo import gdal
from pyproj import CRS

from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import ground_height
from muysc_qgis.topography.heights import metres_per_unit

UTM = "EPSG:32633"
NORTH_UP = (450_000.0, 30.0, 0.0, 4_520_000.0, 0.0, -30.0)


def plane(columns=12, rows=9):
    """Return heights that tell their column and row: 100 + 10 column + row."""
    return 100.0 + 10.0 * np.arange(columns) + np.arange(rows)[:, None]


@pytest.fixture
def small(write_dem):
    def make(heights=None, crs=UTM, **keywords):
        return write_dem(plane() if heights is None else heights, crs, NORTH_UP, **keywords)

    return make


def test_terrain_is_bilinear_through_the_cell_centres(small):
    dem = open_dem(small())
    # Centre of the first cell, then 2.5 columns and 3.25 rows further.
    assert ground_height(dem, 450_015.0, 4_519_985.0, "point") == pytest.approx(100.0)
    height = ground_height(dem, 450_015.0 + 75.0, 4_519_985.0 - 97.5, "point")
    assert height == pytest.approx(100 + 25 + 3.25)


def test_bilinear_cell_has_its_twist(small):
    heights = np.zeros((2, 2))
    heights[1, 1] = 100.0
    dem = open_dem(small(heights))
    assert ground_height(dem, 450_015.0 + 7.5, 4_519_985.0 - 15.0, "point") == pytest.approx(12.5)


def test_grid_and_map_coordinates_are_inverse(small):
    dem = open_dem(small())
    column, row = np.array([0.0, 3.7, 11.0]), np.array([8.0, 0.2, 5.5])
    back = dem.grid_position(*dem.crs_position(column, row))
    np.testing.assert_allclose(back, [column, row], atol=1e-9)


@pytest.mark.parametrize(
    ("data_type", "scale", "offset"),
    [(gdal.GDT_Int16, 0.1, 250.0), (gdal.GDT_Float32, 2.0, None), (gdal.GDT_UInt16, None, -120.0)],
)
def test_scale_and_offset(small, data_type, scale, offset):
    dem = open_dem(small(data_type=data_type, scale=scale, offset=offset))
    exact = plane() * (1.0 if scale is None else scale) + (0.0 if offset is None else offset)
    np.testing.assert_allclose(dem.read(0, 0, 12, 9), exact)


@pytest.mark.parametrize(
    ("tag", "metres"),
    [
        ("", 1.0), ("m", 1.0), ("metre", 1.0), ("Meters", 1.0), ("ft", 0.3048), ("feet", 0.3048),
        ("foot", 0.3048), ("US survey foot", 1200 / 3937), ("us-ft", 1200 / 3937),
        ("ftUS", 1200 / 3937),
    ],
)  # fmt: skip
def test_unit_of_the_band(small, tag, metres):
    dem = open_dem(small(unit=tag))
    np.testing.assert_allclose(dem.read(0, 0, 12, 9), plane() * metres)
    assert dem.assumptions == ()


@pytest.mark.parametrize(
    ("crs", "metres"),
    [
        ("EPSG:32633+5773", 1.0),  # EGM96 height
        ("EPSG:2229+8228", 0.3048),  # NAVD88 height (ft)
        ("EPSG:2229+6360", 1200 / 3937),  # NAVD88 height (ftUS)
        ("EPSG:4979", 1.0),
    ],
)
def test_unit_of_the_vertical_system(small, crs, metres):
    dem = open_dem(small(crs=crs))
    np.testing.assert_allclose(dem.read(0, 0, 12, 9), plane() * metres)
    assert dem.assumptions == ()
    assert not dem.crs.is_compound


def test_unit_of_the_vertical_system_without_a_tag(small):
    # As in formats that do not make a tag of it.
    assert metres_per_unit("auto", "", CRS("EPSG:2229+8228"), "x")[0] == pytest.approx(0.3048)


@pytest.mark.parametrize(
    ("unit", "metres"), [("metre", 1.0), ("foot", 0.3048), ("us_survey_foot", 1200 / 3937)]
)
def test_unit_given_wins_over_the_file(small, unit, metres):
    dem = open_dem(small(unit="ft", crs="EPSG:2229+6360"), unit=unit)
    np.testing.assert_allclose(dem.read(0, 0, 12, 9), plane() * metres)


def test_unit_scales_the_offset_too(small):
    dem = open_dem(small(unit="ft", scale=0.5, offset=10.0))
    np.testing.assert_allclose(dem.read(0, 0, 12, 9), (plane() * 0.5 + 10.0) * 0.3048)


def test_metres_on_a_map_in_feet_are_an_assumption_that_is_said(small):
    dem = open_dem(small(crs="EPSG:2229"))
    (sentence,) = dem.assumptions
    assert "taken as metres" in sentence
    assert "US survey foot" in sentence
    assert open_dem(small(crs="EPSG:2229"), unit="metre").assumptions == ()


LOWEST_SINGLE = float(np.finfo(np.float32).min)


@pytest.mark.parametrize(
    ("data_type", "stored", "no_data"),
    [
        (gdal.GDT_Int16, -32768, -32768),
        (gdal.GDT_Int16, -9999, -9999),
        (gdal.GDT_Byte, 0, 0),
        (gdal.GDT_UInt16, 65535, 65535),
        (gdal.GDT_Int32, -2147483648, -2147483648),
        (gdal.GDT_Float32, LOWEST_SINGLE, LOWEST_SINGLE),
        (gdal.GDT_Float32, -3.4028235e38, -3.4028235e38),
        (gdal.GDT_Float32, -9999.9, -9999.9),
        (gdal.GDT_Float32, np.nan, np.nan),
        (gdal.GDT_Float32, np.nan, None),
        (gdal.GDT_Float32, np.inf, None),
        (gdal.GDT_Float64, -1.7976931348623157e308, -1.7976931348623157e308),
        (gdal.GDT_Float64, np.nan, np.nan),
    ],
)
def test_no_data_is_unknown(small, data_type, stored, no_data):
    heights = plane(10, 6)
    unknown = np.zeros(heights.shape, bool)
    unknown[1, 2] = unknown[4, 7] = True
    heights[unknown] = stored
    dem = open_dem(small(heights, data_type=data_type, no_data=no_data, scale=0.5, unit="ft"))
    read = dem.read(0, 0, 10, 6)
    np.testing.assert_array_equal(np.isnan(read), unknown)
    np.testing.assert_allclose(read[~unknown], heights[~unknown] * 0.5 * 0.3048)


def test_no_data_that_the_type_cannot_hold_takes_nothing_away(small):
    # −9999 comes out as 241 where a byte is made of it.
    heights = np.full((4, 4), 241.0)
    dem = open_dem(small(heights, data_type=gdal.GDT_Byte, no_data=-9999))
    np.testing.assert_array_equal(dem.read(0, 0, 4, 4), heights)
    dem = open_dem(small(heights, data_type=gdal.GDT_Float32, no_data=-1.7976931348623157e308))
    np.testing.assert_array_equal(dem.read(0, 0, 4, 4), heights)


def test_mask_of_the_file_is_unknown(small):
    path = small()
    dataset = gdal.Open(path, gdal.GA_Update)
    dataset.CreateMaskBand(gdal.GMF_PER_DATASET)
    mask = np.full((9, 12), 255, np.uint8)
    mask[3, 4] = 0
    dataset.GetRasterBand(1).GetMaskBand().WriteArray(mask)
    dataset.FlushCache()
    del dataset
    np.testing.assert_array_equal(np.isnan(open_dem(path).read(0, 0, 12, 9)), mask == 0)


def test_other_bands_are_read_by_number(small):
    path = small(np.stack([plane(), plane() + 500.0]))
    np.testing.assert_allclose(open_dem(path, band=2).read(0, 0, 12, 9), plane() + 500.0)


def test_window_is_the_part_of_the_raster_it_names(small):
    dem = open_dem(small())
    np.testing.assert_array_equal(dem.read(3, 2, 5, 4), plane()[2:6, 3:8])


def test_window_over_the_seam_of_a_globe(write_dem):
    heights = np.tile(np.arange(360.0), (10, 1))
    dem = open_dem(write_dem(heights, "EPSG:4326", (-180.0, 1.0, 0.0, 5.0, 0.0, -1.0)))
    np.testing.assert_array_equal(dem.read(358, 0, 4, 2), [[358, 359, 0, 1]] * 2)
    np.testing.assert_array_equal(dem.read(-2, 0, 3, 2), [[358, 359, 0]] * 2)
    seam = np.append(heights, heights[:, :1], axis=1)
    dem = open_dem(write_dem(seam, "EPSG:4326", (-180.5, 1.0, 0.0, 5.0, 0.0, -1.0)))
    np.testing.assert_array_equal(dem.read(358, 0, 4, 2), [[358, 359, 0, 1]] * 2)


def test_height_beside_a_gap_needs_only_the_cells_that_count(small):
    heights = plane()
    heights[:, 5] = np.nan
    dem = open_dem(small(heights))
    # On the centre of column 4, of which column 5 is the unknown neighbour.
    x = 450_015.0 + 4 * 30.0
    assert ground_height(dem, x, 4_519_985.0, "point") == pytest.approx(140.0)


@pytest.mark.parametrize("corner", [(0, 0), (11, 0), (0, 8), (11, 8)])
def test_outermost_cell_centres_are_on_the_terrain(small, corner):
    dem = open_dem(small())
    x, y = dem.crs_position(*corner)
    assert ground_height(dem, float(x), float(y), "point") == pytest.approx(
        plane()[corner[1], corner[0]]
    )


def test_outermost_cell_centres_survive_the_rounding_of_degrees(write_dem):
    step = 1 / 3600
    path = write_dem(plane(), "EPSG:4326", (14.3 - step / 2, step, 0, 40.9 + step / 2, 0, -step))
    dem = open_dem(path)
    for column, row in ((0, 0), (11, 0), (0, 8), (11, 8)):
        x, y = round(14.3 + column * step, 12), round(40.9 - row * step, 12)
        assert ground_height(dem, x, y, "point") == pytest.approx(plane()[row, column], abs=1e-5)


def test_override_of_the_reference_system(small):
    dem = open_dem(small(crs=None), crs="EPSG:32719")
    assert dem.crs.to_epsg() == 32719
    assert open_dem(small(), crs="EPSG:32719").crs.to_epsg() == 32719
