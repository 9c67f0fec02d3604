"""The main job from a shell: outputs, exit codes, and one sentence when it cannot be done."""

import re

import pytest
from osgeo import gdal

gdal.UseExceptions()

POINTS = {
    "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
    "TARGET": "14.424745,40.823729 [EPSG:4326]",
}


@pytest.fixture
def job(data_folder):
    return {
        "DEM": data_folder / "vesuvius_srtmgl1.tif",
        **POINTS,
        "AZIMUTH_APERTURE": 42,
        "ELEVATION_APERTURE": 22,
        "AZIMUTH_PIXELS": 20,
        "ELEVATION_PIXELS": 20,
    }


def test_the_toolbox_lists_every_algorithm(qgis_process):
    listed = qgis_process("list").stdout
    for name in ("radiography", "muonflux", "drape"):
        assert f"muysc:{name}" in listed


def test_help_names_every_parameter_with_its_unit(qgis_process):
    shown = qgis_process("help", "muysc:radiography").stdout
    assert "DENSITY: Density (g/cm³" in shown
    assert "ACCEPTANCE: Acceptance of a pixel (cm² sr)" in shown


def test_a_path_with_accents_and_spaces_chains_from_dem_to_draped_flux(qgis_process, job, tmp_path):
    folder = tmp_path / "volcán de prueba ñ"
    dem = folder / "elevación 1″.tif"
    folder.mkdir()
    dem.write_bytes(job["DEM"].read_bytes())
    outputs = {
        "THICKNESS": folder / "espesor de roca.tif",
        "FLUX": folder / "flujo μ.tif",
        "FIELD_OF_VIEW": folder / "campo de visión.gpkg",
        "PANEL": folder / "panel ñ.png",
        "REPORT": folder / "informe ñ.html",
    }
    done = qgis_process.run("radiography", {**job, "DEM": dem, **outputs})
    assert done.returncode == 0, done.stdout + done.stderr
    for path in outputs.values():
        assert path.stat().st_size > 500, path
    draped = folder / "flujo en el mapa.tif"
    done = qgis_process.run("drape", {"MUOGRAM": outputs["FLUX"], "DEM": dem, "OUTPUT": draped})
    assert done.returncode == 0, done.stdout + done.stderr
    assert gdal.Open(str(draped)).RasterXSize == gdal.Open(str(dem)).RasterXSize
    again = folder / "flujo otra vez.tif"
    done = qgis_process.run("muonflux", {"THICKNESS": outputs["THICKNESS"], "FLUX": again})
    assert done.returncode == 0, done.stdout + done.stderr
    first, second = (gdal.Open(str(path)).ReadAsArray() for path in (outputs["FLUX"], again))
    # Float32 files round the thickness on the way.
    assert abs(second / first - 1).max() < 1e-5


def test_numbers_are_printed(qgis_process, job, tmp_path):
    done = qgis_process.run(
        "radiography", {**job, "THICKNESS": tmp_path / "t.tif", "FLUX": tmp_path / "f.tif"}
    )
    numbers = dict(re.findall(r"^(\w+):\s+([-\d.e+]+)$", done.stdout, re.MULTILINE))
    # The geodesic distance of the two points, by pyproj.
    assert float(numbers["TARGET_DISTANCE"]) == pytest.approx(1882.88, abs=0.01)
    assert float(numbers["ROCK_PIXELS"]) > 100
    assert float(numbers["UNKNOWN_PIXELS"]) == 0


#: Words that a traceback or a raw library message would show.
_LEAKS = ("Traceback", 'File "', "line ", "RuntimeError", "NoneType")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"DENSITY": "-1"}, ["-1 g/cm³", "above 0"]),
        ({"DETECTOR": "0,0 [EPSG:4326]"}, ["detector", "off the DEM"]),
        ({"FLUX_MODEL": "hebbeker"}, ["hebbeker", "reyna-hebbeker"]),
        ({"TARGET": POINTS["DETECTOR"]}, ["same point"]),
        ({"AZIMUTH_PIXELS": "100000", "ELEVATION_PIXELS": "100000"}, ["GiB"]),
        ({"DEM": "/no/such/file.tif"}, ["/no/such/file.tif"]),
        ({"FLUX": "/proc/version/flux.tif"}, ["/proc/version", "no folder"]),
    ],
)
def test_bad_input_is_refused_in_one_sentence_and_leaves_no_file(
    qgis_process, job, tmp_path, change, words
):
    thickness = tmp_path / "thickness.tif"
    thickness.write_bytes(b"what stood here before")
    flux = tmp_path / "flux.tif"
    done = qgis_process.run("radiography", {**job, "THICKNESS": thickness, "FLUX": flux, **change})
    said = done.stdout + done.stderr
    assert done.returncode != 0
    for word in words:
        assert word in said
    for leak in _LEAKS:
        assert leak not in done.stderr
    assert thickness.read_bytes() == b"what stood here before"
    assert [path.name for path in tmp_path.iterdir()] == ["thickness.tif"]
