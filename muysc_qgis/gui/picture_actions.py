"""Copying and saving a picture."""

from __future__ import annotations

from qgis.PyQt.QtGui import QImage
from qgis.PyQt.QtWidgets import QApplication, QFileDialog, QMessageBox, QWidget

from .texts import tr


def copy_picture(image: QImage) -> None:
    """Put a picture on the clipboard."""
    QApplication.clipboard().setImage(image)


def save_picture(parent: QWidget, image: QImage) -> None:
    """Ask for a file and save a picture in it."""
    path, _ = QFileDialog.getSaveFileName(parent, tr("Save picture"), "", "PNG (*.png)")
    if not path:
        return
    if not path.lower().endswith(".png"):
        path += ".png"
    if not image.save(path, "PNG"):
        QMessageBox.warning(
            parent,
            tr("Save picture"),
            tr("{path} cannot be written; choose another folder or close the file.").format(
                path=path
            ),
        )
