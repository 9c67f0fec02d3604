"""Importing text: the raster that comes out follows the contract, and goes on from there."""

import numpy as np
import pytest
from osgeo import gdal

from muysc_qgis.muogram import Muogram, read_muogram, write_muogram

gdal.UseExceptions()

TABLE = "azimuth,zenith,counts\n10,80,4\n11,80,5\n10,79,6\n11,79,7\n"


@pytest.fixture
def table(tmp_path):
    path = tmp_path / "tabla ñ.csv"
    path.write_text(TABLE)
    return str(path)


@pytest.fixture
def reference(tmp_path):
    path = tmp_path / "thickness.tif"
    metadata = {
        "DETECTOR_LON": 14.4, "DETECTOR_LAT": 40.8, "DETECTOR_ELEVATION": 600.0,
        "TARGET_DISTANCE": 1883.0, "BORESIGHT_AZIMUTH": 10.6, "BORESIGHT_ELEVATION": 10.4,
        "DENSITY": 2.65, "FLUX_MODEL": "guan",
    }  # fmt: skip
    write_muogram(
        Muogram(
            "thickness",
            np.full((2, 2), 900.0),
            np.array([10.0, 11.0]),
            np.array([11.0, 10.0]),
            metadata,
        ),
        path,
    )
    return str(path)


@pytest.fixture
def load(run, tmp_path):
    def run_import(feedback=None, **parameters):
        return run("importmuogram", {"OUTPUT": str(tmp_path / "made.tif"), **parameters}, feedback)

    return run_import


def test_the_raster_follows_the_contract(load, table, recorder):
    feedback = recorder()
    results = load(
        feedback, INPUT=table, DETECTOR="14.41,40.81 [EPSG:4326]", DETECTOR_ELEVATION=604.5,
        EXPOSURE=30, ACCEPTANCE=6.5,
    )  # fmt: skip
    assert (results["PIXELS"], results["UNKNOWN_PIXELS"], results["TOTAL"]) == (4, 0, 22)
    dataset = gdal.Open(results["OUTPUT"])
    band = dataset.GetRasterBand(1)
    assert band.DataType == gdal.GDT_Float32
    assert np.isnan(band.GetNoDataValue())
    assert dataset.GetGeoTransform() == (9.5, 1, 0, 11.5, 0, -1)
    np.testing.assert_array_equal(dataset.ReadAsArray(), [[6, 7], [4, 5]])
    metadata = dataset.GetMetadata("MUYSC")
    assert metadata["QUANTITY"] == "counts"
    assert metadata["UNIT"] == "1"
    for key, value in (
        ("DETECTOR_LON", 14.41), ("DETECTOR_LAT", 40.81), ("DETECTOR_ELEVATION", 604.5),
        ("BORESIGHT_AZIMUTH", 10.5), ("BORESIGHT_ELEVATION", 10.5), ("DAYS", 30),
        ("ACCEPTANCE", 6.5),
    ):  # fmt: skip
        assert float(metadata[key]) == value
    assert not feedback.warnings


def test_a_reference_hands_over_the_place_and_nothing_else(load, table, reference):
    metadata = read_muogram(load(INPUT=table, REFERENCE=reference)["OUTPUT"]).metadata
    assert float(metadata["DETECTOR_ELEVATION"]) == 600
    assert float(metadata["BORESIGHT_AZIMUTH"]) == 10.6
    assert float(metadata["TARGET_DISTANCE"]) == 1883
    assert not {"DENSITY", "FLUX_MODEL"} & set(metadata)
    metadata = read_muogram(
        load(INPUT=table, REFERENCE=reference, DETECTOR_ELEVATION=777)["OUTPUT"]
    ).metadata
    assert float(metadata["DETECTOR_ELEVATION"]) == 777


def test_a_detector_in_another_crs_is_transformed(load, table):
    # Zone 33 N: the central meridian is 15° E, easting 500 km; northing by pyproj.
    from pyproj import Transformer

    x, y = Transformer.from_crs(4326, 32633, always_xy=True).transform(14.41, 40.81)
    made = load(INPUT=table, DETECTOR=f"{x},{y} [EPSG:32633]")["OUTPUT"]
    metadata = read_muogram(made).metadata
    assert float(metadata["DETECTOR_LON"]) == pytest.approx(14.41, abs=1e-6)
    assert float(metadata["DETECTOR_LAT"]) == pytest.approx(40.81, abs=1e-6)


def test_a_bare_detector_and_a_missing_one_are_told(load, table, recorder):
    feedback = recorder()
    load(feedback, INPUT=table, DETECTOR="14.41,40.81", DETECTOR_ELEVATION=0)
    assert any("EPSG:4326 is assumed" in info for info in feedback.infos)
    feedback = recorder()
    load(feedback, INPUT=table)
    assert any("DETECTOR_LON" in warning for warning in feedback.warnings)


def test_errors_come_out_as_a_second_raster(load, tmp_path):
    path = tmp_path / "flux.txt"
    path.write_text("az el flux err\n10 5 1.5 .1\n11 5 2.5 .2\n")
    results = load(INPUT=str(path), QUANTITY="flux", ERROR=str(tmp_path / "error.tif"))
    errors = read_muogram(results["ERROR"])
    assert errors.quantity == "flux_error"
    np.testing.assert_allclose(errors.values, [[0.1, 0.2]], rtol=1e-6)


def test_a_matrix_takes_its_angles_from_parameters_or_the_reference(load, tmp_path, reference):
    path = tmp_path / "matrix.txt"
    path.write_text("6 7\n4 5\n")
    by_angles = load(
        INPUT=str(path), VERTICAL_ANGLE="zenith", AZIMUTH_FIRST=10, AZIMUTH_LAST=11,
        VERTICAL_FIRST=79, VERTICAL_LAST=80,
    )  # fmt: skip
    first = read_muogram(by_angles["OUTPUT"])
    second = read_muogram(load(INPUT=str(path), REFERENCE=reference)["OUTPUT"])
    for muogram in (first, second):
        np.testing.assert_array_equal(muogram.values, [[6, 7], [4, 5]])
        np.testing.assert_array_equal(muogram.elevation_deg, [11, 10])


def test_counts_go_on_to_a_density(run, load, table, reference, tmp_path):
    counts = load(INPUT=table, REFERENCE=reference, EXPOSURE=30, ACCEPTANCE=6)["OUTPUT"]
    results = run(
        "density",
        {
            "COUNTS": counts, "THICKNESS": reference,
            "DENSITY": str(tmp_path / "d.tif"), "DENSITY_ERROR": str(tmp_path / "e.tif"),
        },
    )  # fmt: skip
    assert results["ROCK_PIXELS"] == 4
    assert results["MEAN_DENSITY"] > 0


def test_an_algorithm_as_models_and_dialogs_see_it(provider):
    algorithm = provider.algorithm("importmuogram")
    names = {one.name() for one in algorithm.parameterDefinitions()}
    assert names >= {"INPUT", "QUANTITY", "VERTICAL_ANGLE", "ANGLE_UNIT", "REFERENCE", "OUTPUT"}
    assert {one.name() for one in algorithm.outputDefinitions()} >= {"OUTPUT", "TOTAL", "PIXELS"}
    assert "line" in algorithm.shortHelpString()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"INPUT": None}, ("INPUT is missing",)),
        ({"INPUT": "/no/such/table.csv"}, ("/no/such/table.csv", "cannot be read")),
        ({"QUANTITY": "muons"}, ("muons", "counts, flux")),
        ({"VERTICAL_ANGLE": "theta"}, ("theta", "zenith")),
        ({"VALUE_COLUMN": "rate"}, ("rate", "azimuth, zenith, counts")),
        ({"FACTOR": 0}, ("FACTOR is 0",)),
        ({"FACTOR": 0.5}, ("fractional", "3.5")),
        ({"DETECTOR": "here"}, ("here", "x,y")),
        ({"DETECTOR": "450000,4518000"}, ("450000", "nowhere on Earth")),
        ({"DETECTOR_ELEVATION": 20000}, ("20000", "10000")),
        ({"EXPOSURE": 0}, ("EXPOSURE is 0", "above 0")),
        ({"ERROR": "error.tif"}, ("no errors were found",)),
        ({"RELATIVE": True}, ("boresight", "BORESIGHT_AZIMUTH")),
        ({"OUTPUT": "counts.asc"}, (".tif",)),
    ],
)
def test_what_cannot_be_used_is_refused(load, table, tmp_path, change, words):
    from qgis.core import QgsProcessingException

    for name in ("ERROR", "OUTPUT"):
        if name in change:
            change = {**change, name: str(tmp_path / change[name])}
    with pytest.raises(QgsProcessingException) as caught:
        load(**{"INPUT": table, **change})
    said = str(caught.value).replace("Unable to execute algorithm\n", "")
    for word in words:
        assert word in said
    assert "\n" not in said.strip()
    assert not list(tmp_path.glob("*.tif"))
