"""Terrain made to measure: surfaces sampled on rasters of any kind."""

import math
from dataclasses import dataclass
from itertools import count

import numpy as np
import pytest
from osgeo import gdal, osr
from pyproj import CRS, Proj, Transformer

from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import ground_height, local_frame
from muysc_qgis.topography.tracing import trace_terrain

gdal.UseExceptions()

#: WGS 84 defining parameters (EPSG:7030).
WGS84_A, WGS84_F = 6378137.0, 1 / 298.257223563


def gaussian_radius(latitude):
    """Return √(MN) on WGS 84 from its textbook radii M and N."""
    e2 = WGS84_F * (2 - WGS84_F)
    root = math.sqrt(1 - e2 * math.sin(math.radians(latitude)) ** 2)
    prime_vertical = WGS84_A / root
    meridian = WGS84_A * (1 - e2) / root**3
    return math.sqrt(meridian * prime_vertical)


@dataclass(frozen=True)
class Place:
    """A detector's place and the plane in which surfaces around it are defined."""

    longitude: float = 14.4
    latitude: float = 40.8

    @property
    def metric_crs(self):
        return f"+proj=aeqd +lon_0={self.longitude} +lat_0={self.latitude} +datum=WGS84 +units=m"

    @property
    def radius(self):
        return gaussian_radius(self.latitude)

    def bulge(self, east, north):
        """Return what makes a surface, added to it, as it were on a flat Earth."""
        return (east**2 + north**2) / (2 * self.radius)


@pytest.fixture(scope="session")
def place():
    return Place()


@pytest.fixture
def write_dem(tmp_path):
    """Return a function that writes heights to a GeoTIFF and returns its path."""
    number = count()

    def write(
        heights, crs, geotransform, data_type=gdal.GDT_Float64, no_data=None, scale=None,
        offset=None, unit="", options=(), name=None,
    ):  # fmt: skip
        path = str(tmp_path / (name or f"dem{next(number)}.tif"))
        heights = np.atleast_3d(np.asarray(heights).T).T  # bands first
        bands, rows, columns = heights.shape
        dataset = gdal.GetDriverByName("GTiff").Create(
            path, columns, rows, bands, data_type, list(options)
        )
        if geotransform is not None:
            dataset.SetGeoTransform(geotransform)
        if crs:
            reference = osr.SpatialReference()
            reference.SetFromUserInput(crs)
            dataset.SetSpatialRef(reference)
        for index in range(bands):
            band = dataset.GetRasterBand(index + 1)
            band.WriteArray(heights[index])
            if no_data is not None:
                band.SetNoDataValue(no_data)
            if scale is not None:
                band.SetScale(scale)
            if offset is not None:
                band.SetOffset(offset)
            if unit:
                band.SetUnitType(unit)
        dataset.FlushCache()
        return path

    return write


def own_degrees(crs, x, y):
    """Return longitude and latitude in degrees on the CRS's own datum."""
    if crs.is_geographic:
        degrees = math.degrees(crs.axis_info[0].unit_conversion_factor)
        return np.asarray(x) * degrees, np.asarray(y) * degrees
    return Proj(crs)(x, y, inverse=True)


def cell_centres(geotransform, columns, rows):
    column, row = np.meshgrid(np.arange(columns) + 0.5, np.arange(rows) + 0.5)
    x0, xc, xr, y0, yc, yr = geotransform
    return x0 + xc * column + xr * row, y0 + yc * column + yr * row


@pytest.fixture
def sample_surface(write_dem):
    """Return a function that samples surface(east, north) around (x, y) of a CRS."""

    def sample(surface, crs, geotransform, columns, rows, x, y, **keywords):
        reference = CRS.from_user_input(crs)
        flat = reference.sub_crs_list[0] if reference.is_compound else reference
        longitude, latitude = own_degrees(flat, *cell_centres(geotransform, columns, rows))
        here = [np.full(longitude.shape, value) for value in own_degrees(flat, x, y)]
        azimuth, _, distance = flat.get_geod().inv(*here, longitude, latitude)
        east = distance * np.sin(np.radians(azimuth))
        north = distance * np.cos(np.radians(azimuth))
        return write_dem(surface(east, north), crs, geotransform, **keywords)

    return sample


@pytest.fixture
def metric_dem(write_dem, place):
    """Return a function that samples surface(east, north) on a metric grid.

    The plane is the azimuthal equidistant projection around the detector, and
    `shift` (in cells) says where the grid lies under it.
    """

    def sample(surface, cell, half_width, shift=(0.0, 0.0), centre=(0.0, 0.0), **keywords):
        n = 2 * math.ceil(half_width / cell) + 1
        left = centre[0] + (shift[0] - n / 2) * cell
        top = centre[1] + (shift[1] + n / 2) * cell
        geotransform = (left, cell, 0.0, top, 0.0, -cell)
        heights = surface(*cell_centres(geotransform, n, n))
        return write_dem(heights, place.metric_crs, geotransform, **keywords)

    return sample


@pytest.fixture(scope="session")
def trace():
    """Return a function that traces rays through the DEM of a file.

    The detector stands at (x, y) of the DEM's CRS, at `eye` m in its heights or
    `above` m over the ground.
    """

    def trace(path, azimuth, elevation, x=0.0, y=0.0, eye=None, above=None, **keywords):
        dem = open_dem(path)
        frame = local_frame(dem, x, y, "detector")
        if eye is None:
            eye = ground_height(dem, x, y, "detector") + above
        return trace_terrain(
            frame, eye, np.atleast_1d(azimuth), np.atleast_1d(elevation), **keywords
        )

    return trace


@pytest.fixture(scope="session")
def wgs84_to():
    """Return a function that takes longitude and latitude to a CRS."""

    def transform(crs, longitude, latitude):
        return Transformer.from_crs("EPSG:4326", crs, always_xy=True).transform(longitude, latitude)

    return transform
