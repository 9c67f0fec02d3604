"""The few places where Qt 5 and Qt 6, and versions of QGIS, name things differently."""

from __future__ import annotations

from qgis.core import QgsMapLayerProxyModel, QgsWkbTypes
from qgis.PyQt.QtCore import QPointF
from qgis.PyQt.QtGui import QMouseEvent

try:
    from qgis.PyQt.QtGui import QAction
except ImportError:  # Qt 5
    from qgis.PyQt.QtWidgets import QAction

__all__ = ["LINES", "POLYGONS", "RASTER_LAYERS", "QAction", "position_of"]

RASTER_LAYERS = QgsMapLayerProxyModel.Filter.RasterLayer
POLYGONS = QgsWkbTypes.GeometryType.PolygonGeometry
LINES = QgsWkbTypes.GeometryType.LineGeometry


def position_of(event: QMouseEvent) -> QPointF:
    """Return where in a widget the mouse is."""
    return event.position() if hasattr(event, "position") else QPointF(event.pos())
