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
from . import scales, style
from .colours import has_colour, sky_mask
from .contours import draw_contours, draw_skyline
from .directions import Directions, describe, directions_of
from .frames import Frame, page_axes, place
from .legend import draw_legend

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.figure import Figure

#: Pictures wider than this many times their height stand one above another.
_WIDE = 3.0

#: Order of the legend.
_LEGEND = ("Target", "Skyline", "Open sky", "Unknown")

_LEGEND_IN = 0.34
_LEGEND_COLUMN_IN = 1.25

#: Title of a picture below the upper end of its room, or above a small picture (inches).
_HEADING_IN = 0.2
_SMALL_HEADING_IN = 0.08

#: Room below a picture whose azimuths stand below another one (inches).
_UNLABELLED_IN = 0.16

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
    # Small pictures of the same directions share their scales.
    shared = not layout.large and all(_same(grids[0], grid) for grid in grids)
    layouts = [
        replace(layout, below=_UNLABELLED_IN) if shared and row[-1] + columns < len(grids)
        else layout
        for row in rows
    ]  # fmt: skip
    heights = [
        max(sizes[n][1] for n in row) + one.above + one.below + one.bar_height + one.bar_below
        for row, one in zip(rows, layouts)
    ]
    heading = style.heading_height_in(title, lines)
    height = heading + sum(heights) + _LEGEND_IN
    figure = style.new_figure(style.WIDTH_IN, height)
    style.add_heading(figure, title, lines, layout.left - 0.4)
    axes = page_axes(figure)

    legend: dict[str, Artist] = {}
    top = height - heading
    for row, one, row_height in zip(rows, layouts, heights):
        for column, n in enumerate(row):
            picture_width, picture_height = sizes[n]
            x = column * cell_width + layout.left + (room - picture_width) / 2
            box = (x, top - one.above - picture_height, picture_width, picture_height)
            frame = place(axes, box, grids[n].extent_deg)
            legend |= _one_panel(frame, muograms[n], grids[n], muograms, one, terrain)
            labelled = one.below > _UNLABELLED_IN, not shared or column == 0
            draw.draw_angles(frame, grids[n], *labelled)
        top -= row_height
    if legend:
        shown = [(label, legend[label]) for label in _LEGEND if label in legend]
        left = (style.WIDTH_IN - _LEGEND_COLUMN_IN * len(shown)) / 2
        draw_legend(figure, shown, left, _LEGEND_IN, 1, _LEGEND_IN, _LEGEND_COLUMN_IN)
    return figure


def _same(one: Directions, other: Directions) -> bool:
    """Return whether two muograms have their pixels at the same places of a panel."""
    return np.array_equal(one.azimuth_edges_deg, other.azimuth_edges_deg) and np.array_equal(
        one.zenith_edges_deg, other.zenith_edges_deg
    )


def _picture_size(grid: Directions, room: float, layout: _Layout) -> tuple[float, float]:
    """Return width and height of a picture (inches), on one angular scale if it fits."""
    scale = min(room / grid.width_deg, layout.tallest / grid.height_deg)
    return (
        min(room, max(layout.narrowest, scale * grid.width_deg)),
        max(layout.lowest, scale * grid.height_deg),
    )


def _one_panel(
    frame: Frame,
    muogram: Muogram,
    grid: Directions,
    muograms: Sequence[Muogram],
    layout: _Layout,
    terrain: Muogram | None,
) -> dict[str, Artist]:
    """Draw one muogram; return its legend entries."""
    from matplotlib.lines import Line2D

    sky, known = _sky(muogram, muograms) if terrain is None else _sky(terrain, [])
    scale, entries = draw.draw_pixels(frame, muogram, grid, sky)
    legend: dict[str, Artist] = {}
    target = draw.draw_target(frame, grid)
    if target is not None:
        legend["Target"] = target
    skyline = None if sky is None else draw_skyline(frame, grid, sky, known)
    if skyline is not None:
        legend["Skyline"] = Line2D([], [], color=style.INK, linewidth=style.LINE_WIDTH)
    legend.update(entries)
    if layout.large:
        lines, ink = (muogram, scale) if terrain is None else (terrain, None)
        draw_contours(frame, lines, grid, sky, ink, skyline)
        draw.add_compass(frame, grid)
        draw.add_elevation(frame, grid)
    left, bottom, _, height = frame.box
    above = layout.above - _HEADING_IN if layout.large else _SMALL_HEADING_IN
    frame.axes.figure.text(
        left, bottom + height + above, muogram.kind.title, transform=frame.axes.transData,
        fontsize=style.HEADING_SIZE, fontweight="bold", color=style.INK, gid="title",
    )  # fmt: skip
    if has_colour(muogram.values, muogram.kind, sky).any():
        kind = muogram.kind
        name = kind.label if layout.large or kind.unit == "1" else kind.unit
        scales.draw_colour_bar_below(
            frame, muogram.values, scale, name, layout.below, layout.bar_height
        )
    elif sky is not None and sky.all():
        draw.draw_note(frame, "Open sky in every direction")
    else:
        draw.draw_note(frame, "No direction has a known value")
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
