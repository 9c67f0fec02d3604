"""A highest density: known of a rock, it stands in for views that are missing."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.tomography.lattice import Lattice
from muysc_qgis.tomography.operators import StoredPaths
from muysc_qgis.tomography.projector import path_matrix, paths_through
from muysc_qgis.tomography.rays import joined, rays_from_station
from muysc_qgis.tomography.solvers import METHODS, Options, reconstruct
from muysc_qgis.tomography.system import System
from muysc_qgis.tomography.voxels import VoxelGrid

GRID = VoxelGrid((-100, -100, -10), (20, 20, 20), (10, 10, 1))
ROCK = 2.65


@pytest.fixture(scope="module")
def truth():
    """Rock with a corner of air."""
    model = np.full(GRID.shape, ROCK)
    model[:4, :5] = 0.0
    return model.ravel()


@pytest.fixture(scope="module")
def system(truth):
    """Stations on one side only."""
    fans = []
    for view, azimuth in enumerate((-35.0, 0.0, 35.0)):
        towards = np.radians(azimuth)
        station = (-300 * np.sin(towards), -300 * np.cos(towards), 0)
        directions = azimuth + np.linspace(-25, 25, 30)
        fans.append(rays_from_station(station, directions, np.array([0.0]), view))
    rays = joined(fans)
    paths = StoredPaths(path_matrix(paths_through(GRID, rays)))
    return System(paths, paths.forward(truth).astype(float), Lattice.of(GRID), rays.view)


@pytest.mark.parametrize("name", sorted(set(METHODS) - {"bayes"}))
def test_no_density_is_above_the_highest(name, system):
    free = reconstruct(name, system, Options(start=ROCK, regularization=0.0))
    bound = reconstruct(name, system, Options(start=ROCK, regularization=0.0, highest=ROCK))
    assert free.values.max() > ROCK + 0.05
    # Some sweep in single precision.
    assert bound.values.max() <= ROCK * (1 + 1e-6)


@pytest.mark.parametrize("name", ["sirt", "sart", "mlem", "tv"])
def test_it_brings_the_model_nearer(name, system, truth):
    options = {"start": ROCK, "iterations": 200, "regularization": 0.0}
    free = reconstruct(name, system, Options(**options))
    bound = reconstruct(name, system, Options(**options, highest=ROCK))
    off = [np.linalg.norm(one.values - truth) for one in (free, bound)]
    assert off[1] < 0.8 * off[0]


@pytest.mark.parametrize("name", ["mlem", "pml-quad"])
def test_the_likelihood_still_rises(name, system):
    objective = reconstruct(name, system, Options(start=2.0, highest=ROCK)).objective
    assert np.all(np.diff(objective) <= 1e-9 * objective[0])


def test_a_highest_density_of_nothing_is_refused():
    with pytest.raises(MuyscError, match="The highest density is 0 g/cm³"):
        Options(highest=0.0)
