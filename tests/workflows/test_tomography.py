"""From muograms of several stations to densities, on the real Vesuvius."""

from dataclasses import replace

import numpy as np
import pytest

from muysc_qgis.errors import Cancelled, MuyscError
from muysc_qgis.tomography.figures_of_merit import contrast_recovered
from muysc_qgis.tomography.operators import projector_of
from muysc_qgis.tomography.phantoms import conduit, share_inside, with_body
from muysc_qgis.tomography.solvers import Options
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.trajectories import TrajectoryMap
from muysc_qgis.workflows import tomography as workflow
from muysc_qgis.workflows.muogram_data import bare_stations, read_survey
from muysc_qgis.workflows.named_view import NamedView
from muysc_qgis.workflows.ray_data import NO_ERROR, NO_VALUE, ray_data
from muysc_qgis.workflows.station_data import rock_of_all
from muysc_qgis.workflows.tomography import (
    TomographyChoices,
    projection_of,
    reconstruct_volume,
    survey,
    tomography,
)
from muysc_qgis.workflows.volume_plan import VolumePlan

#: The crater around which the stations stand, and the density (g/cm³) that they see.
CRATER, DENSITY = (14.4265, 40.8215), 2.4
#: The cone, in the UTM zone.
PLAN = VolumePlan((450_600, 452_700, 4_518_000, 4_520_100), 100.0, None, 700.0, 1300.0)


@pytest.fixture(scope="module")
def lines(dem, views):
    """Rays through the cone, without data."""
    return survey(bare_stations(views("opacity")), dem, PLAN)


def filled(lines, opacity, error):
    """The rays with an opacity and a relative error each."""
    pairs = zip(lines.stations, lines.per_pixel(opacity), lines.per_pixel(error * opacity))
    return replace(lines, stations=tuple(one.with_opacity(*pair) for one, *pair in pairs))


def test_every_quantity_leads_to_the_density_of_a_uniform_mountain(dem, views):
    choices = TomographyChoices("sirt", Options(iterations=5), relative_error=0.05)
    for quantity in ("opacity", "thickness", "flux", "transmission"):
        data = read_survey(views(quantity), [], dem)
        result = tomography(data.stations, dem, PLAN, choices, rock=data.rock)
        assert result.reference_density == pytest.approx(DENSITY, rel=1e-4), quantity
        np.testing.assert_allclose(result.density.values[result.density.known], DENSITY, rtol=2e-4)


def test_mean_densities_along_rays_are_data_too(dem, views):
    seen = [one.view for one in views("thickness")]
    densities = [
        NamedView("", one.with_values("density", np.where(one.values > 0, DENSITY, np.nan)))
        for one in seen
    ]
    data = read_survey(densities, [], dem)
    result = tomography(data.stations, dem, PLAN, TomographyChoices("lsmr"), rock=data.rock)
    np.testing.assert_allclose(result.density.values[result.density.known], DENSITY, rtol=1e-4)


def test_telescope_angles_are_directions_too(dem, views):
    """Opacities along the middle of each trajectory of a telescope that is turned a little."""
    given = []
    tangent = np.linspace(-0.3, 0.3, 13)
    for number, one in enumerate(views("opacity")):
        bare = TrajectoryMap(
            "opacity", np.zeros((13, 13)), tangent, tangent[::-1],
            {**one.view.metadata, "ROLL": 10.0, "TANGENT_STEP": 0.05},
        )  # fmt: skip
        (seen,) = rock_of_all(bare_stations([NamedView("bare", bare)]), dem)
        opacity = 100 * DENSITY * seen.thickness_m.reshape(13, 13)
        given.append(NamedView(f"telescope {number}", replace(bare, values=opacity)))
    data = read_survey(given, [], dem)
    result = tomography(data.stations, dem, PLAN, TomographyChoices("sirt"), rock=data.rock)
    assert result.rays > 300
    np.testing.assert_allclose(result.density.values[result.density.known], DENSITY, rtol=1e-4)


def test_rock_outside_the_volume_has_the_reference_density(lines):
    """A mountain of 2.2 in the volume and 2.6 around it."""
    density = np.full(lines.lattice.count, 2.2)
    opacity = lines.opacity(projector_of(lines.paths).forward(density).astype(float), 2.6)
    options = Options(iterations=100, discrepancy=0)
    choices = TomographyChoices("sirt", options, reference_density=2.6)
    result = reconstruct_volume(filled(lines, opacity, 1e-4), choices)
    seen = result.coverage.values > 10
    assert np.median(result.density.values[seen]) == pytest.approx(2.2, abs=0.005)
    assert result.relative_residual < 1e-3


@pytest.mark.parametrize("method", ["bayes", "tv"])
def test_a_light_conduit_is_found_where_it_is(lines, method):
    """Data from voxels of half the size, so that the model that is sought cannot be exact."""
    x, y = lines.frame.place(*CRATER)
    east, north = (float(one) for one in lines.frame.local(np.array(x), np.array(y)))
    body = conduit((east, north), 250.0, 700.0, 1000.0)
    grid = lines.frame.metric(lines.grid)
    fine = replace(lines.paths, grid=grid.resized([size / 2 for size in grid.size_m]), column=None)
    density = with_body(2.6, share_inside(fine.grid, body), 2.1)
    opacity = lines.opacity(projector_of(fine).forward(density.ravel()).astype(float), 2.6)
    error = 0.01
    noise = 1 + error * np.random.default_rng(3).standard_normal(len(opacity))
    result = reconstruct_volume(
        filled(lines, opacity * noise, error),
        TomographyChoices(method, Options(deviation=False), reference_density=2.6),
    )
    share = share_inside(grid, body)
    truth = with_body(2.6, share, 2.1)
    assert 0.45 < contrast_recovered(result.density.values, truth, share > 0.5) < 1.1
    lightest = np.unravel_index(np.nanargmin(result.density.values), grid.shape)
    assert share[lightest] > 0.5
    assert 0.3 < result.chi_squared < 1.3
    assert result.deviation is None  # not asked for


def test_air_and_unseen_voxels_are_unknown_and_all_is_counted(dem, views):
    given = views("opacity")
    holes = given[0].view.values.copy()
    holes[5:8] = np.nan
    given[0] = replace(given[0], view=given[0].view.with_values("opacity", holes))
    data = read_survey(given, [], dem)
    result = tomography(data.stations, dem, PLAN, TomographyChoices("sirt"), rock=data.rock)
    rays, density = result.coverage.values, result.density.values
    assert np.array_equal(np.isnan(density), ~(rays > 0))
    assert np.count_nonzero(np.isfinite(rays)) == result.rock_voxels
    assert np.count_nonzero(rays == 0) == result.unseen_voxels > 0
    assert result.rays + sum(result.lost.values()) == sum(one.view.values.size for one in given)
    known = np.isfinite(views("opacity")[0].view.values[5:8])
    assert 0 < result.lost[NO_VALUE] <= np.count_nonzero(known)
    assert sum(one.rays for one in result.residuals) == result.rays


def test_without_a_mask_the_sky_shows_where_the_air_is(dem, views):
    data = read_survey(views("opacity"), [], dem)
    choices = TomographyChoices("sirt", Options(iterations=60), mask=False)
    plan = replace(PLAN, top_m=1600.0)
    result = tomography(data.stations, dem, plan, choices, rock=data.rock)
    slices = np.nanmean(result.density.values, axis=(0, 1))
    assert slices[0] > 2.0  # rock nearly everywhere
    assert slices[-1] < 0.3  # above the summit


def test_a_station_that_sees_sky_alone_has_no_relative_residual(dem, views):
    one, *others = read_survey(views("opacity"), [], dem).stations
    sky = one.opacity == 0
    only_sky = replace(
        one, azimuth_deg=one.azimuth_deg[sky], elevation_deg=one.elevation_deg[sky],
        opacity=one.opacity[sky], lost={},
    )  # fmt: skip
    choices = TomographyChoices("sirt", Options(iterations=2), DENSITY, mask=False)
    result = tomography([only_sky, *others], dem, replace(PLAN, top_m=1600.0), choices)
    first, second, *_ = result.residuals
    assert first.rays > 0
    assert np.isnan(first.relative)
    assert second.relative > 0


def test_recomputed_paths_give_the_same_as_the_matrix_and_are_told(lines, monkeypatch):
    # So few rays need less memory than the voxels, which come first.
    monkeypatch.setattr(workflow, "_FEW_NUMBERS_PER_VOXEL", 1)
    opacity = 100 * 2.4 * lines.thickness_m * (1 + 0.1 * np.sin(np.arange(len(lines.thickness_m))))
    lines = filled(lines, opacity, 0.01)
    options = Options(iterations=3, discrepancy=0)
    stored, anew = (
        reconstruct_volume(lines, TomographyChoices("sirt", options, memory_bytes=memory))
        for memory in (1 << 30, 150_000)
    )
    np.testing.assert_allclose(stored.density.values, anew.density.values, rtol=1e-4)
    assert not any("recomputed" in text for text in stored.warnings)
    assert "recomputed at every step" in anew.warnings[0]
    assert "use voxels of" in anew.warnings[0]


def test_voxels_that_do_not_fit_name_a_size_that_does(lines):
    with pytest.raises(MuyscError, match=r"voxels of 100 m need about .* use voxels of 1\d\d m or"):
        reconstruct_volume(filled(lines, lines.thickness_m, 0.1), TomographyChoices(
            "sirt", memory_bytes=300_000))  # fmt: skip


def test_one_station_is_warned_of(dem, views):
    data = read_survey(views("opacity")[:1], [], dem)
    result = tomography(data.stations, dem, PLAN, TomographyChoices("sirt"), rock=data.rock)
    assert any("one station only" in warning for warning in result.warnings)


def test_what_is_left_is_told_in_shares_of_the_data(lines):
    """Opacities that are by turns 10 % too large and too small, against rock of one density."""
    turns = 1 + 0.1 * (-1.0) ** np.arange(len(lines.thickness_m))
    opacity = lines.opacity(DENSITY * lines.inside_m * turns, DENSITY)
    # So large an error that the start explains them all.
    choices = TomographyChoices("sirt", Options(start=DENSITY), DENSITY)
    result = reconstruct_volume(filled(lines, opacity, 10.0), choices)
    off, data = 0.1 * DENSITY * lines.inside_m, DENSITY * lines.inside_m * turns
    assert result.reconstruction.iterations_done == 0
    assert result.relative_residual == pytest.approx(
        np.sqrt(np.mean(off**2) / np.mean(data**2)), rel=1e-5
    )
    for number, one in enumerate(result.residuals):
        own = lines.paths.rays.view == number
        rms = np.sqrt(np.mean(off[own] ** 2))
        assert one.rms == pytest.approx(100 * rms, rel=1e-5)
        assert one.relative == pytest.approx(rms / np.sqrt(np.mean(data[own] ** 2)), rel=1e-5)


def test_priors_and_volumes_that_do_not_suit_the_air_and_the_rock_are_warned_of(dem, views):
    data = read_survey(views("opacity"), [], dem)
    x, y = from_wgs84(projection_of(data.stations, dem), *CRATER)
    little = replace(PLAN, extent=(x - 200, x + 200, y - 200, y + 200))
    choices = TomographyChoices(
        "bayes", Options(iterations=2, deviation=False), relative_error=0.05, mask=False
    )
    result = tomography(data.stations, dem, little, choices, rock=data.rock)
    assert any("expects rock of the reference density where there is air" in one
               for one in result.warnings)  # fmt: skip
    (outside,) = (one for one in result.warnings if "is outside the volume and taken" in one)
    assert 50 < int(outside.split(" %")[0]) < 100


def test_too_few_iterations_are_told(lines):
    opacity = 250.0 * lines.thickness_m * (1 + 0.1 * np.sin(np.arange(len(lines.thickness_m))))
    choices = TomographyChoices("bayes", Options(iterations=2, deviation=False))
    result = reconstruct_volume(filled(lines, opacity, 0.01), choices)
    assert any("did not settle within 2 iterations" in text for text in result.warnings)


@pytest.fixture(scope="module")
def uniform(dem, views):
    """What is found where one density explains all."""
    data = read_survey(views("opacity"), [], dem)
    choices = TomographyChoices("sirt", relative_error=0.05)
    return tomography(data.stations, dem, PLAN, choices, rock=data.rock)


def test_a_start_that_explains_the_data_is_told(uniform):
    assert uniform.reconstruction.iterations_done == 0
    assert any("One density of 2.4 g/cm³ explains the data" in text for text in uniform.warnings)


def test_the_slice_shown_first_is_that_of_the_target_where_rays_see_it(uniform):
    coverage, level = uniform.coverage.values, uniform.grid.level_at(uniform.target.z)
    rays = np.nansum(coverage, axis=(0, 1))
    busiest = int(np.argmax(rays))
    assert level != busiest
    assert rays[level] > 0.25 * rays[busiest]
    assert uniform.shown_level == level
    assert replace(uniform, target=None).shown_level == busiest
    few = coverage.copy()
    few[:, :, level] *= 0.2
    assert replace(uniform, coverage=replace(uniform.coverage, values=few)).shown_level == busiest


def test_colours_of_densities_are_about_the_reference_and_never_of_nothing(uniform):
    """0.05 g/cm³ to both sides at the least, else as far as all but 2 % of the voxels."""
    assert uniform.density_limits == pytest.approx((DENSITY - 0.05, DENSITY + 0.05), abs=1e-3)
    values = uniform.density.values.copy()
    known = np.flatnonzero(uniform.density.known)
    values.flat[known[: len(known) // 2]] = DENSITY - 0.4
    values.flat[known[-2:]] = 9.0
    wide = replace(uniform, density=replace(uniform.density, values=values))
    assert wide.density_limits == pytest.approx((DENSITY - 0.4, DENSITY + 0.4), abs=2e-3)


def test_the_suggested_volume_holds_the_cone(dem, views):
    bare = bare_stations(views("opacity"))
    lines = survey(bare, dem, VolumePlan(voxels=30))
    x, y = lines.frame.place(*CRATER)
    for axis, place in ((0, x), (1, y)):
        assert lines.grid.origin_m[axis] + 500 < place < lines.grid.end_m[axis] - 500
    assert lines.grid.end_m[2] > 1262  # the summit
    assert 20 <= max(lines.grid.shape) <= 31
    # All but the top lies on whole multiples of a voxel.
    bounds = np.array([*lines.grid.origin_m, *lines.grid.end_m[:2]]) / lines.grid.size_m[0]
    np.testing.assert_allclose(bounds, np.round(bounds), rtol=0, atol=1e-6)
    assert lines.inside_m.sum() > 0.6 * lines.thickness_m.sum()


def test_a_run_can_be_stopped(dem, views):
    data = read_survey(views("opacity"), [], dem)
    for most in (0.1, 0.4, 0.8):
        with pytest.raises(Cancelled):
            tomography(
                data.stations, dem, PLAN, TomographyChoices("tv", relative_error=0.001),
                progress=lambda done, most=most: done < most,
            )  # fmt: skip


@pytest.mark.parametrize(
    ("plan", "sentence"),
    [
        (lambda: replace(PLAN, base_m=1300.0), r"base of the volume at 1300 m is not below its"),
        (lambda: replace(PLAN, voxel_size_m=0.0), r"voxel size of 0 m cannot be used"),
        (lambda: VolumePlan(voxels=0), r"0 voxels along the longest side are too few"),
        (lambda: replace(PLAN, top_m=None, base_m=1400.0), r"base of the volume at 1400 m is not"),
        (lambda: replace(PLAN, extent=(453_000, 453_300, 4_514_000, 4_514_300),
                         base_m=-500.0),
         r"None of the \d+ rays in rock crosses rock of the volume"),
        (lambda: replace(PLAN, extent=(453_000, 453_300, 4_514_000, 4_514_300), base_m=None),
         r"No ray meets rock between x 453000 and 453300"),
        (lambda: replace(PLAN, extent=(400_000, 452_000, 4_518_000, 4_520_000)),
         r"reaches beyond the elevation model vesuvius"),
    ],
)  # fmt: skip
def test_volumes_that_cannot_be_are_refused(dem, views, plan, sentence):
    bare = bare_stations(views("opacity"))
    with pytest.raises(MuyscError, match=sentence):
        survey(bare, dem, plan())


@pytest.mark.parametrize(
    ("choices", "sentence"),
    [
        ({"method": "fbp"}, r"Filtered back-projection needs parallel rays all around"),
        ({"reference_density": 0.0}, r"reference density of 0 g/cm³ is not that of any rock"),
        ({"relative_error": -0.1}, r"relative error of -0.1 cannot be used"),
        ({"memory_bytes": 0}, r"memory of 0 GiB holds no path"),
    ],
)
def test_choices_that_mean_nothing_are_refused(choices, sentence):
    with pytest.raises(MuyscError, match=sentence):
        TomographyChoices(**choices)


def test_assumed_errors_and_those_of_the_lengths_add_up(lines):
    """5 % of the opacity, at least that of a tenth of the mean, and 2 m of rock beside it."""
    opacity = 250.0 * lines.thickness_m
    bare = tuple(one.with_opacity(each, None)
                 for one, each in zip(lines.stations, lines.per_pixel(opacity)))  # fmt: skip
    known = ray_data(replace(lines, stations=bare), 2.5, 0.05, 2.0)
    assumed = 0.05 * np.maximum(opacity, 0.1 * opacity.mean())
    np.testing.assert_allclose(known.error, np.sqrt(assumed**2 + 500.0**2))
    assert ray_data(replace(lines, stations=bare), None, None, 2.0).error is None


def test_rays_without_an_error_are_left_out_and_counted(lines):
    opacity, error = 250.0 * lines.thickness_m, np.full(len(lines.thickness_m), 10.0)
    error[:4] = np.nan, 0.0, np.inf, 1e-9
    pairs = zip(lines.stations, lines.per_pixel(opacity), lines.per_pixel(error))
    some = replace(lines, stations=tuple(one.with_opacity(*pair) for one, *pair in pairs))
    known = ray_data(some, None, None, 0.0)
    assert known.lost[NO_ERROR] == 3
    assert known.used[0] == 3
    half = replace(some, stations=(replace(some.stations[0], error=None), *some.stations[1:]))
    with pytest.raises(MuyscError, match=r"5 of 6 stations have errors of their opacities"):
        ray_data(half, None, None, 0.0)
    nothing = tuple(one.with_opacity(np.full(len(one), np.nan), None) for one in lines.stations)
    with pytest.raises(MuyscError, match=r"None of the \d+ rays .* has an opacity above 0"):
        ray_data(replace(lines, stations=nothing), None, None, 0.0)


def test_bayes_without_errors_says_what_it_needs(lines):
    bare = tuple(
        one.with_opacity(opacity, None)
        for one, opacity in zip(lines.stations, lines.per_pixel(lines.thickness_m))
    )
    with pytest.raises(MuyscError, match=r"needs the standard errors of the data"):
        reconstruct_volume(replace(lines, stations=bare), TomographyChoices("bayes"))
    with pytest.raises(MuyscError, match=r"has no opacities; simulate or read them first"):
        reconstruct_volume(lines, TomographyChoices("sirt"))


def test_stations_need_the_terrain(dem, views):
    (one,) = bare_stations(views("opacity")[:1])
    with pytest.raises(MuyscError, match=r"detector of site_0_opacity .* is off the DEM"):
        rock_of_all([replace(one, longitude=20.0)], dem)
    assert projection_of([one], dem).to_epsg() == 32633
    with pytest.raises(MuyscError, match=r"No muogram is given"):
        survey([], dem, PLAN, crs=projection_of([one], dem))
