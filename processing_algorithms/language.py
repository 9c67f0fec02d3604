"""Parameters in the language of QGIS; reports and refusals keep to the English text."""

from __future__ import annotations

from qgis.core import QgsProcessingParameterDefinition

from ..muysc_qgis.translation import tr

#: Where a parameter keeps its English label and help.
_LABEL, _HELP = "muysc_label", "muysc_help"


def translated(definition: QgsProcessingParameterDefinition) -> QgsProcessingParameterDefinition:
    """Translate label and help of a parameter, and keep both in English beside."""
    label, text = definition.description(), definition.help()
    definition.setMetadata({**definition.metadata(), _LABEL: label, _HELP: text})
    definition.setDescription(tr(label))
    definition.setHelp(tr(text))
    return definition


def english_label(definition: QgsProcessingParameterDefinition) -> str:
    """Return the label as it was declared."""
    return str(definition.metadata().get(_LABEL, definition.description()))


def english_help(definition: QgsProcessingParameterDefinition) -> str:
    """Return the help as it was declared."""
    return str(definition.metadata().get(_HELP, definition.help()))
