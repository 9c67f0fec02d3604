"""Rays in the frame of a volume: true lengths, true north, a round Earth."""

import numpy as np
import pytest
from osgeo import gdal
from pyproj import CRS, Geod
from scipy import ndimage

from muysc_qgis.errors import MuyscError
from muysc_qgis.tomography.projector import path_matrix
from muysc_qgis.tomography.voxels import VoxelGrid
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import from_wgs84, to_wgs84
from muysc_qgis.topography.sampling import heights_at
from muysc_qgis.workflows.sightlines import lay_sightlines
from muysc_qgis.workflows.station_data import StationData, rock_seen
from muysc_qgis.workflows.volume_frame import (
    VolumeFrame,
    chosen_projection,
    projection_for,
    utm_zone,
)
from muysc_qgis.workflows.volume_ground import ground_below

EARTH = Geod(ellps="WGS84")


@pytest.fixture(scope="module")
def projected(data_folder, tmp_path_factory):
    """The same terrain in the projection of the volume."""
    path = str(tmp_path_factory.mktemp("dem") / "utm.tif")
    gdal.Warp(
        path, str(data_folder / "vesuvius_srtmgl1.tif"), dstSRS="EPSG:32633", xRes=30, yRes=30,
        resampleAlg="bilinear", outputType=gdal.GDT_Float32, dstNodata=-9999,
        outputBounds=(446_000, 4_513_000, 457_000, 4_527_000),
    )  # fmt: skip
    return open_dem(path)


def station(dem, azimuths=25, elevations=12, **more):
    """A detector on the western flank that looks at the crater, its rays one by one."""
    lon, lat = 14.405, 40.821
    x, y = from_wgs84(dem.crs, lon, lat)
    height = float(heights_at(dem, *dem.grid_position(x, y)))
    azimuth, elevation = np.meshgrid(np.linspace(60, 120, azimuths), np.linspace(24, 1, elevations))
    return StationData(
        "west", lon, lat, height + 2, azimuth.ravel(), elevation.ravel(), **more
    )  # fmt: skip


def lines_through(dem, one, size=100.0, mask=True):
    """Rays through a volume that holds the whole mountain."""
    grid = VoxelGrid.covering((448_600, 4_515_600, 200), (454_900, 4_522_900, 1300), size)
    frame = VolumeFrame.around(CRS.from_epsg(32633), (451_700, 4_519_200))
    return lay_sightlines([one], [rock_seen(one, dem)], grid, frame, dem, mask)


def test_scale_and_north_are_those_of_the_projection():
    """Snyder 1987 (USGS 1395), equations 8-11 and 8-14 to second order: k = k0 (1 + x²/2R²)."""
    longitude, latitude = 17.9, 45.0
    crs = utm_zone(longitude, latitude)
    place = from_wgs84(crs, longitude, latitude)
    frame = VolumeFrame.around(crs, place)
    x = (place[0] - 500_000) / 0.9996
    assert frame.scale == pytest.approx(0.9996 * (1 + x**2 / (2 * frame.radius_m**2)), abs=1e-6)
    _, (north,) = frame.lines((*place, 0.0), np.zeros(1), np.zeros(1))
    convergence = np.arctan(np.tan(np.radians(longitude - 15)) * np.sin(np.radians(latitude)))
    # Grid north is that angle west of true north, east of the central meridian.
    assert np.arctan2(-north[0], north[1]) == pytest.approx(convergence, abs=1e-5)


@pytest.mark.parametrize("azimuth", [0.0, 77.0, 200.0])
@pytest.mark.parametrize("elevation", [-3.0, 4.0, 30.0])
def test_points_of_a_ray_are_where_the_geodesic_and_the_round_earth_put_them(azimuth, elevation):
    crs = utm_zone(14.4, 40.8)
    frame = VolumeFrame.around(crs, from_wgs84(crs, 14.43, 40.82))
    lon, lat, height = 14.41, 40.79, 700.0
    place = (*from_wgs84(crs, lon, lat), height)
    (start,), (direction,) = frame.lines(place, np.array([azimuth]), np.array([elevation]))
    for distance in (500.0, 5000.0):
        point = start + direction * distance / np.hypot(*direction[:2])
        x, y = (frame.middle[axis] + frame.scale * point[axis] for axis in (0, 1))
        end = EARTH.fwd(lon, lat, azimuth, distance)
        assert to_wgs84(crs, x, y) == pytest.approx(end[:2], abs=3e-6)  # 0.3 m
        rise = distance * np.tan(np.radians(elevation)) + distance**2 / (2 * frame.radius_m)
        above = point[2] + frame.drop(point[0], point[1])
        assert above == pytest.approx(height + rise, abs=0.002)


def test_lengths_in_the_volume_are_those_of_radiography(projected):
    """The volume's ground has the DEM's own cells, so both trace the same surface."""
    lines = lines_through(projected, station(projected))
    assert len(lines.thickness_m) > 150
    off = np.abs(lines.inside_m - lines.thickness_m)
    assert np.median(off / lines.thickness_m) < 1e-4
    # Radiography takes the ground between grid lines for straight where that costs little.
    assert (off < 0.15 + 1e-4 * lines.thickness_m).all()


def test_rows_of_the_matrix_add_up_to_the_rock_inside(projected):
    lines = lines_through(projected, station(projected))
    rows = np.asarray(path_matrix(lines.paths).sum(axis=1, dtype=float)).ravel()
    np.testing.assert_allclose(rows, lines.inside_m, rtol=1e-4, atol=1e-3)


def test_a_dem_in_degrees_is_sampled_without_bias(dem):
    """What sampling costs: metres on single rays, nothing in the mean."""
    lines = lines_through(dem, station(dem))
    off = lines.outside_m
    assert np.median(np.abs(off) / lines.thickness_m) < 1e-3
    assert abs(off.sum()) < 2e-4 * lines.thickness_m.sum()


def test_lengths_do_not_depend_on_where_voxels_begin(projected):
    one = station(projected)
    coarse, fine = (lines_through(projected, one, size) for size in (100.0, 50.0))
    np.testing.assert_allclose(coarse.inside_m, fine.inside_m, rtol=1e-9)


def test_ground_that_data_leave_out_does_not_count(projected):
    """A muogram made with a near field and a range has its rock between the two."""
    plain = station(projected)
    cut = station(projected, near_field_m=1500.0, max_range_m=2500.0)
    whole, part = (lines_through(projected, one) for one in (plain, cut))
    assert part.thickness_m.sum() < 0.6 * whole.thickness_m.sum()
    np.testing.assert_allclose(part.inside_m, part.thickness_m, rtol=1e-4, atol=0.1)


def test_without_a_mask_rays_count_from_face_to_face(projected):
    lines = lines_through(projected, station(projected), mask=False)
    assert len(lines.thickness_m) == 300  # the sky's too
    assert np.all(lines.paths.lengths_m() >= lines.inside_m - 1e-6)
    assert lines.lattice.count == lines.grid.count


def test_ground_of_a_fine_dem_is_averaged(tmp_path):
    """Checkered heights of 1 m cells, seen by voxels of 80 m, are a plain."""
    heights = 500.0 + 10.0 * (np.indices((300, 300)).sum(axis=0) % 2)
    path = str(tmp_path / "fine.tif")
    dataset = gdal.GetDriverByName("GTiff").Create(path, 300, 300, 1, gdal.GDT_Float32)
    dataset.SetGeoTransform((500_000, 1, 0, 4_500_300, 0, -1))
    dataset.SetProjection(CRS.from_epsg(32633).to_wkt())
    dataset.GetRasterBand(1).WriteArray(heights)
    del dataset
    dem = open_dem(path)
    grid = VoxelGrid((500_030.0, 4_500_030.0, 400.0), (80.0, 80.0, 80.0), (3, 3, 2))
    frame = VolumeFrame.around(dem.crs, (500_150.0, 4_500_150.0))
    ground = ground_below(grid, frame, dem)
    assert ground.step_m[0] == pytest.approx(20, rel=1e-3)
    np.testing.assert_allclose(ground.height_m, 505.0, atol=1.0)


def test_projections_that_stretch_are_refused_with_a_better_one():
    mercator = CRS.from_epsg(3857)
    with pytest.raises(MuyscError, match=r"stretches lengths by 32 % .* WGS 84 / UTM zone 33N"):
        VolumeFrame.around(mercator, from_wgs84(mercator, 14.4, 40.8))
    with pytest.raises(MuyscError, match=r"EPSG:4326 .* is no projection in metres"):
        chosen_projection("EPSG:4326", "EPSG:4326")


def test_the_dem_decides_the_projection_if_it_is_true(dem, projected):
    assert projection_for(dem, 14.4, 40.8).to_epsg() == 32633
    assert projection_for(projected, 14.4, 40.8) == projected.crs
    assert utm_zone(-75.4, -4.5).to_epsg() == 32718


def test_a_volume_off_the_dem_is_refused(dem):
    grid = VoxelGrid.covering((440_000, 4_515_600, 200), (454_900, 4_522_900, 1300), 100.0)
    frame = VolumeFrame.around(CRS.from_epsg(32633), (451_700, 4_519_200))
    with pytest.raises(MuyscError, match=r"no heights for \d+ % of the volume"):
        ground_below(grid, frame, dem)


def test_heights_of_many_points_are_those_of_scipy(dem):
    column, row = np.array([0.0, 10.25, 300.5, 611.0]), np.array([503.0, 7.75, 200.0, 0.0])
    cells = dem.read(0, 0, dem.columns, dem.rows)
    linear = ndimage.map_coordinates(cells, [row, column], order=1)
    np.testing.assert_allclose(heights_at(dem, column, row), linear)
    assert np.isnan(heights_at(dem, np.array([-1.0, 5.0]), np.array([3.0, 504.0]))).all()
