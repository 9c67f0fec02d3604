"""Where a volume lies on the map: true metres, true north and straight rays in a projection."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import MuyscError
from ..tomography.voxels import VoxelGrid
from ..topography.datum import Transformation
from ..topography.dem import Dem
from ..topography.frame import from_wgs84, gaussian_radius_m, geodesic_ends, to_wgs84

if TYPE_CHECKING:
    from pyproj import CRS

#: Half the distance (m) over which scale and north of a projection are measured.
_BASE_LINE_M = 500.0

#: Largest share by which a projection may stretch lengths: 0.04 % at the middle of a UTM zone,
#: 0.1 % at its border.
_MOST_STRETCH = 0.01

#: Largest share by which it may stretch one direction more than another.
_MOST_SKEW = 0.001


@dataclass(frozen=True)
class VolumeFrame:
    """A projection around the middle of a volume, in true metres in which muons fly straight.

    Horizontal positions are counted from the middle and divided by the projection's scale
    there, so that lengths are true: across a volume 10 km wide the scale of a UTM zone
    changes by less than 1e-4. Up is counted from the plane that touches the level surface at the
    middle's sea level, from which the Earth falls away by r²/2R at the distance r (2 m at 5 km).
    Slices of a volume are level to that.
    """

    crs: CRS
    #: Position of the middle in the CRS.
    middle: tuple[float, float]
    #: Metres of the CRS for one on the ground.
    scale: float
    #: Radius of the Earth in the middle.
    radius_m: float
    #: That of the terrain, which counts where the CRS is on its datum.
    by: Transformation | None = None

    @classmethod
    def around(
        cls, crs: CRS, middle: tuple[float, float], by: Transformation | None = None
    ) -> VolumeFrame:
        """Return the frame around a position of a projected CRS.

        Raises
        ------
        MuyscError
            If lengths are not true in the projection.
        """
        stretch = _stretch(crs, middle)
        widest, least = np.linalg.svd(stretch, compute_uv=False)
        scale = float(np.sqrt(widest * least))
        if abs(scale - 1) > _MOST_STRETCH or widest / least - 1 > _MOST_SKEW:
            raise MuyscError(
                f"{crs.name} stretches lengths by {100 * (widest - 1):.2g} % here, too much for "
                "voxels of one size; choose a projection that is true to scale, such as the UTM "
                f"zone {utm_zone(*to_wgs84(crs, *middle)).name}."
            )
        return cls(crs, middle, scale, gaussian_radius_m(crs, *middle), by)

    def metric(self, grid: VoxelGrid) -> VoxelGrid:
        """Return a grid of the CRS in true metres around the middle."""
        (x, y, z), (width, depth, height) = grid.origin_m, grid.size_m
        east, north = self.local(np.array(x), np.array(y))
        size = (width / self.scale, depth / self.scale, height)
        return VoxelGrid((float(east), float(north), z), size, grid.shape)

    def local(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return true metres east and north of the middle of positions in the CRS."""
        return (x - self.middle[0]) / self.scale, (y - self.middle[1]) / self.scale

    def place(self, longitude: float, latitude: float) -> tuple[float, float]:
        """Return the position in the CRS of a WGS 84 longitude and latitude in degrees."""
        return from_wgs84(self.crs, longitude, latitude, self.by)

    def drop(self, east_m: np.ndarray, north_m: np.ndarray) -> np.ndarray:
        """Return how far (m) level surfaces lie below the frame's planes at positions in it."""
        return (east_m**2 + north_m**2) / (2 * self.radius_m)

    def lines(
        self, station: Sequence[float], azimuth_deg: np.ndarray, elevation_deg: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the rays of a station in the frame.

        Above sea level a ray rises as h + d tan θ + d²/2R. In the frame that is a straight line:
        with the station at the horizontal position s and the level unit vector u of the ray, it
        starts at h − s²/2R and rises by tan θ − s·u/R. True north is that of the station.

        Parameters
        ----------
        station
            x and y in the CRS, and height.
        azimuth_deg, elevation_deg
            (n,) directions.

        Returns
        -------
        tuple
            (n, 3) origins and (n, 3) unit directions: east, north and up in true metres.
        """
        azimuth = np.radians(azimuth_deg)
        level = np.stack([np.sin(azimuth), np.cos(azimuth)], axis=-1)
        level = level @ _stretch(self.crs, (station[0], station[1])).T
        level /= np.linalg.norm(level, axis=-1, keepdims=True)
        place = np.stack(self.local(np.array(station[0]), np.array(station[1])))
        slope = np.tan(np.radians(elevation_deg)) - level @ place / self.radius_m
        direction = np.concatenate([level, slope[:, None]], axis=1)
        direction /= np.linalg.norm(direction, axis=1, keepdims=True)
        start = np.append(place, station[2] - self.drop(place[0], place[1]))
        return np.broadcast_to(start, direction.shape).copy(), direction


def projection_for(dem: Dem, longitude: float, latitude: float) -> CRS:
    """Return the DEM's own CRS where its lengths are true metres, else the UTM zone.

    Parameters
    ----------
    dem
        Terrain.
    longitude, latitude
        WGS 84 degrees of the place where lengths count.
    """
    crs = dem.crs
    if _in_metres(crs):
        with contextlib.suppress(MuyscError):
            return VolumeFrame.around(crs, from_wgs84(crs, longitude, latitude)).crs
    return utm_zone(longitude, latitude)


def chosen_projection(definition: str, name: str) -> CRS:
    """Return a projection in metres that a user chose.

    Parameters
    ----------
    definition
        In any form that `pyproj.CRS` takes.
    name
        What the user calls it.

    Raises
    ------
    MuyscError
        If it is none.
    """
    from pyproj import CRS

    crs = CRS.from_user_input(definition)
    if not _in_metres(crs):
        raise MuyscError(
            f"The coordinate reference system {name} ({crs.name}) is no projection in metres, "
            "which voxels need; choose a projected one such as a UTM zone, or leave it empty."
        )
    return crs


def utm_zone(longitude: float, latitude: float) -> CRS:
    """Return the UTM zone on WGS 84 of a longitude and latitude in degrees."""
    from pyproj import CRS

    zone = int((longitude + 180.0) % 360.0 // 6) + 1
    return CRS.from_epsg((32600 if latitude >= 0 else 32700) + zone)


def _in_metres(crs: CRS) -> bool:
    """Return whether a CRS is a projection in metres."""
    units = [axis.unit_conversion_factor for axis in crs.axis_info[:2]]
    return crs.is_projected and all(unit == 1 for unit in units)


def _stretch(crs: CRS, place: tuple[float, float]) -> np.ndarray:
    """Return d(x, y)/d(east, north) of a CRS at a position, 2 × 2."""
    x, y = geodesic_ends(crs, place, np.array([90.0, 0.0, 270.0, 180.0]), _BASE_LINE_M)
    return np.array([x[:2] - x[2:], y[:2] - y[2:]]) / (2 * _BASE_LINE_M)
