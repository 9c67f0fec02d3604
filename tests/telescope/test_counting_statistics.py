"""Significance of counts against sums of Poisson probabilities."""

import math

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.radiography.counting import feasibility_days
from muysc_qgis.telescope.statistics import days_for_contrast, significant_excess


def upper_tail(sigma):
    return 0.5 * math.erfc(sigma / math.sqrt(2))


def poisson_at_least(count, mean):
    """Return P(N ≥ count) by summing probabilities."""
    below = sum(math.exp(k * math.log(mean) - mean - math.lgamma(k + 1)) for k in range(count))
    return 1 - below


@pytest.mark.parametrize("sigma", [1.0, 2.0, 3.0])
@pytest.mark.parametrize("mean", [0.5, 3.0, 20.0, 150.0])
def test_the_excess_lies_between_the_whole_counts_around_its_probability(mean, sigma):
    excess = float(significant_excess(np.array(mean), sigma))
    assert poisson_at_least(math.floor(excess), mean) >= upper_tail(sigma)
    assert poisson_at_least(math.ceil(excess), mean) <= upper_tail(sigma)


def test_no_counts_by_hand():
    # P(N ≥ 1) = 1 − e^−μ: with μ = −ln(1 − p) one count is the excess.
    sigma = 2.0
    mean = -math.log1p(-upper_tail(sigma))
    assert float(significant_excess(np.array(mean), sigma)) == pytest.approx(1.0, rel=1e-6)


def test_many_counts_need_sigma_times_their_root():
    means = np.array([1e4, 1e6, 1e8])
    sigmas = (significant_excess(means, 3.0) - means) / np.sqrt(means)
    # The skewness of the law is the first that is left: it falls with the root.
    np.testing.assert_array_less(abs(sigmas - 3.0), [4e-2, 4e-3, 4e-4])


def test_unknown_and_empty_stay_unknown():
    assert np.all(np.isnan(significant_excess(np.array([np.nan, 0.0, -1.0]), 3.0)))
    days = days_for_contrast(np.array([np.nan, 0.0, 1.0]), np.array([1.0, 1.0, np.nan]), 3.0)
    assert np.all(np.isnan(days))
    assert np.isinf(days_for_contrast(np.array(1.0), np.array(1.0), 3.0))


@pytest.mark.parametrize("change", [1.02, 0.98])
def test_small_contrasts_need_lesparres_time(change):
    # Small changes need so many counts that the Poisson law is the normal one.
    rate = np.array([0.01, 1.0, 50.0])
    exact = days_for_contrast(rate, change * rate, 3.0)
    normal = feasibility_days(rate, change * rate, 1.0, 3.0)
    np.testing.assert_allclose(exact, normal, rtol=0.02)


@pytest.mark.parametrize(("rate", "changed"), [(0.2, 0.5), (2.0, 1.0), (5.0, 8.0), (1.0, 0.0)])
def test_after_that_time_the_change_has_its_probability(rate, changed):
    sigma = 2.0
    days = float(days_for_contrast(np.array(rate), np.array(changed), sigma))
    expected = changed * days
    if changed > rate:
        below, above = math.floor(expected), math.ceil(expected)
        assert poisson_at_least(below, rate * days) >= upper_tail(sigma)
        assert poisson_at_least(above, rate * days) <= upper_tail(sigma) * (1 + 1e-6)
    else:
        # P(N ≤ n) = 1 − P(N ≥ n + 1).
        below, above = math.floor(expected), math.ceil(expected)
        assert 1 - poisson_at_least(below + 1, rate * days) <= upper_tail(sigma) * (1 + 1e-6)
        assert 1 - poisson_at_least(above + 1, rate * days) >= upper_tail(sigma) * (1 - 1e-6)


def test_complete_absence_by_hand():
    # None where r T are expected: e^−rT = p.
    days = float(days_for_contrast(np.array(4.0), np.array(0.0), 3.0))
    assert days == pytest.approx(-math.log(upper_tail(3.0)) / 4.0, rel=1e-6)


@pytest.mark.parametrize("sigma", [0.0, -1.0, np.nan, 31.0])
def test_useless_significances_are_refused(sigma):
    with pytest.raises(MuyscError, match="significance"):
        significant_excess(np.ones(2), sigma)
    with pytest.raises(MuyscError, match="significance"):
        days_for_contrast(np.ones(2), 2 * np.ones(2), sigma)
