"""Places on a page with scales of their own.

A set of matplotlib's axes takes longer to make than the picture in it to draw.
So all pictures of a page share one set, in inches, and each has a frame: the
transforms from its values, and from shares of its sides, to the page.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.transforms import Transform

#: Left, bottom, width and height (inches) on the page.
Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class Frame:
    """A rectangle on a page.

    Parameters
    ----------
    axes
        Where artists are added, with one of the two transforms.
    values
        Transform from the values at its sides to the page.
    shares
        Transform from shares, 0 to 1 from the left and from the bottom.
    box
        Where on the page.
    """

    axes: Axes
    values: Transform
    shares: Transform
    box: Box

    def on_page(self, points: np.ndarray) -> np.ndarray:
        """Return points, (n, 2) values, in the coordinates of the axes."""
        return np.asarray((self.values - self.axes.transData).transform(points))


def new_axes(figure: Figure, box: Box, **look: Any) -> Axes:
    """Return axes with scales of their own in a box; further arguments go to matplotlib."""
    width, height = figure.get_size_inches()
    left, bottom, wide, high = box
    return figure.add_axes((left / width, bottom / height, wide / width, high / height), **look)


def page_axes(figure: Figure) -> Axes:
    """Return axes over a whole figure, in inches from its lower left corner."""
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    width, height = figure.get_size_inches()
    # Limits that are set stay, whatever is drawn.
    axes.set(xlim=(0.0, width), ylim=(0.0, height))
    axes.set_axis_off()
    return axes


def place(axes: Axes, box: Box, limits: tuple[float, float, float, float]) -> Frame:
    """Return a frame on a page, its outline drawn.

    Parameters
    ----------
    axes
        From `page_axes`.
    box
        Where on the page.
    limits
        Values at the left, right, bottom and top side.
    """
    from matplotlib.patches import Rectangle
    from matplotlib.transforms import Affine2D

    (x, y, width, height), (left, right, bottom, top) = box, limits
    shares = Affine2D().scale(width, height).translate(x, y) + axes.transData
    to_shares = Affine2D().translate(-left, -bottom).scale(1 / (right - left), 1 / (top - bottom))
    axes.add_artist(
        Rectangle(
            (x, y), width, height, fill=False, edgecolor=style.MUTED,
            linewidth=style.THIN_LINE_WIDTH, zorder=2.5,
        )
    )  # fmt: skip
    return Frame(axes, to_shares + shares, shares, box)


def whole(axes: Axes) -> Frame:
    """Return the frame of axes that have scales of their own; only their outline stays."""
    axes.xaxis.set_visible(False)
    axes.yaxis.set_visible(False)
    for spine in axes.spines.values():
        spine.set_color(style.MUTED)
        spine.set_linewidth(style.THIN_LINE_WIDTH)
    place, (width, height) = axes.get_position(), axes.figure.get_size_inches()
    box = (place.x0 * width, place.y0 * height, place.width * width, place.height * height)
    return Frame(axes, axes.transData, axes.transAxes, box)


def draw_image(
    frame: Frame, colours: np.ndarray, extent: tuple[float, float, float, float], gid: str
) -> None:
    """Draw cells of one colour each into a frame.

    Parameters
    ----------
    frame
        From `place`.
    colours
        (rows, columns, 4) bytes, the top row first.
    extent
        Values at the left, right, bottom and top edge of the picture.
    gid
        What it is.
    """
    from matplotlib.image import AxesImage

    image = AxesImage(frame.axes, extent=extent, interpolation="nearest")
    image.set_data(colours)
    image.set(transform=frame.values, zorder=1, gid=gid)
    frame.axes.add_image(image)
