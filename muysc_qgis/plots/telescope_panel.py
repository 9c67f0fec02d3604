"""What a telescope collects: maps with sections, the telescope and its aperture."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..telescope.acceptance import Trajectories, trajectories
from ..telescope.geometry import TelescopeGeometry
from ..telescope.presets import PRESETS
from ..trajectories import TrajectoryMap, maps_of
from . import style, ticks
from .frames import new_axes, page_axes
from .scales import draw_colour_bar
from .telescope_axes import (
    angle_ticks,
    draw_map,
    edges,
    label_angles,
)
from .telescope_drawing import draw_aperture, draw_telescope

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MAPS = ("acceptance", "solid_angle", "detection_area", "path_length")

#: Measures of the page (inches).
_MARGIN = 0.62
_MAP = 1.72
_SECTION = 0.72
_TOP_ROW = 2.55

_COLOURS = {"exact": style.DETECTOR, "paper": style.RAY}


def telescope_panel(collected: Trajectories, name: str) -> Figure:
    """Return the panel of one telescope.

    Above, the telescope with a muon, its aperture from the side and its acceptance by
    both formulas; below, four quantities as maps, each with the section through its
    middle.

    Parameters
    ----------
    collected
        From `trajectories`.
    name
        Key of `PRESETS`, or anything else for one's own.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    geometry = collected.geometry
    title, lines = telescope_title(name), describe_geometry(collected)
    heading = style.heading_height_in(title, lines)
    height = heading + _TOP_ROW + 0.55 + _SECTION + 0.12 + _MAP + 1.35
    figure = style.new_figure(style.WIDTH_IN, height)
    style.add_heading(figure, title, lines, _MARGIN - 0.4)
    top = height - heading - 0.1
    axes = new_axes(figure, (0.35, top - _TOP_ROW, 3.4, _TOP_ROW))
    draw_telescope(axes, geometry)
    axes = new_axes(figure, (3.75, top - _TOP_ROW + 0.15, 2.5, _TOP_ROW - 0.35))
    draw_aperture(axes, geometry)
    figure.text(
        5.0 / style.WIDTH_IN, (top - _TOP_ROW + 0.02) / height, "Aperture, from the side",
        ha="center", fontsize=style.TEXT_SIZE, color=style.MUTED,
    )  # fmt: skip
    _draw_formulas(new_axes(figure, (6.95, top - _TOP_ROW + 0.3, 2.8, _TOP_ROW - 0.55)), collected)
    maps = maps_of(collected, name)
    bottom = 1.2
    room = (style.WIDTH_IN - _MARGIN) / len(_MAPS)
    page = page_axes(figure)
    for number, key in enumerate(_MAPS):
        left = _MARGIN + number * room
        _draw_quantity(page, maps[key], left, bottom, first=number == 0)
    return figure


def telescope_title(name: str) -> str:
    """Return what a telescope is called in titles."""
    return f"Telescope {PRESETS[name].title}" if name in PRESETS else "Telescope"


def describe_geometry(collected: Trajectories) -> list[str]:
    """Return the telescope's numbers, two lines."""
    geometry = collected.geometry
    between = "" if geometry.planes == 2 else f" ({geometry.planes} planes)"
    count = f"{geometry.trajectories:,}".replace(",", "\u202f")
    return [
        f"{geometry.bars_x} × {geometry.bars_y} bars of {geometry.pixel_size_cm:g} cm  ·  outer "
        f"planes {geometry.separation_cm:g} cm apart{between}  ·  {count} trajectories, "
        f"{1e3 * geometry.step:.3g} mrad from one to the next",
        f"Largest acceptance {collected.acceptance_cm2_sr.max():.4g} cm² sr  ·  étendue "
        f"{collected.etendue_cm2_sr:.5g} cm² sr  ·  "
        + ("full integral" if collected.formula == "exact" else "formula of the paper"),
    ]


def _draw_quantity(page: Axes, one: TrajectoryMap, left: float, bottom: float, first: bool) -> None:
    """Draw one map with its section above and its colour scale below."""
    figure = page.figure
    x0, x1, y0, y1 = edges(one)
    tall = min(_MAP, _MAP * (y1 - y0) / (x1 - x0))
    wide = min(_MAP, _MAP * (x1 - x0) / (y1 - y0))
    x = left + (_MAP - wide) / 2
    y = bottom + _MAP - tall
    axes = new_axes(figure, (x, y, wide, tall))
    scale, _ = draw_map(axes, one)
    label_angles(axes, 4, 4 if tall == _MAP else 2, names=False)
    axes.set_xlabel("Angle to the right (°)", fontsize=style.TEXT_SIZE, labelpad=2)
    if first:
        axes.set_ylabel("Angle upwards (°)", fontsize=style.TEXT_SIZE, labelpad=2)
    section = new_axes(figure, (x, bottom + _MAP + 0.12, wide, _SECTION))
    _draw_section(section, one, x0, x1)
    style.add_title(section, one.kind.title)
    draw_colour_bar(page, (x, y - 0.58, wide, 0.1), one.values, scale, one.kind.label)


def _draw_section(axes: Axes, one: TrajectoryMap, left: float, right: float) -> None:
    """Draw the values along the middle row and the diagonal."""
    rows, columns = one.values.shape
    axes.plot(
        one.x,
        one.values[rows // 2],
        color=style.DETECTOR,
        linewidth=style.LINE_WIDTH,
        label="across",
    )
    if rows == columns:
        axes.plot(
            one.x, np.diag(one.values), color=style.RAY, linewidth=style.LINE_WIDTH,
            linestyle=(0, (4, 1.5)), label="diagonal",
        )  # fmt: skip
        if one.quantity == _MAPS[0]:
            axes.legend(frameon=False, fontsize=style.CONTOUR_SIZE, loc="upper left",
                        handlelength=1.2, borderaxespad=0.1, labelspacing=0.2)  # fmt: skip
    axes.set_xlim(left, right)
    finite = one.values[np.isfinite(one.values)]
    low, high = float(finite.min()), float(finite.max())
    if low < 0.5 * high:
        low = 0.0
    margin = 0.08 * (high - low) or 0.1 * high
    axes.set_ylim(low - (margin if low else 0), high + margin)
    step = ticks.round_step(high - low + margin, 4)
    positions = ticks.multiples(low, high + margin, step)
    axes.set_yticks(positions, [ticks.number_label(float(tick)) for tick in positions])
    axes.set_xticks(angle_ticks(left, right, 4)[0], [])
    style.style_axes(axes)
    style.add_grid(axes)


def _draw_formulas(axes: Axes, collected: Trajectories) -> None:
    """Draw the acceptance along the middle row by both formulas."""
    geometry: TelescopeGeometry = collected.geometry
    angle = np.degrees(np.arctan(geometry.step * geometry.offset_x))
    for formula in ("exact", "paper"):
        values = trajectories(geometry, formula).acceptance_cm2_sr[geometry.bars_y - 1]
        axes.plot(
            angle, values, color=_COLOURS[formula], linewidth=style.LINE_WIDTH,
            label="full integral" if formula == "exact" else "paper",
            linestyle="-" if formula == "exact" else (0, (4, 1.5)),
        )  # fmt: skip
    axes.set_ylim(0, None)
    axes.set_xlabel("Angle from the boresight (°)", fontsize=style.TEXT_SIZE, labelpad=2)
    style.add_title(axes, "Acceptance of a trajectory (cm² sr)")
    limit = max(geometry.half_aperture_deg[0], 1e-3)
    across = ticks.angle_ticks(-limit, limit, 6)
    axes.set_xticks(across, [ticks.number_label(float(tick)) for tick in across])
    style.add_grid(axes)
    style.style_axes(axes)
    axes.legend(frameon=False, fontsize=style.TICK_SIZE, loc="upper right", handlelength=1.6)
