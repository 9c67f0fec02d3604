"""Picking and dragging detector and target on the map."""

from __future__ import annotations

from qgis.core import QgsPointXY
from qgis.gui import QgsMapCanvas, QgsMapMouseEvent, QgsMapTool, QgsSnapIndicator
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtGui import QKeyEvent

from .map_items import MapItems

#: How near to a marker (dots) a press takes hold of it.
_NEAR = 12


class PlaceTool(QgsMapTool):
    """Sets detector or target by a click, or drags whichever marker is pressed.

    Points snap as the project's snapping options say.
    """

    #: “detector” or “target”, the point on the map, and whether the mouse is still down.
    moved = pyqtSignal(str, QgsPointXY, bool)

    def __init__(self, canvas: QgsMapCanvas, role: str, items: MapItems) -> None:
        super().__init__(canvas)
        self.role = role
        self._items = items
        self._held: str | None = None
        self._snap = QgsSnapIndicator(canvas)
        self.setCursor(Qt.CursorShape.CrossCursor)

    def release(self) -> None:
        """Leave nothing on the canvas."""
        del self._snap
        self.deleteLater()

    # What QGIS asks for.

    def canvasPressEvent(self, event: QgsMapMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        tolerance = _NEAR * self.canvas().mapUnitsPerPixel()
        self._held = self._items.marker_at(event.originalMapPoint(), tolerance) or self.role

    def canvasMoveEvent(self, event: QgsMapMouseEvent) -> None:
        point = event.snapPoint()
        self._snap.setMatch(event.mapPointMatch())
        if self._held is not None:
            self.moved.emit(self._held, point, True)

    def canvasReleaseEvent(self, event: QgsMapMouseEvent) -> None:
        if self._held is None or event.button() != Qt.MouseButton.LeftButton:
            return
        role, self._held = self._held, None
        self.moved.emit(role, event.snapPoint(), False)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            event.accept()
            self.canvas().unsetMapTool(self)

    def deactivate(self) -> None:
        self._held = None
        self._snap.setVisible(False)
        super().deactivate()
