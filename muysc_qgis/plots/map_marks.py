"""What surrounds a map in kilometres: scales along its sides, scale bar, north arrow."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from . import scales, style, ticks
from .frames import whole

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Room for a tick with its label (inches).
_TICK_ROOM_IN = 0.7

#: Share of the map's width that the scale bar takes at most.
_LONGEST = 0.25

#: Lower left corner of the bar, as a share of the map.
_LEFT, _BOTTOM = 0.03, 0.035

#: Drawing order of bar and arrow: on areas and lines, below what marks a place.
_ORDER = 5.5


def draw_surroundings(axes: Axes, size_in: tuple[float, float], east: str, north: str) -> None:
    """Draw scales, scale bar and north arrow; the limits must be set.

    Parameters
    ----------
    axes
        Of the map, in kilometres.
    size_in
        Width and height on the page.
    east, north
        What runs along the lower and the left side.
    """
    frame = whole(axes)
    for side, name, (low, high), length in (
        ("bottom", east, axes.get_xlim(), size_in[0]),
        ("left", north, axes.get_ylim(), size_in[1]),
    ):
        step = ticks.round_step(high - low, max(2, int(length / _TICK_ROOM_IN)))
        scales.draw_scale(frame, side, ticks.multiples(low, high, step), name=f"{name} (km)")
    _draw_scale_bar(axes)
    _draw_north(axes)


def bar_length(longest: float) -> float:
    """Return the largest 1, 2 or 5 × 10ⁿ that is not above `longest`."""
    decade = 10.0 ** np.floor(np.log10(longest))
    return float(max(m * decade for m in (1, 2, 5) if m * decade <= longest * (1 + 1e-9)))


def _draw_scale_bar(axes: Axes) -> None:
    """Draw a bar of a round length at the lower left."""
    from matplotlib.patches import Rectangle

    west, east = axes.get_xlim()
    length = bar_length(_LONGEST * (east - west))
    share = length / (east - west)
    look = {"transform": axes.transAxes, "zorder": _ORDER}
    axes.add_patch(
        Rectangle(
            (_LEFT - 0.015, _BOTTOM - 0.018), share + 0.03, 0.075,
            facecolor="white", alpha=0.8, **look,
        )
    )  # fmt: skip
    for part, colour in ((0, style.INK), (1, "white")):
        axes.add_patch(
            Rectangle(
                (_LEFT + part * share / 2, _BOTTOM), share / 2, 0.01,
                facecolor=colour, edgecolor=style.INK, linewidth=0.6, **look,
            )
        )  # fmt: skip
    text = f"{ticks.number_label(length)} km" if length >= 1 else f"{length * 1e3:.4g} m"
    axes.text(
        _LEFT + share / 2, _BOTTOM + 0.017, text,
        ha="center", va="bottom", fontsize=style.TICK_SIZE, color=style.INK, **look,
    )  # fmt: skip


def _draw_north(axes: Axes) -> None:
    """Draw an arrow to the north at the upper right."""
    axes.annotate(
        "N", xy=(0.955, 0.975), xytext=(0.955, 0.885), xycoords="axes fraction",
        ha="center", va="center", fontsize=style.HEADING_SIZE, fontweight="bold", color=style.INK,
        arrowprops={"arrowstyle": "-|>", "color": style.INK, "linewidth": 1.4},
        bbox={"facecolor": "white", "alpha": 0.8, "edgecolor": "none", "pad": 2}, zorder=_ORDER,
    )  # fmt: skip
