"""Means that outliers do not rule, pixels of which one ray says too little, limits beside sky."""

import numpy as np
import pytest

from muysc_qgis.forward.sub_rays import SubRays
from muysc_qgis.measurement.density import Flag, measure_density
from muysc_qgis.measurement.judgement import check_sky, chi_squared, impossible
from muysc_qgis.measurement.mean import mean_density
from muysc_qgis.measurement.mixed import (
    BOX_VARIANCE,
    beside_sky,
    bias_of_one_ray,
    mixed_pixels,
)
from muysc_qgis.measurement.observation import from_counts, from_values
from muysc_qgis.measurement.scene import Scene
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate

PHYSICS = Physics(flux_model="gaisser-tang")
ELEVATION = np.linspace(25.0, 4.0, 24)[:, None]
DENSITY = 2.2


def scene(**more):
    thickness = np.clip((23.0 - ELEVATION) * 45.0, 0, None) * np.ones(30)
    return Scene(thickness, ELEVATION, PHYSICS, 600.0, **more)


@pytest.mark.parametrize("kind", ["counts", "flux", "flux without errors"])
def test_a_few_pixels_that_cannot_be_right_do_not_rule_the_mean(kind):
    there = scene()
    flux = there.flux_at(DENSITY)
    generator = np.random.default_rng(3)
    exposure = 400 / np.median(flux[there.rock])
    counts = generator.poisson(flux * exposure).astype(float)
    wrong = there.rock & (generator.random(flux.shape) < 0.03)
    counts[wrong] = np.rint(counts[wrong] * generator.choice([0.05, 20.0], wrong.sum()))
    if kind == "counts":
        seen = from_counts(counts, exposure, 1.0, 0.95)
    else:
        errors = None if "without" in kind else np.sqrt(np.maximum(counts, 1)) / exposure
        seen = from_values(counts / exposure, errors, 0.95)
    found = measure_density(seen, there)
    mean = mean_density(seen, there, found)
    assert mean.density == pytest.approx(DENSITY, rel=0.01)
    if kind != "flux without errors":
        assert mean.error < 0.01 * DENSITY
        assert chi_squared(found, mean.density) > 1.5


def test_the_bias_of_one_ray_is_that_of_the_mean_flux_over_a_pixel():
    # The logarithm of the thickness grows by a tenth from pixel to pixel.
    thickness = 300.0 * np.exp(0.1 * np.arange(9))[None, :] * np.ones((3, 1))
    within = np.exp(0.1 * ((np.arange(2001) + 0.5) / 2001 - 0.5))
    opacity = thickness[0, 4] * within * DENSITY * 100
    flux = attenuate(opacity, np.full(2001, 12.0), PHYSICS).flux
    one, more = attenuate(
        thickness[0, 4] * DENSITY * 100 * np.array([1.0, 1.001]), np.full(2, 12.0), PHYSICS
    ).flux
    slope = -np.log(more / one) / np.log(1.001)
    expected = np.log(flux.mean() / one) / slope
    found = bias_of_one_ray(thickness, np.full(thickness.shape, slope), BOX_VARIANCE)
    # A power of the thickness, which the flux falls faster than: no less, and less than twice.
    assert expected < found[1, 4] < 2 * expected


def test_pixels_beside_the_sky_are_those_within_reach():
    thickness = np.array([[0.0, 0.0, 0.0], [5.0, 0.0, 5.0], [5.0, 5.0, 5.0], [5.0, 5.0, np.nan]])
    one = np.array([[0, 0, 0], [1, 0, 1], [1, 1, 1], [0, 0, 0]], bool)
    np.testing.assert_array_equal(beside_sky(thickness, 1), one)
    assert beside_sky(thickness, 2)[3, :2].all()
    assert not beside_sky(thickness, 2)[3, 2]


def test_more_counts_leave_fewer_pixels_to_one_ray():
    there = scene()
    flux = there.flux_at(DENSITY)
    numbers = []
    for per_pixel in (10, 1e3, 1e6):
        exposure = per_pixel / np.median(flux[there.rock])
        seen = from_counts(flux * exposure, exposure, 1.0, 0.95, expected=True)
        found = measure_density(seen, there)
        mixed = mixed_pixels(found, there, BOX_VARIANCE)
        numbers.append(int(mixed.sum()))
        again = measure_density(seen, there.without(mixed))
        assert again.count(Flag.MIXED) == mixed.sum()
        assert np.isnan(again.density[mixed]).all()
    assert numbers[0] < numbers[1] < numbers[2]


def half_sky(counts_factor, minimum=0.0):
    """Return what one pixel says half of which sees the sky, for counts over those expected."""
    rays = SubRays(
        (1, 1), np.zeros(2), np.full(2, 10.0), np.array([0.0, 300.0]), np.zeros(2, np.uint8),
        np.array([False, True]), np.zeros(2, np.int32), np.arange(2, dtype=np.int32),
        np.full(2, 0.5), np.zeros(1, bool),
    )  # fmt: skip
    there = Scene(rays.mean_thickness_m, np.full((1, 1), 10.0), PHYSICS, 0.0, rays=rays)
    counts = np.rint(there.flux_at(DENSITY) * 5e4 * counts_factor)
    seen = from_counts(counts, 5e4, 1.0, 0.95)
    return there, measure_density(seen, there, minimum)


@pytest.mark.parametrize("minimum", [0.0, 20.0])
def test_fewer_muons_than_come_past_the_rock_leave_a_lower_limit(minimum):
    there, found = half_sky(1.0, minimum)
    assert found.flags[0, 0] == Flag.MEASURED
    assert found.density[0, 0] == pytest.approx(DENSITY, rel=0.1)
    there, found = half_sky(0.985 * there.sky_flux[0, 0] / there.flux_at(DENSITY)[0, 0], minimum)
    assert found.flags[0, 0] in (Flag.LOWER_LIMIT, Flag.NO_ANSWER)
    assert np.isnan(found.error[0, 0])


def test_the_sky_tells_an_acceptance_that_is_wrong():
    there = scene()
    flux = there.flux_at(DENSITY)
    seen = from_counts(np.rint(flux * 1000.0), 2000.0, 1.0, 0.95)
    sky = check_sky(seen, there, there.thickness_m == 0)
    assert sky.pixels == np.count_nonzero(there.thickness_m == 0)
    assert sky.ratio == pytest.approx(0.5, rel=0.01)
    assert 0 < sky.error < 0.01
    light, dense = impossible(measure_density(seen, there))
    # Half the flux is more than half as much rock where there is little.
    assert light == 0
    assert dense == 30
