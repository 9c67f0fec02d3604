"""Differential spectra: one cell for each zenith angle, all models in it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...radiography.comparison import Comparison, SpectrumCurve
from ...radiography.measured_spectra import carried_to
from ...radiography.spectra import DEFAULT_MODEL, MODELS
from .. import charts, style, ticks
from . import looks

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

TITLE = "Differential muon spectra"
_COLUMNS = 3
#: Heights (inches) of heading with legend, of a cell's two axes, and below them.
_HEAD_IN, _MAIN_IN, _RATIO_IN, _GAP_IN, _FOOT_IN, _CELL_TITLE_IN = 1.1, 2.1, 0.8, 0.06, 0.5, 0.24
_BETWEEN_IN = 0.12
#: How measured points look.
_DOTS = {"markersize": 2.2, "markeredgewidth": 0.4, "markerfacecolor": "white"}
_POINTS = {**_DOTS, "elinewidth": 0.4, "zorder": 3}
#: Ratios shown.
_RATIOS = (0.4, 1.6)


def height_in(comparison: Comparison) -> float:
    """Return the height that `draw` takes (inches)."""
    rows = -(-len(comparison.zenith_deg) // _columns(comparison))
    return _HEAD_IN + rows * (_CELL_TITLE_IN + _MAIN_IN + _GAP_IN + _RATIO_IN + _FOOT_IN)


def _columns(comparison: Comparison) -> int:
    """Return how many cells stand side by side; four make a square."""
    count = len(comparison.zenith_deg)
    return 2 if count == 4 else min(count, _COLUMNS)


def reference_model(comparison: Comparison) -> str:
    """Return the model that others are divided by: the default one where it takes part."""
    return DEFAULT_MODEL if DEFAULT_MODEL in comparison.models else comparison.models[0]


def draw(figure: Figure, top_in: float, comparison: Comparison) -> None:
    """Draw the spectra from a distance below the top of a figure (inches)."""
    reference = reference_model(comparison)
    style.add_heading(figure, TITLE, _lines(comparison, reference), top_in=top_in)
    columns = _columns(comparison)
    width = style.WIDTH_IN - charts.LEFT_IN - charts.RIGHT_IN
    cell_in = (width + _BETWEEN_IN) / columns - _BETWEEN_IN
    lowest, highest = _limits(comparison)
    for number, angle in enumerate(comparison.zenith_deg):
        row, column = divmod(number, columns)
        left = charts.LEFT_IN + column * (cell_in + _BETWEEN_IN)
        top = top_in + _HEAD_IN + _CELL_TITLE_IN
        top += row * (_CELL_TITLE_IN + _MAIN_IN + _GAP_IN + _RATIO_IN + _FOOT_IN)
        main = charts.place(figure, left, top, cell_in, _MAIN_IN)
        ratio = charts.place(figure, left, top + _MAIN_IN + _GAP_IN, cell_in, _RATIO_IN)
        curves = [one for one in comparison.spectra if one.zenith_deg == angle]
        _draw_cell(main, ratio, curves, comparison, reference)
        charts.log_axis(main, "y", lowest, highest, 5)
        main.set_title(
            f"Zenith angle {ticks.number_label(angle)}°",
            fontsize=style.HEADING_SIZE, loc="left", pad=3,
        )  # fmt: skip
        _draw_counted(main, angle, comparison, reference)
        main.set_xticklabels([])
        charts.label(ratio, x="Kinetic energy (GeV)")
        if column == 0:
            charts.label(main, y="dI/dE (cm⁻² s⁻¹ sr⁻¹ GeV⁻¹)")
            charts.label(ratio, y="Ratio")
        else:
            main.set_yticklabels([])
            ratio.set_yticklabels([])
    _draw_legend(figure, top_in, comparison)


def _lines(comparison: Comparison, reference: str) -> list[str]:
    altitude = comparison.altitude_m if comparison.physics.altitude_counts else 0.0
    where = "at sea level" if altitude == 0 else f"at {altitude:g} m above sea level"
    band = " Shaded: its standard error." if MODELS[reference].tabulated else ""
    return [
        f"Muons from the open sky {where}; below, each model divided by "
        f"{MODELS[reference].title}.{band} Faded: outside what a model is made for."
    ]


def _limits(comparison: Comparison) -> tuple[float, float]:
    """Return whole decades around the curves; what lies far below is cut."""
    values = np.concatenate([one.flux for one in comparison.spectra])
    values = values[np.isfinite(values) & (values > 0)]
    return 10.0 ** np.floor(np.log10(values.min())), 10.0 ** np.ceil(np.log10(values.max()))


def _draw_cell(
    main: Axes, ratio: Axes, curves: list[SpectrumCurve], comparison: Comparison, reference: str
) -> None:
    base = next(one for one in curves if one.model == reference)
    for one in curves:
        colour, line = looks.MODEL_LOOKS[one.model]
        looks.faded_line(main, one.kinetic_energy_gev, one.flux, one.holds, colour, line)
        looks.faded_line(
            ratio, one.kinetic_energy_gev, one.flux / base.flux, one.holds, colour, line
        )
        if np.isfinite(one.error).any():
            _draw_band(main, ratio, one, base, colour)
    _draw_measured(main, ratio, base, comparison)
    energy = base.kinetic_energy_gev
    for axes in (main, ratio):
        charts.log_axis(axes, "x", energy[0], energy[-1], 3)
    ratio.set_ylim(*_RATIOS)
    ratio.set_yticks([0.5, 1.0, 1.5], ["0.5", "1", "1.5"])


def _draw_band(
    main: Axes, ratio: Axes, one: SpectrumCurve, base: SpectrumCurve, colour: str
) -> None:
    """Shade one standard error to either side of a model."""
    low, high = one.flux * (1.0 - one.error), one.flux * (1.0 + one.error)
    look = {"color": colour, "alpha": looks.BAND, "linewidth": 0, "zorder": 1}
    main.fill_between(one.kinetic_energy_gev, low, high, **look)
    ratio.fill_between(one.kinetic_energy_gev, low / base.flux, high / base.flux, **look)


def _draw_measured(main: Axes, ratio: Axes, base: SpectrumCurve, comparison: Comparison) -> None:
    """Draw the measured points near an angle, carried there by the muon sky."""
    altitude = comparison.altitude_m if comparison.physics.altitude_counts else 0.0
    ln_energy = np.log(base.kinetic_energy_gev)
    for name, (energy, flux, error) in carried_to(base.zenith_deg, altitude).items():
        inside = (energy >= base.kinetic_energy_gev[0]) & (energy <= base.kinetic_energy_gev[-1])
        energy, flux, error = energy[inside], flux[inside], error[inside]
        reference = np.exp(np.interp(np.log(energy), ln_energy, np.log(base.flux)))
        look = {"fmt": looks.MEASURED[name], "color": looks.POINTS, "linewidth": 0, **_POINTS}
        main.errorbar(energy, flux, error, **look)
        ratio.errorbar(energy, flux / reference, error / reference, **look)


def _draw_counted(axes: Axes, angle: float, comparison: Comparison, reference: str) -> None:
    """Shade the muons that get through the thickness asked for."""
    start = comparison.minimum_energy_gev
    if not np.isfinite(start):
        return
    base = next(
        one for one in comparison.spectra if one.zenith_deg == angle and one.model == reference
    )
    behind = next(
        one for one in comparison.behind if one.zenith_deg == angle and one.model == reference
    )
    energy = np.concatenate(([start], base.kinetic_energy_gev[base.kinetic_energy_gev > start]))
    flux = np.exp(np.interp(np.log(energy), np.log(base.kinetic_energy_gev), np.log(base.flux)))
    axes.fill_between(
        energy, flux, axes.get_ylim()[0], color=looks.COUNTED, alpha=0.55, linewidth=0, zorder=0
    )
    axes.axvline(start, color=style.MUTED, linewidth=style.THIN_LINE_WIDTH, linestyle=":")
    axes.text(
        0.97, 0.95,
        f"> {ticks.number_label(float(f'{start:.4g}'))} GeV:\n"
        f"{ticks.number_label(float(f'{behind.flux[0]:.3g}'))} cm⁻² sr⁻¹ day⁻¹",
        transform=axes.transAxes, ha="right", va="top", fontsize=style.TICK_SIZE, color=style.INK,
        linespacing=1.3,
    )  # fmt: skip


def _draw_legend(figure: Figure, top_in: float, comparison: Comparison) -> None:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    artists: list[object] = []
    for name in comparison.models:
        colour, line = looks.MODEL_LOOKS[name]
        artists.append(Line2D([], [], color=colour, linestyle=line, linewidth=1.3))
    labels = [MODELS[name].title for name in comparison.models]
    nearest = min(comparison.zenith_deg)
    for name in carried_to(nearest, 0.0):
        artists.append(
            Line2D([], [], color=looks.POINTS, linestyle="", marker=looks.MEASURED[name], **_DOTS)
        )
        labels.append(f"{name}, scaled to the angle")
    if np.isfinite(comparison.minimum_energy_gev):
        artists.append(Patch(facecolor=looks.COUNTED, alpha=0.55, linewidth=0))
        labels.append(
            f"through {ticks.number_label(comparison.thickness_m)} m of rock "
            f"({MODELS[reference_model(comparison)].title})"
        )
    charts.legend(figure, top_in + 0.66, artists, labels, 4)
