"""The dock in a window that is drawn nowhere, and a hand that uses it."""

import importlib
import time
from types import SimpleNamespace

import pytest

UTM = "EPSG:32633"


@pytest.fixture(scope="session")
def gui(provider):
    """Import modules of the desktop by their short names."""
    package = type(provider).__module__.split(".")[0]
    return lambda name: importlib.import_module(f"{package}.muysc_qgis.gui.{name}")


@pytest.fixture
def project(qgis_application):
    """The project of QGIS, empty before and after."""
    from qgis.core import QgsProject

    project = QgsProject.instance()
    project.clear()
    yield project
    project.clear()


@pytest.fixture
def iface(qgis_application, project):
    """As much of QGIS's interface as the plugin uses, around a real map."""
    from qgis.core import QgsCoordinateReferenceSystem
    from qgis.gui import QgsMapCanvas, QgsMessageBar
    from qgis.PyQt import sip
    from qgis.PyQt.QtWidgets import QMainWindow

    window, canvas, bar = QMainWindow(), QgsMapCanvas(), QgsMessageBar()
    window.setCentralWidget(canvas)
    # The tests look at what stands on the map, not at its picture.
    canvas.setRenderFlag(False)
    window.resize(1200, 900)
    project.setCrs(QgsCoordinateReferenceSystem(UTM))
    canvas.setDestinationCrs(project.crs())
    toolbar = window.addToolBar("plugins")
    menu = []
    yield SimpleNamespace(
        mainWindow=lambda: window,
        mapCanvas=lambda: canvas,
        messageBar=lambda: bar,
        addToolBarIcon=toolbar.addAction,
        removeToolBarIcon=toolbar.removeAction,
        addPluginToMenu=lambda name, action: menu.append(action),
        removePluginMenu=lambda name, action: menu.remove(action),
        addTabifiedDockWidget=lambda area, dock, *beside: window.addDockWidget(area, dock),
        removeDockWidget=window.removeDockWidget,
        toolbar=toolbar,
        menu=menu,
    )
    # At once: Python might clean them up later, in a thread that must not.
    sip.delete(bar)
    sip.delete(window)


@pytest.fixture
def desktop(gui, iface):
    iface.mainWindow().show()
    desktop = gui("desktop").Desktop(iface)
    yield desktop
    desktop.remove()


@pytest.fixture
def dock(desktop):
    desktop.action.setChecked(True)
    return desktop.dock


@pytest.fixture
def terrain(project, iface, data_folder):
    """Vesuvius, in degrees, shown on the map."""
    from qgis.core import QgsCoordinateTransform, QgsRasterLayer

    layer = QgsRasterLayer(str(data_folder / "vesuvius_srtmgl1.tif"), "Vesuvius")
    project.addMapLayer(layer)
    canvas = iface.mapCanvas()
    canvas.setLayers([layer])
    to_map = QgsCoordinateTransform(layer.crs(), project.crs(), project)
    canvas.setExtent(to_map.transformBoundingBox(layer.extent()))
    return layer


class Hand:
    """Uses a dock and its map as a user does."""

    #: Longitude and latitude.
    detector, target = (14.410686, 40.810561), (14.424745, 40.823729)

    def __init__(self, dock, canvas):
        self.dock, self.canvas = dock, canvas

    def wait(self, until):
        from qgis.PyQt.QtTest import QTest

        end = time.monotonic() + 20
        while not until():
            assert time.monotonic() < end, "nothing happened"
            QTest.qWait(2)

    def settle(self):
        self.wait(lambda: not self.dock.planner.busy and not self.dock.sites.comparison.busy)

    def dot(self, longitude, latitude):
        """Return where a place is shown, in dots of the map."""
        from qgis.core import (
            QgsCoordinateReferenceSystem,
            QgsCoordinateTransform,
            QgsPointXY,
            QgsProject,
        )

        to_map = QgsCoordinateTransform(
            QgsCoordinateReferenceSystem("EPSG:4326"),
            self.canvas.mapSettings().destinationCrs(),
            QgsProject.instance(),
        )
        point = to_map.transform(QgsPointXY(longitude, latitude))
        return self.canvas.getCoordinateTransform().transform(point).toQPointF().toPoint()

    def click(self, longitude, latitude):
        from qgis.PyQt.QtCore import Qt
        from qgis.PyQt.QtTest import QTest

        QTest.mouseClick(
            self.canvas.viewport(),
            Qt.MouseButton.LeftButton,
            Qt.KeyboardModifier.NoModifier,
            self.dot(longitude, latitude),
        )

    def drag(self, start, dots):
        """Press at a place, move by so many dots to the right, one by one; do not let go."""
        from qgis.PyQt.QtCore import QEvent, QPoint, QPointF, Qt
        from qgis.PyQt.QtGui import QMouseEvent
        from qgis.PyQt.QtTest import QTest
        from qgis.PyQt.QtWidgets import QApplication

        left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
        first = self.dot(*start)
        QTest.mousePress(self.canvas.viewport(), left, none, first)
        for step in range(1, dots + 1):
            position = QPointF(first + QPoint(step, 0))
            move = QMouseEvent(
                QEvent.Type.MouseMove, position, position, Qt.MouseButton.NoButton, left, none
            )
            QApplication.sendEvent(self.canvas.viewport(), move)
        return first + QPoint(dots, 0)

    def release(self, dot):
        from qgis.PyQt.QtCore import Qt
        from qgis.PyQt.QtTest import QTest

        QTest.mouseRelease(
            self.canvas.viewport(),
            Qt.MouseButton.LeftButton,
            Qt.KeyboardModifier.NoModifier,
            dot,
        )

    def take(self, role):
        """Press the button of a map tool unless it is pressed."""
        button = getattr(self.dock.form, f"pick_{role}")
        if not button.isChecked():
            button.click()

    def two_clicks(self):
        self.take("detector")
        self.click(*self.detector)
        self.take("target")
        self.click(*self.target)
        self.settle()

    def pixel_event(self, row, column):
        """Return where the muogram shows a pixel."""
        view = self.dock.muogram.view
        view.grab()  # it is laid out when it is painted
        return view.place_of(row, column)


@pytest.fixture
def hand(dock, iface):
    return Hand(dock, iface.mapCanvas())


@pytest.fixture
def planned(dock, terrain, hand):
    """A dock with terrain, detector, target and muogram."""
    dock.form.dem.setLayer(terrain)
    hand.two_clicks()
    return dock
