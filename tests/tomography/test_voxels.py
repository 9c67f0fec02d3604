"""The volume: its bounds, slices and views."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.tomography.voxels import VoxelGrid, view


def test_whole_voxels_cover_an_extent():
    grid = VoxelGrid.covering((0, 0, 100), (95, 100, 130), (10, 20, 10))
    assert grid.shape == (10, 5, 3)
    assert grid.end_m == (100, 100, 130)
    # 0.3 / 0.1 is a hair below 3 and must not become 4 voxels of 0.1.
    assert VoxelGrid.covering((0, 0, 0), (0.3, 0.3, 0.3), 0.1).shape == (3, 3, 3)


def test_centres_follow_the_order_of_the_values():
    grid = VoxelGrid((10, 20, 30), (1, 2, 4), (2, 3, 4))
    east, north, up = grid.all_centres_m().T
    assert np.array_equal(east.reshape(grid.shape)[:, 0, 0], grid.centres_m(0))
    assert np.array_equal(north.reshape(grid.shape)[0, :, 0], [21, 23, 25])
    assert np.array_equal(up.reshape(grid.shape)[0, 0, :], [32, 36, 40, 44])


def test_views_keep_the_mass():
    """Summed over any view, density times volume is the same: the mass of the body."""
    grid = VoxelGrid((0, 0, 0), (2, 3, 5), (4, 5, 6))
    density = np.random.default_rng(1).uniform(1, 3, grid.shape)
    mass = density.sum() * grid.volume_m3
    areas = {"top": 2 * 3, "front": 2 * 5, "side": 3 * 5}
    for name, area in areas.items():
        assert np.sum(view(grid, density, name)) * area == pytest.approx(mass)


def test_air_counts_nothing_and_columns_of_air_are_unknown():
    grid = VoxelGrid((0, 0, 0), (1, 1, 10), (1, 2, 2))
    density = np.array([[[2.0, np.nan], [np.nan, np.nan]]])
    assert np.array_equal(view(grid, density, "top"), [[20.0, np.nan]], equal_nan=True)


def test_a_slice_is_found_by_its_height():
    grid = VoxelGrid((0, 0, 100), (1, 1, 10), (1, 1, 3))
    assert [grid.level_at(height) for height in (100, 109, 110, 130)] == [0, 0, 1, 2]
    with pytest.raises(MuyscError, match=r"131 m is outside the volume.*100 to 130"):
        grid.level_at(131)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: VoxelGrid((0, 0, 0), (0, 1, 1), (1, 1, 1)), "voxel size is 0 × 1 × 1 m"),
        (lambda: VoxelGrid((0, 0, 0), (1, 1, 1), (0, 1, 1)), "0 × 1 × 1 voxels"),
        (lambda: VoxelGrid((0, 0, 0), (1, 1, 1), (2000, 2000, 2000)), "at most|in all"),
        (lambda: VoxelGrid.covering((0, 0, 5), (1, 1, 5), 1), "which is empty"),
        (lambda: VoxelGrid.covering((0, 0, 0), (1, 1, 5), -1), "must be above 0"),
        (lambda: view(VoxelGrid((0, 0, 0), (1, 1, 1), (1, 1, 1)), np.ones((1, 1, 1)), "left"),
         "“left” is not a view"),
        (lambda: view(VoxelGrid((0, 0, 0), (1, 1, 1), (1, 1, 2)), np.ones((1, 1, 1)), "top"),
         "one value for each voxel"),
    ],
)  # fmt: skip
def test_unusable_volumes_are_refused(make, message):
    with pytest.raises(MuyscError, match=message):
        make()
