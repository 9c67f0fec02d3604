"""Entry point of QGIS."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QCoreApplication

from .translation import install_translator

if TYPE_CHECKING:
    from qgis.PyQt.QtCore import QTranslator

    from ..processing_algorithms.provider import MuyscProvider
    from .gui.desktop import Desktop


class MuyscPlugin:
    """Adds the Processing provider; in the desktop and headless alike."""

    def __init__(self, iface: Any) -> None:
        """Keep the interface, which is None in qgis_process."""
        self.iface = iface
        self.provider: MuyscProvider | None = None
        self.desktop: Desktop | None = None
        # First of all, because algorithms and widgets take their texts when they are made.
        self.translator: QTranslator | None = install_translator()

    def initProcessing(self) -> None:  # noqa: N802 - QGIS calls it
        """Register the provider."""
        from ..processing_algorithms.provider import MuyscProvider

        self.provider = MuyscProvider()
        QgsApplication.processingRegistry().addProvider(self.provider)
        self.provider.attach_models()

    def initGui(self) -> None:  # noqa: N802 - QGIS calls it
        """Set up what the desktop needs."""
        self.initProcessing()
        # Widgets cannot even be imported where there is no desktop.
        from .gui.desktop import Desktop

        self.desktop = Desktop(self.iface)

    def unload(self) -> None:
        """Take everything out again."""
        if self.desktop is not None:
            self.desktop.remove()
            self.desktop = None
        if self.provider is not None:
            QgsApplication.processingRegistry().removeProvider(self.provider)
            self.provider = None
        if self.translator is not None:
            QCoreApplication.removeTranslator(self.translator)
            self.translator = None
