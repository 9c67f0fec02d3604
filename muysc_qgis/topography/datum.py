"""Between the datum of a terrain and WGS 84: one operation for both directions."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ..errors import MuyscError

if TYPE_CHECKING:
    from pyproj import CRS, Transformer

#: Half the side (degrees) of the area for which the best operation is looked for.
_AREA_DEG = 0.01

#: Share of a position by which two computations of one operation may differ: 1 cm in 10 000 km.
_ALIKE = 1e-9


@dataclass(frozen=True)
class Transformation:
    """How positions become longitudes and latitudes on WGS 84, and how these come back.

    Between two datums there often are several operations, metres apart. A run uses one, and its
    inverse on the way back, so that a point comes out where it went in.
    """

    #: Of the positions, x before y.
    crs: CRS
    #: Pipelines of PROJ that follow each other from `crs` to longitude and latitude in degrees,
    #: and whether each is run backwards.
    steps: tuple[tuple[str, bool], ...]
    #: As the register of PROJ has it, “NAD27 to WGS 84 (4)”.
    name: str
    #: In m, None where it is unknown.
    accuracy_m: float | None

    @property
    def doubts(self) -> tuple[str, ...]:
        """What the user must know before trusting positions, a sentence each."""
        if self.accuracy_m is not None:
            return ()
        return (
            f"The accuracy of the transformation between {degrees_of(self.crs).name} and WGS 84 "
            f"({self.name}) is unknown: longitudes and latitudes may be off by 100 m or more; set "
            "a better transformation in the project's properties, or install the grid it needs.",
        )

    def to_wgs84(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return longitudes and latitudes (degrees) of positions, infinite where there are none."""
        for pipeline, backwards in self.steps:
            x, y = _pipeline(pipeline).transform(x, y, direction=_direction(backwards))
        return x, y

    def from_wgs84(
        self, longitude: np.ndarray, latitude: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return positions of longitudes and latitudes (degrees), infinite where there are none."""
        x, y = longitude, latitude
        for pipeline, backwards in reversed(self.steps):
            x, y = _pipeline(pipeline).transform(x, y, direction=_direction(not backwards))
        return x, y

    def shares_datum(self, crs: CRS) -> bool:
        """Return whether a CRS is on the datum of the positions."""
        return _one_datum(crs, self.crs)

    def plain(self) -> dict[str, Any]:
        """Return plain settings from which `of` makes the same in another process."""
        return {
            "crs": self.crs.to_json(),
            "steps": [list(step) for step in self.steps],
            "name": self.name,
            "accuracy_m": self.accuracy_m,
        }

    @classmethod
    def of(cls, plain: Mapping[str, Any]) -> Transformation:
        """Return the transformation of plain settings, which may have been text in between."""
        from pyproj import CRS

        steps = tuple((str(pipeline), bool(backwards)) for pipeline, backwards in plain["steps"])
        return cls(CRS.from_json(plain["crs"]), steps, plain["name"], plain["accuracy_m"])


@lru_cache(maxsize=64)
def own_transformation(crs: CRS, x: float, y: float) -> Transformation | None:
    """Return PROJ's best operation to WGS 84 at a position.

    None where the system is on WGS 84 itself, or where nothing leads there: who asks for a
    longitude then is told.

    Parameters
    ----------
    crs
        Geographic or projected.
    x, y
        A position in it.
    """
    from pyproj.aoi import AreaOfInterest
    from pyproj.exceptions import ProjError
    from pyproj.transformer import TransformerGroup

    if _one_datum(crs, wgs84()):
        return None
    longitude, latitude = transformer(crs, degrees_of(crs)).transform(x, y)
    # The same longitude in −180…180°, which areas of use are in.
    longitude = (longitude + 180) % 360 - 180
    area: Any = None
    if math.isfinite(longitude) and abs(latitude) <= 90 - _AREA_DEG:
        sides = np.clip(longitude + np.array([-_AREA_DEG, _AREA_DEG]), -180, 180)
        area = AreaOfInterest(
            float(sides[0]), latitude - _AREA_DEG, float(sides[1]), latitude + _AREA_DEG
        )
    # One made for another part of the datum's area is better than to take two datums for one.
    wishes = ((area, False), (None, False), (None, True))
    try:
        with warnings.catch_warnings():
            # What a missing grid would make better is no trouble here.
            warnings.simplefilter("ignore")
            groups = (
                TransformerGroup(
                    crs, wgs84(), always_xy=True, area_of_interest=where, allow_ballpark=guess
                ).transformers
                for where, guess in wishes
            )
            best = next((one[0] for one in groups if one), None)
    except ProjError:
        return None
    if best is None:
        return None
    # Exact: the longitudes of another meridian or of WGS 84 in three dimensions.
    if best.accuracy == 0:
        return None
    name = name_of_operation(best.description)
    return Transformation(crs, ((best.definition, False),), name, known_accuracy(best.accuracy))


def leads(step: tuple[str, bool], start: tuple[float, float], end: tuple[float, float]) -> bool:
    """Return whether a step is known to PROJ and leads from one position to another.

    Another program's PROJ may have grids that this one lacks, or name them otherwise.

    Parameters
    ----------
    step
        A pipeline, and whether it is run backwards.
    start, end
        Positions, and what the other program made of them.
    """
    from pyproj.exceptions import ProjError

    pipeline, backwards = step
    try:
        found = _pipeline(pipeline).transform(*start, direction=_direction(backwards))
    except ProjError:
        return False
    return bool(np.allclose(found, end, rtol=_ALIKE, atol=_ALIKE))


def name_of_operation(description: str) -> str:
    """Return the part of a description of PROJ that tells of datums.

    “Inverse of UTM zone 10N + NAD27 to WGS 84 (4) + axis order change (2D)” has one such part.
    """
    parts = [part for part in description.split(" + ") if " to " in part]
    return " + ".join(parts) or description or "an operation without a name"


def described(name: str, accuracy_m: float | None) -> str:
    """Return an operation in words, with its accuracy (m, None where unknown)."""
    accuracy = "of unknown accuracy" if accuracy_m is None else f"accurate to {accuracy_m:g} m"
    return f"{name}, {accuracy}"


def known_accuracy(accuracy_m: float) -> float | None:
    """Return an accuracy (m) of PROJ, which says −1 where it is unknown."""
    return accuracy_m if accuracy_m >= 0 else None


@lru_cache(maxsize=64)
def transformer(source: CRS, target: CRS) -> Transformer:
    """Return a cached transformer; building one costs more than using it.

    Raises
    ------
    MuyscError
        If nothing leads from one to the other.
    """
    from pyproj import Transformer
    from pyproj.exceptions import ProjError

    try:
        return Transformer.from_crs(source, target, always_xy=True)
    except ProjError as error:
        raise MuyscError(
            f"No transformation leads from {source.name} to {target.name}; assign the raster a "
            "coordinate reference system on the Earth."
        ) from error


@lru_cache(maxsize=64)
def degrees_of(crs: CRS) -> CRS:
    """Return the geographic CRS on the datum of another, in degrees.

    A few national datums count in grads (NTF in Paris, for one).
    """
    from pyproj.crs import GeographicCRS

    geodetic = cast("CRS", crs.geodetic_crs)  # none: refused when the DEM was opened
    if geodetic.axis_info[0].unit_name == "degree":
        return geodetic
    return GeographicCRS(geodetic.name, datum=geodetic.datum)


@lru_cache(maxsize=1)
def wgs84() -> CRS:
    """Return WGS 84; making it takes longer than a transformation."""
    from pyproj import CRS

    return CRS.from_epsg(4326)


@lru_cache(maxsize=64)
def _one_datum(one: CRS, other: CRS) -> bool:
    return bool(degrees_of(one).equals(degrees_of(other), ignore_axis_order=True))


@lru_cache(maxsize=64)
def _pipeline(text: str) -> Transformer:
    from pyproj import Transformer

    return Transformer.from_pipeline(text)


def _direction(backwards: bool) -> Any:
    from pyproj.enums import TransformDirection

    return TransformDirection.INVERSE if backwards else TransformDirection.FORWARD
