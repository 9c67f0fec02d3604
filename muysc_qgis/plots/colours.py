"""matplotlib colours of a quantity, and the picture of a muogram's pixels."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..quantities import COLOUR_STOPS, Quantity
from .limits import colour_limits
from .style import SKY, rgb

if TYPE_CHECKING:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Colormap

#: Rounding of a ratio kept in single precision.
_ROUNDING = 1e-6


def colour_map(quantity: Quantity) -> Colormap:
    """Return the colours of a quantity from low to high."""
    from matplotlib.colors import LinearSegmentedColormap

    return LinearSegmentedColormap.from_list(
        quantity.colours, COLOUR_STOPS[quantity.colours], N=256
    )


def colour_scale(values: np.ndarray, quantity: Quantity) -> ScalarMappable:
    """Return the colour scale of a quantity spanning `colour_limits`.

    Parameters
    ----------
    values
        Any shape, in the quantity's unit.
    quantity
        What the values are.
    """
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LogNorm, Normalize

    low, high = colour_limits(values, quantity)
    norm = LogNorm(low, high) if quantity.logarithmic else Normalize(low, high)
    return ScalarMappable(norm, colour_map(quantity))


def has_colour(values: np.ndarray, quantity: Quantity, sky: np.ndarray | None) -> np.ndarray:
    """Return which pixels take their colour from the scale.

    Not those that are unknown, and not those of open sky without a value that
    the scale could show, such as a thickness of zero. A zero under rock (no
    counts, say) takes the lowest colour.
    """
    known = np.isfinite(values)
    if sky is None:
        return known
    shown = np.greater(values, 0.0, where=known, out=np.zeros_like(known))
    return np.where(sky, shown if quantity.logarithmic else known, known)


def pixel_colours(
    values: np.ndarray, quantity: Quantity, sky: np.ndarray | None, scale: ScalarMappable
) -> np.ndarray:
    """Return the picture of a muogram: one colour a pixel.

    Parameters
    ----------
    values
        (n_elevation, n_azimuth), in the quantity's unit; NaN where unknown.
    quantity
        What the values are.
    sky
        (n_elevation, n_azimuth), true where the ray meets no rock; None where
        that is not known.
    scale
        From `colour_scale`.

    Returns
    -------
    (n_elevation, n_azimuth, 4) bytes, red, green, blue and alpha: the scale's
    colour, the colour of the sky, or transparent where unknown.
    """
    low, _ = scale.get_clim()
    coloured = has_colour(values, quantity, sky)
    # Zero has no logarithm; the lower end stands for it and all below.
    shown = np.maximum(np.where(coloured, values, low), low)
    picture = scale.to_rgba(shown, bytes=True)
    picture[~coloured] = 0
    if sky is not None:
        picture[sky & ~coloured] = (*rgb(SKY), 255)
    return picture


def sky_mask(values: np.ndarray, quantity: Quantity) -> np.ndarray | None:
    """Return where the rays meet no rock, if the quantity can tell, else None.

    Thickness and opacity are zero there, and the transmission is 1 to within
    the rounding of a raster's single precision.
    """
    if quantity.name in ("thickness", "opacity"):
        return np.asarray(values == 0.0)
    if quantity.name == "transmission":
        return np.asarray(values > 1.0 - _ROUNDING)
    return None


def ink_on(rgba: tuple[float, ...]) -> str:
    """Return black or white, whichever stands out from a colour.

    By the luma of Rec. ITU-R BT.709 on the gamma-encoded components.
    """
    red, green, blue = rgba[:3]
    return "#ffffff" if 0.2126 * red + 0.7152 * green + 0.0722 * blue < 0.5 else "#000000"
