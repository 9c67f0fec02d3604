"""Terrain on another datum from a shell: a point comes out where it went in."""

import pytest
from osgeo import gdal
from pyproj import Geod, Transformer

gdal.UseExceptions()

#: On the flank of Mount St. Helens and in its crater, WGS 84.
FLANK, CRATER = (-122.2, 46.18), (-122.1944, 46.1910)


@pytest.mark.parametrize("crs", ["EPSG:4326", "EPSG:32610"])
def test_a_wgs84_point_on_terrain_in_nad27_comes_back(qgis_process, data_folder, tmp_path, crs):
    to_own = Transformer.from_crs(4326, crs, always_xy=True)
    points = {
        name: "{!r},{!r} [{}]".format(*to_own.transform(*place), crs)
        for name, place in (("DETECTOR", FLANK), ("TARGET", CRATER))
    }
    flux = tmp_path / "flux.tif"
    done = qgis_process.run(
        "radiography",
        {
            "DEM": data_folder / "st_helens_usgs.tif", **points, "AZIMUTH_PIXELS": 3,
            "ELEVATION_PIXELS": 3, "THICKNESS": tmp_path / "thickness.tif", "FLUX": flux,
        },
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    told = gdal.Open(str(flux)).GetMetadata("MUYSC")
    assert "NAD27 to WGS 84" in told["TRANSFORMATION"]
    for what, place in (("DETECTOR", FLANK), ("TARGET", CRATER)):
        back = float(told[f"{what}_LON"]), float(told[f"{what}_LAT"])
        assert Geod(ellps="WGS84").inv(*place, *back)[2] < 0.1
