"""Start-up script of QGIS: the terrain of Vesuvius, with a telescope and its target."""

from pathlib import Path

from qgis.core import (
    Qgis,
    QgsColorRampShader,
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsFeature,
    QgsGeometry,
    QgsHillshadeRenderer,
    QgsMarkerSymbol,
    QgsPalLayerSettings,
    QgsPointXY,
    QgsProject,
    QgsRasterDataProvider,
    QgsRasterLayer,
    QgsRasterShader,
    QgsSingleBandPseudoColorRenderer,
    QgsVectorLayer,
    QgsVectorLayerSimpleLabeling,
)
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtWidgets import QDockWidget
from qgis.utils import iface, plugin_paths

#: UTM zone 33 North, so that the map shows the mountain undistorted.
MAP_CRS = "EPSG:32633"
#: Height (m) and colour of the terrain tints.
TINTS = ((0, "#7fae7b"), (300, "#d8d3a0"), (700, "#b98d5e"), (1280, "#f4f0ec"))
#: Metres of height to one degree of latitude, for shading a geographic raster.
METRES_PER_DEGREE = 111_000
PLACES = {"detector": (14.410686, 40.810561), "target": (14.424745, 40.823729)}


def checkout() -> Path:
    """Return the folder that QGIS has loaded the plugin from."""
    folders = [Path(folder) / "muysc" for folder in plugin_paths]
    return next(folder for folder in folders if folder.exists()).resolve()


def smooth(layer: QgsRasterLayer) -> None:
    """Interpolate heights between the cells; steps would be shaded as stripes."""
    provider = layer.dataProvider()
    provider.enableProviderResampling(True)
    provider.setZoomedInResamplingMethod(QgsRasterDataProvider.ResamplingMethod.Cubic)
    layer.setResamplingStage(Qgis.RasterResamplingStage.Provider)


def hillshade(dem: str) -> QgsRasterLayer:
    """Return the terrain lit from the north-west."""
    layer = QgsRasterLayer(dem, "Vesuvius, hillshade")
    renderer = QgsHillshadeRenderer(layer.dataProvider(), 1, 315, 45)
    renderer.setZFactor(1 / METRES_PER_DEGREE)
    layer.setRenderer(renderer)
    smooth(layer)
    return layer


def terrain(dem: str) -> QgsRasterLayer:
    """Return the terrain in tints of height, see-through."""
    layer = QgsRasterLayer(dem, "Vesuvius, elevation (m)")
    ramp = QgsColorRampShader(TINTS[0][0], TINTS[-1][0])
    ramp.setColorRampItemList(
        [QgsColorRampShader.ColorRampItem(height, QColor(tint), f"{height} m")
         for height, tint in TINTS]
    )  # fmt: skip
    shader = QgsRasterShader()
    shader.setRasterShaderFunction(ramp)
    layer.setRenderer(QgsSingleBandPseudoColorRenderer(layer.dataProvider(), 1, shader))
    layer.setOpacity(0.6)
    smooth(layer)
    return layer


def places() -> QgsVectorLayer:
    """Return detector and target as labelled points."""
    layer = QgsVectorLayer("Point?crs=EPSG:4326&field=name:string", "Telescope", "memory")
    for name, position in PLACES.items():
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(*position)))
        feature.setAttributes([name])
        layer.dataProvider().addFeatures([feature])
    layer.renderer().setSymbol(
        QgsMarkerSymbol.createSimple({"name": "circle", "color": "#c2255c", "size": "3"})
    )
    labels = QgsPalLayerSettings()
    labels.fieldName = "name"
    labels.dist = 1.5  # mm beside the dot
    layer.setLabeling(QgsVectorLayerSimpleLabeling(labels))
    layer.setLabelsEnabled(True)
    return layer


def open_vesuvius() -> None:
    """Fill an empty project and zoom to the mountain."""
    project = QgsProject.instance()
    dem = str(checkout() / "tests" / "data" / "vesuvius_srtmgl1.tif")
    layer = terrain(dem)
    # Otherwise the first layer would give the map its own.
    iface.layerTreeCanvasBridge().setAutoSetupOnFirstLayer(False)
    project.setCrs(QgsCoordinateReferenceSystem(MAP_CRS))
    project.addMapLayers([places(), layer, hillshade(dem)])
    to_map = QgsCoordinateTransform(layer.crs(), project.crs(), project)
    iface.mapCanvas().setExtent(to_map.transformBoundingBox(layer.extent()))
    iface.mapCanvas().refresh()
    toolbox = iface.mainWindow().findChild(QDockWidget, "ProcessingToolbox")
    if toolbox is not None:
        toolbox.show()


open_vesuvius()
