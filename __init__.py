"""MUYSC for QGIS: muon radiography and tomography of large structures."""

from __future__ import annotations

from typing import Any


def classFactory(iface: Any) -> Any:  # noqa: N802 - QGIS asks for this name
    """Return the plugin; `iface` is None when QGIS runs without a desktop."""
    from .muysc_qgis.plugin import MuyscPlugin

    return MuyscPlugin(iface)
