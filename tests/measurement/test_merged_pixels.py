"""Merging keeps every pixel, reaches the minimum and stays among neighbours."""

import numpy as np
import pytest

from muysc_qgis.measurement.regions import errors_of_pixels, merge_pixels


@pytest.fixture
def picture():
    generator = np.random.default_rng(5)
    counts = generator.poisson(np.geomspace(0.3, 60, 30)[:, None] * np.ones((30, 40)))
    usable = generator.random((30, 40)) > 0.1
    usable[:6, 10:25] = False
    return counts.astype(float), usable


@pytest.mark.parametrize("minimum", [1, 20, 300])
def test_every_region_has_the_minimum(picture, minimum):
    counts, usable = picture
    label = merge_pixels(counts, usable, minimum)
    assert np.array_equal(label >= 0, usable)
    sums = np.bincount(label[usable], counts[usable])
    assert sums.min() >= minimum
    assert sums.sum() == counts[usable].sum()


@pytest.mark.parametrize("minimum", [20, 300])
def test_regions_are_rectangles_without_others_in_them(picture, minimum):
    counts, usable = picture
    label = merge_pixels(counts, usable, minimum)
    for number in range(label.max() + 1):
        rows, columns = np.nonzero(label == number)
        box = label[rows.min() : rows.max() + 1, columns.min() : columns.max() + 1]
        assert set(np.unique(box)) <= {-1, number}


def test_regions_are_no_larger_than_needed(picture):
    counts, usable = picture
    label = merge_pixels(counts, usable, 20)
    sums = np.bincount(label[usable], counts[usable])
    # A region with far more than twice the minimum could have been cut, unless a single
    # pixel holds nearly all of it.
    largest = np.array([counts[label == n].max() for n in range(len(sums))])
    assert np.all(sums - largest < 4 * 20)


def test_pixels_that_reach_the_minimum_alone_stay_alone():
    label = merge_pixels(np.full((4, 5), 9.0), np.ones((4, 5), bool), 9)
    assert len(np.unique(label)) == 20


def test_too_few_counts_make_one_region():
    label = merge_pixels(np.ones((3, 3)), np.ones((3, 3), bool), 50)
    assert np.all(label == 0)


def test_nothing_usable_makes_no_region():
    assert np.all(merge_pixels(np.ones((3, 3)), np.zeros((3, 3), bool), 5) == -1)


def test_pixels_of_a_region_weigh_as_much_as_its_one_measurement(picture):
    """Σ 1/σ² over a region is 1/σ² of what it measured; pixels on their own stay as they are."""
    label = merge_pixels(*picture, 50)
    measured = np.random.default_rng(2).uniform(0.1, 0.9, label.max() + 1)
    errors = errors_of_pixels(np.append(measured, 0.4)[label], label)
    weights = np.bincount(label[label >= 0], errors[label >= 0] ** -2)
    np.testing.assert_allclose(weights, measured**-2)
    assert np.bincount(label[label >= 0]).max() > 10
    assert np.all(errors[label < 0] == 0.4)
    alone = np.full((2, 2), -1)
    assert np.all(errors_of_pixels(np.full((2, 2), 0.4), alone) == 0.4)
