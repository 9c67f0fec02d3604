"""Panel and report of a measured density."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..measurement.density import Flag
from ..muogram import Muogram
from ..quantities import QUANTITIES
from ..trajectories import TrajectoryMap
from ..views import View, like
from ..workflows.measured_density import FLAG_MEANINGS, DensityResult
from .directions import describe
from .panel import muogram_panels, summary_panel
from .provenance import Provenance, physics_of
from .report import Citation, PixelCount, Report, ReportFigure, Row
from .style import REPORT_DPI, png_bytes
from .trajectory_page import aimed_at_target, trajectory_page

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Quantities of the second figure, as far as there are any.
_FURTHER = (
    "thickness", "opacity", "density_lower", "density_upper", "density_minimum",
    "density_maximum", "density_flags",
)  # fmt: skip

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
    """Draw density and its error with skyline and, over azimuths, contours of the thickness.

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
    subtitle = subtitle[:1].upper() + subtitle[1:]
    if _in_telescope_angles(result):
        return _page(result, names, "Density along the telescope's trajectories", subtitle)
    return muogram_panels(
        _muograms(result, names), subtitle=subtitle, terrain=_muograms(result, ["thickness"])[0]
    )


def figures(result: DensityResult) -> list[ReportFigure]:
    """Draw the figures of the report.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    further = [
        name
        for name in _FURTHER
        if name in result.muograms and np.isfinite(result.muograms[name].values).any()
    ]
    meanings = ", ".join(f"{int(flag)} {text}" for flag, text in FLAG_MEANINGS.items())
    lines = (
        "Lines are the skyline, azimuths and elevations."
        if _in_telescope_angles(result)
        else "Lines are the skyline and the rock thickness."
    )
    return [
        ReportFigure(
            "Mean density along each ray and its error, one standard deviation. " + lines,
            png_bytes(panel(result)),
            "Muograms of density and of its error",
            is_panel=True,
        ),
        ReportFigure(
            f"What the density follows from, and its interval. Flags: {meanings}.",
            png_bytes(_further(result, further), REPORT_DPI),
            "Muograms of " + ", ".join(QUANTITIES[name].title.lower() for name in further),
        ),
    ]


def report(
    result: DensityResult,
    drawn: Sequence[ReportFigure],
    provenance: Provenance,
) -> Report:
    """Gather everything that the report of a measured density tells.

    Parameters
    ----------
    result
        What was found.
    drawn
        See `figures`.
    provenance
        What it was computed from, and when.
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
    told = Report(
        title="Density from a measured muogram",
        subtitle=f"From {density.metadata['MEASURED']}, mean along each ray",
        figures=drawn,
        results=rows,
        pixels=[one for one in counted if one.count],
        pixel_total=density.values.size,
        warnings=result.warnings,
        citations=[
            *physics_of(density.metadata),
            *(_INTERVALS if density.metadata["MEASURED"] == "counts" else ()),
        ],
    )
    return provenance.added_to(told)


def _in_telescope_angles(result: DensityResult) -> bool:
    return isinstance(result.muograms["density"], TrajectoryMap)


def _further(result: DensityResult, names: Sequence[str]) -> Figure:
    """Draw what the density follows from, and its interval."""
    if _in_telescope_angles(result):
        return _page(result, names, "Further quantities", "")
    return summary_panel({one.quantity: one for one in _muograms(result, names)})


def _page(result: DensityResult, names: Sequence[str], title: str, subtitle: str) -> Figure:
    """Draw quantities in telescope angles."""
    maps = [one for one in _drawn(result, names) if isinstance(one, TrajectoryMap)]
    lines = [subtitle] if subtitle else []
    thickness = result.muograms["thickness"].values
    rock = np.where(np.isnan(thickness), np.nan, thickness > 0)
    return trajectory_page(
        maps,
        [one.kind.title for one in maps],
        title,
        [*lines, *describe(aimed_at_target(maps[0]))],
        rock,
    )


def _muograms(result: DensityResult, names: Sequence[str]) -> list[Muogram]:
    return [one for one in _drawn(result, names) if isinstance(one, Muogram)]


def _drawn(result: DensityResult, names: Sequence[str]) -> list[View]:
    """Return what was found without the limits in it."""
    limits = result.densities.flags == Flag.LOWER_LIMIT
    drawn = []
    for name in names:
        one = result.muograms[name]
        if name.startswith(("density", "opacity")) and name != "density_flags":
            one = like(one, name, np.where(limits, np.nan, one.values), one.metadata)
        drawn.append(one)
    return drawn


def _with_error(value: float, error: float) -> str:
    """Return a value with its error, two digits of it."""
    if not (np.isfinite(error) and error > 0):
        return f"{value:.3g} g/cm³"
    digits = max(0, 1 - int(np.floor(np.log10(error))))
    return f"{value:.{digits}f} ± {error:.{digits}f} g/cm³"
