"""What a report tells of the parameters, the pixels and the files."""

import html
import re
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal

gdal.UseExceptions()


@pytest.fixture
def tables(run, vesuvius, tmp_path):
    """Return the tables of a report by their headings, rows of texts."""

    def made(**parameters):
        files = {
            "THICKNESS": str(tmp_path / "thickness.tif"),
            "FLUX": str(tmp_path / "flux.tif"),
            "FIELD_OF_VIEW": str(tmp_path / "seen.gpkg"),
            "PANEL": str(tmp_path / "panel.png"),
            "REPORT": str(tmp_path / "report.html"),
        }
        run("radiography", {**vesuvius, **files, **parameters})
        text = Path(files["REPORT"]).read_text(encoding="utf-8")
        found = {}
        for name, body in re.findall(r'<h2 id="(\w+)">.*?<tbody>(.*?)</tbody>', text, re.DOTALL):
            rows = re.findall(r"<tr.*?</tr>", body, re.DOTALL)
            cells = [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row, re.DOTALL) for row in rows]
            found[name] = {
                label: [html.unescape(value) for value in values] for label, *values in cells
            }
        return found

    return made


def test_parameters_have_names_units_and_what_stands_for_nothing(tables):
    told = tables(STRAGGLING="false")["parameters"]
    assert told["Elevation model (DEM)"] == ["vesuvius_srtmgl1.tif", ""]
    assert told["Detector"] == ["14.410686, 40.810561 (EPSG:4326)", ""]
    assert told["Azimuth aperture"] == ["42", "°"]
    assert told["Pixels in azimuth"] == ["21", ""]
    assert told["Maximum range"] == ["as far as the DEM", ""]
    assert told["Density"] == ["the material's own", ""]
    assert told["Material"] == ["Standard rock", ""]
    assert told["Muon flux model"] == ["GSF–SIBYLL", ""]
    # A table has no constants, and the altitude in it.
    assert "Parameters of the Gaisser formula" not in told
    assert "Correct for altitude" not in told
    assert told["Energy loss"] == ["Range table (csda)", ""]
    assert told["Correct for straggling"] == ["no", ""]


def test_parameters_without_a_meaning_are_left_out(tables):
    told = tables(FLUX_MODEL="guan", DENSITY=2.2)["parameters"]
    assert told["Muon flux model"] == ["Guan et al.", ""]
    assert told["Density"] == ["2.2", "g/cm³"]
    assert "Parameters of the Gaisser formula" not in told
    assert not any("bar" in label.lower() or "planes" in label for label in told)
    custom = {"PRESET": "custom", "BARS_X": 16, "PIXEL_SIZE": 5, "SEPARATION": 100}
    told = tables(**custom)["parameters"]
    assert told["Width of a bar"] == ["5", "cm"]
    assert told["Bars up"] == ["as many as across", ""]


def test_every_pixel_is_accounted_for(tables, tmp_path):
    counted = tables(MAX_RANGE=2500)["pixels"]
    thickness = gdal.Open(str(tmp_path / "thickness.tif")).ReadAsArray()
    assert int(counted["Rock"][0]) == np.count_nonzero(thickness > 0)
    assert int(counted["Open sky"][0]) == np.count_nonzero(thickness == 0)
    assert 0 < int(counted["Rock, thickness cut"][0]) < int(counted["Rock"][0])
    assert "maximum range of 2500 m" in counted["Rock, thickness cut"][2]
    assert int(counted["All"][0]) == thickness.size
    # Nothing is cut or unknown where nothing is said.
    assert set(tables()["pixels"]) == {"Rock", "Open sky", "All"}


def test_the_files_of_the_run_are_listed_by_name(tables):
    assert {name for (name,) in tables()["files"].values()} == {
        "thickness.tif", "flux.tif", "seen.gpkg", "panel.png",
    }  # fmt: skip
