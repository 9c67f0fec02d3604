"""Rasters in telescope angles: written, read, and told from muograms."""

import numpy as np
import pytest
from osgeo import gdal

from muysc_qgis.errors import MuyscError
from muysc_qgis.muogram import Muogram, read_grid, read_muogram, write_muogram
from muysc_qgis.trajectories import (
    TrajectoryMap,
    read_trajectories,
    read_view,
    write_trajectories,
)

AIMED = {"BORESIGHT_AZIMUTH": 350.0, "BORESIGHT_ELEVATION": 20.0, "ROLL": 5.0}


def raster(metadata=AIMED, nx=5, ny=3, step=0.02):
    x = step * (np.arange(nx) - nx // 2)
    y = step * (ny // 2 - np.arange(ny))
    values = np.arange(nx * ny, dtype=float).reshape(ny, nx)
    values[0, 0] = np.nan
    return TrajectoryMap("counts", values, x, y, {**metadata, "TANGENT_STEP": step})


def test_there_and_back(tmp_path):
    written = raster()
    write_trajectories(written, tmp_path / "a.tif")
    back = read_trajectories(tmp_path / "a.tif")
    np.testing.assert_array_equal(back.values, written.values)
    np.testing.assert_allclose(back.x, written.x, atol=1e-15)
    np.testing.assert_allclose(back.y, written.y, atol=1e-15)
    assert back.quantity == "counts"
    assert read_grid(tmp_path / "a.tif").metadata["PROJECTION"] == "tangent"
    np.testing.assert_allclose(back.directions_deg(), written.directions_deg(), atol=1e-9)


@pytest.mark.parametrize(("nx", "ny"), [(1, 1), (1, 3), (3, 1)])
def test_a_single_trajectory_keeps_its_size(tmp_path, nx, ny):
    written = raster(nx=nx, ny=ny)
    write_trajectories(written, tmp_path / "a.tif")
    back = read_trajectories(tmp_path / "a.tif")
    np.testing.assert_allclose(back.x, written.x, atol=1e-15)
    np.testing.assert_allclose(back.pixel_size, 0.02)


def test_each_direction_leads_to_its_pixel():
    one = raster()
    pixels = one.pixel_of(*one.directions_deg())
    np.testing.assert_array_equal(pixels, np.arange(15).reshape(3, 5))
    assert one.pixel_of(np.array([350.0]), np.array([40.0])) == -1
    assert one.pixel_of(np.array([170.0]), np.array([-20.0])) == -1


def test_a_telescope_without_a_direction_says_so():
    with pytest.raises(MuyscError, match="no direction in the sky"):
        raster({}).directions_deg()


def test_muograms_and_telescope_rasters_are_told_apart(tmp_path):
    write_trajectories(raster(), tmp_path / "telescope.tif")
    muogram = Muogram("counts", np.ones((2, 2)), np.array([0.0, 1.0]), np.array([1.0, 0.0]))
    write_muogram(muogram, tmp_path / "muogram.tif")
    with pytest.raises(MuyscError, match="telescope angles"):
        read_muogram(tmp_path / "telescope.tif")
    with pytest.raises(MuyscError, match="no raster in telescope angles"):
        read_trajectories(tmp_path / "muogram.tif")
    assert isinstance(read_view(tmp_path / "telescope.tif"), TrajectoryMap)
    assert isinstance(read_view(tmp_path / "muogram.tif"), Muogram)


@pytest.mark.parametrize(
    "geotransform",
    [
        (1e300, 1, 0, 10, 0, -1), (np.inf, 1, 0, 10, 0, -1), (np.nan, 1, 0, 10, 0, -1),
        (0, 1e308, 0, 10, 0, -1), (0, 1, 0, 10, 0, -np.inf), (0, 1, 0, 1e9, 0, -1),
        (0, 1e-300, 0, 10, 0, -1), (0, 1, 0, 10, 0, -1e-10),
    ],
)  # fmt: skip
def test_pixels_that_are_no_directions_are_refused(tmp_path, geotransform):
    path = str(tmp_path / "a.tif")
    write_trajectories(raster(), path)
    dataset = gdal.Open(path, gdal.GA_Update)
    dataset.SetGeoTransform(geotransform)
    del dataset
    with pytest.raises(MuyscError, match=r"no directions.*1e\+06 at most and are 1e-09 or more"):
        read_grid(path)


def test_shapes_and_quantities_are_checked():
    with pytest.raises(MuyscError, match="one value for each"):
        TrajectoryMap("counts", np.ones((2, 2)), np.arange(3.0), np.arange(2.0))
    with pytest.raises(MuyscError, match="“beauty” is not a quantity"):
        TrajectoryMap("beauty", np.ones((1, 1)), np.zeros(1), np.zeros(1))
