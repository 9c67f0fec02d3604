"""Terrain on another datum: one transformation to WGS 84, there and back."""

import json
import warnings
from dataclasses import replace

import numpy as np
import pytest
from pyproj import CRS, Geod, Transformer
from pyproj.transformer import TransformerGroup

from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.survey.held_dem import plain_dem, reopened_dem
from muysc_qgis.survey.masks import Mask
from muysc_qgis.topography.datum import Transformation, leads, name_of_operation
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.drape import check_detector
from muysc_qgis.topography.frame import from_wgs84, to_wgs84, transformed
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.simulation import Telescope, simulate
from muysc_qgis.workflows.volume_frame import VolumeFrame

WGS84 = Geod(ellps="WGS84")

#: On the south flank and the crater of Mount St. Helens, WGS 84.
FLANK, CRATER = (-122.2, 46.18), (-122.1944, 46.1910)

#: NAD27 to WGS 84 (4), EPSG:1173, from the register: the mean of the contiguous United States.
MEAN_OF_USA = (
    "+proj=pipeline +step +inv +proj=utm +zone=10 +ellps=clrk66 +step +proj=push +v_3 "
    "+step +proj=cart +ellps=clrk66 +step +proj=helmert +x=-8 +y=160 +z=176 "
    "+step +inv +proj=cart +ellps=WGS84 +step +proj=pop +v_3 "
    "+step +proj=unitconvert +xy_in=rad +xy_out=deg"
)


@pytest.fixture(scope="module")
def helens(data_folder):
    return open_dem(data_folder / "st_helens_usgs.tif")


def metres(one, other):
    return WGS84.inv(*one, *other)[2]


def operation_named(crs, name, back=False):
    """Find an operation in the register, without the code under test."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # better ones may need grids that are not there
        ends = (4326, crs) if back else (crs, 4326)
        group = TransformerGroup(*ends, always_xy=True)
    return next(one for one in group.transformers if name in one.description)


def test_a_detector_comes_back_from_where_it_was_put(helens):
    place, target = (from_wgs84(helens.crs, *one, helens.transformation) for one in (FLANK, CRATER))
    sight = take_sight(helens, place, target)
    assert metres(sight.detector_wgs84, FLANK) < 0.001
    assert metres(sight.target_wgs84, CRATER) < 0.001
    # NAD27 is some 100 m from WGS 84 here.
    assert metres(Transformer.from_crs(26710, 4267, always_xy=True).transform(*place), FLANK) > 80


def test_both_directions_are_one_operation_of_the_register(helens):
    by = helens.transformation
    exact = operation_named(26710, by.name)
    assert by.accuracy_m == exact.accuracy
    x, y = (
        np.array([557_900.0, 562_000.0, 567_500.0]),
        np.array([5_108_000.0, 5.115e6, 5_121_900.0]),
    )
    longitude, latitude = by.to_wgs84(x, y)
    np.testing.assert_allclose((longitude, latitude), exact.transform(x, y), rtol=0, atol=1e-11)
    back = exact.transform(longitude, latitude, direction="INVERSE")
    np.testing.assert_allclose(by.from_wgs84(longitude, latitude), back, rtol=0, atol=1e-6)
    np.testing.assert_allclose(back, (x, y), rtol=0, atol=0.001)


@pytest.mark.parametrize(
    ("crs", "x", "y"),
    [
        ("EPSG:26710", 562_000.0, 5_115_000.0),  # NAD27
        ("EPSG:4267", -122.2, 46.2),
        ("EPSG:23030", 450_000.0, 4_500_000.0),  # ED50
        ("EPSG:3003", 1_650_000.0, 4_850_000.0),  # Monte Mario
        ("EPSG:4806", 2.0, 40.8),  # the same from Rome
        ("EPSG:4807", 0.7, 50.8),  # NTF in grads from Paris
        ("EPSG:30166", 10_000.0, -150_000.0),  # Tokyo
        ("EPSG:2193", 1_757_000.0, 5_917_000.0),  # NZGD2000
        ("EPSG:25833", 450_000.0, 4_500_000.0),  # ETRS89
    ],
)
def test_positions_come_back_on_every_datum(write_dem, crs, x, y):
    step = 3e-4 if CRS(crs).is_geographic else 30.0
    path = write_dem(np.zeros((9, 9)), crs, (x - 4.5 * step, step, 0.0, y + 4.5 * step, 0.0, -step))
    dem = open_dem(path)
    by = dem.transformation
    assert by.accuracy_m > 0
    place = to_wgs84(dem.crs, x, y, by)
    # Within a centimetre: heights above the two ellipsoids, which differ, are not kept.
    assert from_wgs84(dem.crs, *place, by) == pytest.approx((x, y), abs=0.01 * step / 30)
    expected = operation_named(crs, by.name).transform(x, y)
    assert metres(place, expected) < 1e-6


def test_the_best_operation_is_that_of_the_place(write_dem):
    # Western and eastern United States have parameters of their own, metres apart.
    west, east = (
        open_dem(write_dem(np.zeros((9, 9)), "EPSG:4267", (x, 1e-3, 0.0, 40.0, 0.0, -1e-3)))
        for x in (-120.0, -76.0)
    )
    assert west.transformation.name != east.transformation.name


@pytest.mark.parametrize("crs", ["EPSG:4326", "EPSG:32633", "EPSG:3857", "OGC:CRS84"])
def test_on_wgs84_there_is_none_and_nothing_changes(write_dem, crs):
    at = Transformer.from_crs(4326, crs, always_xy=True).transform(14.4, 40.8)
    step = 1e-3 if CRS(crs).is_geographic else 30.0
    dem = open_dem(write_dem(np.zeros((9, 9)), crs, (at[0], step, 0.0, at[1], 0.0, -step)))
    assert dem.transformation is None
    assert dem.doubts == ()
    # To the last digit what PROJ says.
    assert to_wgs84(dem.crs, *at, dem.transformation) == Transformer.from_crs(
        dem.crs, 4326, always_xy=True
    ).transform(*at)


def test_another_choice_moves_detector_and_target_alike(helens, data_folder):
    by = Transformation(helens.crs, ((MEAN_OF_USA, False),), "NAD27 to WGS 84 (4)", 10.0)
    dem = replace(helens, transformation=by)
    place, target = (from_wgs84(dem.crs, *one, by) for one in (FLANK, CRATER))
    exact = Transformer.from_pipeline(MEAN_OF_USA)
    assert exact.transform(*place) == pytest.approx(FLANK, abs=1e-8)
    sight = take_sight(dem, place, target)
    assert metres(sight.detector_wgs84, FLANK) < 0.001
    assert metres(sight.target_wgs84, CRATER) < 0.001
    # Several metres from what PROJ would take.
    assert metres(to_wgs84(helens.crs, *place, helens.transformation), FLANK) > 1
    # Onto the map and back, by way of a projection on WGS 84.
    utm = CRS.from_epsg(32610)
    there = transformed(dem.crs, utm, *place, by=by)
    assert there == pytest.approx(Transformer.from_crs(4326, utm, always_xy=True).transform(*FLANK))
    assert transformed(utm, dem.crs, *there, by=by) == pytest.approx(place, abs=1e-3)
    # Within one datum it has no part.
    assert transformed(dem.crs, CRS.from_epsg(26711), *place, by=by) == pytest.approx(
        Transformer.from_crs(26710, 26711).transform(*place), abs=1e-6
    )
    # Voxels in the projection of the terrain stand where the detector does.
    frame = VolumeFrame.around(dem.crs, target, by)
    assert frame.place(*FLANK) == pytest.approx(place, abs=1e-6)


def test_a_step_backwards_is_the_same_operation(helens):
    x, y = 562_000.0, 5_115_000.0
    forth = operation_named(26710, "NAD27 to WGS 84 (4)")
    inverse = operation_named(26710, "NAD27 to WGS 84 (4)", back=True)
    by = Transformation(helens.crs, ((inverse.definition, True),), "NAD27 to WGS 84 (4)", 10.0)
    assert by.to_wgs84(x, y) == pytest.approx(forth.transform(x, y), abs=1e-8)
    assert by.from_wgs84(*by.to_wgs84(x, y)) == pytest.approx((x, y), abs=1e-3)
    place = forth.transform(x, y)
    assert leads((inverse.definition, True), (x, y), place)
    assert not leads((inverse.definition, False), (x, y), place)
    assert not leads((MEAN_OF_USA.replace("x=-8", "x=-9"), False), (x, y), place)
    missing = "+proj=pipeline +step +proj=hgridshift +grids=no_such_grid.tif"
    assert not leads((missing, False), (x, y), place)


def test_other_processes_take_the_same(helens):
    again = reopened_dem(json.loads(json.dumps(plain_dem(helens))))
    assert again.transformation == helens.transformation
    vesuvian = plain_dem(helens) | {"transformation": None}
    assert reopened_dem(vesuvian).transformation is None


def test_a_mask_on_wgs84_lies_where_the_terrain_says(helens, write_dem):
    by = Transformation(helens.crs, ((MEAN_OF_USA, False),), "NAD27 to WGS 84 (4)", 10.0)
    dem = replace(helens, transformation=by)
    # Allowed is one cell of 2 m around the detector.
    x, y = Transformer.from_crs(4326, 32610, always_xy=True).transform(*FLANK)
    allowed = np.zeros((3, 3))
    allowed[1, 1] = 1
    path = write_dem(allowed, "EPSG:32610", (x - 3, 2.0, 0.0, y + 3, 0.0, -2.0))
    mask = Mask(path, CRS.from_epsg(32610))
    place = np.array(from_wgs84(dem.crs, *FLANK, by))[:, None]
    assert mask.holds(dem.crs, *place, by).all()
    assert not mask.holds(dem.crs, *place, helens.transformation).any()


def simulated(dem, at, aim):
    sight = take_sight(dem, at, aim)
    return simulate(sight, Aperture(10.0, 4.0, 2, 2), Physics(), Telescope(6.0))


def test_a_muogram_names_its_transformation_and_finds_its_detector_again(helens):
    by = helens.transformation
    place, aim = (from_wgs84(helens.crs, *one, by) for one in (FLANK, CRATER))
    simulation = simulated(helens, place, aim)
    for muogram in simulation.muograms.values():
        assert muogram.metadata["TRANSFORMATION"] == by.name
        assert muogram.metadata["TRANSFORMATION_ACCURACY"] == by.accuracy_m
    frame, _ = check_detector(simulation.muograms["flux"], helens)
    x, y = helens.crs_position(*frame.ground_positions(0.0, 0.0))
    assert (float(x), float(y)) == pytest.approx(place, abs=0.001)


def test_an_unknown_accuracy_is_said(write_dem):
    # A datum that only an ellipsoid is known of.
    crs = "+proj=utm +zone=33 +ellps=intl"
    heights = 100.0 + np.arange(400.0).reshape(20, 20)
    dem = open_dem(write_dem(heights, crs, (450_000.0, 30.0, 0.0, 4_500_000.0, 0.0, -30.0)))
    assert dem.transformation.accuracy_m is None
    simulation = simulated(dem, (450_100.0, 4_499_900.0), (450_400.0, 4_499_600.0))
    assert simulation.muograms["flux"].metadata["TRANSFORMATION_ACCURACY"] == "unknown"
    (told,) = [one for one in simulation.warnings if "transformation" in one]
    assert "Ballpark" in told
    assert "unknown" in told


@pytest.mark.parametrize(
    ("description", "name"),
    [
        ("Inverse of UTM zone 10N + NAD27 to WGS 84 (4) + axis order change (2D)",
         "NAD27 to WGS 84 (4)"),
        ("Inverse of Lambert zone II + NTF (Paris) to NTF (1) + NTF to WGS 84 (1)",
         "NTF (Paris) to NTF (1) + NTF to WGS 84 (1)"),
        ("Ballpark geographic offset from NAD27 to WGS 84",
         "Ballpark geographic offset from NAD27 to WGS 84"),
        ("PROJ-based coordinate operation", "PROJ-based coordinate operation"),
        ("", "an operation without a name"),
    ],
)  # fmt: skip
def test_operations_are_called_by_what_changes_the_datum(description, name):
    assert name_of_operation(description) == name
