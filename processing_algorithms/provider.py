"""The Processing provider."""

from __future__ import annotations

from importlib import import_module

from qgis.core import Qgis, QgsMessageLog, QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from .base import ROOT
from .models import FILES, MuyscModel

#: Module and class of every algorithm, in the order of the toolbox.
ALGORITHMS = (
    ("radiography", "Radiography"),
    ("muonflux", "MuonFlux"),
    ("drape", "Drape"),
    ("downloadsrtm", "DownloadSrtm"),
    ("fluxspectrum", "FluxSpectrum"),
    ("importmuogram", "ImportMuogram"),
    ("density", "Density"),
    ("telescope", "Telescope"),
    ("expectedcounts", "ExpectedCounts"),
    ("radiographyatsites", "RadiographyAtSites"),
    ("siteselection", "SiteSelection"),
    ("tomography", "TomographyAlgorithm"),
    ("reconstructiontest", "ReconstructionTest"),
    ("reconstructionbenchmark", "ReconstructionBenchmark"),
)


class MuyscProvider(QgsProcessingProvider):
    """Muon radiography and tomography in the Processing toolbox."""

    def id(self) -> str:
        return "muysc"

    def name(self) -> str:
        return "MUYSC"

    def longName(self) -> str:
        return "MUYSC: muon radiography and tomography"

    def icon(self) -> QIcon:
        return QIcon(str(ROOT / "icon.svg"))

    def defaultRasterFileExtension(self) -> str:
        return "tif"

    def supportedOutputRasterLayerExtensions(self) -> list[str]:
        # Muograms describe themselves in tags that few other formats keep.
        return ["tif"]

    def defaultVectorFileExtension(self, has_geometry: bool = True) -> str:
        # Tables are text with units in the header.
        return super().defaultVectorFileExtension(has_geometry) if has_geometry else "csv"

    def loadAlgorithms(self) -> None:
        for module, name in ALGORITHMS:
            # One algorithm that cannot be loaded must not take the others down.
            try:
                algorithm = getattr(import_module(f".{module}", __package__), name)
                self.addAlgorithm(algorithm())
            except Exception as error:
                QgsMessageLog.logMessage(
                    f"The algorithm {module} cannot be loaded: {error!r}",
                    "MUYSC",
                    Qgis.MessageLevel.Critical,
                )
        for path in FILES:
            self.addAlgorithm(MuyscModel(path))

    def attach_models(self) -> None:
        """Complete the models, whose steps QGIS finds only in a registered provider."""
        for algorithm in self.algorithms():
            if isinstance(algorithm, MuyscModel):
                algorithm.attach()
