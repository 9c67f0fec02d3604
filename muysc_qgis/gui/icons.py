"""The plugin's own icons, by name."""

from __future__ import annotations

from pathlib import Path

from qgis.PyQt.QtGui import QIcon

FOLDER = Path(__file__).resolve().parent.parent.parent / "icons"


def icon(name: str) -> QIcon:
    """Return an icon of the folder `icons`."""
    return QIcon(str(FOLDER / f"{name}.svg"))
