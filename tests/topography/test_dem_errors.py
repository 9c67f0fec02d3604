"""Rasters that cannot be used, by the sentence that says so."""

import re

import numpy as np
import pytest
from osgeo import gdal

from muysc_qgis.errors import MuyscError, detail_of
from muysc_qgis.muogram import Muogram, write_muogram
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import ground_height, local_frame

UTM = "EPSG:32633"
NORTH_UP = (450_000.0, 30.0, 0.0, 4_520_000.0, 0.0, -30.0)
FLAT = np.full((8, 8), 100.0)


def refuses(path, *parts, **keywords):
    """Check the sentence: the file's name, what is wrong, what to do."""
    with pytest.raises(MuyscError) as caught:
        open_dem(path, **keywords)
    sentence = str(caught.value)
    for part in parts:
        assert part in sentence
    assert sentence.endswith(".")
    assert "\n" not in sentence


def test_missing_file(tmp_path):
    refuses(str(tmp_path / "nowhere.tif"), "nowhere.tif", "cannot be opened")


def test_empty_file(tmp_path):
    path = tmp_path / "empty.tif"
    path.write_bytes(b"")
    refuses(str(path), "empty.tif", "cannot be opened")


def test_file_that_is_no_raster(tmp_path):
    path = tmp_path / "notes.txt"
    path.write_text("altitude: high")
    refuses(str(path), "notes.txt", "cannot be opened")


@pytest.mark.parametrize("share", [0.02, 0.5, 0.95])
@pytest.mark.parametrize("options", [(), ("TILED=YES", "COMPRESS=DEFLATE")])
def test_truncated_file(write_dem, share, options):
    generator = np.random.default_rng(5)
    heights = generator.uniform(0, 900, (600, 600))
    path = write_dem(heights, UTM, NORTH_UP, options=options, name="cut.tif")
    with open(path, "rb") as file:
        content = file.read()
    with open(path, "wb") as file:
        file.write(content[: int(share * len(content))])
    with pytest.raises(MuyscError, match=r"cut\.tif (cannot be opened|cannot be read)"):
        open_dem(path).read(0, 0, 600, 600)


def test_picture(write_dem):
    path = write_dem(
        np.stack([FLAT] * 3), UTM, NORTH_UP, gdal.GDT_Byte, options=["PHOTOMETRIC=RGB"]
    )
    for band, colour in ((1, "Red"), (2, "Green"), (3, "Blue")):
        refuses(path, f"Band {band}", f"picture ({colour})", "elevation raster", band=band)


def test_palette(write_dem):
    path = write_dem(FLAT, UTM, NORTH_UP, gdal.GDT_Byte, options=["PHOTOMETRIC=PALETTE"])
    dataset = gdal.Open(path, gdal.GA_Update)
    colours = gdal.ColorTable()
    colours.SetColorEntry(100, (1, 2, 3))
    dataset.GetRasterBand(1).SetColorTable(colours)
    dataset.FlushCache()
    del dataset
    refuses(path, "Band 1", "picture (Palette)", "elevation raster")


def test_alpha_band(write_dem):
    path = write_dem(np.stack([FLAT] * 2), UTM, NORTH_UP, gdal.GDT_Byte, options=["ALPHA=YES"])
    refuses(path, "Band 2", "picture (Alpha)", band=2)


def test_complex_numbers(write_dem):
    path = write_dem(FLAT, UTM, NORTH_UP, gdal.GDT_CFloat32)
    refuses(path, "Band 1", "complex numbers (CFloat32)", "elevation raster")


def test_muogram(tmp_path):
    path = tmp_path / "thickness.tif"
    muogram = Muogram("thickness", FLAT, np.arange(8.0), np.arange(8.0)[::-1])
    write_muogram(muogram, path)
    refuses(str(path), "thickness.tif is a muogram", "choose the elevation raster")


def test_no_reference_system(write_dem):
    refuses(
        write_dem(FLAT, None, NORTH_UP, name="bare.tif"),
        "bare.tif has no coordinate reference system", "Assign Projection",
    )  # fmt: skip


def test_no_georeferencing(write_dem):
    refuses(write_dem(FLAT, UTM, None, name="scan.tif"), "scan.tif is not georeferenced")


def test_collapsed_geotransform(write_dem):
    collapsed = (450_000.0, 30.0, 30.0, 4_520_000.0, 30.0, 30.0)
    refuses(write_dem(FLAT, UTM, collapsed), "is not georeferenced")


@pytest.mark.parametrize("far", [1e200, np.inf, np.nan])
def test_coordinates_that_no_map_has(write_dem, far):
    path = write_dem(FLAT, UTM, (far, 30.0, 0.0, 4_520_000.0, 0.0, -30.0), name="far.tif")
    refuses(path, "far.tif", f"{far}", "1e+09", "georeference it")


@pytest.mark.parametrize("band", [0, 2, -1])
def test_band_that_does_not_exist(write_dem, band):
    refuses(
        write_dem(FLAT, UTM, NORTH_UP), f"Band {band} does not exist", "choose 1 to 1", band=band
    )


@pytest.mark.parametrize("shape", [(1, 8), (8, 1)])
def test_too_few_cells(write_dem, shape):
    refuses(
        write_dem(np.zeros(shape), UTM, NORTH_UP),
        f"{shape[1]} × {shape[0]} cells",
        "at least 2 × 2",
    )


def test_unknown_unit(write_dem):
    path = write_dem(FLAT, UTM, NORTH_UP, unit="fathom", name="chart.tif")
    refuses(path, "chart.tif", "“fathom”", "set the height unit")
    assert open_dem(path, unit="metre").read(0, 0, 1, 1)[0, 0] == 100.0
    refuses(path, "“furlong”", "metre, foot, us_survey_foot", unit="furlong")


@pytest.mark.parametrize(
    ("crs", "name"), [("EPSG:4978", "WGS 84"), ('LOCAL_CS["mine",UNIT["metre",1]]', "mine")]
)
def test_reference_system_that_maps_no_ground(write_dem, crs, name):
    refuses(write_dem(FLAT, crs, NORTH_UP), f"({name})", "geographic or projected")


def test_reference_system_that_is_not_understood(write_dem):
    refuses(write_dem(FLAT, UTM, NORTH_UP), "is not understood", crs="EPSG:none")


def test_another_planet(write_dem):
    moon = "+proj=longlat +R=1737400 +no_defs"
    dem = open_dem(write_dem(FLAT, moon, (10.0, 0.01, 0.0, 5.0, 0.0, -0.01)))
    frame = local_frame(dem, 10.04, 4.96, "detector")
    with pytest.raises(MuyscError, match="reference system on the Earth"):
        frame.wgs84()


@pytest.mark.parametrize(
    ("value", "data_type"), [(-32768, gdal.GDT_Int16), (12_000, gdal.GDT_Float32)]
)
def test_values_that_no_ground_on_earth_has(write_dem, value, data_type):
    heights = FLAT.copy()
    heights[2, 3] = value
    dem = open_dem(write_dem(heights, UTM, NORTH_UP, data_type, name="odd.tif"))
    with pytest.raises(MuyscError, match=re.escape(f"odd.tif holds {value:g} m")) as caught:
        dem.read(0, 0, 8, 8)
    assert "no-data value or unit" in str(caught.value)


def test_missing_heights_that_the_file_does_not_flag(write_dem):
    heights = FLAT.copy()
    heights[2, 3] = -9999
    path = write_dem(heights, UTM, NORTH_UP, name="unflagged.tif")
    with pytest.raises(MuyscError, match="set the raster's no-data value to it"):
        open_dem(path).read(0, 0, 8, 8)


def test_highest_and_deepest_ground_are_elevations(write_dem):
    heights = FLAT.copy()
    heights[0, 0], heights[0, 1] = 8849.0, -10_935.0
    np.testing.assert_array_equal(
        open_dem(write_dem(heights, UTM, NORTH_UP)).read(0, 0, 8, 8), heights
    )


def test_detector_off_the_dem(write_dem):
    dem = open_dem(write_dem(FLAT, UTM, NORTH_UP, name="area.tif"))
    with pytest.raises(MuyscError) as caught:
        local_frame(dem, 451_234.5, 4_519_900.0, "detector")
    sentence = str(caught.value)
    assert "The detector (451234.5, 4519900) is off the DEM area.tif" in sentence
    assert "x 450015 to 450225 and y 4519775 to 4519985" in sentence
    assert "move the detector or choose a larger DEM" in sentence


def test_half_a_cell_outside_is_off_the_surface(write_dem):
    # Inside the outermost cell, but beyond its centre.
    dem = open_dem(write_dem(FLAT, UTM, NORTH_UP))
    with pytest.raises(MuyscError, match="off the DEM"):
        ground_height(dem, 450_010.0, 4_519_900.0, "target")


def test_detector_on_no_data(write_dem):
    heights = FLAT.copy()
    heights[4, 4] = np.nan
    dem = open_dem(write_dem(heights, UTM, NORTH_UP, name="gap.tif"))
    with pytest.raises(MuyscError, match=r"The detector .* where the DEM gap\.tif has no data"):
        local_frame(dem, 450_000.0 + 4.3 * 30, 4_520_000.0 - 4.3 * 30, "detector")


@pytest.mark.parametrize(
    "said", ["no such file", "no such file.", "no such file.\nMay be caused by: a typing error."]
)
def test_of_what_gdal_says_one_line_is_enough(said):
    assert detail_of(RuntimeError(said)) == "no such file"
    assert detail_of(RuntimeError()) == ""
