"""What a telescope counts on the mountain, and what the counts show."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from ..telescope.planning import HALF
from ..trajectories import TrajectoryMap
from ..workflows.expected_counts import TelescopeCounts
from . import style
from .directions import describe
from .telescope_axes import (
    draw_colour_bar,
    draw_map,
    draw_net,
    draw_skyline,
    draw_target,
    edges,
    label_angles,
    place,
    write_heading,
)
from .telescope_panel import telescope_title
from .ticks import number_label

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Quantities of the panel, and of the report's second figure.
PANEL = ("counts", "relative_error", "density_resolution", "contrast_days")
FURTHER = ("exposure", "open_sky_counts", "flux", "thickness")

#: Measures of the page (inches).
_LEFT = 0.68
_RIGHT = 0.62
_ABOVE = 0.55
_BELOW = 1.12
_TALLEST = 3.6


def counts_panel(counts: TelescopeCounts, name: str, quantities: tuple[str, ...] = PANEL) -> Figure:
    """Return maps of what a telescope counts, with skyline, horizon and target.

    Parameters
    ----------
    counts
        From `expected_counts`.
    name
        Name of the telescope.
    quantities
        Which to show, two in a row.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    from matplotlib.lines import Line2D

    plan = counts.plan
    maps = [counts.maps[key] for key in quantities]
    left, right, bottom, top = edges(maps[0])
    room = style.WIDTH_IN / 2 - _LEFT - _RIGHT
    wide = min(room, _TALLEST * (right - left) / (top - bottom))
    tall = wide * (top - bottom) / (right - left)
    rows = -(-len(maps) // 2)
    title = f"{telescope_title(name)}: {plan.days:g} days of counting"
    lines = [*_told(counts), *describe(_aimed_at_target(maps[0]))]
    heading = style.heading_height_in(title, lines)
    height = heading + rows * (tall + _ABOVE + _BELOW) + 0.3
    figure = style.new_figure(style.WIDTH_IN, height)
    write_heading(figure, title, lines, _LEFT - 0.4)
    sky = counts.rock_share <= HALF
    legend: dict[str, object] = {}
    for number, one in enumerate(maps):
        row, column = divmod(number, 2)
        x = column * style.WIDTH_IN / 2 + _LEFT + (room - wide) / 2
        y = height - heading - row * (tall + _ABOVE + _BELOW) - _ABOVE - tall
        axes = place(figure, (x, y, wide, tall))
        scale, entries = draw_map(axes, one, sky)
        legend.update(entries)
        draw_net(axes, counts.pointing)
        if draw_skyline(axes, one, counts.rock_share):
            legend["Skyline"] = Line2D([], [], color=style.INK, linewidth=style.LINE_WIDTH)
        target = draw_target(axes, one)
        if target is not None:
            legend["Target"] = target
        label_angles(axes, 7, 7)
        axes.set_title(
            _title(one.quantity, counts), fontsize=style.HEADING_SIZE, fontweight="bold",
            loc="left", color=style.INK, pad=16,
        )  # fmt: skip
        draw_colour_bar(figure, (x, y - 0.55, wide, 0.12), one, scale)
    order = [key for key in ("Target", "Skyline", "Open sky", "Unknown") if key in legend]
    if order:
        figure.legend(
            [legend[key] for key in order], order, loc="lower center", ncol=len(order),
            frameon=False, fontsize=style.TEXT_SIZE, handlelength=1.8, columnspacing=2.2,
        )  # fmt: skip
    return figure


def _aimed_at_target(one: TrajectoryMap) -> TrajectoryMap:
    """Return a raster whose metadata point at the target, which muograms always do."""
    aimed = {
        key: one.metadata[target]
        for key, target in (
            ("BORESIGHT_AZIMUTH", "TARGET_AZIMUTH"),
            ("BORESIGHT_ELEVATION", "TARGET_ELEVATION_ANGLE"),
        )
    }
    return replace(one, metadata={**one.metadata, **aimed})


def _title(quantity: str, counts: TelescopeCounts) -> str:
    plan = counts.plan
    if quantity == "density_resolution":
        return f"Smallest density contrast seen at {plan.sigma:g} σ"
    if quantity == "contrast_days":
        return f"Days to see {plan.contrast_percent:+g} % of density".replace("-", "−")
    return counts.maps[quantity].kind.title


def _told(counts: TelescopeCounts) -> list[str]:
    geometry, plan = counts.geometry, counts.plan
    merged = "" if plan.merge == 1 else f"  ·  {plan.merge} × {plan.merge} trajectories merged"
    pointing, aim = counts.pointing, counts.maps["counts"].metadata
    boresight = ""
    if (pointing.azimuth_deg, pointing.elevation_deg) != (
        aim["TARGET_AZIMUTH"],
        aim["TARGET_ELEVATION_ANGLE"],
    ):
        boresight = (
            f"  ·  boresight {pointing.azimuth_deg % 360:.1f}°, {pointing.elevation_deg:.1f}° up"
        )
    roll = f"  ·  roll {counts.pointing.roll_deg:g}°" if counts.pointing.roll_deg else ""
    total, rock = (
        number_label(float(f"{counts.rate_per_day(behind_rock=one):.4g}")) for one in (False, True)
    )
    rates = f"{total} muons a day along known trajectories, {rock} of them behind rock"
    return [
        f"{geometry.bars_x} × {geometry.bars_y} bars of {geometry.pixel_size_cm:g} cm, planes "
        f"{geometry.separation_cm:g} cm apart{merged}{boresight}{roll}",
        rates,
    ]
