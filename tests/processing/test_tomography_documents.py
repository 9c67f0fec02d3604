"""Panel, report and section of a tomography, from muograms that were simulated."""

import html
import json
import re
from pathlib import Path

import pytest

#: West, south and east of Gran Cono.
DETECTORS = ("14.4108,40.8196", "14.4262,40.8108", "14.4415,40.8236")


@pytest.fixture
def muograms(run, vesuvius, tmp_path):
    paths = []
    for number, place in enumerate(DETECTORS):
        path = str(tmp_path / f"station {number + 1}.tif")
        small = {"AZIMUTH_PIXELS": 9, "ELEVATION_PIXELS": 6, "DETECTOR": f"{place} [EPSG:4326]"}
        unwanted = {"THICKNESS": str(tmp_path / f"thickness {number}.tif"),
                    "FLUX": str(tmp_path / f"flux {number}.tif")}  # fmt: skip
        run("radiography", {**vesuvius, **small, **unwanted, "OPACITY": path})
        paths.append(path)
    return paths


@pytest.fixture
def job(vesuvius, muograms, tmp_path):
    files = {"DENSITY": "density.tif", "COVERAGE": "coverage.tif", "PANEL": "panel.png",
             "REPORT": "report.html", "RESIDUALS": "residuals.csv"}  # fmt: skip
    return {
        "MUOGRAMS": muograms, "DEM": vesuvius["DEM"], "VOXELS": 12, "METHOD": "sirt",
        "RELATIVE_ERROR": 0.1, "ITERATIONS": 5, "REFERENCE_DENSITY": 2.5,
        **{name: str(tmp_path / file) for name, file in files.items()},
    }  # fmt: skip


def table(report, name):
    """Return one table of a report: rows of texts by their labels."""
    (body,) = re.findall(rf'<h2 id="{name}">.*?<tbody>(.*?)</tbody>', report, re.DOTALL)
    rows = [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row, re.DOTALL)
            for row in re.findall(r"<tr.*?</tr>", body, re.DOTALL)]  # fmt: skip
    return {label: [html.unescape(value) for value in values] for label, *values in rows}


def test_the_report_tells_what_counts(run, job, tmp_path):
    results = run("tomography", job)
    report = Path(results["REPORT"]).read_text(encoding="utf-8")
    told = table(report, "parameters")
    assert told["Muograms"] == ["station 1.tif, station 2.tif, station 3.tif", ""]
    assert told["Method"] == ["SIRT", ""]
    assert told["Memory"] == ["4", "GiB"]
    assert "Relaxation" in told
    # What belongs to other methods has no meaning here.
    assert not [label for label in told if "prior" in label or "hybrid" in label]
    numbers = table(report, "results")
    assert int(numbers["Rays used"][0]) == results["RAYS"]
    assert int(numbers["Iterations"][0]) == results["ITERATIONS_DONE"]
    assert float(numbers["Mean density"][0]) == pytest.approx(results["MEAN_DENSITY"], abs=1e-4)
    files = table(report, "files")
    assert files["Residuals"] == ["residuals.csv"]
    assert report.count("<img ") == 2
    assert Path(results["PANEL"]).read_bytes().startswith(b"\x89PNG")


def test_a_line_gives_a_section_of_its_own_and_in_the_report(run, job, tmp_path):
    line = tmp_path / "line.geojson"
    ends = [[14.416, 40.818], [14.436, 40.826]]
    line.write_text(json.dumps({
        "type": "Feature", "properties": {},
        "geometry": {"type": "LineString", "coordinates": ends},
    }))  # fmt: skip
    section = {"SECTION_LINE": str(line), "SECTION": str(tmp_path / "section.png")}
    results = run("tomography", {**job, **section})
    assert Path(results["SECTION"]).read_bytes().startswith(b"\x89PNG")
    report = Path(results["REPORT"]).read_text(encoding="utf-8")
    assert report.count("<img ") == 3
    assert table(report, "parameters")["Line of a vertical section"] == ["line.geojson", ""]


def test_the_report_of_a_test_tells_its_model_alone(run, vesuvius, tmp_path):
    files = {"DENSITY": "density.tif", "COVERAGE": "coverage.tif", "PANEL": "panel.png",
             "REPORT": "report.html"}  # fmt: skip
    results = run("reconstructiontest", {
        "DEM": vesuvius["DEM"], "TARGET": "14.4262,40.8218 [EPSG:4326]", "RING_SITES": 4,
        "AZIMUTH_PIXELS": 12, "ELEVATION_PIXELS": 8, "VOXELS": 12, "METHOD": "sirt",
        "MODEL": "sphere", "BODY_RADIUS": 200, "BODY_MIDDLE": 900, "NOISE": False,
        "RELATIVE_ERROR": 0.1, "LENGTH_ERROR": 0, "ITERATIONS": 20,
        **{name: str(tmp_path / file) for name, file in files.items()},
    })  # fmt: skip
    report = Path(results["REPORT"]).read_text(encoding="utf-8")
    told = table(report, "parameters")
    assert told["Known model"] == ["sphere", ""]
    assert told["Middle of the sphere"] == ["900", "m"]
    assert not [label for label in told if "checkerboard" in label or "of the conduit" in label]
    numbers = table(report, "results")
    assert results["CONTRAST"] > 0.05
    assert float(numbers["Contrast found over the true one, sphere"][0]) == pytest.approx(
        results["CONTRAST"], abs=1e-3
    )
    assert float(numbers["Front view: mean |ε|"][0]) == pytest.approx(
        results["FRONT_ERROR"], abs=1e-4
    )
    assert report.count("<img ") == 3
    assert Path(results["PANEL"]).read_bytes().startswith(b"\x89PNG")
