"""The line that the dock copies, pasted into a shell as it is."""

import importlib
import shutil
import subprocess

import numpy as np
import pytest
from osgeo import gdal

gdal.UseExceptions()

COMMAND = shutil.which("qgis_process.bin") or shutil.which("qgis_process")


@pytest.mark.parametrize("algorithm", ["radiography", "expectedcounts"])
def test_the_copied_line_computes_what_the_dock_shows(
    provider, qgis_process, data_folder, tmp_path, algorithm
):
    package = type(provider).__module__.split(".")[0]
    plans, commands = (
        importlib.import_module(f"{package}.muysc_qgis.gui.{name}") for name in ("plan", "commands")
    )
    folder = tmp_path / "it's a $HOME of “DEMs”"
    folder.mkdir()
    dem = folder / "Vesuvius & co.tif"
    dem.write_bytes((data_folder / "vesuvius_srtmgl1.tif").read_bytes())
    plan = plans.Plan(
        detector=plans.Place(450294.059, 4517886.498, "EPSG:32633"),
        target=plans.Place(14.424745, 40.823729, "EPSG:4326"),
        density_g_cm3=2.2,
    ).with_preset("lesparre2010")
    parameters = {
        "radiography": plan.radiography(str(dem)),
        "expectedcounts": plan.expected_counts(str(dem)),
    }[algorithm]
    line = commands.command_line(f"muysc:{algorithm}", parameters)
    done = subprocess.run(
        ["bash", "-c", f'qgis_process() {{ {COMMAND} "$@"; }}; {line}'],
        env=qgis_process.environment,
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    import processing

    output = {"radiography": "FLUX", "expectedcounts": "COUNTS"}[algorithm]
    wanted = processing.run(
        f"muysc:{algorithm}",
        {**parameters, output: "TEMPORARY_OUTPUT", "THICKNESS": "TEMPORARY_OUTPUT"},
    )
    np.testing.assert_array_equal(
        gdal.Open(str(tmp_path / f"{output.lower()}.tif")).ReadAsArray(),
        gdal.Open(wanted[output]).ReadAsArray(),
    )
