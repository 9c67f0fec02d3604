"""Pictures of the muon sky: beside measurements, its error, and what altitude does."""

from __future__ import annotations

from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from muysc_qgis.plots import charts, style
from muysc_qgis.radiography.muon_sky import muon_sky
from muysc_qgis.radiography.spectra import kinetic_from_momentum

from . import sky_rows

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_COLOURS = ("#d81b60", "#0072b2", "#009e73", "#e69f00", "#56b4e9", "#cc79a7", "#1a1a1a", "#7f7f7f")
_CELL_IN, _GAP_IN, _TOP_IN = 1.55, 0.55, 0.95


def measured() -> Figure:
    """Draw every measured spectrum over the muon sky, by bands of the zenith angle."""
    bands = (("Vertical", 0, 20), ("30°", 25, 45), ("60°", 50, 65), ("75° to 80°", 70, 85))
    spectra = sky_rows.all_spectra()
    figure = style.new_figure(style.WIDTH_IN, _TOP_IN + len(bands) * (_CELL_IN + _GAP_IN))
    style.add_heading(
        figure, "Measured spectra over the muon sky",
        ["Shaded: its standard error. Only BESS-TeV and L3+C took part in the fit; error bars "
         "where the source gives them."],
    )  # fmt: skip
    width = style.WIDTH_IN - charts.LEFT_IN - charts.RIGHT_IN - 1.6
    for number, (title, low, high) in enumerate(bands):
        top = _TOP_IN + number * (_CELL_IN + _GAP_IN)
        axes = charts.place(figure, charts.LEFT_IN, top, width, _CELL_IN)
        chosen = [(name, one) for name, one in spectra if low <= one.zenith_deg[0] < high]
        _band(axes, float(np.mean([one.zenith_deg[0] for _, one in chosen])))
        for colour, (name, one) in zip(_COLOURS, chosen):
            model = sky_rows.model_flux(one)
            error = np.nan_to_num(one.error / model)
            axes.errorbar(
                one.momentum_gev, one.flux / model, error, fmt="o", markersize=2.4,
                elinewidth=0.5, color=colour, label=name, linewidth=0,
            )  # fmt: skip
        axes.axhline(1.0, color=style.MUTED, linewidth=style.THIN_LINE_WIDTH)
        charts.log_axis(axes, "x", 0.5, 3000.0)
        axes.set_ylim(0.6, 1.6)
        axes.set_title(title, fontsize=style.HEADING_SIZE, loc="left", pad=3)
        axes.legend(
            frameon=False, fontsize=style.TICK_SIZE, loc="upper left", bbox_to_anchor=(1.0, 1.0)
        )
        last = number == len(bands) - 1
        charts.label(axes, x="Momentum (GeV/c)" if last else "", y="Measured over model")
    return figure


def _band(axes: Axes, zenith_deg: float) -> None:
    momentum = np.geomspace(0.5, 3000.0, 100)
    error = muon_sky().relative_error(
        kinetic_from_momentum(momentum), np.cos(np.radians(zenith_deg)), 0.0
    )
    axes.fill_between(momentum, 1 - error, 1 + error, color=style.SKY, linewidth=0, zorder=0)


def altitude(mulder: ModuleType | None) -> Figure:
    """Draw the flux at altitudes over that at the sea, with mulder's and the old law beside it."""
    from muysc_qgis.radiography.altitude import altitude_factor

    figure = style.new_figure(style.WIDTH_IN, 3.6)
    style.add_heading(
        figure, "What altitude does",
        ["Flux at an altitude over that at the sea. Lines: the muon sky; crosses: losses and "
         "decay by mulder;", "dotted: the law exp(h/h₀) of the formulas, which has no angle."],
    )  # fmt: skip
    width = (style.WIDTH_IN - charts.LEFT_IN - charts.RIGHT_IN - 0.9) / 3
    momentum = np.geomspace(2.0, 1000.0, 40)
    crosses = np.geomspace(20.0, 1000.0, 6)
    for number, height in enumerate(sky_rows.ALTITUDES_M):
        axes = charts.place(figure, charts.LEFT_IN + number * (width + 0.45), 0.95, width, 2.1)
        for colour, zenith in zip(_COLOURS, sky_rows.ZENITHS_DEG):
            cosine, kinetic = np.cos(np.radians(zenith)), kinetic_from_momentum(momentum)
            ratio = muon_sky().flux(kinetic, cosine, height) / muon_sky().flux(kinetic, cosine, 0.0)
            axes.plot(momentum, ratio, color=colour, linewidth=1.2, label=f"zenith {zenith:g}°")
            if mulder is not None:
                _, other = sky_rows.altitude_factors(mulder, height, zenith, crosses)
                axes.plot(crosses, other, "x", color=colour, markersize=4)
        axes.plot(momentum, altitude_factor(momentum, height), ":", color=style.INK, linewidth=1.0)
        charts.log_axis(axes, "x", 2.0, 1000.0)
        axes.set_title(f"{height:g} m", fontsize=style.HEADING_SIZE, loc="left", pad=3)
        charts.label(axes, x="Momentum (GeV/c)", y="Ratio" if number == 0 else "")
        if number == 0:
            axes.legend(frameon=False, fontsize=style.TICK_SIZE, loc="upper right")
    return figure
