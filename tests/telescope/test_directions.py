"""Tangents to directions and back."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.telescope.directions import Pointing


def test_on_the_horizon_tangents_are_plain_angles():
    azimuth, elevation = Pointing(30.0, 0.0).sky(np.array([0.0, 1.0, -1.0]), np.zeros(3))
    np.testing.assert_allclose(azimuth, [30, 75, -15])
    np.testing.assert_allclose(elevation, 0, atol=1e-12)
    azimuth, elevation = Pointing(30.0, 0.0).sky(np.zeros(2), np.array([1.0, -1.0]))
    np.testing.assert_allclose(azimuth, 30)
    np.testing.assert_allclose(elevation, [45, -45])


def test_above_the_horizon_the_middle_column_adds_up():
    _, elevation = Pointing(200.0, 20.0).sky(0.0, np.tan(np.radians([5.0, -7.0])))
    np.testing.assert_allclose(elevation, [25, 13])


def test_a_roll_turns_clockwise_seen_along_the_boresight():
    azimuth, elevation = Pointing(90.0, 0.0, 90.0).sky(np.array([0.1, 0.0]), np.array([0.0, 0.1]))
    # The telescope's right points down, its up to the right (south, looking east).
    np.testing.assert_allclose(elevation, [-np.degrees(np.arctan(0.1)), 0], atol=1e-12)
    np.testing.assert_allclose(azimuth, [90, 90 + np.degrees(np.arctan(0.1))])


@pytest.mark.parametrize("pointing", [(10, 5, 0), (350, 60, 25), (180, 89, -120), (0, -30, 10)])
def test_there_and_back(pointing):
    telescope = Pointing(*map(float, pointing))
    x, y = np.random.default_rng(1).uniform(-1.5, 1.5, (2, 500))
    back = telescope.plane(*telescope.sky(x, y))
    np.testing.assert_allclose(back, [x, y], atol=1e-9)


def test_axes_are_square_to_each_other():
    axes = Pointing(123.0, 34.0, 56.0).axes()
    np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-12)


def test_behind_the_telescope_there_is_no_tangent():
    x, y = Pointing(0.0, 10.0).plane(np.array([180.0]), np.array([10.0]))
    assert np.isnan(x)
    assert np.isnan(y)


@pytest.mark.parametrize(
    ("pointing", "words"),
    [
        ((0.0, 91.0), "boresight elevation of 91° is impossible; give an angle from −90 to 90°"),
        ((0.0, -90.5), "boresight elevation of -90.5°"),
        ((400.0, 0.0), "boresight azimuth of 400°"),
        ((0.0, np.nan), "boresight elevation of nan°"),
        ((0.0, 0.0, 720.0), "roll of 720°"),
    ],
)
def test_impossible_angles_are_refused(pointing, words):
    with pytest.raises(MuyscError, match=words):
        Pointing(*pointing)
