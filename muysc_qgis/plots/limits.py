"""Where colour scales begin and end: one rule for map styles, panels and reports.

Needs numpy alone, so that map styles work where matplotlib is missing.
"""

from __future__ import annotations

import numpy as np

from ..quantities import Quantity

#: Share of the values left outside the scale at each end, so that a few
#: extreme pixels do not take the contrast from all others (%).
_OUTSIDE_PERCENT = 0.5

#: Decades that a logarithmic scale spans at most: past that the mountain
#: itself would be left with a few shades.
_DECADES = 4.0
_DECADES_OF_DEPTH = 2.0

#: Quantities proportional to the rock crossed. They run towards zero at the
#: skyline, where nothing is to be seen: their upper decades are kept.
_DEPTHS = ("thickness", "opacity")

#: Decades between the sky and the scale at most: the flux falls by as many behind the
#: first few hundred metres of rock.
_DECADES_TO_THE_SKY = 2.5

#: Quantities that are largest in the thickest rock, and smallest in the sky.
_GROWING = ("exposure",)

#: What a telescope is to reach: the least is the best, and the lower decades are kept.
_GOALS = ("relative_error", "density_resolution", "contrast_days")

#: Counts of a whole picture, from the deepest rock to the sky: more decades, the upper.
_COUNTS = ("counts", "open_sky_counts")
_DECADES_OF_COUNTS = 5.0

#: Logarithmic scales narrower than this ratio count as a single value.
_SMALLEST_RATIO = 1.001


def colour_limits(values: np.ndarray, quantity: Quantity) -> tuple[float, float]:
    """Return the values at the two ends of a quantity's colour scale.

    Half a percent of the values is left out at each end. A logarithmic scale
    looks at positive values only and spans at most four decades: the upper
    ones for the minimum energy; for flux, transmission and exposure those of the
    thickest rock, so that the open sky is of one colour and the mountain is not,
    but beginning no more than two and a half decades from the sky. For thickness
    and opacity it is the upper two decades, for counts the upper five, and for
    errors and the time to see something the lower four.

    Parameters
    ----------
    values
        Any shape, in the quantity's unit; values that are not finite are left
        out, and on a logarithmic scale those of zero and less.
    quantity
        What the values are.

    Returns
    -------
    low, high
        Finite, low < high; positive on a logarithmic scale. Without a usable
        value 1 and 10 on a logarithmic scale, 0 and 1 on a linear one; around
        a single value half a decade, or half of it, on either side.
    """
    values = np.asarray(values, dtype=float)
    usable = np.isfinite(values)
    if quantity.logarithmic:
        usable &= np.greater(values, 0.0, where=usable, out=np.zeros_like(usable))
    chosen = values[usable]
    if chosen.size == 0:
        return (1.0, 10.0) if quantity.logarithmic else (0.0, 1.0)
    low = float(np.percentile(chosen, _OUTSIDE_PERCENT, method="lower"))
    high = float(np.percentile(chosen, 100.0 - _OUTSIDE_PERCENT, method="higher"))
    return _logarithmic(low, high, quantity) if quantity.logarithmic else _linear(low, high)


def _logarithmic(low: float, high: float, quantity: Quantity) -> tuple[float, float]:
    """Return limits of at most the decades allowed and at least a visible span."""
    if high < low * _SMALLEST_RATIO:
        return low / 10**0.5, high * 10**0.5
    depth = quantity.name in _DEPTHS
    counts = quantity.name in _COUNTS
    decades = _DECADES_OF_DEPTH if depth else _DECADES_OF_COUNTS if counts else _DECADES
    excess = np.log10(high / low) - decades
    if excess <= 0:
        return low, high
    if depth or counts or quantity.name == "minimum_energy":
        return high / 10**decades, high
    if quantity.name in _GOALS:
        return low, low * 10**decades
    left_out = 10 ** min(excess, _DECADES_TO_THE_SKY)
    if quantity.name in _GROWING:
        return low * left_out, low * left_out * 10**decades
    return high / left_out / 10**decades, high / left_out


def _linear(low: float, high: float) -> tuple[float, float]:
    """Return limits that differ enough to tell colours apart."""
    if high - low > 1e-9 * max(abs(low), abs(high)):
        return low, high
    margin = abs(low) / 2 or 0.5
    return low - margin, high + margin
