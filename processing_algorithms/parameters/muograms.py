"""Muograms as parameters."""

from __future__ import annotations

from typing import Any

from qgis.core import QgsProcessingAlgorithm, QgsProcessingContext

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.muogram import Muogram, read_muogram
from ...muysc_qgis.trajectories import read_view
from ...muysc_qgis.views import View
from .terrain import raster_layer
from .values import given


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
    layer = algorithm.parameterAsRasterLayer(parameters, name, context)
    if (layer is None or not layer.isValid()) and isinstance(value, str):
        # Opening it again will tell why QGIS could not.
        return value
    return raster_layer(algorithm, parameters, name, context).source()
