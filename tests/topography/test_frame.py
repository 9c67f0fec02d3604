"""The local frame: radius, curvature drop, azimuths and distances."""

import numpy as np
import pytest
from pyproj import Transformer

from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import local_frame


@pytest.fixture
def frame_at(write_dem):
    def make(longitude, latitude, crs="EPSG:4326"):
        geotransform = (longitude - 1.0, 0.5, 0.0, latitude + 1.0, 0.0, -0.5)
        path = write_dem(np.zeros((4, 4)), crs, geotransform)
        return local_frame(open_dem(path), longitude, latitude, "detector")

    return make


@pytest.mark.parametrize(
    ("latitude", "radius"),
    # √(MN) on WGS 84: b at the equator, a²/b at the pole (a = 6378137 m,
    # b = 6356752.314 m), and a √(1 − e²)/(1 − e² sin² φ) between.
    [(0.0, 6_356_752.314), (45.0, 6_378_101.03), (89.0, 6_399_580.489)],
)
def test_radius_of_curvature(frame_at, latitude, radius):
    assert frame_at(10.0, latitude).radius_m == pytest.approx(radius, rel=1e-9)


@pytest.mark.parametrize(("distance", "drop"), [(5000.0, 1.96), (10_000.0, 7.85)])
def test_curvature_drop(frame_at, distance, drop):
    # The physics reference, rounded to 1 cm and for the mean radius of 6371 km.
    frame = frame_at(10.0, 40.0)
    assert frame.drop(distance) * frame.radius_m / 6_371_000 == pytest.approx(drop, abs=0.005)


def test_drop_is_that_of_a_sphere(frame_at):
    frame = frame_at(10.0, 40.0)
    for distance in (1e3, 1e4, 5e4):
        # The level surface at a distance along it, seen from the tangent plane.
        angle = distance / frame.radius_m
        fall = frame.radius_m * (1 - np.cos(angle))
        assert frame.drop(distance) == pytest.approx(fall, rel=angle**2)


@pytest.mark.parametrize("latitude", [-60.0, 0.3, 40.8, 75.0])
def test_azimuth_and_distance_are_inverse_to_positions(frame_at, latitude):
    frame = frame_at(14.4, latitude)
    azimuth = np.array([0.0, 33.0, 90.0, 179.9, 222.0, 359.0])[:, None]
    distance = np.array([1.0, 250.0, 30_000.0])
    back, length = frame.polar(*frame.ground_positions(azimuth, distance))
    assert back.shape == length.shape == (6, 3)
    # A metre on this raster is 2e-5 cells, in which an angle is good to 1e-8.
    np.testing.assert_allclose((back - azimuth + 180) % 360 - 180, 0.0, atol=1e-6)
    np.testing.assert_allclose(length, np.broadcast_to(distance, (6, 3)), rtol=1e-7)


def test_published_distance_from_casina_amelia_to_vesuvius(data_folder):
    # The physics reference: 1883 m.
    dem = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    frame = local_frame(dem, 14.410686, 40.810561, "detector")
    azimuth, distance = frame.polar(*dem.grid_position(np.array([14.424745]), 40.823729))
    assert distance[0] == pytest.approx(1883.0, abs=0.5)
    # A flat triangle on the spheroid's radii of curvature gives 39.04°.
    assert azimuth[0] == pytest.approx(39.04, abs=0.01)


def test_datum_of_the_dem_is_carried_to_wgs84(frame_at):
    # NAD27 to WGS 84 by the mean translation of NIMA TR8350.2 for the contiguous
    # United States, (−8, 160, 176) m, good to 10 m.
    there = Transformer.from_pipeline(
        "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad "
        "+step +proj=cart +ellps=clrk66 +step +proj=helmert +x=-8 +y=160 +z=176 "
        "+step +inv +proj=cart +ellps=WGS84 +step +proj=unitconvert +xy_in=rad +xy_out=deg"
    )
    exact_longitude, exact_latitude, _ = there.transform(-122.2, 46.2, 0.0)
    assert exact_longitude < -122.201  # a shift of 90 m
    longitude, latitude = frame_at(-122.2, 46.2, "EPSG:4267").wgs84()
    assert longitude == pytest.approx(exact_longitude, abs=10 / 77_000)
    assert latitude == pytest.approx(exact_latitude, abs=10 / 111_000)
