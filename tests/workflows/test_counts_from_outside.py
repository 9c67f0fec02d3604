"""Counts drawn by means that the product does not use, and what it makes of them."""

import numpy as np
import pytest

from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.tomography.counting import CountPriors


@pytest.fixture(scope="module")
def scene():
    """Return a small world of three telescopes, its terrain, what they count, and the fits."""
    from tools import count_experiments, count_world
    from tools.mountain_counts import Terrain

    world = count_world.build(TelescopeGeometry(6, 6, 12.0, 115.0), 3, 6)
    terrain = Terrain(str(count_world.DEM))
    means = world.expected(terrain)
    return count_world, world, terrain, means, count_experiments.Fits(world)


def test_what_is_expected_is_what_is_counted(scene):
    _, world, _, means, fits = scene
    model = fits.laid.model
    found = model.expected(np.full(model.lattice.count, 2.65), 2.65)
    counted = np.concatenate([one.ravel() for one in means])[fits.laid.pixel]
    off = (found - counted) / np.sqrt(counted)
    assert np.sqrt(np.mean((found / counted - 1) ** 2)) < 0.02
    assert np.median(np.abs(off)) < 0.2
    assert len(world.sites) == 3


def test_a_uniform_mountain_comes_back_from_noisy_counts(scene):
    count_world, _, _, means, fits = scene
    found = fits.fit(count_world.poisson(means, 1), CountPriors(2.5))
    values = found.densities[fits.seen]
    assert values.std() < 0.08
    assert values.mean() == pytest.approx(2.65, abs=0.06)
    factors = [band.after for band in found.bands if band.name == "factor"]
    assert factors == pytest.approx([1.0] * 3, abs=0.01)


def test_a_station_that_counts_less_is_found(scene):
    count_world, _, _, means, fits = scene
    less = [means[0], 0.95 * means[1], means[2]]
    found = fits.fit(count_world.poisson(less, 2), CountPriors(2.65))
    bands = {(band.name, band.station): band for band in found.bands}
    flux = bands["flux", -1].after
    assert bands["factor", 1].after * flux == pytest.approx(0.95, abs=0.01)
    assert bands["factor", 0].after * flux == pytest.approx(1.0, abs=0.01)
