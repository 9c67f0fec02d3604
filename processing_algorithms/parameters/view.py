"""Parameters of where the telescope stands and what it looks at."""

from __future__ import annotations

import re
from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterPoint,
    QgsRasterLayer,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.radiography.aperture import Aperture
from ...muysc_qgis.topography.dem import Dem
from ...muysc_qgis.topography.sight import Sight, take_sight
from .transformation import passage
from .values import explained, given, number, read_count, read_number

#: A point without a coordinate reference system, as a script writes it.
_BARE_POINT = re.compile(r"^\s*[-+.\deE]+\s*,\s*[-+.\deE]+\s*$")


def sight_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare detector and target."""
    return [
        explained(
            QgsProcessingParameterPoint("DETECTOR", "Detector"),
            "Where the telescope stands, on the DEM. As text: x,y [EPSG:code]; without a code the "
            "point is in the project's CRS, or the DEM's where there is no project.",
        ),
        detector_height_parameter(),
        *target_parameters(),
    ]


def detector_height_parameter() -> QgsProcessingParameterDefinition:
    """Declare how high the detector stands."""
    return number(
        "DETECTOR_HEIGHT", "Detector height above ground (m)",
        "Give the height of the telescope above the ground in m, −10000 to 10000; negative in "
        "a tunnel or borehole.",
        0.0, -10_000, 10_000,
    )  # fmt: skip


def target_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare what is looked at."""
    return [
        explained(
            QgsProcessingParameterPoint("TARGET", "Target"),
            "What the telescope points at, on the DEM: the middle of the field of view.",
        ),
        number(
            "TARGET_HEIGHT", "Target height above ground (m)",
            "Give the height of the aiming point above the ground in m, −10000 to 10000; negative "
            "inside the mountain.",
            0.0, -10_000, 10_000,
        ),
    ]  # fmt: skip


def read_sight(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    dem: Dem,
    layer: QgsRasterLayer,
) -> tuple[Sight, list[str]]:
    """Return the line of sight, and what had to be assumed for it.

    Raises
    ------
    MuyscError
        If a point is missing or cannot be used.
    """
    read = (algorithm, parameters)
    detector, detector_notes = read_point(*read, "DETECTOR", context, dem, layer)
    target, target_notes = read_point(*read, "TARGET", context, dem, layer)
    return (
        take_sight(
            dem,
            detector,
            target,
            read_number(*read, "DETECTOR_HEIGHT", context),
            read_number(*read, "TARGET_HEIGHT", context),
        ),
        [*detector_notes, *target_notes],
    )


def read_point(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
    dem: Dem,
    layer: QgsRasterLayer,
) -> tuple[tuple[float, float], list[str]]:
    """Return a point in the CRS of the DEM's layer, and what had to be assumed for it.

    Raises
    ------
    MuyscError
        If the point is missing or none, or has no place in that CRS.
    """
    if not given(parameters, name):
        raise MuyscError(f"{name} is missing; give a point, as text x,y [EPSG:code], on the DEM.")
    value = parameters[name]
    is_text = isinstance(value, str)
    if is_text and not re.match(r"^\s*[-+.\deE]+\s*,\s*[-+.\deE]+", value):
        raise MuyscError(f"{name} is “{value}”, which is not a point; write x,y [EPSG:code].")
    point = algorithm.parameterAsPoint(parameters, name, context)
    # That of the project where the point names none, and invalid where there is no project.
    crs = algorithm.parameterAsPointCrs(parameters, name, context)
    crs = crs if crs.isValid() else layer.crs()
    notes = []
    if is_text and _BARE_POINT.match(value):
        notes.append(f"{name} names no coordinate reference system; {crs.authid()} was assumed.")
    way = passage(name, crs, dem, layer.crs(), context)
    place = way.to_dem(point.x(), point.y())
    if place is None:
        raise MuyscError(
            f"{name} ({point.x():.10g}, {point.y():.10g}) cannot be transformed from "
            f"{crs.authid() or crs.description()} to that of the DEM; check that its coordinates "
            "are of that system."
        )
    return place, [*notes, *way.notes]


def aperture_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare the field of view and how far it reaches."""
    return [
        number(
            "AZIMUTH_APERTURE", "Azimuth aperture (°)",
            "Give the full width of the field of view in azimuth, above 0° and up to 360°.",
            60.0, 0, 360,
        ),
        number(
            "ELEVATION_APERTURE", "Elevation aperture (°)",
            "Give the full height of the field of view in elevation, above 0° and up to 180°; it "
            "must not reach past the zenith.",
            30.0, 0, 180,
        ),
        number(
            "AZIMUTH_PIXELS", "Pixels in azimuth",
            "Give the number of muogram columns, 1 or more.", 100, 1, whole=True,
        ),
        number(
            "ELEVATION_PIXELS", "Pixels in elevation",
            "Give the number of muogram rows, 1 or more.", 100, 1, whole=True,
        ),
        number(
            "MAX_RANGE", "Maximum range (m, empty: as far as the DEM)",
            "Give the largest horizontal distance in m at which rock counts, above 0. Rays still "
            "in rock there keep the thickness up to it. Empty looks as far as the DEM reaches.",
            None, 0, advanced=True,
        ),
        number(
            "NEAR_FIELD", "Near field to ignore (m)",
            "Give the distance in m within which terrain is ignored, 0 or more: for small bumps at "
            "the detector's foot that a DEM cannot resolve.",
            0.0, 0, advanced=True,
        ),
    ]  # fmt: skip


def read_aperture(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Aperture:
    """Return the field of view.

    Raises
    ------
    MuyscError
        If a width or count cannot be used.
    """
    return Aperture(
        read_number(algorithm, parameters, "AZIMUTH_APERTURE", context),
        read_number(algorithm, parameters, "ELEVATION_APERTURE", context),
        read_count(algorithm, parameters, "AZIMUTH_PIXELS", context),
        read_count(algorithm, parameters, "ELEVATION_PIXELS", context),
    )
