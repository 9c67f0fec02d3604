"""Candidate places for the detector, kept in a point layer of the project."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsGeometry,
    QgsMarkerSymbol,
    QgsPalLayerSettings,
    QgsProject,
    QgsVectorLayer,
    QgsVectorLayerSimpleLabeling,
)

from ...processing_algorithms.compat import field
from ..errors import MuyscError
from ..plots.style import DETECTOR
from .plan import Place
from .texts import tr

#: Marks the layer, whatever it is called and wherever it was saved.
_PROPERTY = "muysc/candidates"

#: Where the project file keeps the sites of a layer that lives in memory.
SCOPE, ENTRY = "muysc", "/candidates"

_NAME, _HEIGHT = "name", "height_m"


@dataclass(frozen=True)
class Site:
    """A place where the telescope could stand."""

    identifier: int
    name: str
    place: Place
    height_m: float


def find_layer() -> QgsVectorLayer | None:
    """Return the layer of candidate sites, None where there is none."""
    for layer in QgsProject.instance().mapLayers().values():
        if isinstance(layer, QgsVectorLayer) and layer.customProperty(_PROPERTY):
            return layer
    return None


def make_layer(crs: QgsCoordinateReferenceSystem) -> QgsVectorLayer:
    """Add an empty layer of candidate sites to the project."""
    layer = QgsVectorLayer("Point", tr("Candidate sites"), "memory")
    layer.setCrs(crs)
    layer.dataProvider().addAttributes([field(_NAME, str), field(_HEIGHT, float)])
    layer.updateFields()
    layer.setCustomProperty(_PROPERTY, True)
    # What is in it is kept by the project, so nobody needs to be warned.
    layer.setCustomProperty("skipMemoryLayersCheck", 1)
    layer.renderer().setSymbol(
        QgsMarkerSymbol.createSimple({"name": "triangle", "color": DETECTOR, "size": "3"})
    )
    labels = QgsPalLayerSettings()
    labels.fieldName = _NAME
    layer.setLabeling(QgsVectorLayerSimpleLabeling(labels))
    layer.setLabelsEnabled(True)
    QgsProject.instance().addMapLayer(layer)
    return layer


def numbered(number: int) -> str:
    """Return the name of a site that has been given none."""
    return tr("Site {number}").format(number=number)


def sites_of(layer: QgsVectorLayer) -> list[Site]:
    """Return the sites of a layer, which may lack names and heights."""
    names = layer.fields().names()
    sites = []
    for feature in layer.getFeatures():
        geometry = feature.geometry()
        if geometry.isEmpty():
            continue
        name = feature[_NAME] if _NAME in names else None
        height = feature[_HEIGHT] if _HEIGHT in names else None
        sites.append(
            Site(
                feature.id(),
                str(name) if name else numbered(feature.id()),
                Place.of(geometry.centroid().asPoint(), layer.crs()),
                float(height) if isinstance(height, (int, float)) else 0.0,
            )
        )
    return sites


def add_site(layer: QgsVectorLayer, name: str, place: Place, height_m: float) -> None:
    """Add a site to a layer.

    Raises
    ------
    MuyscError
        If the layer cannot be written, or does not reach there.
    """
    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromPointXY(place.point_in(layer.crs())))
    names = layer.fields().names()
    for key, value in ((_NAME, name), (_HEIGHT, height_m)):
        if key in names:
            feature[key] = value
    _require(layer.dataProvider().addFeatures([feature])[0], layer)
    layer.updateExtents()
    layer.triggerRepaint()


def remove_sites(layer: QgsVectorLayer, identifiers: list[int]) -> None:
    """Remove sites from a layer.

    Raises
    ------
    MuyscError
        If the layer cannot be written.
    """
    _require(layer.dataProvider().deleteFeatures(identifiers), layer)
    layer.triggerRepaint()


def rename_site(layer: QgsVectorLayer, identifier: int, name: str) -> None:
    """Give a site another name.

    Raises
    ------
    MuyscError
        If the layer cannot be written.
    """
    index = layer.fields().indexFromName(_NAME)
    changed = index >= 0 and layer.dataProvider().changeAttributeValues({identifier: {index: name}})
    _require(changed, layer)
    layer.triggerRepaint()


def _require(done: bool, layer: QgsVectorLayer) -> None:
    if not done:
        raise MuyscError(
            tr("The layer {name} cannot be changed; save it as a GeoPackage.").format(
                name=layer.name()
            )
        )


def store_sites() -> None:
    """Keep the sites of a layer in memory in the project, whose file would lose them."""
    layer = find_layer()
    kept = layer is not None and layer.dataProvider().name() == "memory"
    entries = [asdict(site) for site in sites_of(layer)] if layer is not None and kept else []
    project = QgsProject.instance()
    if entries or project.readEntry(SCOPE, ENTRY)[0]:
        project.writeEntry(SCOPE, ENTRY, json.dumps(entries))


def restore_sites() -> None:
    """Fill a layer in memory, empty in a project that was opened, again."""
    layer = find_layer()
    if layer is None or layer.dataProvider().name() != "memory" or layer.featureCount():
        return
    try:
        for entry in json.loads(QgsProject.instance().readEntry(SCOPE, ENTRY)[0] or "[]"):
            add_site(layer, entry["name"], Place(**entry["place"]), entry["height_m"])
    except (ValueError, TypeError, KeyError):
        # Not written by this plugin.
        return
