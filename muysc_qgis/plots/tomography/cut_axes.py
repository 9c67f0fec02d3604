"""One cut in a frame: cells in colour, ground, marks, and scales in kilometres and metres."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import style, ticks
from ..frames import Frame, draw_image, place
from ..scales import draw_scale
from .cuts import Cut

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable

#: Rock that no ray crosses.
UNSEEN = "#b9b9b9"

#: Room for a tick with its label across and up (inches).
_ACROSS_IN, _UP_IN = 0.62, 0.3

#: How the ground is drawn, also in legends.
GROUND_LINE = {"color": style.INK, "linewidth": 1.3}


def fitted(size_m: tuple[float, float], most_in: tuple[float, float]) -> tuple[float, float]:
    """Return the largest width and height (inches) at one scale that fit a room."""
    scale = min(room / size for room, size in zip(most_in, size_m))
    return size_m[0] * scale, size_m[1] * scale


def cell_colours(cut: Cut, scale: ScalarMappable, rock: np.ndarray | None) -> np.ndarray:
    """Return the picture of a cut, (rows, columns, 4) bytes, the top row first.

    Rock without a value is grey; all else without a value is sky in a vertical cut and
    transparent in a level one.
    """
    picture = scale.to_rgba(np.nan_to_num(cut.values), bytes=True)
    known = np.isfinite(cut.values)
    picture[~known] = (*style.rgb(style.SKY), 255) if cut.is_vertical else 0
    if rock is not None:
        picture[~known & rock] = (*style.rgb(UNSEEN), 255)
    return picture.transpose(1, 0, 2)[::-1]


def draw_cut(
    axes: Axes,
    corner_in: tuple[float, float],
    size_in: tuple[float, float],
    cut: Cut,
    scale: ScalarMappable,
    rock: np.ndarray | None = None,
    upright_scale: bool = True,
) -> Frame:
    """Draw a cut with its scales.

    Parameters
    ----------
    axes
        From `page_axes`.
    corner_in, size_in
        Lower left corner, width and height on the page.
    cut
        What is drawn.
    scale
        Colours and limits.
    rock
        (n_across, n_up) of bool: where there is rock, seen or not.
    upright_scale
        Whether there is a scale at the left, too.
    """
    frame = place(axes, (*corner_in, *size_in), cut.limits_m)
    left, right, bottom, top = cut.limits_m
    draw_image(frame, cell_colours(cut, scale, rock), cut.limits_m, "cells")
    wide, high = size_in
    count = max(2, int(wide / _ACROSS_IN))
    draw_lengths(frame, "bottom", (left, right), count, 1e3, f"{cut.across} (km)")
    if upright_scale:
        unit, word = (1.0, "m") if cut.is_vertical else (1e3, "km")
        count = max(1, round(high / _UP_IN))
        draw_lengths(frame, "left", (bottom, top), count, unit, f"{cut.up} ({word})")
    return frame


def draw_lengths(
    frame: Frame, side: str, limits_m: tuple[float, float], count: int, unit_m: float, name: str
) -> None:
    """Draw a scale of lengths in a unit along a side."""
    low, high = limits_m
    positions = ticks.multiples(low, high, ticks.round_step(high - low, count))
    if len(positions) < 2 and count > 1:
        # One number says nothing about the scale.
        positions = ticks.multiples(low, high, ticks.round_step(high - low, 2 * count))
    labels = [ticks.number_label(float(position) / unit_m) for position in positions]
    draw_scale(frame, side, positions, labels, name)


def draw_ground(frame: Frame, cut: Cut, ground_m: np.ndarray) -> None:
    """Draw the ground line over evenly spaced points from the left to the right edge."""
    from matplotlib.lines import Line2D

    left, right, bottom, top = cut.limits_m
    across = np.linspace(left, right, len(ground_m))
    # Where the ground leaves the picture, so does its line.
    shown = np.where((ground_m >= bottom) & (ground_m <= top), ground_m, np.nan)
    frame.axes.add_artist(
        Line2D(across, shown, transform=frame.values, zorder=3, gid="ground", **GROUND_LINE)
    )


def draw_target(frame: Frame, cut: Cut, across_m: float, up_m: float) -> None:
    """Mark the target where it is in the picture."""
    from matplotlib.lines import Line2D

    left, right, bottom, top = cut.limits_m
    if left <= across_m <= right and bottom <= up_m <= top:
        mark = Line2D([across_m], [up_m], zorder=5, gid="target", **style.TARGET_MARK)
        mark.set_transform(frame.values)
        frame.axes.add_artist(mark)


def write_title(frame: Frame, text: str, remark: str = "") -> None:
    """Write what a picture shows above it, and a remark below that."""
    left, bottom, _, height = frame.box
    lines = [(text, style.HEADING_SIZE, "bold", style.INK, 0.2 if remark else 0.07)]
    if remark:
        lines.append((remark, style.TICK_SIZE, "normal", style.MUTED, 0.055))
    for line, size, weight, colour, above in lines:
        frame.axes.text(
            left, bottom + height + above, style.plain(line), fontsize=size, fontweight=weight,
            color=colour, va="baseline",
        )  # fmt: skip
