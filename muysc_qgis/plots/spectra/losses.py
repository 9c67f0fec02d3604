"""Energy loss: stopping power of materials, and the energy that rock demands."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...radiography.comparison import Comparison
from ...radiography.energy_loss import LESPARRE_LIMIT_GEV
from ...radiography.materials import MATERIALS
from .. import charts, style, ticks
from . import looks

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

TITLE = "Energy loss in rock"
_HEAD_IN, _MAIN_IN, _RATIO_IN, _GAP_IN, _FOOT_IN = 0.95, 2.7, 1.1, 0.08, 0.55
_MIDDLE_IN = 0.75
#: Differences shown, percent.
_PERCENT = (-30.0, 50.0)
#: Stopping powers shown, MeV cm²/g.
_STOPPING = (1.0, 1e3)

HEIGHT_IN = _HEAD_IN + _MAIN_IN + _GAP_IN + _RATIO_IN + _FOOT_IN

LAW_TITLES = {
    "csda": "Range table (csda)",
    "lesparre": "Polynomial, integrated (lesparre)",
    "paper": "Polynomial, E/S (paper)",
}


def draw(figure: Figure, top_in: float, comparison: Comparison) -> None:
    """Draw the energy losses from a distance below the top of a figure (inches)."""
    physics = comparison.physics
    style.add_heading(
        figure,
        TITLE,
        [
            "Left: mean loss in each material beside the polynomial of Lesparre et al. for "
            "standard rock; grey: above the 1 TeV it is fitted to.",
            f"Right: kinetic energy that {MATERIALS[physics.material].title.lower()} of "
            f"{physics.density:g} g/cm³ demands by the three range laws.",
        ],
        top_in=top_in,
    )
    width = (style.WIDTH_IN - charts.LEFT_IN - charts.RIGHT_IN - _MIDDLE_IN) / 2
    top = top_in + _HEAD_IN
    pairs = []
    for left in (charts.LEFT_IN, charts.LEFT_IN + width + _MIDDLE_IN):
        pairs.append(
            (
                charts.place(figure, left, top, width, _MAIN_IN),
                charts.place(figure, left, top + _MAIN_IN + _GAP_IN, width, _RATIO_IN),
            )
        )
    _draw_stopping(*pairs[0], comparison)
    _draw_minimum_energy(*pairs[1], comparison)


def _draw_stopping(main: Axes, below: Axes, comparison: Comparison) -> None:
    energy = comparison.losses[0].kinetic_energy_gev
    for index, one in enumerate(comparison.losses):
        colour, line = looks.material_look(index)
        look = {"color": colour, "linestyle": line, "linewidth": 1.2}
        main.plot(energy, one.stopping_power, label=MATERIALS[one.material].title, **look)
        below.plot(energy, 100 * (one.polynomial / one.stopping_power - 1), **look)
    fitted = energy <= LESPARRE_LIMIT_GEV
    polynomial = comparison.losses[0].polynomial
    look = {"color": style.INK, "linestyle": (0, (1, 1)), "linewidth": 1.8}
    main.plot(energy[fitted], polynomial[fitted], label="Polynomial of Lesparre et al.", **look)
    main.plot(energy, polynomial, alpha=looks.FADED, **look)
    for axes in (main, below):
        axes.axvspan(LESPARRE_LIMIT_GEV, energy[-1], color="#ececec", zorder=0, linewidth=0)
        charts.log_axis(axes, "x", energy[0], energy[-1])
    charts.log_axis(main, "y", *_STOPPING)
    main.set_xticklabels([])
    below.set_ylim(*_PERCENT)
    below.axhline(0, color=style.MUTED, linewidth=style.THIN_LINE_WIDTH)
    main.legend(frameon=False, fontsize=style.TICK_SIZE, loc="upper left", labelspacing=0.3)
    charts.label(main, y="Stopping power (MeV cm²/g)")
    charts.label(below, x="Kinetic energy (GeV)", y="Polynomial\n− table (%)")


def _draw_minimum_energy(main: Axes, below: Axes, comparison: Comparison) -> None:
    table = next(one for one in comparison.minimum_energies if one.energy_loss == "csda")
    highest = np.nanmax(table.minimum_energy_gev)
    for one in comparison.minimum_energies:
        colour, line = looks.LAW_LOOKS[one.energy_loss]
        look = {"color": colour, "linestyle": line, "linewidth": 1.3}
        main.plot(
            one.thickness_m, one.minimum_energy_gev, label=LAW_TITLES[one.energy_loss], **look
        )
        below.plot(
            one.thickness_m, 100 * (one.minimum_energy_gev / table.minimum_energy_gev - 1), **look
        )
    for axes in (main, below):
        charts.log_axis(axes, "x", 1.0, table.thickness_m[-1])
        axes.axvline(
            comparison.thickness_m, color=style.MUTED, linestyle=":",
            linewidth=style.THIN_LINE_WIDTH,
        )  # fmt: skip
    charts.log_axis(main, "y", 0.1, 10.0 ** np.ceil(np.log10(highest)))
    if np.isfinite(comparison.minimum_energy_gev):
        main.plot(
            [comparison.thickness_m], [comparison.minimum_energy_gev], marker="o", markersize=5,
            markerfacecolor=looks.COUNTED, markeredgecolor=style.INK, linestyle="none",
            label=f"{ticks.number_label(comparison.thickness_m)} m: "
            f"{ticks.number_label(float(f'{comparison.minimum_energy_gev:.4g}'))} GeV "
            f"({comparison.physics.energy_loss})",
        )  # fmt: skip
    main.set_xticklabels([])
    below.set_ylim(*_PERCENT)
    below.axhline(0, color=style.MUTED, linewidth=style.THIN_LINE_WIDTH)
    main.legend(frameon=False, fontsize=style.TICK_SIZE, loc="upper left", labelspacing=0.3)
    charts.label(main, y="Minimum kinetic energy (GeV)")
    charts.label(below, x="Thickness (m)", y="Law −\ncsda (%)")
