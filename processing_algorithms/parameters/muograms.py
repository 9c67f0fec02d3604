"""Muograms as parameters."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsMapLayer,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterMultipleLayers,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.geotiff import is_endless
from ...muysc_qgis.muogram import Muogram, read_muogram
from ...muysc_qgis.trajectories import read_view
from ...muysc_qgis.views import View
from ..compat import RASTERS
from .terrain import opened_layer, raster_layer
from .values import explained, given


def read_muogram_layer(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> tuple[Muogram, str]:
    """Return a muogram and its file.

    Raises
    ------
    MuyscError
        If there is none, or the raster is no muogram.
    """
    path = _path(algorithm, parameters, name, context)
    return read_muogram(path), path


def read_view_layer(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> tuple[View, str]:
    """Return a muogram or a raster in telescope angles, and its file.

    Raises
    ------
    MuyscError
        If there is none, or the raster is neither.
    """
    path = _path(algorithm, parameters, name, context)
    return read_view(path), path


def _path(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> str:
    if not given(parameters, name):
        raise MuyscError(f"{name} is missing; choose a muogram.")
    value = parameters[name]
    if opened_layer(algorithm, parameters, name, context) is None and isinstance(value, str):
        # Opening it again will tell why QGIS could not.
        return value
    return raster_layer(algorithm, parameters, name, context).source()


def muogram_layers(
    name: str, label: str, text: str, optional: bool = False
) -> QgsProcessingParameterDefinition:
    """Declare several muograms."""
    return explained(
        QgsProcessingParameterMultipleLayers(name, label, RASTERS, None, optional), text
    )


def read_view_layers(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> list[tuple[View, str]]:
    """Return several muograms or rasters in telescope angles with their files; none where empty.

    Raises
    ------
    MuyscError
        If a raster is neither.
    """
    if not given(parameters, name):
        return []
    value = parameters[name]
    asked = value if isinstance(value, list) else [value]
    try:
        endless = any(isinstance(one, str) and is_endless(one) for one in asked)
        layers = [] if endless else algorithm.parameterAsLayerList(parameters, name, context)
    except Exception:
        # So a damaged file shows that fails deep inside QGIS.
        layers = []
    paths = [layer.source() for layer in layers]
    if len(paths) < len(asked):
        # Opening them again will tell why QGIS could not.
        paths = [one.source() if isinstance(one, QgsMapLayer) else str(one) for one in asked]
    return [(read_view(path), path) for path in paths]
