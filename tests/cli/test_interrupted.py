"""Runs that are killed, or that write to one place at the same time."""

import subprocess
import time

import pytest
from osgeo import gdal, ogr

gdal.UseExceptions()

OLDER = b"older result"
POINTS = (
    "--DETECTOR=14.410686,40.810561 [EPSG:4326]",
    "--TARGET=14.424745,40.823729 [EPSG:4326]",
)


@pytest.fixture
def start(qgis_process, data_folder, tmp_path):
    """Start radiography with a layer and a raster in a folder; returns the process."""
    started = []

    def run(pixels):
        outputs = {"THICKNESS": "t.tif", "FLUX": "f.tif", "FIELD_OF_VIEW": "v.gpkg"}
        process = subprocess.Popen(
            [
                qgis_process.command, "run", "muysc:radiography",
                f"--DEM={data_folder / 'vesuvius_srtmgl1.tif'}", *POINTS,
                f"--AZIMUTH_PIXELS={pixels}", f"--ELEVATION_PIXELS={pixels}",
                *(f"--{name}={tmp_path / file}" for name, file in outputs.items()),
            ],
            env=qgis_process.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            text=True,
        )  # fmt: skip
        started.append(process)
        return process

    yield run
    for process in started:
        if process.poll() is None:
            process.kill()
        process.communicate()


def test_a_run_that_is_killed_leaves_earlier_results(start, tmp_path):
    finals = [tmp_path / name for name in ("t.tif", "f.tif", "v.gpkg")]
    for final in finals:
        final.write_bytes(OLDER)
    process = start(600)
    # It is writing as soon as a temporary file has appeared.
    while not list(tmp_path.glob(".*-partial*")):
        assert process.poll() is None, process.communicate()[0]
        time.sleep(0.001)
    process.kill()
    process.wait()
    assert [final.read_bytes() for final in finals] == [OLDER] * 3


def test_two_runs_write_to_one_place_at_once(start, tmp_path):
    processes = [start(30), start(30)]
    for process in processes:
        said, _ = process.communicate(timeout=120)
        assert process.returncode == 0, said
    names = {path.name for path in tmp_path.iterdir()}
    assert names == {"t.tif", "t.qml", "f.tif", "f.qml", "v.gpkg"}
    assert gdal.Open(str(tmp_path / "t.tif")).ReadAsArray().max() > 100
    assert ogr.Open(str(tmp_path / "v.gpkg")).GetLayer(0).GetFeatureCount() >= 2
