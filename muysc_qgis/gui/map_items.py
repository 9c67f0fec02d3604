"""What the plan looks like on the map: markers, field of view, ray."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingContext,
    QgsProject,
)
from qgis.gui import QgsMapCanvas, QgsRubberBand, QgsVertexMarker
from qgis.PyQt import sip
from qgis.PyQt.QtGui import QColor

from ...processing_algorithms.parameters.transformation import passage
from ..plots.style import DETECTOR, GROUND_SEEN, RAY
from ..topography.footprint import Outline
from ..workflows.simulation import outlines
from .compat import LINES, POLYGONS
from .plan import Place
from .preview import Preview
from .sections import RaySection

#: Opacities (0 to 255) of the fill of a field of view, and of the ground seen in it.
_VEIL, _GROUND_VEIL = 40, 90

#: Lines along a ray, so that it is as bent on the map as it is on the ground.
_RAY_PARTS = 20

_ICON_SIZE = 14


class MapItems:
    """Everything that the dock draws on the canvas."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        self._canvas = canvas
        icons = QgsVertexMarker.IconType
        self._markers = {
            "detector": _marker(canvas, icons.ICON_TRIANGLE, DETECTOR),
            "target": _marker(canvas, icons.ICON_CROSS, RAY),
        }
        self._wedge = _band(canvas, POLYGONS, DETECTOR, _VEIL, 2)
        self._ground = _band(canvas, POLYGONS, GROUND_SEEN, _GROUND_VEIL, 1)
        self._air = _band(canvas, LINES, RAY, 255, 1)
        self._rock = _band(canvas, LINES, RAY, 255, 4)

    @property
    def markers(self) -> list[QgsVertexMarker]:
        """The detector's and the target's."""
        return [*self._markers.values()]

    @property
    def field_of_view(self) -> QgsGeometry:
        """The sector drawn, in the map's system."""
        return self._wedge.asGeometry()

    @property
    def ray_in_rock(self) -> QgsGeometry:
        """The stretches drawn of a ray in rock, in the map's system."""
        return self._rock.asGeometry()

    def show_place(self, role: str, place: Place | None) -> None:
        """Move the marker of the detector or the target, or hide it."""
        marker = self._markers[role]
        point = place and self._on_canvas([place.point], place.system)
        marker.setVisible(bool(point))
        if point:
            marker.setCenter(point[0])

    def marker_at(self, point: QgsPointXY, tolerance: float) -> str | None:
        """Return which marker stands within a distance, in units of the map."""
        near = {
            role: marker.center().distance(point)
            for role, marker in self._markers.items()
            if marker.isVisible()
        }
        role = min(near, key=lambda role: near[role], default=None)
        return role if role is not None and near[role] <= tolerance else None

    def show_view(self, preview: Preview) -> None:
        """Draw the field of view, and the ground seen in it."""
        inputs = preview.inputs
        sector, seen = outlines(preview.simulation, inputs.sight, inputs.aperture)
        for band, parts in ((self._wedge, [sector]), (self._ground, seen)):
            band.reset(POLYGONS)
            for part in parts:
                ring = self._ring(preview, part)
                if len(ring) > 3:
                    band.addGeometry(QgsGeometry.fromPolygonXY([ring]), None)

    def show_ray(self, section: RaySection) -> None:
        """Draw a ray up to where it leaves the last rock, thick where it is in rock."""
        self.hide_ray()
        reach = section.rock_m[-1, 1] if len(section.rock_m) else section.distance_m[-1]
        self._draw_ray(self._air, section, np.array([[0.0, reach]]))
        self._draw_ray(self._rock, section, section.rock_m)

    def hide_ray(self) -> None:
        """Take the ray off the map."""
        self._air.reset(LINES)
        self._rock.reset(LINES)

    def hide_view(self) -> None:
        """Take field of view and ray off the map."""
        self._wedge.reset(POLYGONS)
        self._ground.reset(POLYGONS)
        self.hide_ray()

    def remove(self) -> None:
        """Take everything off the canvas for good."""
        for item in (*self.markers, self._wedge, self._ground, self._air, self._rock):
            # Now, and not when Python comes across them, perhaps in another thread.
            sip.delete(item)

    def _draw_ray(self, band: QgsRubberBand, section: RaySection, parts: np.ndarray) -> None:
        for start, end in parts:
            along = np.linspace(start, end, _RAY_PARTS + 1)
            azimuth = np.full_like(along, section.azimuth_deg)
            line = self._around(section.preview, azimuth, along)
            if line:
                band.addGeometry(QgsGeometry.fromPolylineXY(line), None)

    def _ring(self, preview: Preview, outline: Outline) -> list[QgsPointXY]:
        ring = self._around(preview, outline.azimuth_deg, outline.distance_m)
        return [*ring, *ring[:1]]

    def _around(
        self, preview: Preview, azimuth_deg: np.ndarray, distance_m: np.ndarray
    ) -> list[QgsPointXY]:
        """Return points around the detector in the map's system, none where it does not reach.

        By the transformation that brought the detector from the map to the DEM.
        """
        frame = preview.inputs.sight.frame
        x, y = frame.dem.crs_position(*frame.ground_positions(azimuth_deg, distance_m))
        context = QgsProcessingContext()
        context.setProject(QgsProject.instance())
        on_map = self._canvas.mapSettings().destinationCrs()
        return passage("DETECTOR", on_map, frame.dem, preview.crs, context).from_dem(x, y)

    def _on_canvas(
        self, points: Iterable[QgsPointXY], crs: QgsCoordinateReferenceSystem
    ) -> list[QgsPointXY]:
        """Return points in the map's system, none where it does not reach."""
        to_map = QgsCoordinateTransform(
            crs, self._canvas.mapSettings().destinationCrs(), QgsProject.instance()
        )
        try:
            return [to_map.transform(point) for point in points]
        except QgsCsException:
            return []


def _marker(canvas: QgsMapCanvas, icon: QgsVertexMarker.IconType, colour: str) -> QgsVertexMarker:
    marker = QgsVertexMarker(canvas)
    marker.setIconType(icon)
    marker.setIconSize(_ICON_SIZE)
    marker.setPenWidth(3)
    marker.setColor(QColor(colour))
    marker.setFillColor(QColor(255, 255, 255, 160))
    marker.setVisible(False)
    return marker


def _band(
    canvas: QgsMapCanvas, kind: object, colour: str, opacity: int, width: int
) -> QgsRubberBand:
    band = QgsRubberBand(canvas, kind)
    stroke, fill = QColor(colour), QColor(colour)
    fill.setAlpha(opacity)
    band.setStrokeColor(stroke)
    band.setFillColor(fill)
    band.setWidth(width)
    return band
