"""One telescope beside those that were built."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..telescope.acceptance import Trajectories, trajectories
from ..telescope.geometry import TelescopeGeometry
from ..telescope.presets import PRESETS
from . import charts, style, ticks
from .frames import Box, new_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Colours and line styles told apart with any colour vision (Okabe & Ito 2008).
_LOOKS = (
    ("#0072b2", "-"), ("#d55e00", "-"), ("#009e73", "-"), ("#cc79a7", "-"),
    ("#56b4e9", (0, (5, 1.5))), ("#e69f00", (0, (5, 1.5))), ("#7f7f7f", (0, (5, 1.5))),
    ("#8a5a00", (0, (1.5, 1.2))), ("#000000", "-"),
)  # fmt: skip

_HEIGHT = 8.1

#: Name of a telescope that is none of the presets.
_OWN = "this telescope"

#: Telescopes drawn side by side.
_COLUMNS = 3


def comparison_panel(geometry: TelescopeGeometry, name: str, formula: str) -> Figure:
    """Return acceptances, shapes, resolutions and étendues of all telescopes.

    Parameters
    ----------
    geometry
        The telescope that is looked at.
    name
        Its preset; any other name adds it to the presets.
    formula
        One of `FORMULAS`.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    entries = {preset.title: preset.geometry for preset in PRESETS.values()}
    chosen = PRESETS[name].title if name in PRESETS else _OWN
    entries.setdefault(chosen, geometry)
    collected = {title: trajectories(one, formula) for title, one in entries.items()}
    looks = dict(zip(entries, _LOOKS))
    title = "Telescopes compared"
    lines = [
        f"{chosen[0].upper()}{chosen[1:]} in bold  ·  "
        + ("full integral over two pixels" if formula == "exact" else "formula of the paper")
    ]
    figure = style.new_figure(style.WIDTH_IN, _HEIGHT)
    style.add_heading(figure, title, lines)
    _acceptances(new_axes(figure, (0.75, 4.45, 4.1, 2.7)), collected, looks, chosen)
    _shapes(figure, (5.2, 4.0, 4.7, 3.15), entries, looks, chosen)
    _resolutions(new_axes(figure, (0.75, 0.6, 4.1, 2.9)), collected, looks, chosen)
    _etendues(new_axes(figure, (6.75, 0.6, 2.5, 2.9)), collected, looks, chosen)
    return figure


def _headed(axes: Axes, title: str) -> None:
    style.add_title(axes, title)
    style.add_grid(axes)
    style.style_axes(axes)


def _acceptances(
    axes: Axes, collected: dict[str, Trajectories], looks: dict[str, tuple], chosen: str
) -> None:
    """Draw acceptance per solid angle, which tells telescopes of any bars apart."""
    widest = 0.0
    for title, one in collected.items():
        geometry = one.geometry
        middle = geometry.bars_y - 1
        angle = np.degrees(np.arctan(geometry.step * geometry.offset_x))
        area = one.acceptance_cm2_sr[middle] / (one.solid_angle_sr[middle] / 4)
        colour, line = looks[title]
        axes.plot(
            angle, area / 1e4, color=colour, linestyle=line,
            linewidth=2.4 if title == chosen else style.LINE_WIDTH, label=title,
            zorder=4 if title == chosen else 2,
        )  # fmt: skip
        widest = max(widest, geometry.half_aperture_deg[0])
    axes.set_xlim(-widest, widest)
    axes.set_ylim(0, None)
    positions = ticks.angle_ticks(-widest, widest, 8)
    axes.set_xticks(positions, [ticks.number_label(float(tick)) for tick in positions])
    axes.set_xlabel("Angle from the boresight (°)", fontsize=style.TEXT_SIZE, labelpad=2)
    axes.set_ylabel("m²", fontsize=style.TEXT_SIZE, labelpad=2)
    _headed(axes, "Effective area by direction")


def _shapes(
    figure: Figure,
    box: Box,
    entries: dict[str, TelescopeGeometry],
    looks: dict[str, tuple],
    chosen: str,
) -> None:
    """Draw every telescope from the side, all at one scale."""
    axes = new_axes(figure, box)
    wide, tall = box[2] / _COLUMNS, box[3] / -(-len(entries) // _COLUMNS)
    inches = min(
        *((wide - 0.25) / one.separation_cm for one in entries.values()),
        *((tall - 0.42) / (one.bars_y * one.pixel_size_cm) for one in entries.values()),
    )
    for number, (title, one) in enumerate(entries.items()):
        row, column = divmod(number, _COLUMNS)
        x, top = column * wide, box[3] - row * tall
        half = one.bars_y * one.pixel_size_cm / 2 * inches
        y, depth = top - 0.36 - (tall - 0.42) / 2, one.separation_cm * inches
        colour = looks[title][0]
        for distance in np.linspace(0, depth, one.planes):
            axes.plot([x + distance] * 2, [y - half, y + half], color=colour, linewidth=2.6,
                      solid_capstyle="butt", zorder=3)  # fmt: skip
        for sign in (-1, 1):
            axes.plot([x, x + depth], [y - sign * half, y + sign * half], color=colour,
                      linewidth=0.7, zorder=2)  # fmt: skip
        bold = "bold" if title == chosen else "normal"
        sizes = f"{one.bars_x} × {one.bars_y} × {one.pixel_size_cm:g} cm, {one.separation_cm:g} cm"
        for text, size, down, weight, ink in (
            (title, style.TICK_SIZE, 0.0, bold, style.INK),
            (sizes, style.CONTOUR_SIZE, 0.15, "normal", style.MUTED),
        ):
            axes.text(x, top - down, text, fontsize=size, fontweight=weight, color=ink, va="top")
    end = box[2] - 0.15
    axes.plot([end - 100 * inches, end], [-0.05] * 2, color=style.INK, linewidth=1.5)
    axes.text(end - 100 * inches - 0.06, -0.05, "1 m", fontsize=style.TICK_SIZE, va="center",
              ha="right", color=style.INK)  # fmt: skip
    axes.set_xlim(-0.03, box[2])
    axes.set_ylim(-0.1, box[3])
    axes.axis("off")
    style.add_title(axes, "From the side, at one scale")


def _resolutions(
    axes: Axes, collected: dict[str, Trajectories], looks: dict[str, tuple], chosen: str
) -> None:
    """Draw what a trajectory collects against how finely it looks."""
    for title, one in collected.items():
        x, y = one.angular_resolution_mrad.max(), one.acceptance_cm2_sr.max()
        axes.plot(
            [x], [y], marker="o", markersize=10 if title == chosen else 7, linestyle="none",
            color=looks[title][0], zorder=3, clip_on=False,
        )  # fmt: skip
        axes.annotate(
            # Presets keep clear of each other below their marks.
            title, (x, y), xytext=(7, 2 if title == _OWN else -2), textcoords="offset points",
            fontsize=style.TICK_SIZE, fontweight="bold" if title == chosen else "normal",
            color=style.INK, va="bottom" if title == _OWN else "top",
        )  # fmt: skip
    axes.set_xscale("log")
    axes.set_yscale("log")
    # To the right there is room for the names.
    for which, (low, high), beyond in (("x", axes.get_xlim(), 2.3), ("y", axes.get_ylim(), 1.15)):
        charts.short_log_axis(axes, which, low / 1.15, high * beyond)
    axes.set_xlabel("Angular resolution, full width (mrad)", fontsize=style.TEXT_SIZE, labelpad=2)
    axes.set_ylabel("cm² sr", fontsize=style.TEXT_SIZE, labelpad=2)
    _headed(axes, "Largest acceptance of a trajectory")


def _etendues(
    axes: Axes, collected: dict[str, Trajectories], looks: dict[str, tuple], chosen: str
) -> None:
    """Draw étendues as bars with the half aperture beside each."""
    order = sorted(collected, key=lambda title: collected[title].etendue_cm2_sr)
    values = [collected[title].etendue_cm2_sr / 1e4 for title in order]
    bars = axes.barh(range(len(order)), values, color=[looks[title][0] for title in order])
    for title, bar, value in zip(order, bars, values):
        angle = collected[title].geometry.half_aperture_deg[0]
        axes.annotate(
            f"{value:.3g}, ±{angle:.0f}°", (value, bar.get_y() + bar.get_height() / 2),
            xytext=(4, 0), textcoords="offset points", va="center", fontsize=style.TICK_SIZE,
            color=style.INK, annotation_clip=False,
        )  # fmt: skip
    axes.set_yticks(range(len(order)), order)
    axes.set_xlim(0, 1.4 * max(values))
    axes.set_xlabel("m² sr", fontsize=style.TEXT_SIZE, labelpad=2)
    _headed(axes, "Étendue and half aperture")
    for label, title in zip(axes.get_yticklabels(), order):
        label.set_fontweight("bold" if title == chosen else "normal")
    axes.grid(axis="y", visible=False)
