"""A muogram painted with axes, skyline, target and colour scale, on any Qt painter."""

from __future__ import annotations

import numpy as np
from qgis.PyQt.QtCore import QLineF, QPointF, QRectF, Qt
from qgis.PyQt.QtGui import (
    QColor,
    QFont,
    QFontInfo,
    QFontMetricsF,
    QPainter,
    QPalette,
    QPen,
    QPolygonF,
)

from ..plots import ticks
from ..plots.colours import has_colour
from ..plots.limits import colour_limits
from ..plots.style import SKY
from ..quantities import Quantity
from .colours import UNKNOWN, image_of, shades, share_along
from .muogram_layout import GAP, TICK, Layout, Scene
from .texts import tr

#: Points of the target's star: outer and inner radius in lines of text.
_STAR = (0.6, 0.25)

#: Side of the frame around a pixel at least (dots).
_SMALLEST_MARK = 7.0


def paint(
    painter: QPainter,
    room: QRectF,
    scene: Scene,
    palette: QPalette,
    marked: tuple[int, int] | None = None,
) -> Layout:
    """Paint a muogram into a room; return where its parts stand.

    Parameters
    ----------
    painter, room, scene
        With what, where and what.
    palette
        Colours of everything that is no data.
    marked
        Row and column of a pixel to point out.
    """
    layout = Layout.within(room, scene, painter.font())
    ink = palette.color(QPalette.ColorRole.WindowText)
    painter.drawImage(layout.frame, scene.image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    _paint_lines(painter, layout, scene)
    painter.setPen(QPen(ink, 1.0))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawRect(layout.frame)
    _paint_azimuths(painter, layout)
    _paint_elevations(painter, layout)
    _paint_scale(painter, layout, scene)
    painter.save()
    painter.setClipRect(layout.frame)
    _paint_target(painter, layout.point(*scene.target_deg))
    if marked is not None:
        _paint_mark(painter, layout.box(*marked))
    painter.restore()
    return layout


def skyline(sky: np.ndarray, known: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the sides of pixels between known rock and known sky.

    Returns
    -------
    tuple
        (n, 2) row and column of pixels whose upper side, and of those whose left side,
        parts rock from sky.
    """
    upright = (sky[1:] != sky[:-1]) & known[1:] & known[:-1]
    across = (sky[:, 1:] != sky[:, :-1]) & known[:, 1:] & known[:, :-1]
    return np.add(np.argwhere(upright), (1, 0)), np.add(np.argwhere(across), (0, 1))


def _paint_lines(painter: QPainter, layout: Layout, scene: Scene) -> None:
    """Paint the skyline, and the horizon."""
    below, beside = skyline(scene.sky, np.isfinite(scene.muogram.values) | scene.sky)
    lines = []
    for row, column in below.tolist():
        box = layout.box(row, column)
        lines.append(QLineF(box.topLeft(), box.topRight()))
    for row, column in beside.tolist():
        box = layout.box(row, column)
        lines.append(QLineF(box.topLeft(), box.bottomLeft()))
    painter.setPen(QPen(QColor("black"), 1.2))
    painter.drawLines(lines)
    left, right, low, high = layout.limits_deg
    if low < 0 < high:
        painter.setPen(QPen(QColor(128, 128, 128), 1.0, Qt.PenStyle.DashLine))
        painter.drawLine(QLineF(layout.point(left, 0.0), layout.point(right, 0.0)))


def _paint_azimuths(painter: QPainter, layout: Layout) -> None:
    metrics = QFontMetricsF(painter.font())
    line = metrics.height()
    left, right, low, high = layout.limits_deg
    frame = layout.frame
    room = metrics.horizontalAdvance("888°") * 1.15
    for azimuth in ticks.angle_ticks(left, right, max(2, int(frame.width() / room))):
        foot = layout.point(azimuth, low)
        painter.drawLine(QLineF(foot, foot + QPointF(0.0, line * TICK)))
        _centred(painter, ticks.azimuth_label(azimuth), foot.x(), foot.y() + line * TICK)
    _centred(
        painter, tr("Azimuth from north (°)"), frame.center().x(),
        frame.bottom() + line * (1 + TICK),
    )  # fmt: skip
    letters = ticks.compass_points(left, right)
    room = metrics.horizontalAdvance("WNW") * 1.3
    if len(letters) * room > frame.width():
        letters = [(azimuth, name) for azimuth, name in letters if len(name) < 3]
    for azimuth, name in letters:
        _centred(painter, name, layout.point(azimuth, high).x(), frame.top() - line)


def _paint_elevations(painter: QPainter, layout: Layout) -> None:
    metrics = QFontMetricsF(painter.font())
    line = metrics.height()
    left, _, low, high = layout.limits_deg
    frame = layout.frame
    widest = 0.0
    for elevation in ticks.angle_ticks(low, high, max(2, int(frame.height() / (1.7 * line)))):
        foot = layout.point(left, elevation)
        painter.drawLine(QLineF(foot, foot - QPointF(line * TICK, 0.0)))
        label = ticks.number_label(elevation)
        width = metrics.horizontalAdvance(label)
        widest = max(widest, width)
        painter.drawText(
            QPointF(
                foot.x() - line * (TICK + GAP / 2) - width,
                foot.y() + (metrics.ascent() - metrics.descent()) / 2,
            ),
            label,
        )
    painter.save()
    painter.translate(frame.left() - line * (1 + TICK + GAP) - widest, frame.center().y())
    painter.rotate(-90)
    _centred(painter, tr("Elevation (°)"), 0.0, 0.0)
    painter.restore()


def _paint_scale(painter: QPainter, layout: Layout, scene: Scene) -> None:
    """Paint the colour scale with its ticks below the picture."""
    metrics = QFontMetricsF(painter.font())
    line, bar, quantity = metrics.height(), layout.bar, scene.muogram.kind
    low, high = limits = colour_limits(scene.muogram.values, quantity)
    painter.drawImage(bar, image_of(shades(quantity)[None]))
    painter.drawRect(bar)
    if quantity.logarithmic:
        positions = ticks.logarithmic_ticks(low, high)
    else:
        positions = ticks.multiples(low, high, ticks.round_step(high - low, 5))
    labels = [ticks.number_label(position) for position in positions]
    room = max(map(metrics.horizontalAdvance, labels), default=0.0) * 1.3
    every = max(1, int(np.ceil(len(labels) * room / bar.width())))
    for at, label in [*zip(share_along(positions, quantity, limits).tolist(), labels)][::every]:
        foot = QPointF(bar.left() + at * bar.width(), bar.bottom())
        painter.drawLine(QLineF(foot, foot + QPointF(0.0, line * TICK)))
        _centred(painter, label, _inside(painter, layout, label, foot.x()), foot.y() + line * TICK)
    name = quantity_label(quantity)
    painter.save()
    _shrink(painter, name, layout.room.width())
    middle = _inside(painter, layout, name, bar.center().x())
    _centred(painter, name, middle, bar.bottom() + line * (1 + TICK))
    painter.restore()
    _paint_key(painter, QPointF(bar.center().x(), bar.bottom() + line * (2 + 2 * TICK)), scene)


def _paint_key(painter: QPainter, middle: QPointF, scene: Scene) -> None:
    """Paint what colours beside the scale mean, as far as they occur."""
    values = scene.muogram.values
    coloured = has_colour(values, scene.muogram.kind, scene.sky)
    entries = [
        (colour, text)
        for colour, text, present in (
            (SKY, tr("open sky"), np.any(scene.sky & ~coloured)),
            (UNKNOWN, tr("unknown"), np.any(~scene.sky & ~coloured)),
        )
        if present
    ]
    metrics = QFontMetricsF(painter.font())
    line = metrics.height()
    widths = [line * 1.2 + metrics.horizontalAdvance(text) for _, text in entries]
    x = middle.x() - (sum(widths) + line * (len(widths) - 1)) / 2
    for (colour, text), width in zip(entries, widths):
        swatch = QRectF(x, middle.y() + line * 0.15, line * 0.7, line * 0.7)
        painter.fillRect(swatch, QColor(colour))
        painter.drawRect(swatch)
        painter.drawText(QPointF(x + line, middle.y() + metrics.ascent()), text)
        x += width + line


def quantity_label(quantity: Quantity) -> str:
    """Return title and unit in the language of QGIS."""
    title = tr(quantity.title)
    return title if quantity.unit == "1" else f"{title} ({quantity.unit})"


def _shrink(painter: QPainter, text: str, width: float) -> None:
    """Take smaller letters for a text that would be too wide."""
    excess = QFontMetricsF(painter.font()).horizontalAdvance(text) / width
    if excess > 1:
        font = QFont(painter.font())
        font.setPixelSize(max(1, int(QFontInfo(font).pixelSize() / excess)))
        painter.setFont(font)


def _inside(painter: QPainter, layout: Layout, text: str, middle: float) -> float:
    """Return the middle of a text that must not reach out of the room."""
    half = QFontMetricsF(painter.font()).horizontalAdvance(text) / 2
    return max(layout.room.left() + half, min(middle, layout.room.right() - half))


def _centred(painter: QPainter, text: str, middle: float, top: float) -> None:
    """Write a line of text below a point."""
    metrics = QFontMetricsF(painter.font())
    left = middle - metrics.horizontalAdvance(text) / 2
    painter.drawText(QPointF(left, top + metrics.ascent()), text)


def _paint_target(painter: QPainter, middle: QPointF) -> None:
    """Paint a star, as panels do."""
    line = QFontMetricsF(painter.font()).height()
    corners = []
    for corner in range(10):
        angle = np.pi * corner / 5
        radius = line * _STAR[corner % 2]
        corners.append(middle + QPointF(radius * np.sin(angle), -radius * np.cos(angle)))
    painter.setPen(QPen(QColor("black"), 1.0))
    painter.setBrush(QColor("white"))
    painter.drawPolygon(QPolygonF(corners))


def _paint_mark(painter: QPainter, box: QRectF) -> None:
    """Frame a pixel, large enough to be seen."""
    margin = max(2.0, (_SMALLEST_MARK - box.width()) / 2)
    mark = box.adjusted(-margin, -margin, margin, margin)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for colour, thickness in (("black", 3.0), ("white", 1.4)):
        painter.setPen(QPen(QColor(colour), thickness))
        painter.drawRect(mark)
