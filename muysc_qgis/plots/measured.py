"""Panel and report of a measured density."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..errors import MuyscError
from ..measurement.density import Flag
from ..muogram import Muogram
from ..radiography.energy_loss import ENERGY_LOSSES
from ..radiography.spectra import MODELS
from ..workflows.measured_density import FLAG_MEANINGS, DensityResult
from .documents import Parameter, own_versions
from .panel import muogram_panels, summary_panel
from .report import Citation, OutputFile, PixelCount, Report, ReportFigure, Row
from .style import png_bytes

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Quantities of the second figure, as far as there are any.
_FURTHER = (
    "thickness", "opacity", "density_lower", "density_upper", "density_minimum",
    "density_maximum", "density_flags",
)  # fmt: skip
#: Resolution (dots per inch) of figures in the report, read on screens.
_REPORT_DPI = 110

_INTERVALS = (
    Citation(
        "Confidence intervals of counts: Garwood (1936). Fiducial limits for the Poisson "
        "distribution. Biometrika, 28, 437–442.",
        "https://doi.org/10.1093/biomet/28.3-4.437",
    ),
    Citation(
        "Of ratios of counts: Clopper & Pearson (1934). The use of confidence or fiducial limits "
        "illustrated in the case of the binomial. Biometrika, 26, 404–413.",
        "https://doi.org/10.1093/biomet/26.4.404",
    ),
)


def panel(result: DensityResult) -> Figure:
    """Draw density and its error with skyline and contours of the thickness.

    Limits are left out: their value says more of the exposure than of the rock.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    names = ["density"]
    if np.isfinite(result.muograms["density_error"].values).any():
        names.append("density_error")
    mean = result.mean
    subtitle = "" if np.isnan(mean.density) else f"mean {_with_error(mean.density, mean.error)}"
    limits = result.densities.count(Flag.LOWER_LIMIT)
    if limits:
        subtitle += f"  ·  {limits} lower limits not shown"
    return muogram_panels(
        [_drawn(result, name) for name in names],
        subtitle=subtitle[:1].upper() + subtitle[1:],
        terrain=_drawn(result, "thickness"),
    )


def figures(result: DensityResult) -> list[ReportFigure]:
    """Draw the figures of the report.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    further = {
        name: _drawn(result, name)
        for name in _FURTHER
        if name in result.muograms and np.isfinite(result.muograms[name].values).any()
    }
    meanings = ", ".join(f"{int(flag)} {text}" for flag, text in FLAG_MEANINGS.items())
    return [
        ReportFigure(
            "Mean density along each ray and its error, one standard deviation. Lines are the "
            "skyline and the rock thickness.",
            png_bytes(panel(result)),
            "Muograms of density and of its error",
            is_panel=True,
        ),
        ReportFigure(
            f"What the density follows from, and its interval. Flags: {meanings}.",
            png_bytes(summary_panel(further), _REPORT_DPI),
            "Muograms of " + ", ".join(one.kind.title.lower() for one in further.values()),
        ),
    ]


def report(
    result: DensityResult,
    drawn: Sequence[ReportFigure],
    parameters: Sequence[Parameter],
    outputs: Mapping[str, str],
    date: str,
    versions: Mapping[str, str],
) -> Report:
    """Gather everything that the report of a measured density tells.

    Parameters
    ----------
    result
        What was found.
    drawn
        See `figures`.
    parameters, outputs, date, versions
        As in the report of a simulation.
    """
    density = result.muograms["density"]
    found, mean = result.densities, result.mean
    rows = [
        Row("Mean density", mean.density, "g/cm³"),
        Row("Its error", mean.error, "g/cm³"),
        Row("of which from counting", mean.statistical_error, "g/cm³"),
        Row("Median density", result.median_density, "g/cm³"),
    ]
    if found.region is not None:
        rows.append(Row("Regions of merged pixels", found.regions))
    counted = [
        PixelCount(FLAG_MEANINGS[flag], found.count(flag), f"flag {int(flag)}") for flag in Flag
    ]
    model = MODELS[str(density.metadata["FLUX_MODEL"])]
    return Report(
        title="Density from a measured muogram",
        subtitle=f"From {density.metadata['MEASURED']}, mean along each ray",
        date=date,
        figures=drawn,
        results=rows,
        parameters=[Row(one.label, one.value, one.unit) for one in parameters],
        pixels=[one for one in counted if one.count],
        pixel_total=density.values.size,
        warnings=result.warnings,
        outputs=[OutputFile(label, Path(path).name) for label, path in outputs.items()],
        citations=[
            Citation(f"Muon flux model: {model.citation}"),
            Citation(f"Energy loss: {ENERGY_LOSSES[str(density.metadata['ENERGY_LOSS'])]}"),
            *(_INTERVALS if density.metadata["MEASURED"] == "counts" else ()),
        ],
        versions={**own_versions(), **versions},
    )


def _drawn(result: DensityResult, name: str) -> Muogram:
    """Return a muogram without the limits in it."""
    muogram = result.muograms[name]
    if not isinstance(muogram, Muogram):
        raise MuyscError("Densities in telescope angles have no panel; leave PANEL and REPORT out.")
    if not muogram.quantity.startswith(("density", "opacity")) or "flags" in muogram.quantity:
        return muogram
    limits = result.densities.flags == Flag.LOWER_LIMIT
    return muogram.with_values(muogram.quantity, np.where(limits, np.nan, muogram.values))


def _with_error(value: float, error: float) -> str:
    """Return a value with its error, two digits of it."""
    if not (np.isfinite(error) and error > 0):
        return f"{value:.3g} g/cm³"
    digits = max(0, 1 - int(np.floor(np.log10(error))))
    return f"{value:.{digits}f} ± {error:.{digits}f} g/cm³"
