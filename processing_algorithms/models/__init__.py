"""Models that come with the provider, as QGIS's designer saves them.

``tools/make_models.py`` makes the files.
"""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsProcessingModelAlgorithm
from qgis.PyQt.QtGui import QIcon

from ...muysc_qgis.translation import tr
from ..base import GROUP_ICONS, help_url
from ..language import english_help, english_label, translated

FILES = sorted(Path(__file__).parent.glob("*.model3"))


class MuyscModel(QgsProcessingModelAlgorithm):
    """A model under an id without spaces, in the language of QGIS.

    QGIS would take the id, the title and the way to save it from one name.
    """

    def __init__(self, path: Path) -> None:
        """Read a model, translated.

        Raises
        ------
        ValueError
            If the file holds no model.
        """
        super().__init__()
        self._path = path
        if not self.fromFile(str(path)):
            raise ValueError(f"{path.name} holds no model")
        self._english = [self.displayName(), self.group(), *self.helpContent().values()]
        for step in self.childAlgorithms().values():
            outputs = step.modelOutputs()
            for output in outputs.values():
                self._english.append(output.description())
                output.setDescription(tr(output.description()))
            step.setModelOutputs(outputs)
            self.setChildAlgorithm(step)
        self.setName(tr(self.displayName()))
        self.setGroup(tr(self.group()))
        self.setHelpContent({key: tr(text) for key, text in self.helpContent().items()})
        for definition in self.parameterDefinitions():
            translated(definition)

    def attach(self) -> None:
        """Find out what the steps hand over, once their provider is registered."""
        for step in self.childAlgorithms().values():
            step.reattach()
            self.setChildAlgorithm(step)
        self.updateDestinationParameters()

    def texts(self) -> list[str]:
        """Return everything that is translated, in English."""
        labels = [english_label(one) for one in self.parameterDefinitions()]
        helps = [english_help(one) for one in self.parameterDefinitions()]
        return [*self._english, *labels, *helps]

    def name(self) -> str:
        return self._path.stem

    def groupId(self) -> str:
        return "models"

    def icon(self) -> QIcon:
        return QIcon(str(GROUP_ICONS / "models.svg"))

    def helpUrl(self) -> str:
        return help_url(self.name())

    def createInstance(self) -> MuyscModel:
        return MuyscModel(self._path)
