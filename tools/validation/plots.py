"""The pictures of the validation: the differences at a glance, and what the models do."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from muysc_qgis.plots import charts, style
from muysc_qgis.plots.documents import panel
from muysc_qgis.plots.spectra import documents, looks
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.comparison import compare
from muysc_qgis.radiography.constants import SECONDS_PER_DAY
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.spectra import MODELS
from muysc_qgis.radiography.transmission import attenuate
from muysc_qgis.workflows.simulation import Telescope, simulate

from . import mulder_rows, sky_plots
from .row import Row
from .terrain_rows import P1, VESUVIUS, Station

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_DPI = 85
_ROW_IN = 0.155
_LABELS_IN = 5.6


def save_all(folder: Path, rows: Sequence[Row]) -> list[Path]:
    """Draw every picture into a folder and return the files."""
    folder.mkdir(parents=True, exist_ok=True)
    materials = ["water", "ice", "limestone", "granite", "basalt"]
    angles = (0.0, 30.0, 60.0, 75.0, 85.0)
    comparison = compare(list(MODELS), angles, 500.0, Physics(), 0.0, materials)
    figures = {
        "sky_measured": sky_plots.measured(),
        "sky_altitude": sky_plots.altitude(mulder_rows.load()),
        "spectra": documents.spectrum_figure(comparison),
        "energy_loss": documents.loss_figure(comparison),
        "attenuation": documents.attenuation_figure(comparison),
        "differences": differences(rows),
        "transport": transport(rows),
        "machin_p1": _muograms(P1),
        "vesuvius": _muograms(VESUVIUS),
    }
    files = []
    for name, figure in figures.items():
        files.append(folder / f"{name}.png")
        style.save_png(figure, files[-1], _DPI)
    return files


def _muograms(station: Station) -> Figure:
    """Draw thickness and flux as the algorithm does."""
    simulation = simulate(station.sight(), Aperture(60, 26, 120, 60), Physics(), Telescope())
    return panel(simulation)


def differences(rows: Sequence[Row]) -> Figure:
    """Draw every difference with the tolerance it must keep."""
    compared = [row for row in rows if not np.isnan(row.difference)]
    sections = list(dict.fromkeys(row.section for row in compared))
    height = 1.25 + _ROW_IN * (len(compared) + len(sections))
    figure = style.new_figure(style.WIDTH_IN, height)
    style.add_heading(
        figure, "Differences from the references",
        ["Bars: what counts as agreement; hollow: not required. Dots: ours over the reference, "
         "less 1; 0 within an interval."],
    )  # fmt: skip
    axes = charts.place(figure, _LABELS_IN, 0.75, style.WIDTH_IN - _LABELS_IN - 0.25, height - 1.25)
    labels, places, at = [], [], 0
    for section in sections:
        axes.text(
            0.0, at, section, transform=axes.get_yaxis_transform(), fontsize=style.TICK_SIZE,
            fontweight="bold", color=style.INK, va="center", ha="right",
        )  # fmt: skip
        at += 1
        for row in (one for one in compared if one.section == section):
            if row.tolerance is not None:
                width = 100 * row.tolerance
                axes.barh(at, 2 * width, left=-width, height=0.8, color=style.SKY, zorder=1)
            axes.plot(
                [100 * row.difference], [at], "o", markersize=3.5, zorder=3,
                color=style.DETECTOR if row.agrees else style.RAY,
                markerfacecolor="white" if row.tolerance is None else None,
            )  # fmt: skip
            labels.append(style.plain(row.what))
            places.append(at)
            at += 1
    axes.set_ylim(at - 0.3, -0.7)
    axes.set_yticks(places, labels, fontsize=6.5)
    # Small differences are told apart, large ones still fit.
    axes.set_xscale("symlog", linthresh=1.0)
    axes.set_xlim(-200, 6000)
    axes.set_xticks([-100, -10, -1, 0, 1, 10, 100, 1000],
                    ["−100", "−10", "−1", "0", "1", "10", "100", "1000"])  # fmt: skip
    axes.axvline(0, color=style.MUTED, linewidth=style.THIN_LINE_WIDTH, zorder=2)
    axes.minorticks_off()
    charts.label(axes, x="Difference (%)")
    return figure


def transport(rows: Sequence[Row]) -> Figure:
    """Draw intensities against depth for two zenith angles, with full transport beside them."""
    figure = style.new_figure(style.WIDTH_IN, 4.6)
    style.add_heading(
        figure, "Intensity behind rock",
        ["Left: the model against depth; squares: full transport, with the zenith angle. Right: "
         "differences at those points; blue: 15 %."],
    )  # fmt: skip
    width = (style.WIDTH_IN - charts.LEFT_IN - charts.RIGHT_IN - 0.75) / 2
    left = charts.place(figure, charts.LEFT_IN, 0.75, width, 3.3)
    right = charts.place(figure, charts.LEFT_IN + width + 0.75, 0.75, width, 3.3)
    depth = np.geomspace(0.1, 12.0, 80)
    for zenith, line in ((0.0, "-"), (75.0, "--")):
        flux = attenuate(depth * 1e5, np.array(90.0 - zenith), Physics(flux_model="guan")).flux
        left.plot(depth, flux / SECONDS_PER_DAY, line, color=style.INK, linewidth=1.2,
                  label=f"Guan et al., zenith {zenith:g}°")  # fmt: skip
    for model in ("gsf-sibyll", "gaisser-tang", "guan", "reyna-bugaev"):
        colour, _ = looks.MODEL_LOOKS[model]
        points = [
            row for row in rows
            if row.section == "Intensity behind rock" and row.what.endswith(f", {model}")
        ]  # fmt: skip
        depths = [float(row.what.split(" km")[0]) for row in points]
        right.plot(depths, [100 * row.difference for row in points], "o", color=colour,
                   label=MODELS[model].title)  # fmt: skip
    for row in rows:
        if row.section == "Intensity behind rock" and row.what.endswith(", guan"):
            left.plot(
                [float(row.what.split(" km")[0])], [row.reference], "s", color=style.RAY,
                markersize=5,
            )  # fmt: skip
            left.annotate(
                row.what.split("zenith ")[1].split(",")[0],
                (float(row.what.split(" km")[0]), float(row.reference or 0.0)),
                textcoords="offset points", xytext=(7, 3), fontsize=style.TICK_SIZE,
            )  # fmt: skip
    simulated = [row for row in rows if row.mulder and row.what.endswith("all losses")]
    if simulated:
        depths = [float(row.what.split("at ")[1].split(" km")[0]) for row in simulated]
        right.plot(depths, [100 * row.difference for row in simulated], "x", color=style.INK,
                   label="Guan et al. over mulder, 1 % noise")  # fmt: skip
    charts.log_axis(left, "x", 0.1, 12.0)
    charts.log_axis(left, "y", 1e-13, 1e-3)
    left.legend(frameon=False, fontsize=style.TICK_SIZE, loc="lower left")
    right.legend(frameon=False, fontsize=style.TICK_SIZE, loc="lower right")
    right.axhline(0, color=style.MUTED, linewidth=style.THIN_LINE_WIDTH)
    right.axhspan(-15, 15, color=style.SKY, zorder=0, linewidth=0)
    right.set_xlim(0, 9)
    right.set_ylim(-35, 35)
    charts.label(left, x="Depth (km w.e.)", y="Intensity (cm⁻² s⁻¹ sr⁻¹)")
    charts.label(right, x="Depth (km w.e.)", y="Ours less full transport (%)")
    return figure
