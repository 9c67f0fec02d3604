"""Rows on terrain whose thickness is known in closed form."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from osgeo import gdal, osr

from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import local_frame
from muysc_qgis.topography.tracing import trace_terrain

from .row import Row

#: Where the detector stands, degrees; the shapes are around it in the plane.
_LONGITUDE, _LATITUDE = 14.4, 40.8
#: Cell and half the width of the terrain, and how far east a hill stands (m).
_CELL_M, _HALF_M, _HILL_M = 5.0, 2000.0, 1000.0

Surface = Callable[[np.ndarray, np.ndarray], np.ndarray]


def rows() -> Iterator[Row]:
    """Yield every row."""
    section = "Geometry"
    tangent, cosine = np.tan(np.radians(10.0)), np.cos(np.radians(10.0))
    cells = f"closed form; terrain of {_CELL_M:g} m cells"

    def flat(east: np.ndarray, north: np.ndarray) -> np.ndarray:
        return np.full(east.shape, 500.0)

    yield Row(
        section, "Slab, 50 m over the detector, zenith 80°",
        _traced_m(flat, 80.0, detector_m=450.0), "m", 50.0 / np.sin(np.radians(10.0)), cells, 1e-6,
    )  # fmt: skip

    def cone(east: np.ndarray, north: np.ndarray) -> np.ndarray:
        return 500.0 - 0.7 * np.hypot(east - _HILL_M, north)

    near = (0.7 * _HILL_M - 500.0) / (0.7 - tangent)
    far = (0.7 * _HILL_M + 500.0) / (0.7 + tangent)
    yield Row(
        section, "Cone of 500 m, slope 0.7, zenith 80°", _traced_m(cone, 80.0), "m",
        (far - near) / cosine, cells, 2e-3,
    )  # fmt: skip
    radius = 400.0

    def hemisphere(east: np.ndarray, north: np.ndarray) -> np.ndarray:
        return np.sqrt(np.maximum(radius**2 - (east - _HILL_M) ** 2 - north**2, 0.0))

    miss = _HILL_M * np.sin(np.radians(10.0))
    yield Row(
        section, "Hemisphere of 400 m, zenith 80°", _traced_m(hemisphere, 80.0), "m",
        2.0 * np.sqrt(radius**2 - miss**2), cells, 2e-3,
    )  # fmt: skip


def _traced_m(surface: Surface, zenith_deg: float, detector_m: float = 0.0) -> float:
    """Return the thickness of the ray to the east through a surface sampled on a grid."""
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "surface.tif")
        _write(path, surface)
        frame = local_frame(open_dem(path), 0.0, 0.0, "detector")
        elevation = np.array([90.0 - zenith_deg])
        rock = trace_terrain(frame, detector_m, np.array([90.0]), elevation)
    return float(rock.thickness_m[0, 0])


def _write(path: str, surface: Surface) -> None:
    """Sample a surface in the plane around the detector, with the Earth's bulge added."""
    count = 2 * round(_HALF_M / _CELL_M) + 1
    place = (np.arange(count) - count // 2) * _CELL_M
    east, north = np.meshgrid(place, -place)
    # The frame takes d²/2R off again; R = √(MN) of WGS 84 at the latitude.
    flattening = 1 / 298.257223563
    e2 = flattening * (2 - flattening)
    radius = 6378137.0 * np.sqrt(1 - e2) / (1 - e2 * np.sin(np.radians(_LATITUDE)) ** 2)
    heights = surface(east, north) + (east**2 + north**2) / (2 * radius)
    dataset = gdal.GetDriverByName("GTiff").Create(path, count, count, 1, gdal.GDT_Float64)
    left = place[0] - _CELL_M / 2
    dataset.SetGeoTransform((left, _CELL_M, 0.0, -left, 0.0, -_CELL_M))
    reference = osr.SpatialReference()
    reference.ImportFromProj4(
        f"+proj=aeqd +lon_0={_LONGITUDE} +lat_0={_LATITUDE} +datum=WGS84 +units=m"
    )
    dataset.SetSpatialRef(reference)
    dataset.GetRasterBand(1).WriteArray(heights)
    dataset.FlushCache()
