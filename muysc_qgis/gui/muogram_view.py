"""The widget that shows a muogram and tells which pixel the mouse is on."""

from __future__ import annotations

from qgis.PyQt.QtCore import QEvent, QPointF, QRectF, QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import (
    QColor,
    QFont,
    QImage,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QTextOption,
)
from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from ..plots.directions import describe
from .compat import position_of
from .muogram_layout import Layout, Scene
from .muogram_picture import paint

#: Size (dots) of a picture that is copied or saved.
PICTURE_WIDTH, PICTURE_HEIGHT = 1600, 1200
_PICTURE_MARGIN = 40
_PICTURE_TEXT = 26


class MuogramView(QWidget):
    """Shows a muogram; without one, why there is none."""

    #: Row and column of the pixel under the mouse.
    hovered = pyqtSignal(int, int)
    #: The mouse is on no pixel any more.
    left = pyqtSignal()
    clicked = pyqtSignal(int, int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMouseTracking(True)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(220, 200)
        self._scene: Scene | None = None
        self._layout: Layout | None = None
        self._marked: tuple[int, int] | None = None
        #: Why there is no muogram.
        self.reason = ""

    def show_scene(self, scene: Scene) -> None:
        """Show a muogram."""
        self._scene = scene
        self.setCursor(Qt.CursorShape.CrossCursor)
        self.update()

    def show_reason(self, reason: str) -> None:
        """Show a sentence in place of a muogram."""
        self._scene, self._layout, self._marked, self.reason = None, None, None, reason
        self.unsetCursor()
        self.update()

    def mark(self, pixel: tuple[int, int] | None) -> None:
        """Point out a pixel."""
        self._marked = pixel
        self.update()

    def pixel_at(self, position: QPointF) -> tuple[int, int] | None:
        """Return row and column of the pixel at a place in the widget."""
        if self._scene is None or self._layout is None:
            return None
        return self._layout.pixel(position)

    def place_of(self, row: int, column: int) -> QPointF:
        """Return where in the widget a pixel's middle is."""
        if self._scene is None or self._layout is None:
            return QPointF()
        muogram = self._scene.muogram
        return self._layout.point(muogram.azimuth_deg[column], muogram.elevation_deg[row])

    def picture(self) -> QImage | None:
        """Return what is shown, black on white and large enough for a page."""
        if self._scene is None:
            return None
        image = QImage(PICTURE_WIDTH, PICTURE_HEIGHT, QImage.Format.Format_RGB32)
        image.fill(QColor("white"))
        painter = QPainter(image)
        font = QFont(self.font())
        font.setPixelSize(_PICTURE_TEXT)
        painter.setFont(font)
        palette = QPalette(QColor("white"))
        palette.setColor(QPalette.ColorRole.WindowText, QColor("black"))
        margin = _PICTURE_MARGIN
        room = QRectF(image.rect()).adjusted(margin, margin, -margin, -margin)
        lines = "\n".join(describe(self._scene.muogram))
        painter.setPen(QColor("black"))
        painter.drawText(room, lines, QTextOption())
        room.setTop(painter.boundingRect(room, lines, QTextOption()).bottom() + margin / 2)
        paint(painter, room, self._scene, palette)
        painter.end()
        return image

    # What Qt asks for.

    def sizeHint(self) -> QSize:
        return QSize(340, 320)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        room = QRectF(self.rect())
        if self._scene is None:
            painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
            option = QTextOption(Qt.AlignmentFlag.AlignCenter)
            painter.drawText(room.adjusted(12, 12, -12, -12), self.reason, option)
        else:
            self._layout = paint(painter, room, self._scene, self.palette(), self._marked)
        painter.end()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        pixel = self.pixel_at(position_of(event))
        if pixel is None:
            self._leave()
            return
        if pixel != self._marked:
            self.mark(pixel)
            self.hovered.emit(*pixel)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        pixel = self.pixel_at(position_of(event))
        if pixel is not None and event.button() == Qt.MouseButton.LeftButton:
            self.clicked.emit(*pixel)

    def leaveEvent(self, event: QEvent) -> None:
        self._leave()

    def _leave(self) -> None:
        if self._marked is not None:
            self.mark(None)
            self.left.emit()
