"""How well terrain and pointing are known, as parameters."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
)

from ...muysc_qgis.topography.terrain_error import TerrainErrors
from .values import number, read_number


def terrain_error_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare the errors of terrain and pointing, and how far those of the terrain are alike.

    Optional, so that models from before they were there stay complete.
    """
    declared = [
        number(
            "TERRAIN_ERROR", "Error of the terrain (m)",
            "Give the standard error of the terrain's heights on the mountain in m, 0 to 1000: "
            "1.48 times the median of their deviations from a better model. Only for "
            "THICKNESS_ERROR.",
            5.0, 0, 1000, advanced=True,
        ),
        number(
            "TERRAIN_CORRELATION", "Terrain errors are alike within (m)",
            "Give the distance in m within which heights of the terrain are wrong alike, 0 to "
            "100000. Over wider trajectories their errors average out, and nearer to the detector "
            "they make no difference. Only for THICKNESS_ERROR.",
            100.0, 0, 100_000, advanced=True,
        ),
        number(
            "POINTING_ERROR", "Error of the pointing (°)",
            "Give the standard error of the elevation angle that the telescope points at in "
            "degrees, 0 to 30. Only for THICKNESS_ERROR.",
            0.0, 0, 30, advanced=True,
        ),
    ]  # fmt: skip
    optional = QgsProcessingParameterDefinition.Flag.FlagOptional
    for parameter in declared:
        parameter.setFlags(parameter.flags() | optional)
    return declared


def read_terrain_errors(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> TerrainErrors:
    """Return how well terrain and pointing are known.

    Raises
    ------
    MuyscError
        If a number is out of range.
    """
    read = (algorithm, parameters)
    return TerrainErrors(
        read_number(*read, "TERRAIN_ERROR", context),
        read_number(*read, "POINTING_ERROR", context),
        read_number(*read, "TERRAIN_CORRELATION", context),
    )
