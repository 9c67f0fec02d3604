"""The field of view as polygons on the map."""

from __future__ import annotations

from typing import Any

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsFields,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSink,
)

from ...muysc_qgis.radiography.aperture import Aperture
from ...muysc_qgis.staging import Staging
from ...muysc_qgis.topography.footprint import Outline
from ...muysc_qgis.topography.sight import Sight
from ...muysc_qgis.workflows.simulation import Simulation, outlines
from ..compat import POLYGON, VECTOR_POLYGON, field
from ..parameters.values import explained
from .layers import write_layer
from .styles import FootprintOnLoad

NAME = "FIELD_OF_VIEW"


def footprint_output() -> QgsProcessingParameterDefinition:
    """Declare the field of view."""
    return explained(
        QgsProcessingParameterFeatureSink(NAME, "Field of view", VECTOR_POLYGON, None, True, True),
        "Polygons on the map: the sector that the aperture covers, and within it the ground seen, "
        "from the nearest to the farthest rock face along each azimuth.",
    )


def write_footprint(
    algorithm: QgsProcessingAlgorithm,
    simulation: Simulation,
    sight: Sight,
    aperture: Aperture,
    crs: QgsCoordinateReferenceSystem,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
) -> dict[str, str]:
    """Write the polygons; called last, see `write_layer`.

    Raises
    ------
    MuyscError
        If the layer cannot be written.
    """
    if parameters.get(NAME) is None:
        return {}
    fields = QgsFields()
    for name, kind in (
        ("part", str), ("azimuth_from", float), ("azimuth_to", float),
        ("elevation_from", float), ("elevation_to", float),
        ("distance_from_m", float), ("distance_to_m", float),
    ):  # fmt: skip
        fields.append(field(name, kind))
    half = aperture.elevation_width_deg / 2
    elevations = (sight.boresight_elevation_deg - half, sight.boresight_elevation_deg + half)
    sector, seen = outlines(simulation, sight, aperture)
    features = []
    for part, outline in (("aperture", sector), *(("ground seen", one) for one in seen)):
        feature = QgsFeature(fields)
        features.append(feature)
        feature.setGeometry(_polygon(outline, sight))
        positive = outline.distance_m[outline.distance_m > 0]
        feature.setAttributes(
            [
                part,
                float(np.min(outline.azimuth_deg)),
                float(np.max(outline.azimuth_deg)),
                *elevations,
                0.0 if part == "aperture" else float(positive.min(initial=np.inf)),
                float(outline.distance_m.max()),
            ]
        )
    write = (features, parameters, context, staging)
    identifier = write_layer(algorithm, NAME, fields, POLYGON, crs, *write)
    if context.willLoadLayerOnCompletion(identifier):
        context.layerToLoadOnCompletionDetails(identifier).setPostProcessor(FootprintOnLoad())
    return {NAME: identifier}


def _polygon(outline: Outline, sight: Sight) -> QgsGeometry:
    frame = sight.frame
    x, y = frame.dem.crs_position(*frame.ground_positions(outline.azimuth_deg, outline.distance_m))
    ring = [QgsPointXY(float(px), float(py)) for px, py in zip(x, y)]
    return QgsGeometry.fromPolygonXY([[*ring, ring[0]]])
