"""Muograms side by side: the panel of a simulation and the report's summary."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from textwrap import fill, wrap
from typing import TYPE_CHECKING

import numpy as np

from ..errors import MuyscError
from ..muogram import Muogram
from . import muogram_axes as draw
from . import style
from .colours import has_colour, sky_mask
from .contours import draw_contours, draw_skyline
from .directions import Directions, describe, directions_of
from .style import png_bytes, save_png

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["muogram_panel", "muogram_panels", "png_bytes", "save_png", "summary_panel"]

#: Pictures wider than this many times their height stand one above another.
_WIDE = 3.0

#: Order of the legend.
_LEGEND = ("Target", "Skyline", "Open sky", "Unknown")

_LEGEND_IN = 0.34

#: Narrower pictures (inches) get their heading on a row of its own, above the
#: name of the azimuth axis.
_HEADING_FITS_IN = 3.5
_ROW_IN = 0.2


@dataclass(frozen=True)
class _Layout:
    """Room around the picture of each panel (inches), and what is drawn."""

    #: With contours, compass and elevation, or the bare picture.
    large: bool
    left: float
    right: float
    above: float
    below: float
    #: Most and least that a picture measures.
    tallest: float
    narrowest: float = 1.6
    lowest: float = 1.2
    bar_height: float = 0.12
    bar_below: float = 0.46


_LARGE = _Layout(large=True, left=0.62, right=0.62, above=0.58, below=0.52, tallest=4.4)
_SMALL = _Layout(large=False, left=0.52, right=0.18, above=0.3, below=0.46, tallest=2.6, lowest=0.9)


def muogram_panel(left: Muogram, right: Muogram, title: str = "", subtitle: str = "") -> Figure:
    """Return two muograms side by side, as a rule thickness and flux.

    See `muogram_panels`.
    """
    return muogram_panels([left, right], title=title, subtitle=subtitle)


def muogram_panels(
    muograms: Sequence[Muogram],
    title: str = "",
    subtitle: str = "",
    terrain: Muogram | None = None,
) -> Figure:
    """Return muograms as panels with angles, contours, skyline and target.

    The panels stand side by side, or one above another where the field of view
    is wide. Azimuth and elevation share one scale as far as the page allows.
    Whichever muogram tells rock from open sky (thickness, opacity or
    transmission) tells it for all on the same directions.

    Parameters
    ----------
    muograms
        At least one; any quantities, any directions.
    title
        Title; by default the titles of the quantities.
    subtitle
        Line below it, before those on place and physics.
    terrain
        Thickness on the same directions, whose skyline and contours are drawn instead of
        each muogram's own.

    Raises
    ------
    MuyscError
        If matplotlib is missing or there is no muogram.
    """
    _require(muograms)
    grids = [directions_of(muogram) for muogram in muograms]
    wide = all(grid.width_deg > _WIDE * grid.height_deg for grid in grids)
    columns = 1 if wide or len(muograms) == 1 else 2
    title = title or _joined([muogram.kind.title for muogram in muograms])
    return _draw(muograms, grids, columns, _LARGE, title, subtitle, terrain)


def summary_panel(
    muograms: Mapping[str, Muogram], title: str = "Further quantities", subtitle: str = ""
) -> Figure:
    """Return all given quantities as small panels, three in a row.

    Parameters
    ----------
    muograms
        By quantity; drawn in the mapping's order.
    title, subtitle
        Title, and a line below it.

    Raises
    ------
    MuyscError
        If matplotlib is missing or there is no muogram.
    """
    chosen = list(muograms.values())
    _require(chosen)
    grids = [directions_of(muogram) for muogram in chosen]
    wide = all(grid.width_deg > _WIDE * grid.height_deg for grid in grids)
    columns = min(len(chosen), 1 if wide else 3)
    return _draw(chosen, grids, columns, _SMALL, title, subtitle)


def _require(muograms: Sequence[Muogram]) -> None:
    if not muograms:
        raise MuyscError("A panel needs at least one muogram, but none was given.")


def _joined(titles: list[str]) -> str:
    """Return titles as one phrase: “Rock thickness and muon flux”."""
    phrase = [titles[0], *(title[0].lower() + title[1:] for title in titles[1:])]
    return " and ".join(filter(None, (", ".join(phrase[:-1]), phrase[-1])))


def _draw(
    muograms: Sequence[Muogram],
    grids: list[Directions],
    columns: int,
    layout: _Layout,
    title: str,
    subtitle: str,
    terrain: Muogram | None = None,
) -> Figure:
    """Lay the panels out in rows and draw them."""
    title = fill(title, 85)
    lines = [subtitle, *describe(muograms[0])] if subtitle else describe(muograms[0])
    lines = [part for line in lines for part in wrap(line, 135)]
    cell_width = style.WIDTH_IN / columns
    room = cell_width - layout.left - layout.right
    sizes = [_picture_size(grid, room, layout) for grid in grids]
    rows = [list(range(n, min(n + columns, len(grids)))) for n in range(0, len(grids), columns)]
    narrow = layout.large and min(width for width, _ in sizes) < _HEADING_FITS_IN
    if narrow:
        layout = replace(layout, above=layout.above + _ROW_IN)
    around = layout.above + layout.below + layout.bar_height + layout.bar_below
    heights = [max(sizes[n][1] for n in row) + around for row in rows]
    heading = style.heading_height_in(title, lines)
    height = heading + sum(heights) + _LEGEND_IN
    figure = style.new_figure(style.WIDTH_IN, height)
    style.add_heading(figure, title, lines, layout.left - 0.4)

    legend: dict[str, object] = {}
    for index, row in enumerate(rows):
        for column, n in enumerate(row):
            picture_width, picture_height = sizes[n]
            x = column * cell_width + layout.left + (room - picture_width) / 2
            top = height - heading - sum(heights[:index]) - layout.above
            box = (x, top - picture_height, picture_width, picture_height)
            legend.update(_one_panel(figure, box, muograms[n], grids[n], muograms, layout, terrain))
    if legend:
        shown = [label for label in _LEGEND if label in legend]
        figure.legend(
            [legend[label] for label in shown], shown, loc="lower center", ncol=len(shown),
            frameon=False, fontsize=style.TEXT_SIZE, handlelength=1.8, columnspacing=2.2,
        )  # fmt: skip
    return figure


def _picture_size(grid: Directions, room: float, layout: _Layout) -> tuple[float, float]:
    """Return width and height of a picture (inches), on one angular scale if it fits."""
    scale = min(room / grid.width_deg, layout.tallest / grid.height_deg)
    return (
        min(room, max(layout.narrowest, scale * grid.width_deg)),
        max(layout.lowest, scale * grid.height_deg),
    )


def _one_panel(
    figure: Figure,
    box: tuple[float, float, float, float],
    muogram: Muogram,
    grid: Directions,
    muograms: Sequence[Muogram],
    layout: _Layout,
    terrain: Muogram | None,
) -> dict[str, object]:
    """Draw one muogram into a box (inches); return its legend entries."""
    from matplotlib.lines import Line2D

    width, height = figure.get_size_inches()

    def placed(x: float, y: float, w: float, h: float) -> tuple[float, float, float, float]:
        return x / width, y / height, w / width, h / height

    axes = figure.add_axes(placed(*box))
    sky, known = _sky(muogram, muograms) if terrain is None else _sky(terrain, [])
    scale, entries = draw.draw_pixels(axes, muogram, grid, sky)
    legend: dict[str, object] = {}
    target = draw.draw_target(axes, grid)
    if target is not None:
        legend["Target"] = target
    skyline = None if sky is None else draw_skyline(axes, grid, sky, known)
    if skyline is not None:
        legend["Skyline"] = Line2D([], [], color=style.INK, linewidth=style.LINE_WIDTH)
    legend.update(entries)
    if layout.large:
        inches_per_degree = box[2] / grid.width_deg, box[3] / grid.height_deg
        lines, ink = (muogram, scale) if terrain is None else (terrain, None)
        draw_contours(axes, lines, grid, sky, ink, skyline, inches_per_degree)
    draw.scale_axes(axes, grid)
    axes.set_title(
        muogram.kind.title, fontsize=style.HEADING_SIZE, fontweight="bold", loc="left",
        color=style.INK, y=1.0, pad=(layout.above - 0.2) * 72 if layout.large else 6,
    )  # fmt: skip
    if layout.large:
        draw.add_compass(axes, grid)
        draw.add_elevation(axes, grid)
    if has_colour(muogram.values, muogram.kind, sky).any():
        x, y, picture_width, _ = box
        bar = placed(x, y - layout.below - layout.bar_height, picture_width, layout.bar_height)
        label = (
            muogram.kind.label if layout.large or muogram.kind.unit == "1" else muogram.kind.unit
        )
        draw.add_colour_bar(figure.add_axes(bar), muogram, scale, label)
    elif sky is not None and sky.all():
        draw.draw_note(axes, "Open sky in every direction")
    else:
        draw.draw_note(axes, "No direction has a known value")
    return legend


def _sky(muogram: Muogram, muograms: Sequence[Muogram]) -> tuple[np.ndarray | None, np.ndarray]:
    """Return where a muogram's rays meet no rock (None: not known) and where that is known."""
    # A transmission of 1 is a rounded number, a thickness of 0 is not: ask it last.
    for other in sorted((muogram, *muograms), key=lambda one: one.quantity == "transmission"):
        same = (
            other.values.shape == muogram.values.shape
            and np.allclose(other.azimuth_deg, muogram.azimuth_deg)
            and np.allclose(other.elevation_deg, muogram.elevation_deg)
        )
        sky = sky_mask(other.values, other.kind) if same else None
        if sky is not None:
            return sky, np.isfinite(other.values)
    return None, np.zeros(muogram.values.shape, dtype=bool)
