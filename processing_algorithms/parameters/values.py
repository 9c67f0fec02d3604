"""Single parameters: declaring them with help, reading them with a sentence."""

from __future__ import annotations

import math
from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterNumber,
)

from ...muysc_qgis.errors import MuyscError
from ..compat import ADVANCED
from ..language import english_help

#: Digits after the point in dialogs; scripts may give more.
_DECIMALS = 3


def explained(
    parameter: QgsProcessingParameterDefinition, text: str, advanced: bool = False
) -> QgsProcessingParameterDefinition:
    """Give a parameter its help text and, where rarely used, the advanced flag."""
    parameter.setHelp(text)
    if advanced:
        parameter.setFlags(parameter.flags() | ADVANCED)
    return parameter


def number(
    name: str,
    label: str,
    text: str,
    default: float | None,
    low: float | None = None,
    high: float | None = None,
    advanced: bool = False,
    whole: bool = False,
) -> QgsProcessingParameterDefinition:
    """Return a number parameter; optional where the default is None."""
    kinds = QgsProcessingParameterNumber.Type
    parameter = QgsProcessingParameterNumber(
        name, label, kinds.Integer if whole else kinds.Double, default, default is None
    )
    if low is not None:
        parameter.setMinimum(low)
    if high is not None:
        parameter.setMaximum(high)
    if not whole:
        parameter.setMetadata({"widget_wrapper": {"decimals": _DECIMALS}})
    return explained(parameter, text, advanced)


def choice(
    name: str, label: str, text: str, options: list[str], default: str, advanced: bool = False
) -> QgsProcessingParameterDefinition:
    """Return an enumeration that is stored as the word chosen."""
    parameter = QgsProcessingParameterEnum(
        name, label, options, defaultValue=default, usesStaticStrings=True
    )
    return explained(parameter, text, advanced)


def choices(
    name: str, label: str, text: str, options: list[str], default: list[str], advanced: bool = False
) -> QgsProcessingParameterDefinition:
    """Return an enumeration of which several words may be chosen."""
    parameter = QgsProcessingParameterEnum(
        name, label, options, True, default, True, usesStaticStrings=True
    )
    return explained(parameter, text, advanced)


def switch(
    name: str, label: str, text: str, default: bool, advanced: bool = False
) -> QgsProcessingParameterDefinition:
    """Return a yes-or-no parameter."""
    return explained(QgsProcessingParameterBoolean(name, label, default), text, advanced)


def given(parameters: dict[str, Any], name: str) -> bool:
    """Return whether a parameter has a value of its own."""
    return parameters.get(name) not in (None, "")


def read_number(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> float:
    """Return a number that has a default.

    QGIS would take its default for a text that is no number; this refuses it.

    Raises
    ------
    MuyscError
        If the value is no finite number.
    """
    raw = parameters.get(name)
    value = algorithm.parameterAsDouble(parameters, name, context)
    if isinstance(raw, str):
        try:
            value = float(raw)
        except ValueError:
            value = math.nan
    if not math.isfinite(value):
        remedy = english_help(algorithm.parameterDefinition(name))
        raise MuyscError(
            f"{name} is “{raw}”, which is not a finite number; {remedy[0].lower()}{remedy[1:]}"
        )
    return value


def read_optional(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> float | None:
    """Return a number, None where it is empty and has no default; see `read_number`."""
    if not given(parameters, name) and algorithm.parameterDefinition(name).defaultValue() is None:
        return None
    return read_number(algorithm, parameters, name, context)


def read_count(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> int:
    """Return a whole number.

    Raises
    ------
    MuyscError
        If the value is no whole number.
    """
    value = read_number(algorithm, parameters, name, context)
    if value != round(value):
        raise MuyscError(f"{name} is {value}, which is not a whole number; round it.")
    return int(value)


def read_within(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> float | None:
    """Return a number within the limits of its parameter, None where an optional one is empty.

    QGIS refuses what is outside without telling the limits; the parameter's help has them.

    Raises
    ------
    MuyscError
        If the value is no number within the limits, or no whole one where it must be.
    """
    definition = algorithm.parameterDefinition(name)
    whole = definition.dataType() == QgsProcessingParameterNumber.Type.Integer
    value = (read_count if whole else read_optional)(algorithm, parameters, name, context)
    if value is not None and not definition.minimum() <= value <= definition.maximum():
        remedy = english_help(definition).partition(". ")[0].rstrip(".")
        raise MuyscError(f"{name} is {value:g}; {remedy[0].lower()}{remedy[1:]}.")
    return value


def read_choice(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> str:
    """Return the word chosen.

    Raises
    ------
    MuyscError
        If it is not one of the options, which QGIS would replace by the default.
    """
    raw = parameters.get(name)
    options = algorithm.parameterDefinition(name).options()
    if isinstance(raw, str) and raw and raw not in options:
        raise MuyscError(f"{name} is “{raw}”; use one of {', '.join(options)}.")
    return algorithm.parameterAsEnumString(parameters, name, context)


def read_choices(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> list[str]:
    """Return the words chosen, none where the list is empty.

    Raises
    ------
    MuyscError
        If a word is not one of the options, which QGIS would leave out.
    """
    raw = parameters.get(name)
    options = algorithm.parameterDefinition(name).options()
    words = raw.split(",") if isinstance(raw, str) else raw if isinstance(raw, list) else []
    for word in words:
        if isinstance(word, str) and word.strip() not in ("", *options):
            raise MuyscError(f"{name} names “{word}”; use some of {', '.join(options)}.")
    if isinstance(raw, str) or raw == []:
        return [word.strip() for word in words if word.strip()]
    return list(algorithm.parameterAsEnumStrings(parameters, name, context))
