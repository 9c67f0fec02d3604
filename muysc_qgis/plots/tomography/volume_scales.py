"""Colour scales of what voxels hold, one rule for every figure."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ...quantities import QUANTITIES, Quantity
from ...volume import VOLUME_QUANTITIES
from .. import ticks
from ..colours import colour_map, colour_scale

if TYPE_CHECKING:
    from matplotlib.cm import ScalarMappable

#: Share (%) of the values that a scale shows without its arrows.
_SHOWN_PERCENT = 99.5

#: Least half width of a diverging scale, g/cm³: differences below that are rounding.
_LEAST_SPREAD = 0.01

#: Blue below and red above the middle, as in the style of the raster.
_DIVERGING = replace(VOLUME_QUANTITIES["density"], colours="blue_red")


def diverging(values: np.ndarray, middle: float, least: float = _LEAST_SPREAD) -> ScalarMappable:
    """Return a scale that is white in the middle and as wide on both sides as values need.

    Parameters
    ----------
    values
        Any shape; what is not finite is left out.
    middle
        What white stands for.
    least
        Least half width.
    """
    apart = np.abs(values[np.isfinite(values)] - middle)
    most = float(np.percentile(apart, _SHOWN_PERCENT)) if apart.size else 0.0
    # Rounded up to a tenth of its decade, so that the ends are round numbers.
    step = ticks.round_step(max(most, least), 10)
    half = step * np.ceil(max(most, least) / step)
    if middle > 0:
        # No density is below 0.
        half = min(half, middle)
    return between(middle - half, middle + half)


def between(low: float, high: float) -> ScalarMappable:
    """Return a scale that is white in the middle between two limits."""
    return _scale(low, high, _DIVERGING)


def lengths(values: np.ndarray) -> ScalarMappable:
    """Return a scale from 0 to the largest value, in the colours of rock thickness."""
    return _from_zero(values, 100.0, QUANTITIES["thickness"])


def counted(values: np.ndarray) -> ScalarMappable:
    """Return the scale of rays per voxel."""
    return colour_scale(values, VOLUME_QUANTITIES["coverage"])


def errors(values: np.ndarray) -> ScalarMappable:
    """Return the scale of standard errors of densities, which begins at 0."""
    return _from_zero(values, _SHOWN_PERCENT, VOLUME_QUANTITIES["density_error"])


def _from_zero(values: np.ndarray, shown_percent: float, quantity: Quantity) -> ScalarMappable:
    known = values[np.isfinite(values)]
    most = float(np.percentile(known, shown_percent)) if known.size else 0.0
    return _scale(0.0, most or 1.0, quantity)


def _scale(low: float, high: float, quantity: Quantity) -> ScalarMappable:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    return ScalarMappable(Normalize(low, high), colour_map(quantity))
