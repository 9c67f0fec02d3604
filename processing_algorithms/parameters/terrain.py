"""The DEM parameter, shared by every algorithm that needs terrain."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterBand,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterRasterLayer,
    QgsRasterLayer,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.geotiff import is_endless
from ...muysc_qgis.topography.dem import Dem, open_dem
from ...muysc_qgis.topography.heights import UNITS
from .transformation import with_transformation
from .values import choice, explained, read_choice, read_count


def dem_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare the DEM, its band and the unit of its heights."""
    return [
        explained(
            QgsProcessingParameterRasterLayer("DEM", "Elevation model (DEM)"),
            "Raster of terrain heights, in any coordinate reference system. It must hold the "
            "detector, the target and all rock behind it. Cells without data count as unknown.",
        ),
        explained(
            QgsProcessingParameterBand("BAND", "Band of the heights", 1, "DEM", True),
            "Number of the raster band that holds the heights, from 1.",
        ),
        choice(
            "HEIGHT_UNIT", "Unit of the heights",
            "auto takes the unit that the raster states, and metres where it states none.",
            ["auto", *UNITS], "auto", advanced=True,
        ),
    ]  # fmt: skip


def read_dem(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> tuple[Dem, QgsRasterLayer]:
    """Return the DEM, with the transformation of the project, and its layer.

    Raises
    ------
    MuyscError
        If there is no layer, or it is no elevation raster.
    """
    layer = raster_layer(algorithm, parameters, "DEM", context)
    crs = layer.crs()
    # The user may have corrected the CRS of the layer, which the file cannot know.
    own = layer.dataProvider().crs()
    override = crs.toWkt() if crs.isValid() and crs != own else None
    dem = open_dem(
        layer.source(),
        read_count(algorithm, parameters, "BAND", context),
        override,
        read_choice(algorithm, parameters, "HEIGHT_UNIT", context),
    )
    return with_transformation(dem, crs, context), layer


def raster_layer(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> QgsRasterLayer:
    """Return a raster layer that GDAL can read.

    Raises
    ------
    MuyscError
        If there is none.
    """
    layer = opened_layer(algorithm, parameters, name, context)
    if layer is None:
        value = parameters.get(name)
        if isinstance(value, str) and value:
            # Opening it again tells why QGIS could not.
            open_dem(value)
            raise MuyscError(f"{name} “{value}” is no raster; choose a raster layer or file.")
        raise MuyscError(f"{name} is missing; choose a raster layer or file.")
    if layer.dataProvider().name() != "gdal":
        raise MuyscError(
            f"{name} “{layer.name()}” comes from a {layer.dataProvider().name()} service, whose "
            "values cannot be read exactly; save it as GeoTIFF and choose that."
        )
    return layer


def opened_layer(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> QgsRasterLayer | None:
    """Return a raster layer, None where QGIS cannot open it."""
    value = parameters.get(name)
    if isinstance(value, str) and is_endless(value):
        return None
    try:
        layer = algorithm.parameterAsRasterLayer(parameters, name, context)
    except Exception:
        # So a damaged file shows that fails deep inside QGIS.
        return None
    return layer if layer is not None and layer.isValid() else None
