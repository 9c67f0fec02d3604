"""Intervals of counts against published tables and against their own definition."""

import numpy as np
import pytest
from scipy import stats

from muysc_qgis.measurement import poisson


@pytest.mark.parametrize(
    ("counts", "lower", "upper"),
    [
        # Gehrels (1986), ApJ 303, 336, doi:10.1086/164079, tables 1 and 2, one standard
        # deviation: 0.8413 on either side.
        (0, 0.0, 1.841),
        (1, 0.173, 3.300),
        (2, 0.708, 4.638),
        (3, 1.367, 5.918),
        (5, 2.840, 8.382),
        (10, 6.891, 14.27),
        (20, 15.57, 25.55),
    ],
)
def test_exact_intervals_are_the_published_ones(counts, lower, upper):
    low, high = poisson.exact_interval(np.array([counts]))
    assert low[0] == pytest.approx(lower, abs=0.006)
    assert high[0] == pytest.approx(upper, abs=0.006)


@pytest.mark.parametrize("counts", [1, 4, 13])
def test_ends_have_the_tail_probabilities_that_define_them(counts):
    low, high = poisson.exact_interval(np.array([counts]))
    tail = (1 - poisson.ONE_SIGMA) / 2
    assert stats.poisson.sf(counts - 1, low[0]) == pytest.approx(tail)
    assert stats.poisson.cdf(counts, high[0]) == pytest.approx(tail)


def test_no_counts_exclude_three_at_95_percent():
    assert poisson.upper_limit(np.array([0]), 0.95)[0] == pytest.approx(-np.log(0.05))


@pytest.mark.parametrize(("counts", "reference"), [(1, 7), (4, 4), (12, 100)])
def test_ratio_ends_have_the_tail_probabilities_that_define_them(counts, reference):
    low, high = poisson.exact_ratio_interval(np.array([counts]), np.array([reference]))
    tail = (1 - poisson.ONE_SIGMA) / 2
    total = counts + reference
    assert stats.binom.sf(counts - 1, total, low[0] / (1 + low[0])) == pytest.approx(tail)
    assert stats.binom.cdf(counts, total, high[0] / (1 + high[0])) == pytest.approx(tail)


def test_a_ratio_to_endless_counts_is_a_poisson_mean():
    counts, many = np.arange(0.0, 15.0), 1e9
    ratio = poisson.exact_ratio_interval(counts, np.full(15, many))
    for one, other in zip(ratio, poisson.exact_interval(counts)):
        np.testing.assert_allclose(one * many, other, rtol=1e-5)


def test_nothing_in_the_denominator_has_no_upper_end():
    low, high = poisson.exact_ratio_interval(np.array([3.0, 0.0]), np.array([0.0, 0.0]))
    assert np.isinf(high).all()
    assert low[0] > 0
    assert low[1] == 0


def test_unknown_counts_stay_unknown():
    counts = np.array([np.nan, 0.0, 25.0])
    for end in (
        *poisson.exact_interval(counts),
        *poisson.exact_ratio_interval(counts, np.array([5.0, np.nan, np.nan])),
    ):
        assert np.isnan(end[0])
    down, up = poisson.logarithmic_errors(counts)
    assert np.isnan([down[0], up[0], down[1], up[1]]).all()
    assert down[2] == up[2] == pytest.approx(0.2)


@pytest.mark.parametrize("mean", [1.5, 4.0, 9.0])
def test_few_counts_hold_the_truth_at_least_as_often_as_they_say(mean):
    counts = np.arange(1, 60)
    down, up = poisson.logarithmic_errors(counts)
    holds = (counts * np.exp(-down) <= mean) & (mean <= counts * np.exp(up))
    # A count of none has no interval of its own; its probability is not lost.
    probability = stats.poisson.pmf(counts, mean)[holds].sum() + stats.poisson.pmf(0, mean)
    assert probability >= poisson.ONE_SIGMA


@pytest.mark.parametrize("mean", [30.0, 75.0, 400.0])
def test_many_counts_hold_the_truth_as_often_as_they_say(mean):
    counts = np.arange(1, 1000)
    down, up = poisson.logarithmic_errors(counts)
    holds = (counts * np.exp(-down) <= mean) & (mean <= counts * np.exp(up))
    assert stats.poisson.pmf(counts, mean)[holds].sum() == pytest.approx(0.68, abs=0.04)
