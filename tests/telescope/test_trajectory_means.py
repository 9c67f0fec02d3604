"""Means over trajectories: partition of the acceptance, order of convergence."""

import numpy as np
import pytest

from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.telescope.quadrature import trajectory_means


def flux(x, y):
    """Return something as steep as a flux, smooth, and of no symmetry."""
    return np.exp(2.0 * y - 0.7 * x) / (1 + (x - 0.2) ** 2)


def rate_of_whole_planes(geometry, field):
    """Integrate field × overlap of the planes / (1 + x² + y²)² over all directions."""
    node, weight = np.polynomial.legendre.leggauss(60)
    a, b = geometry.bars_x * geometry.step, geometry.bars_y * geometry.step
    total = 0.0
    # The overlap has a kink on both axes: one quadrant at a time.
    for sign_x in (-1, 1):
        for sign_y in (-1, 1):
            x, y = np.meshgrid(sign_x * a * (node + 1) / 2, sign_y * b * (node + 1) / 2)
            overlap = (a - abs(x)) * (b - abs(y)) * geometry.separation_cm**2
            inner = field(x, y) * overlap / (1 + x**2 + y**2) ** 2
            total += a * b / 4 * weight @ inner @ weight
    return total


def stacked(*functions):
    return lambda x, y: np.stack([function(x, y) for function in functions])


def test_a_constant_stays_what_it_is():
    geometry = TelescopeGeometry(5, 3, 4.0, 50.0)
    means = trajectory_means(geometry, stacked(lambda x, y: np.full(x.shape, 7.0)))
    assert means.shape == (1, 5, 9)
    np.testing.assert_allclose(means, 7.0)


@pytest.mark.parametrize("rough", [False, True])
def test_a_linear_function_has_the_value_in_the_middle(rough):
    # Where the obliquity is even: on the axis.
    geometry = TelescopeGeometry(1, 1, 10.0, 50.0)
    cells = np.full((2, 2), rough)
    means = trajectory_means(geometry, stacked(lambda x, y: 3 + x - 2 * y), cells)
    assert means[0, 0, 0] == pytest.approx(3)


def test_trajectories_make_up_the_whole_telescope_to_fourth_order():
    errors = []
    for bars in (4, 8, 16, 32):
        geometry = TelescopeGeometry(bars, bars, 80.0 / bars, 100.0)
        means = trajectory_means(geometry, stacked(flux))[0]
        rate = np.sum(means * trajectories(geometry).acceptance_cm2_sr)
        errors.append(abs(rate / rate_of_whole_planes(geometry, flux) - 1))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.all(orders > 3.7), (errors, orders)
    assert errors[1] < 1e-4


def test_rough_cells_agree_with_smooth_ones_where_it_is_smooth():
    geometry = TelescopeGeometry(12, 12, 4.0, 100.0)
    rng = np.random.default_rng(3)
    smooth = trajectory_means(geometry, stacked(flux))
    for rough in (np.ones((24, 24), bool), rng.random((24, 24)) < 0.3):
        np.testing.assert_allclose(
            trajectory_means(geometry, stacked(flux), rough), smooth, rtol=5e-4
        )


def test_one_trajectory_against_brute_force():
    geometry = TelescopeGeometry(4, 4, 10.0, 60.0)
    m, n = 2, 1
    share = (np.arange(2000) + 0.5) / 1000 - 1
    x, y = np.meshgrid(geometry.step * (m + share), geometry.step * (n + share))
    weight = np.outer(1 - abs(share), 1 - abs(share)) / (1 + x**2 + y**2) ** 2
    expected = np.sum(weight * flux(x, y)) / np.sum(weight)
    rough = np.ones((8, 8), bool)
    for cells, tolerance in ((None, 2e-3), (rough, 1e-6)):
        mean = trajectory_means(geometry, stacked(flux), cells)[0, 3 - n, 3 + m]
        assert mean == pytest.approx(expected, rel=tolerance)


def test_a_step_is_shared_out_between_trajectories():
    # Half the sky dark: rough cells along the border, first order in their nodes.
    geometry = TelescopeGeometry(6, 6, 5.0, 50.0)
    border = 0.037

    def step(x, y):
        return np.where(y > border + 0.3 * x, 1.0, 0.0)

    def mean_error(nodes):
        means = trajectory_means(geometry, stacked(step), np.ones((12, 12), bool), nodes)[0]
        return np.sqrt(np.mean((means - reference) ** 2))

    reference = trajectory_means(geometry, stacked(step), np.ones((12, 12), bool), 96)[0]
    errors = [mean_error(nodes) for nodes in (4, 8, 16)]
    assert errors[0] > errors[1] > errors[2]
    assert errors[2] < 2e-3


def test_what_cannot_be_known_spoils_its_own_trajectories_alone():
    geometry = TelescopeGeometry(4, 4, 10.0, 100.0)
    means = trajectory_means(geometry, stacked(lambda x, y: np.where(y < -0.149, np.nan, 1.0)))[0]
    # Rows n = 3 … −3: n = −1 reaches down to −0.2, its lower cells' middles to −0.15.
    assert np.all(np.isfinite(means[:4]))
    assert np.all(np.isnan(means[4:]))
