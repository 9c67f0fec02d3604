"""What the user plans: everything that the dock asks for, and its forms elsewhere."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, fields, replace
from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsPointXY,
    QgsProject,
)

from ...processing_algorithms.parameters.telescope import NONE
from ..errors import MuyscError
from ..radiography.spectra import DEFAULT_MODEL
from ..telescope.presets import PRESETS

#: Decimals of coordinates: a millimetre or better.
_DECIMALS_OF_METRES = 3
_DECIMALS_OF_DEGREES = 8


@dataclass(frozen=True)
class Place:
    """A point with the coordinate reference system that it was picked in."""

    x: float
    y: float
    #: “EPSG:4326”, or the definition itself as “WKT:…”.
    crs: str

    @classmethod
    def of(cls, point: QgsPointXY, crs: QgsCoordinateReferenceSystem) -> Place:
        """Return a point of the map, rounded to what a text can carry."""
        decimals = _DECIMALS_OF_DEGREES if crs.isGeographic() else _DECIMALS_OF_METRES
        name = crs.authid() or f"WKT:{crs.toWkt()}"
        return cls(round(point.x(), decimals), round(point.y(), decimals), name)

    @property
    def point(self) -> QgsPointXY:
        """The point in its own system."""
        return QgsPointXY(self.x, self.y)

    @property
    def system(self) -> QgsCoordinateReferenceSystem:
        """The coordinate reference system."""
        return QgsCoordinateReferenceSystem(self.crs)

    def point_in(self, crs: QgsCoordinateReferenceSystem) -> QgsPointXY:
        """Return the point in another system.

        Raises
        ------
        MuyscError
            If that does not reach there.
        """
        to_crs = QgsCoordinateTransform(self.system, crs, QgsProject.instance())
        try:
            return to_crs.transform(self.point)
        except QgsCsException as error:
            raise MuyscError(
                f"The point {self.text} cannot be shown in {crs.description()}; choose a system "
                "that covers it."
            ) from error

    @property
    def text(self) -> str:
        """The point as Processing reads it."""
        return f"{self.x!r},{self.y!r} [{self.crs}]"


@dataclass(frozen=True)
class Plan:
    """A telescope on a mountain, before anything is computed."""

    #: Id of the layer in the project, empty for none.
    dem: str = ""
    detector: Place | None = None
    detector_height_m: float = 0.0
    target: Place | None = None
    target_height_m: float = 0.0
    #: Key of `PRESETS`, or `NONE` for an acceptance given as a number.
    preset: str = NONE
    azimuth_aperture_deg: float = 60.0
    elevation_aperture_deg: float = 30.0
    acceptance_cm2_sr: float = 6.0
    muons: float = 10.0
    days: float = 30.0
    material: str = "standard_rock"
    #: None for the material's own.
    density_g_cm3: float | None = None
    flux_model: str = DEFAULT_MODEL

    def with_place(self, role: str, place: Place) -> Plan:
        """Return the plan with the detector or the target somewhere else."""
        if role == "detector":
            return replace(self, detector=place)
        return replace(self, target=place)

    def with_preset(self, preset: str) -> Plan:
        """Return the plan with a telescope, and its whole field of view."""
        if preset not in PRESETS:
            return replace(self, preset=preset)
        half = PRESETS[preset].geometry.half_aperture_deg
        across, up = (round(2 * width, 1) for width in half)
        return replace(self, preset=preset, azimuth_aperture_deg=across, elevation_aperture_deg=up)

    def radiography(self, dem: str) -> dict[str, Any]:
        """Return the parameters of the algorithm radiography; `dem` is an id or a file."""
        given = {
            **self._sight(dem),
            "AZIMUTH_APERTURE": self.azimuth_aperture_deg,
            "ELEVATION_APERTURE": self.elevation_aperture_deg,
            **self._physics(),
            "MUONS": self.muons,
        }
        if self.preset == NONE:
            return {**given, "ACCEPTANCE": self.acceptance_cm2_sr}
        return {**given, "PRESET": self.preset}

    def expected_counts(self, dem: str) -> dict[str, Any]:
        """Return the parameters of the algorithm expectedcounts; `dem` is an id or a file."""
        given = {
            **self._sight(dem), **self._physics(), "DAYS": self.days, "MUONS": self.muons,
        }  # fmt: skip
        return given if self.preset == NONE else {**given, "PRESET": self.preset}

    def _sight(self, dem: str) -> dict[str, Any]:
        return {
            "DEM": dem,
            "DETECTOR": self.detector.text if self.detector else None,
            "DETECTOR_HEIGHT": self.detector_height_m,
            "TARGET": self.target.text if self.target else None,
            "TARGET_HEIGHT": self.target_height_m,
        }

    def _physics(self) -> dict[str, Any]:
        given: dict[str, Any] = {"MATERIAL": self.material, "FLUX_MODEL": self.flux_model}
        if self.density_g_cm3 is not None:
            given["DENSITY"] = self.density_g_cm3
        return given

    def to_json(self) -> str:
        """Return the plan as the project keeps it."""
        return json.dumps(asdict(self))

    @classmethod
    def from_json(cls, text: str) -> Plan:
        """Return a plan that a project kept; the default for whatever it lacks."""
        try:
            kept = dict(json.loads(text))
            places = {
                name: Place(**kept[name]) for name in ("detector", "target") if kept.get(name)
            }
        except (ValueError, TypeError):
            return cls()
        values = {
            field.name: kept[field.name]
            for field in fields(cls)
            if field.name in kept and _fits(kept[field.name], field.default)
        }
        return cls(**{**values, **places})


def _fits(value: object, default: object) -> bool:
    """Return whether a value can stand in for a default: numbers and texts for their like."""
    numbers = (float, int)
    if default is None or isinstance(default, numbers):
        return isinstance(value, numbers) or value is default
    return isinstance(value, type(default))
