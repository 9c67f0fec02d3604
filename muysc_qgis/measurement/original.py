"""The text muograms of the first MUYSC.

Its `save_data` writes four comment lines (``Op`` and ``Pp``: longitude, latitude and
elevation of detector and target; ``A``: the region; the names of the columns) and one line
for each ray. Angles are in radians from the line to the target: the one called ``cenith``
grows upwards, the azimuth counterclockwise, because the target is turned by it in a frame
of longitude and latitude. The lengths are metres, though the names say kilometres: they are
what its `measure` returns, and its flux module divides them by 1000.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from .text import TextTable

#: WGS 84 (NIMA TR8350.2): semi-major axis in m, and eccentricity squared.
_EQUATOR_M = 6_378_137.0
_ECCENTRICITY_SQUARED = 6.69437999014e-3

_POINT = re.compile(r"^(Op|Pp)((?:\s+\S+){3})\s*$")


@dataclass(frozen=True)
class OriginalHeader:
    """Detector and target of a text muogram, (longitude, latitude, elevation in m)."""

    detector: tuple[float, float, float]
    target: tuple[float, float, float]


def original_header(table: TextTable) -> OriginalHeader | None:
    """Return what the comments of the first MUYSC say, None for any other file."""
    points = {}
    for comment in table.comments:
        match = _POINT.match(comment)
        if match:
            # Where the target is the highest point found, its coordinates are arrays.
            numbers = [text.strip("[]") for text in match.group(2).split()]
            try:
                points[match.group(1)] = tuple(float(text) for text in numbers)
            except ValueError:
                return None
    if len(points) < 2 or table.values.shape[1] != 3:
        return None
    return OriginalHeader(points["Op"], points["Pp"])  # type: ignore[arg-type]


def line_of_sight(header: OriginalHeader) -> tuple[float, float, float]:
    """Return azimuth and elevation (degrees) and horizontal distance (m) of the target.

    On the plane that touches the WGS 84 ellipsoid half way between the two points, right
    to 10⁻⁴ over the kilometres that muography spans.
    """
    (lon, lat, height), (target_lon, target_lat, target_height) = header.detector, header.target
    middle = math.radians((lat + target_lat) / 2)
    curvature = 1.0 - _ECCENTRICITY_SQUARED * math.sin(middle) ** 2
    across = _EQUATOR_M / math.sqrt(curvature)
    along = across * (1.0 - _ECCENTRICITY_SQUARED) / curvature
    turn = (target_lon - lon + 180.0) % 360.0 - 180.0
    east = across * math.cos(middle) * math.radians(turn)
    north = along * math.radians(target_lat - lat)
    distance = math.hypot(east, north)
    return (
        math.degrees(math.atan2(east, north)) % 360.0,
        math.degrees(math.atan2(target_height - height, distance)),
        distance,
    )
