"""Texts of the desktop: their translation, and numbers as the dock writes them."""

from __future__ import annotations

import numpy as np
from qgis.PyQt.QtCore import QCoreApplication

from ..plots.ticks import number_label
from ..quantities import Quantity

#: Context of every text in the files of translations.
_CONTEXT = "MUYSC"

#: Digits of a value: no flux model knows more.
_DIGITS = 3


def tr(text: str) -> str:
    """Return a text in the language of QGIS."""
    return str(QCoreApplication.translate(_CONTEXT, text))


def rounded(value: float) -> str:
    """Return a value to three digits, “–” where it is unknown."""
    if not np.isfinite(value):
        return "–"
    return number_label(float(f"{value:.{_DIGITS}g}"))


def metres(value: float) -> str:
    """Return a length in whole metres, “–” where it is unknown."""
    return f"{number_label(float(round(value)))} m" if np.isfinite(value) else "–"


def days(value: float) -> str:
    """Return a time in days to three digits, “–” where it is unknown."""
    return tr("{number} days").format(number=rounded(value)) if np.isfinite(value) else "–"


def with_unit(value: float, quantity: Quantity) -> str:
    """Return a value to three digits with the unit of its quantity."""
    unit = "" if quantity.unit == "1" or not np.isfinite(value) else f" {quantity.unit}"
    return rounded(value) + unit
