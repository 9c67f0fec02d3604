"""Picking on the map: snapping, keys, and tools that others take over."""

import pytest
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsFeature,
    QgsGeometry,
    QgsPointXY,
    QgsProject,
    QgsSnappingConfig,
    QgsTolerance,
    QgsVectorLayer,
)
from qgis.gui import QgsMapCanvasSnappingUtils, QgsMapToolPan
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest


@pytest.fixture
def huts(project, iface):
    """A layer with one point, to which the project's snapping options hold."""
    layer = QgsVectorLayer("Point?crs=EPSG:4326", "huts", "memory")
    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(14.412, 40.811)))
    layer.dataProvider().addFeatures([feature])
    layer.updateExtents()
    project.addMapLayer(layer)
    canvas = iface.mapCanvas()
    canvas.setLayers([layer, *canvas.layers()])
    config = QgsSnappingConfig(project)
    config.setEnabled(True)
    config.setMode(QgsSnappingConfig.SnappingMode.AllLayers)
    config.setTypeFlag(QgsSnappingConfig.SnappingTypes.VertexFlag)
    config.setTolerance(20)
    config.setUnits(QgsTolerance.UnitType.Pixels)
    snapping = QgsMapCanvasSnappingUtils(canvas, canvas)
    snapping.setConfig(config)
    canvas.setSnappingUtils(snapping)
    # The first look builds an index, for which events of the mouse do not wait.
    snapping.snapToMap(canvas.center())
    yield feature.geometry().asPoint()
    canvas.setSnappingUtils(None)


def test_a_click_near_a_vertex_is_at_the_vertex(dock, terrain, huts, hand):
    dock.form.dem.setLayer(terrain)
    hand.take("detector")
    beside = hand.canvas.mapUnitsPerPixel() * 8 / 111_000
    hand.click(huts.x() + beside, huts.y())
    place = dock.planner.plan.detector
    back = QgsCoordinateTransform(
        place.system, QgsCoordinateReferenceSystem("EPSG:4326"), QgsProject.instance()
    )
    point = back.transform(place.point)
    assert (point.x(), point.y()) == pytest.approx((huts.x(), huts.y()), abs=1e-7)


def test_after_the_detector_the_target_is_picked(dock, terrain, hand, iface):
    hand.take("detector")
    assert iface.mapCanvas().mapTool() is dock.planner.tools["detector"]
    hand.click(*hand.detector)
    assert dock.form.pick_target.isChecked()
    assert not dock.form.pick_detector.isChecked()
    assert iface.mapCanvas().mapTool() is dock.planner.tools["target"]


def test_escape_puts_the_tool_away(dock, iface, hand):
    hand.take("target")
    QTest.keyClick(iface.mapCanvas(), Qt.Key.Key_Escape)
    assert iface.mapCanvas().mapTool() is None
    assert not dock.form.pick_target.isChecked()


def test_another_tool_releases_the_button(dock, iface, hand):
    hand.take("detector")
    pan = QgsMapToolPan(iface.mapCanvas())
    iface.mapCanvas().setMapTool(pan)
    assert not dock.form.pick_detector.isChecked()
    iface.mapCanvas().unsetMapTool(pan)


def test_pressing_the_button_again_puts_the_tool_away(dock, iface, hand):
    hand.take("detector")
    dock.form.pick_detector.click()
    assert iface.mapCanvas().mapTool() is None


def test_the_right_button_picks_nothing(dock, iface, hand):
    hand.take("detector")
    QTest.mouseClick(
        iface.mapCanvas().viewport(),
        Qt.MouseButton.RightButton,
        Qt.KeyboardModifier.NoModifier,
        hand.dot(*hand.detector),
    )
    assert dock.planner.plan.detector is None


def test_a_map_without_a_system_is_in_that_of_the_dem(dock, iface, terrain, hand, project):
    canvas = iface.mapCanvas()
    canvas.setDestinationCrs(QgsCoordinateReferenceSystem())
    canvas.setExtent(terrain.extent())
    dock.form.dem.setLayer(terrain)
    hand.two_clicks()
    assert dock.planner.plan.detector.crs == terrain.crs().authid()
    assert dock.planner.preview.inputs.sight.target_distance_m == pytest.approx(1884, abs=60)
