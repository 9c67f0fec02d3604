"""Volumes as GeoTIFF: a band for each slice, on the map, and back."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal

from muysc_qgis.errors import MuyscError
from muysc_qgis.muogram import Muogram, read_muogram, write_muogram
from muysc_qgis.tomography.voxels import VoxelGrid
from muysc_qgis.volume import Volume, band_name, read_volume, write_volume
from muysc_qgis.workflows.volume_frame import utm_zone

GRID = VoxelGrid((450_100.0, 4_518_000.0, 2425.0), (50.0, 40.0, 30.0), (4, 3, 5))


@pytest.fixture
def volume():
    values = np.arange(60.0).reshape(GRID.shape) / 16
    values[3, 2, 4] = np.nan
    crs = utm_zone(14.4, 40.8).to_wkt()
    return Volume("density", GRID, values, crs, {"METHOD": "tv", "REFERENCE_DENSITY": 2.65})


@pytest.fixture
def file(volume, tmp_path):
    path = tmp_path / "density.tif"
    write_volume(volume, path)
    return path


def test_a_volume_comes_back_as_it_was(volume, file):
    back = read_volume(file)
    assert back.grid == volume.grid
    np.testing.assert_array_equal(back.values, volume.values)
    assert back.quantity == "density"
    assert back.metadata == {"METHOD": "tv", "REFERENCE_DENSITY": "2.65"}
    assert "32633" in back.crs


def test_slices_are_bands_from_the_lowest_up_named_after_their_centres(file):
    dataset = gdal.Open(str(file))
    bands = [dataset.GetRasterBand(number + 1) for number in range(dataset.RasterCount)]
    assert [band.GetDescription() for band in bands] == [
        "z = 2440 m", "z = 2470 m", "z = 2500 m", "z = 2530 m", "z = 2560 m",
    ]  # fmt: skip
    assert all(band.DataType == gdal.GDT_Float32 for band in bands)
    assert all(np.isnan(band.GetNoDataValue()) for band in bands)
    assert {band.GetUnitType() for band in bands} == {"g/cm³"}


def test_any_reader_finds_a_voxel_where_it_is_on_the_map(volume, file):
    dataset = gdal.Open(str(file))
    assert dataset.GetSpatialRef().GetAuthorityCode(None) == "32633"
    left, width, _, top, _, height = dataset.GetGeoTransform()
    east, north = 450_100 + 2.5 * 50, 4_518_000 + 1.5 * 40
    column, row = int((east - left) / width), int((north - top) / height)
    assert dataset.GetRasterBand(4).ReadAsArray()[row, column] == volume.values[2, 1, 3]


def test_names_of_bands_keep_fractions():
    assert band_name(1012.5) == "z = 1012.5 m"


def test_a_slice_is_no_muogram_and_a_muogram_no_volume(file, tmp_path):
    with pytest.raises(MuyscError, match=r"5 bands where a muogram has 1"):
        read_muogram(file)
    flat = tmp_path / "muogram.tif"
    write_muogram(Muogram("density", np.ones((2, 3)), np.arange(3.0), np.array([2.0, 1.0])), flat)
    with pytest.raises(MuyscError, match=r"is no volume of voxels.*made by Muon tomography"):
        read_volume(flat)
    with pytest.raises(MuyscError, match=r"cannot be opened"):
        read_volume(tmp_path / "none.tif")


def test_one_slice_is_no_muogram_either(volume, tmp_path):
    thin = VoxelGrid(GRID.origin_m, GRID.size_m, (4, 3, 1))
    path = tmp_path / "thin.tif"
    write_volume(Volume("density", thin, volume.values[:, :, :1], volume.crs), path)
    with pytest.raises(MuyscError, match=r"“voxel density” is not a quantity of a muogram"):
        read_muogram(path)


def test_what_does_not_fit_is_refused(volume):
    with pytest.raises(MuyscError, match=r"“flux” is not a quantity of voxels"):
        volume.with_values("flux", volume.values)
    with pytest.raises(MuyscError, match=r"give one value for each voxel"):
        volume.with_values("coverage", volume.values[:2])
    with pytest.raises(MuyscError, match=r"cannot be written"):
        write_volume(volume, "/no/such/folder/file.tif")


def test_other_code_may_have_switched_on_exceptions_since():
    code = (
        "from osgeo import gdal, ogr, osr\n"
        "for one in (gdal, ogr, osr): one.UseExceptions()\n"
        "from muysc_qgis.errors import MuyscError\n"
        "from muysc_qgis.geotiff import raster_writer\n"
        "@raster_writer\n"
        "def write(path): gdal.GetDriverByName('GTiff').Create(path, 4, 4)\n"
        "try: write('/no/such/folder/file.tif')\n"
        "except MuyscError as error: print(error)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stdout.startswith("The raster /no/such/folder/file.tif cannot be written"), done
