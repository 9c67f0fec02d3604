"""Can this survey see it?: what it asks for, what it refuses, what it finds."""

import csv
from pathlib import Path

import numpy as np
import pytest
from pyproj import CRS

from muysc_qgis.volume import read_volume
from muysc_qgis.workflows.volume_frame import VolumeFrame

SUMMIT = "14.429444,40.822222 [EPSG:4326]"

POLYGON = (
    "POLYGON((451100 4519000, 451300 4519000, 451300 4519200, 451100 4519200, 451100 4519000))"
)


@pytest.fixture
def small(vesuvius, tmp_path):
    """Eight stations around the cone, coarse enough for many tests."""
    return {
        "DEM": vesuvius["DEM"],
        "TARGET": SUMMIT,
        "RING_SITES": 8,
        "RING_RADIUS": 800,
        "AZIMUTH_APERTURE": 100,
        "ELEVATION_APERTURE": 28,
        "AZIMUTH_PIXELS": 12,
        "ELEVATION_PIXELS": 12,
        "ACCEPTANCE": 100,
        "DAYS": 1000,
        "MINIMUM_COUNTS": 0,
        "VOXEL_SIZE": 100,
        "BASE": 900,
        "DENSITY": str(tmp_path / "density.tif"),
        "COVERAGE": str(tmp_path / "coverage.tif"),
    }


def polygons(fields, rows):
    """Return a layer of polygons in the UTM zone of Vesuvius."""
    from qgis.core import QgsFeature, QgsGeometry, QgsVectorLayer

    layer = QgsVectorLayer(
        "Polygon?crs=EPSG:32633&" + "&".join(f"field={name}:double" for name in fields),
        "bodies",
        "memory",
    )
    for wkt, values in rows:
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromWkt(wkt))
        feature.setAttributes(values)
        layer.dataProvider().addFeature(feature)
    layer.updateExtents()
    return layer


def test_it_introduces_itself(provider):
    algorithm = provider.algorithm("reconstructiontest")
    assert algorithm.displayName() == "Can this survey see it?"


def test_it_finds_a_conduit_and_writes_everything(run, small, tmp_path):
    names = {
        "DENSITY": "density.tif", "COVERAGE": "coverage.tif", "TRUTH": "truth.tif",
        "STATIONS": "stations.gpkg", "TABLE": "errors.csv", "RESIDUALS": "residuals.csv",
        "PANEL": "panel.png",
    }  # fmt: skip
    files = {name: str(tmp_path / file) for name, file in names.items()}
    results = run("reconstructiontest", {**small, **files, "BODY_DENSITY": 1.9})
    assert all(Path(file).stat().st_size > 0 for file in files.values())
    assert 0.6 < results["CONTRAST"] < 1.1
    assert results["SITES_USED"] == 8
    assert results["RELATIVE_L2"] < 0.08
    with open(files["TABLE"], encoding="utf-8") as file:
        table = {row["figure"]: float(row["value"]) for row in csv.DictReader(file)}
    assert table["Contrast found over the true one"] == pytest.approx(results["CONTRAST"], rel=1e-3)
    assert table["Front view: mean |ε| (km)"] == pytest.approx(results["FRONT_ERROR"], rel=1e-3)


def test_the_known_model_has_the_densities_of_rock_and_body(run, small, tmp_path):
    files = {"TRUTH": str(tmp_path / "truth.tif"), "DENSITY": small["DENSITY"]}
    run("reconstructiontest", {**small, **files, "ROCK_DENSITY": 2.4, "BODY_RADIUS": 200})
    truth, found = (read_volume(files[name]) for name in ("TRUTH", "DENSITY"))
    assert truth.grid == found.grid
    assert np.nanmin(truth.values) == pytest.approx(2.15)
    assert np.nanmax(truth.values) == pytest.approx(2.4)
    # The body stands under the target, the summit.
    frame = VolumeFrame.around(CRS.from_wkt(truth.crs), (451_900.0, 4_519_000.0))
    x, y = frame.place(14.429444, 40.822222)
    column = int((x - truth.grid.origin_m[0]) // truth.grid.size_m[0])
    row = int((y - truth.grid.origin_m[1]) // truth.grid.size_m[1])
    known = truth.values[column, row][np.isfinite(truth.values[column, row])]
    assert known == pytest.approx(np.full(len(known), 2.15))


def test_the_same_seed_draws_the_same_counts(run, small):
    fewer = {**small, "RING_SITES": 3, "AZIMUTH_PIXELS": 8, "ELEVATION_PIXELS": 8}
    first, again, other = (
        run("reconstructiontest", {**fewer, "MODEL": "uniform", "SEED": seed}) for seed in (3, 3, 4)
    )
    assert first["MUONS_COUNTED"] == again["MUONS_COUNTED"] != other["MUONS_COUNTED"]
    assert first["SPREAD"] == again["SPREAD"] != other["SPREAD"]


def test_without_noise_a_uniform_mountain_is_found_as_it_is(run, small):
    results = run("reconstructiontest", {**small, "MODEL": "uniform", "NOISE": False})
    assert results["SPREAD"] < 0.002
    assert abs(results["BIAS"]) < 0.002
    assert np.isnan(results["MUONS_COUNTED"])


def test_the_shape_is_found_without_the_terrain(run, small):
    """As the paper does it: every voxel is unknown, and the data are exact."""
    exact = {"MODEL": "uniform", "NOISE": False, "RELATIVE_ERROR": 0, "LENGTH_ERROR": 0}
    options = {"TERRAIN_MASK": False, "METHOD": "sirt", "HIGHEST_DENSITY": 2.65}
    results = run("reconstructiontest", {**small, **exact, **options})
    assert results["ITERATIONS_DONE"] == 50
    assert results["TOP_ERROR"] < 0.15


@pytest.mark.parametrize("model", ["sphere", "checkerboard"])
def test_every_model_runs(run, small, model):
    sizes = {"BODY_RADIUS": 200, "BODY_EDGE": 300}
    results = run("reconstructiontest", {**small, **sizes, "MODEL": model, "NOISE": False})
    assert results["CONTRAST"] > 0.2


def test_polygons_are_bodies_with_densities_of_their_own(run, small):
    layer = polygons(["density", "base", "top"], [(POLYGON, [3.2, 900, 1100])])
    results = run(
        "reconstructiontest", {**small, "MODEL": "polygons", "POLYGONS": layer, "NOISE": False}
    )
    assert 0.3 < results["CONTRAST"] < 1.2


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"MODEL": "polygons"}, "POLYGONS is missing; choose a layer of polygons with the fields"),
        ({"DAYS": 0}, "The time of counting in days is 0; give a finite number above 0"),
        ({"RING_RADIUS": 50_000}, "8 are off the DEM or in a gap of it"),
        ({"RING_SLOPE": 0.01}, "8 are too steep"),
        ({"RING_TOLERANCE": 900}, "Places on a ring of 800 m cannot be moved by 900 m"),
        ({"BODY_BASE": 2000, "BODY_TOP": 2500}, "The body “conduit” is outside the rock"),
        ({"BODY_BASE": 1000, "BODY_TOP": 950}, "The height of the conduit is -50 m"),
        ({"BODY_RADIUS": 0}, "The radius of the conduit is 0 m"),
        ({"BODY_POSITION": "14.36,40.77 [EPSG:4326]"}, "The body “conduit” is outside the rock"),
        ({"MODEL": "cube"}, "MODEL is “cube”; use one of uniform, checkerboard, conduit"),
        ({"METHOD": "fbp"}, "needs parallel rays"),
    ],
)
def test_what_cannot_be_tried_is_refused_in_a_sentence(run, small, changes, sentence):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match=sentence.replace("(", r"\(")):
        run("reconstructiontest", {**small, **changes})


@pytest.mark.parametrize(
    ("fields", "values", "sentence"),
    [
        (["density", "top"], [2.0, 1000], "POLYGONS lacks the field base"),
        (["rho"], [2.0], "lacks the fields density, base, top"),
        (["density", "base", "top"], [2.0, 1000, 900], "from 1000 m up to 900 m"),
        (["density", "base", "top"], [-1.0, 900, 1000], "The density of polygon 1 is -1 g/cm³"),
        (["density", "base", "top"], [None, 900, 1000], "Polygon 1 has the density “NULL”"),
    ],
)
def test_polygons_that_lack_something_are_named(run, small, fields, values, sentence):
    from qgis.core import QgsProcessingException

    layer = polygons(fields, [(POLYGON, values)])
    with pytest.raises(QgsProcessingException, match=sentence):
        run("reconstructiontest", {**small, "MODEL": "polygons", "POLYGONS": layer})


def test_sites_of_a_layer_stand_in_for_the_ring(run, small, recorder, tmp_path):
    from qgis.core import QgsFeature, QgsGeometry, QgsVectorLayer

    layer = QgsVectorLayer("Point?crs=EPSG:4326&field=name:string", "sites", "memory")
    for name, x, y in (
        ("north", 14.4294, 40.8300), ("east", 14.4390, 40.8222), ("south", 14.4294, 40.8140),
        ("west", 14.4190, 40.8222), ("sea", 14.0, 40.5),
    ):  # fmt: skip
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromWkt(f"POINT({x} {y})"))
        feature.setAttributes([name])
        layer.dataProvider().addFeature(feature)
    feedback = recorder()
    stations = str(tmp_path / "stations.gpkg")
    results = run(
        "reconstructiontest",
        {**small, "SITES": layer, "NAME_FIELD": "name", "MODEL": "uniform", "NOISE": False,
         "STATIONS": stations},
        feedback,
    )  # fmt: skip
    assert results["SITES_USED"] == 4
    assert any("Site sea was skipped" in text for text in feedback.warnings)
    written = QgsVectorLayer(stations, "stations")
    assert [one["site"] for one in written.getFeatures()] == ["north", "east", "south", "west"]
