"""Muons in each pixel, and what places for a detector are compared by."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.planning import counts_in, figures_of_site
from muysc_qgis.workflows.simulation import Telescope, simulate

#: Tall enough for rays below the horizon; the middle pixel looks at the target.
APERTURE = Aperture(30.0, 60.0, 5, 7)
TELESCOPE = Telescope(6.0, 12.0, trajectories(TelescopeGeometry(16, 16, 5.0, 100.0)))


@pytest.fixture(scope="module")
def sight(dem):
    places = [from_wgs84(dem.crs, *place) for place in ((14.410686, 40.810561), (14.4265, 40.8215))]
    return take_sight(dem, *places, 0.0, -100.0)


@pytest.fixture(scope="module")
def simulation(sight):
    return simulate(sight, APERTURE, Physics(), TELESCOPE)


def test_counts_are_the_muons_wanted_times_days_over_the_exposure_time(simulation):
    counts = counts_in(30.0, simulation, TELESCOPE)
    assert counts.quantity == "counts"
    assert counts.metadata["DAYS"] == 30.0
    exposure = simulation.muograms["exposure"].values
    np.testing.assert_allclose(counts.values, 12.0 * 30.0 / exposure)
    assert np.isfinite(exposure).sum() > 10
    with pytest.raises(MuyscError, match="time of counting in days is 0"):
        counts_in(0.0, simulation, TELESCOPE)


def test_figures_of_a_site_are_those_of_its_muogram(sight, simulation):
    told = []
    figures = figures_of_site(
        sight, APERTURE, Physics(), TELESCOPE, lambda share: told.append(share) or True
    )
    thickness = simulation.muograms["thickness"].values
    assert figures.target_distance_m == sight.target_distance_m
    assert figures.maximum_thickness_m == np.nanmax(thickness)
    assert figures.target_thickness_m == pytest.approx(thickness[3, 2], rel=1e-6) != 0
    # One ray and many have energy grids of their own, on which fluxes are known to 4·10⁻⁵.
    assert figures.target_days == pytest.approx(
        simulation.muograms["exposure"].values[3, 2], rel=1e-4
    )
    unknown = np.isnan(simulation.muograms["flux"].values).sum()
    assert figures.unknown_pixels == unknown > 0
    assert figures.pixels == 35
    assert told == sorted(told)
    assert told[-1] == 1.0
