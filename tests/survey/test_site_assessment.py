"""What a place is worth: the numbers of a radiography from there, and nothing else."""

import numpy as np
import pytest
from pyproj import Geod

from muysc_qgis.errors import MuyscError
from muysc_qgis.muogram import Muogram
from muysc_qgis.progress import silent
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.survey.body import target_body
from muysc_qgis.survey.held_dem import held_dem, hold
from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.topography.sampling import heights_at
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.simulation import Telescope, simulate
from muysc_qgis.workflows.site_assessment import NUMBERS, assess, survey_job


def simulated(plan, place):
    sight = take_sight(plan.dem, place, plan.target, plan.detector_height_m, plan.target_height_m)
    view = plan.view
    return sight, simulate(
        sight, view.aperture, view.physics, view.telescope, view.max_range_m, view.near_field_m
    )


def pixels_of(plan, sight, muogram: Muogram):
    """Return the pixel of each body point by a geodesic of its own, −1 outside."""
    body = plan.body()
    geod = Geod(ellps="WGS84")
    result = []
    for place, height in zip(body.place, body.height_m):
        x, y = plan.dem.crs_position(body.column[place], body.row[place])
        azimuth, _, distance = geod.inv(*sight.detector_wgs84, float(x), float(y))
        rise = height - sight.detector_elevation_m - distance**2 / (2 * sight.frame.radius_m)
        elevation = np.degrees(np.arctan2(rise, distance))
        column = np.argmin(np.abs((muogram.azimuth_deg - azimuth + 180) % 360 - 180))
        row = np.argmin(np.abs(muogram.elevation_deg - elevation))
        half_x = np.ptp(muogram.azimuth_deg) / (len(muogram.azimuth_deg) - 1) / 2
        half_y = np.ptp(muogram.elevation_deg) / (len(muogram.elevation_deg) - 1) / 2
        off_x = abs((muogram.azimuth_deg[column] - azimuth + 180) % 360 - 180)
        off_y = abs(muogram.elevation_deg[row] - elevation)
        outside = off_x > half_x or off_y > half_y
        result.append(-1 if outside else row * len(muogram.azimuth_deg) + column)
    return np.array(result)


def test_a_candidate_has_the_numbers_of_a_radiography_from_there(plan, places):
    # Rocks of 300 m and more around here: both limits of thickness matter.
    survey = plan(aperture=Aperture(12, 14, 12, 14), thickness_from_m=100, thickness_to_m=900)
    for place in map(tuple, places(5)):
        found = assess(survey, survey.body(), place)
        sight, simulation = simulated(survey, place)
        thickness = simulation.muograms["thickness"]
        pixel = pixels_of(survey, sight, thickness)
        rock = np.where(pixel >= 0, thickness.values.ravel()[pixel], 0)
        days = np.where(pixel >= 0, simulation.muograms["exposure"].values.ravel()[pixel], np.nan)
        behind = (rock > 0) & np.isfinite(days)
        seen = behind & (rock >= 100) & (rock <= 900)
        assert found.exposure_days == np.median(days[seen])
        assert found.thickness_m == np.median(rock[behind])
        assert found.smallest_thickness_m == rock[behind].min()
        assert found.largest_thickness_m == rock[behind].max()
        assert found.share_seen == seen.sum() / len(pixel)
        assert found.score == pytest.approx((100 / (100 + days[seen])).sum() / len(pixel))
        assert found.free_sky == np.mean(thickness.values == 0)
        assert found.detector_elevation_m == sight.detector_elevation_m


def test_the_score_is_a_half_where_the_campaign_just_suffices(plan, places):
    """T/(T + d) = 1/2 for d = T: with limits that all rock keeps to, half of the share seen."""
    place = tuple(places(1)[0])
    survey = plan(aperture=Aperture(40, 40, 1, 1), thickness_from_m=0, thickness_to_m=1e5)
    first = assess(survey, survey.body(), place)
    assert first.share_seen > 0
    # One pixel: every point has the same days.
    same = plan(
        aperture=Aperture(40, 40, 1, 1), thickness_from_m=0, thickness_to_m=1e5,
        days=first.exposure_days,
    )  # fmt: skip
    assert assess(same, same.body(), place).score == pytest.approx(first.share_seen / 2)


def test_jobs_give_what_assessing_gives(plan, places):
    """Terrain, physics and telescope survive the way to a worker, to the last digit."""
    survey = plan(
        physics=Physics(material="granite", density_g_cm3=2.4, flux_model="guan"),
        telescope=Telescope(
            6.0, 20.0, trajectories(TelescopeGeometry(16, 16, 5.0, 100.0), "exact")
        ),
        max_range_m=4000.0,
        near_field_m=20.0,
    )
    compute = survey_job(survey, places(3)).prepared()
    for item, place in enumerate(places(3)):
        found = assess(survey, survey.body(), tuple(place))
        np.testing.assert_array_equal(
            compute(item, silent), [getattr(found, name) for name in NUMBERS]
        )


def test_only_the_terrain_within_the_range_is_held(plan, places):
    whole = survey_job(plan(), places(4)).arrays["heights"]
    near = survey_job(plan(max_range_m=1000.0), places(4)).arrays["heights"]
    assert whole.shape == (504, 612)
    assert near.size < whole.size / 2


def test_held_terrain_is_the_file_with_its_gaps_and_units(gaps):
    settings, arrays = hold(gaps, (0, 0, gaps.columns, gaps.rows))
    held = held_dem(settings, arrays)
    np.testing.assert_array_equal(held.read(1, 2, 3, 4), gaps.read(1, 2, 3, 4))
    assert np.isnan(held.read(0, 0, 5, 5)).sum() == 1
    points = np.array([0.5, 3.75]), np.array([0.25, 4.0])
    np.testing.assert_array_equal(heights_at(held, *points), heights_at(gaps, *points))


@pytest.fixture
def gaps(tmp_path):
    """A DEM in decimetres with an offset and one gap."""
    from osgeo import gdal, osr

    from muysc_qgis.topography.dem import open_dem

    path = str(tmp_path / "gaps.tif")
    dataset = gdal.GetDriverByName("GTiff").Create(path, 8, 6, 1, gdal.GDT_Int16)
    dataset.SetGeoTransform((500000, 30, 0, 4500000, 0, -30))
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(32633)
    dataset.SetSpatialRef(reference)
    band = dataset.GetRasterBand(1)
    values = np.arange(48).reshape(6, 8) * 10
    values[3, 2] = -32768
    band.WriteArray(values)
    band.SetNoDataValue(-32768)
    band.SetScale(0.1)
    band.SetOffset(100.0)
    del band
    dataset = None
    return open_dem(path)


def test_terrain_that_is_not_held_is_refused(gaps):
    settings, arrays = hold(gaps, (2, 2, 3, 3))
    held = held_dem(settings, arrays)
    np.testing.assert_array_equal(held.read(2, 2, 3, 3), gaps.read(2, 2, 3, 3))
    for window in ((1, 2, 2, 2), (3, 3, 3, 2)):
        with pytest.raises(MuyscError, match="beyond the part in memory"):
            held.read(*window)


def test_the_body_is_the_cylinder_under_the_ground(plane):
    """Volume and mean height of a cylinder under a plane: points of equal volume."""
    body = target_body(plane, (500000.0, 4500000.0), 300.0, 200.0)
    assert len(body.place) == pytest.approx(3000, rel=0.05)
    # The ground at the target is at 1000 m; the plane's mean over a circle is its middle.
    assert body.height_m.mean() == pytest.approx(900 + 300**2 * 0.1**2 / 4 / (2 * 200), rel=2e-3)
    assert body.height_m.min() > 800
    frame_x, frame_y = plane.crs_position(body.column, body.row)
    assert np.hypot(frame_x - 500000, frame_y - 4500000).max() <= 300.2


@pytest.fixture
def plane(tmp_path):
    """A plane that rises by 0.1 eastwards, 1000 m high in the middle."""
    from osgeo import gdal, osr

    from muysc_qgis.topography.dem import open_dem

    path = str(tmp_path / "plane.tif")
    dataset = gdal.GetDriverByName("GTiff").Create(path, 101, 101, 1, gdal.GDT_Float64)
    dataset.SetGeoTransform((500000 - 505, 10, 0, 4500000 + 505, 0, -10))
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(32633)
    dataset.SetSpatialRef(reference)
    east = (np.arange(101) - 50) * 10.0
    dataset.GetRasterBand(1).WriteArray(np.broadcast_to(1000 + 0.1 * east, (101, 101)).copy())
    dataset = None
    return open_dem(path)


def test_a_candidate_that_cannot_be_used_is_a_sentence(plan):
    compute = survey_job(plan(), np.array([[14.424745, 40.823729], [14.4, 40.81]])).prepared()
    assert "same point" in compute(0, silent)
    assert isinstance(compute(1, silent), list)
