"""Thickness against an independent ray tracer on the same nodes of the same DEM."""

import numpy as np
import pytest

from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.topography.tracing import trace_terrain


def test_thickness_on_vesuvius_is_that_of_mulder(data_folder):
    mulder = pytest.importorskip("mulder")
    dem = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    sight = take_sight(dem, (14.410686, 40.810561), (14.424745, 40.823729))
    azimuth, elevation = Aperture(42, 22, 60, 60).directions(
        sight.boresight_azimuth_deg, sight.boresight_elevation_deg
    )
    elevation = elevation[::-1]
    ours = trace_terrain(sight.frame, sight.detector_elevation_m, azimuth, elevation).thickness_m

    left, top = dem.crs_position(0, 0)
    right, bottom = dem.crs_position(dem.columns - 1, dem.rows - 1)
    # Given as an array: from the file, mulder 0.3.7 puts the values of the outer
    # cells on the raster's edge instead of on the cell centres.
    grid = mulder.Grid(
        dem.read(0, 0, dem.columns, dem.rows)[::-1].copy(),
        xlim=(float(left), float(right)),
        ylim=(float(bottom), float(top)),
        crs=4326,
    )
    azimuths, elevations = np.meshgrid(azimuth, elevation, indexing="ij")
    theirs = mulder.EarthGeometry(mulder.Layer(grid, material="Rock")).scan(
        latitude=40.810561,
        longitude=14.410686,
        altitude=sight.detector_elevation_m + 0.01,
        azimuth=azimuths.ravel(),
        elevation=elevations.ravel(),
    )[:, 0]
    theirs = theirs.reshape(ours.shape)
    rock = (ours > 1) & (theirs > 1)
    assert rock.sum() > 1500
    assert np.median(np.abs(ours - theirs)[rock] / theirs[rock]) < 1e-3
    assert np.percentile(np.abs(ours - theirs)[rock], 99) < 10
