"""Panel and report of a comparison: what is drawn and told, in which order."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...radiography.comparison import Comparison
from ...radiography.energy_loss import ENERGY_LOSSES
from ...radiography.materials import MATERIALS
from ...radiography.spectra import MODELS
from ..provenance import Provenance
from ..report import Citation, Report, ReportFigure, Row
from ..style import REPORT_DPI, WIDTH_IN, new_figure, png_bytes
from . import attenuation, energy_spectra, losses

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def spectrum_figure(comparison: Comparison) -> Figure:
    """Draw the differential spectra.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    figure = new_figure(WIDTH_IN, energy_spectra.height_in(comparison))
    energy_spectra.draw(figure, 0.0, comparison)
    return figure


def loss_figure(comparison: Comparison) -> Figure:
    """Draw stopping power and minimum energy.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    figure = new_figure(WIDTH_IN, losses.HEIGHT_IN)
    losses.draw(figure, 0.0, comparison)
    return figure


def attenuation_figure(comparison: Comparison) -> Figure:
    """Draw transmission and flux against opacity.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    figure = new_figure(WIDTH_IN, attenuation.HEIGHT_IN)
    attenuation.draw(figure, 0.0, comparison)
    return figure


def panel(comparison: Comparison) -> Figure:
    """Draw all three on one page.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    spectra_in = energy_spectra.height_in(comparison)
    figure = new_figure(WIDTH_IN, spectra_in + losses.HEIGHT_IN + attenuation.HEIGHT_IN)
    energy_spectra.draw(figure, 0.0, comparison)
    losses.draw(figure, spectra_in, comparison)
    attenuation.draw(figure, spectra_in + losses.HEIGHT_IN, comparison)
    return figure


def report(
    comparison: Comparison,
    provenance: Provenance,
) -> Report:
    """Gather everything that the report of a comparison tells.

    Parameters
    ----------
    comparison
        What was computed.
    provenance
        What it was computed from, and when.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    told = Report(
        title="Muon spectra compared",
        subtitle=f"{len(comparison.models)} flux models at {len(comparison.zenith_deg)} zenith "
        "angles, in the open sky and behind rock",
        figures=_figures(comparison),
        results=_results(comparison),
        warnings=comparison.warnings,
        citations=[
            *(
                Citation(f"Muon flux model {MODELS[name].title}: {MODELS[name].citation}")
                for name in comparison.models
            ),
            *(
                Citation(f"Energy loss “{name}”: {source}")
                for name, source in ENERGY_LOSSES.items()
            ),
            *(
                Citation(f"{MATERIALS[one.material].title}: {MATERIALS[one.material].source}")
                for one in comparison.losses
            ),
        ],
    )
    return provenance.added_to(told)


def _figures(comparison: Comparison) -> list[ReportFigure]:
    drawn = (
        (
            spectrum_figure,
            "Differential spectra of the models at each zenith angle, and their ratio. Shaded: the "
            "muons that the rock lets through.",
        ),
        (
            loss_figure,
            "Mean energy loss of muons, and the kinetic energy they need to cross rock.",
        ),
        (attenuation_figure, "Transmission and flux against opacity."),
    )
    return [
        ReportFigure(caption, png_bytes(draw(comparison), REPORT_DPI), caption)
        for draw, caption in drawn
    ]


def _results(comparison: Comparison) -> list[Row]:
    rows = [
        Row("Thickness", comparison.thickness_m, "m"),
        Row("Opacity", comparison.opacity_g_cm2, "g/cm²"),
        Row("Minimum kinetic energy", comparison.minimum_energy_gev, "GeV"),
        Row("Largest flux over smallest among the models that hold", comparison.largest_ratio),
    ]
    for one in comparison.behind:
        beyond = "" if one.holds[0] else ", outside the model's range"
        where = f"{MODELS[one.model].title} at {one.zenith_deg:g}°{beyond}"
        rows.append(Row(f"Flux, {where}", float(one.flux[0]), "cm⁻² sr⁻¹ day⁻¹"))
    return rows
