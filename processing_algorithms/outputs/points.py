"""Layers of points with numbers."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsFeatureSink,
    QgsFields,
    QgsGeometry,
    QgsPoint,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
)

from ...muysc_qgis.errors import MuyscError
from ..compat import POINT, POINT_Z, field


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
    has_heights: bool = False,
) -> dict[str, str]:
    """Write a layer if it is wanted; called last, because a sink cannot be staged.

    Parameters
    ----------
    algorithm, parameters, context
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

    Returns
    -------
    dict
        The layer by the name of the sink, nothing where it is not wanted.

    Raises
    ------
    MuyscError
        If the sink cannot be made.
    """
    if parameters.get(output) is None:
        return {}
    fields = QgsFields()
    for name, kind in kinds.items():
        fields.append(field(name, kind))
    kind = POINT_Z if has_heights else POINT
    sink, identifier = algorithm.parameterAsSink(parameters, output, context, fields, kind, crs)
    if sink is None:
        raise MuyscError(
            f"{output} cannot be written to “{parameters[output]}”; choose another place."
        )
    for point in points:
        feature = QgsFeature(fields)
        feature.setGeometry(QgsGeometry(QgsPoint(*point.position)))
        feature.setAttributes([_known(value) for value in point.values])
        sink.addFeature(feature, QgsFeatureSink.Flag.FastInsert)
    return {output: identifier}


def _known(value: Any) -> Any:
    return None if isinstance(value, float) and math.isnan(value) else value
