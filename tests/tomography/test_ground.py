"""The ground over the volume, against closed forms and dense sampling."""

import numpy as np
import pytest

from muysc_qgis.errors import Cancelled, MuyscError
from muysc_qgis.tomography.ground import HeightField, holds_rock, rock_fraction
from muysc_qgis.tomography.projector import path_matrix, paths_through
from muysc_qgis.tomography.rays import rays_from_station
from muysc_qgis.tomography.rock import rock_along
from muysc_qgis.tomography.voxels import VoxelGrid

GRID = VoxelGrid((-300, -200, 0), (20, 25, 10), (30, 16, 30))


def field(height, step=(20.0, 25.0), low=(-320.0, -225.0), shape=(33, 19)):
    east = low[0] + step[0] * np.arange(shape[0])
    north = low[1] + step[1] * np.arange(shape[1])
    values = np.broadcast_to(height(east[:, None], north[None, :]), shape).astype(float)
    return HeightField(low, step, values)


def hills(east, north):
    return 120 + 60 * np.sin(east / 90) * np.cos(north / 70) + 0.1 * east


def fan(station, azimuths=40, elevations=15):
    return rays_from_station(
        station, np.linspace(40, 140, azimuths), np.linspace(-10, 25, elevations)[::-1]
    )


def test_a_plain_is_a_slab():
    """Under a level plain a ray of elevation ε leaves the rock after depth / sin ε."""
    ground = field(lambda east, north: 150.0)
    rays = rays_from_station((-250, 0, 100), np.array([90.0]), np.array([30.0, 45.0, 60.0]))
    expected = 50 / np.sin(np.radians([30, 45, 60]))
    rock = rock_along(GRID, rays, ground)
    assert rock.end_m - rock.start_m == pytest.approx(expected)
    matrix = path_matrix(paths_through(GRID, rays, rock, holds_rock(GRID, ground)))
    total = np.asarray(matrix.sum(axis=1, dtype=float)).ravel()
    assert total == pytest.approx(expected, rel=1e-4)


def test_a_slope_cuts_level_rays_where_it_is_as_high():
    ground = field(lambda east, north: 150 + 0.5 * east)
    rays = rays_from_station((-300, 10, 100), np.array([90.0]), np.array([0.0]))
    rock = rock_along(GRID, rays, ground)
    # 150 + x/2 = 100 at x = −100, 200 m from the detector; the volume ends at 600 m.
    assert (rock.start_m, rock.end_m) == (pytest.approx([200]), pytest.approx([600]))


def test_hills_against_dense_sampling():
    """The bilinear ground sampled every 2 cm along the rays; at most 6 borders, 2 cm each."""
    ground = field(hills)
    rays = fan((-290, 20, 110))
    rock = rock_along(GRID, rays, ground)
    exact = np.bincount(rock.ray, rock.end_m - rock.start_m, len(rays))
    step = 0.02
    distance = np.arange(step / 2, 800, step)
    sampled = []
    for origin, direction in zip(rays.origin_m, rays.direction):
        east, north, up = origin[:, None] + direction[:, None] * distance
        inside = (east < 300) & (np.abs(north) < 200) & (up > 0) & (up < 300)
        sampled.append(step * np.count_nonzero(inside & (up < ground.at(east, north))))
    assert np.bincount(rock.ray).max() > 1
    assert exact == pytest.approx(np.array(sampled), abs=0.12)


def test_rows_add_up_to_the_rock_inside_the_volume():
    """No length is lost to voxels that are taken for air."""
    ground = field(hills, step=(13.0, 17.0), shape=(52, 28))
    rays = fan((-400, 20, 90))
    rock = rock_along(GRID, rays, ground)
    paths = paths_through(GRID, rays, rock, holds_rock(GRID, ground))
    total = np.asarray(path_matrix(paths).sum(axis=1, dtype=float)).ravel()
    assert np.count_nonzero(total) > 100
    assert total == pytest.approx(paths.lengths_m(), rel=1e-4, abs=1e-3)


def test_stretches_do_not_overlap_and_are_in_order():
    rock = rock_along(GRID, fan((-290, 20, 110)), field(hills))
    assert np.all(np.diff(rock.ray) >= 0)
    same = rock.ray[1:] == rock.ray[:-1]
    assert same.any()
    assert np.all(rock.start_m[1:][same] > rock.end_m[:-1][same])


def test_the_share_of_rock_of_a_plane():
    """The mean over a voxel of a plane that runs through it, and the volume of a wedge."""
    ground = field(lambda east, north: 100 + 0.2 * east)
    share = rock_fraction(GRID, ground)
    wedge = np.sum(share) * GRID.volume_m3
    assert wedge == pytest.approx(600 * 400 * 100, rel=1e-6)
    assert set(np.unique(share[:, :, 0])) == {1.0}
    assert np.all(share[:, :, -1] == 0)


def test_voxels_with_rock_are_marked():
    ground = field(hills, step=(13.0, 17.0), shape=(52, 28))
    marked = holds_rock(GRID, ground)
    share = rock_fraction(GRID, ground)
    assert np.all(marked[share > 0])
    # What is marked beyond is next to rock: at most the top voxels of each column.
    assert np.count_nonzero(marked) < 1.3 * np.count_nonzero(share > 0)


def test_unusable_terrain_is_refused():
    with pytest.raises(MuyscError, match="1 unknown heights"):
        HeightField((0, 0), (1, 1), np.array([[1.0, np.nan], [1, 1]]))
    with pytest.raises(MuyscError, match="at least 2 × 2"):
        HeightField((0, 0), (1, 1), np.ones((1, 5)))
    small = HeightField((-250, -250), (100, 100), np.ones((5, 6)))
    for use in (
        lambda: rock_fraction(GRID, small),
        lambda: holds_rock(GRID, small),
        lambda: rock_along(GRID, fan((0, 0, 0)), small),
    ):
        with pytest.raises(MuyscError, match="150 m beyond the elevation model"):
            use()


def test_tracing_can_be_stopped():
    with pytest.raises(Cancelled):
        rock_along(GRID, fan((-290, 20, 110)), field(hills), lambda fraction: False)
