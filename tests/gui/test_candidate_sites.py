"""Candidate sites: a layer of the project, and the figures that compare them."""

import pytest
from qgis.core import QgsVectorFileWriter, QgsVectorLayer


@pytest.fixture
def sites(gui):
    return gui("sites")


@pytest.fixture
def two_sites(planned, hand):
    planned.places.setCollapsed(False)
    planned.sites.add.click()
    hand.take("detector")
    hand.click(14.43, 40.80)
    hand.settle()
    planned.sites.add.click()
    hand.settle()
    return planned


def column(dock, number):
    table = dock.sites.table
    return [table.item(row, number).text() for row in range(table.rowCount())]


def test_sites_stand_in_a_layer_of_the_project(two_sites, sites, project):
    layer = sites.find_layer()
    assert layer.id() in project.mapLayers()
    assert layer.crs() == project.crs()
    assert [site.name for site in sites.sites_of(layer)] == ["Site 1", "Site 2"]
    assert sites.sites_of(layer)[1].place == two_sites.planner.plan.detector


def test_the_figures_are_those_of_the_muogram_from_each_site(two_sites):
    plan, preview = two_sites.planner.plan, two_sites.planner.preview
    listed = two_sites.sites.comparison
    from_here = next(
        listed.figures(plan, site) for site in two_sites.sites.listed if site.place == plan.detector
    )
    assert from_here.target_distance_m == preview.inputs.sight.target_distance_m
    assert from_here.maximum_thickness_m == preview.simulation.maximum_thickness_m
    assert column(two_sites, 1)[1] == f"{from_here.target_distance_m:.0f}"
    assert column(two_sites, 2)[1] == f"{from_here.maximum_thickness_m:.0f}"
    # The ray to the target is where the muogram's four middle pixels meet.
    middle = preview.muogram("exposure").values[49:51, 49:51]
    assert middle.min() * 0.9 < from_here.target_days < middle.max() * 1.1


def test_figures_follow_the_settings(two_sites, hand):
    before = column(two_sites, 3)
    two_sites.form.muons.setValue(100)
    hand.settle()
    after = column(two_sites, 3)
    for few, many in zip(before, after):
        assert float(many.replace("\u202f", "")) == pytest.approx(10 * float(few), rel=0.01)


def test_a_site_is_used_zoomed_to_renamed_and_removed(two_sites, sites, hand, iface):
    table = two_sites.sites.table
    assert not two_sites.sites.use.isEnabled()
    table.selectRow(0)
    two_sites.sites.use.click()
    hand.settle()
    first = two_sites.sites.listed[0]
    assert two_sites.planner.plan.detector == first.place
    table.selectRow(0)
    two_sites.sites.zoom.click()
    assert iface.mapCanvas().center().distance(first.place.point) < 1
    assert iface.mapCanvas().scale() <= 25_001
    table.item(0, 0).setText("Ridge")
    assert [site.name for site in sites.sites_of(sites.find_layer())] == ["Ridge", "Site 2"]
    table.selectRow(0)
    two_sites.sites.remove.click()
    hand.settle()
    assert column(two_sites, 0) == ["Site 2"]


def test_sites_in_memory_survive_in_the_project_file(two_sites, project, hand, tmp_path):
    figures = column(two_sites, 1)
    path = str(tmp_path / "sites.qgz")
    assert project.write(path)
    project.clear()
    assert column(two_sites, 0) == []
    assert project.read(path)
    hand.settle()
    assert column(two_sites, 0) == ["Site 1", "Site 2"]
    assert column(two_sites, 1) == figures


def test_sites_saved_as_a_geopackage_are_used_from_there(two_sites, sites, project, tmp_path, hand):
    memory = sites.find_layer()
    path = str(tmp_path / "sites.gpkg")
    options = QgsVectorFileWriter.SaveVectorOptions()
    QgsVectorFileWriter.writeAsVectorFormatV3(memory, path, project.transformContext(), options)
    saved = QgsVectorLayer(path, "saved", "ogr")
    saved.setCustomProperties(memory.customProperties())
    project.removeMapLayer(memory)
    assert column(two_sites, 0) == []
    project.addMapLayer(saved)
    assert column(two_sites, 0) == ["Site 1", "Site 2"]
    two_sites.sites.add.click()
    hand.settle()
    assert saved.featureCount() == 3


def test_what_the_user_does_to_the_layer_is_followed(two_sites, sites, hand):
    layer = sites.find_layer()
    layer.startEditing()
    layer.deleteFeature(sites.sites_of(layer)[0].identifier)
    layer.commitChanges()
    hand.settle()
    assert column(two_sites, 0) == ["Site 2"]


def test_a_site_off_the_dem_says_so_and_spoils_no_other(two_sites, sites, gui, hand):
    place = gui("plan").Place(14.2, 40.8, "EPSG:4326")
    sites.add_site(sites.find_layer(), "Naples", place, 0.0)
    two_sites.sites.reload()
    hand.settle()
    assert column(two_sites, 1)[2] == "–"
    assert "Naples: The detector" in two_sites.sites.told.text()
    assert "…" not in column(two_sites, 1)


def test_a_layer_of_another_origin_may_lack_name_and_height(project, sites, dock):
    layer = QgsVectorLayer("Point?crs=EPSG:4326", "places", "memory")
    layer.setCustomProperty("muysc/candidates", True)
    project.addMapLayer(layer)
    from qgis.core import QgsFeature, QgsGeometry, QgsPointXY

    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(14.41, 40.81)))
    layer.dataProvider().addFeatures([feature])
    dock.sites.reload()
    assert column(dock, 0) == ["Site 1"]
    assert dock.sites.listed[0].height_m == 0


def test_figures_that_are_folded_away_cost_nothing(two_sites, hand):
    two_sites.places.setCollapsed(True)
    two_sites.form.muons.setValue(100)
    hand.wait(lambda: not two_sites.planner.busy)
    assert not two_sites.sites.comparison.busy
    assert column(two_sites, 3) == ["…", "…"]
    two_sites.places.setCollapsed(False)
    hand.settle()
    assert "…" not in column(two_sites, 3)


def test_the_layer_is_filled_and_kept_without_the_dock(gui, iface, project, sites, tmp_path):
    desktop = gui("desktop").Desktop(iface)
    layer = sites.make_layer(project.crs())
    sites.add_site(layer, "Ridge", gui("plan").Place(14.41, 40.81, "EPSG:4326"), 2.0)
    path = str(tmp_path / "sites.qgz")
    assert project.write(path)
    project.clear()
    assert project.read(path)
    assert [(one.name, one.height_m) for one in sites.sites_of(sites.find_layer())] == [
        ("Ridge", 2.0)
    ]
    assert desktop.dock is None
    desktop.remove()
