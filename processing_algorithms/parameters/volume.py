"""Parameters of the voxels that a tomography fills."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterCrs,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterExtent,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.workflows.volume_frame import chosen_projection
from ...muysc_qgis.workflows.volume_plan import VOXELS, VolumePlan
from .values import explained, given, number, read_count, read_number, read_optional, switch

if TYPE_CHECKING:
    from pyproj import CRS

#: GiB that the path matrix may take unless the user says otherwise.
_MEMORY_GIB = 4.0


def volume_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare the extent, heights and size of the voxels."""
    return [
        explained(
            QgsProcessingParameterExtent("EXTENT", "Extent of the volume (empty: where the "
                                         "muograms look)", None, True),
            "Rectangle on the map, as text xmin,xmax,ymin,ymax [EPSG:code], on the elevation "
            "model. Empty takes the rectangle with nine tenths of the rock on the rays.",
        ),
        number(
            "VOXEL_SIZE", "Voxel size (m, empty: by the number of voxels)",
            "Give the edge of a voxel in m, above 0.",
            None, 0,
        ),
        number(
            "VOXELS", "Voxels along the longest side",
            "Give the number of voxels along the longest side of the volume, 1 to 1000. It counts "
            "where no voxel size is given, which is then rounded up.",
            VOXELS, 1, 1000, whole=True,
        ),
        number(
            "BASE", "Base of the volume (m, empty: the lowest rays)",
            "Give the height of the volume's floor in m above sea level, below its top. Empty "
            "takes where all but the lowest 2 % of the rock on the rays is above it.",
            None, -12_000, 12_000,
        ),
        number(
            "TOP", "Top of the volume (m, empty: the highest ground)",
            "Give the height of the volume's ceiling in m above sea level, above its base.",
            None, -12_000, 12_000,
        ),
        explained(
            QgsProcessingParameterCrs("CRS", "Coordinate reference system (empty: the elevation "
                                      "model's or UTM)", None, True),
            "Projected coordinate reference system of the volume, true to scale there. Empty takes "
            "that of the elevation model if it is one in metres, else the UTM zone.",
            advanced=True,
        ),
        switch(
            "TERRAIN_MASK", "Voxels of air are known",
            "Whether rock ends at the terrain. If not, all voxels are unknown and the rays of the "
            "sky count too: the shape of the mountain is reconstructed with its density.",
            True, advanced=True,
        ),
        number(
            "MEMORY", "Memory (GiB)",
            "Give the most memory in GiB for the paths of the rays, above 0. Where they need more, "
            "they are computed anew at every step, which is slow.",
            _MEMORY_GIB, 0, 10_000, advanced=True,
        ),
    ]  # fmt: skip


def read_crs(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> CRS | None:
    """Return the projection asked for, None where there is none.

    Raises
    ------
    MuyscError
        If it is no projected coordinate reference system in metres.
    """
    if not given(parameters, "CRS"):
        return None
    asked: QgsCoordinateReferenceSystem = algorithm.parameterAsCrs(parameters, "CRS", context)
    if not asked.isValid():
        raise MuyscError(
            f"CRS is “{parameters['CRS']}”, which is no coordinate reference system; write "
            "EPSG:code, or leave it empty."
        )
    return chosen_projection(
        asked.toWkt(QgsCoordinateReferenceSystem.WktVariant.WKT2_2018), asked.authid()
    )


def read_plan(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    crs: CRS,
) -> VolumePlan:
    """Return what is asked of the volume, its extent in the CRS of the volume.

    Raises
    ------
    MuyscError
        If a value cannot be used.
    """
    read = (algorithm, parameters)
    return VolumePlan(
        _extent(algorithm, parameters, context, crs),
        read_optional(*read, "VOXEL_SIZE", context),
        read_count(*read, "VOXELS", context),
        read_optional(*read, "BASE", context),
        read_optional(*read, "TOP", context),
    )


def read_memory(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> int:
    """Return the memory for the paths in bytes."""
    return int(read_number(algorithm, parameters, "MEMORY", context) * 2**30)


def _extent(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    crs: CRS,
) -> tuple[float, float, float, float] | None:
    if not given(parameters, "EXTENT"):
        return None
    target = QgsCoordinateReferenceSystem.fromWkt(crs.to_wkt())
    box = algorithm.parameterAsExtent(parameters, "EXTENT", context, target)
    if box.isNull() or box.isEmpty():
        raise MuyscError(
            f"EXTENT is “{parameters['EXTENT']}”, which is no rectangle with an area; write "
            "xmin,xmax,ymin,ymax [EPSG:code], or leave it empty."
        )
    return box.xMinimum(), box.xMaximum(), box.yMinimum(), box.yMaximum()
