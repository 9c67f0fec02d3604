"""What is simulated at a density and measured gives the density back, within its errors."""

import numpy as np
import pytest

from muysc_qgis.measurement.density import (
    Flag,
    measure_density,
    model_densities,
)
from muysc_qgis.measurement.mean import mean_density
from muysc_qgis.measurement.observation import from_count_ratio, from_counts, from_values
from muysc_qgis.measurement.scene import Scene
from muysc_qgis.measurement.uniform import expected_of_pixels, uniform_density
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate

DENSITY = 2.2
ALTITUDE_M = 600.0
ELEVATION_DEG = np.linspace(25.0, 2.0, 24)[:, None]
DRAWS = 12


def thickness():
    """Return a hill with sky above it, 0 to 1.1 km of rock."""
    across = 1.0 + 0.25 * np.sin(np.arange(30) / 5.0)
    return np.clip((23.0 - ELEVATION_DEG) * 45.0 * across, 0.0, None)


def scene(uncertainty=0.0, **physics):
    return Scene(thickness(), ELEVATION_DEG, Physics(**physics), ALTITUDE_M, uncertainty)


def muons(there):
    opacity = there.thickness_m * DENSITY * 100.0
    return attenuate(opacity, ELEVATION_DEG, there.physics, ALTITUDE_M)


def draws(there, per_pixel, seed):
    """Yield counts with Poisson noise, and the exposure that gives a median of them."""
    flux = muons(there).flux
    exposure = per_pixel / np.median(flux[there.rock])
    generator = np.random.default_rng(seed)
    for _ in range(DRAWS):
        yield generator.poisson(flux * exposure).astype(float), exposure


@pytest.mark.parametrize(
    "physics",
    [
        {},
        {"flux_model": "reyna-bugaev", "energy_loss": "lesparre", "straggling": False},
        {"flux_model": "guan", "material": "andesite", "detection_threshold_gev": 1.0},
    ],
)
@pytest.mark.parametrize("kind", ["flux", "transmission"])
def test_without_noise_the_density_comes_back(physics, kind):
    there = scene(**physics)
    seen = muons(there)
    if kind == "flux":
        observation = from_values(seen.flux, None, 0.95)
    else:
        observation = from_values(seen.transmission, None, 0.95, ELEVATION_DEG)
    found = measure_density(observation, there)
    assert np.all(found.flags[there.rock] == Flag.MEASURED)
    np.testing.assert_allclose(found.density[there.rock], DENSITY, rtol=2e-3)
    assert np.isnan(found.density[~there.rock]).all()
    assert np.all(found.flags[~there.rock] == Flag.SKY)
    assert np.all(found.opacity(there.thickness_m)[~there.rock] == 0)


@pytest.mark.parametrize(("per_pixel", "minimum"), [(60, 0), (400, 0), (8, 30), (60, 100)])
def test_the_interval_holds_the_density_in_68_percent_of_pixels(per_pixel, minimum):
    there = scene()
    holds, within, total = 0, 0, 0
    for counts, exposure in draws(there, per_pixel, 20):
        found = measure_density(from_counts(counts, exposure, 1.0, 0.95), there, minimum)
        where = np.flatnonzero(found.flags == Flag.MEASURED)
        if minimum:
            # Pixels of one region have one density between them.
            where = where[np.unique(found.region.ravel()[where], return_index=True)[1]]
        density, error, lower, upper = (
            one.ravel()[where] for one in (found.density, found.error, found.lower, found.upper)
        )
        holds += np.count_nonzero((lower <= DENSITY) & (upper >= DENSITY))
        within += np.count_nonzero(np.abs(density - DENSITY) <= error)
        total += where.size
    assert holds / total == pytest.approx(0.68, abs=0.03)
    assert within / total == pytest.approx(0.68, abs=0.03)


def test_few_counts_promise_no_more_than_they_hold():
    there = scene()
    holds, total = 0, 0
    for counts, exposure in draws(there, 6, 21):
        found = measure_density(from_counts(counts, exposure, 1.0, 0.95), there)
        here = (found.flags == Flag.MEASURED) | (found.flags == Flag.LOWER_LIMIT)
        upper = np.where(np.isnan(found.upper), np.inf, found.upper)
        holds += np.count_nonzero((found.lower <= DENSITY) & (upper >= DENSITY) & here)
        total += np.count_nonzero(here)
    assert holds / total >= 0.68


def test_an_open_sky_run_cancels_the_acceptance():
    there = scene()
    # Pixels of very different acceptance; the sky was seen straight up by the same ones.
    acceptance = np.geomspace(0.2, 5.0, 30) * np.ones((24, 1))
    up = np.linspace(86.0, 63.0, 24)[:, None]
    rock = muons(there).flux * acceptance
    sky = attenuate(np.zeros((24, 30)), up, there.physics, ALTITUDE_M).flux * acceptance
    days, sky_days = 100 / np.median(rock[there.rock]), 3000 / np.median(sky)
    generator = np.random.default_rng(22)
    holds, total, pulls = 0, 0, []
    for _ in range(DRAWS):
        counts = generator.poisson(rock * days).astype(float)
        sky_counts = generator.poisson(sky * sky_days).astype(float)
        seen = from_count_ratio(counts, sky_counts, days / sky_days, up, 0.95)
        found = measure_density(seen, there)
        good = (found.flags == Flag.MEASURED) & (counts >= 20)
        holds += np.count_nonzero(np.abs(found.density - DENSITY)[good] <= found.error[good])
        total += np.count_nonzero(good)
        mean = mean_density(seen, there, found)
        pulls.append((mean.density - DENSITY) / mean.error)
    assert holds / total == pytest.approx(0.68, abs=0.03)
    assert abs(np.mean(pulls)) < 3 / np.sqrt(DRAWS)


@pytest.mark.parametrize("per_pixel", [2, 60])
def test_the_mean_is_unbiased_and_its_error_right(per_pixel):
    there = scene()
    pulls = []
    for counts, exposure in draws(there, per_pixel, 23):
        seen = from_counts(counts, exposure, 1.0, 0.95)
        mean = mean_density(seen, there, measure_density(seen, there))
        assert mean.error == mean.statistical_error
        pulls.append((mean.density - DENSITY) / mean.error)
    assert abs(np.mean(pulls)) < 3 / np.sqrt(DRAWS)
    assert 0.5 < np.std(pulls, ddof=1) < 1.7  # χ² with 11 degrees of freedom, 99.9 %


def test_the_weighted_mean_of_a_flux_has_its_textbook_error():
    there = scene()
    flux = muons(there).flux
    seen = from_values(flux, 0.05 * flux, 0.95)
    found = measure_density(seen, there)
    mean = mean_density(seen, there, found)
    assert mean.density == pytest.approx(DENSITY, rel=1e-3)
    weights = 1 / found.error[there.rock] ** 2
    # The densities have the errors of both ends of an interval of 5 %.
    assert mean.error == pytest.approx(weights.sum() ** -0.5, rel=1e-2)


def test_errors_are_counting_errors_over_the_slope_of_the_flux():
    """σρ/ρ = N^-1/2/|dlnI/dlnϱ|, with the slope from the flux itself."""
    there = scene()
    rock = there.rock
    opacity = there.thickness_m * DENSITY * 100.0
    step = 1e-3
    ends = [
        attenuate(opacity * (1 + side), ELEVATION_DEG, there.physics, ALTITUDE_M).flux
        for side in (-step, step)
    ]
    slope = np.log(ends[1] / ends[0])[rock] / np.log((1 + step) / (1 - step))
    counts = np.full(rock.shape, 10_000.0)
    seen = from_counts(counts, 1.0, counts / muons(there).flux, 0.95)
    found = measure_density(seen, there)
    expected = DENSITY * 1e-2 / np.abs(slope)
    np.testing.assert_allclose(found.error[rock], expected, rtol=0.01)


def test_the_uncertainty_of_the_model_adds_in_quadrature_and_stays_in_the_mean():
    counts, exposure = next(draws(scene(), 400, 24))
    seen = from_counts(counts, exposure, 1.0, 0.95)
    results = {}
    for uncertainty in (0.0, 0.1):
        there = scene(uncertainty)
        found = measure_density(seen, there)
        results[uncertainty] = found.error, mean_density(seen, there, found)
    (plain, mean), (whole, uncertain) = results[0.0], results[0.1]
    enough = counts > 200
    ratio = np.hypot(counts**-0.5, 0.1, where=enough, out=np.ones_like(counts)) * np.sqrt(counts)
    rock = scene().rock & enough
    np.testing.assert_allclose((whole / plain)[rock], ratio[rock], rtol=0.01)
    for one in (mean, uncertain):
        assert abs(one.density - DENSITY) < 3 * one.statistical_error
    assert uncertain.statistical_error >= mean.error == mean.statistical_error
    # The flux falls with a power of 1 to 4 of the density: 10 % of it are 2.5 to 10 % of that,
    # and thick rock, where the power is large, has the more weight.
    assert 0.025 * DENSITY < uncertain.error < 0.06 * DENSITY


def test_merged_pixels_share_the_density_that_explains_their_counts():
    there = scene()
    counts, exposure = next(draws(there, 5, 25))
    found = measure_density(from_counts(counts, exposure, 1.0, 0.95), there, 50)
    assert found.regions == len(np.unique(found.density[there.rock]))
    opacity = np.nan_to_num(found.opacity(there.thickness_m))
    expected = attenuate(opacity, ELEVATION_DEG, there.physics, ALTITUDE_M).flux * exposure
    label = found.region[there.rock]
    np.testing.assert_allclose(
        np.bincount(label, expected[there.rock]),
        np.bincount(label, counts[there.rock]),
        rtol=1e-5,
    )


def test_a_region_of_one_pixel_is_a_pixel():
    there = scene()
    rock = there.rock
    counts, exposure = next(draws(there, 60, 26))
    single = measure_density(from_counts(counts, exposure, 1.0, 0.95), there)
    number = np.arange(np.count_nonzero(rock))
    elevation = np.broadcast_to(ELEVATION_DEG, rock.shape)[rock]
    expected = expected_of_pixels(
        number, np.full(number.shape, exposure), there.thickness_m[rock],
        elevation, there.physics, ALTITUDE_M, len(number),
    )  # fmt: skip
    alone = uniform_density(counts[rock], expected)
    known = counts[rock] > 0
    np.testing.assert_allclose(alone[known], single.density[rock][known], rtol=1e-5)


def test_the_spread_of_the_models_encloses_each_that_holds():
    there = scene(flux_model="gaisser-tang")
    seen = from_values(muons(there).flux, None, 0.95)
    spread = model_densities(seen, there)
    rock = there.rock
    assert np.all(spread.minimum[rock] <= DENSITY * (1 + 1e-5))
    assert np.all(spread.maximum[rock] >= DENSITY * (1 - 1e-5))
    assert spread.rays["gaisser-tang"] == np.count_nonzero(rock)
    # These rays are more than 65° from the zenith; Bugaev's vertical spectrum holds for none.
    assert spread.rays["bugaev"] == 0
    guan = measure_density(seen, scene(flux_model="guan")).density[rock]
    assert np.all((spread.minimum[rock] <= guan) & (guan <= spread.maximum[rock]))
