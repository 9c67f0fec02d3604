"""Tomography from what telescopes count: expected counts of Vesuvius become its density again."""

import csv
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from pyproj import Geod

from muysc_qgis.trajectories import read_trajectories, write_trajectories
from muysc_qgis.volume import read_volume

gdal.UseExceptions()

CRATER, DENSITY = (14.4265, 40.8215), 2.5
CONE = {
    "EXTENT": "450700,452600,4518100,4520000 [EPSG:32633]",
    "VOXEL_SIZE": 190, "BASE": 750, "TOP": 1300, "LENGTH_ERROR": 0, "TERRAIN_ERROR": 0,
}  # fmt: skip
TELESCOPE = {"PRESET": "custom", "BARS_X": 7, "PIXEL_SIZE": 9, "SEPARATION": 100}


@pytest.fixture(scope="module")
def dem_path(data_folder):
    return str(data_folder / "vesuvius_srtmgl1.tif")


@pytest.fixture(scope="module")
def counts(provider, dem_path, tmp_path_factory):
    """Return files of expected counts of three telescopes, in a folder with accents and a space."""
    import processing

    folder = tmp_path_factory.mktemp("cuentas ñ y")
    files = []
    for number, azimuth in enumerate((30, 150, 270)):
        longitude, latitude = Geod(ellps="WGS84").fwd(*CRATER, azimuth, 1200.0)[:2]
        results = processing.run("muysc:expectedcounts", {
            "DEM": dem_path, "DETECTOR": f"{longitude},{latitude} [EPSG:4326]",
            "TARGET": f"{CRATER[0]},{CRATER[1]} [EPSG:4326]", "DETECTOR_HEIGHT": 2,
            "BORESIGHT_ELEVATION": 20, "DENSITY": DENSITY, "DAYS": 60, "EFFICIENCY": 0.9,
            "COUNTS": str(folder / f"site {number}.tif"), **TELESCOPE,
        })  # fmt: skip
        files.append(results["COUNTS"])
    return files


@pytest.fixture
def setting(counts, dem_path, tmp_path):
    return {
        "MUOGRAMS": counts, "DEM": dem_path, **CONE, "METHOD": "counts",
        "REFERENCE_DENSITY": 2.65, "DENSITY": str(tmp_path / "density.tif"), "COVERAGE": None,
    }  # fmt: skip


def test_expected_counts_give_back_the_density(run, setting, tmp_path):
    results = run("tomography", {
        **setting, "DENSITY_ERROR": str(tmp_path / "error.tif"),
        "STATION_FACTORS": str(tmp_path / "factors.csv"),
        "RESIDUAL_MUOGRAMS": str(tmp_path / "residuals"), "RESIDUALS": str(tmp_path / "left.csv"),
        "REPORT": str(tmp_path / "report.html"),
    })  # fmt: skip
    volume = read_volume(results["DENSITY"])
    values = volume.values[volume.known]
    assert volume.metadata["METHOD"] == "counts"
    assert values.mean() == pytest.approx(DENSITY, abs=0.08)
    assert values.std() < 0.08
    # Without noise only what the two quadratures differ by is left to explain.
    assert results["CHI_SQUARED"] < 1
    error = read_volume(results["DENSITY_ERROR"])
    assert np.nanmax(error.values) < np.hypot(0.2, 0.3)
    assert np.mean(np.abs(values - DENSITY) < error.values[volume.known]) > 0.9
    with Path(results["STATION_FACTORS"]).open(encoding="utf-8-sig") as file:
        rows = list(csv.DictReader(file))
    factors = [float(row["found"]) for row in rows if row["quantity"] == "factor of the counts"]
    assert factors == pytest.approx([1.0] * 3, abs=0.01)
    assert {row["station"] for row in rows} == {"all", "site 0", "site 1", "site 2"}
    residuals = sorted(Path(results["RESIDUAL_MUOGRAMS"]).glob("*.tif"))
    assert [one.name for one in residuals] == [f"site {n}_residual.tif" for n in range(3)]
    left = read_trajectories(residuals[0])
    assert left.quantity == "residual"
    assert np.nanmax(np.abs(left.values)) < 4
    report = Path(results["REPORT"]).read_text(encoding="utf-8")
    assert "Fit of counts" in report


def test_a_station_that_counts_less_is_found_and_told(run, setting, counts, tmp_path, recorder):
    raster = read_trajectories(counts[1])
    less = str(tmp_path / "low.tif")
    write_trajectories(replace(raster, values=0.5 * raster.values), less)
    feedback = recorder()
    factors = str(tmp_path / "factors.csv")
    changed = {**setting, "MUOGRAMS": [counts[0], less, counts[2]], "STATION_FACTORS": factors}
    results = run("tomography", changed, feedback)
    with Path(results["STATION_FACTORS"]).open(encoding="utf-8-sig") as file:
        found = {
            row["station"]: float(row["found"])
            for row in csv.DictReader(file)
            if row["quantity"] == "factor of the counts"
        }
    assert found["low"] / found["site 0"] == pytest.approx(0.5, abs=0.02)
    assert any("check its acceptance, efficiency and days" in one for one in feedback.warnings)
    assert any("factor of the counts" in one for one in feedback.infos)


def test_the_default_method_gives_way_to_that_of_counts(run, setting):
    results = run("tomography", {k: v for k, v in setting.items() if k != "METHOD"})
    assert read_volume(results["DENSITY"]).metadata["METHOD"] == "counts"


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"METHOD": "sirt"}, r"counts, which sirt cannot read: pixels without a muon"),
        ({"TERRAIN_MASK": False}, r"TERRAIN_MASK is off; switch it on"),
        ({"REFERENCE_DENSITY": 2.65, "HIGHEST_DENSITY": 2.0}, r"not within the bounds 0 to 2"),
        ({"EXTENT": "440700,440900,4508100,4508300 [EPSG:32633]"}, r"(?i)extent"),
    ],
)
def test_what_cannot_be_used_is_said_in_a_sentence(run, setting, tmp_path, change, sentence):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match=sentence):
        run("tomography", {**setting, **change})
    assert list(tmp_path.iterdir()) == []


def test_opacities_are_not_counts(run, setting, counts, tmp_path):
    from qgis.core import QgsProcessingException

    raster = read_trajectories(counts[0])
    density = str(tmp_path / "density of old.tif")
    write_trajectories(replace(raster, quantity="density", values=0 * raster.values + 2.5), density)
    with pytest.raises(QgsProcessingException, match=r"method counts fits rasters of counts"):
        run("tomography", {**setting, "MUOGRAMS": [density]})
    with pytest.raises(QgsProcessingException, match=r"holds density; choose a muogram of"):
        run("tomography", {**setting, "MUOGRAMS": [density, counts[1]]})
