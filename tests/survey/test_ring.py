"""Places on a ring: where they are asked for, and moved to ground that suits."""

import numpy as np
import pytest
from osgeo import gdal, osr
from pyproj import Geod

from muysc_qgis.errors import MuyscError
from muysc_qgis.survey.ring import Ring, ring_places
from muysc_qgis.topography.dem import open_dem

gdal.UseExceptions()

#: Middle of the made terrain in UTM zone 33 N.
X, Y, CELL, CELLS = 452_000.0, 4_519_000.0, 20.0, 151


@pytest.fixture
def terrain(tmp_path):
    """Return a function that makes a DEM of heights by metres east and north of its middle."""

    def make(height):
        axis = (np.arange(CELLS) - CELLS // 2) * CELL
        reference = osr.SpatialReference()
        reference.ImportFromEPSG(32633)
        path = str(tmp_path / "terrain.tif")
        dataset = gdal.GetDriverByName("GTiff").Create(path, CELLS, CELLS, 1, gdal.GDT_Float64)
        corner = (CELLS / 2) * CELL
        dataset.SetGeoTransform((X - corner, CELL, 0, Y + corner, 0, -CELL))
        dataset.SetProjection(reference.ExportToWkt())
        values = height(axis[None, :] + 0 * axis[:, None], -axis[:, None] + 0 * axis[None, :])
        dataset.GetRasterBand(1).WriteArray(values)
        dataset.FlushCache()
        del dataset
        return open_dem(path)

    return make


def flat(east, north):
    return 100.0 + 0 * east


def test_a_full_ring_divides_the_turn(terrain):
    places = ring_places(terrain(flat), (X, Y), Ring(1000.0, 8))
    assert places.azimuth_deg == pytest.approx(np.arange(8) * 45.0)
    assert places.distance_m == pytest.approx(np.full(8, 1000.0))
    assert not places.missing


def test_places_lie_at_their_azimuth_and_distance_on_the_ellipsoid(data_folder):
    """Against the geodesic of pyproj."""
    dem = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    target = (14.4265, 40.8215)
    places = ring_places(dem, target, Ring(1500.0, 5, 10.0, 130.0, sees_target=False))
    azimuth, _, distance = Geod(ellps="WGS84").inv(
        np.full(5, target[0]), np.full(5, target[1]), places.x, places.y
    )
    assert azimuth == pytest.approx([10, 40, 70, 100, 130], abs=1e-6)
    assert distance == pytest.approx(np.full(5, 1500.0), abs=1e-3)


def test_an_arc_runs_clockwise_across_north():
    assert Ring(1000.0, 3, 300.0, 60.0).azimuths() % 360 == pytest.approx([300, 0, 60])
    assert Ring(1000.0, 4, 90.0, 450.0).azimuths() % 360 == pytest.approx([90, 180, 270, 0])


def test_the_slope_is_that_of_a_plane(terrain):
    dem = terrain(lambda east, north: 500.0 + 0.3 * east - 0.4 * north)
    places = ring_places(dem, (X, Y), Ring(800.0, 6))
    assert places.slope_deg == pytest.approx(np.full(6, np.degrees(np.arctan(0.5))), abs=0.1)


def test_a_place_moves_to_the_terrace_next_to_it(terrain):
    """Steep but for a level band from 1040 to 1120 m."""

    def terrace(east, north):
        radius = np.hypot(east, north)
        return 900.0 - 0.5 * (np.minimum(radius, 1040) + np.maximum(radius - 1120, 0))

    dem = terrain(terrace)
    stay = ring_places(dem, (X, Y), Ring(1000.0, 6))
    move = ring_places(dem, (X, Y), Ring(1000.0, 6, tolerance_m=100.0))
    assert np.all(stay.slope_deg > 20)
    assert np.all(move.slope_deg < 1)
    assert np.all((move.distance_m > 1040) & (move.distance_m <= 1100 + 1e-6))


def test_steep_places_are_left_out_and_counted(terrain):
    """Level in the east, steep in the west."""
    dem = terrain(lambda east, north: 500.0 + np.where(east < 0, 0.8 * east, 0.0))
    places = ring_places(dem, (X, Y), Ring(1000.0, 8, 22.5, 382.5, slope_deg=20.0))
    assert places.number.tolist() == [0, 1, 2, 3]
    assert places.missing == {"too steep": 4}


def test_a_wall_in_front_hides_the_target(terrain):
    """A ridge at 900 m, in the north alone."""
    dem = terrain(
        lambda east, north: 100.0 + 200.0 * np.exp(-(((np.hypot(east, north) - 900) / 30) ** 2))
        * (north > 0)
    )  # fmt: skip
    ring = Ring(1050.0, 4, 45.0, 405.0)
    assert ring_places(dem, (X, Y), ring).number.tolist() == [1, 2]
    blind = Ring(1050.0, 4, 45.0, 405.0, sees_target=False)
    assert len(ring_places(dem, (X, Y), blind)) == 4


def test_a_ring_beyond_the_terrain_says_why(terrain):
    with pytest.raises(MuyscError, match=r"None of the 5 places at 4000 m .* 5 are off the DEM"):
        ring_places(terrain(flat), (X, Y), Ring(4000.0, 5))


@pytest.mark.parametrize(
    ("ring", "sentence"),
    [
        ({"radius_m": 0.0}, "A ring radius of 0 m holds no place"),
        ({"count": 0}, "0 places make no ring"),
        ({"tolerance_m": 2000.0}, "cannot be moved by 2000 m"),
        ({"slope_deg": 0.0}, "A slope of 0° is no limit"),
        ({"from_deg": 30.0, "to_deg": 30.0}, "has no width for 4 places"),
        ({"to_deg": np.nan}, "must be finite"),
    ],
)
def test_what_is_no_ring_is_refused(ring, sentence):
    with pytest.raises(MuyscError, match=sentence):
        Ring(**{"radius_m": 1000.0, "count": 4, **ring})
