"""A vertical section through a volume along a line on the map."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsFeature,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFileDestination,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.topography.dem import Dem
from ...muysc_qgis.workflows.tomography_result import Tomography
from ..compat import VECTOR_LINE
from ..parameters.values import explained, given

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LINE, SECTION = "SECTION_LINE", "SECTION"

#: Corners of a line in the CRS of the volume.
Line = Sequence[tuple[float, float]]


def section_line() -> QgsProcessingParameterDefinition:
    """Declare the line."""
    return explained(
        QgsProcessingParameterFeatureSource(
            LINE, "Line of a vertical section", [VECTOR_LINE], None, True
        ),
        "Layer whose first line says where the vertical section runs; in any coordinate reference "
        "system.",
    )


def section_output() -> QgsProcessingParameterDefinition:
    """Declare the picture."""
    return explained(
        QgsProcessingParameterFileDestination(
            SECTION, "Vertical section", "PNG pictures (*.png)", None, True, False
        ),
        "Picture of the densities below the line, with the ground.",
    )


def read_line(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    wkt: str,
) -> Line | None:
    """Return the line in a coordinate reference system, None where there is none.

    Raises
    ------
    MuyscError
        If the layer has no line, or a section is wanted without one.
    """
    if not given(parameters, LINE):
        if given(parameters, SECTION):
            raise MuyscError(
                f"{SECTION} is asked for without {LINE}; choose a layer with a line to run along."
            )
        return None
    source = algorithm.parameterAsSource(parameters, LINE, context)
    if source is None:
        raise MuyscError(f"{LINE} is “{parameters[LINE]}”, which is no layer of lines; choose one.")
    feature = QgsFeature()
    if not source.getFeatures().nextFeature(feature) or feature.geometry().isEmpty():
        raise MuyscError(f"{LINE} holds no line; draw one across the volume.")
    geometry = feature.geometry()
    target = QgsCoordinateReferenceSystem.fromWkt(wkt)
    try:
        geometry.transform(
            QgsCoordinateTransform(source.sourceCrs(), target, context.transformContext())
        )
    except QgsCsException as error:
        raise MuyscError(
            f"{LINE} cannot be transformed from {source.sourceCrs().authid()} to the projection of "
            "the volume; check that its coordinates are of that system."
        ) from error
    points = [(vertex.x(), vertex.y()) for vertex in geometry.vertices()]
    if len(points) < 2 or geometry.length() == 0:
        raise MuyscError(f"{LINE} holds a line without a length; draw one across the volume.")
    return points


def section_pictures(
    result: Tomography, dem: Dem, line: Line | None
) -> dict[str, Callable[[], Figure]]:
    """Return what draws the section by output name, nothing without a line."""
    if line is None:
        return {}

    def section() -> Figure:
        from ...muysc_qgis.plots.tomography.documents import terrain
        from ...muysc_qgis.plots.tomography.section_picture import section_figure

        return section_figure(result, line, terrain(result, dem))

    return {SECTION: section}
