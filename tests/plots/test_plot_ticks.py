"""Round numbers of axes, contours and labels."""

import numpy as np
import pytest

from muysc_qgis.plots import ticks
from muysc_qgis.quantities import QUANTITIES


@pytest.mark.parametrize(
    ("span", "count", "step"),
    [
        (1.0, 10, 0.1),
        (1.0, 9, 0.2),
        (22.0, 5, 5.0),
        (1450.0, 9, 200.0),
        (3e-4, 3, 1e-4),
        (7e5, 7, 1e5),
    ],
)
def test_round_step(span, count, step):
    assert ticks.round_step(span, count) == pytest.approx(step)


def test_multiples_include_both_ends():
    assert ticks.multiples(-0.3, 0.3, 0.1) == pytest.approx([-0.3, -0.2, -0.1, 0, 0.1, 0.2, 0.3])
    assert ticks.multiples(1.1, 1.9, 1.0).size == 0


@pytest.mark.parametrize("span", [1e3, 1e-1, 1e-3])
def test_a_narrow_range_far_from_zero_has_few_multiples(span):
    low, high = 1.81e12, 1.81e12 + span
    step = ticks.round_step(high - low, 5)
    assert 1 <= ticks.multiples(low, high, step).size <= 6


@pytest.mark.parametrize("span", [0.5, 1.0, 8.0, 22.0, 42.0, 90.0, 180.0, 360.0])
def test_zenith_and_elevation_ticks_stand_on_the_same_lines(span):
    zenith = ticks.angle_ticks(80.0 - span, 80.0, 8)
    elevation = ticks.angle_ticks(10.0, 10.0 + span, 8)
    assert len(zenith) >= 3
    assert 90.0 - zenith[::-1] == pytest.approx(elevation, abs=1e-9)


@pytest.mark.parametrize(
    ("low", "high"), [(1, 1e3), (3.7e-3, 3.7), (36, 2800), (310, 390), (1e-9, 1e-6)]
)
def test_a_logarithmic_scale_has_at_least_three_ticks_inside(low, high):
    positions = ticks.logarithmic_ticks(low, high)
    assert len(positions) >= 3
    assert np.all((positions >= low * 0.999999) & (positions <= high * 1.000001))
    assert np.all(np.diff(positions) > 0)


def test_thickness_contours_step_by_round_lengths():
    values = np.linspace(0.0, 1450.0, 300)
    assert ticks.contour_levels(values, QUANTITIES["thickness"]) == pytest.approx(
        np.arange(200.0, 1450.0, 200.0)
    )


def test_flux_contours_are_decades():
    values = np.array([0.0, np.nan, 3e-3, 250.0])
    assert ticks.contour_levels(values, QUANTITIES["flux"]) == pytest.approx(
        [0.01, 0.1, 1, 10, 100]
    )


@pytest.mark.parametrize("values", [[], [np.nan], [500.0, 500.0], [0.0, 0.0]])
def test_no_contours_where_nothing_changes(values):
    for name in ("thickness", "flux", "density"):
        assert ticks.contour_levels(np.array(values), QUANTITIES[name]).size == 0


@pytest.mark.parametrize(
    ("value", "label"),
    [
        (0, "0"), (-20.0, "−20"), (0.5, "0.5"), (1000.0, "1000"), (30_000.0, "30\u202f000"),
        (10.0**-4, "0.0001"), (1e-5, "10⁻⁵"), (2e-7, "2·10⁻⁷"), (1e6, "10⁶"), (-3e8, "−3·10⁸"),
    ],
)  # fmt: skip
def test_number_labels(value, label):
    assert ticks.number_label(value) == label


@pytest.mark.parametrize(
    ("azimuth", "label"),
    [(-10.0, "350°"), (360.0, "0°"), (370.0, "10°"), (-1e-9, "0°"), (39.5, "39.5°")],
)
def test_azimuths_read_from_0_to_360(azimuth, label):
    assert ticks.azimuth_label(azimuth) == label


def test_compass_points_across_north():
    assert ticks.compass_points(330.0, 400.0) == [
        (337.5, "NNW"), (360.0, "N"), (382.5, "NNE"),
    ]  # fmt: skip
    assert ticks.compass_points(-50.0, 10.0) == [(-45.0, "NW"), (-22.5, "NNW"), (0.0, "N")]
    assert [name for _, name in ticks.compass_points(1.0, 361.0)] == [
        "NE", "E", "SE", "S", "SW", "W", "NW", "N",
    ]  # fmt: skip
