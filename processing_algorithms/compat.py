"""The few places where QGIS 3.22 and QGIS 4 name things differently."""

from __future__ import annotations

from qgis.core import (
    Qgis,
    QgsField,
    QgsProcessing,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterField,
    QgsWkbTypes,
)

ADVANCED = QgsProcessingParameterDefinition.Flag.FlagAdvanced
RASTERS = QgsProcessing.SourceType.TypeRaster
VECTOR_POINT = QgsProcessing.SourceType.TypeVectorPoint
VECTOR_LINE = QgsProcessing.SourceType.TypeVectorLine
VECTOR = QgsProcessing.SourceType.TypeVector
VECTOR_POLYGON = QgsProcessing.SourceType.TypeVectorPolygon
NUMERIC_FIELD = QgsProcessingParameterField.DataType.Numeric
POINT = QgsWkbTypes.Type.Point
POINT_Z = QgsWkbTypes.Type.PointZ
POLYGON = QgsWkbTypes.Type.Polygon

if Qgis.QGIS_VERSION_INT >= 33800:
    from qgis.PyQt.QtCore import QMetaType

    _TYPES = {float: QMetaType.Type.Double, int: QMetaType.Type.Int, str: QMetaType.Type.QString}
else:
    from qgis.PyQt.QtCore import QVariant

    _TYPES = {float: QVariant.Double, int: QVariant.Int, str: QVariant.String}


def field(name: str, kind: type) -> QgsField:
    """Return an attribute field for a Python type."""
    return QgsField(name, _TYPES[kind])
