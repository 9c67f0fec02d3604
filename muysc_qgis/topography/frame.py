"""The local frame of a detector: azimuths and distances on the ellipsoid."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ..errors import MuyscError
from .datum import Transformation, degrees_of, transformer, wgs84
from .sampling import heights_at

if TYPE_CHECKING:
    from pyproj import CRS, Geod

    from .dem import Dem

#: Distance between the exact points of a path over the ground. Between them the
#: path is straight in the raster's own coordinates; the sagitta, at most
#: step² tan(latitude) / 8R, is 3 cm at 80° latitude.
PATH_STEP_M = 500.0


@dataclass(frozen=True)
class LocalFrame:
    """Azimuthal frame around one point, on the ellipsoid of a DEM's own datum.

    Positions are (azimuth, geodesic distance) from the origin: the azimuthal
    equidistant projection in polar form. Heights fall off by the curvature drop
    d²/2R, so that straight rays are straight in the frame. Distances are those on
    the ellipsoid; at an altitude h they are longer by h/R, 0.08 % at 5 km.
    """

    #: Longitude and latitude of the origin in the DEM's datum, degrees.
    longitude: float
    latitude: float
    dem: Dem

    @cached_property
    def _geod(self) -> Geod:
        return _geod_of(self.dem.crs)

    @property
    def radius_m(self) -> float:
        """Gaussian radius of curvature √(MN) of the ellipsoid at the origin."""
        return _radius_m(self._geod, self.latitude)

    def drop(self, distance_m: np.ndarray | float) -> np.ndarray:
        """Return how far (m) the level surface falls below the horizontal plane."""
        return np.square(distance_m) / (2 * self.radius_m)

    def ground_positions(
        self, azimuth_deg: np.ndarray | float, distance_m: np.ndarray | float
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the DEM's grid (column, row) at azimuths and distances, broadcast."""
        azimuth, distance = np.broadcast_arrays(
            np.asarray(azimuth_deg, float), np.asarray(distance_m, float)
        )
        longitude, latitude, _ = self._geod.fwd(
            np.full(azimuth.size, self.longitude), np.full(azimuth.size, self.latitude),
            azimuth.ravel(), distance.ravel(),
        )  # fmt: skip
        x, y = _from_geographic(self.dem.crs, np.asarray(longitude), np.asarray(latitude))
        column, row = self.dem.grid_position(x, y)
        return column.reshape(azimuth.shape), row.reshape(azimuth.shape)

    def polar(self, column: np.ndarray, row: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return azimuth (0–360°) and distance (m) of grid positions, any shape."""
        x, y = self.dem.crs_position(column, row)
        longitude, latitude = _to_geographic(self.dem.crs, x, y)
        azimuth, _, distance = self._geod.inv(
            np.full(longitude.size, self.longitude), np.full(longitude.size, self.latitude),
            longitude.ravel(), latitude.ravel(),
        )  # fmt: skip
        shape = longitude.shape
        return np.asarray(azimuth).reshape(shape) % 360.0, np.asarray(distance).reshape(shape)

    def equidistant_wkt(self) -> str:
        """Return the azimuthal equidistant projection around the origin, as WKT."""
        from pyproj.crs import ProjectedCRS
        from pyproj.crs.coordinate_operation import AzimuthalEquidistantConversion

        conversion = AzimuthalEquidistantConversion(self.latitude, self.longitude)
        return str(ProjectedCRS(conversion, geodetic_crs=degrees_of(self.dem.crs)).to_wkt())

    def wgs84(self) -> tuple[float, float]:
        """Return longitude and latitude of the origin on WGS 84, degrees."""
        return to_wgs84(
            degrees_of(self.dem.crs), self.longitude, self.latitude, self.dem.transformation
        )


def _radius_m(geod: Geod, latitude: float) -> float:
    sine = np.sin(np.radians(latitude))
    return float(geod.a * np.sqrt(1 - geod.es) / (1 - geod.es * sine**2))


@lru_cache(maxsize=64)
def _geod_of(crs: CRS) -> Geod:
    return cast("Geod", crs.get_geod())  # none: not tied to the Earth, refused on opening


def _from_geographic(
    crs: CRS, longitude: np.ndarray, latitude: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Project longitude and latitude of the CRS's own datum (degrees)."""
    if crs.is_geographic and crs.axis_info[0].unit_name == "degree":
        return longitude, latitude
    return transformer(degrees_of(crs), crs).transform(longitude, latitude)


def _to_geographic(crs: CRS, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    if crs.is_geographic and crs.axis_info[0].unit_name == "degree":
        return np.asarray(x), np.asarray(y)
    longitude, latitude = transformer(crs, degrees_of(crs)).transform(x, y)
    return np.asarray(longitude), np.asarray(latitude)


def to_wgs84(crs: CRS, x: float, y: float, by: Transformation | None = None) -> tuple[float, float]:
    """Return WGS 84 longitude and latitude (degrees) of a point in any CRS; see `transformed`."""
    longitude, latitude = _moved(crs, wgs84(), x, y, by)
    return float(longitude), float(latitude)


def local_frame(dem: Dem, x: float, y: float, what: str) -> LocalFrame:
    """Return the frame around a point given in the DEM's CRS.

    Parameters
    ----------
    dem
        Terrain on which the point must lie.
    x, y
        Coordinates in the DEM's CRS.
    what
        Name of the point, for messages.

    Raises
    ------
    MuyscError
        If the point is off the DEM or on no-data.
    """
    ground_height(dem, x, y, what)
    longitude, latitude = _to_geographic(dem.crs, np.asarray([x]), np.asarray([y]))
    return LocalFrame(float(longitude[0]), float(latitude[0]), dem)


def ground_height(dem: Dem, x: float, y: float, what: str) -> float:
    """Return the terrain height (m) under a point given in the DEM's CRS.

    Raises
    ------
    MuyscError
        If the point is off the DEM or on no-data.
    """
    column, row = dem.grid_position(x, y)
    if not bool(dem.contains(column, row)):
        left, top = dem.crs_position(0, 0)
        right, bottom = dem.crs_position(dem.columns - 1, dem.rows - 1)
        raise MuyscError(
            f"The {what} ({x:.10g}, {y:.10g}) is off the DEM {dem.name}, which spans "
            f"x {min(left, right):.10g} to {max(left, right):.10g} and "
            f"y {min(top, bottom):.10g} to {max(top, bottom):.10g} ({dem.crs.name}); move the "
            f"{what} or choose a larger DEM."
        )
    height = float(heights_at(dem, column, row))
    if np.isnan(height):
        raise MuyscError(
            f"The {what} ({x:.10g}, {y:.10g}) lies where the DEM {dem.name} has no data; "
            f"move the {what} or fill the gap."
        )
    return height


def from_wgs84(
    crs: CRS, longitude: float, latitude: float, by: Transformation | None = None
) -> tuple[float, float]:
    """Return the position in any CRS of a WGS 84 longitude and latitude; see `transformed`."""
    x, y = _moved(wgs84(), crs, longitude, latitude, by)
    return float(x), float(y)


def transformed(
    source: CRS, target: CRS, x: np.ndarray, y: np.ndarray, *, by: Transformation | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Return positions of one CRS in another, any shape.

    Parameters
    ----------
    source, target
        From which and to which.
    x, y
        Positions in the first.
    by
        The transformation of the terrain, which leads from and to its datum; None leaves the
        choice to PROJ.

    Raises
    ------
    MuyscError
        If nothing leads from one to the other.
    """
    new_x, new_y = _moved(source, target, x, y, by)
    return np.asarray(new_x), np.asarray(new_y)


def _moved(source: CRS, target: CRS, x: Any, y: Any, by: Transformation | None) -> tuple[Any, Any]:
    """Return positions of one CRS in another, by way of WGS 84 from or to the terrain's datum."""
    if by is not None and by.shares_datum(source) and not by.shares_datum(target):
        x, y = by.to_wgs84(*transformer(source, by.crs).transform(x, y))
        source = wgs84()
    elif by is not None and by.shares_datum(target) and not by.shares_datum(source):
        x, y = by.from_wgs84(*transformer(source, wgs84()).transform(x, y))
        source = by.crs
    moved: tuple[Any, Any] = transformer(source, target).transform(x, y)
    return moved


def geodesic_ends(
    crs: CRS, start: tuple[float, float], azimuth_deg: np.ndarray, distance_m: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return where geodesics from a position of a projected CRS end, in that CRS, (n,) each."""
    longitude, latitude = _to_geographic(crs, np.asarray([start[0]]), np.asarray([start[1]]))
    count = len(azimuth_deg)
    ends = _geod_of(crs).fwd(
        np.repeat(longitude, count), np.repeat(latitude, count), azimuth_deg,
        np.full(count, distance_m),
    )  # fmt: skip
    return _from_geographic(crs, np.asarray(ends[0]), np.asarray(ends[1]))


def gaussian_radius_m(crs: CRS, x: float, y: float) -> float:
    """Return the Gaussian radius of curvature √(MN) of the ellipsoid at a position of a CRS."""
    _, latitude = _to_geographic(crs, np.asarray([x]), np.asarray([y]))
    return _radius_m(_geod_of(crs), float(latitude[0]))
