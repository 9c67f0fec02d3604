"""Layers of points with numbers."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsFields,
    QgsGeometry,
    QgsPoint,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
)

from ...muysc_qgis.staging import Staging
from ..compat import POINT, POINT_Z, field
from .layers import write_layer
from .styles import SitesOnLoad


@dataclass(frozen=True)
class Point:
    """A place and what is known of it, in the order of the fields."""

    #: x and y, and the height where the layer has heights.
    position: tuple[float, ...]
    values: tuple[Any, ...]


def write_points(
    algorithm: QgsProcessingAlgorithm,
    output: str,
    kinds: Mapping[str, type],
    points: Iterable[Point],
    crs: QgsCoordinateReferenceSystem,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
    has_heights: bool = False,
    sites: str | None = None,
) -> dict[str, str]:
    """Write a layer if it is wanted; called last, see `write_layer`.

    Parameters
    ----------
    algorithm, parameters, context, staging
        Of the run.
    output
        Name of the sink.
    kinds
        Python type by field; a number that is NaN is written as empty.
    points
        What to write.
    crs
        Of the positions.
    has_heights
        Whether the points have heights.
    sites
        Kind of site that they are, see `SitesOnLoad`, None for other points.

    Returns
    -------
    dict
        The layer by the name of the sink, nothing where it is not wanted.

    Raises
    ------
    MuyscError
        If the layer cannot be written.
    """
    if parameters.get(output) is None:
        return {}
    fields = QgsFields()
    for name, type_ in kinds.items():
        fields.append(field(name, type_))
    kind = POINT_Z if has_heights else POINT
    features = (_feature(point, fields) for point in points)
    write = (features, parameters, context, staging)
    identifier = write_layer(algorithm, output, fields, kind, crs, *write)
    if sites is not None and context.willLoadLayerOnCompletion(identifier):
        details = context.layerToLoadOnCompletionDetails(identifier)
        details.setPostProcessor(SitesOnLoad(sites))
    return {output: identifier}


def _feature(point: Point, fields: QgsFields) -> QgsFeature:
    feature = QgsFeature(fields)
    feature.setGeometry(QgsGeometry(QgsPoint(*point.position)))
    feature.setAttributes([_known(value) for value in point.values])
    return feature


def _known(value: Any) -> Any:
    return None if isinstance(value, float) and math.isnan(value) else value
