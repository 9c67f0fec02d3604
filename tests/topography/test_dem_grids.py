"""One hill on rasters of every kind: the same thickness, whatever the grid."""

import math

import numpy as np
import pytest
from pyproj import Proj

from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import from_wgs84, ground_height, local_frame

CELL_M, CELLS = 10.0, 340
EYE = 20.0
AZIMUTH, ELEVATION = np.array([35.0, 50.0, 62.0, 200.0]), np.array([2.0, 6.0, 11.0, 18.0])


def hill(east, north):
    """Return a hill 1 km to the north-east, longer than it is wide, and a plain."""
    along = (east + north) / math.sqrt(2) - 1000.0
    across = (east - north) / math.sqrt(2)
    return 600.0 * np.exp(-((along / 220.0) ** 2) - (across / 450.0) ** 2)


def exact_thickness(radius):
    """Return the thickness of the hill itself, by its roots along each ray."""
    s = np.linspace(0.0, 1650.0, 165_001)
    result = np.zeros((len(AZIMUTH), len(ELEVATION)))
    for i, azimuth in enumerate(np.radians(AZIMUTH)):
        ground = hill(s * np.sin(azimuth), s * np.cos(azimuth)) - s**2 / (2 * radius)
        for j, elevation in enumerate(np.radians(ELEVATION)):
            above = ground - EYE - s * np.tan(elevation)
            change = np.flatnonzero(np.diff(np.sign(above)))
            # Linear between samples 1 cm apart.
            at = s[change] + 0.01 * above[change] / (above[change] - above[change + 1])
            result[i, j] = np.sum(at[1::2] - at[::2]) / np.cos(elevation)
    return result


def check(path, trace, x, y, tolerance=0.5):
    frame = local_frame(open_dem(path), x, y, "detector")
    exact = exact_thickness(frame.radius_m)
    assert np.count_nonzero(exact > 300) >= 6
    assert np.count_nonzero(exact == 0) >= 4
    rock = trace(path, AZIMUTH, ELEVATION, x, y, eye=EYE)
    # Bilinear cells of 10 m cut up to 0.15 m off this hill.
    np.testing.assert_allclose(rock.thickness_m, exact, atol=tolerance)


def grid(x, y, step_x, step_y, columns=CELLS, rows=CELLS, turn_deg=0.0, shear=0.0):
    """Return the geotransform of a raster around (x, y), turned and sheared."""
    c, s = math.cos(math.radians(turn_deg)), math.sin(math.radians(turn_deg))
    xc, yc = step_x * c, step_x * s
    xr, yr = -step_y * s + shear * step_x * c, step_y * c + shear * step_x * s
    # A detector on no grid line and off the middle.
    u, v = columns / 2 + 0.3, rows / 2 - 0.2
    return (x - u * xc - v * xr, xc, xr, y - u * yc - v * yr, yc, yr)


UTM = "EPSG:32633"


@pytest.mark.parametrize(
    ("step_x", "step_y", "turn", "shear"),
    [
        (10.0, -10.0, 0.0, 0.0),
        (6.0, -10.0, 0.0, 0.0),
        (10.0, -5.0, 0.0, 0.0),
        (10.0, 10.0, 0.0, 0.0),
        (-10.0, -10.0, 0.0, 0.0),
        (10.0, -10.0, 30.0, 0.0),
        (10.0, -8.0, 135.0, 0.0),
        (9.0, -9.0, 0.0, 0.5),
        (9.0, 9.0, 20.0, 0.3),
    ],
    ids=[
        "north-up", "narrow cells", "low cells", "south-up", "west-up", "turned",
        "turned far", "sheared", "turned, sheared, south-up",
    ],
)  # fmt: skip
def test_geotransforms(sample_surface, trace, wgs84_to, step_x, step_y, turn, shear):
    x, y = wgs84_to(UTM, 14.4, 40.8)
    columns, rows = (round(3600 / abs(step)) for step in (step_x, step_y))
    geotransform = grid(x, y, step_x, step_y, columns, rows, turn, shear)
    check(sample_surface(hill, UTM, geotransform, columns, rows, x, y), trace, x, y)


@pytest.mark.parametrize(
    ("crs", "longitude", "latitude"),
    [
        ("EPSG:32633", 14.4, 40.8),
        ("EPSG:3857", 14.4, 40.8),
        ("EPSG:2193", 174.76, -36.88),
        ("EPSG:32719", -69.9, -33.4),
        ("EPSG:32760", 179.998, -16.8),
        ("EPSG:32760", -179.998, -16.8),
        ("EPSG:32633+5773", 14.4, 40.8),
        ("EPSG:27572", 2.9, 45.77),
        ("EPSG:2229", -118.2, 34.2),
        ("EPSG:3413", 20.0, 79.9),
        ("EPSG:3413", 100.0, 89.994),
        ("EPSG:3031", -30.0, -89.996),
    ],
    ids=[
        "UTM", "web Mercator", "NZTM", "UTM south", "UTM up to the antimeridian",
        "UTM from the antimeridian", "compound", "grads on Paris", "US survey feet",
        "polar stereographic", "north pole inside", "south pole inside",
    ],
)  # fmt: skip
def test_projected_systems(sample_surface, trace, wgs84_to, crs, longitude, latitude):
    x, y = wgs84_to(crs.partition("+")[0], longitude, latitude)
    step = CELL_M
    if crs == "EPSG:3857":
        step /= math.cos(math.radians(latitude))
    if crs == "EPSG:2229":
        step *= 3937 / 1200
    path = sample_surface(hill, crs, grid(x, y, step, -step), CELLS, CELLS, x, y)
    # A web Mercator cell of 10 m is made on the sphere, 0.3 % off on the ellipsoid;
    # at the pole the plane of the map is bent by the Earth's own bulge.
    check(path, trace, x, y)


@pytest.mark.parametrize(
    ("crs", "longitude", "latitude", "shown"),
    [
        ("EPSG:4326", 14.4, 40.8, 14.4),
        ("EPSG:4326", -75.4, 4.5, 284.6),
        ("EPSG:4326", 284.6, 4.5, -75.4),
        ("EPSG:4326", 179.995, -16.8, 179.995),
        ("EPSG:4326", 179.995, -16.8, -180.005),
        ("EPSG:4326", 180.005, -16.8, -179.995),
        ("EPSG:4326", -179.995, -16.8, 180.005),
        ("EPSG:4326", 20.0, 80.0, 20.0),
        ("EPSG:4326", -60.0, -77.5, -60.0),
        ("EPSG:4979", 14.4, 40.8, 14.4),
        ("EPSG:4267", -122.2, 46.2, -122.2),
        ("EPSG:4326+5773", 14.4, 40.8, 14.4),
    ],
    ids=[
        "WGS 84", "raster −180…180, detector 0…360", "raster 0…360, detector −180…180",
        "west of the antimeridian", "the same beyond −180", "east of it",
        "raster beyond −180, detector beyond 180", "80° north", "77.5° south",
        "three-dimensional", "NAD27", "compound",
    ],
)  # fmt: skip
def test_geographic_systems(sample_surface, trace, crs, longitude, latitude, shown):
    step_y = CELL_M / 111_200.0
    step_x = step_y / math.cos(math.radians(latitude))
    geotransform = grid(longitude, latitude, step_x, -step_y)
    path = sample_surface(hill, crs, geotransform, CELLS, CELLS, longitude, latitude)
    check(path, trace, shown, latitude)


def test_geographic_system_in_grads(sample_surface, trace):
    # NTF (Paris) counts longitudes from Paris, and 400 grads to the turn.
    longitude, latitude = 0.7, 50.8
    step_y = CELL_M / 100_080.0
    step_x = step_y / math.cos(math.radians(latitude * 0.9))
    geotransform = grid(longitude, latitude, step_x, -step_y)
    path = sample_surface(hill, "EPSG:4807", geotransform, CELLS, CELLS, longitude, latitude)
    check(path, trace, longitude, latitude)
    # A whole turn away is the same place.
    check(path, trace, longitude + 400.0, latitude)


def test_paris_meridian_is_found_again_on_wgs84(write_dem, wgs84_to):
    # NTF lies some 50 m from WGS 84 here; a forgotten meridian would be 180 km.
    x, y = wgs84_to("EPSG:27572", 2.9, 45.77)
    for crs, at, step in (
        ("EPSG:27572", (x, y), 10.0),
        ("EPSG:4807", wgs84_to("EPSG:4807", 2.9, 45.77), 0.001),
    ):
        path = write_dem(np.full((9, 9), 500.0), crs, grid(*at, step, -step, 9, 9))
        dem = open_dem(path)
        longitude, latitude = local_frame(dem, *at, "detector").wgs84()
        assert longitude == pytest.approx(2.9, abs=1e-7)
        assert latitude == pytest.approx(45.77, abs=1e-7)
        assert from_wgs84(dem.crs, 2.9, 45.77) == pytest.approx(at, rel=1e-12)


def test_azimuth_zero_is_true_north_not_grid_north(write_dem, wgs84_to):
    # 2.5° off the central meridian grid north turns by 1.6° at this latitude.
    x, y = wgs84_to(UTM, 17.5, 40.8)
    path = write_dem(np.full((300, 300), 100.0), UTM, grid(x, y, 10.0, -10.0, 300, 300))
    dem = open_dem(path)
    frame = local_frame(dem, x, y, "detector")
    column, row = frame.ground_positions(np.array([0.0, 90.0]), 1000.0)
    longitude, latitude = Proj(UTM)(*dem.crs_position(column, row), inverse=True)
    assert longitude[0] == pytest.approx(17.5, abs=1e-9)
    # 1000 m of meridian, radius of curvature 6 362.7 km at 40.8°.
    assert latitude[0] - 40.8 == pytest.approx(math.degrees(1000 / 6_362_700), rel=1e-4)
    assert latitude[1] == pytest.approx(40.8, abs=2e-6)
    azimuth, distance = frame.polar(column, row)
    np.testing.assert_allclose((azimuth + 180) % 360 - 180, [0.0, 90.0], atol=1e-6)
    np.testing.assert_allclose(distance, 1000.0, rtol=1e-9)


def world(step, first, columns):
    """Return a raster of the whole globe whose heights depend on longitude alone."""
    longitude = first + step * np.arange(columns)
    heights = 600.0 + 400.0 * np.cos(np.radians(3 * longitude + 40.0))
    rows = round(170 / step)
    geotransform = (first - step / 2, step, 0.0, 85.0, 0.0, -step)
    return np.tile(heights, (rows, 1)), geotransform


@pytest.mark.parametrize(
    ("first", "columns"),
    [(-179.75, 720), (0.25, 720), (-180.0, 720), (-180.0, 721), (0.0, 721), (-181.0, 725)],
    ids=["−180…180", "0…360", "on the line", "last = first", "0…360, last = first", "overlapping"],
)
@pytest.mark.parametrize("longitude", [-179.9, 180.1, 179.9, 0.1, -0.1, 359.9])
def test_globe_has_no_edge(write_dem, trace, first, columns, longitude):
    heights, geotransform = world(0.5, first, columns)
    path = write_dem(heights, "EPSG:4326", geotransform)
    # Where the same profile lies within a raster of a part of the globe.
    middle = (longitude + 180.0) % 360.0 - 180.0
    part = np.arange(-60, 60) * 0.5 + round(2 * (middle - first)) / 2 + first
    heights = np.tile(600.0 + 400.0 * np.cos(np.radians(3 * part + 40.0)), (340, 1))
    local = write_dem(heights, "EPSG:4326", (part[0] - 0.25, 0.5, 0.0, 85.0, 0.0, -0.5))
    rays = (np.array([60.0, 90.0, 270.0, 300.0]), np.array([0.0, 0.5]))
    whole = trace(path, *rays, longitude, 10.2, above=-100.0)
    within = trace(local, *rays, middle, 10.2, above=-100.0)
    assert np.all(within.thickness_m > 1000.0)
    np.testing.assert_allclose(whole.thickness_m, within.thickness_m, rtol=1e-9)


def test_raster_of_nearly_the_whole_globe_has_an_edge(write_dem):
    heights, geotransform = world(0.5, -179.75, 719)
    dem = open_dem(write_dem(heights, "EPSG:4326", geotransform))
    assert not dem.wraps
    with pytest.raises(ValueError, match="off the DEM"):
        ground_height(dem, 179.75, 0.0, "detector")
