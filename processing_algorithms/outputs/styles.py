"""Map styles: each quantity in the colours that panels and reports use."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
from qgis import core
from qgis.core import (
    Qgis,
    QgsCategorizedSymbolRenderer,
    QgsColorRampShader,
    QgsFillSymbol,
    QgsMapLayer,
    QgsMarkerSymbol,
    QgsPalLayerSettings,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingLayerPostProcessorInterface,
    QgsRasterShader,
    QgsRendererCategory,
    QgsSingleBandPseudoColorRenderer,
    QgsSingleSymbolRenderer,
    QgsTextBufferSettings,
    QgsTextFormat,
    QgsVectorLayerSimpleLabeling,
)
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtXml import QDomDocument, QDomElement

from ...muysc_qgis.plots.limits import colour_limits
from ...muysc_qgis.quantities import COLOUR_STOPS, Quantity

#: Colour of muogram pixels without rock.
SKY_COLOUR = "#dceaf7"

#: Quantities that are 0 where there is only sky.
_ZERO_IN_THE_SKY = ("thickness", "opacity")


def write_style(
    path: Path,
    values: np.ndarray,
    quantity: Quantity,
    band: int = 1,
    limits: tuple[float, float] | None = None,
    elevations: np.ndarray | None = None,
) -> None:
    """Write a QML style for one band of a raster.

    Parameters
    ----------
    path
        The ``.qml`` file; QGIS applies it when it stands beside the raster
        under the same name.
    values
        The raster's values, any shape.
    quantity
        What they are.
    band
        Number of the band to show, from 1.
    limits
        Values at the ends of the colours; None for what suits the values.
    elevations
        (n_bands + 1,) bounds of the elevation slices that the bands are, m; QGIS can step
        through them from 3.38 on. None where bands are no slices.
    """
    function = QgsColorRampShader()
    function.setColorRampType(QgsColorRampShader.Type.Interpolated)
    items = _colour_items(quantity, *(limits or colour_limits(values, quantity)))
    function.setColorRampItemList(items)
    function.setMinimumValue(items[0].value)
    function.setMaximumValue(items[-1].value)
    shader = QgsRasterShader()
    shader.setRasterShaderFunction(function)
    renderer = QgsSingleBandPseudoColorRenderer(None, band, shader)
    renderer.setClassificationMin(items[0].value)
    renderer.setClassificationMax(items[-1].value)
    document = QDomDocument()
    root = document.createElement("qgis")
    root.setAttribute("version", Qgis.QGIS_VERSION)
    root.setAttribute("styleCategories", "AllStyleCategories")
    pipe = document.createElement("pipe")
    renderer.writeXml(document, pipe)
    root.appendChild(pipe)
    if elevations is not None:
        _append_elevations(root, document, elevations)
    document.appendChild(root)
    path.write_text(document.toString(2), encoding="utf-8")


def _append_elevations(root: QDomElement, document: QDomDocument, elevations: np.ndarray) -> None:
    """Say which slice of elevations each band is, where QGIS knows such bands."""
    kind = getattr(core, "QgsRasterLayerElevationProperties", None)
    if not hasattr(kind, "setFixedRangePerBand"):
        return
    properties = kind(None)
    properties.setEnabled(True)
    properties.setMode(Qgis.RasterElevationMode.FixedRangePerBand)
    properties.setFixedRangePerBand({
        band + 1: core.QgsDoubleRange(float(low), float(high), True, False)
        for band, (low, high) in enumerate(zip(elevations[:-1], elevations[1:]))
    })  # fmt: skip
    properties.writeXml(root, document, core.QgsReadWriteContext())


def _colour_items(
    quantity: Quantity, low: float, high: float
) -> list[QgsColorRampShader.ColorRampItem]:
    """Return values with colours and labels, evenly spaced on the quantity's scale."""
    colours = COLOUR_STOPS[quantity.colours]
    if quantity.logarithmic:
        stops = np.geomspace(low, high, len(colours))
    else:
        stops = np.linspace(low, high, len(colours))
    unit = "" if quantity.unit == "1" else f" {quantity.unit}"
    items = [
        QgsColorRampShader.ColorRampItem(float(stop), QColor(colour), f"{_rounded(stop)}{unit}")
        for stop, colour in zip(stops, colours)
    ]
    if quantity.name in _ZERO_IN_THE_SKY:
        # Two stops close together: sky is one colour and the thinnest rock another.
        edge = low * 1e-6
        sky = QColor(SKY_COLOUR)
        items = [
            QgsColorRampShader.ColorRampItem(0.0, sky, "sky"),
            QgsColorRampShader.ColorRampItem(edge, QColor(colours[0]), f"< {_rounded(low)}{unit}"),
            *items,
        ]
    return items


def _rounded(value: float) -> str:
    """Return three significant digits without an exponent where that is short."""
    if value and not 1e-3 <= abs(value) < 1e6:
        return f"{value:.2e}"
    digits = max(0, 2 - math.floor(math.log10(abs(value)))) if value else 0
    return f"{value:,.{digits}f}".replace(",", " ")


class _OnLoad(QgsProcessingLayerPostProcessorInterface):
    """Does something to a layer when Processing adds it to the project."""

    #: QGIS keeps no reference of its own to a post-processor made in Python.
    _alive: list[_OnLoad] = []  # noqa: RUF012 - shared on purpose

    def __init__(self) -> None:
        super().__init__()
        self._alive.append(self)

    def postProcessLayer(
        self, layer: QgsMapLayer, context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> None:
        self.apply(layer)
        layer.triggerRepaint()
        self._alive.remove(self)

    def apply(self, layer: QgsMapLayer) -> None:
        raise NotImplementedError


class StyleOnLoad(_OnLoad):
    """Applies the style beside a raster.

    QGIS would do so itself unless the user has set a default raster style.
    """

    def __init__(self, style: str) -> None:
        super().__init__()
        self.style = style

    def apply(self, layer: QgsMapLayer) -> None:
        layer.loadNamedStyle(self.style)


class FootprintOnLoad(_OnLoad):
    """Draws a field of view as the map of the report does: outline, and a veil over the ground."""

    #: Part, its legend, and the properties of its fill.
    _PARTS = (
        ("aperture", "Field of view", {"style": "no", "outline_style": "dash"}),
        ("ground seen", "Ground seen", {"color": "204,121,167,110", "outline_style": "no"}),
    )

    def apply(self, layer: QgsMapLayer) -> None:
        layer.setRenderer(
            QgsCategorizedSymbolRenderer(
                "part",
                [
                    QgsRendererCategory(
                        part, QgsFillSymbol.createSimple({"outline_width": "0.4", **look}), label
                    )
                    for part, label, look in self._PARTS
                ],
            )
        )


class SitesOnLoad(_OnLoad):
    """Marks sites as the pictures of a survey do, each with its name."""

    #: Properties of the marker by kind of site.
    _MARKERS = {  # noqa: RUF012 - never changed
        "site": {"name": "circle", "color": "255,255,255", "size": "3"},
        "telescope": {
            "name": "triangle", "color": "0,114,178", "outline_color": "255,255,255", "size": "4.5",
        },
    }  # fmt: skip

    def __init__(self, kind: str) -> None:
        super().__init__()
        self.kind = kind

    def apply(self, layer: QgsMapLayer) -> None:
        marker = QgsMarkerSymbol.createSimple(self._MARKERS[self.kind])
        layer.setRenderer(QgsSingleSymbolRenderer(marker))
        names = QgsPalLayerSettings()
        names.fieldName = "site"
        text, halo = QgsTextFormat(), QgsTextBufferSettings()
        halo.setEnabled(True)
        text.setBuffer(halo)
        names.setFormat(text)
        layer.setLabeling(QgsVectorLayerSimpleLabeling(names))
        layer.setLabelsEnabled(True)
