"""Can this survey see it?, from a shell."""

import re


def test_a_survey_is_tried(qgis_process, data_folder, tmp_path):
    folder = tmp_path / "prueba ñ"
    outputs = {
        "DENSITY": folder / "densidad.tif",
        "COVERAGE": folder / "rayos.tif",
        "TABLE": folder / "errores.csv",
        "REPORT": folder / "informe.html",
    }
    done = qgis_process.run(
        "reconstructiontest",
        {
            "DEM": data_folder / "vesuvius_srtmgl1.tif",
            "TARGET": "14.429444,40.822222 [EPSG:4326]",
            "RING_SITES": 6, "RING_RADIUS": 800, "AZIMUTH_PIXELS": 10, "ELEVATION_PIXELS": 8,
            "VOXEL_SIZE": 100, "BASE": 900, "SEED": 7, **outputs,
        },
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    for path in outputs.values():
        assert path.stat().st_size > 100, path
    found = dict(re.findall(r"^(\w+):\s+(\S+)$", done.stdout, re.MULTILINE))
    assert int(found["SITES_USED"]) == 6
    assert 0 < float(found["RELATIVE_L2"]) < 0.2


def test_polygons_that_are_missing_are_one_sentence(qgis_process, data_folder, tmp_path):
    done = qgis_process.run(
        "reconstructiontest",
        {
            "DEM": data_folder / "vesuvius_srtmgl1.tif",
            "TARGET": "14.429444,40.822222 [EPSG:4326]",
            "MODEL": "polygons",
            "DENSITY": tmp_path / "density.tif",
            "COVERAGE": tmp_path / "rays.tif",
        },
    )
    assert done.returncode != 0
    assert "POLYGONS is missing; choose a layer of polygons" in done.stdout + done.stderr
    assert "Traceback" not in done.stderr
    assert not list(tmp_path.iterdir())
