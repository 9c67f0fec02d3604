"""Muon tomography in a shell: files by name, everything written, numbers that agree."""

import re

import numpy as np
import pytest
from pyproj import Geod

from muysc_qgis.muogram import write_muogram
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.volume import read_volume
from muysc_qgis.workflows.simulation import Telescope, simulate


def test_several_muograms_become_a_volume(qgis_process, data_folder, tmp_path):
    dem = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    crater = (14.4265, 40.8215)
    muograms = []
    for azimuth in (0, 120, 240):
        place = Geod(ellps="WGS84").fwd(*crater, azimuth, 1500.0)[:2]
        sight = take_sight(dem, from_wgs84(dem.crs, *place), from_wgs84(dem.crs, *crater), 2.0)
        seen = simulate(sight, Aperture(50, 20, 12, 8), Physics(density_g_cm3=2.3), Telescope())
        muograms.append(tmp_path / f"opacity from {azimuth}°.tif")
        write_muogram(seen.muograms["opacity"], muograms[-1])
    names = {"DENSITY": "d.tif", "COVERAGE": "c.tif", "POINTS": "p.gpkg", "RESIDUALS": "r.csv",
             "PANEL": "p.png", "REPORT": "r.html"}  # fmt: skip
    outputs = {output: tmp_path / name for output, name in names.items()}
    done = qgis_process(
        "run", "muysc:tomography", *(f"--MUOGRAMS={path}" for path in muograms),
        f"--DEM={dem.path}", "--VOXELS=12",
        *(f"--{output}={path}" for output, path in outputs.items()),
    )  # fmt: skip
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    assert all(path.stat().st_size for path in outputs.values())
    mean = float(re.search(r"MEAN_DENSITY:\s+([\d.]+)", said).group(1))
    volume = read_volume(outputs["DENSITY"])
    assert mean == pytest.approx(2.3, rel=1e-3)
    assert mean == pytest.approx(np.nanmean(volume.values), rel=1e-5)
    assert "Traceback" not in said
