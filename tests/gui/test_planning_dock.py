"""Two clicks on the map give what the algorithm computes, whatever happens in between."""

import shlex
import threading
from dataclasses import replace

import numpy as np
import pytest
from qgis.core import QgsCoordinateReferenceSystem, QgsPointXY, QgsProject, QgsRasterLayer


def run(algorithm, parameters):
    import processing

    outputs = {"THICKNESS": "TEMPORARY_OUTPUT", "FLUX": "TEMPORARY_OUTPUT"}
    return processing.run(algorithm, {**parameters, **outputs})


def assert_same(preview, results):
    from osgeo import gdal

    for output in ("THICKNESS", "FLUX"):
        raster = gdal.Open(results[output]).ReadAsArray()
        # Rasters are in single precision.
        np.testing.assert_allclose(preview.muogram(output.lower()).values, raster, rtol=1e-6)


@pytest.mark.parametrize("map_crs", ["EPSG:32633", "EPSG:4326", "EPSG:3857"])
def test_two_clicks_give_the_numbers_of_the_algorithm(dock, iface, terrain, hand, map_crs):
    crs = QgsCoordinateReferenceSystem(map_crs)
    canvas = iface.mapCanvas()
    extent = canvas.extent()
    canvas.setDestinationCrs(crs)
    assert canvas.extent() != extent or map_crs == "EPSG:32633"
    dock.form.dem.setLayer(terrain)
    hand.two_clicks()
    plan = dock.planner.plan
    assert (plan.detector.crs, plan.target.crs) == (map_crs, map_crs)
    assert dock.planner.preview.muogram("thickness").values.shape == (100, 100)
    assert_same(dock.planner.preview, run("muysc:radiography", plan.radiography(terrain.source())))


def test_a_dem_in_metres_and_a_map_in_degrees(dock, iface, project, data_folder, hand):
    layer = QgsRasterLayer(str(data_folder / "maungawhau_linz5m.tif"), "Maungawhau")
    project.addMapLayer(layer)
    canvas = iface.mapCanvas()
    canvas.setDestinationCrs(QgsCoordinateReferenceSystem("EPSG:4326"))
    middle = layer.extent().center()
    crs = layer.crs()
    from qgis.core import QgsCoordinateTransform

    to_degrees = QgsCoordinateTransform(crs, QgsCoordinateReferenceSystem("EPSG:4326"), project)
    canvas.setExtent(to_degrees.transformBoundingBox(layer.extent()))
    dock.form.dem.setLayer(layer)
    aside = to_degrees.transform(QgsPointXY(middle.x() - 150, middle.y() - 100))
    aim = to_degrees.transform(middle)
    hand.detector, hand.target = (aside.x(), aside.y()), (aim.x(), aim.y())
    hand.two_clicks()
    preview = dock.planner.preview
    assert preview.inputs.sight.target_distance_m == pytest.approx(np.hypot(150, 100), abs=5)
    assert_same(preview, run("muysc:radiography", dock.planner.plan.radiography(layer.id())))


def test_settings_reach_the_muogram(planned, hand, terrain):
    form = planned.form
    form.preset.setCurrentIndex(form.preset.findData("carbone2014"))
    form.detector_height.setValue(3)
    form.target_height.setValue(-100)
    form.density.setValue(2.2)
    form.model.setCurrentIndex(form.model.findData("guan"))
    hand.settle()
    metadata = planned.planner.preview.muogram("flux").metadata
    assert (metadata["DENSITY"], metadata["FLUX_MODEL"]) == (2.2, "guan")
    assert metadata["DETECTOR_HEIGHT"] == 3
    assert planned.planner.plan.azimuth_aperture_deg == pytest.approx(
        2 * np.degrees(np.arctan(16 * 5 / 170)), abs=0.06
    )
    parameters = planned.planner.plan.radiography(terrain.id())
    assert (parameters["PRESET"], parameters["TARGET_HEIGHT"]) == ("carbone2014", -100)
    assert_same(planned.planner.preview, run("muysc:radiography", parameters))


def test_counts_are_flux_times_acceptance_times_days(planned, hand):
    planned.form.acceptance.setValue(12)
    planned.form.days.setValue(50)
    hand.settle()
    preview = planned.planner.preview
    np.testing.assert_allclose(
        preview.muogram("counts").values, preview.muogram("flux").values * 12 * 50
    )


def test_without_a_dem_the_dock_says_what_to_do(dock, hand):
    assert "DEM" in dock.muogram.view.reason
    hand.two_clicks()
    assert "DEM" in dock.muogram.view.reason


def test_the_only_raster_is_suggested(terrain, desktop):
    desktop.action.setChecked(True)
    assert desktop.dock.planner.layer is terrain
    assert "detector" in desktop.dock.muogram.view.reason


def test_removing_the_dem_leaves_a_usable_dock(planned, project, terrain, hand, data_folder):
    source = terrain.source()
    project.removeMapLayer(terrain)
    assert planned.planner.preview is None
    assert "DEM" in planned.muogram.view.reason
    assert not planned.muogram.copy.isEnabled()
    again = QgsRasterLayer(source, "again")
    project.addMapLayer(again)
    planned.form.dem.setLayer(again)
    hand.settle()
    assert planned.planner.preview is not None


def test_removing_the_dem_while_it_is_read_is_safe(planned, project, terrain, hand):
    planned.form.azimuth.setValue(359)
    assert planned.planner.busy
    project.removeMapLayer(terrain)
    hand.settle()
    assert planned.planner.preview is None


def test_a_point_off_the_dem_is_told_in_a_sentence(planned, hand):
    hand.take("detector")
    hand.click(14.2, 40.81)
    hand.settle()
    assert planned.planner.preview is None
    assert "is off the DEM" in planned.muogram.view.reason
    assert planned.planner.items.field_of_view.isEmpty()


def test_of_very_fast_clicks_only_the_last_arrives(planned, hand):
    arrived = []
    planned.planner.previewed.connect(arrived.append)
    hand.take("detector")
    longitude, latitude = hand.detector
    for step in range(12):
        hand.click(longitude + 0.0004 * step, latitude)
    hand.settle()
    assert len(arrived) == 1
    longitude_seen, _ = arrived[0].inputs.sight.detector_wgs84
    assert longitude_seen == pytest.approx(longitude + 0.0004 * 11, abs=2e-4)


def test_dragging_redraws_roughly_and_letting_go_fully(planned, hand, gui):
    arrived = []
    planned.planner.previewed.connect(arrived.append)
    # The tool of the target takes hold of the detector's marker.
    hand.take("target")
    target = planned.planner.plan.target
    dot = hand.drag(hand.detector, 8)
    hand.settle()
    assert arrived
    assert all(preview.coarse for preview in arrived)
    side = gui("preview").COARSE_PIXELS
    assert arrived[-1].muogram("flux").values.shape == (side, side)
    hand.release(dot)
    hand.settle()
    assert not arrived[-1].coarse
    assert arrived[-1].muogram("flux").values.shape == (100, 100)
    assert planned.planner.plan.target == target


def test_the_project_keeps_the_plan(planned, project, hand, tmp_path, terrain):
    planned.form.density.setValue(2.4)
    hand.settle()
    plan, thickness = planned.planner.plan, planned.planner.preview.muogram("thickness").values
    path = str(tmp_path / "plan.qgz")
    assert project.write(path)
    assert not project.isDirty()
    project.clear()
    assert planned.planner.plan.detector is None
    assert planned.planner.preview is None
    assert "DEM" in planned.muogram.view.reason
    assert project.read(path)
    hand.settle()
    assert planned.planner.plan == plan
    assert planned.form.density.value() == 2.4
    np.testing.assert_array_equal(planned.planner.preview.muogram("thickness").values, thickness)


def test_a_project_without_a_plan_stays_as_it_is(dock, project, tmp_path):
    path = str(tmp_path / "other.qgz")
    assert project.write(path)
    assert not project.isDirty()
    assert project.readEntry("muysc", "/plan") == ("", False)


def test_what_is_no_plan_in_a_project_is_ignored(gui, project):
    Plan = gui("plan").Plan  # noqa: N806
    for text in ("", "nonsense", "[1]", "3", '{"detector": 3}', '{"detector": {"x": 1}}'):
        assert Plan.from_json(text) == Plan()
    assert Plan.from_json('{"unheard_of": 1, "muons": "many", "days": 7.5}') == Plan(days=7.5)
    plan = Plan(detector=gui("plan").Place(1.5, 2, "EPSG:4326"), density_g_cm3=2.4)
    assert Plan.from_json(plan.to_json()) == plan


def test_a_system_without_a_code_reaches_the_algorithm(planned, iface, hand):
    crs = QgsCoordinateReferenceSystem.fromProj("+proj=laea +lat_0=40.8 +lon_0=14.4 +units=m")
    assert not crs.authid()
    iface.mapCanvas().setDestinationCrs(crs)
    iface.mapCanvas().zoomToFullExtent()
    before = planned.planner.preview.inputs.sight.target_distance_m
    hand.two_clicks()
    assert planned.planner.plan.detector.crs.startswith("WKT:")
    after = planned.planner.preview.inputs.sight.target_distance_m
    assert after == pytest.approx(before, abs=60)
    parameters = planned.planner.plan.radiography(planned.planner.layer.source())
    assert_same(planned.planner.preview, run("muysc:radiography", parameters))


def test_the_dialog_is_filled_in(planned, monkeypatch):
    import processing

    opened = []

    class Dialog:
        def show(self):
            pass

    def create(algorithm, parameters):
        opened.append((algorithm, parameters))
        return Dialog()

    monkeypatch.setattr(processing, "createAlgorithmDialog", create)
    radiography, counts = planned.run.menu().actions()
    radiography.trigger()
    counts.trigger()
    (first, radiographed), (second, counted) = opened
    assert (first, second) == ("muysc:radiography", "muysc:expectedcounts")
    assert_same(planned.planner.preview, run(first, radiographed))
    assert counted["DAYS"] == 30
    assert counted["DETECTOR"] == radiographed["DETECTOR"]


def test_the_command_computes_the_same(planned, qgis_application):
    planned.copy.menu().actions()[0].trigger()
    program, verb, algorithm, *options = shlex.split(qgis_application.clipboard().text())
    assert (program, verb, algorithm) == ("qgis_process", "run", "muysc:radiography")
    parameters = dict(option.removeprefix("--").split("=", 1) for option in options)
    assert_same(planned.planner.preview, run(algorithm, parameters))


def test_unloading_leaves_nothing_behind(gui, iface, terrain):
    iface.mainWindow().show()
    canvas = iface.mapCanvas()
    before, threads = len(canvas.scene().items()), {*threading.enumerate()}
    desktop = gui("desktop").Desktop(iface)
    desktop.action.setChecked(True)
    dock = desktop.dock
    from qgis.PyQt.QtCore import QEvent
    from qgis.PyQt.QtWidgets import QApplication

    dock.planner.change(
        replace(
            dock.planner.plan,
            detector=gui("plan").Place(14.410686, 40.810561, "EPSG:4326"),
            target=gui("plan").Place(14.424745, 40.823729, "EPSG:4326"),
        )
    )
    dock.form.pick_target.click()
    assert len(canvas.scene().items()) > before
    assert dock.planner.busy
    desktop.remove()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert len(canvas.scene().items()) == before
    assert canvas.mapTool() is None
    assert {*threading.enumerate()} <= threads
    assert iface.toolbar.actions() == [] == iface.menu
    # Nobody listens any more.
    QgsProject.instance().clear()
    canvas.setDestinationCrs(QgsCoordinateReferenceSystem("EPSG:3857"))


def test_closing_the_dock_clears_the_map(planned, desktop, iface, hand):
    items = planned.planner.items
    assert not items.field_of_view.isEmpty()
    planned.close()
    assert not desktop.action.isChecked()
    assert items.field_of_view.isEmpty()
    assert not any(item.isVisible() for item in items.markers)
    desktop.action.setChecked(True)
    hand.settle()
    assert not items.field_of_view.isEmpty()
