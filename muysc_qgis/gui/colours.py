"""The colours of a quantity as a Qt image, the same as on maps, panels and in reports."""

from __future__ import annotations

import numpy as np
from qgis.PyQt.QtGui import QImage

from ..plots.colours import has_colour
from ..plots.limits import colour_limits
from ..plots.style import SKY, UNKNOWN_LOOK, rgb
from ..quantities import COLOUR_STOPS, Quantity

_SHADES = 256
UNKNOWN = str(UNKNOWN_LOOK["facecolor"])


def shades(quantity: Quantity) -> np.ndarray:
    """Return the colours of a quantity from low to high, (256, 3) bytes."""
    stops = np.array([rgb(colour) for colour in COLOUR_STOPS[quantity.colours]], dtype=float)
    at = np.linspace(0.0, len(stops) - 1.0, _SHADES)
    channels = [np.interp(at, np.arange(len(stops)), channel) for channel in stops.T]
    return np.rint(np.column_stack(channels)).astype(np.uint8)


def share_along(values: np.ndarray, quantity: Quantity, limits: tuple[float, float]) -> np.ndarray:
    """Return where on the scale values lie, 0 at its low end to 1 at its high end."""
    low, high = limits
    inside = np.clip(np.where(np.isfinite(values), values, low), low, high)
    if quantity.logarithmic:
        return np.asarray(np.log(inside / low) / np.log(high / low))
    return np.asarray((inside - low) / (high - low))


def picture_of(values: np.ndarray, quantity: Quantity, sky: np.ndarray) -> QImage:
    """Return a muogram as a picture, one dot a pixel, the top row first.

    Parameters
    ----------
    values
        (n_elevation, n_azimuth) in the quantity's unit, NaN where unknown.
    quantity
        What the values are.
    sky
        (n_elevation, n_azimuth), true where the ray meets no rock.
    """
    position = share_along(values, quantity, colour_limits(values, quantity))
    index = np.minimum((position * _SHADES).astype(int), _SHADES - 1)
    picture = shades(quantity)[index]
    coloured = has_colour(values, quantity, sky)
    picture[~coloured] = rgb(UNKNOWN)
    picture[sky & ~coloured] = rgb(SKY)
    return image_of(picture)


def image_of(picture: np.ndarray) -> QImage:
    """Return (rows, columns, 3) bytes as a picture of their own."""
    rows, columns = picture.shape[:2]
    rgbx = np.dstack([picture[..., ::-1], np.full((rows, columns), 255, np.uint8)])
    image = QImage(
        np.ascontiguousarray(rgbx).tobytes(), columns, rows, 4 * columns, QImage.Format.Format_RGB32
    )
    # The bytes belong to Python, and the picture outlives them.
    return image.copy()
