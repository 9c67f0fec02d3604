"""Muograms as parameters."""

from __future__ import annotations

from typing import Any

from qgis.core import QgsProcessingAlgorithm, QgsProcessingContext

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.muogram import Muogram, read_muogram
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
    if not given(parameters, name):
        raise MuyscError(f"{name} is missing; choose a muogram.")
    layer = algorithm.parameterAsRasterLayer(parameters, name, context)
    if (layer is None or not layer.isValid()) and isinstance(parameters[name], str):
        # Opening it again tells why QGIS could not.
        return read_muogram(parameters[name]), parameters[name]
    path = raster_layer(algorithm, parameters, name, context).source()
    return read_muogram(path), path
