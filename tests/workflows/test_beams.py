"""Sub-rays through trajectories, against an independent quadrature and turned telescopes."""

import numpy as np
import pytest

from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate
from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.directions import Pointing
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.telescope.merging import merge_sum
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.topography.tracing import trace_terrain
from muysc_qgis.workflows.beams import look_around, telescope_beams
from muysc_qgis.workflows.flux_table import FluxTable
from muysc_qgis.workflows.pixel_beams import look_at_pixels, pixel_beams

GEOMETRY = TelescopeGeometry(6, 5, 5.0, 60.0)
ROCK = 2.65


@pytest.fixture(scope="module")
def sight(dem):
    return take_sight(
        dem, from_wgs84(dem.crs, 14.4265, 40.8125), from_wgs84(dem.crs, 14.4265, 40.8215), 2.0, 0.0
    )


def looked(sight, pointing):
    cells = look_around(GEOMETRY, pointing, sight.frame, sight.detector_elevation_m)
    return telescope_beams(GEOMETRY, pointing, cells, trajectories(GEOMETRY).acceptance_cm2_sr)


def flux_along(sight, azimuth, elevation):
    thickness = trace_terrain(
        sight.frame, sight.detector_elevation_m, azimuth, elevation[:, None]
    ).thickness_m[:, 0]
    return attenuate(100 * ROCK * thickness, elevation, Physics(), 500.0).flux


@pytest.fixture(scope="module")
def means(sight):
    """Return a function from a pointing to the mean flux of its trajectories."""

    def of(pointing):
        beams = looked(sight, pointing)
        return beams, beams.weights @ flux_along(sight, beams.azimuth_deg, beams.elevation_deg)

    return of


@pytest.mark.parametrize("roll", [0.0, 30.0])
def test_the_mean_flux_is_that_of_a_dense_grid(sight, means, roll):
    """Against 24 × 24 nodes in each cell between trajectories, whatever it holds."""
    pointing = Pointing(0.0, 24.0, roll)
    beams, found = means(pointing)

    def field(x, y):
        azimuth, elevation = (one.ravel() for one in pointing.sky(x, y))
        flux = flux_along(sight, azimuth, np.maximum(elevation, 0.05))
        return flux.reshape(1, *x.shape)

    cells = 2 * GEOMETRY.bars_y * 2 * GEOMETRY.bars_x
    dense = dense_means(field, 24)
    whole = np.asarray(beams.weights.sum(axis=1)).ravel() > 0
    assert whole.sum() > 40
    # What is left is the dense grid's own error where the sky begins.
    off = found[whole] / dense[whole] - 1
    assert np.sqrt(np.mean(off**2)) < 0.015
    assert np.abs(off).max() < 0.06
    assert beams.count < 24 * 24 * cells / 4


def dense_means(field, nodes):
    """Return the mean over each trajectory's response, a plain sum over evenly spread points.

    The response falls linearly to zero at the neighbours' middles, times 1/(1 + x² + y²)².
    """
    step = GEOMETRY.step
    share = (np.arange(2 * nodes) + 0.5) / nodes - 1.0
    result = []
    for row in range(GEOMETRY.bars_y - 1, -GEOMETRY.bars_y, -1):
        for column in range(1 - GEOMETRY.bars_x, GEOMETRY.bars_x):
            x, y = np.meshgrid(step * (column + share), step * (row + share))
            response = np.outer(1 - np.abs(share), 1 - np.abs(share)) / (1 + x**2 + y**2) ** 2
            result.append(np.sum(field(x, y)[0] * response) / np.sum(response))
    return np.array(result)


def test_derivatives_are_those_of_a_turned_telescope(sight, means):
    turn = 0.2
    beams = means(Pointing(0.0, 24.0))[0]
    flux = flux_along(sight, beams.azimuth_deg, beams.elevation_deg)
    for matrix, one, other in (
        (beams.turned, Pointing(turn, 24.0), Pointing(-turn, 24.0)),
        (beams.tilted, Pointing(0.0, 24.0 + turn), Pointing(0.0, 24.0 - turn)),
    ):
        change = (means(one)[1] - means(other)[1]) / (2 * turn)
        off = matrix @ flux - change
        assert np.sqrt(np.mean(off**2)) < 0.06 * np.sqrt(np.mean(change**2))


def test_bins_are_the_means_of_their_trajectories(sight):
    pointing = Pointing(0.0, 30.0)
    cells = look_around(GEOMETRY, pointing, sight.frame, sight.detector_elevation_m)
    acceptance = trajectories(GEOMETRY).acceptance_cm2_sr
    single, merged = (
        telescope_beams(GEOMETRY, pointing, cells, acceptance, merge) for merge in (1, 3)
    )
    values = np.cos(np.radians(single.azimuth_deg)) * single.elevation_deg
    each = (single.weights @ values).reshape(acceptance.shape)
    expected = merge_sum(each * acceptance, 3) / merge_sum(acceptance, 3)
    assert merged.weights @ values == pytest.approx(expected.ravel())


def test_pixels_of_a_muogram_collect_evenly(sight):
    azimuth, elevation = np.linspace(-10, 10, 5), np.linspace(40, 10, 4)
    cells = look_at_pixels(azimuth, elevation, sight.frame, sight.detector_elevation_m)
    beams = pixel_beams(azimuth, elevation, cells)
    assert set(np.unique(cells.kinds)) >= {0, 1, 3}
    assert np.asarray(beams.weights.sum(axis=1)).ravel() == pytest.approx(1)
    middle = (beams.weights @ beams.azimuth_deg).reshape(4, 5)
    assert middle == pytest.approx(np.broadcast_to(azimuth, (4, 5)))
    assert (beams.turned @ beams.azimuth_deg) == pytest.approx(1.0)
    assert (beams.tilted @ beams.elevation_deg) == pytest.approx(1.0, abs=0.02)


def test_pixels_at_the_skyline_have_the_flux_of_many_rays(sight):
    azimuth, elevation = np.linspace(-15, 15, 7), np.linspace(30, 6, 9)
    cells = look_at_pixels(azimuth, elevation, sight.frame, sight.detector_elevation_m)
    beams = pixel_beams(azimuth, elevation, cells)
    found = beams.weights @ flux_along(sight, beams.azimuth_deg, beams.elevation_deg)
    fine = [
        (axis[:, None] + abs(axis[1] - axis[0]) * ((np.arange(60) + 0.5) / 60 - 0.5)).ravel()
        for axis in (azimuth, elevation)
    ]
    grid = [one.ravel() for one in np.meshgrid(*fine)]
    flux = flux_along(sight, *grid).reshape(9, 60, 7, 60)
    weight = np.cos(np.radians(grid[1])).reshape(flux.shape)
    dense = (flux * weight).sum(axis=(1, 3)) / weight.sum(axis=(1, 3))
    assert found == pytest.approx(dense.ravel(), rel=0.03)


@pytest.mark.parametrize("altitude", [0.0, 1200.0])
def test_the_table_is_the_flux(altitude):
    rng = np.random.default_rng(1)
    opacity, elevation = np.exp(rng.uniform(3, 13, 4000)), rng.uniform(1, 60, 4000)
    table = FluxTable.of(0.5, 61.0, Physics(), altitude)
    flux, slope = table(opacity, elevation)
    exact = attenuate(opacity, elevation, Physics(), altitude).flux
    off = flux / exact - 1
    assert np.abs(off).max() < 3e-3
    assert np.sqrt(np.mean(off**2)) < 3e-4
    thick = opacity > 3000
    apart = attenuate(opacity[thick] * 1.01, elevation[thick], Physics(), altitude).flux
    assert slope[thick] == pytest.approx((apart - exact[thick]) / (0.01 * opacity[thick]), rel=0.03)
