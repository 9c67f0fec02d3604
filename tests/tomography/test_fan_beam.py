"""All methods on one small fan-beam problem: what tomography gains over one density.

24 × 24 voxels, eight detectors around half of them, 2 % noise; two bodies so that the best
homogeneous density has a relative error of 0.123.
"""

import numpy as np
import pytest

from muysc_qgis.tomography.figures_of_merit import contrast_recovered, relative_error
from muysc_qgis.tomography.lattice import Lattice
from muysc_qgis.tomography.operators import StoredPaths
from muysc_qgis.tomography.phantoms import conduit, share_inside, with_body
from muysc_qgis.tomography.projector import path_matrix, paths_through
from muysc_qgis.tomography.rays import joined, rays_from_station
from muysc_qgis.tomography.solvers import METHODS, Options, reconstruct
from muysc_qgis.tomography.system import System
from muysc_qgis.tomography.voxels import VoxelGrid

GRID = VoxelGrid((-240, -240, -10), (20, 20, 20), (24, 24, 1))
NOISE = 0.02

#: Largest relative error of each method with its defaults: a tenth above what it reaches.
LIMITS = {
    "art": 0.067, "bart": 0.064, "sart": 0.062, "sirt": 0.066, "mlem": 0.069, "osem": 0.063,
    "pml-quad": 0.056, "pml-hybrid": 0.046, "ospml-quad": 0.055, "ospml-hybrid": 0.045,
    "tv": 0.034, "grad": 0.053, "tikhonov": 0.053, "lsmr": 0.070, "bayes": 0.052,
}  # fmt: skip


@pytest.fixture(scope="module")
def conduits():
    return share_inside(GRID, conduit((40, 20), 80, -10, 10))


@pytest.fixture(scope="module")
def truth(conduits):
    model = with_body(2.65, conduits, 1.55)
    return with_body(model, share_inside(GRID, conduit((-110, -90), 60, -10, 10)), 3.1)


@pytest.fixture(scope="module")
def system(truth):
    fans = []
    for view in range(8):
        azimuth = 7 + 22.5 * view
        towards = np.radians(azimuth)
        station = (-600 * np.sin(towards), -600 * np.cos(towards), 0)
        directions = azimuth + np.linspace(-26, 26, 40)
        fans.append(rays_from_station(station, directions, np.array([0.0]), view))
    rays = joined(fans)
    paths = StoredPaths(path_matrix(paths_through(GRID, rays)))
    data = paths.forward(truth.ravel()).astype(float)
    errors = NOISE * data
    data += errors * np.random.default_rng(0).standard_normal(len(data))
    return System(paths, data, Lattice.of(GRID), rays.view, errors)


def test_one_density_is_off_by_an_eighth(system, truth):
    homogeneous = np.full(GRID.shape, system.usable().homogeneous())
    assert relative_error(homogeneous, truth) == pytest.approx(0.123, abs=0.002)


@pytest.mark.parametrize("name", sorted(METHODS))
def test_every_method_finds_the_bodies(name, system, truth, conduits):
    result = reconstruct(name, system, Options(correlation_length_m=80.0, prior_deviation=0.4))
    model = system.lattice.expand(result.values)
    assert relative_error(model, truth) < LIMITS[name]
    assert 0.55 < contrast_recovered(model, truth, conduits > 0.5) < 1.1
    assert 0.6 < result.misfit[-1] < 1.2


def test_one_sweep_from_nothing_is_worse_than_one_density(system, truth):
    """What a single sweep of ART gives, as the paper uses it."""
    result = reconstruct("art", system, Options(iterations=1, start=0.0, relaxation=1.0))
    assert relative_error(system.lattice.expand(result.values), truth) > 0.2


def test_without_a_penalty_gradient_descent_follows_the_noise(system, truth):
    options = Options(iterations=1000, regularization=0.0, discrepancy=0.0)
    endless = system.lattice.expand(reconstruct("grad", system, options).values)
    stopped = system.lattice.expand(
        reconstruct("grad", system, Options(iterations=1000, regularization=0.0)).values
    )
    assert relative_error(endless, truth) > 2 * relative_error(stopped, truth)


def test_the_bayesian_error_covers_the_truth(system, truth):
    """Two thirds of the voxels within one deviation, where the prior is about right."""
    options = Options(correlation_length_m=80.0, prior_deviation=0.35, prior_density=2.5)
    result = reconstruct("bayes", system, options)
    within = np.abs(result.values - truth.ravel()) < result.deviation
    assert 0.6 < within.mean() < 0.97
    assert np.all(result.deviation <= 0.35 * (1 + 1e-9))
