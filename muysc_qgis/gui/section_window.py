"""The terrain profile of a ray, in a window of its own."""

from __future__ import annotations

from qgis.PyQt.QtCore import QRectF, QSize, Qt
from qgis.PyQt.QtGui import QImage, QPainter, QPaintEvent
from qgis.PyQt.QtWidgets import QDialog, QDialogButtonBox, QVBoxLayout, QWidget

from .background import Background
from .picture_actions import copy_picture, save_picture
from .sections import RaySection
from .texts import tr
from .widgets import wrapping_label


class _Picture(QWidget):
    """Shows a picture as large as its room, in its own shape."""

    def __init__(self) -> None:
        super().__init__()
        self.image = QImage()
        self.setMinimumSize(280, 120)

    def sizeHint(self) -> QSize:
        return QSize(900, 420)

    def paintEvent(self, event: QPaintEvent) -> None:
        if self.image.isNull():
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        size = self.image.size().scaled(self.size(), Qt.AspectRatioMode.KeepAspectRatio)
        room = QRectF(self.rect())
        left, top = (room.width() - size.width()) / 2, (room.height() - size.height()) / 2
        # Smaller by halves first: painters look at four neighbours only.
        shown = self.image
        while shown.width() > 2 * size.width():
            shown = shown.scaled(
                shown.size() / 2,
                Qt.AspectRatioMode.KeepAspectRatio,
                Qt.TransformationMode.SmoothTransformation,
            )
        painter.drawImage(QRectF(left, top, size.width(), size.height()), shown)
        painter.end()


class SectionWindow(QDialog):
    """Shows the section along the ray that was clicked last."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Section along a ray"))
        self.picture = _Picture()
        self.told = wrapping_label()
        self.told.setVisible(False)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        roles = QDialogButtonBox.ButtonRole
        self._copy = buttons.addButton(tr("Copy picture"), roles.ActionRole)
        self._save = buttons.addButton(tr("Save picture…"), roles.ActionRole)
        self._copy.clicked.connect(lambda: copy_picture(self.picture.image))
        self._save.clicked.connect(lambda: save_picture(self, self.picture.image))
        buttons.rejected.connect(self.close)
        layout = QVBoxLayout(self)
        layout.addWidget(self.picture, 1)
        layout.addWidget(self.told)
        layout.addWidget(buttons)
        self._background = Background(self)
        self._background.computed.connect(self._show_png)
        self._background.failed.connect(self._show_reason)

    @property
    def busy(self) -> bool:
        """Whether a section is being drawn."""
        return self._background.busy

    def show_section(self, section: RaySection) -> None:
        """Draw a section, and come up."""
        self._background.submit(lambda: lambda progress: section.figure_png())
        self.show()
        self.raise_()

    def release(self) -> None:
        """Stop drawing for good."""
        self._background.close()
        self.close()

    def _show_png(self, png: bytes) -> None:
        self._show(QImage.fromData(png), "")

    def _show_reason(self, reason: str) -> None:
        self._show(QImage(), reason)

    def _show(self, image: QImage, reason: str) -> None:
        self.picture.image = image
        self.picture.update()
        self.told.setText(reason)
        self.told.setVisible(bool(reason))
        self._copy.setEnabled(not image.isNull())
        self._save.setEnabled(not image.isNull())
