"""Counts of a telescope on real terrain and under the open sky."""

import numpy as np
import pytest

from muysc_qgis.errors import Cancelled, MuyscError
from muysc_qgis.radiography.counting import feasibility_days
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate
from muysc_qgis.telescope.directions import Pointing
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.telescope.planning import CountingPlan, smallest_contrast
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.expected_counts import expected_counts

PHYSICS = Physics(flux_model="gaisser-tang")
TELESCOPE = TelescopeGeometry(8, 8, 10.0, 200.0)


@pytest.fixture(scope="module")
def sight(data_folder):
    dem = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    return take_sight(dem, (14.410686, 40.810561), (14.424745, 40.823729))


@pytest.fixture(scope="module")
def at_target(sight):
    return Pointing(sight.boresight_azimuth_deg, sight.boresight_elevation_deg)


@pytest.fixture(scope="module")
def counted(sight, at_target):
    return expected_counts(sight, TELESCOPE, at_target, PHYSICS, CountingPlan())


def flux_of_the_sky(sight, elevation):
    return attenuate(
        np.zeros(elevation.size), elevation.ravel(), PHYSICS, sight.detector_elevation_m
    ).flux.reshape(elevation.shape)


@pytest.mark.parametrize(
    ("azimuth", "elevation", "roll"), [(220.0, 55.0, 0.0), (10.0, 48.0, 30.0), (0.0, 90.0, 0.0)]
)
def test_rate_under_the_open_sky_is_the_integral_over_both_planes(sight, azimuth, elevation, roll):
    geometry = TelescopeGeometry(6, 4, 10.0, 100.0)
    pointing = Pointing(azimuth, elevation, roll)
    # Four coordinates, one point on each plane; the DEM's rim is below the field of view.
    node, weight = np.polynomial.legendre.leggauss(10)
    sides = [bars * geometry.pixel_size_cm for bars in (geometry.bars_x, geometry.bars_y)]
    apart = node[:, None] / 2 - node[None, :] / 2
    x, y = np.meshgrid(sides[0] * apart.ravel() / 100.0, sides[1] * apart.ravel() / 100.0)
    product = np.outer(weight, weight).ravel() / 4
    _, heights = pointing.sky(x, y)
    integrand = flux_of_the_sky(sight, heights) / (1 + x**2 + y**2) ** 2 / 100.0**2
    expected = (sides[0] * sides[1]) ** 2 * product @ integrand @ product
    counts = expected_counts(sight, geometry, pointing, PHYSICS, CountingPlan())
    assert not counts.behind_rock.any()
    assert counts.unknown_trajectories == 0
    assert counts.rate_per_day() == pytest.approx(expected, rel=1e-3)


def test_the_whole_sky_converges_to_second_order_in_the_rays(sight):
    pointing = Pointing(220.0, 50.0)

    def counts(rays):
        plan = CountingPlan(rays_per_bar=rays)
        counted = expected_counts(sight, TELESCOPE, pointing, PHYSICS, plan, refine=False)
        return counted.maps["counts"].values

    reference = counts(24)
    errors = [np.sqrt(np.mean((counts(rays) / reference - 1) ** 2)) for rays in (1, 2, 4)]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.all(orders > 1.6), (errors, orders)
    assert errors[-1] < 2e-4


def test_the_skyline_converges_faster_than_first_order(sight, at_target):
    def run(rays):
        plan = CountingPlan(rays_per_bar=rays)
        return expected_counts(sight, TELESCOPE, at_target, PHYSICS, plan, wanted=(), refine=False)

    reference = run(16)
    known = np.isfinite(reference.maps["counts"].values)
    skyline = (reference.rock_share > 0.02) & (reference.rock_share < 0.98) & known
    assert skyline.sum() > 10
    counts = reference.maps["counts"].values[skyline]

    def error(rays):
        return np.sqrt(np.mean((run(rays).maps["counts"].values[skyline] / counts - 1) ** 2))

    errors = [error(rays) for rays in (1, 2, 4)]
    assert np.log2(errors[0] / errors[-1]) / 2 > 1.0, errors
    # The default, between the last two.
    assert error(CountingPlan().rays_per_bar) < 0.05


def test_many_small_trajectories_count_what_one_large_one_does(sight, at_target):
    # The same planes in 3 × 3 and in 9 × 9 bars: the total is the same muons.
    plan = CountingPlan(rays_per_bar=6)
    pointing = Pointing(at_target.azimuth_deg, at_target.elevation_deg + 12)
    rates = [
        expected_counts(
            sight, TelescopeGeometry(bars, bars, 45.0 / bars, 150.0), pointing, PHYSICS, plan
        ).rate_per_day()
        for bars in (3, 9)
    ]
    assert rates[0] == pytest.approx(rates[1], rel=5e-3)


def test_quantities_follow_from_each_other(counted):
    values = {name: one.values for name, one in counted.maps.items()}
    known = np.isfinite(values["counts"])
    np.testing.assert_allclose(
        values["counts"][known], (30 * values["flux"] * values["acceptance"])[known]
    )
    np.testing.assert_allclose(
        values["relative_error"][known], 100 / np.sqrt(values["counts"][known])
    )
    np.testing.assert_allclose(values["exposure"][known], 300 / values["counts"][known])
    sky = counted.rock_share == 0
    np.testing.assert_allclose(values["counts"][sky], values["open_sky_counts"][sky])
    assert np.all(np.isnan(values["density_resolution"][sky]))
    assert np.all(np.isnan(values["contrast_days"][sky]))
    rock = counted.behind_rock
    assert np.all(values["counts"][rock] < values["open_sky_counts"][rock])
    assert np.all(values["contrast_days"][rock] > 0)


def test_a_contrast_of_the_resolution_needs_the_days_planned(sight, at_target, counted):
    # Where many muons arrive, both ways of asking are one.
    counts = np.where(counted.rock_share == 1, counted.maps["counts"].values, np.nan)
    row, column = np.unravel_index(np.nanargmax(counts), counts.shape)
    resolution = counted.maps["density_resolution"].values[row, column]
    plan = CountingPlan(contrast_percent=-resolution)
    days = expected_counts(sight, TELESCOPE, at_target, PHYSICS, plan).maps["contrast_days"]
    # The power law for the flux is good to some percent over the contrast.
    assert days.values[row, column] == pytest.approx(30, rel=0.2)


def test_resolution_of_many_counts_is_that_of_their_error():
    # I ∝ ρ^−2.5, a million counts: σ/(2.5 √N).
    lighter = 0.98**-2.5
    contrast = smallest_contrast(np.array(1e6), np.array(1.0), np.array(lighter), 3.0)
    assert float(contrast) == pytest.approx(3 / 2.5 / 1e3, rel=5e-3)
    assert np.isnan(smallest_contrast(np.array(1e6), np.array(1.0), np.array(1.0), 3.0))


def test_lesparres_formula_is_the_other_choice(sight, at_target):
    plan = CountingPlan(statistics="lesparre", sigma=2.0)
    result = expected_counts(sight, TELESCOPE, at_target, PHYSICS, plan)
    exact = expected_counts(sight, TELESCOPE, at_target, PHYSICS, CountingPlan(sigma=2.0))
    rock = result.rock_share == 1
    row, column = np.argwhere(rock & np.isfinite(result.maps["counts"].values))[-1]
    flux = result.maps["flux"].values[row, column]
    # Alone from the flux behind nine tenths of the rock in the middle, roughly.
    thickness = result.maps["thickness"].values[row, column]
    _, elevation = result.maps["flux"].directions_deg()
    behind = attenuate(
        np.array([thickness, 0.9 * thickness]) * 265, elevation[row, column], PHYSICS, 604.0
    ).flux
    ratio = behind[1] / behind[0]
    acceptance = result.maps["acceptance"].values[row, column]
    expected = feasibility_days(flux, ratio * flux, acceptance, 2.0)
    days = result.maps["contrast_days"].values[row, column]
    assert days == pytest.approx(float(expected), rel=0.25)
    assert exact.maps["contrast_days"].values[row, column] != days


def test_merging_keeps_the_muons_and_sharpens_the_contrast(sight, at_target, counted):
    plan = CountingPlan(merge=3)
    merged = expected_counts(sight, TELESCOPE, at_target, PHYSICS, plan, refine=False)
    counted = expected_counts(sight, TELESCOPE, at_target, PHYSICS, CountingPlan(), refine=False)
    assert merged.maps["counts"].values.shape == (5, 5)
    step = merged.maps["counts"].pixel_size
    np.testing.assert_allclose(step, 3 * TELESCOPE.step)
    # The bins in the middle are the sums of three by three.
    for row in (1, 2, 3):
        for column in (1, 2, 3):
            members = slice(3 * row, 3 * row + 3), slice(3 * column, 3 * column + 3)
            assert merged.maps["counts"].values[row, column] == pytest.approx(
                counted.maps["counts"].values[members].sum(), nan_ok=True
            )
    whole = np.argwhere((merged.rock_share == 1) & np.isfinite(merged.maps["counts"].values))
    assert len(whole)
    for row, column in whole:
        members = slice(3 * row, 3 * row + 3), slice(3 * column, 3 * column + 3)
        resolution = merged.maps["density_resolution"].values[row, column]
        assert resolution < np.nanmin(counted.maps["density_resolution"].values[members])


def test_efficiency_scales_the_counts(sight, at_target, counted):
    half = expected_counts(sight, TELESCOPE, at_target, PHYSICS, CountingPlan(efficiency=0.5))
    np.testing.assert_allclose(
        half.maps["counts"].values, 0.5 * counted.maps["counts"].values, equal_nan=True
    )


def test_a_roll_of_90_degrees_turns_the_picture(sight, at_target, counted):
    turned = Pointing(at_target.azimuth_deg, at_target.elevation_deg, 90.0)
    rolled = expected_counts(sight, TELESCOPE, turned, PHYSICS, CountingPlan(rays_per_bar=6))
    # The telescope's right points down: what it has on its right, the level one has below.
    seen = np.rot90(rolled.maps["counts"].values, -1)
    level = counted.maps["counts"].values
    sky = counted.rock_share == 0
    np.testing.assert_allclose(seen[sky], level[sky], rtol=2e-3)
    assert np.array_equal(np.isnan(seen), np.isnan(level))


def test_trajectories_at_the_horizon_are_unknown_and_counted(counted):
    _, elevation = counted.maps["counts"].directions_deg()
    unknown = np.isnan(counted.maps["counts"].values)
    assert unknown.any()
    assert np.all(unknown[elevation <= 0])
    assert counted.unknown_trajectories == unknown.sum()
    (cause,) = [cause for cause in counted.unknown if "horizon" in cause]
    assert counted.unknown[cause] == unknown.sum()


def test_rock_without_a_flux_is_unknown_and_counted(sight):
    # The range law of the paper ends at 613 m of rock: all but the summit of the cone.
    pointing = Pointing(sight.boresight_azimuth_deg, 25.0)
    physics = Physics(energy_loss="paper")
    result = expected_counts(sight, TELESCOPE, pointing, physics, CountingPlan())
    ((cause, number),) = result.unknown.items()
    assert "energy loss has no answer" in cause
    assert number == result.unknown_trajectories > 0
    whole = expected_counts(sight, TELESCOPE, pointing, PHYSICS, CountingPlan())
    assert whole.unknown_trajectories == 0
    lost = np.isnan(result.maps["counts"].values)
    assert np.all(whole.rock_share[lost] > 0)
    # The thickness is known where the flux is not.
    assert np.all(np.isfinite(result.maps["thickness"].values))


def test_rays_to_the_edge_of_the_dem_are_unknown_and_counted(data_folder):
    # From the crater's floor of a DEM that ends within the cone behind it.
    dem = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    sight = take_sight(dem, (14.3505, 40.8305), (14.42, 40.825), -300.0)
    west = Pointing(270.0, 8.0)
    result = expected_counts(sight, TELESCOPE, west, PHYSICS, CountingPlan())
    (edge,) = [cause for cause in result.unknown if "edge of the DEM" in cause]
    unknown = np.isnan(result.maps["thickness"].values)
    assert result.unknown[edge] > 0
    assert unknown.sum() >= result.unknown[edge]
    assert any("edge of the DEM in rock" in warning for warning in result.warnings)


def test_all_sky_is_done_with_a_warning(sight):
    result = expected_counts(sight, TELESCOPE, Pointing(220.0, 60.0), PHYSICS, CountingPlan())
    assert "All 225 known trajectories see only sky" in result.warnings[0]
    assert np.isnan(result.median("exposure"))


def test_maps_describe_themselves(counted, at_target):
    metadata = counted.maps["counts"].metadata
    assert metadata["BARS_X"] == 8
    assert metadata["SEPARATION"] == 200
    assert metadata["BORESIGHT_AZIMUTH"] == at_target.azimuth_deg
    assert metadata["FLUX_MODEL"] == PHYSICS.flux_model
    assert counted.maps["counts"].pointing == at_target


def test_a_telescope_that_looks_down_is_refused(sight):
    with pytest.raises(MuyscError, match=r"nothing above .* raise the boresight"):
        expected_counts(sight, TELESCOPE, Pointing(0.0, -60.0), PHYSICS, CountingPlan())


def test_a_stop_is_obeyed(sight, at_target):
    with pytest.raises(Cancelled):
        expected_counts(
            sight, TELESCOPE, at_target, PHYSICS, CountingPlan(), progress=lambda share: share < 0.7
        )


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"days": 0.0}, "number of days is 0"),
        ({"sigma": -1.0}, "significance"),
        ({"contrast_percent": 0.0}, "contrast of 0 %"),
        ({"contrast_percent": -100.0}, "contrast of -100 %"),
        ({"efficiency": 1.5}, "efficiency of 1.5"),
        ({"statistics": "guess"}, "“guess”; use poisson or lesparre"),
    ],
)
def test_impossible_plans_are_refused(change, words):
    with pytest.raises(MuyscError, match=words):
        CountingPlan(**change)


@pytest.mark.parametrize(
    ("plan", "words"),
    [({"merge": 2}, "odd number"), ({"merge": 17}, "1 to 15"), ({"rays_per_bar": 0.5}, "rays a")],
)
def test_plans_that_do_not_fit_the_telescope(sight, at_target, plan, words):
    with pytest.raises(MuyscError, match=words):
        expected_counts(sight, TELESCOPE, at_target, PHYSICS, CountingPlan(**plan))
