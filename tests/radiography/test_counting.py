"""Counting times and density errors against the published figures."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.radiography.counting import (
    exposure_days,
    feasibility_days,
)
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate

#: 100 m, 500 m and 1 km of standard rock, g/cm².
OPACITY = 265.0 * np.array([100.0, 500.0, 1000.0])
#: The choices of the published work, at a zenith angle of 75°.
PHYSICS = Physics(flux_model="reyna-bugaev", straggling=False)


def flux(opacity):
    return attenuate(opacity, 15.0, PHYSICS).flux


def test_exposure_for_ten_muons_in_6_cm2_sr():
    days = exposure_days(flux(OPACITY), 6.0, 10)
    np.testing.assert_allclose(days, [0.66, 23, 213], rtol=7e-3)


def test_exposure_by_hand():
    # 2 muons per cm² sr and day, seen by 5 cm² sr: 10 a day.
    np.testing.assert_allclose(exposure_days(np.array(2.0), 5.0, 100), 10.0)
    np.testing.assert_allclose(
        exposure_days(np.array([2.0, 2.0]), np.array([5.0, 10.0]), 100), [10, 5]
    )


def test_exposure_is_unknown_without_flux():
    days = exposure_days(np.array([np.nan, 0.0, 1.0]), np.array([1.0, 1.0, np.nan]), 10)
    assert np.all(np.isnan(days))


@pytest.mark.parametrize("value", [0.0, -1.0, np.nan, np.inf])
def test_useless_numbers_are_refused(value):
    with pytest.raises(MuyscError, match=f"acceptance in cm² sr is {value:g}"):
        exposure_days(np.ones(2), value, 10)
    with pytest.raises(MuyscError, match=f"number of muons is {value:g}"):
        exposure_days(np.ones(2), 6.0, value)
    with pytest.raises(MuyscError, match=f"significance in standard deviations is {value:g}"):
        feasibility_days(np.ones(2), np.ones(2), 6.0, value)
    if not np.isnan(value):
        with pytest.raises(MuyscError, match="acceptance"):
            exposure_days(np.ones(2), np.array([1.0, value]), 10)


def test_feasibility_of_ten_percent_less_along_the_whole_path():
    days = feasibility_days(flux(OPACITY), flux(0.9 * OPACITY), 10.0)
    np.testing.assert_allclose(days, [1.0, 12.6, 57.6], rtol=0.011)


def test_feasibility_grows_with_the_square_of_the_significance():
    one, three = (
        feasibility_days(np.array(1.0), np.array(1.3), 5.0, sigma) for sigma in (1.0, 3.0)
    )
    assert three == pytest.approx(9 * one)
    assert np.isinf(feasibility_days(np.array(1.0), np.array(1.0), 5.0))
    assert np.isnan(feasibility_days(np.array(np.nan), np.array(1.0), 5.0))
