"""Runs that name a formula for the flux give what they gave before there was a better model.

The numbers are those of the demo of version 0.1.0, every tenth pixel, whose default was
gaisser-tang: `FLUX_MODEL` alone is named here, as a script of then would have.
"""

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal

from muysc_qgis.radiography.settings import Physics

DATA = Path(__file__).resolve().parents[1] / "data"
KEPT = np.load(DATA / "demo_gaisser_tang.npz")
VIEW = {
    "DEM": str(DATA / "vesuvius_srtmgl1.tif"),
    "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
    "TARGET": "14.424745,40.823729 [EPSG:4326]",
    "AZIMUTH_APERTURE": 42,
    "ELEVATION_APERTURE": 22,
    "FLUX_MODEL": "gaisser-tang",
}


@pytest.fixture(scope="module", params=[{}, {"DETECTION_THRESHOLD": 0.0}], ids=["none", "zero"])
def rasters(provider, tmp_path_factory, request):
    """Return the rasters of a run without a threshold, and with the 0 that models stored."""
    import processing

    folder = tmp_path_factory.mktemp("formula")
    files = {name.upper(): str(folder / f"{name}.tif") for name in KEPT}
    files["THICKNESS"] = str(folder / "thickness.tif")
    processing.run("muysc:radiography", {**VIEW, **request.param, **files})
    return {name: gdal.Open(files[name.upper()]).ReadAsArray() for name in KEPT}


@pytest.mark.parametrize("quantity", list(KEPT))
def test_every_tenth_pixel_of_the_former_demo_is_the_same(rasters, quantity):
    # One unit in the last place of a raster's numbers, for another numpy's rounding.
    np.testing.assert_array_max_ulp(rasters[quantity][4::10, 4::10], KEPT[quantity], 1)


def test_formulas_without_a_threshold_count_all_muons_behind_rock():
    assert Physics(flux_model="guan").threshold_gev == 0.0
    assert Physics(flux_model="guan", detection_threshold_gev=2.0).threshold_gev == 2.0
