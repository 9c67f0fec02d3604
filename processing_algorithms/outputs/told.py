"""Parameters of a run as its report tells them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterPoint,
    QgsProcessingParameterRasterLayer,
)

from ...muysc_qgis.radiography.gaisser import GAISSER_PARAMETERS
from ...muysc_qgis.radiography.materials import MATERIALS
from ...muysc_qgis.radiography.spectra import MODELS
from ...muysc_qgis.telescope.presets import CUSTOM, PRESETS
from ...muysc_qgis.tomography.counting import COUNTS, COUNTS_TITLE
from ...muysc_qgis.tomography.solvers import METHODS
from ..language import english_label
from ..parameters.telescope import NONE, SIZES
from ..parameters.values import given

#: Units that labels of parameters end with, and what comes before the stand-in for no value.
_UNITS = ("m", "cm", "°", "g/cm³", "cm² sr", "GeV", "days", "%", "GiB")
_EMPTY = "empty: "

#: What the words of enumerations are called, by parameter.
_TITLED: dict[str, Mapping[str, Any]] = {
    "MATERIAL": MATERIALS,
    "FLUX_MODEL": MODELS,
    "GAISSER_PARAMETERS": GAISSER_PARAMETERS,
    "PRESET": PRESETS,
    "METHOD": METHODS,
}

#: Parameters that count for some words of another one alone.
_ART = ("art", "bart", "sart", "sirt")
_PENALISED = ("pml-quad", "pml-hybrid", "ospml-quad", "ospml-hybrid")
_ONLY_FOR: dict[str, dict[str, tuple[str, ...]]] = {
    "METHOD": {
        "RELAXATION": _ART,
        "REGULARIZATION": (*_PENALISED, "tv", "grad", "tikhonov", "lsmr"),
        "SUBSETS": ("bart", "osem", "ospml-quad", "ospml-hybrid"),
        "EDGE_DENSITY": ("pml-hybrid", "ospml-hybrid"),
        "PRIOR_DEVIATION": ("bayes", COUNTS),
        "CORRELATION_LENGTH": ("bayes", COUNTS),
        "EFFICIENCY": (COUNTS,),
        "DRAWS": (COUNTS,),
        "MEAN_DEVIATION": (COUNTS,),
        "STATION_ERROR": (COUNTS,),
        "FLUX_ERROR": (COUNTS,),
        "POINTING_ERROR": (COUNTS,),
        "TERRAIN_ERROR": (COUNTS,),
        "TERRAIN_LENGTH": (COUNTS,),
        "POSTERIOR_SAMPLES": ("bayes",),
    },
    "MODEL": {
        "BODY_DENSITY": ("checkerboard", "conduit", "sphere"),
        "BODY_RADIUS": ("conduit", "sphere"),
        "BODY_EDGE": ("checkerboard",),
        "BODY_POSITION": ("conduit", "sphere"),
        "BODY_BASE": ("conduit",),
        "BODY_TOP": ("conduit",),
        "BODY_MIDDLE": ("sphere",),
    },
}

#: Files of a list that are named; of more, the first ones and how many there are.
_NAMED_FILES = 8


def told(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> list[tuple[str, str | float | bool, str]]:
    """Return label, value and unit of every input parameter that counts.

    Where a parameter is empty, the value says what stands for it.
    """
    rows: list[tuple[str, str | float | bool, str]] = []
    left_out = _without_effect(algorithm, parameters, context)
    for definition in algorithm.parameterDefinitions():
        if definition.isDestination() or definition.name() in left_out:
            continue
        label, unit, otherwise = _split_label(english_label(definition))
        value = parameters.get(definition.name())
        if value is None or value == "":
            value = definition.defaultValue()
        if value is not None and value != "":
            rows.append((label, _value(algorithm, definition, value, context), unit))
        elif otherwise:
            rows.append((label, otherwise, ""))
    return rows


def _value(
    algorithm: QgsProcessingAlgorithm,
    definition: QgsProcessingParameterDefinition,
    value: Any,
    context: QgsProcessingContext,
) -> str | float | bool:
    """Return the value of a parameter as a reader knows it: names rather than words of scripts."""
    read = ({definition.name(): value}, definition.name(), context)
    if isinstance(definition, QgsProcessingParameterBoolean):
        return bool(algorithm.parameterAsBool(*read))
    if isinstance(definition, QgsProcessingParameterNumber):
        return float(algorithm.parameterAsDouble(*read))
    if isinstance(definition, QgsProcessingParameterPoint):
        point, crs = algorithm.parameterAsPoint(*read), algorithm.parameterAsPointCrs(*read)
        place = f"{point.x():.10g}, {point.y():.10g}".replace("-", "−")
        return f"{place} ({crs.authid() or crs.description()})" if crs.isValid() else place
    if isinstance(definition, QgsProcessingParameterRasterLayer):
        layer = algorithm.parameterAsRasterLayer(*read)
        return str(value) if layer is None else Path(layer.source()).name
    if isinstance(definition, QgsProcessingParameterMultipleLayers):
        return _files([layer.source() for layer in algorithm.parameterAsLayerList(*read)])
    if isinstance(definition, QgsProcessingParameterFeatureSource) and isinstance(value, str):
        return _files([value])
    if isinstance(definition, QgsProcessingParameterEnum) and isinstance(value, str):
        return _title(definition.name(), value)
    if isinstance(value, (str, float, int)):
        return value
    if isinstance(value, list) and all(isinstance(one, (str, int, float)) for one in value):
        return ", ".join(map(str, value))
    return str(definition.valueAsPythonString(value, context)).strip("'")


def _files(sources: list[str]) -> str:
    """Return the names of files, without their folders and what follows them."""
    names = [Path(source.partition("|")[0]).name for source in sources]
    if len(names) <= _NAMED_FILES:
        return ", ".join(names)
    return f"{', '.join(names[: _NAMED_FILES - 1])} and {len(names) - _NAMED_FILES + 1} more"


def _title(name: str, word: str) -> str:
    """Return what a word of an enumeration is called."""
    from ...muysc_qgis.plots.spectra.losses import LAW_TITLES

    if name == "ENERGY_LOSS":
        return LAW_TITLES.get(word, word)
    if (name, word) == ("METHOD", COUNTS):
        return COUNTS_TITLE
    known = _TITLED.get(name, {}).get(word)
    return word.replace("_", " ") if known is None else known.title


def _split_label(label: str) -> tuple[str, str, str]:
    """Return “Density (g/cm³, empty: its own)” as label, unit and what stands for no value."""
    match = re.match(r"^(.*?) \((.*)\)$", label)
    if match is None:
        return label, "", ""
    inside, _, otherwise = match.group(2).partition(_EMPTY)
    unit = inside.split(",")[0]
    if unit in _UNITS or (otherwise and not unit):
        return match.group(1), unit, otherwise
    return label, "", ""


def _without_effect(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> set[str]:
    """Return the parameters that other choices leave without a meaning."""

    def chosen(name: str) -> str | None:
        if not isinstance(algorithm.parameterDefinition(name), QgsProcessingParameterEnum):
            return None
        return str(algorithm.parameterAsEnumString(parameters, name, context))

    names: set[str] = set()
    definitions = {one.name() for one in algorithm.parameterDefinitions()}
    preset, model = chosen("PRESET"), chosen("FLUX_MODEL")
    if preset not in (None, CUSTOM):
        names |= {*SIZES, *(["FORMULA"] if preset == NONE else [])}
    if model is not None and not model.startswith("gaisser"):
        names.add("GAISSER_PARAMETERS")
    if model is not None and MODELS[model].tabulated:
        names.add("ALTITUDE_CORRECTION")
    for choice, dependent in _ONLY_FOR.items():
        word = chosen(choice)
        if word is not None:
            names |= {name for name, words in dependent.items() if word not in words}
    if given(parameters, "SITES"):
        # A layer of sites stands in for the ring.
        names |= {name for name in definitions if name.startswith("RING_")}
    return names
