"""Known models, the muons counted behind them, and what is found again."""

from dataclasses import replace

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.survey.ring import Ring, ring_places
from muysc_qgis.tomography.solvers import Options
from muysc_qgis.tomography.voxels import VoxelGrid
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.workflows.known_model import KnownModel, Prism, density_in
from muysc_qgis.workflows.reconstruction_test import _contrast_along, reconstruct_known_model
from muysc_qgis.workflows.simulated_counts import Campaign, count_muons, station_data
from muysc_qgis.workflows.simulation import Telescope
from muysc_qgis.workflows.sites import Site, stations_of
from muysc_qgis.workflows.station_data import rock_seen
from muysc_qgis.workflows.tomography import TomographyChoices, survey
from muysc_qgis.workflows.volume_frame import VolumeFrame, utm_zone
from muysc_qgis.workflows.volume_plan import VolumePlan

SUMMIT, ROCK = (14.429444, 40.822222), 2.5
CRS = utm_zone(*SUMMIT)
MIDDLE = from_wgs84(CRS, *SUMMIT)
APERTURE = Aperture(80.0, 28.0, 16, 12)
PLAN = VolumePlan(
    (MIDDLE[0] - 500, MIDDLE[0] + 500, MIDDLE[1] - 500, MIDDLE[1] + 500), 100.0, None, 900.0, 1300.0
)
EXACT = TomographyChoices("lsmr", Options(regularization=0.0, iterations=400), ROCK)


@pytest.fixture(scope="module")
def stations(dem):
    places = ring_places(dem, SUMMIT, Ring(900.0, 8, sees_target=False))
    sites = [Site(f"s{n}", place, 0.0, f"s{n}") for n, place in enumerate(zip(places.x, places.y))]
    return stations_of(dem, sites, SUMMIT, 0.0, APERTURE)[0]


@pytest.fixture(scope="module")
def lines(dem, stations):
    data = [station_data(station, APERTURE) for station in stations]
    return survey(data, dem, PLAN, True, CRS)


def find(stations, dem, model, campaign=None, choices=EXACT):
    return reconstruct_known_model(
        stations, APERTURE, dem, PLAN, model, Physics(density_g_cm3=ROCK),
        campaign or Campaign(noise=False), choices, CRS,
    )  # fmt: skip


def test_directions_are_those_of_the_muogram(stations):
    azimuth, elevation = APERTURE.directions(
        stations[0].sight.boresight_azimuth_deg, stations[0].sight.boresight_elevation_deg
    )
    data = station_data(stations[0], APERTURE)
    assert data.azimuth_deg.reshape(12, 16)[5] == pytest.approx(azimuth)
    assert data.elevation_deg.reshape(12, 16)[:, 3] == pytest.approx(elevation)


def test_a_conduit_adds_its_chord_to_a_ray(stations, dem):
    """Against the closed form: contrast times the length of the ray in an upright cylinder."""
    radius, contrast, edge = 180.0, -0.7, 25.0
    data = [station_data(station, APERTURE) for station in stations]
    lines = survey(data, dem, replace(PLAN, voxel_size_m=edge), True, CRS)
    model = KnownModel("conduit", ROCK, ROCK + contrast, radius, centre=MIDDLE)
    metric = lines.paths.grid
    bodies = model.bodies(lines.frame, metric)
    found = _contrast_along(lines, bodies, ROCK, dem)
    rays, paths = lines.paths.rays, lines.paths.stretches
    east, north = (float(one) for one in lines.frame.local(*np.array(MIDDLE)))
    aside = rays.origin_m[:, :2] - (east, north)
    level = rays.direction[:, :2]
    a = np.sum(level**2, axis=1)
    b = np.sum(aside * level, axis=1)
    root = np.sqrt(np.maximum(b**2 - a * (np.sum(aside**2, axis=1) - radius**2), 0))
    start, end = (-b - root) / a, (-b + root) / a
    inside = np.minimum(paths.end_m, end[paths.ray]) - np.maximum(paths.start_m, start[paths.ray])
    chord = np.bincount(paths.ray, np.maximum(inside, 0), len(rays))
    assert chord.max() > 300
    # The rim is a staircase of half voxels, whose shares are right on the mean.
    assert found.sum() == pytest.approx(contrast * chord.sum(), rel=0.01)
    assert np.abs(found - contrast * chord).max() < abs(contrast) * 2 * edge


def test_shares_of_a_polygon_with_a_hole_add_up_to_its_area():
    frame = VolumeFrame.around(CRS, MIDDLE)
    x, y = MIDDLE

    def square(half):
        return np.array([(x - half, y - half), (x + half, y - half), (x + half, y + half),
                         (x - half, y + half), (x - half, y - half)])  # fmt: skip

    model = KnownModel(
        "polygons", ROCK, prisms=(Prism("1", (square(200), square(100)), 950.0, 1050.0, 1.5),)
    )
    grid = VoxelGrid((-400, -400, 900), (50, 50, 50), (16, 16, 4))
    density, (share,) = density_in(grid, model.bodies(frame, grid), ROCK)
    area = share.sum() * grid.volume_m3 / 100.0
    assert area == pytest.approx((400**2 - 200**2) / frame.scale**2, rel=0.01)
    assert density.min() == pytest.approx(1.5)
    assert density[8, 8] == pytest.approx(ROCK)


def test_cubes_and_spheres_are_as_large_as_asked_for_and_in_the_middle():
    frame = VolumeFrame.around(CRS, MIDDLE)
    grid = VoxelGrid((-400, -400, 900), (50, 50, 50), (16, 16, 8))
    board = KnownModel("checkerboard", ROCK, 2.0, edge_m=100.0)
    density, _ = density_in(grid, board.bodies(frame, grid), ROCK)
    assert density[:4, 0, 0] == pytest.approx([ROCK, ROCK, 2.0, 2.0])
    assert density[0, 0, :4] == pytest.approx([ROCK, ROCK, 2.0, 2.0])
    ball = KnownModel("sphere", ROCK, 2.0, radius_m=150.0, centre=MIDDLE)
    _, (share,) = density_in(grid, ball.bodies(frame, grid), ROCK)
    assert share.sum() * grid.volume_m3 == pytest.approx(4 / 3 * np.pi * 150**3, rel=0.01)
    assert share.ravel() @ grid.all_centres_m() / share.sum() == pytest.approx(
        [0, 0, 1100], abs=1e-6
    )


def test_without_noise_one_density_is_found_everywhere(stations, dem):
    found = find(stations, dem, KnownModel("uniform", ROCK))
    assert found.relative_error < 1e-4
    assert np.isnan(found.contrast)


def test_without_noise_the_contrast_of_a_wide_body_is_found(stations, dem):
    model = KnownModel("conduit", ROCK, 2.0, 200.0, centre=MIDDLE)
    found = find(stations, dem, model)
    assert found.contrast == pytest.approx(1.0, abs=0.15)
    (body,) = found.bodies
    assert 0 < body.seen <= body.voxels


def test_the_fit_of_merged_pixels_ends_where_that_of_their_regions_would(stations, dem):
    """Their errors are √n times as wide and they scatter together: at √(regions/pixels), not 1."""
    model = KnownModel("conduit", ROCK, 1.0, 250.0, centre=MIDDLE)
    choices = TomographyChoices("sirt", Options(iterations=100), ROCK)
    campaign = Campaign(40.0, Telescope(10.0), minimum_counts=50.0)
    fit = find(stations, dem, model, campaign, choices).tomography.reconstruction
    assert fit.stopped_by == "discrepancy"
    # Regions of three to four pixels on the mean.
    assert 4**-0.5 < fit.misfit[-1] < 3**-0.5


def test_the_shape_is_found_without_the_terrain(stations, dem):
    choices = replace(
        EXACT, method="sirt", mask=False, options=Options(iterations=100, highest=ROCK)
    )
    found = find(stations, dem, KnownModel("uniform", ROCK), choices=choices)
    assert np.nanmin(found.truth.values) == 0.0
    assert np.nanmax(found.truth.values) == pytest.approx(ROCK)
    air = found.truth.values == 0
    assert np.nanmean(found.tomography.density.values[air]) < 0.3 * ROCK


@pytest.fixture(scope="module")
def counting(dem, stations, lines):
    """Return a function that counts behind uniform rock, as the first station sees it."""
    data, station = lines.stations[0], stations[0]
    thickness = rock_seen(data, dem).thickness_m
    known = data.with_opacity(100 * ROCK * thickness, None)

    def count(campaign, seed=1):
        return known, thickness, count_muons(
            known, station, thickness, APERTURE, Physics(density_g_cm3=ROCK), campaign,
            np.random.default_rng(seed),
        )  # fmt: skip

    return count


def test_counts_say_the_opacity_within_their_errors(counting):
    """Over repeated draws: two thirds within one error, as of a normal distribution."""
    campaign = Campaign(3000.0, Telescope(100.0), minimum_counts=0.0)
    off = []
    for seed in range(6):
        known, thickness, counted = counting(campaign, seed)
        rock = (thickness > 0) & np.isfinite(counted.data.opacity)
        off.append(((counted.data.opacity - known.opacity) / counted.data.error)[rock])
    off = np.concatenate(off)
    assert 0.64 < np.mean(np.abs(off) < 1) < 0.73
    assert abs(np.mean(off)) < 0.15


@pytest.mark.parametrize("days", [1e18, 1e308])
def test_more_muons_than_can_be_drawn_are_refused(counting, days):
    with pytest.raises(MuyscError, match=r"muons in 1e\+\d+ days, beyond the 1e\+15.*less time"):
        counting(Campaign(days, Telescope(100.0)))


def test_merged_pixels_weigh_as_much_as_their_region(counting):
    """What the pixels say of one density, Σ (ϱ/σ)² over the rock, merging does not change.

    Only the few pixels without a muon of their own come on top.
    """
    days, telescope = 30.0, Telescope(10.0)
    _, thickness, merged = counting(Campaign(days, telescope, minimum_counts=50.0))
    _, _, single = counting(Campaign(days, telescope, minimum_counts=0.0))
    assert merged.regions < 0.8 * merged.pixels
    assert merged.pixels > single.pixels
    rock = thickness > 0
    said = [np.nansum((one.data.opacity / one.data.error)[rock] ** 2) for one in (merged, single)]
    assert said[0] == pytest.approx(said[1], rel=0.03)


def test_the_sky_is_as_sure_as_the_thinnest_rock(counting):
    _, thickness, counted = counting(Campaign(30.0, Telescope(10.0)))
    sky, rock = thickness == 0, thickness > 0
    assert np.count_nonzero(sky) > 10
    assert np.all(counted.data.opacity[sky] == 0)
    assert np.all(counted.data.error[sky] == np.nanmin(counted.data.error[rock]))


def test_pixels_without_a_muon_are_left_out_and_counted(counting):
    _, _, counted = counting(Campaign(1.0, Telescope(1.0), minimum_counts=0.0))
    (none,) = (lost for cause, lost in counted.data.lost.items() if "no muon" in cause)
    assert none.sum() > 0
    assert np.all(np.isnan(counted.data.opacity[none]))


def test_the_same_seed_draws_the_same_counts(counting):
    campaign = Campaign(100.0, Telescope(10.0))
    (_, _, one), (_, _, same), (_, _, other) = (counting(campaign, seed) for seed in (5, 5, 6))
    assert np.array_equal(one.data.opacity, same.data.opacity, equal_nan=True)
    assert one.muons == same.muons != other.muons


def test_a_body_above_the_ground_is_refused(stations, dem):
    model = KnownModel(
        "sphere", ROCK, 2.0, 50.0, middle_m=1290.0, centre=(MIDDLE[0] + 400, MIDDLE[1])
    )
    with pytest.raises(MuyscError, match="The body “sphere” is outside the rock of the volume"):
        find(stations, dem, model)


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"kind": "cube"}, "“cube” is not a model"),
        ({"kind": "polygons"}, "needs a layer of polygons"),
        ({"density": 0.0}, "The density of the rock is 0 g/cm³"),
        ({"body_density": 40.0}, "The density of the body is 40 g/cm³"),
    ],
)
def test_models_that_cannot_be_are_refused(change, sentence):
    with pytest.raises(MuyscError, match=sentence):
        KnownModel(**change)


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"days": -1.0}, "The time of counting in days is -1"),
        ({"minimum_counts": -1.0}, "A minimum of -1 counts cannot be reached"),
        ({"seed": -1}, "The seed is -1"),
    ],
)
def test_campaigns_that_cannot_be_are_refused(change, sentence):
    with pytest.raises(MuyscError, match=sentence):
        Campaign(**change)
