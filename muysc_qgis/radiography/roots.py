"""Many roots at once: halving, then the Illinois method.

M. Dowell & P. Jarratt (1971). A modified regula falsi method for computing the root of an
equation. BIT Numerical Mathematics, 11, 168–174. https://doi.org/10.1007/BF01934364
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

#: Relative accuracy of what the functions are logarithms of.
TOLERANCE = 1e-7

#: More steps than any root needs.
_STEPS = 100


def falling_roots(
    excess: Callable[[np.ndarray], np.ndarray],
    low: np.ndarray,
    high: np.ndarray,
    at_low: np.ndarray,
    at_high: np.ndarray,
    sought: np.ndarray,
    halvings: int,
) -> np.ndarray:
    """Return where functions that fall from `low` to `high` are 0 within `TOLERANCE`.

    Parameters
    ----------
    excess
        The functions, from and to arrays of the shape of all the others.
    low, high
        Ends; the root lies between them.
    at_low, at_high
        Functions at the ends.
    sought
        Where there is a root; elsewhere the result means nothing.
    halvings
        Steps before the faster search, 1 or more.
    """
    middle, before = low, np.zeros(low.shape, dtype=bool)
    for step in range(_STEPS):
        if step < halvings:
            middle = 0.5 * (low + high)
        else:
            with np.errstate(invalid="ignore", divide="ignore"):
                middle = (low * at_high - high * at_low) / (at_high - at_low)
            # Where nothing is sought there is no root between the ends.
            middle = np.clip(middle, low, high)
        at_middle = excess(middle)
        beyond = at_middle > 0
        # An end that stays for a second time counts half, so that it will move too.
        weight = np.where((beyond == before) & (step > halvings), 0.5, 1.0)
        at_high = np.where(beyond, weight * at_high, at_middle)
        at_low = np.where(beyond, at_middle, weight * at_low)
        before = beyond
        low, high = np.where(beyond, middle, low), np.where(beyond, high, middle)
        if not np.any((np.abs(at_middle) > TOLERANCE) & sought):
            break
    return middle
