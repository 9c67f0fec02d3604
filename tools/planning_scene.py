"""Uses the planning dock as a user does: clicks on the map and on the muogram.

For the tests of the dock, and for pictures of it.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsPointXY,
    QgsProject,
)
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QEvent, QPoint, QPointF, Qt
from qgis.PyQt.QtGui import QMouseEvent
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QWidget

#: Longitude and latitude of Casina Amelia and of the summit of Vesuvius.
DETECTOR, TARGET = (14.410686, 40.810561), (14.424745, 40.823729)

_LEFT, _NO_BUTTON = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
_NO_KEY = Qt.KeyboardModifier.NoModifier
_SECONDS = 20


class Hand:
    """Uses a dock and its map."""

    def __init__(self, dock: Any, canvas: QgsMapCanvas) -> None:
        self.dock, self.canvas = dock, canvas
        self.detector, self.target = DETECTOR, TARGET

    def wait(self, until: Callable[[], bool]) -> None:
        """Let QGIS work until something is so."""
        end = time.monotonic() + _SECONDS
        while not until():
            if time.monotonic() > end:
                raise TimeoutError("nothing happened")
            QTest.qWait(2)

    def settle(self) -> None:
        """Wait for the muogram and for the figures of all sites."""
        self.wait(lambda: not self.dock.planner.busy and not self.dock.sites.comparison.busy)

    def dot(self, longitude: float, latitude: float) -> QPoint:
        """Return where a place is shown, in dots of the map."""
        to_map = QgsCoordinateTransform(
            QgsCoordinateReferenceSystem("EPSG:4326"),
            self.canvas.mapSettings().destinationCrs(),
            QgsProject.instance(),
        )
        point = to_map.transform(QgsPointXY(longitude, latitude))
        return self.canvas.getCoordinateTransform().transform(point).toQPointF().toPoint()

    def take(self, role: str) -> None:
        """Press the button of a map tool unless it is pressed."""
        button = getattr(self.dock.form, f"pick_{role}")
        if not button.isChecked():
            button.click()

    def click(self, longitude: float, latitude: float) -> None:
        """Click on a place."""
        QTest.mouseClick(self.canvas.viewport(), _LEFT, _NO_KEY, self.dot(longitude, latitude))

    def two_clicks(self) -> None:
        """Pick detector and target, and wait for the muogram."""
        self.take("detector")
        self.click(*self.detector)
        self.take("target")
        self.click(*self.target)
        self.settle()

    def drag(self, start: tuple[float, float], dots: int) -> QPoint:
        """Press at a place and move to the right, dot by dot; return where, without letting go."""
        first = self.dot(*start)
        QTest.mousePress(self.canvas.viewport(), _LEFT, _NO_KEY, first)
        for step in range(1, dots + 1):
            _move(self.canvas.viewport(), QPointF(first + QPoint(step, 0)), _LEFT)
        return first + QPoint(dots, 0)

    def release(self, dot: QPoint) -> None:
        """Let go on the map."""
        QTest.mouseRelease(self.canvas.viewport(), _LEFT, _NO_KEY, dot)

    def place_of(self, row: int, column: int) -> QPointF:
        """Return where the muogram shows a pixel."""
        view = self.dock.muogram.view
        view.grab()  # it is laid out when it is painted
        return view.place_of(row, column)

    def hover(self, row: int, column: int) -> None:
        """Move over a pixel of the muogram."""
        self.move(self.place_of(row, column))

    def move(self, place: QPointF) -> None:
        """Move over a place of the muogram's widget."""
        _move(self.dock.muogram.view, place, _NO_BUTTON)
        QTest.qWait(5)

    def open_section(self, row: int, column: int) -> Any:
        """Click on a pixel of the muogram; return the window of the section."""
        place = self.place_of(row, column).toPoint()
        QTest.mouseClick(self.dock.muogram.view, _LEFT, _NO_KEY, place)
        window = self.dock.muogram.section
        self.wait(lambda: not window.busy)
        return window


def _move(widget: QWidget, place: QPointF, buttons: Qt.MouseButton) -> None:
    event = QMouseEvent(QEvent.Type.MouseMove, place, place, _NO_BUTTON, buttons, _NO_KEY)
    QApplication.sendEvent(widget, event)
