"""Surveys from the command line."""

import json
from pathlib import Path

import pytest

SITES = {
    "type": "FeatureCollection",
    "features": [
        {
            "type": "Feature",
            "properties": {"name": name},
            "geometry": {"type": "Point", "coordinates": place},
        }
        for name, place in (("west", [14.4107, 40.8106]), ("off the map", [0.0, 0.0]))
    ],
}


@pytest.fixture
def sites(tmp_path):
    path = tmp_path / "sites with é.geojson"
    path.write_text(json.dumps(SITES), encoding="utf-8")
    return path


def test_radiography_at_sites(qgis_process, data_folder, sites, tmp_path):
    folder = tmp_path / "muograms"
    done = qgis_process.run(
        "radiographyatsites",
        {
            "DEM": data_folder / "vesuvius_srtmgl1.tif",
            "SITES": sites,
            "NAME_FIELD": "name",
            "TARGET": "14.424745,40.823729 [EPSG:4326]",
            "QUANTITIES": "thickness,exposure",
            "AZIMUTH_PIXELS": 20,
            "ELEVATION_PIXELS": 10,
            "FOLDER": folder,
            "INDEX": tmp_path / "index.gpkg",
        },
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert sorted(path.name for path in folder.glob("*.tif")) == [
        "west_exposure.tif", "west_thickness.tif",
    ]  # fmt: skip
    assert "Site off the map was skipped" in done.stdout + done.stderr
    assert Path(tmp_path / "index.gpkg").stat().st_size > 0


def test_no_site_left_is_one_sentence(qgis_process, data_folder, sites, tmp_path):
    done = qgis_process.run(
        "radiographyatsites",
        {
            "DEM": data_folder / "machin_digitised.tif",
            "SITES": sites,
            "TARGET": "-75.3878,4.4877 [EPSG:4326]",
            "FOLDER": tmp_path / "muograms",
        },
    )
    assert done.returncode != 0
    assert "None of the 2 sites can be used" in done.stderr
    assert not (tmp_path / "muograms").exists()


def test_site_selection_with_worker_processes(qgis_process, data_folder, tmp_path):
    done = qgis_process.run(
        "siteselection",
        {
            "DEM": data_folder / "vesuvius_srtmgl1.tif",
            "TARGET": "14.424745,40.823729 [EPSG:4326]",
            "MIN_DISTANCE": 1500,
            "MAX_DISTANCE": 2500,
            "SPACING": 400,
            "AZIMUTH_PIXELS": 12,
            "ELEVATION_PIXELS": 8,
            "WORKERS": 2,
            "SCORE": tmp_path / "score é.tif",
            "TELESCOPE_SITES": tmp_path / "telescopes.gpkg",
        },
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "in one process instead" not in done.stdout + done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "score é.qml", "score é.tif", "telescopes.gpkg",
    ]  # fmt: skip
    assert "BEST_SCORE" in done.stdout
