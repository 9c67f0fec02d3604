"""What a muogram's picture shows, and where its parts stand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from qgis.PyQt.QtCore import QPointF, QRectF, QSizeF
from qgis.PyQt.QtGui import QFont, QFontMetricsF, QImage

from ..muogram import Muogram
from ..plots.directions import pixel_edges
from .colours import picture_of

#: Sizes as multiples of the height of a line of text.
GAP, TICK, _BAR = 0.3, 0.25, 0.7

#: What fits between the picture and the right edge of the room.
_MARGIN = "88"

#: Most that the picture is stretched upwards for a wide field of view, and squeezed.
_STRETCH = (0.7, 2.0)


@dataclass(frozen=True)
class Scene:
    """What there is to paint."""

    muogram: Muogram
    #: (n_elevation, n_azimuth), true where the ray meets no rock.
    sky: np.ndarray
    #: Azimuth and elevation of the target.
    target_deg: tuple[float, float]
    image: QImage

    @classmethod
    def of(cls, muogram: Muogram, opacity: Muogram) -> Scene:
        """Return the scene of a muogram; the opacity tells rock from sky."""
        sky = np.asarray(opacity.values == 0)
        target = muogram.number("BORESIGHT_AZIMUTH"), muogram.number("BORESIGHT_ELEVATION")
        return cls(muogram, sky, target, picture_of(muogram.values, muogram.kind, sky))

    @property
    def limits_deg(self) -> tuple[float, float, float, float]:
        """Azimuth at the left and right edge, elevation at the lower and upper."""
        azimuth = pixel_edges(self.muogram.azimuth_deg)
        elevation = pixel_edges(self.muogram.elevation_deg)
        return float(azimuth[0]), float(azimuth[-1]), float(elevation[-1]), float(elevation[0])


@dataclass(frozen=True)
class Layout:
    """Where the parts of a picture stand."""

    #: All that may be painted on.
    room: QRectF
    #: The pixels.
    frame: QRectF
    #: The colour scale.
    bar: QRectF
    #: Azimuth at the left and right edge, elevation at the lower and upper.
    limits_deg: tuple[float, float, float, float]
    #: Number of rows and columns of pixels.
    shape: tuple[int, ...]

    @classmethod
    def within(cls, room: QRectF, scene: Scene, font: QFont) -> Layout:
        """Return the layout that fills a room, as far as the angles allow."""
        metrics = QFontMetricsF(font)
        line = metrics.height()
        left, right, low, high = scene.limits_deg
        widest = max(metrics.horizontalAdvance(text) for text in ("−88", "888"))
        # The name of the elevation stands upright beside its labels.
        frame = room.adjusted(
            widest + line * (1 + TICK + 2 * GAP), line * (1 + GAP),
            -metrics.horizontalAdvance(_MARGIN), -line * (5 + _BAR + 3 * TICK + 2 * GAP),
        )  # fmt: skip
        true_height = frame.width() * (high - low) / (right - left)
        height = min(frame.height(), _STRETCH[1] * true_height)
        if height < _STRETCH[0] * true_height:
            width = height / _STRETCH[0] / true_height * frame.width()
            frame.setLeft(frame.left() + (frame.width() - width) / 2)
            frame.setWidth(width)
        frame.setHeight(max(height, 1.0))
        below = frame.bottom() + line * (2 + TICK + 2 * GAP)
        bar = QRectF(frame.left(), below, frame.width(), line * _BAR)
        return cls(room, frame, bar, scene.limits_deg, scene.sky.shape)

    def point(self, azimuth_deg: float, elevation_deg: float) -> QPointF:
        """Return where a direction stands."""
        left, right, low, high = self.limits_deg
        return QPointF(
            self.frame.left() + (azimuth_deg - left) / (right - left) * self.frame.width(),
            self.frame.bottom() - (elevation_deg - low) / (high - low) * self.frame.height(),
        )

    def box(self, row: int, column: int) -> QRectF:
        """Return where a pixel stands, or would stand below or right of the last."""
        rows, columns = self.shape
        width, height = self.frame.width() / columns, self.frame.height() / rows
        corner = self.frame.topLeft() + QPointF(column * width, row * height)
        return QRectF(corner, QSizeF(width, height))

    def pixel(self, point: QPointF) -> tuple[int, int] | None:
        """Return row and column of the pixel at a point, None beside the picture."""
        across = (point.x() - self.frame.left()) / self.frame.width()
        down = (point.y() - self.frame.top()) / self.frame.height()
        if not (0 <= across < 1 and 0 <= down < 1):
            return None
        return int(down * self.shape[0]), int(across * self.shape[1])
