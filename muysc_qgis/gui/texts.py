"""Texts of the desktop: their translation, and numbers as the dock writes them."""

from __future__ import annotations

import numpy as np

from ..plots.ticks import number_label
from ..quantities import Quantity
from ..translation import tr

#: Digits of a value: no flux model knows more.
_DIGITS = 3

#: So that a value and its unit stay on one line: no-break space, and slash with a joiner.
NO_BREAK = "\u00a0"
_NO_BREAK_SLASH = "/\u2060"


def rounded(value: float) -> str:
    """Return a value to three digits, “–” where it is unknown."""
    if not np.isfinite(value):
        return "–"
    return number_label(float(f"{value:.{_DIGITS}g}"))


def metres(value: float) -> str:
    """Return a length in whole metres, “–” where it is unknown."""
    return f"{bare_metres(value)}{NO_BREAK}m" if np.isfinite(value) else "–"


def days(value: float) -> str:
    """Return a time in days to three digits, “–” where it is unknown."""
    if not np.isfinite(value):
        return "–"
    return tr("{number} days").format(number=rounded(value)).replace(" ", NO_BREAK)


def with_unit(value: float, quantity: Quantity) -> str:
    """Return a value to three digits with the unit of its quantity."""
    if quantity.unit == "1" or not np.isfinite(value):
        return rounded(value)
    return f"{rounded(value)} {quantity.unit}".replace(" ", NO_BREAK).replace("/", _NO_BREAK_SLASH)


def bare_metres(value: float) -> str:
    """Return a length in whole metres without the unit, “–” where it is unknown."""
    return number_label(float(round(value))) if np.isfinite(value) else "–"
