"""The dock on terrain of another datum: what is clicked, computed and drawn is one place."""

import pytest
from pyproj import Geod, Transformer
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsProject,
    QgsRasterLayer,
)

#: On the flank of Mount St. Helens and in its crater, WGS 84.
FLANK, CRATER = (-122.2, 46.18), (-122.1944, 46.1910)

#: NAD27 to WGS 84 (13), which QGIS does not take of itself here.
CHOSEN = (
    "+proj=pipeline +step +inv +proj=utm +zone=10 +ellps=clrk66 +step +proj=push +v_3 "
    "+step +proj=cart +ellps=clrk66 +step +proj=helmert +x=4 +y=159 +z=188 "
    "+step +inv +proj=cart +ellps=WGS84 +step +proj=pop +v_3 "
    "+step +proj=unitconvert +xy_in=rad +xy_out=deg"
)


@pytest.fixture
def on_helens(dock, iface, project, data_folder, hand):
    """Return a dock with terrain in NAD27 and two clicks, on a map in some system."""

    def click(map_crs):
        crs = QgsCoordinateReferenceSystem(map_crs)
        project.setCrs(crs)
        layer = QgsRasterLayer(str(data_folder / "st_helens_usgs.tif"), "St. Helens")
        project.addMapLayer(layer)
        canvas = iface.mapCanvas()
        canvas.setDestinationCrs(crs)
        to_map = QgsCoordinateTransform(layer.crs(), crs, project)
        canvas.setExtent(to_map.transformBoundingBox(layer.extent()))
        dock.form.dem.setLayer(layer)
        hand.detector, hand.target = FLANK, CRATER
        hand.two_clicks()
        return dock

    return click


# NAD83 is brought to NAD27 by nothing better than no shift at all, where its grid is missing.
@pytest.mark.parametrize("map_crs", ["EPSG:4326", "EPSG:3857", "EPSG:32610", "EPSG:26910"])
@pytest.mark.parametrize("chosen", [False, True])
def test_the_place_clicked_is_the_place_computed_and_drawn(on_helens, map_crs, chosen):
    if chosen:
        context = QgsProject.instance().transformContext()
        ends = map(QgsCoordinateReferenceSystem, ("EPSG:26710", "EPSG:4326"))
        assert context.addCoordinateOperation(*ends, CHOSEN)
        QgsProject.instance().setTransformContext(context)
    planner = on_helens(map_crs).planner
    preview, plan = planner.preview, planner.plan
    metadata = preview.muogram("flux").metadata
    number = 13 if chosen else 3
    assert metadata["TRANSFORMATION"] == f"NAD27 to WGS 84 ({number})"
    to_wgs84 = Transformer.from_crs(map_crs, 4326, always_xy=True)
    clicked = to_wgs84.transform(plan.detector.x, plan.detector.y)
    computed = metadata["DETECTOR_LON"], metadata["DETECTOR_LAT"]
    geod = Geod(ellps="WGS84")
    assert geod.inv(*clicked, *computed)[2] < 0.1
    # The field of view begins at the detector.
    drawn = planner.items.field_of_view
    corners = [to_wgs84.transform(one.x(), one.y()) for one in drawn.vertices()]
    assert min(geod.inv(*clicked, *one)[2] for one in corners) < 0.1
