"""Entry point of QGIS."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from qgis.core import QgsApplication

if TYPE_CHECKING:
    from ..processing_algorithms.provider import MuyscProvider


class MuyscPlugin:
    """Adds the Processing provider; in the desktop and headless alike."""

    def __init__(self, iface: Any) -> None:
        """Keep the interface, which is None in qgis_process."""
        self.iface = iface
        self.provider: MuyscProvider | None = None

    def initProcessing(self) -> None:  # noqa: N802 - QGIS calls it
        """Register the provider."""
        from ..processing_algorithms.provider import MuyscProvider

        self.provider = MuyscProvider()
        QgsApplication.processingRegistry().addProvider(self.provider)

    def initGui(self) -> None:  # noqa: N802 - QGIS calls it
        """Set up what the desktop needs."""
        self.initProcessing()

    def unload(self) -> None:
        """Take everything out again."""
        if self.provider is not None:
            QgsApplication.processingRegistry().removeProvider(self.provider)
            self.provider = None
