"""Can this survey see it, in counts: from telescopes on a ring to a verdict."""

import csv
from pathlib import Path

import numpy as np
import pytest

from muysc_qgis.volume import read_volume


@pytest.fixture
def setting(data_folder, tmp_path):
    return {
        "DEM": str(data_folder / "vesuvius_srtmgl1.tif"),
        "TARGET": "14.429444,40.822222 [EPSG:4326]", "RING_SITES": 3, "RING_RADIUS": 900,
        "MODEL": "sphere", "ROCK_DENSITY": 2.65, "BODY_DENSITY": 2.0, "BODY_RADIUS": 170,
        "BODY_MIDDLE": 1060, "EXTENT": "451300,452500,4518600,4519800 [EPSG:32633]",
        "VOXEL_SIZE": 120, "BASE": 900, "TOP": 1300, "PRESET": "custom", "BARS_X": 7,
        "PIXEL_SIZE": 8, "SEPARATION": 90, "DAYS": 200, "METHOD": "counts", "DRAWS": 2,
        "DENSITY": str(tmp_path / "density.tif"), "COVERAGE": None,
    }  # fmt: skip


def test_a_survey_ends_in_a_verdict(run, setting, recorder, tmp_path):
    feedback = recorder()
    table, report = str(tmp_path / "table.csv"), str(tmp_path / "report.html")
    results = run("reconstructiontest", {**setting, "TABLE": table, "REPORT": report}, feedback)
    assert results["SIGNIFICANCE"] > results["SIGNIFICANCE_OVERALL"] > 2
    assert results["SURVEYS_SEEING"] == 100
    assert 0.1 < results["CONTRAST"] < 1.3
    assert results["MUONS_COUNTED"] > 1e4
    assert read_volume(results["DENSITY"]).metadata["METHOD"] == "counts"
    assert any("This survey can see the body" in text for text in feedback.infos)
    with Path(table).open(encoding="utf-8-sig") as file:
        figures = {row["figure"]: row["value"] for row in csv.DictReader(file)}
    assert float(figures["Standard errors of the body at its place"]) == pytest.approx(
        results["SIGNIFICANCE"], rel=1e-3
    )
    assert Path(report).stat().st_size > 10_000


def test_what_cannot_be_used_is_said_in_a_sentence(run, setting, tmp_path):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match="outside the rock of the volume"):
        run("reconstructiontest", {**setting, "BODY_MIDDLE": 5000})
    with pytest.raises(QgsProcessingException, match=r"not within the bounds"):
        run("reconstructiontest", {**setting, "HIGHEST_DENSITY": 2.0})
    assert list(tmp_path.iterdir()) == []


def test_other_methods_tell_no_significance(run, setting):
    results = run("reconstructiontest", {**setting, "METHOD": "bayes", "VOXEL_SIZE": 200})
    assert np.isnan(results["SIGNIFICANCE"])
    assert np.isfinite(results["CONTRAST"])
