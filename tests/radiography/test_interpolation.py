"""Curves through points, against cubics in closed form and scipy's splines."""

import numpy as np
import pytest

from muysc_qgis.radiography.interpolation import HermiteCurve, spline_slopes


@pytest.fixture
def knots():
    return np.cumsum(np.random.default_rng(7).uniform(0.1, 3.0, 40))


def test_a_cubic_is_its_own_spline(knots):
    cubic = np.polynomial.Polynomial([2.0, -1.0, 0.3, 0.05])
    slopes = spline_slopes(knots, cubic(knots))
    np.testing.assert_allclose(slopes, cubic.deriv()(knots), rtol=1e-10)
    between = np.linspace(knots[0], knots[-1], 1001)
    curve = HermiteCurve.through(knots, cubic(knots))
    np.testing.assert_allclose(curve(between), cubic(between), rtol=1e-10)


@pytest.mark.parametrize("count", [4, 5, 40])
def test_slopes_are_those_of_scipy(knots, count):
    interpolate = pytest.importorskip("scipy.interpolate")
    x, y = knots[:count], np.sin(knots[:count])
    theirs = interpolate.CubicSpline(x, y).derivative()(x)
    np.testing.assert_allclose(spline_slopes(x, y), theirs, rtol=0, atol=1e-12)


def test_beyond_the_knots_nothing_is_known(knots):
    curve = HermiteCurve.through(knots, knots)
    assert np.isnan(curve(np.array([knots[0] - 0.01, knots[-1] + 0.01]))).all()
