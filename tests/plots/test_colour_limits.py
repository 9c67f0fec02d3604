"""The ends of the colour scales."""

import subprocess
import sys

import numpy as np
import pytest

from muysc_qgis.plots.limits import colour_limits
from muysc_qgis.quantities import QUANTITIES


@pytest.mark.parametrize("name", QUANTITIES)
@pytest.mark.parametrize(
    "values",
    [
        np.zeros((3, 4)),
        np.full((3, 4), np.nan),
        np.full((3, 4), 7.0),
        np.full((1, 1), 1e-12),
        np.array([[0.0, np.nan], [5.0, np.inf]]),
        np.array([[-3.0, -1.0]]),
        np.empty((0, 0)),
        np.array([[1, 2], [3, 4]]),
        np.geomspace(1e-9, 1e9, 1000),
    ],
)
def test_limits_always_make_a_scale(name, values):
    low, high = colour_limits(values, QUANTITIES[name])
    assert np.isfinite([low, high]).all()
    assert low < high
    assert low > 0 or not QUANTITIES[name].logarithmic


@pytest.mark.parametrize(
    ("name", "decades"),
    [("thickness", 2), ("opacity", 2), ("flux", 4), ("exposure", 4), ("minimum_energy", 4)],
)
def test_a_logarithmic_scale_spans_no_more_than_its_decades(name, decades):
    low, high = colour_limits(np.geomspace(1e-4, 1e4, 10_001), QUANTITIES[name])
    assert np.log10(high / low) == pytest.approx(decades)


def test_thickness_keeps_its_upper_decades():
    values = np.geomspace(0.01, 2000.0, 10_001)
    low, high = colour_limits(values, QUANTITIES["thickness"])
    assert high == pytest.approx(2000.0, rel=0.07)
    assert low == pytest.approx(high / 100)


@pytest.fixture
def mountain():
    """Half sky, half rock whose flux falls evenly by five and a half decades."""
    return np.concatenate([np.full(5000, 120.0), 120.0 / np.geomspace(1.0, 10**5.5, 5000)])


@pytest.mark.parametrize("name", ["flux", "transmission", "flux_minimum"])
def test_the_thickest_rock_keeps_its_colours_and_the_sky_is_of_one(mountain, name):
    low, high = colour_limits(mountain, QUANTITIES[name])
    assert low == pytest.approx(mountain.min(), rel=0.2)
    assert high == pytest.approx(1e4 * low)
    assert high < 120.0


def test_the_exposure_behind_the_thickest_rock_keeps_its_colours(mountain):
    low, high = colour_limits(1.0 / mountain, QUANTITIES["exposure"])
    assert high == pytest.approx(1.0 / mountain.min(), rel=0.2)
    assert low == pytest.approx(high / 1e4)


def test_a_scale_begins_two_and_a_half_decades_from_the_sky_at_most():
    values = np.geomspace(1e-6, 1e6, 100_001)
    low, high = colour_limits(values, QUANTITIES["flux"])
    assert (low, high) == pytest.approx((10**-0.5, 10**3.5), rel=0.2)
    low, high = colour_limits(values, QUANTITIES["exposure"])
    assert (low, high) == pytest.approx((10**-3.5, 10**0.5), rel=0.2)


def test_a_range_that_fits_is_kept_whole():
    values = np.array([20.0, 50.0, 100.0, 900.0])
    assert colour_limits(values, QUANTITIES["thickness"]) == (20.0, 900.0)
    assert colour_limits(values, QUANTITIES["density"]) == (20.0, 900.0)


def test_sky_and_unknown_pixels_do_not_move_the_thickness_scale():
    rock = np.linspace(100.0, 900.0, 50)
    crowded = np.concatenate([rock, np.zeros(5000), np.full(5000, np.nan), [np.inf]])
    quantity = QUANTITIES["thickness"]
    assert colour_limits(crowded, quantity) == colour_limits(rock, quantity)


def test_a_few_extreme_pixels_do_not_take_the_contrast():
    values = np.concatenate([np.linspace(2.0, 3.0, 1000), [-1e6, 1e6]])
    low, high = colour_limits(values, QUANTITIES["density"])
    assert 2.0 <= low < 2.02
    assert 2.98 < high <= 3.0


def test_a_single_value_stands_in_the_middle_of_its_scale():
    low, high = colour_limits(np.full(9, 400.0), QUANTITIES["flux"])
    assert low < 400.0 < high
    assert np.sqrt(low * high) == pytest.approx(400.0)
    low, high = colour_limits(np.full(9, 2.65), QUANTITIES["density"])
    assert (low + high) / 2 == pytest.approx(2.65)


def test_importing_the_plots_loads_no_heavy_library(data_folder):
    code = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "from muysc_qgis.plots import limits, panel, overview_map, profile, report\n"
        "heavy = {'matplotlib', 'jinja2', 'scipy', 'osgeo'} & set(sys.modules)\n"
        "sys.exit(', '.join(sorted(heavy)) or 0)\n"
    )
    root = str(data_folder.parent.parent)
    run = subprocess.run([sys.executable, "-c", code, root], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
