"""What rock leaves: transmission and flux against opacity, for each zenith angle."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...radiography.comparison import AttenuationCurve, Comparison
from ...radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ...radiography.spectra import MODELS
from .. import charts, style, ticks
from . import looks
from .energy_spectra import reference_model

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

TITLE = "Muons behind rock"
_HEAD_IN, _MAIN_IN, _FOOT_IN, _LEGEND_IN = 1.12, 3.0, 0.5, 0.25
_MIDDLE_IN = 0.75
#: Smallest values shown.
_LEAST_TRANSMISSION, _LEAST_FLUX = 1e-7, 1e-5

HEIGHT_IN = _HEAD_IN + _MAIN_IN + _FOOT_IN + _LEGEND_IN


def draw(figure: Figure, top_in: float, comparison: Comparison) -> None:
    """Draw transmission and flux from a distance below the top of a figure (inches)."""
    reference = reference_model(comparison)
    style.add_heading(
        figure,
        TITLE,
        [
            f"Lines: {MODELS[reference].title}, faded outside its range. Bands: from the smallest "
            "to the largest of the models that hold (two or more)."
        ],
        top_in=top_in,
    )
    width = (style.WIDTH_IN - charts.LEFT_IN - charts.RIGHT_IN - _MIDDLE_IN) / 2
    top = top_in + _HEAD_IN
    transmission = charts.place(figure, charts.LEFT_IN, top, width, _MAIN_IN)
    flux = charts.place(figure, charts.LEFT_IN + width + _MIDDLE_IN, top, width, _MAIN_IN)
    colours = looks.zenith_colours(len(comparison.zenith_deg))
    for angle, colour in zip(comparison.zenith_deg, colours):
        curves = [one for one in comparison.attenuations if one.zenith_deg == angle]
        line = next(one for one in curves if one.model == reference)
        _draw_band(transmission, curves, colour, with_sky=True)
        _draw_band(flux, curves, colour, with_sky=False)
        looks.faded_line(
            transmission, line.opacity_g_cm2, line.transmission,
            line.holds & line.sky_holds, colour, "-",
        )  # fmt: skip
        looks.faded_line(flux, line.opacity_g_cm2, line.flux, line.holds, colour, "-")
    highest = max(float(np.nanmax(one.flux)) for one in comparison.attenuations)
    charts.log_axis(transmission, "y", _LEAST_TRANSMISSION, 1.0, 8)
    charts.log_axis(flux, "y", _LEAST_FLUX, 10.0 ** np.ceil(np.log10(highest)), 10)
    charts.label(transmission, y="Transmission (flux / open sky)")
    charts.label(flux, y="Muon flux (cm⁻² sr⁻¹ day⁻¹)")
    opacity = comparison.attenuations[0].opacity_g_cm2
    for axes in (transmission, flux):
        charts.log_axis(axes, "x", opacity[0], opacity[-1])
        _mark(axes, comparison)
        charts.label(axes, x="Opacity (g/cm²)")
        _add_thickness(axes, comparison)
    _draw_legend(figure, top + _MAIN_IN + _FOOT_IN, comparison, colours)


def _draw_band(axes: Axes, curves: list[AttenuationCurve], colour: str, with_sky: bool) -> None:
    """Fill between the smallest and the largest of the models that hold."""
    name = "transmission" if with_sky else "flux"
    values = np.array(
        [
            np.where(one.holds & (one.sky_holds or not with_sky), getattr(one, name), np.nan)
            for one in curves
        ]
    )
    several = np.count_nonzero(np.isfinite(values), axis=0) > 1
    low = np.where(several, np.fmin.reduce(values), np.nan)
    high = np.where(several, np.fmax.reduce(values), np.nan)
    axes.fill_between(curves[0].opacity_g_cm2, low, high, color=colour, alpha=0.22, linewidth=0)


def _mark(axes: Axes, comparison: Comparison) -> None:
    axes.axvline(
        comparison.opacity_g_cm2, color=style.MUTED, linestyle=":",
        linewidth=style.THIN_LINE_WIDTH,
    )  # fmt: skip
    low, high = np.log(axes.get_xlim())
    right_half = np.log(comparison.opacity_g_cm2) > 0.5 * (low + high)
    axes.text(
        comparison.opacity_g_cm2, 0.02, f" {ticks.number_label(comparison.thickness_m)} m ",
        ha="right" if right_half else "left", transform=axes.get_xaxis_transform(),
        fontsize=style.TICK_SIZE, color=style.MUTED,
    )  # fmt: skip


def _add_thickness(axes: Axes, comparison: Comparison) -> None:
    """Give the top of the axes the thickness that goes with the opacity."""
    per_metre = comparison.physics.density * G_CM2_PER_M_WATER_EQUIVALENT
    top = axes.twiny()
    style.style_axes(top)
    low, high = axes.get_xlim()
    charts.log_axis(top, "x", low / per_metre, high / per_metre)
    top.set_xlabel(
        f"Thickness at {comparison.physics.density:g} g/cm³ (m)",
        fontsize=style.TEXT_SIZE, labelpad=4,
    )  # fmt: skip


def _draw_legend(figure: Figure, top_in: float, comparison: Comparison, colours: list[str]) -> None:
    from matplotlib.lines import Line2D

    charts.legend(
        figure,
        top_in,
        [Line2D([], [], color=colour, linewidth=1.6) for colour in colours],
        [f"zenith {ticks.number_label(angle)}°" for angle in comparison.zenith_deg],
        min(len(colours), 8),
    )
