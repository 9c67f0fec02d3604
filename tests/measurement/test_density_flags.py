"""Pixels without a plain density: limits, bright, unknown; and what is refused."""

from dataclasses import replace

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.measurement.density import Flag, measure_density
from muysc_qgis.measurement.mean import mean_density
from muysc_qgis.measurement.observation import (
    check_transmission,
    from_count_ratio,
    from_counts,
    from_values,
)
from muysc_qgis.measurement.scene import Scene
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate

ELEVATION_DEG = np.array([[12.0], [6.0]])
PHYSICS = Physics(flux_model="gaisser-tang", altitude_correction=False)


def scene(thickness=((100.0, 400.0), (300.0, 900.0)), elevation=ELEVATION_DEG, uncertainty=0.0):
    return Scene(np.array(thickness), elevation, PHYSICS, 0.0, uncertainty)


def flux_at(density, there):
    opacity = density * 100 * there.thickness_m
    return attenuate(opacity, there.elevation_deg, PHYSICS).flux


def test_no_muon_gives_the_least_density_that_explains_it():
    there = scene()
    exposure = -np.log(0.05) / flux_at(1.7, there)  # 2.9957 muons expected at 1.7 g/cm³
    found = measure_density(from_counts(np.zeros((2, 2)), 1.0, exposure, 0.95), there)
    assert np.all(found.flags == Flag.LOWER_LIMIT)
    # As many are expected with a probability of 5 % to see none.
    np.testing.assert_allclose(found.density, 1.7, rtol=1e-5)
    assert np.isnan(found.error).all()
    assert np.isnan(found.upper).all()
    np.testing.assert_array_equal(found.lower, found.density)


def test_a_limit_grows_weaker_with_the_uncertainty_of_the_model():
    seen = from_counts(np.zeros((2, 2)), 100.0, 1.0, 0.95)
    plain, wide = (measure_density(seen, scene(uncertainty=u)).density for u in (0.0, 0.2))
    assert np.all(wide < plain)


def test_a_picture_without_muons_is_one_region_with_a_limit():
    there = scene()
    found = measure_density(from_counts(np.zeros((2, 2)), 30.0, 1.0, 0.95), there, 20)
    assert np.all(found.flags == Flag.LOWER_LIMIT)
    expected = 30.0 * flux_at(found.density[0, 0], there).sum()
    assert expected == pytest.approx(-np.log(0.05), rel=1e-5)


def test_a_flux_of_zero_with_an_error_is_a_limit_too():
    there = scene()
    error = flux_at(2.0, there) / 1.6448536  # the one-sided 95 % of a normal distribution
    found = measure_density(from_values(np.zeros((2, 2)), error, 0.95), there)
    assert np.all(found.flags == Flag.LOWER_LIMIT)
    np.testing.assert_allclose(found.density, 2.0, rtol=1e-5)


def test_a_flux_of_zero_without_an_error_says_nothing():
    found = measure_density(from_values(np.zeros((2, 2)), None, 0.95), scene())
    assert np.all(found.flags == Flag.NO_ANSWER)
    assert np.isnan(found.density).all()


def test_more_than_the_open_sky_is_density_zero():
    there = scene()
    sky = np.broadcast_to(flux_at(0.0, there), (2, 2))
    found = measure_density(from_values(1.1 * sky, 0.2 * sky, 0.95), there)
    assert np.all(found.flags == Flag.BRIGHT)
    assert np.all(found.density == 0)


def test_an_error_as_large_as_the_flux_leaves_no_upper_end():
    there = scene()
    flux = flux_at(2.0, there)
    found = measure_density(from_values(flux, flux, 0.95), there)
    assert np.all(found.flags == Flag.MEASURED)
    assert np.isnan(found.upper).all()
    assert np.isfinite(found.lower).all()


def test_unknown_is_told_by_its_cause():
    there = scene(thickness=((0.0, 100.0), (np.nan, 100.0)), elevation=np.array([[5.0], [-1.0]]))
    values = np.array([[1.0, np.nan], [1.0, 1.0]])
    found = measure_density(from_values(values, None, 0.95), there)
    expected = [[Flag.SKY, Flag.NOT_MEASURED], [Flag.NOT_MEASURED, Flag.NO_ANSWER]]
    np.testing.assert_array_equal(found.flags, expected)
    assert np.isnan(found.density).all()


def test_nothing_counted_in_the_open_sky_leaves_a_pixel_unknown():
    counts, sky = np.full((2, 2), 30.0), np.array([[0.0, 900.0], [900.0, 900.0]])
    found = measure_density(from_count_ratio(counts, sky, 10.0, ELEVATION_DEG, 0.95), scene())
    assert found.flags[0, 0] == Flag.NOT_MEASURED
    assert found.count(Flag.MEASURED) == 3


def test_rock_that_stops_no_muon_has_no_density():
    # A formula counts all muons behind rock and those above 1 GeV/c in the sky, which is
    # 0.9 GeV and crosses about 1.8 m of rock: 0.1 m dims nothing.
    there = scene(thickness=((0.1, 100.0), (0.1, 300.0)))
    there = replace(there, physics=Physics(flux_model="guan", altitude_correction=False))
    sky = np.broadcast_to(flux_at(0.0, there), (2, 2))
    for seen in (
        from_values(np.where(there.thickness_m < 1, sky, 0.1 * sky), None, 0.95),
        from_counts(np.full((2, 2), 30.0), 1.0, 30.0 / (0.1 * sky), 0.95),
    ):
        found = measure_density(seen, there)
        assert np.all(found.flags[:, 0] == Flag.TOO_THIN)
        assert np.isnan(found.density[:, 0]).all()
        assert np.all(found.flags[:, 1] == Flag.MEASURED)
    # A threshold below which nothing counts makes any rock count.
    strict = Physics(flux_model="guan", altitude_correction=False, detection_threshold_gev=1.0)
    assert not Scene(there.thickness_m, ELEVATION_DEG, strict, 0.0).too_thin.any()


def test_a_picture_of_sky_has_no_mean():
    there = scene(thickness=np.zeros((2, 2)))
    seen = from_counts(np.full((2, 2), 9.0), 1.0, 1.0, 0.95)
    for minimum in (0, 5):
        found = measure_density(seen, there, minimum)
        assert np.isnan(mean_density(seen, there, found).density)
        assert found.regions == 0


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: from_counts(np.array([[-3.0]]), 1, 1, 0.95), ("muon counts", "-3", "1 pixel,")),
        (lambda: from_counts(np.array([[2.5]]), 1, 1, 0.95), ("fractional", "2.5")),
        (lambda: from_counts(np.array([[np.inf]]), 1, 1, 0.95), ("infinite",)),
        (lambda: from_counts(np.array([[2.0]]), 0, 1, 0.95), ("exposure in days is 0",)),
        (lambda: from_counts(np.array([[2.0]]), 1, -1, 0.95), ("acceptance in cm² sr is -1",)),
        (lambda: from_values(np.array([[-1.0, -2.0]]), None, 0.95), ("measured flux", "2 pixels")),
        (
            lambda: from_values(np.array([[-0.1]]), None, 0.95, ELEVATION_DEG[:1]),
            ("measured transmission", "-0.1"),
        ),
        (lambda: from_values(np.ones((1, 1)), -np.ones((1, 1)), 0.95), ("error", "-1")),
        (
            lambda: from_count_ratio(
                np.ones((1, 1)), np.full((1, 1), 0.5), 1, ELEVATION_DEG[:1], 0.95
            ),
            ("open-sky counts", "0.5"),
        ),
        (
            lambda: check_transmission(np.array([[1.2, 37.0]]), None, np.array([[5.0, 5.0]])),
            ("above 1 in 2 pixels", "37", "percent"),
        ),
        (lambda: scene(thickness=((-1.0, 1.0), (1.0, 1.0))), ("thickness", "-1 m")),
        (lambda: scene(uncertainty=1.0), ("100 %",)),
        (
            lambda: measure_density(from_values(np.ones((2, 2)), None, 0.95), scene(), 20),
            ("merged up to 20 counts", "give muon counts"),
        ),
    ],
)
def test_what_cannot_be_is_refused(make, words):
    with pytest.raises(MuyscError) as caught:
        make()
    said = str(caught.value)
    assert said.endswith((".", ".)"))
    for word in words:
        assert word in said


def test_a_transmission_a_little_above_one_is_noise():
    values, errors = np.array([[1.04, 3.0]]), np.array([[0.02, 0.1]])
    check_transmission(values, errors, np.array([[5.0, 0.0]]))
