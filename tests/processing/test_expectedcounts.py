"""Expected counts through scripts and the shell."""

import csv
import sys
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal

gdal.UseExceptions()

RASTERS = (
    "COUNTS", "EXPOSURE", "RELATIVE_ERROR", "DENSITY_RESOLUTION", "CONTRAST_DAYS",
    "OPEN_SKY_COUNTS", "FLUX", "THICKNESS", "ACCEPTANCE",
)  # fmt: skip


def read(path):
    return gdal.Open(str(path)).ReadAsArray().astype(float)


@pytest.fixture
def job(vesuvius):
    return {
        **{name: vesuvius[name] for name in ("DEM", "DETECTOR", "TARGET")},
        "PRESET": "custom",
        "BARS_X": 8,
        "PIXEL_SIZE": 10,
        "SEPARATION": 200,
    }


@pytest.fixture
def everything(job, tmp_path):
    return {
        **job,
        **{name: str(tmp_path / f"{name.lower()}.tif") for name in RASTERS},
        "TABLE": str(tmp_path / "table.csv"),
        "PANEL": str(tmp_path / "panel.png"),
        "REPORT": str(tmp_path / "report.html"),
    }


@pytest.fixture
def refused(run, job, tmp_path):
    from qgis.core import QgsProcessingException

    def run_and_catch(**change):
        with pytest.raises(QgsProcessingException) as caught:
            run("expectedcounts", {**job, "COUNTS": str(tmp_path / "c.tif"), **change})
        assert list(tmp_path.iterdir()) == []
        said = str(caught.value).replace("Unable to execute algorithm\n", "").strip()
        assert "\n" not in said
        return said

    return run_and_catch


def test_every_output_is_written_and_declared(run, provider, everything):
    results = run("expectedcounts", everything)
    for name in (*RASTERS, "TABLE", "PANEL", "REPORT"):
        assert Path(results[name]).stat().st_size > 500
    algorithm = provider.algorithm("expectedcounts")
    assert set(results) <= {output.name() for output in algorithm.outputDefinitions()}
    assert all(type(value) in (int, float, str) for value in results.values())


def test_numbers_agree_with_the_rasters(run, everything):
    results = run("expectedcounts", {**everything, "DAYS": 10})
    counts = read(results["COUNTS"])
    assert counts.shape == (15, 15)
    assert results["TOTAL_RATE"] == pytest.approx(np.nansum(counts) / 10, rel=1e-6)
    assert results["UNKNOWN_TRAJECTORIES"] == np.count_nonzero(np.isnan(counts))
    assert results["TRAJECTORIES"] == 225
    assert 0 < results["ROCK_RATE"] < results["TOTAL_RATE"]
    np.testing.assert_allclose(read(results["RELATIVE_ERROR"]), 100 / np.sqrt(counts), rtol=1e-5)
    np.testing.assert_allclose(read(results["EXPOSURE"]), 100 / counts, rtol=1e-5)


def test_the_rasters_know_where_they_look(run, everything):
    results = run("expectedcounts", {**everything, "ROLL": 10, "BORESIGHT_ELEVATION": 25})
    metadata = gdal.Open(results["COUNTS"]).GetMetadata("MUYSC")
    assert metadata["PROJECTION"] == "tangent"
    assert float(metadata["ROLL"]) == 10
    assert float(metadata["BORESIGHT_ELEVATION"]) == 25
    assert float(metadata["DAYS"]) == 30
    with open(results["TABLE"], encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == 225
    (middle,) = [
        row
        for row in rows
        if row["offset to the right (pixels)"] == row["offset upwards (pixels)"] == "0"
    ]
    assert float(middle["elevation (°)"]) == pytest.approx(25)
    assert float(middle["azimuth (°)"]) == pytest.approx(float(metadata["BORESIGHT_AZIMUTH"]))
    assert float(middle["Muon counts"]) == pytest.approx(read(results["COUNTS"])[7, 7], rel=1e-5)
    # Rolled clockwise, the telescope's right looks lower.
    (right,) = [
        row
        for row in rows
        if row["offset to the right (pixels)"] == "5" and row["offset upwards (pixels)"] == "0"
    ]
    assert float(right["elevation (°)"]) < 23


def test_unknown_and_warnings_are_told(run, everything, recorder):
    feedback = recorder()
    results = run("expectedcounts", {**everything, "DETECTOR_HEIGHT": -5}, feedback)
    assert any("horizon" in text for text in feedback.infos)
    assert any("5 m below ground" in warning for warning in feedback.warnings)
    report = Path(results["REPORT"]).read_text(encoding="utf-8")
    for words in ("below ground", "horizon", "Peña-Rodríguez", "Lesparre", "SIBYLL", "3 σ"):
        assert words in report


def test_merging_trades_detail_for_time(run, everything):
    one = read(run("expectedcounts", everything)["CONTRAST_DAYS"])
    merged = read(run("expectedcounts", {**everything, "MERGE": 3})["CONTRAST_DAYS"])
    assert merged.shape == (5, 5)
    assert np.nanmedian(merged) < np.nanmedian(one)


def test_counts_can_be_draped_on_the_terrain(run, everything, tmp_path):
    results = run("expectedcounts", {**everything, "RAYS_PER_BAR": 2})
    draped = run(
        "drape",
        {"MUOGRAM": results["CONTRAST_DAYS"], "DEM": everything["DEM"],
         "OUTPUT": str(tmp_path / "draped.tif")},
    )  # fmt: skip
    assert draped["CELLS"] > 500
    values = read(draped["OUTPUT"])
    kept = np.unique(values[np.isfinite(values)])
    assert np.isin(kept, read(results["CONTRAST_DAYS"])).all()


def test_other_algorithms_name_what_they_were_given(run, everything, tmp_path):
    from qgis.core import QgsProcessingException

    results = run("expectedcounts", everything)
    with pytest.raises(QgsProcessingException, match="telescope angles"):
        run("muonflux", {"THICKNESS": results["THICKNESS"], "FLUX": str(tmp_path / "other.tif")})


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"BARS_X": 0}, ("0 bars across",)),
        ({"PIXEL_SIZE": 0}, ("pixel size of 0 cm",)),
        ({"BORESIGHT_ELEVATION": 95}, ("boresight elevation of 95°", "−90 to 90°")),
        ({"BORESIGHT_ELEVATION": -60}, ("raise the boresight",)),
        ({"BORESIGHT_AZIMUTH": 700}, ("boresight azimuth of 700°",)),
        ({"ROLL": 1000}, ("roll of 1000°",)),
        ({"DAYS": 0}, ("number of days is 0",)),
        ({"MUONS": -1}, ("number of muons is -1",)),
        ({"SIGMA": 0}, ("significance", "is 0")),
        ({"CONTRAST": 0}, ("contrast of 0 %",)),
        ({"CONTRAST": -150}, ("contrast of -150 %",)),
        ({"MERGE": 2}, ("2 trajectories", "odd number from 1 to 15")),
        ({"EFFICIENCY": 0}, ("efficiency of 0",)),
        ({"RAYS_PER_BAR": 99}, ("99 rays a bar", "1 to 50")),
        ({"STATISTICS": "bayes"}, ("bayes", "poisson")),
        ({"DENSITY": -1}, ("-1 g/cm³",)),
        ({"DETECTOR": "20,40 [EPSG:4326]"}, ("off the DEM",)),
        ({"TARGET": None}, ("TARGET is missing",)),
        ({"COUNTS": "counts.asc"}, ("COUNTS", ".tif")),
    ],
)
def test_what_cannot_be_is_refused_in_one_sentence(refused, change, words):
    said = refused(**change)
    assert said.endswith(".")
    for word in words:
        assert word in said


def test_a_cancelled_run_leaves_nothing(run, job, recorder, tmp_path):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match="Cancelled"):
        run("expectedcounts", {**job, "COUNTS": str(tmp_path / "c.tif")}, recorder(cancel_at=5))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("algorithm", ["expectedcounts", "telescope"])
def test_without_matplotlib_every_raster_is_written(
    run, job, tmp_path, recorder, monkeypatch, algorithm
):
    for name in [name for name in sys.modules if name.split(".")[0] == "matplotlib"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    feedback = recorder()
    raster = {"expectedcounts": "COUNTS", "telescope": "ACCEPTANCE"}[algorithm]
    outputs = {raster: str(tmp_path / "raster.tif"), "PANEL": str(tmp_path / "panel.png")}
    if algorithm == "telescope":
        job = {"COMPARISON": str(tmp_path / "comparison.png")}
    run(algorithm, {**job, **outputs}, feedback)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["raster.qml", "raster.tif"]
    assert any("matplotlib" in warning for warning in feedback.warnings)
