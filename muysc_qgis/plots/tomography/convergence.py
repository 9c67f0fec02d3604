"""How a reconstruction approached the data, and what it leaves of each station's."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...workflows.tomography_result import Tomography
from .. import charts, style, ticks

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

TITLE = "Misfit by iteration and by station"

#: Width of the left chart, space between both, heights (inches).
_CURVE, _BETWEEN, _HEAD, _CHART, _FOOT = 4.3, 0.85, 0.85, 3.0, 1.05

#: Names of stations that fit below their bars (inches for each, letters of each).
_NAME_IN, _LETTERS = 0.19, 12

#: Logarithmic scale where the misfit falls by more than this factor.
_STEEP = 20.0


def convergence_figure(tomography: Tomography, discrepancy: float = 1.0) -> Figure:
    """Draw the misfit against the iterations, and the residual of every station.

    Parameters
    ----------
    tomography
        What was computed.
    discrepancy
        Multiple of the data's errors at which fitting was to end; 0 for never.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    figure = style.new_figure(style.WIDTH_IN, _HEAD + _CHART + _FOOT)
    known = bool(np.isfinite([one.chi_squared for one in tomography.residuals]).any())
    told = "over their errors" if known else "over the data's own, as errors are not known"
    style.add_heading(figure, TITLE, [f"Root mean square of what is left of the data, {told}."])
    left = charts.LEFT_IN
    _draw_curve(
        charts.place(figure, left, _HEAD, _CURVE, _CHART), tomography,
        discrepancy if known else 0.0,
    )  # fmt: skip
    right = left + _CURVE + _BETWEEN
    _draw_stations(
        charts.place(figure, right, _HEAD, style.WIDTH_IN - right - charts.RIGHT_IN, _CHART),
        tomography, known,
    )  # fmt: skip
    return figure


def _draw_curve(axes: Axes, tomography: Tomography, level: float) -> None:
    found = tomography.reconstruction
    misfit = found.misfit
    # Methods that know it at the end alone have two values.
    iterations = (
        np.arange(len(misfit))
        if len(misfit) == found.iterations_done + 1
        else np.array([0, found.iterations_done])[-len(misfit) :]
    )
    line = "-" if len(misfit) > 2 else (0, (2, 2))
    axes.plot(iterations, misfit, color=style.DETECTOR, linewidth=1.5, linestyle=line)
    axes.plot(
        iterations[-1:], misfit[-1:], marker="o", markersize=7, color=style.RAY, linestyle="none",
        clip_on=False, zorder=4, label=f"{misfit[-1]:.3g} after {found.iterations_done} iterations",
    )  # fmt: skip
    positive = misfit[misfit > 0]
    shown = np.append(positive, level) if level else positive
    low, high = (float(shown.min()), float(shown.max())) if shown.size else (0.0, 1.0)
    if low > 0 and high / low > _STEEP:
        charts.short_log_axis(axes, "y", low / 1.4, high * 1.4)
    else:
        axes.set_ylim(0.0, 1.08 * high)
    most = max(1, found.iterations_done)
    axes.set_xlim(0, most)
    whole = ticks.multiples(0, most, max(1.0, ticks.round_step(most, 6)))
    axes.set_xticks(whole, [ticks.number_label(float(one)) for one in whole])
    if level:
        axes.axhline(
            level, color=style.MUTED, linestyle=(0, (5, 2)), linewidth=1.0,
            label="explained within the errors",
        )  # fmt: skip
    axes.legend(loc="best", fontsize=style.TICK_SIZE, framealpha=0.9, edgecolor="none")
    charts.label(axes, "Iterations", "Misfit")
    style.add_title(axes, "Where the reconstruction ended")


def _draw_stations(axes: Axes, tomography: Tomography, known: bool) -> None:
    residuals = tomography.residuals
    values = np.array(
        [np.sqrt(one.chi_squared) if known else 100 * one.relative for one in residuals]
    )
    places = np.arange(len(values))
    axes.bar(places, np.nan_to_num(values), color=style.DETECTOR, width=0.8)
    if known:
        axes.axhline(1.0, color=style.MUTED, linestyle=(0, (5, 2)), linewidth=1.0)
    axes.set_xlim(-0.6, len(values) - 0.4)
    width_in = axes.get_position().width * axes.figure.get_size_inches()[0]
    every = max(1, int(np.ceil(len(values) * _NAME_IN / width_in)))
    names = [
        one.name if len(one.name) <= _LETTERS else one.name[: _LETTERS - 1] + "…"
        for one in residuals
    ]
    axes.set_xticks(places[::every], [style.plain(name) for name in names[::every]], rotation=90)
    axes.grid(axis="x", visible=False)
    charts.label(axes, y="Residual / error" if known else "Residual / data (%)")
    style.add_title(axes, f"What is left of each of {len(values)} stations")
