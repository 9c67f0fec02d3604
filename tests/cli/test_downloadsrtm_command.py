"""Terrain from a shell."""

import re

import numpy as np
from osgeo import gdal

gdal.UseExceptions()


def parameters(tile_server, tmp_path):
    return {
        "EXTENT": "14.40,14.45,40.80,40.85 [EPSG:4326]",
        "SOURCE": f"{tile_server.url}/{{latitude}}/{{tile}}.hgt?key=secret",
        "CACHE": tmp_path / "caché ñ",
        "DEM": tmp_path / "terreno ñ" / "dem.tif",
        "TIMEOUT": 5,
        "RETRIES": 0,
    }


def test_a_run_writes_the_dem_and_numbers(qgis_process, tile_server, vesuvius_tile, tmp_path):
    tile_server.files["/N40/N40E014.hgt"] = vesuvius_tile.tobytes()
    given = parameters(tile_server, tmp_path)
    done = qgis_process.run("downloadsrtm", given)
    assert done.returncode == 0, done.stdout + done.stderr
    dataset = gdal.Open(str(given["DEM"]))
    # 0.05° of 1″ with both ends: columns from 14.40° = 1440″ on, rows from 41° − 540″ on.
    assert np.array_equal(dataset.ReadAsArray(), vesuvius_tile[540:721, 1440:1621])
    numbers = dict(re.findall(r"^(\w+):\s+(\d+)$", done.stdout, re.MULTILINE))
    assert numbers["TILES"] == "1"
    assert numbers["SEA_TILES"] == numbers["VOID_PIXELS"] == "0"
    assert "secret" not in "".join(dataset.GetMetadata().values())


def test_a_server_without_the_tile_is_one_sentence(qgis_process, tile_server, tmp_path):
    done = qgis_process.run("downloadsrtm", parameters(tile_server, tmp_path))
    assert done.returncode != 0
    assert "none of the tiles of the extent (N40E014)" in done.stdout + done.stderr
    assert "Traceback" not in done.stderr
    assert not list(tmp_path.iterdir())
