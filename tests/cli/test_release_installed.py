"""The zip of a release, installed in a fresh profile as the plugin manager does, and run."""

import os
import re
import subprocess
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest
from osgeo import gdal

from tools import package

gdal.UseExceptions()

#: Where QGIS keeps the plugins of its first profile, below its folder of settings.
PLUGINS = Path("profiles", "default", "python", "plugins")


@pytest.fixture(scope="module")
def installed(qgis_process, tmp_path_factory):
    """Return qgis_process with the release, and with nothing of this checkout."""
    try:
        commit = package.git("rev-parse", "HEAD").strip()
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("not a git checkout with a commit")
    home = tmp_path_factory.mktemp("stranger")
    package.pack(home / "muysc.zip", commit)
    plugins = home / "settings" / PLUGINS
    with zipfile.ZipFile(home / "muysc.zip") as content:
        content.extractall(plugins)
    environment = {
        **os.environ,
        **qgis_process.environment,
        "HOME": str(home),
        "XDG_RUNTIME_DIR": str(home),
        "QGIS_CUSTOM_CONFIG_PATH": str(home / "settings"),
    }
    environment.pop("QGIS_PLUGINPATH")
    process = replace(qgis_process, environment=environment)
    enabled = process("plugins", "enable", "muysc")
    assert enabled.returncode == 0, enabled.stdout + enabled.stderr
    return process, plugins / "muysc"


def test_the_toolbox_lists_every_algorithm_and_model(installed):
    process, folder = installed
    listed = set(re.findall(r"muysc:(\w+)", process("list").stdout))
    # One page of help for each, and the list of them.
    assert listed == {page.stem for page in folder.glob("docs/reference/*.html")} - {"index"}
    assert {"radiography", "volcanosurvey", "exposureplan"} <= listed


def test_the_toolbox_speaks_spanish(installed):
    process, _ = installed
    spanish = replace(process, environment={**process.environment, "LANG": "es_CO.UTF-8"})
    spanish.environment.pop("LC_ALL", None)
    assert "Radiografía" in spanish("list").stdout


def test_vesuvius_from_the_release(installed, data_folder, tmp_path):
    process, folder = installed
    files = {name: tmp_path / f"{name.lower()}.tif" for name in ("THICKNESS", "FLUX")}
    files |= {"PANEL": tmp_path / "panel.png", "REPORT": tmp_path / "report.html"}
    done = process.run(
        "radiography",
        {
            "DEM": data_folder / "vesuvius_srtmgl1.tif",
            "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
            "TARGET": "14.424745,40.823729 [EPSG:4326]",
            "AZIMUTH_PIXELS": 20,
            "ELEVATION_PIXELS": 20,
            **files,
        },
    )
    assert done.returncode == 0, done.stdout + done.stderr
    for path in files.values():
        assert path.stat().st_size > 500, path
    thickness = gdal.Open(str(files["THICKNESS"]))
    assert 500 < thickness.ReadAsArray().max() < 5000
    version = re.search(r"^version=(.+)$", (folder / "metadata.txt").read_text(), re.MULTILINE)[1]
    assert thickness.GetMetadataItem("VERSION", "MUYSC") == version


def test_a_refusal_from_the_release_is_one_sentence(installed, tmp_path):
    process, _ = installed
    done = process.run("drape", {"MUOGRAM": tmp_path / "none.tif", "DEM": tmp_path / "none.tif"})
    assert done.returncode != 0
    assert "Traceback" not in done.stderr
