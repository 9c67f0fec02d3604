"""A muogram put back on the map: cells and rays agree in both directions."""

import numpy as np
import pytest
from osgeo import gdal
from pyproj import Geod

gdal.UseExceptions()
GEOD = Geod(ellps="WGS84")


@pytest.fixture
def muograms(run, vesuvius, tmp_path):
    results = run(
        "radiography",
        {
            **vesuvius,
            "AZIMUTH_PIXELS": 84,
            "ELEVATION_PIXELS": 44,
            "THICKNESS": str(tmp_path / "thickness.tif"),
            "FLUX": str(tmp_path / "flux.tif"),
            "DISTANCE": str(tmp_path / "distance.tif"),
        },
    )
    return {name: results[name] for name in ("THICKNESS", "FLUX", "DISTANCE")}


def open_raster(path):
    dataset = gdal.Open(str(path))
    return dataset.ReadAsArray().astype(float), dataset.GetGeoTransform(), dataset


def muogram_pixel(azimuth, elevation, geotransform):
    left, step_x, _, top, _, step_y = geotransform
    return int((elevation - top) / step_y), int((azimuth - left) / step_x)


@pytest.mark.parametrize("side", ["near", "far"])
def test_the_raster_lies_on_the_grid_of_the_dem(run, vesuvius, muograms, tmp_path, side):
    results = run(
        "drape",
        {"MUOGRAM": muograms["FLUX"], "DEM": vesuvius["DEM"], "SIDE": side,
         "OUTPUT": str(tmp_path / "draped.tif")},
    )  # fmt: skip
    draped, geotransform, dataset = open_raster(results["OUTPUT"])
    dem, dem_geotransform, dem_dataset = open_raster(vesuvius["DEM"])
    assert draped.shape == dem.shape
    assert geotransform == dem_geotransform
    assert dataset.GetSpatialRef().IsSame(dem_dataset.GetSpatialRef())
    assert results["CELLS"] == np.count_nonzero(np.isfinite(draped)) > 500
    assert dataset.GetRasterBand(1).GetUnitType() == "cm⁻² sr⁻¹ day⁻¹"


def test_each_cell_carries_the_value_of_the_ray_to_it(run, vesuvius, muograms, tmp_path):
    """From the map to the muogram: azimuth and elevation of cells by the ellipsoid."""
    results = run(
        "drape",
        {"MUOGRAM": muograms["FLUX"], "DEM": vesuvius["DEM"], "OUTPUT": str(tmp_path / "d.tif")},
    )
    draped, (left, step_x, _, top, _, step_y), _ = open_raster(results["OUTPUT"])
    heights, _, _ = open_raster(vesuvius["DEM"])
    flux, geotransform, dataset = open_raster(muograms["FLUX"])
    told = dataset.GetMetadata("MUYSC")
    longitude, latitude = float(told["DETECTOR_LON"]), float(told["DETECTOR_LAT"])
    rows, columns = np.nonzero(np.isfinite(draped))
    agree = 0
    for row, column in zip(rows, columns):
        azimuth, _, distance = GEOD.inv(
            longitude, latitude, left + step_x * (column + 0.5), top + step_y * (row + 0.5)
        )
        rise = heights[row, column] - float(told["DETECTOR_ELEVATION"])
        # 6371 km: the curvature drop is below 1 m here, its radius is not critical.
        elevation = np.degrees(np.arctan2(rise - distance**2 / 2 / 6.371e6, distance))
        pixel = muogram_pixel(azimuth % 360, elevation, geotransform)
        agree += np.isclose(flux[pixel], draped[row, column], rtol=1e-6)
    # Cells on the border of two pixels may fall to either.
    assert agree >= 0.995 * len(rows)


def test_the_ray_of_a_pixel_ends_in_a_cell_that_carries_it(run, vesuvius, muograms, tmp_path):
    """From the muogram to the map: direction and distance of a pixel give its cell."""
    results = run(
        "drape",
        {"MUOGRAM": muograms["DISTANCE"], "DEM": vesuvius["DEM"],
         "OUTPUT": str(tmp_path / "d.tif")},
    )  # fmt: skip
    draped, (left, step_x, _, top, _, step_y), _ = open_raster(results["OUTPUT"])
    distance, (az0, daz, _, el0, _, delev), dataset = open_raster(muograms["DISTANCE"])
    told = dataset.GetMetadata("MUYSC")
    hits, asked = 0, 0
    for row in range(2, distance.shape[0] - 2):
        for column in range(2, distance.shape[1] - 2):
            around = distance[row - 2 : row + 3, column - 2 : column + 3]
            # Away from edges of the rock face, where neighbouring rays jump.
            if not np.isfinite(around).all() or np.ptp(around) > 0.25 * around.mean():
                continue
            azimuth, elevation = az0 + daz * (column + 0.5), el0 + delev * (row + 0.5)
            level = distance[row, column] * np.cos(np.radians(elevation))
            longitude, latitude, _ = GEOD.fwd(
                float(told["DETECTOR_LON"]), float(told["DETECTOR_LAT"]), azimuth, level
            )
            cell = int((latitude - top) / step_y), int((longitude - left) / step_x)
            window = draped[cell[0] - 1 : cell[0] + 2, cell[1] - 1 : cell[1] + 2]
            asked += 1
            # The cell or one beside it is seen, and lies about as far away: within the
            # diagonal of two cells of 31 m × 23 m and one pixel.
            hits += np.isfinite(window).any() and (
                np.nanmin(np.abs(window - distance[row, column])) < 77 + 0.02 * level
            )
    assert asked > 300
    assert hits >= 0.97 * asked


def test_near_and_far_side_are_different_ground(run, vesuvius, muograms, tmp_path):
    sides = {}
    for side in ("near", "far"):
        path = tmp_path / f"{side}.tif"
        run("drape", {"MUOGRAM": muograms["THICKNESS"], "DEM": vesuvius["DEM"], "SIDE": side,
                      "OUTPUT": str(path)})  # fmt: skip
        sides[side] = np.isfinite(open_raster(path)[0])
    both = np.count_nonzero(sides["near"] & sides["far"])
    assert both < 0.1 * np.count_nonzero(sides["near"])
    # Seen from the south-west, the near side lies south-west of the far side.
    rows, columns = zip(*(np.argwhere(sides[side]).mean(axis=0) for side in ("near", "far")))
    assert rows[0] > rows[1]
    assert columns[0] < columns[1]


def test_a_raster_that_is_no_muogram_is_refused(run, vesuvius, tmp_path):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match="lacks the metadata key QUANTITY"):
        run("drape", {"MUOGRAM": vesuvius["DEM"], "DEM": vesuvius["DEM"],
                      "OUTPUT": str(tmp_path / "d.tif")})  # fmt: skip
    assert list(tmp_path.iterdir()) == []


def test_another_mountain_is_refused(run, muograms, data_folder, tmp_path):
    from qgis.core import QgsProcessingException

    output = tmp_path / "d.tif"
    with pytest.raises(QgsProcessingException, match="off the DEM"):
        run("drape", {"MUOGRAM": muograms["FLUX"],
                      "DEM": str(data_folder / "maungawhau_linz5m.tif"),
                      "OUTPUT": str(output)})  # fmt: skip
    assert not output.exists()
