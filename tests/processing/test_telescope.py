"""Telescope parameters through scripts: numbers, files, and what is refused."""

import csv

import numpy as np
import pytest
from osgeo import gdal

gdal.UseExceptions()

RASTERS = ("ACCEPTANCE", "SOLID_ANGLE", "DETECTION_AREA", "PATH_LENGTH", "ANGULAR_RESOLUTION")


def read(path):
    return gdal.Open(str(path)).ReadAsArray().astype(float)


@pytest.fixture
def everything(tmp_path):
    return {
        **{name: str(tmp_path / f"{name.lower()}.tif") for name in RASTERS},
        "TABLE": str(tmp_path / "table.csv"),
        "PANEL": str(tmp_path / "panel.png"),
        "COMPARISON": str(tmp_path / "comparison.png"),
        "REPORT": str(tmp_path / "report.html"),
    }


@pytest.fixture
def refused(run, tmp_path):
    from qgis.core import QgsProcessingException

    def run_and_catch(**change):
        with pytest.raises(QgsProcessingException) as caught:
            run("telescope", {"ACCEPTANCE": str(tmp_path / "a.tif"), **change})
        assert list(tmp_path.iterdir()) == []
        said = str(caught.value).replace("Unable to execute algorithm\n", "").strip()
        assert "\n" not in said
        return said

    return run_and_catch


def test_it_runs_without_any_parameter(run, tmp_path):
    results = run("telescope", {"ACCEPTANCE": str(tmp_path / "a.tif")})
    # MuTe, by the table of the MUYSC paper.
    assert results["MAX_ACCEPTANCE"] == pytest.approx(3.686, rel=2e-4)
    assert results["TRAJECTORIES"] == 59**2
    assert results["MAX_DETECTION_AREA"] == 14_400
    assert results["ETENDUE"] == pytest.approx(2890, abs=0.5)
    assert int(results["APERTURE"]) == 25
    assert all(type(value) in (int, float, str) for value in results.values())


def test_every_output_is_written_and_declared(run, provider, everything, tmp_path):
    results = run("telescope", {"PRESET": "lesparre2012", **everything})
    for path in everything.values():
        assert (tmp_path / path).stat().st_size > 500
    declared = {output.name() for output in provider.algorithm("telescope").outputDefinitions()}
    assert set(results) <= declared
    report = (tmp_path / "report.html").read_text(encoding="utf-8")
    for words in ("Lesparre", "La Soufrière", "Sullivan", "Thomas", "cm² sr", "Étendue"):
        assert words in report


def test_rasters_are_in_tangents_and_agree_with_the_numbers(run, everything):
    results = run("telescope", {"PRESET": "gibert2010", **everything})
    acceptance = read(results["ACCEPTANCE"])
    assert acceptance.shape == (63, 63)
    assert acceptance.max() == pytest.approx(results["MAX_ACCEPTANCE"], rel=1e-6)
    assert acceptance.sum() == pytest.approx(results["ETENDUE"], rel=1e-6)
    assert read(results["SOLID_ANGLE"]).max() == pytest.approx(results["MAX_SOLID_ANGLE"])
    dataset = gdal.Open(results["ACCEPTANCE"])
    left, step_x, _, top, _, step_y = dataset.GetGeoTransform()
    assert (step_x, step_y) == pytest.approx((0.05, -0.05))
    assert left + 31.5 * step_x == pytest.approx(0)
    assert top + 31.5 * step_y == pytest.approx(0)
    metadata = dataset.GetMetadata("MUYSC")
    assert metadata["PROJECTION"] == "tangent"
    assert metadata["FORMULA"] == "exact"
    assert float(metadata["SEPARATION"]) == 100


def test_the_table_has_units_and_every_trajectory(run, everything):
    results = run(
        "telescope",
        {"PRESET": "custom", "BARS_X": 4, "BARS_Y": 3, "PIXEL_SIZE": 10, "SEPARATION": 80,
         "FORMULA": "paper", **everything},
    )  # fmt: skip
    with open(results["TABLE"], encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == 7 * 5
    (row,) = [
        row
        for row in rows
        if row["offset to the right (pixels)"] == "2" and row["offset upwards (pixels)"] == "-1"
    ]
    assert float(row["Detection area (cm²)"]) == 2 * 2 * 100
    assert float(row["Acceptance (cm² sr)"]) == pytest.approx(4 * 1e4 / (80**2 + 100 * 5))
    assert float(row["tangent to the right"]) == pytest.approx(0.25)


def test_a_preset_wins_over_numbers_and_says_so(run, recorder, tmp_path):
    feedback = recorder()
    results = run(
        "telescope",
        {"PRESET": "mute", "SEPARATION": 100, "ACCEPTANCE": str(tmp_path / "a.tif")},
        feedback,
    )
    assert results["MAX_ACCEPTANCE"] == pytest.approx(3.686, rel=2e-4)
    (warning,) = feedback.warnings
    assert "separation (cm) 100 is not used, because the preset mute has 250" in warning


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"PRESET": "hubble"}, ("PRESET", "hubble", "mute")),
        ({"PRESET": "custom"}, ("bars across", "missing")),
        ({"BARS_X": 0}, ("0 bars across", "from 1 to 1000")),
        ({"BARS_X": 2.5}, ("2.5 bars across", "whole number")),
        ({"BARS_Y": -1}, ("-1 bars up",)),
        ({"PIXEL_SIZE": 0}, ("pixel size of 0 cm", "above 0")),
        ({"SEPARATION": 0}, ("separation of the planes of 0 cm",)),
        ({"SEPARATION": "wide"}, ("SEPARATION", "wide", "not a finite number")),
        ({"PLANES": 1}, ("1 planes", "from 2 to 20")),
        ({"FORMULA": "rough"}, ("FORMULA", "rough", "exact")),
        ({"TABLE": "table.txt"}, ("TABLE", ".csv")),
        ({"COMPARISON": "comparison.jpg"}, ("COMPARISON", ".png")),
    ],
)
def test_what_cannot_be_is_refused_in_one_sentence(refused, change, words):
    numbers = {"PRESET": "custom", "BARS_X": 5, "PIXEL_SIZE": 5, "SEPARATION": 80}
    said = refused(**(change if "PRESET" in change else {**numbers, **change}))
    assert said.endswith(".")
    for word in words:
        assert word in said


def test_radiography_takes_a_telescope(run, vesuvius, tmp_path, recorder):
    outputs = {name: str(tmp_path / f"{name}.tif") for name in ("FLUX", "THICKNESS", "EXPOSURE")}
    feedback = recorder()
    results = run("radiography", {**vesuvius, **outputs, "PRESET": "mute"}, feedback)
    exposure, flux = read(results["EXPOSURE"]), read(results["FLUX"])
    # In the middle of 21 × 11 pixels it looks along the axis.
    assert exposure[5, 10] == pytest.approx(10 / (flux[5, 10] * 3.68577), rel=1e-4)
    assert np.all(exposure[5, [0, 20]] * flux[5, [0, 20]] > 10 / 3.68577)
    metadata = gdal.Open(results["EXPOSURE"]).GetMetadata("MUYSC")
    assert float(metadata["ACCEPTANCE"]) == pytest.approx(3.68577, rel=1e-5)
    custom = run(
        "radiography",
        {**vesuvius, **outputs, "PRESET": "custom", "BARS_X": 4, "PIXEL_SIZE": 5,
         "SEPARATION": 200},
        feedback,
    )  # fmt: skip
    assert np.isnan(read(custom["EXPOSURE"])).any()
    assert any("outside the telescope's field of view" in warning for warning in feedback.warnings)
    unused = recorder()
    run("radiography", {**vesuvius, **outputs, "BARS_X": 4}, unused)
    assert any("BARS_X is not used" in warning for warning in unused.warnings)
