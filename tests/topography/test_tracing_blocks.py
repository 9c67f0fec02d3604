"""Memory, blocks and cancelling: how the work is cut must not show in the result."""

import tracemalloc

import numpy as np
import pytest
from osgeo import gdal, osr

from muysc_qgis.errors import Cancelled
from muysc_qgis.topography import dem as dem_module
from muysc_qgis.topography import profiles, stretches
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import local_frame
from muysc_qgis.topography.tracing import trace_terrain

#: The quantities of `RockPaths`.
NAMES = ("outcome", "thickness_m", "distance_m", "exit_m")

AZIMUTH = np.linspace(0.0, 357.0, 120)
ELEVATION = np.array([-12.0, -3.0, 0.0, 2.0, 5.0, 9.0, 15.0, 25.0, 60.0, 90.0])

SITES = [
    ("vesuvius_srtmgl1.tif", 14.410686, 40.810561),
    # North-east, near the wedges without data.
    ("st_helens_usgs.tif", 566_000.0, 5_121_500.0),
]


def assert_same(one, other):
    for name in NAMES:
        np.testing.assert_allclose(getattr(one, name), getattr(other, name), rtol=1e-9, atol=1e-7)


@pytest.fixture
def count_reads(monkeypatch):
    """Count the cells of each window read."""
    cells = []
    read = dem_module.Dem.read

    def counted(self, column, row, columns, rows):
        cells.append(columns * rows)
        return read(self, column, row, columns, rows)

    monkeypatch.setattr(dem_module.Dem, "read", counted)
    return cells


@pytest.mark.parametrize(("name", "x", "y"), SITES)
@pytest.mark.parametrize("scattered", [False, True])
@pytest.mark.parametrize(
    "limits",
    [
        {"MAX_PIECES": 700},
        {"MAX_CELLS": 5000},
        {"MAX_KNOTS": 200},
        {"MAX_PIECES": 500, "MAX_CELLS": 3000, "MAX_KNOTS": 300},
    ],
    ids=", ".join,
)
def test_block_sizes_do_not_show(data_folder, trace, monkeypatch, name, x, y, scattered, limits):
    path = str(data_folder / name)
    rays = (AZIMUTH, ELEVATION)
    if scattered:
        rays = (np.repeat(AZIMUTH, 10)[::3], np.tile(ELEVATION, 120)[::3, None])
    blocks = []
    cut = profiles.cut_stretches
    monkeypatch.setattr(profiles, "cut_stretches", lambda *a: blocks.append(0) or cut(*a))
    monkeypatch.setattr(profiles, "MAX_PIECES", 1 << 20)
    whole = trace(path, *rays, x, y, above=1.0)
    few = len(blocks)
    for limit, value in limits.items():
        monkeypatch.setattr(profiles, limit, value)
    assert_same(trace(path, *rays, x, y, above=1.0), whole)
    assert len(blocks) - few > 4 * few


def test_windows_stay_below_their_limit_all_around(data_folder, trace, monkeypatch, count_reads):
    # Seen all around, a ring is as wide as its radius whatever its breadth.
    monkeypatch.setattr(profiles, "MAX_CELLS", 2000)
    path = str(data_folder / "vesuvius_srtmgl1.tif")
    trace(path, AZIMUTH, ELEVATION, 14.410686, 40.810561, above=1.0)
    assert max(count_reads) <= 2000


@pytest.mark.parametrize(("name", "x", "y"), SITES)
@pytest.mark.parametrize("above", [-60.0, 1.0])
@pytest.mark.parametrize("keywords", [{}, {"max_range_m": 2800.0}, {"near_field_m": 700.0}])
def test_level_ground_serves_as_well_as_all_the_detail(
    data_folder, trace, monkeypatch, name, x, y, above, keywords
):
    path = str(data_folder / name)
    rays = (np.repeat(AZIMUTH, 10), np.tile(ELEVATION, 120)[:, None])
    quick = trace(path, *rays, x, y, above=above, **keywords)
    served = []
    level = stretches._level

    def detail(*arguments):
        heights = level(*arguments)
        served.append((len(heights), np.count_nonzero(np.isfinite(heights))))
        return np.full_like(heights, np.nan)

    monkeypatch.setattr(stretches, "_level", detail)
    assert_same(trace(path, *rays, x, y, above=above, **keywords), quick)
    assert max(count for _, count in served) > 1000  # or there would be nothing to compare


@pytest.mark.parametrize(("name", "x", "y"), SITES)
def test_no_ray_depends_on_the_others(data_folder, trace, name, x, y):
    path = str(data_folder / name)
    many = trace(path, AZIMUTH, ELEVATION, x, y, above=1.0)
    through_rock = np.argwhere(many.thickness_m > 50.0)
    assert len(through_rock) > 20
    for row, column in [*through_rock[:: len(through_rock) // 12], (3, 9), (101, 0)]:
        one = trace(path, AZIMUTH[row], ELEVATION[column], x, y, above=1.0)
        for quantity in NAMES:
            np.testing.assert_allclose(
                getattr(one, quantity)[0, 0],
                getattr(many, quantity)[row, column],
                rtol=1e-9,
                atol=1e-7,
            )


def test_range_beyond_the_last_rock_changes_nothing(data_folder, trace):
    path = str(data_folder / "vesuvius_srtmgl1.tif")
    rays = (np.linspace(18.0, 60.0, 30), np.linspace(8.0, 28.0, 20))
    free = trace(path, *rays, 14.410686, 40.810561, above=1.0)
    ranged = trace(path, *rays, 14.410686, 40.810561, above=1.0, max_range_m=4321.0)
    before = free.exit_m * np.cos(np.radians(rays[1])) < 4321.0
    assert np.count_nonzero(before) > 100
    for name in NAMES:
        np.testing.assert_allclose(
            getattr(ranged, name)[before], getattr(free, name)[before], rtol=1e-9
        )


def test_cancelling_stops_at_once(data_folder, count_reads, monkeypatch):
    monkeypatch.setattr(profiles, "MAX_CELLS", 5000)
    dem = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    frame = local_frame(dem, 14.410686, 40.810561, "detector")
    told = []

    def third_time_lucky(fraction):
        told.append(fraction)
        return len(told) < 3

    with pytest.raises(Cancelled):
        trace_terrain(frame, 610.0, AZIMUTH, ELEVATION, progress=third_time_lucky)
    assert len(told) == 3
    assert len(count_reads) <= 5


def test_progress_runs_from_nothing_towards_one(data_folder, monkeypatch):
    monkeypatch.setattr(profiles, "MAX_CELLS", 5000)
    dem = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    frame = local_frame(dem, 14.410686, 40.810561, "detector")
    told = []
    trace_terrain(frame, 610.0, AZIMUTH, ELEVATION, progress=lambda f: told.append(f) or True)
    assert told[0] == 0.0
    assert all(np.diff(told) >= 0)
    assert 0.5 < told[-1] <= 1.0


@pytest.fixture
def huge_dem(tmp_path):
    """Return a sparse raster of 40 000 × 40 000 cells of 1 m, with a hill in its middle."""
    path = str(tmp_path / "huge.tif")
    dataset = gdal.GetDriverByName("GTiff").Create(
        path, 40_000, 40_000, 1, gdal.GDT_Float32, ["SPARSE_OK=TRUE", "TILED=YES"]
    )
    dataset.SetGeoTransform((500_000.0, 1.0, 0.0, 4_540_000.0, 0.0, -1.0))
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(32633)
    dataset.SetSpatialRef(reference)
    # 300 m high, 600 m wide, 2 km east of the middle of the raster.
    across = np.arange(-300.0, 300.0) + 0.5
    hill = 300.0 - np.maximum(np.abs(across), np.abs(across)[:, None])
    dataset.GetRasterBand(1).WriteArray(hill, 21_700, 19_700)
    dataset.FlushCache()
    del dataset
    return path


@pytest.mark.parametrize("scattered", [False, True])
def test_only_the_window_of_a_huge_dem_is_read(huge_dem, count_reads, scattered):
    dem = open_dem(huge_dem)
    frame = local_frame(dem, 520_000.0, 4_520_000.0, "detector")
    # Grid north is 0.15° off, as the middle lies 20 km east of the meridian.
    azimuth, elevation = np.linspace(69.0, 111.0, 100), np.linspace(-1.0, 10.0, 50)
    rays = (azimuth, elevation)
    if scattered:
        rays = (np.repeat(azimuth, 50), np.tile(elevation, 100)[:, None])
    count_reads.clear()
    tracemalloc.start()
    rock = trace_terrain(frame, 2.0, *rays, max_range_m=5000.0)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    # The sector is 9 km² and its bounding boxes not much more, of 1600 km².
    assert sum(count_reads) < 60e6
    assert max(count_reads) <= profiles.MAX_CELLS
    assert peak < 100e6
    thickness = rock.thickness_m.reshape(100, 50)
    middle, up = 50, np.argmin(np.abs(elevation - 4.0))
    t = np.tan(np.radians(elevation[up]))
    near, far = (2000.0 - 300.0 + 2.0) / (1 - t), (2300.0 - 2.0) / (1 + t)
    exact = (far - near) / np.cos(np.radians(elevation[up]))
    assert thickness[middle, up] == pytest.approx(exact, rel=0.01)


def test_a_high_ray_reads_only_what_it_can_meet(huge_dem, count_reads):
    dem = open_dem(huge_dem)
    frame = local_frame(dem, 520_000.0, 4_520_000.0, "detector")
    count_reads.clear()
    # At 80° a ray is above any mountain after 1.6 km, though another is not for long.
    # The box around 20 km of it would be 200 million cells.
    azimuth, elevation = np.array([45.0, 90.0]), np.array([[80.0], [0.5]])
    trace_terrain(frame, 2.0, azimuth, elevation)
    assert sum(count_reads) < 10e6


def test_all_around_in_a_fine_dem_takes_little_memory(huge_dem):
    dem = open_dem(huge_dem)
    frame = local_frame(dem, 520_000.0, 4_520_000.0, "detector")
    tracemalloc.start()
    trace_terrain(frame, 2.0, np.arange(0.0, 360.0, 9.0), np.array([1.0, 9.0]), max_range_m=5000.0)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 100e6
