"""Means over trajectories: partition of the acceptance, and an independent simulation."""

import numpy as np
import pytest

from muysc_qgis.forward.nodes import NodeGrid, Nodes
from muysc_qgis.forward.responses import PixelResponses, TelescopeResponses
from muysc_qgis.forward.sub_rays import SubRays
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate
from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.directions import Pointing
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.telescope.merging import merged_bins
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.topography.tracing import trace_terrain
from muysc_qgis.workflows.forward_model import trace_sub_rays

PHYSICS = Physics(flux_model="gaisser-tang")
POINTING = Pointing(30.0, 20.0, 12.0)


def flux(x, y):
    """Return something as steep as a flux, smooth, and of no symmetry."""
    return np.exp(2.0 * y - 0.7 * x) / (1 + (x - 0.2) ** 2)


def rate_of_whole_planes(geometry, field):
    """Integrate field × overlap of the planes / (1 + x² + y²)² over all directions."""
    node, weight = np.polynomial.legendre.leggauss(60)
    a, b = geometry.bars_x * geometry.step, geometry.bars_y * geometry.step
    total = 0.0
    # The overlap has a kink on both axes: one quadrant at a time.
    for sign_x in (-1, 1):
        for sign_y in (-1, 1):
            x, y = np.meshgrid(sign_x * a * (node + 1) / 2, sign_y * b * (node + 1) / 2)
            overlap = (a - abs(x)) * (b - abs(y)) * geometry.separation_cm**2
            inner = field(x, y) * overlap / (1 + x**2 + y**2) ** 2
            total += a * b / 4 * weight @ inner @ weight
    return total


def even_rays(geometry, rays, thickness=0.0, pointing=POINTING):
    """Return the sub-rays of a telescope in front of the same rock everywhere, row by row."""
    responses = TelescopeResponses(geometry, pointing)
    grid = NodeGrid.over(responses.window, rays)
    column, row = (
        one.ravel()
        for one in np.meshgrid(range(len(grid.azimuth_deg)), range(0, len(grid.elevation_deg), 9))
    )
    full = np.full(len(row), thickness)
    nodes = Nodes.on(grid, column, row + 4, 9.0, full, np.zeros(len(row), np.uint8))
    return SubRays.of(nodes, responses)


def test_weights_add_up_to_one():
    rays = even_rays(TelescopeGeometry(5, 3, 4.0, 50.0), 4)
    assert rays.shape == (5, 9)
    np.testing.assert_allclose(rays.mean(np.full(len(rays.azimuth_deg), 7.0)), 7.0)
    assert np.all(np.diff(rays.element) >= 0)


@pytest.mark.parametrize("thickness", [0.0, 100.0])
def test_trajectories_make_up_the_whole_telescope(thickness):
    geometry = TelescopeGeometry(8, 8, 10.0, 100.0)
    acceptance = trajectories(geometry).acceptance_cm2_sr
    errors = []
    pointing = Pointing(30.0, 50.0, 12.0)
    for count in (2, 4, 8):
        rays = even_rays(geometry, count, thickness, pointing)
        values = flux(*pointing.plane(rays.azimuth_deg, rays.elevation_deg))
        rate = np.sum(rays.mean(values) * acceptance)
        errors.append(abs(rate / rate_of_whole_planes(geometry, flux) - 1))
    assert errors[-1] < 3e-4, errors
    assert errors[0] / errors[-1] > 8, errors


def test_the_error_that_is_told_is_no_less_than_the_true_one():
    geometry = TelescopeGeometry(8, 8, 10.0, 100.0)
    finest = even_rays(geometry, 24, 100.0, Pointing(30.0, 50.0, 12.0))
    rays = even_rays(geometry, 4, 100.0, Pointing(30.0, 50.0, 12.0))

    def of(some):
        return flux(*Pointing(30.0, 50.0, 12.0).plane(some.azimuth_deg, some.elevation_deg))

    mean, error = rays.mean_and_error(of(rays))
    off = np.abs(mean - finest.mean(of(finest)))
    assert np.median(error) > 0.5 * np.median(off)
    assert np.median(error / mean) < 0.01


def test_bins_are_means_weighted_with_acceptances():
    geometry = TelescopeGeometry(5, 4, 8.0, 60.0)
    rays = even_rays(geometry, 5)
    acceptance = trajectories(geometry).acceptance_cm2_sr.ravel()
    shape, group = merged_bins(geometry, 3)
    values = np.random.default_rng(1).random(len(rays.azimuth_deg))
    together = rays.taken_together(shape, group, acceptance).mean(values)
    single = rays.mean(values).ravel()
    expected = np.bincount(group, single * acceptance) / np.bincount(group, acceptance)
    np.testing.assert_allclose(together.ravel(), expected)


def test_a_pixel_is_a_box():
    azimuth, elevation = np.array([10.0, 11.0, 12.0]), np.array([6.0, 5.0])
    responses = PixelResponses(azimuth, elevation, (1.0, 1.0))
    grid = NodeGrid.over(responses.window, 4)
    assert len(grid.azimuth_deg) == 12
    column, row = (one.ravel() for one in np.meshgrid(range(12), range(4, 72, 9)))
    nodes = Nodes.on(grid, column, row, 9.0, np.ones(96), np.zeros(96, np.uint8))
    rays = SubRays.of(nodes, responses)
    np.testing.assert_array_equal(np.bincount(rays.element), np.full(6, 16))
    np.testing.assert_allclose(rays.mean(rays.azimuth_deg), np.tile(azimuth, (2, 1)))
    np.testing.assert_allclose(rays.mean(rays.elevation_deg)[:, 0], elevation, atol=1e-3)


@pytest.mark.parametrize(
    ("bars", "size", "apart", "up"), [(30, 4.0, 250.0, 8.0), (16, 5.0, 115.0, 10.0)]
)
def test_muons_drawn_through_the_planes_see_the_same(data_folder, bars, size, apart, up):
    # Independent of all grids: points drawn on both planes, and one ray each.
    qmc = pytest.importorskip("scipy.stats.qmc")
    dem = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    sight = take_sight(dem, (14.410686, 40.810561), (14.424745, 40.823729))
    geometry = TelescopeGeometry(bars, bars, size, apart)
    pointing = Pointing(sight.boresight_azimuth_deg, sight.boresight_elevation_deg + up)
    rays = trace_sub_rays(
        sight.frame, sight.detector_elevation_m, TelescopeResponses(geometry, pointing)
    )
    found, error = rays.mean_and_error(rays.muons(2.65, PHYSICS, sight.detector_elevation_m).flux)
    share = rays.rock_share
    generator = np.random.default_rng(5)
    chosen = np.concatenate(
        [
            generator.choice(np.flatnonzero((low < share) & (share < high)), 4, replace=False)
            for low, high in ((0.1, 0.5), (0.5, 0.95), (0.999, 2.0))
        ]
    )
    draws = 1 << 11
    truth, spread = np.empty(len(chosen)), np.empty(len(chosen))
    for number, element in enumerate(chosen):
        row, column = np.divmod(element, share.shape[1])
        points = qmc.Sobol(4, seed=number).random(draws)
        x = geometry.step * (column - bars + 1 + points[:, 0] - points[:, 1])
        y = geometry.step * (bars - 1 - row + points[:, 2] - points[:, 3])
        azimuth, elevation = pointing.sky(x, y)
        rock = trace_terrain(
            sight.frame, sight.detector_elevation_m, azimuth, elevation[:, None]
        ).thickness_m[:, 0]
        values = attenuate(rock * 265.0, elevation, PHYSICS, sight.detector_elevation_m).flux
        # Points come alike from the planes; directions do with the squared obliquity.
        weight = (1 + x**2 + y**2) ** -2.0
        blocks = (values * weight).reshape(8, -1).sum(1) / weight.reshape(8, -1).sum(1)
        truth[number] = np.sum(values * weight) / weight.sum()
        spread[number] = blocks.std(ddof=1) / np.sqrt(8)
    off = np.abs(found.ravel()[chosen] / truth - 1)
    allowed = np.hypot(2 * spread / truth, error.ravel()[chosen] / truth)
    assert np.all(off < 2 * allowed + 2e-3), (off, allowed)
    assert np.median(off) < 0.01
