"""Terrain that may be given, and where on it was measured."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterPoint,
    QgsProcessingParameterRasterLayer,
)

from ...muysc_qgis.workflows.view_rays import Ground
from .terrain import dem_parameters, read_dem
from .values import explained, given, number, read_optional
from .view import read_point


def ground_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare the DEM, and the detector where the muogram does not say it."""
    _, *others = dem_parameters()
    return [
        explained(
            QgsProcessingParameterRasterLayer("DEM", "Elevation model (DEM)", None, True),
            "Raster of terrain heights. Each pixel is then seen through it with all its rays, rock "
            "and sky at the skyline alike, and the thickness is not needed.",
        ),
        *others,
        explained(
            QgsProcessingParameterPoint(
                "DETECTOR", "Detector (empty: as the muogram says)", None, True
            ),
            "Where the muons were counted, on the DEM. As text: x,y [EPSG:code]. Empty takes "
            "DETECTOR_LON and DETECTOR_LAT from the metadata of the measured muogram.",
        ),
        number(
            "DETECTOR_HEIGHT", "Detector height above ground (m, empty: as the muogram says)",
            "Give the height of the telescope above the ground of the DEM in m, −10000 to 10000. "
            "Empty takes what the muogram says: its height above ground, else its elevation.",
            None, -10_000, 10_000,
        ),
    ]  # fmt: skip


def read_ground(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> tuple[Ground | None, list[str]]:
    """Return the terrain, None where there is none, and what had to be assumed for it.

    Raises
    ------
    MuyscError
        If the DEM or the point cannot be used.
    """
    if not given(parameters, "DEM"):
        return None, []
    dem, layer = read_dem(algorithm, parameters, context)
    point, notes = None, []
    if given(parameters, "DETECTOR"):
        point, notes = read_point(algorithm, parameters, "DETECTOR", context, dem, layer)
    height = read_optional(algorithm, parameters, "DETECTOR_HEIGHT", context)
    return Ground(dem, point, height), notes
