"""What the algorithms declare about themselves, for the scripts that write it down.

Needs QGIS.
"""

from __future__ import annotations

import importlib.util
import os
import sys
from dataclasses import dataclass
from pathlib import Path

from qgis.core import (
    QgsApplication,
    QgsProcessingAlgorithm,
    QgsProcessingOutputDefinition,
    QgsProcessingParameterDefinition,
    QgsProcessingProvider,
)

ROOT = Path(__file__).resolve().parent.parent
#: The package name is the folder's name, whatever that is; here it gets one.
ALIAS = "muysc"

_FLAGS = QgsProcessingParameterDefinition.Flag


def start_qgis(profile: str) -> QgsApplication:
    """Start QGIS in English without a window."""
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    os.environ["QGIS_CUSTOM_CONFIG_PATH"] = os.environ["XDG_RUNTIME_DIR"] = profile
    os.environ["LANG"] = os.environ["LC_ALL"] = "C.UTF-8"
    application = QgsApplication([], False, profile)
    application.initQgis()
    return application


def load_provider() -> QgsProcessingProvider:
    """Load the plugin as QGIS does and return its provider."""
    spec = importlib.util.spec_from_file_location(
        ALIAS, ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    package = sys.modules[ALIAS] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(package)
    plugin = package.classFactory(None)
    plugin.initProcessing()
    return plugin.provider


def in_order(provider: QgsProcessingProvider) -> list[QgsProcessingAlgorithm]:
    """Return the algorithms in the order of the toolbox."""
    order = [name for name, _ in sys.modules[f"{ALIAS}.processing_algorithms.provider"].ALGORITHMS]
    known = {one.name(): one for one in provider.algorithms()}
    return [known.pop(name) for name in order if name in known] + list(known.values())


@dataclass(frozen=True)
class Declared:
    """What an algorithm takes, and what it gives: files, and numbers and texts."""

    inputs: list[QgsProcessingParameterDefinition]
    files: list[QgsProcessingParameterDefinition]
    numbers: list[QgsProcessingOutputDefinition]


def declared_by(algorithm: QgsProcessingAlgorithm) -> Declared:
    """Return what an algorithm declares."""
    parameters = algorithm.parameterDefinitions()
    files = [one for one in parameters if one.isDestination()]
    written = {one.name() for one in files}
    return Declared(
        [one for one in parameters if not one.isDestination()],
        files,
        [one for one in algorithm.outputDefinitions() if one.name() not in written],
    )


def is_advanced(parameter: QgsProcessingParameterDefinition) -> bool:
    """Return whether a parameter stands under *Advanced* in the dialog."""
    return bool(parameter.flags() & _FLAGS.FlagAdvanced)


def options(parameter: QgsProcessingParameterDefinition) -> list[str]:
    """Return the words of a choice, none for other parameters."""
    return getattr(parameter, "options", list)()


def default(parameter: QgsProcessingParameterDefinition, optional: str) -> str:
    """Return the default as one would type it, `optional` where it may be left out."""
    value = parameter.defaultValue()
    if value is None or value == "":
        return optional if parameter.flags() & _FLAGS.FlagOptional else ""
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:g}" if isinstance(value, float) else str(value)
