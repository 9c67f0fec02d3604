"""Errors of pixels that were merged, as data of a tomography."""

import numpy as np
import pytest

from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.muogram_data import read_survey
from muysc_qgis.workflows.named_view import NamedView
from muysc_qgis.workflows.simulation import Telescope, simulate

DETECTOR, CRATER = (14.410686, 40.810561), (14.4265, 40.8215)
#: g/cm³
ERROR = 0.3


@pytest.fixture(scope="module")
def dem(data_folder):
    return open_dem(data_folder / "vesuvius_srtmgl1.tif")


@pytest.fixture(scope="module")
def thickness(dem):
    places = [from_wgs84(dem.crs, *place) for place in (DETECTOR, CRATER)]
    simulation = simulate(take_sight(dem, *places), Aperture(20, 6, 6, 4), Physics(), Telescope())
    return simulation.muograms["thickness"]


@pytest.mark.parametrize(("minimum_counts", "share"), [(100.0, 1.0), (0.0, 6.0), (None, 6.0)])
def test_merged_pixels_weigh_as_much_as_their_region(dem, thickness, minimum_counts, share):
    """Weights are 1/σ²: those of a region's pixels add up to that of its one measurement."""
    assert thickness.values.shape == (4, 6)
    assert (thickness.values > 0).all()
    region = np.repeat(np.arange(4), 6).reshape(4, 6)
    said = {} if minimum_counts is None else {"MINIMUM_COUNTS": minimum_counts}
    density = thickness.with_values("density", 2.0 + 0.1 * region, **said)
    errors = thickness.with_values("density_error", np.full((4, 6), ERROR), **said)
    data = read_survey([NamedView("density", density)], [NamedView("errors", errors)], dem)
    error = data.stations[0].error / (100.0 * data.rock[0].thickness_m)
    weights = np.bincount(region.ravel(), error**-2)
    np.testing.assert_allclose(weights, share / ERROR**2, rtol=1e-9)
