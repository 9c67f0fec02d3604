"""Round numbers: tick and contour steps, number labels, compass points.

Needs numpy alone; every figure reads its ticks here, so that they look alike.
"""

from __future__ import annotations

import numpy as np

from ..quantities import Quantity

#: Steps of angular axes (degrees); all from 1 up divide 90, so that zenith and
#: elevation ticks stand on the same lines.
_ANGLE_STEPS_DEG = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0)

#: The sixteen compass points, clockwise from north.
_COMPASS = (
    "N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
    "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW",
)  # fmt: skip

_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

#: Quantities whose contours run in equal steps rather than in decades.
_EQUAL_STEPS = ("thickness", "opacity", "distance", "density")


def round_step(span: float, count: int) -> float:
    """Return the smallest 1, 2 or 5 × 10ⁿ that divides `span` into at most `count` parts.

    Parameters
    ----------
    span
        Positive length of the range.
    count
        Largest number of steps.
    """
    least = span / count
    decade = 10.0 ** np.floor(np.log10(least))
    # The factor absorbs rounding, so that 1.0 in ten parts gives 0.1 and not 0.2.
    return float(next(m * decade for m in (1, 2, 5, 10) if m * decade >= least * (1 - 1e-9)))


def multiples(low: float, high: float, step: float) -> np.ndarray:
    """Return the multiples of `step` from `low` to `high`, both included."""
    # No more than that, however small the range is beside its ends.
    slack = min(1e-9 * max(abs(low), abs(high), step) / step, 0.1)
    return step * np.arange(np.ceil(low / step - slack), np.floor(high / step + slack) + 1)


def angle_ticks(low_deg: float, high_deg: float, count: int) -> np.ndarray:
    """Return at most `count` + 1 ticks at a round angular step (degrees)."""
    span = high_deg - low_deg
    step = next((s for s in _ANGLE_STEPS_DEG if span / s <= count), _ANGLE_STEPS_DEG[-1])
    return multiples(low_deg, high_deg, step)


def logarithmic_ticks(low: float, high: float) -> np.ndarray:
    """Return ticks for a logarithmic scale: decades, or 1-2-5, or a round step.

    Parameters
    ----------
    low, high
        0 < low < high.
    """
    decades = 10.0 ** np.arange(np.floor(np.log10(low)), np.ceil(np.log10(high)) + 1)
    for parts in ((1.0,), (1.0, 3.0), (1.0, 2.0, 5.0)):
        ticks = np.outer(decades, parts).ravel()
        ticks = ticks[(ticks >= low * (1 - 1e-9)) & (ticks <= high * (1 + 1e-9))]
        if len(ticks) >= 3:
            return ticks
    return multiples(low, high, round_step(high - low, 5))


def contour_levels(values: np.ndarray, quantity: Quantity, count: int = 9) -> np.ndarray:
    """Return round levels for contour lines inside the range of the values.

    Thickness, opacity, distance and density step by 1, 2 or 5 × 10ⁿ; all other
    quantities, which change by orders of magnitude, by decades.

    Parameters
    ----------
    values
        Any shape; values that are not finite are left out.
    quantity
        What the values are.
    count
        Largest number of equal steps.

    Returns
    -------
    Increasing levels strictly inside the range; empty where there is none.
    """
    finite = values[np.isfinite(values)]
    if quantity.name not in _EQUAL_STEPS:
        finite = finite[finite > 0]
    if finite.size == 0:
        return np.empty(0)
    low, high = float(finite.min()), float(finite.max())
    if quantity.name in _EQUAL_STEPS:
        if high - low <= 1e-9 * max(abs(low), abs(high)):
            return np.empty(0)
        # Rock begins at no thickness at all, wherever the first pixel stands.
        floor = 0.0 if quantity.logarithmic else low
        levels = multiples(low, high, round_step(high - floor, count))
    else:
        levels = 10.0 ** np.arange(np.ceil(np.log10(low)), np.floor(np.log10(high)) + 1)
    return levels[(levels > low) & (levels < high)]


def number_label(value: float) -> str:
    """Return a short label: plain from 0.0001 to 999 999, else as a power of ten."""
    if value == 0:
        return "0"
    if 0.99e-4 < abs(value) < 1e6:
        if abs(value) >= 1e4:
            return f"{value:,.0f}".replace(",", "\u202f").replace("-", "−")
        return f"{value:.6g}".replace("-", "−")
    exponent = int(np.floor(np.log10(abs(value)) + 1e-9))
    mantissa = f"{value / 10.0**exponent:.3g}".replace("-", "−")
    power = power_of_ten(exponent)
    return power if mantissa == "1" else f"{mantissa}·{power}"


def power_of_ten(exponent: int) -> str:
    """Return a power of ten as text: “10⁻⁵”."""
    return "10" + str(exponent).translate(_SUPERSCRIPTS)


def azimuth_label(azimuth_deg: float) -> str:
    """Return an azimuth that may run past north as 0° to 360° (360 itself is 0)."""
    return f"{number_label(round(azimuth_deg % 360.0, 6) % 360.0)}°"


def compass_points(low_deg: float, high_deg: float) -> list[tuple[float, str]]:
    """Return the compass points inside a range of azimuths, which may cross north.

    All sixteen points up to 100°, the eight main ones up to a full turn.

    Returns
    -------
    Pairs of azimuth, continuous with the range (degrees), and letters.
    """
    step = 22.5 if high_deg - low_deg <= 100 else 45.0
    return [
        (float(azimuth), _COMPASS[round(azimuth % 360.0 / 22.5) % 16])
        for azimuth in multiples(low_deg, high_deg, step)
    ]
