"""Trajectories taken together."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.telescope.merging import check_merge, merge_sum, merged_offsets


@pytest.mark.parametrize("bars", [1, 2, 5, 30])
@pytest.mark.parametrize("merge", [1, 3, 5, 7])
def test_nothing_is_lost(bars, merge):
    if merge > 2 * bars - 1:
        pytest.skip("more than there are")
    values = np.random.default_rng(0).random((3, 2 * bars - 1, 2 * bars - 1))
    merged = merge_sum(values, merge)
    offsets = merged_offsets(bars, merge)
    assert merged.shape == (3, len(offsets), len(offsets))
    np.testing.assert_allclose(merged.sum(axis=(1, 2)), values.sum(axis=(1, 2)))
    assert abs(offsets).max() - merge // 2 <= bars - 1


def test_each_bin_holds_the_trajectories_around_it():
    m = np.arange(-4, 5.0)
    values = np.ones((9, 1)) * m
    merged = merge_sum(values, 3)
    np.testing.assert_array_equal(merged_offsets(5, 3), [-3, 0, 3])
    np.testing.assert_allclose(merged[1], 3 * np.array([-4 - 3 - 2, 0, 9]))


def test_the_rim_keeps_what_is_left_over():
    values = np.arange(-2, 3.0) * np.ones((5, 1))
    np.testing.assert_array_equal(merged_offsets(3, 3), [-3, 0, 3])
    np.testing.assert_allclose(merge_sum(values, 3)[1], [-6, 0, 6])


def test_an_unknown_member_spoils_its_bin():
    values = np.ones((9, 9))
    values[0, 0] = np.nan
    assert np.count_nonzero(np.isnan(merge_sum(values, 3))) == 1


@pytest.mark.parametrize("merge", [0, 2, -1, 11, 1.5])
def test_impossible_bins_are_refused(merge):
    with pytest.raises(MuyscError, match="odd number from 1 to 9"):
        check_merge(5, merge)
