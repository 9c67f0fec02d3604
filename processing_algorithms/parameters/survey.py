"""Parameters of a survey: where candidates lie, what they must keep to, how many are chosen."""

from __future__ import annotations

from typing import Any

import numpy as np
from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterRasterLayer,
    QgsRasterLayer,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.survey.candidates import Limits
from ...muysc_qgis.survey.search import Search
from ...muysc_qgis.topography.dem import Dem
from ...muysc_qgis.workflows.site_selection import Wanted
from ..compat import VECTOR_LINE, VECTOR_POINT
from .sites import placed, point_source, points_of, way_to
from .terrain import raster_layer
from .values import explained, given, number, read_count, read_number, read_optional


def candidate_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare where candidates lie and what they must keep to."""
    return [
        number(
            "MIN_DISTANCE", "Smallest distance to the target (m)",
            "Give the horizontal distance in m within which no telescope stands, 0 or more.",
            500.0, 0,
        ),
        number(
            "MAX_DISTANCE", "Largest distance to the target (m)",
            "Give the horizontal distance in m beyond which no telescope stands, above 0.",
            3000.0, 0,
        ),
        number(
            "SPACING", "Spacing of candidates and maps (m)",
            "Give the distance between candidates in m, above 0: also the cell size of the maps. "
            "Half of it makes four times as many candidates.",
            100.0, 0,
        ),
        number(
            "MAX_SLOPE", "Steepest slope (°, 90: any)",
            "Give the steepest ground in degrees, above 0 and up to 90, measured over one cell of "
            "the DEM to each side.",
            30.0, 0, 90,
        ),
        number(
            "ABOVE_TARGET", "Highest above the target (m, empty: any)",
            "Give how much the ground at a candidate may be above the ground at the target in m; "
            "negative where it must be below.",
            None, advanced=True,
        ),
        number(
            "BELOW_TARGET", "Lowest below the target (m, empty: any)",
            "Give how much the ground at a candidate may be below the ground at the target in m; "
            "negative where it must be above.",
            None, advanced=True,
        ),
        explained(
            QgsProcessingParameterFeatureSource("ROADS", "Roads", [VECTOR_LINE], None, True),
            "Layer of lines that telescopes must be near, in any coordinate reference system.",
        ),
        number(
            "ROAD_DISTANCE", "Largest distance to a road (m)",
            "Give the distance in m to the nearest road beyond which no telescope stands, above "
            "0. It counts where ROADS is given.",
            500.0, 0,
        ),
        explained(
            QgsProcessingParameterRasterLayer("MASK", "Mask of candidates", None, True),
            "Raster that says where telescopes may stand: anywhere that its first band is neither "
            "0 nor no data. In any coordinate reference system.",
        ),
        explained(
            QgsProcessingParameterFeatureSource("CANDIDATES", "Candidates", [VECTOR_POINT], None,
                                                True),
            "Layer of points to choose from, in place of a grid around the target. The limits hold "
            "for them too.",
        ),
    ]  # fmt: skip


def target_body_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare what of the mountain is to be seen, and when it is."""
    return [
        number(
            "TARGET_RADIUS", "Radius of the target body (m)",
            "Give the radius in m of the part of the mountain that matters, above 0: a vertical "
            "cylinder around the target.",
            300.0, 0,
        ),
        number(
            "TARGET_DEPTH", "Depth of the target body (m)",
            "Give how far in m below the ground at the target the target body reaches, above 0.",
            300.0, 0,
        ),
        number(
            "MINIMUM_THICKNESS", "Thinnest rock to see through (m)",
            "Give the thickness of rock in m below which a ray says nothing of the target, 0 or "
            "more.",
            50.0, 0,
        ),
        number(
            "MAXIMUM_THICKNESS", "Thickest rock to see through (m)",
            "Give the thickness of rock in m above which too few muons come through, above the "
            "thinnest.",
            1000.0, 0,
        ),
        number(
            "DAYS", "Days of the campaign",
            "Give the days that telescopes will count, above 0. The score weighs exposure times "
            "against it.",
            100.0, 0,
        ),
    ]  # fmt: skip


def choice_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare how many sites are chosen."""
    return [
        number(
            "SITES_WANTED", "Number of best sites",
            "Give how many of the best candidates to list, 1 or more.",
            10, 1, whole=True,
        ),
        number(
            "SITES_APART", "Distance between best sites (m)",
            "Give how far in m the best sites are from each other at the least, 0 or more.",
            250.0, 0,
        ),
        number(
            "TELESCOPES", "Number of telescopes",
            "Give how many telescopes are to cover the target's sides together, 1 or more.",
            3, 1, whole=True,
        ),
        number(
            "COVERED_ANGLE", "Angle that a telescope covers (°, empty: 360° over their number)",
            "Give the angle around the target in degrees, above 0 and up to 360, to either side of "
            "a telescope, at which it adds nothing any more.",
            None, 0, 360, advanced=True,
        ),
    ]  # fmt: skip


def read_search(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    dem: Dem,
    layer: QgsRasterLayer,
    target: tuple[float, float],
) -> tuple[Search, list[str]]:
    """Return where candidates are looked for, and what was assumed for it.

    Raises
    ------
    MuyscError
        If a value or a layer cannot be used.
    """
    read = (algorithm, parameters)
    nearest, farthest, spacing, slope, road = (
        read_number(*read, name, context)
        for name in ("MIN_DISTANCE", "MAX_DISTANCE", "SPACING", "MAX_SLOPE", "ROAD_DISTANCE")
    )
    above, below = (
        read_optional(*read, name, context) for name in ("ABOVE_TARGET", "BELOW_TARGET")
    )
    points, roads, mask = None, None, None
    notes: list[str] = []
    if given(parameters, "CANDIDATES"):
        points, assumed = _read_points(*read, context, dem, layer)
        notes += assumed
    if given(parameters, "ROADS"):
        roads, assumed = _read_roads(*read, context, dem, layer)
        notes += assumed
    if given(parameters, "MASK"):
        raster = raster_layer(*read, "MASK", context)
        mask = (raster.source(), raster.crs().toWkt())
    limits = Limits(nearest, farthest, slope, above, below, road if roads is not None else None)
    return Search(dem, target, limits, spacing, points, roads, mask), notes


def read_wanted(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Wanted:
    """Return how many sites are chosen.

    Raises
    ------
    MuyscError
        If a number cannot be used.
    """
    read = (algorithm, parameters)
    return Wanted(
        read_count(*read, "SITES_WANTED", context),
        read_number(*read, "SITES_APART", context),
        read_count(*read, "TELESCOPES", context),
        read_optional(*read, "COVERED_ANGLE", context),
    )


def _read_points(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    dem: Dem,
    layer: QgsRasterLayer,
) -> tuple[np.ndarray, list[str]]:
    source = point_source(algorithm, parameters, "CANDIDATES", context)
    way, notes = way_to(dem, layer, source, "CANDIDATES", context)
    found = [
        point for feature in source.getFeatures() for point in points_of(feature.geometry(), way)
    ]
    points = [point for point in found if point is not None]
    if len(points) < len(found):
        notes.append(
            f"{len(found) - len(points)} of {len(found)} candidates have no place on the map."
        )
    if not points:
        raise MuyscError("No point of CANDIDATES has a place on the map; choose another layer.")
    return np.array(points), notes


def _read_roads(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    dem: Dem,
    layer: QgsRasterLayer,
) -> tuple[np.ndarray, list[str]]:
    source = algorithm.parameterAsSource(parameters, "ROADS", context)
    if source is None:
        raise MuyscError(f"ROADS “{parameters['ROADS']}” is no layer; choose a layer of lines.")
    way, notes = way_to(dem, layer, source, "ROADS", context)
    segments: list[tuple[float, ...]] = []
    for feature in source.getFeatures():
        geometry = feature.geometry()
        # A feature without a geometry has no part; curves come as straight pieces.
        for part in geometry.constParts():
            line = part.segmentize()
            points = placed(line.vertices(), way)
            segments += [
                (*start, *end)
                for start, end in zip(points, points[1:])
                if start is not None and end is not None
            ]
    if not segments:
        raise MuyscError("ROADS holds no line on the map; choose another layer or leave it empty.")
    return np.array(segments), notes
