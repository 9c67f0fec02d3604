"""Detector and target on the terrain, and the line of sight between them."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from .dem import Dem
from .frame import LocalFrame, ground_height, local_frame, to_wgs84

#: Detector and target closer than this (m) are the same point.
_SAME_POINT_M = 0.01
#: Heights above ground (m) that no telescope or target has.
_HEIGHT_LIMIT_M = 10_000.0


@dataclass(frozen=True)
class Sight:
    """A detector on a DEM and the direction of its target.

    Elevations are in the DEM's heights; azimuth and elevation angle are those of
    the straight line between the two points.
    """

    frame: LocalFrame
    #: Height of the detector above ground (m), negative below it.
    detector_height_m: float
    detector_elevation_m: float
    #: (longitude, latitude) on WGS 84, degrees.
    detector_wgs84: tuple[float, float]
    target_wgs84: tuple[float, float]
    target_elevation_m: float
    #: Horizontal (geodesic) distance.
    target_distance_m: float
    boresight_azimuth_deg: float
    boresight_elevation_deg: float


def take_sight(
    dem: Dem,
    detector: tuple[float, float],
    target: tuple[float, float],
    detector_height_m: float = 0.0,
    target_height_m: float = 0.0,
) -> Sight:
    """Aim a detector at a target.

    Parameters
    ----------
    dem
        Terrain.
    detector, target
        (x, y) in the DEM's CRS.
    detector_height_m, target_height_m
        Heights above ground, negative below it.

    Raises
    ------
    MuyscError
        If a point is off the DEM or on no-data, a height is impossible, or the
        two points are one.
    """
    for name, height in (("detector", detector_height_m), ("target", target_height_m)):
        if not abs(height) <= _HEIGHT_LIMIT_M:
            raise MuyscError(
                f"A {name} height of {height:g} m above ground is impossible; give a number "
                f"between −{_HEIGHT_LIMIT_M:g} and {_HEIGHT_LIMIT_M:g} m."
            )
    frame = local_frame(dem, *detector, "detector")
    eye = ground_height(dem, *detector, "detector") + detector_height_m
    aim = ground_height(dem, *target, "target") + target_height_m
    column, row = dem.grid_position(np.asarray([target[0]]), np.asarray([target[1]]))
    azimuth, distance = (float(value[0]) for value in frame.polar(column, row))
    if distance < _SAME_POINT_M:
        raise MuyscError(
            f"Detector and target are the same point ({detector[0]:.6g}, {detector[1]:.6g}), so "
            "the telescope has no direction; move one of them."
        )
    rise = aim - eye - float(frame.drop(distance))
    return Sight(
        frame,
        detector_height_m,
        eye,
        frame.wgs84(),
        to_wgs84(dem.crs, *target, dem.transformation),
        aim,
        distance,
        azimuth,
        math.degrees(math.atan2(rise, distance)),
    )
