"""One muogram in one set of axes: pixels, target, angles, colour scale."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..muogram import Muogram
from . import style, ticks
from .colours import colour_scale, has_colour, pixel_colours
from .directions import Directions, even_picture

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable

#: Length of a colour bar's arrow, and the room that one of its labels takes (inches).
_ARROW_IN = 0.16
_LABEL_IN = 0.45


def draw_pixels(
    axes: Axes, muogram: Muogram, directions: Directions, sky: np.ndarray | None
) -> tuple[ScalarMappable, dict[str, Artist]]:
    """Draw the pixels and set the limits of the axes to their outer edges.

    Returns
    -------
    scale, legend
        The colour scale, and the legend entries by their label.
    """
    from matplotlib.patches import Patch, Rectangle

    scale = colour_scale(muogram.values, muogram.kind)
    picture = pixel_colours(muogram.values, muogram.kind, sky, scale)
    left, right, bottom, top = directions.extent_deg
    legend: dict[str, Artist] = {}
    opaque = picture[..., 3] == 255
    if not opaque.all():
        axes.add_patch(
            Rectangle((left, top), right - left, bottom - top, zorder=0, **style.UNKNOWN_LOOK)
        )
        legend["Unknown"] = Patch(**style.UNKNOWN_LOOK)
    if np.any(opaque & ~has_colour(muogram.values, muogram.kind, sky)):
        legend["Open sky"] = Patch(facecolor=style.SKY, edgecolor=style.MUTED, linewidth=0.5)
    axes.imshow(
        even_picture(picture, directions),
        extent=(left, right, bottom, top),
        aspect="auto",
        zorder=1,
    )
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)
    return scale, legend


def draw_target(axes: Axes, directions: Directions) -> Artist | None:
    """Mark the target; None if it is not known or outside the picture."""
    if directions.target_deg is None:
        return None
    azimuth, zenith = directions.target_deg
    left, right, bottom, top = directions.extent_deg
    if not (left <= azimuth <= right and top <= zenith <= bottom):
        return None
    (marker,) = axes.plot(
        [azimuth],
        [zenith],
        linestyle="none",
        marker="*",
        markersize=13,
        markerfacecolor="white",
        markeredgecolor="black",
        markeredgewidth=0.9,
        zorder=5,
        clip_on=False,
    )
    return marker


def draw_note(axes: Axes, text: str) -> None:
    """Say in the middle of the axes why there is nothing else to see."""
    axes.text(
        0.5,
        0.5,
        text,
        transform=axes.transAxes,
        ha="center",
        va="center",
        fontsize=style.TEXT_SIZE,
        color=style.INK,
        bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 4},
        zorder=6,
    )


def scale_axes(axes: Axes, directions: Directions, labelled: bool = True) -> None:
    """Give the axes azimuth ticks at the bottom and zenith ticks at the left."""
    left, right, bottom, top = directions.extent_deg
    width_in, height_in = size_in(axes)
    across = ticks.angle_ticks(left, right, max(2, int(width_in / 0.5)))
    down = ticks.angle_ticks(top, bottom, max(2, int(height_in / 0.25)))
    axes.set_xticks(across, [ticks.number_label(tick) for tick in across])
    axes.set_yticks(down, [ticks.number_label(tick) for tick in down])
    style.style_axes(axes)
    if labelled:
        relative = directions.target_deg is not None or directions.origin_deg != 0.0
        axes.set_xlabel(
            "Azimuth from the boresight (°)" if relative else "Azimuth (°)",
            fontsize=style.TEXT_SIZE, labelpad=2,
        )  # fmt: skip
        axes.set_ylabel("Zenith angle (°)", fontsize=style.TEXT_SIZE, labelpad=2)


def add_compass(axes: Axes, directions: Directions) -> Axes:
    """Add the azimuth from north with compass letters along the top."""
    left, right, *_ = directions.extent_deg
    top = axes.twiny()
    top.set_xlim(left, right)
    first, last = left + directions.origin_deg, right + directions.origin_deg
    width_in, _ = size_in(axes)
    azimuths = ticks.angle_ticks(first, last, max(2, int(width_in / 0.5)))
    top.set_xticks(
        azimuths - directions.origin_deg, [ticks.azimuth_label(azimuth) for azimuth in azimuths]
    )
    style.style_axes(top)
    for azimuth, letter in ticks.compass_points(first, last):
        top.annotate(
            letter,
            (azimuth - directions.origin_deg, 1.0),
            xycoords=("data", "axes fraction"),
            xytext=(0, 15),
            textcoords="offset points",
            ha="center",
            va="bottom",
            fontsize=style.TICK_SIZE,
            fontweight="bold",
            color=style.INK,
        )
    top.set_xlabel("Azimuth from north (°)", fontsize=style.TEXT_SIZE, labelpad=14, loc="right")
    return top


def add_elevation(axes: Axes, directions: Directions) -> Axes:
    """Add the elevation above the horizon along the right."""
    *_, bottom, top = directions.extent_deg
    right = axes.twinx()
    right.set_ylim(bottom, top)
    _, height_in = size_in(axes)
    elevations = ticks.angle_ticks(90.0 - bottom, 90.0 - top, max(2, int(height_in / 0.25)))
    right.set_yticks(90.0 - elevations, [ticks.number_label(tick) for tick in elevations])
    right.set_ylabel("Elevation (°)", fontsize=style.TEXT_SIZE, labelpad=3)
    style.style_axes(right)
    return right


def size_in(axes: Axes) -> tuple[float, float]:
    """Return the width and height of axes on the page (inches)."""
    position = axes.get_position()
    width, height = axes.figure.get_size_inches()
    return position.width * width, position.height * height


def add_colour_bar(axes: Axes, muogram: Muogram, scale: ScalarMappable, label: str) -> None:
    """Draw the colour scale into its own axes, arrows where values lie beyond it."""
    low, high = scale.get_clim()
    finite = muogram.values[np.isfinite(muogram.values)]
    if muogram.kind.logarithmic:
        finite = finite[finite > 0]
    below, above = bool(np.any(finite < low)), bool(np.any(finite > high))
    extend = ("both" if above else "min") if below else ("max" if above else "neither")
    bar = axes.figure.colorbar(
        scale,
        cax=axes,
        orientation="horizontal",
        extend=extend,
        extendfrac=_ARROW_IN / size_in(axes)[0],
    )
    if muogram.kind.logarithmic:
        positions = ticks.logarithmic_ticks(low, high)
        positions = positions[:: int(np.ceil(len(positions) * _LABEL_IN / size_in(axes)[0]))]
    else:
        positions = ticks.multiples(low, high, ticks.round_step(high - low, 5))
    bar.set_ticks(positions, labels=[ticks.number_label(position) for position in positions])
    bar.minorticks_off()
    bar.outline.set_linewidth(style.THIN_LINE_WIDTH)
    bar.outline.set_edgecolor(style.MUTED)
    bar.set_label(label, fontsize=style.TEXT_SIZE, labelpad=2)
    style.style_axes(axes)
