"""What QGIS does for the pictures of the guide; a start-up script of QGIS."""

from __future__ import annotations

import os
import sys
import tempfile
import traceback
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path

import processing
from muysc.muysc_qgis.gui.compat import QAction
from muysc.processing_algorithms.outputs.styles import FootprintOnLoad
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsProject,
    QgsRasterLayer,
    QgsRectangle,
)
from qgis.PyQt.QtCore import Qt, QTimer
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QDockWidget, QTreeView, QWidget
from qgis.utils import iface, plugins

sys.path.insert(0, os.environ["MUYSC_TOOLS"])
import demo
import open_vesuvius  # fills the project
from planning_scene import Hand

IMAGES = Path(os.environ["MUYSC_IMAGES"])
SIZE = (1500, 940)
RADIOGRAPHY, SURVEY = "muysc:radiography", "muysc:volcanosurvey"
#: A pixel of the muogram, below the summit.
ROW, COLUMN = 45, 50
#: A second place for the telescope, east of the mountain.
ELSEWHERE = (14.4405, 40.8135)


def save(name: str, widget: QWidget) -> None:
    """Write what a widget shows."""
    QTest.qWait(400)
    widget.grab().save(str(IMAGES / f"{name}.png"))


def window() -> QWidget:
    """Return the window of QGIS."""
    return iface.mainWindow()


def wait_for_map() -> None:
    """Let the map be drawn."""
    canvas = iface.mapCanvas()
    canvas.refresh()
    QTest.qWait(300)
    while canvas.isDrawing():
        QTest.qWait(50)
    QTest.qWait(300)


def arrange() -> None:
    """Give the window its size and hide what the pictures do not need."""
    window().showNormal()
    window().resize(*SIZE)
    for name in ("Browser", "Browser2", "LayerStyling", "PythonConsole"):
        dock = window().findChild(QDockWidget, name)
        if dock is not None:
            dock.hide()
    iface.messageBar().clearWidgets()
    QTest.qWait(500)


def zoom_to(west: float, south: float, east: float, north: float) -> None:
    """Show a part of the map, in degrees."""
    to_map = QgsCoordinateTransform(
        QgsCoordinateReferenceSystem("EPSG:4326"),
        QgsProject.instance().crs(),
        QgsProject.instance(),
    )
    iface.mapCanvas().setExtent(to_map.transformBoundingBox(QgsRectangle(west, south, east, north)))
    wait_for_map()


def plan() -> Hand:
    """Open the dock, and pick detector and target on the map."""
    for node in QgsProject.instance().layerTreeRoot().findLayers():
        if node.name() == "Telescope":
            node.setItemVisibilityChecked(False)  # the dock marks both places itself
    desktop = plugins["muysc"].desktop
    desktop.action.setChecked(True)
    window().resizeDocks([desktop.dock], [430], Qt.Orientation.Horizontal)
    QTest.qWait(500)
    zoom_to(14.392, 40.798, 14.455, 40.845)
    hand = Hand(desktop.dock, iface.mapCanvas())
    dem = next(
        layer
        for layer in QgsProject.instance().mapLayers().values()
        if isinstance(layer, QgsRasterLayer) and "elevation" in layer.name()
    )
    desktop.dock.form.dem.setLayer(dem)
    hand.two_clicks()
    iface.mapCanvas().unsetMapTool(iface.mapCanvas().mapTool())
    hand.hover(ROW, COLUMN)
    wait_for_map()
    hand.hover(ROW, COLUMN)
    return hand


def guide_desktop() -> None:
    """Show the desktop after two clicks."""
    plan()
    save("guide_desktop", window())


def guide_sites() -> None:
    """Show two places side by side."""
    dock = plugins["muysc"].desktop.dock
    hand = Hand(dock, iface.mapCanvas())
    dock.places.setCollapsed(False)
    dock.sites.add.click()
    hand.take("detector")
    hand.click(*ELSEWHERE)
    hand.settle()
    dock.sites.add.click()
    hand.settle()
    iface.mapCanvas().unsetMapTool(iface.mapCanvas().mapTool())
    wait_for_map()
    save("guide_sites", window())


def guide_section() -> None:
    """Show the terrain along a ray."""
    hand = Hand(plugins["muysc"].desktop.dock, iface.mapCanvas())
    section = hand.open_section(ROW, COLUMN)
    save("guide_section", section)
    section.close()


def toolbox() -> QDockWidget:
    """Return the toolbox with the plugin's branch open."""
    dock = window().findChild(QDockWidget, "ProcessingToolbox")
    dock.setUserVisible(True)
    tree = dock.findChild(QTreeView)
    tree.collapseAll()
    model = tree.model()
    for row in range(model.rowCount()):
        index = model.index(row, 0)
        if str(index.data()) == "MUYSC":
            tree.expandRecursively(index)
            tree.scrollTo(index, QTreeView.ScrollHint.PositionAtTop)
    QTest.qWait(300)
    return dock


def guide_toolbox() -> None:
    """Show the algorithms in the toolbox."""
    save("guide_toolbox", toolbox())


def dialog() -> QWidget:
    """Return the dialog of radiography, filled in."""
    places = {name: demo.VIEW[name] for name in ("DETECTOR", "TARGET")}
    layer = next(
        one
        for one in QgsProject.instance().mapLayers().values()
        if isinstance(one, QgsRasterLayer) and "elevation" in one.name()
    )
    shown = processing.createAlgorithmDialog(
        RADIOGRAPHY,
        {**places, "DEM": layer.id(), "AZIMUTH_APERTURE": 42, "ELEVATION_APERTURE": 22},
    )
    shown.resize(1000, 720)
    shown.show()
    QTest.qWait(800)
    return shown


def guide_dialog() -> None:
    """Show the dialog of radiography."""
    shown = dialog()
    save("guide_dialog", shown)
    shown.close()


@lru_cache
def survey(folder: Path) -> dict[str, str]:
    """Run the model as a user would, and return its files."""
    view = {name: value for name, value in demo.VIEW.items() if name != "DEM"}
    outputs = {
        "radiography:THICKNESS": "Rock thickness.tif",
        "radiography:FLUX": "Muon flux.tif",
        "radiography:FIELD_OF_VIEW": "Field of view.gpkg",
        "flux:OUTPUT": "Muon flux on the terrain.tif",
        "thickness:OUTPUT": "Rock thickness on the terrain.tif",
    }
    files = {name: str(folder / file) for name, file in outputs.items()}
    processing.run(SURVEY, {**view, "DEM": str(demo.DEM), **files})
    return files


FOLDER = Path(tempfile.mkdtemp(dir=os.environ["HOME"]))


def guide_draped() -> None:
    """Show the muogram on the map."""
    plugins["muysc"].desktop.dock.close()
    toolbox().hide()
    files = survey(FOLDER)
    field = iface.addVectorLayer(files["radiography:FIELD_OF_VIEW"], "Field of view", "ogr")
    FootprintOnLoad().apply(field)
    layer = iface.addRasterLayer(files["flux:OUTPUT"], "Muon flux on the terrain")
    layer.setOpacity(0.85)
    layers = window().findChild(QDockWidget, "Layers")
    window().resizeDocks([layers], [380], Qt.Orientation.Horizontal)
    zoom_to(14.402, 40.804, 14.437, 40.832)
    save("guide_draped", window())


def guide_muogram() -> None:
    """Show a muogram as a layer of its own."""
    files = survey(FOLDER)
    project = QgsProject.instance()
    hidden = project.layerTreeRoot()
    for node in hidden.findLayers():
        node.setItemVisibilityChecked(False)
    layer = iface.addRasterLayer(files["radiography:THICKNESS"], "Rock thickness (m)")
    iface.mapCanvas().setExtent(layer.extent().buffered(1))
    toolbox()
    wait_for_map()
    save("guide_muogram", window())
    project.removeMapLayer(layer.id())
    for node in hidden.findLayers():
        node.setItemVisibilityChecked(True)


def guide_model() -> None:
    """Show the model in the designer."""
    from processing.modeler.ModelerDialog import ModelerDialog

    designer = ModelerDialog.create()
    folder = Path(os.environ["MUYSC_TOOLS"]).parent / "processing_algorithms" / "models"
    designer.loadModel(str(folder / "volcanosurvey.model3"))
    designer.resize(1400, 860)
    designer.show()
    QTest.qWait(600)
    designer.findChild(QAction, "mActionZoomToItems").trigger()
    save("guide_model", designer)
    designer.hide()


def guide_spanish() -> None:
    """Show the desktop in Spanish."""
    plan()
    save("guide_spanish", window())


def main() -> None:
    """Play the scenes that are asked for, then end QGIS."""
    try:
        arrange()
        for name in os.environ["MUYSC_PICTURES"].split():
            scene: Callable[[], None] = globals()[name]
            scene()
    except Exception:
        # Nobody sees a message box here.
        sys.stderr.write(traceback.format_exc())
    finally:
        QgsProject.instance().setDirty(False)
        sys.stderr.flush()
        os._exit(0)


if iface is not None and QApplication.instance() is not None and open_vesuvius:
    QTimer.singleShot(2000, main)
