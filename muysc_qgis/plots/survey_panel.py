"""Pictures of a survey: the score on the map, the azimuths covered, what sites trade off."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..quantities import QUANTITIES
from ..survey.choice import AZIMUTHS_DEG, coverage
from ..workflows.site_assessment import SurveyPlan
from ..workflows.site_selection import Selection
from . import charts, style, ticks
from .frames import new_axes, page_axes
from .map_marks import draw_surroundings
from .scales import draw_colour_bar
from .survey_map import SurveyMap

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Measures of the panel (inches).
_HEIGHT = 7.35
_MAP = 5.55
_BAR = 0.12
_MAP_LEFT, _MAP_TOP = 0.62, 0.62
_RIGHT, _RIGHT_WIDTH = 7.0, 2.6

#: Quantity and number of the maps in the second figure.
_FURTHER = (
    ("exposure", "exposure_days"),
    ("share_seen", "share_seen"),
    ("thickness", "thickness_m"),
    ("free_sky", "free_sky"),
)
_TITLES = {
    "exposure_days": "Days to the muons wanted",
    "share_seen": "Share of the target seen",
    "thickness_m": "Median thickness through the target",
    "free_sky": "Share of free sky",
}


def survey_panel(selection: Selection, plan: SurveyPlan) -> Figure:
    """Return the panel of a survey.

    The score of every candidate on the map with the sites chosen; how well each azimuth
    around the target is covered; exposure time against the share seen.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    figure = style.new_figure(style.WIDTH_IN, _HEIGHT)
    count = len(selection.candidates)
    style.add_heading(
        figure,
        "Where to put the telescope",
        [f"{count} candidates around the target on the elevation model {plan.dem.name}"],
    )
    axes = charts.place(figure, _MAP_LEFT, _MAP_TOP, _MAP, _MAP)
    maps = SurveyMap.of(selection, plan)
    scale = maps.draw(axes, "site_score", "score")
    legend = maps.mark(axes)
    _label_map(axes, _MAP)
    draw_colour_bar(
        page_axes(figure), (_MAP_LEFT, 0.42, _MAP, _BAR), selection.map_of("score"), scale,
        QUANTITIES["site_score"].label,
    )  # fmt: skip
    figure.legend(
        [artist for _, artist in legend], [label for label, _ in legend],
        loc="lower left", bbox_to_anchor=(_RIGHT / style.WIDTH_IN - 0.02, 0.03), frameon=False,
        fontsize=style.TEXT_SIZE, handlelength=1.6, borderpad=0,
    )  # fmt: skip
    _draw_rose(figure, selection)
    _draw_trade_off(charts.place(figure, _RIGHT, 4.05, _RIGHT_WIDTH, 1.8), selection)
    return figure


def survey_maps(selection: Selection, plan: SurveyPlan) -> Figure:
    """Return the other numbers of every candidate on four maps.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    side, gap = 4.0, 0.85
    figure = style.new_figure(style.WIDTH_IN, 2 * (side + 1.25) + 0.3)
    maps = SurveyMap.of(selection, plan)
    page, height = page_axes(figure), figure.get_size_inches()[1]
    for index, (quantity, number) in enumerate(_FURTHER):
        left = 0.62 + (index % 2) * (side + gap)
        top = 0.35 + (index // 2) * (side + 1.25)
        axes = charts.place(figure, left, top, side, side)
        style.add_title(axes, _TITLES[number], 5)
        scale = maps.draw(axes, quantity, number)
        maps.mark(axes)
        _label_map(axes, side)
        bar = (left, height - top - side - 0.62, side, _BAR)
        draw_colour_bar(page, bar, selection.map_of(number), scale, QUANTITIES[quantity].label)
    return figure


def _label_map(axes: Axes, side_in: float) -> None:
    draw_surroundings(axes, (side_in, side_in), "East of the target", "North of the target")


def _draw_rose(figure: Figure, selection: Selection) -> None:
    """Draw how well each azimuth is covered, north up and clockwise."""
    width, height = figure.get_size_inches()
    side = 2.2
    axes = new_axes(figure, (_RIGHT + 0.2, height - 1.0 - side, side, side), projection="polar")
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    chosen = selection.telescopes
    azimuth, score = selection.candidates.azimuth_deg, np.nan_to_num(selection.numbers["score"])
    middle = np.radians(AZIMUTHS_DEG)
    turn = np.append(middle, middle[0])
    best = np.zeros(len(AZIMUTHS_DEG))
    np.maximum.at(best, np.floor(azimuth % 360.0).astype(int) % 360, score)
    axes.bar(middle, best, width=np.radians(1.0), color="#b9b9b9", linewidth=0, zorder=1)
    covered = coverage(azimuth[chosen], score[chosen], selection.width_deg)
    axes.fill(turn, np.append(covered, covered[0]), color=style.DETECTOR, alpha=0.3, zorder=2)
    axes.plot(turn, np.append(covered, covered[0]), color=style.DETECTOR, linewidth=1.2, zorder=3)
    axes.plot(
        np.radians(azimuth[chosen]), score[chosen], marker="^", markersize=8, linestyle="none",
        markerfacecolor=style.DETECTOR, markeredgecolor="white", zorder=4,
    )  # fmt: skip
    top = max(float(best.max()), 1e-6)
    axes.set_ylim(0, 1.08 * top)
    rings = ticks.multiples(0, top, ticks.round_step(top, 3))[1:]
    axes.set_yticks(rings, [ticks.number_label(round(ring, 9)) for ring in rings])
    axes.set_xticks(np.radians(np.arange(0, 360, 45)), ["N", "NE", "E", "SE", "S", "SW", "W", "NW"])
    axes.tick_params(labelsize=style.TICK_SIZE, pad=0, colors=style.INK)
    axes.grid(color=style.MUTED, linewidth=0.3, alpha=0.6)
    axes.spines["polar"].set_linewidth(style.THIN_LINE_WIDTH)
    _title(figure, "Azimuths around the target", 0.62)
    figure.text(
        _RIGHT / width, (height - 3.56) / height,
        "grey: score of the best; blue: covered by the telescopes",
        fontsize=style.CONTOUR_SIZE, color=style.MUTED, va="bottom",
    )  # fmt: skip


def _draw_trade_off(axes: Axes, selection: Selection) -> None:
    """Draw the days of each candidate against the share of the target that it sees."""
    _title(axes.figure, "What sites trade off", 3.8)
    days, share = selection.numbers["exposure_days"], selection.numbers["share_seen"]
    known = np.isfinite(days) & (share > 0)
    axes.plot(
        share[known], days[known], ".", color="#8f8f8f", markersize=2.5, zorder=2, rasterized=True
    )
    for chosen, marker, face, edge, size in (
        (selection.best, "o", "white", style.INK, 5.5),
        (selection.telescopes, "^", style.DETECTOR, "white", 8),
    ):
        axes.plot(
            share[chosen], days[chosen], marker, markerfacecolor=face, markeredgecolor=edge,
            markersize=size, zorder=3,
        )  # fmt: skip
    axes.set_xlim(0, 1.05 * float(share[known].max(initial=1e-3)))
    shown = days[known]
    charts.log_axis(axes, "y", 0.8 * float(shown.min()), 1.25 * float(shown.max()))
    axes.grid(color=style.MUTED, linewidth=0.3, alpha=0.4)
    style.style_axes(axes)
    charts.label(axes, "Share of the target seen", "Days to the muons wanted")


def _title(figure: Figure, text: str, top_in: float) -> None:
    width, height = figure.get_size_inches()
    figure.text(
        _RIGHT / width, (height - top_in) / height, text, fontsize=style.HEADING_SIZE,
        fontweight="bold", color=style.INK, va="top",
    )  # fmt: skip
