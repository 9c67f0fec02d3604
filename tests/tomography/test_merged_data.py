"""Pixels that carry one measurement are one datum: in weights, in χ² and where methods stop."""

import numpy as np
import pytest

from muysc_qgis.measurement.regions import errors_of_pixels, shares_of_pixels


def test_shares_add_up_to_one_in_each_region():
    region = np.array([[0, 0, 0, 1], [1, -1, -1, 2]])
    share = shares_of_pixels(region)
    assert np.bincount(region[region >= 0], share[region >= 0]) == pytest.approx(1)
    assert np.all(share[region < 0] == 1)
    error = errors_of_pixels(np.full(region.shape, 0.3), region)
    assert error == pytest.approx(0.3 / np.sqrt(share))


def test_chi_squared_counts_regions_not_pixels():
    from muysc_qgis.workflows.tomography_result import _chi_squared

    rng = np.random.default_rng(1)
    region = np.repeat(np.arange(4000), 7)
    errors = errors_of_pixels(np.ones(region.size), region)
    residual = rng.standard_normal(4000)[region]

    class System:
        pass

    system = System()
    system.errors = errors
    found = _chi_squared(system, residual, shares_of_pixels(region), slice(None))
    assert found == pytest.approx(1.0, abs=0.1)
    assert _chi_squared(system, residual, np.ones(region.size), slice(None)) < 0.2
