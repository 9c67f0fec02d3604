"""The dock in a window that is drawn nowhere, and a hand that uses it."""

import importlib
from types import SimpleNamespace

import pytest

from tools.planning_scene import Hand

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


@pytest.fixture
def hand(dock, iface):
    return Hand(dock, iface.mapCanvas())


@pytest.fixture
def planned(dock, terrain, hand):
    """A dock with terrain, detector, target and muogram."""
    dock.form.dem.setLayer(terrain)
    hand.two_clicks()
    return dock
