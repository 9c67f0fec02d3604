"""The choice among candidates."""

from itertools import combinations

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.survey.choice import best_sites, coverage, telescope_set


def test_the_best_are_apart_from_each_other():
    score = np.array([0.5, 0.9, 0.8, np.nan, 0.0, 0.7])
    x = np.array([0.0, 100.0, 150.0, 500.0, 600.0, 400.0])
    chosen = best_sites(score, x, np.zeros(6), 10, 100.0)
    # 0.8 lies 50 m from 0.9; unknown and 0 are none.
    np.testing.assert_array_equal(chosen, [1, 5, 0])
    np.testing.assert_array_equal(best_sites(score, x, np.zeros(6), 2, 0.0), [1, 2])


def test_one_telescope_covers_a_triangle():
    """The mean over 360° of a triangle of height s and half width w is s w/360."""
    covered = coverage(np.array([10.0]), np.array([0.6]), 90.0)
    assert covered.mean() == pytest.approx(0.6 * 90 / 360, rel=1e-3)
    assert covered[[9, 10]] == pytest.approx(0.6 * (1 - 0.5 / 90))
    assert covered[280] == pytest.approx(0.6 * (1 - 89.5 / 90))  # 280.5°, across north
    assert np.all(covered[101:279] == 0)


def test_equal_sites_do_not_overlap_while_there_is_room():
    """Each of two triangles side by side adds s w/360; a third finds less room."""
    azimuth = np.arange(0.25, 360.0, 1.0)
    _, means = telescope_set(azimuth, np.full(360, 0.8), 3, 60.0)
    np.testing.assert_allclose(means[:2], [0.8 * 60 / 360, 2 * 0.8 * 60 / 360], rtol=1e-3)
    assert means[1] < means[2] <= 3 * means[0] * (1 + 1e-12)


def test_the_set_is_within_the_bound_of_the_best_one():
    """Against all sets of three; the bound is 1 − 1/e (Nemhauser et al. 1978)."""
    rng = np.random.default_rng(3)
    for _ in range(5):
        azimuth = np.sort(rng.choice(360, 12, replace=False)) + 0.5
        score = rng.uniform(0.1, 1.0, 12)
        chosen, means = telescope_set(azimuth, score, 3, 120.0)
        best = max(
            coverage(azimuth[list(some)], score[list(some)], 120.0).mean()
            for some in combinations(range(12), 3)
        )
        assert (1 - 1 / np.e) * best <= means[-1] <= best * (1 + 1e-12)
        assert means[-1] == pytest.approx(coverage(azimuth[chosen], score[chosen], 120.0).mean())
        assert chosen[0] == np.argmax(score)


def test_telescopes_that_add_nothing_are_left_out():
    azimuth, score = np.array([10.0, 10.2]), np.array([0.5, 0.4])
    chosen, means = telescope_set(azimuth, score, 3, 90.0)
    np.testing.assert_array_equal(chosen, [0])
    assert len(means) == 1


def test_a_site_between_two_azimuths_covers_some_of_both():
    chosen, means = telescope_set(np.array([10.5]), np.array([0.7]), 1, 1e-9)
    assert chosen == [0]
    assert means == pytest.approx([2 * 0.7 * 0.5 / 360])


def test_an_impossible_width_is_refused():
    with pytest.raises(MuyscError, match="angle of 400°"):
        telescope_set(np.array([1.0]), np.array([1.0]), 1, 400.0)
