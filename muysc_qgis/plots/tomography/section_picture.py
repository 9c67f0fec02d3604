"""A vertical section through a volume along a line."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ...topography.relief import Relief
from ...workflows.tomography_result import Tomography
from .. import style
from ..frames import page_axes
from ..legend import draw_legend
from ..scales import draw_colour_bar_below
from . import volume_scales
from .cut_axes import GROUND_LINE, UNSEEN, draw_cut, draw_ground, fitted
from .cuts import Cut, along_line, heights_along, resampled
from .pictures import BAR_HEIGHT, BELOW, LEFT

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.figure import Figure

TITLE = "Vertical section"

#: The picture at most; legend and colour bar below it (inches).
_ROOM, _FOOT = (8.9, 4.5), 1.1
#: Least height of a picture; flatter ones are stretched upwards to it (inches).
_LOWEST = 1.2


def section_figure(
    tomography: Tomography,
    points_m: Sequence[tuple[float, float]] | np.ndarray,
    relief: Relief | None = None,
    name: str = "",
) -> Figure:
    """Draw the densities below a line on the map.

    Parameters
    ----------
    tomography
        What is cut.
    points_m
        (n, 2) corners of the line in the CRS of the volume.
    relief
        Terrain in that CRS, if it is known.
    name
        Of the line.

    Raises
    ------
    MuyscError
        If the line has no length, or matplotlib is missing.
    """
    cut = along_line(tomography.density, points_m)
    rock = np.isfinite(along_line(tomography.coverage, points_m).values)
    scale = volume_scales.between(*tomography.density_limits)
    wide, high = fitted(cut.size_m, _ROOM)
    stretch = max(1.0, _LOWEST / high)
    lines = [_described(cut, name, stretch)]
    head = style.heading_height_in(TITLE, lines) + 0.15
    page_in = head + high * stretch + BELOW + _FOOT
    figure = style.new_figure(style.WIDTH_IN, page_in)
    style.add_heading(figure, TITLE, lines)
    axes = page_axes(figure)
    corner = (LEFT, page_in - head - high * stretch)
    frame = draw_cut(axes, corner, (wide, high * stretch), cut, scale, rock)
    legend = _legend(relief is not None)
    if relief is not None:
        step = cut.size_m[0] / 2 / len(cut.values)
        _, east, north = resampled(points_m, step)
        draw_ground(frame, cut, heights_along(relief, east, north))
    draw_colour_bar_below(frame, cut.values, scale, "Density (g/cm³)", BELOW + 0.45, BAR_HEIGHT)
    draw_legend(figure, legend, LEFT, corner[1] - BELOW, 1, 0.2, 2.6)
    return figure


def _described(cut: Cut, name: str, stretch: float) -> str:
    parts = [name] if name else []
    parts.append(f"{cut.size_m[0] / 1e3:.3g} km along the line, from its first point")
    if stretch > 1:
        parts.append(f"heights stretched {stretch:.2g} times")
    return "  ·  ".join(parts)


def _legend(with_ground: bool) -> list[tuple[str, Artist]]:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    legend: list[tuple[str, Artist]] = [
        ("Crossed by no ray", Patch(facecolor=UNSEEN, edgecolor="none")),
        ("No rock, or beyond the volume",
         Patch(facecolor=style.SKY, edgecolor=style.MUTED, linewidth=0.4)),
    ]  # fmt: skip
    return [("Ground", Line2D([], [], **GROUND_LINE)), *legend] if with_ground else legend
