"""A page of rasters in telescope angles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ..telescope.planning import HALF
from ..trajectories import TrajectoryMap
from . import style
from .frames import new_axes, page_axes
from .scales import draw_colour_bar
from .telescope_axes import (
    draw_map,
    draw_net,
    draw_skyline,
    draw_target,
    edges,
    label_angles,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Measures of the page (inches).
_LEFT = 0.68
_RIGHT = 0.62
_ABOVE = 0.55
_BELOW = 1.12
_TALLEST = 3.6

#: Order of the legend.
_LEGEND = ("Target", "Skyline", "Open sky", "Unknown")


def trajectory_page(
    maps: Sequence[TrajectoryMap],
    titles: Sequence[str],
    title: str,
    lines: list[str],
    rock_share: np.ndarray,
) -> Figure:
    """Return maps on the same trajectories, two in a row, with skyline, horizon and target.

    Parameters
    ----------
    maps
        At least one, all of a telescope that points somewhere.
    titles
        One for each map.
    title, lines
        Title of the page, and what stands below it.
    rock_share
        (n_y, n_x) share of each trajectory that is behind rock, NaN where unknown.

    Raises
    ------
    MuyscError
        If the metadata do not say where the telescope points.
    """
    from matplotlib.lines import Line2D

    pointing = maps[0].pointing
    left, right, bottom, top = edges(maps[0])
    room = style.WIDTH_IN / 2 - _LEFT - _RIGHT
    wide = min(room, _TALLEST * (right - left) / (top - bottom))
    tall = wide * (top - bottom) / (right - left)
    rows = -(-len(maps) // 2)
    heading = style.heading_height_in(title, lines)
    height = heading + rows * (tall + _ABOVE + _BELOW) + 0.3
    figure = style.new_figure(style.WIDTH_IN, height)
    style.add_heading(figure, title, lines, _LEFT - 0.4)
    page = page_axes(figure)
    sky = rock_share <= HALF
    legend: dict[str, object] = {}
    for number, (one, name) in enumerate(zip(maps, titles)):
        row, column = divmod(number, 2)
        x = column * style.WIDTH_IN / 2 + _LEFT + (room - wide) / 2
        y = height - heading - row * (tall + _ABOVE + _BELOW) - _ABOVE - tall
        axes = new_axes(figure, (x, y, wide, tall))
        scale, entries = draw_map(axes, one, sky)
        legend.update(entries)
        draw_net(axes, pointing)
        if draw_skyline(axes, one, rock_share):
            legend["Skyline"] = Line2D([], [], color=style.INK, linewidth=style.LINE_WIDTH)
        target = draw_target(axes, one)
        if target is not None:
            legend["Target"] = target
        label_angles(axes, 7, 7)
        style.add_title(axes, name, 16)
        bar = (x, y - 0.55, wide, 0.12)
        draw_colour_bar(page, bar, one.values, scale, one.kind.label)
    order = [key for key in _LEGEND if key in legend]
    if order:
        figure.legend(
            [legend[key] for key in order], order, loc="lower center", ncol=len(order),
            frameon=False, fontsize=style.TEXT_SIZE, handlelength=1.8, columnspacing=2.2,
        )  # fmt: skip
    return figure


def aimed_at_target(one: TrajectoryMap) -> TrajectoryMap:
    """Return a raster whose boresight is the target, as in muograms, or that has none."""
    aims = {
        "BORESIGHT_AZIMUTH": "TARGET_AZIMUTH",
        "BORESIGHT_ELEVATION": "TARGET_ELEVATION_ANGLE",
    }
    kept = {key: value for key, value in one.metadata.items() if key not in aims}
    aimed = {key: one.metadata[aim] for key, aim in aims.items() if aim in one.metadata}
    return replace(one, metadata={**kept, **aimed})
