"""Terrain in a rectangle of a projection, against the heights of the DEM itself."""

import numpy as np
import pytest

from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import transformed
from muysc_qgis.topography.relief import relief_on_map
from muysc_qgis.topography.sampling import heights_at


@pytest.fixture
def utm():
    from pyproj import CRS

    return CRS.from_epsg(32633)


@pytest.fixture
def dem(data_folder):
    return open_dem(data_folder / "vesuvius_srtmgl1.tif")


def test_it_holds_the_heights_at_its_points(dem, utm):
    """Finer than the DEM; the warper places its points to an eighth of a pixel."""
    relief = relief_on_map(dem, utm, (451_000.0, 452_600.0), (4_518_500.0, 4_519_700.0), 200)
    assert relief.elevation_m.shape == (150, 200)
    assert (relief.east_m[0], relief.north_m[0]) == (451_004, 4_518_504)
    x, y = np.meshgrid(relief.east_m, relief.north_m)
    expected = heights_at(dem, *dem.grid_position(*transformed(utm, dem.crs, x, y)))
    assert np.abs(relief.elevation_m - expected).max() < 0.5


def test_coarse_ones_are_means_of_the_cells_below(dem, utm):
    limits = (449_000.0, 453_000.0), (4_517_000.0, 4_521_000.0)
    coarse = relief_on_map(dem, utm, *limits, 20).elevation_m
    fine = relief_on_map(dem, utm, *limits, 400).elevation_m
    blocks = fine.reshape(20, 20, 20, 20).mean(axis=(1, 3))
    assert np.abs(coarse - blocks).max() < 6
    assert np.abs(coarse - blocks).mean() < 1


def test_what_is_beyond_the_dem_is_unknown(dem, utm):
    relief = relief_on_map(dem, utm, (300_000.0, 301_000.0), (4_518_000.0, 4_519_000.0), 10)
    assert np.isnan(relief.elevation_m).all()
