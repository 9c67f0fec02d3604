"""An extent in any coordinate reference system, as longitudes and latitudes."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.topography.srtm import Extent
from .values import given

_WGS84 = "EPSG:4326"


def read_extent(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> tuple[Extent, tuple[str, ...]]:
    """Return an extent, and what had to be assumed about it.

    Raises
    ------
    MuyscError
        If there is none, or it cannot be transformed.
    """
    if not given(parameters, name):
        raise MuyscError(f"{name} is missing; give xmin,xmax,ymin,ymax [EPSG:code].")
    rectangle = algorithm.parameterAsExtent(parameters, name, context)
    if rectangle.isNull():
        raise MuyscError(
            f"{name} is “{parameters[name]}”, which is no extent; write xmin,xmax,ymin,ymax "
            "[EPSG:code], or choose a layer."
        )
    crs = algorithm.parameterAsExtentCrs(parameters, name, context)
    degrees = QgsCoordinateReferenceSystem(_WGS84)
    notes: tuple[str, ...] = ()
    if not crs.isValid():
        crs = degrees
        notes = (f"{name} names no coordinate reference system; {_WGS84} is assumed.",)
    transform = QgsCoordinateTransform(crs, degrees, context.transformContext())
    try:
        box = transform.transformBoundingBox(rectangle, handle180Crossover=True)
    except QgsCsException as error:
        raise MuyscError(
            f"{name} cannot be transformed from {crs.authid() or 'its own system'} to longitudes "
            "and latitudes; check that its coordinates are of that system."
        ) from error
    west, east = box.xMinimum(), box.xMaximum()
    # So QGIS tells that the box goes across the antimeridian.
    if west > east:
        east += 360
    return Extent(west, box.yMinimum(), east, box.yMaximum()), notes
