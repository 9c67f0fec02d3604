"""Small widgets that several parts of the dock use."""

from __future__ import annotations

from collections.abc import Callable

from qgis.gui import QgsCollapsibleGroupBoxBasic
from qgis.PyQt.QtWidgets import QLabel, QToolButton

from .icons import icon


def icon_button(name: str, text: str, pressed: Callable[[], None]) -> QToolButton:
    """Return a button that shows its icon, and its text to those who ask."""
    button = QToolButton()
    button.setIcon(icon(name))
    button.setText(text)
    button.setToolTip(text)
    button.clicked.connect(lambda: pressed())
    return button


def folded_box(title: str = "") -> QgsCollapsibleGroupBoxBasic:
    """Return a box that opens when its title is pressed."""
    box = QgsCollapsibleGroupBoxBasic(title)
    box.setCollapsed(True)
    return box


def wrapping_label() -> QLabel:
    """Return a label that takes as many lines as its text needs."""
    label = QLabel()
    label.setWordWrap(True)
    return label
