"""Lengths of rays in voxels, against closed forms and dense sampling."""

import numpy as np
import pytest

from muysc_qgis.errors import Cancelled, MuyscError
from muysc_qgis.tomography import libraries
from muysc_qgis.tomography.crossings import Stretches
from muysc_qgis.tomography.operators import RecomputedPaths, StoredPaths, projector_of
from muysc_qgis.tomography.projector import (
    check_memory,
    matrix_bytes,
    most_entries,
    path_matrix,
    paths_through,
)
from muysc_qgis.tomography.rays import Rays, joined, rays_from_station, unit_vectors
from muysc_qgis.tomography.voxels import VoxelGrid

GRID = VoxelGrid((-50, 0, 100), (10, 7, 5), (12, 9, 8))


def rays_of(*lines):
    origin = np.array([line[0] for line in lines], float)
    direction = np.array([line[1] for line in lines], float)
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    return Rays(origin, direction, np.zeros(len(lines), int))


def random_rays(count, seed=0):
    """Rays from within and around the grid, half of them towards its middle."""
    generator = np.random.default_rng(seed)
    low, high = np.array(GRID.origin_m), np.array(GRID.end_m)
    origin = generator.uniform(low - 60, high + 60, (count, 3))
    goal = generator.uniform(low, high, (count, 3))
    direction = np.where(np.arange(count)[:, None] % 2, goal - origin, origin - goal)
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    return Rays(origin, direction, np.zeros(count, int))


def length_in_box(rays, low, high):
    """Length of half lines in a box by clipping them at one face after the other."""
    result = []
    for origin, direction in zip(rays.origin_m, rays.direction):
        start, end = 0.0, np.inf
        for axis in range(3):
            faces = sorted(
                (face - origin[axis]) / direction[axis] for face in (low[axis], high[axis])
            )
            start, end = max(start, faces[0]), min(end, faces[1])
        result.append(max(end - start, 0.0))
    return np.array(result)


def dense(rays, **more):
    return path_matrix(paths_through(GRID, rays, **more)).toarray().reshape(-1, *GRID.shape)


def test_rows_add_up_to_the_length_in_the_volume():
    """2000 random rays against the length of a half line in a box."""
    rays = random_rays(2000)
    expected = length_in_box(rays, GRID.origin_m, GRID.end_m)
    paths = paths_through(GRID, rays)
    matrix = path_matrix(paths)
    total = np.asarray(matrix.sum(axis=1, dtype=float)).ravel()
    assert np.count_nonzero(expected) > 1000
    assert total == pytest.approx(expected, rel=1e-5, abs=1e-4)
    assert paths.lengths_m() == pytest.approx(expected, rel=1e-9, abs=1e-9)


def test_each_voxel_is_a_box_of_its_own():
    """Each entry is the length of the ray in that one voxel."""
    rays = random_rays(40, seed=3)
    lengths = dense(rays)
    for index in np.ndindex(GRID.shape):
        low = np.array(GRID.origin_m) + np.array(index) * GRID.size_m
        expected = length_in_box(rays, low, low + GRID.size_m)
        assert lengths[(slice(None), *index)] == pytest.approx(expected, abs=1e-4)


def test_rays_along_the_axes():
    lengths = dense(rays_of(
        ((-100, 10, 112), (1, 0, 0)), ((3, 10, 0), (0, 0, 1)), ((3, 1000, 112), (0, -1, 0)),
    ))  # fmt: skip
    assert lengths[0, :, 1, 2] == pytest.approx(10)
    assert lengths[1, 5, 1, :] == pytest.approx(5)
    assert lengths[2, 5, :, 2] == pytest.approx(7)
    assert lengths.sum(axis=(1, 2, 3)) == pytest.approx([120, 40, 63])


def test_along_a_plane_between_voxels_the_length_counts_once():
    lengths = dense(rays_of(((-100, 7, 105), (1, 0, 0)), ((-50, 0, 100), (1, 0, 0))))
    assert lengths.sum(axis=(1, 2, 3)) == pytest.approx([120, 120])


def test_the_diagonal_of_a_cube():
    grid = VoxelGrid((0, 0, 0), (1, 1, 1), (5, 5, 5))
    rays = rays_of(((-1, -1, -1), (1, 1, 1)))
    matrix = path_matrix(paths_through(grid, rays))
    assert matrix.toarray().reshape(grid.shape)[np.arange(5), np.arange(5), np.arange(5)] == (
        pytest.approx(np.sqrt(3))
    )
    assert matrix.sum() == pytest.approx(5 * np.sqrt(3), rel=1e-6)


def test_a_detector_inside_sees_only_ahead():
    ahead, back = dense(rays_of(((0, 30, 120), (1, 0, 0)), ((0, 30, 120), (-1, 0, 0))))
    assert (ahead.sum(), back.sum()) == pytest.approx((70, 50))


def test_rays_that_miss_have_empty_rows():
    rays = rays_of(((-100, 10, 112), (-1, 0, 0)), ((0, 0, 500), (1, 1, 0)), ((0, 30, 0), (0, 0, 1)))
    matrix = path_matrix(paths_through(GRID, rays))
    assert np.diff(matrix.indptr).tolist() == [0, 0, 8]


def test_only_the_given_stretches_of_rock_count():
    """Leaving the rock and entering it again within one voxel gives one entry."""
    rays = rays_of(((-50, 10, 112), (1, 0, 0)), ((0, 10, 0), (0, 0, 1)))
    rock = Stretches(
        np.array([0, 0, 0, 1]), np.array([-5, 12, 16.0, 90]), np.array([3.0, 14, 41, 103])
    )
    matrix = path_matrix(paths_through(GRID, rays, rock))
    assert matrix.toarray().reshape(-1, *GRID.shape)[0, :, 1, 2] == pytest.approx(
        [3, 6, 10, 10, 1, 0, 0, 0, 0, 0, 0, 0]
    )
    assert np.diff(matrix.indptr).tolist() == [5, 1]
    assert matrix[1].sum() == pytest.approx(3)


def test_voxels_of_air_are_no_unknowns():
    rays = random_rays(200)
    active = np.random.default_rng(2).random(GRID.shape) < 0.4
    whole = path_matrix(paths_through(GRID, rays)).toarray()
    some = path_matrix(paths_through(GRID, rays, active=active))
    assert some.shape[1] == np.count_nonzero(active)
    assert np.array_equal(some.toarray(), whole[:, active.ravel()])
    with pytest.raises(MuyscError, match="No voxel of the volume holds rock"):
        paths_through(GRID, rays, active=np.zeros(GRID.shape, bool))


def test_the_estimate_is_an_upper_bound_within_a_thousandth():
    paths = paths_through(GRID, random_rays(3000))
    entries = path_matrix(paths).nnz
    assert entries <= most_entries(paths) <= 1.001 * entries


def test_a_matrix_that_does_not_fit_names_a_voxel_size_that_does():
    paths = paths_through(GRID, random_rays(3000))
    limit = matrix_bytes(paths) // 2
    with pytest.raises(MuyscError, match=r"3000 rays.*use voxels of ([\d.]+) × ") as caught:
        check_memory(paths, limit)
    words = str(caught.value).split("use voxels of ")[1].split(" m or larger")[0]
    sizes = [float(word) for word in words.split(" × ")]
    coarse = VoxelGrid.covering(GRID.origin_m, GRID.end_m, sizes)
    check_memory(paths_through(coarse, paths.rays), limit)
    with pytest.raises(MuyscError, match=r"GiB; use fewer rays\."):
        check_memory(paths, 100)


def test_recomputing_gives_the_same_products_as_the_matrix():
    paths = paths_through(GRID, random_rays(500))
    stored, recomputed = StoredPaths(path_matrix(paths)), RecomputedPaths(paths)
    generator = np.random.default_rng(0)
    x, y = generator.random(stored.shape[1]), generator.random(stored.shape[0])
    assert recomputed.shape == stored.shape
    assert recomputed.forward(x) == pytest.approx(stored.forward(x), rel=1e-5)
    assert recomputed.back(y) == pytest.approx(stored.back(y), rel=1e-5)
    which = np.array([3, 499, 3, 250, 0])
    assert recomputed.take(which).forward(x) == pytest.approx(stored.forward(x)[which], rel=1e-5)
    for projector in (stored, recomputed):
        square = stored.matrix.toarray().astype(float) ** 2
        assert projector.row_squares() == pytest.approx(square.sum(axis=1), rel=1e-5)
        assert projector.column_squares(y) == pytest.approx(y @ square, rel=1e-4)
        assert projector.coverage().tolist() == np.count_nonzero(square, axis=0).tolist()
        parts = projector.grouped([np.array([5, 2]), np.array([7])])
        assert parts[0].forward(x) == pytest.approx(stored.forward(x)[[5, 2]], rel=1e-5)
        assert parts[1].forward(x) == pytest.approx(stored.forward(x)[[7]], rel=1e-5)


def test_back_projection_is_the_transpose_of_forward_projection():
    """y·(Ax) = (Aᵀy)·x."""
    generator = np.random.default_rng(5)
    for projector in (StoredPaths, RecomputedPaths):
        paths = paths_through(GRID, random_rays(300))
        operator = projector(path_matrix(paths) if projector is StoredPaths else paths)
        x, y = generator.random(operator.shape[1]), generator.random(operator.shape[0])
        assert y @ operator.forward(x) == pytest.approx(operator.back(y) @ x, rel=1e-5)


def test_the_projector_is_stored_where_it_fits():
    paths = paths_through(GRID, random_rays(50))
    assert isinstance(projector_of(paths), StoredPaths)
    assert isinstance(projector_of(paths, limit=1000), RecomputedPaths)


def test_without_scipy_the_user_is_told_what_to_install(monkeypatch):
    def missing(name):
        raise ImportError(name)

    monkeypatch.setattr(libraries.importlib, "import_module", missing)
    with pytest.raises(MuyscError, match="needs the Python package scipy"):
        path_matrix(paths_through(GRID, random_rays(5)))


def test_building_can_be_stopped():
    with pytest.raises(Cancelled):
        path_matrix(paths_through(GRID, random_rays(50)), progress=lambda fraction: False)


def test_stations_at_several_heights_keep_the_order_of_their_muograms():
    """Azimuth 90° is east, the azimuth runs fastest, and views count the stations."""
    azimuth, elevation = np.array([80.0, 90.0, 100.0]), np.array([10.0, 0.0])
    rays = joined([
        rays_from_station((-100, 30, height), azimuth, elevation, view)
        for view, height in enumerate((105, 130))
    ])  # fmt: skip
    assert len(rays) == 12
    assert rays.direction[4] == pytest.approx([1, 0, 0])
    assert rays.view.tolist() == [0] * 6 + [1] * 6
    lengths = dense(rays)
    assert lengths[4, :, 4, 1].sum() == pytest.approx(120)
    assert lengths[10, :, 4, 6].sum() == pytest.approx(120)


def test_directions_are_unit_vectors_by_azimuth_and_elevation():
    assert unit_vectors(np.array([0.0, 90.0, 0.0]), np.array([0.0, 45.0, 90.0])) == pytest.approx(
        np.array([[0, 1, 0], [0.5**0.5, 0, 0.5**0.5], [0, 0, 1]])
    )
    with pytest.raises(MuyscError, match="no unit vector"):
        Rays(np.zeros((1, 3)), np.ones((1, 3)), np.zeros(1, int))
