"""Panels and reports of tomographies: what is drawn and told, in which order."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ...topography.dem import Dem
from ...topography.relief import Relief, relief_on_map
from ...workflows.provenance import describe_transformation
from ...workflows.reconstruction_test import KnownModelResult
from ...workflows.tomography_result import Tomography
from ...workflows.view_errors import paper_errors
from ..provenance import Provenance, transformation_rows
from ..report import PixelCount, Report, ReportFigure, Row
from ..style import DPI, REPORT_DPI, png_bytes
from .convergence import convergence_figure
from .known_model_panel import known_model_panel
from .section_picture import section_figure
from .slice_map import map_bounds
from .tomography_panel import tomography_panel

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["known_model_panel", "known_model_report", "panel", "report", "terrain"]


def terrain(tomography: Tomography, dem: Dem) -> Relief:
    """Return the terrain of the map around a volume and its stations.

    Raises
    ------
    MuyscError
        If the DEM cannot be read.
    """
    from pyproj import CRS

    west, east, south, north = map_bounds(tomography)
    crs = CRS.from_wkt(tomography.density.crs)
    return relief_on_map(dem, crs, (west, east), (south, north))


def panel(tomography: Tomography, dem: Dem) -> Figure:
    """Draw the panel of a tomography.

    Raises
    ------
    MuyscError
        If matplotlib is missing or the DEM cannot be read.
    """
    return tomography_panel(tomography, terrain(tomography, dem))


def report(
    tomography: Tomography,
    dem: Dem,
    provenance: Provenance,
    *,
    warnings: Sequence[str] = (),
    discrepancy: float = 1.0,
    line_m: Sequence[tuple[float, float]] | None = None,
) -> Report:
    """Gather everything that the report of a tomography tells.

    Parameters
    ----------
    tomography, dem
        What was computed, and the terrain.
    provenance
        What it was computed from, and when.
    warnings
        What the data said before, a sentence each.
    discrepancy
        Multiple of the errors at which fitting was to end; 0 for never.
    line_m
        Corners of a line in the CRS of the volume along which a section is drawn.

    Raises
    ------
    MuyscError
        If matplotlib is missing or the DEM cannot be read.
    """
    relief = terrain(tomography, dem)
    drawn = [_panel_figure(tomography, relief), _convergence(tomography, discrepancy)]
    if line_m is not None:
        drawn.append(
            ReportFigure(
                "Vertical section through the densities along the line.",
                png_bytes(section_figure(tomography, line_m, relief), REPORT_DPI),
                "Vertical section along the line",
            )
        )
    return _report(
        "Muon tomography", tomography, dem, drawn, _results(tomography), provenance, warnings
    )


def known_model_report(
    found: KnownModelResult,
    dem: Dem,
    provenance: Provenance,
    *,
    warnings: Sequence[str] = (),
    discrepancy: float = 1.0,
) -> Report:
    """Gather everything that the report of a reconstruction test tells.

    Parameters
    ----------
    found
        What was to be found, and what was.
    dem
        Terrain.
    provenance
        What it was computed from, and when.
    warnings
        A sentence each.
    discrepancy
        Multiple of the errors at which fitting was to end; 0 for never.

    Raises
    ------
    MuyscError
        If matplotlib is missing or the DEM cannot be read.
    """
    tomography = found.tomography
    drawn = [
        ReportFigure(
            "Original, reconstruction and their difference: sums along the three axes with the "
            "mean and the standard deviation σ of |ε|, and slices through the target.",
            png_bytes(known_model_panel(tomography, found.truth)),
            "Original, reconstruction and error in views and slices",
            is_panel=True,
        ),
        _panel_figure(tomography, terrain(tomography, dem), is_panel=False),
        _convergence(tomography, discrepancy),
    ]
    rows = [*_merits(found), *_results(tomography)]
    return _report(
        "Reconstruction of a known model", tomography, dem, drawn, rows, provenance, warnings
    )


def _merits(found: KnownModelResult) -> list[Row]:
    """Return how near the reconstruction is to the model: bodies, all voxels, the paper's views."""
    rows = []
    for body in found.bodies:
        contrast = round(body.contrast, 4)
        rows.append(Row(f"Contrast found over the true one, {body.name}", contrast))
        rows.append(Row(f"Voxels of {body.name} crossed by rays", f"{body.seen} of {body.voxels}"))
    rows += [
        Row("Relative error ‖R − T‖ / ‖T‖", round(found.relative_error, 5)),
        Row("Standard deviation of R − T", round(found.spread, 4), "g/cm³"),
        Row("Mean of R − T", round(found.bias, 4), "g/cm³"),
    ]
    if np.isfinite(found.muons):
        rows.append(Row("Muons counted", round(found.muons)))
    for name, error in paper_errors(found.tomography, found.truth).items():
        unit = "" if name == "top" else "km"
        what = f"{name.capitalize()} view{', normalised' if name == 'top' else ''}"
        rows.append(Row(f"{what}: mean |ε|", round(error.mean, 4), unit))
        rows.append(Row(f"{what}: standard deviation of |ε|", round(error.deviation, 4), unit))
    return rows


def _panel_figure(tomography: Tomography, relief: Relief, is_panel: bool = True) -> ReportFigure:
    caption = (
        "Densities at the height of the target and in two sections through it, mean densities and "
        "rays per voxel along three directions"
    )
    if tomography.deviation is not None:
        caption += ", and the standard errors of the densities"
    return ReportFigure(
        f"{caption}. White stands for the reference density.",
        png_bytes(tomography_panel(tomography, relief), DPI if is_panel else REPORT_DPI),
        "Slices, sections and views of the densities",
        is_panel=is_panel,
    )


def _convergence(tomography: Tomography, discrepancy: float) -> ReportFigure:
    return ReportFigure(
        "Misfit between data and model by iteration, and what is left of every station's data.",
        png_bytes(convergence_figure(tomography, discrepancy), REPORT_DPI),
        "Misfit by iteration and by station",
    )


def _report(
    title: str,
    tomography: Tomography,
    dem: Dem,
    drawn: Sequence[ReportFigure],
    rows: Sequence[Row],
    provenance: Provenance,
    warnings: Sequence[str],
) -> Report:
    lost = tomography.lost
    pixels = [PixelCount("Used", tomography.rays, "rays through rock of the volume")]
    pixels += [PixelCount("Not used", count, cause) for cause, count in lost.items() if count]
    told = Report(
        title=title,
        subtitle=f"{tomography.method_title} from {len(tomography.stations)} stations on "
        f"the elevation model {dem.name}",
        figures=drawn,
        results=[*rows, *transformation_rows(describe_transformation(dem))],
        pixels=pixels,
        pixel_total=tomography.rays + sum(lost.values()),
        warnings=[*warnings, *tomography.warnings],
    )
    return provenance.added_to(told)


def _results(tomography: Tomography) -> list[Row]:
    grid, found = tomography.grid, tomography.reconstruction
    density = tomography.density.values[tomography.density.known]
    rows = [
        Row("Voxels", " × ".join(map(str, grid.shape))),
        Row("Edges of a voxel", " × ".join(f"{size:g}" for size in grid.size_m), "m"),
        Row("Base of the volume", round(grid.origin_m[2], 2), "m"),
        Row("Top of the volume", round(grid.end_m[2], 2), "m"),
        Row("Voxels sought", tomography.rock_voxels),
        Row("Voxels crossed by no ray", tomography.unseen_voxels),
        Row("Rays used", tomography.rays),
        Row("Iterations", found.iterations_done),
        Row("Reference density", round(tomography.reference_density, 4), "g/cm³"),
        Row("Mean density", round(tomography.mean_density, 4), "g/cm³"),
        Row("Smallest density", round(float(density.min()), 4), "g/cm³"),
        Row("Largest density", round(float(density.max()), 4), "g/cm³"),
        Row("Relative residual", round(100 * tomography.relative_residual, 3), "%"),
    ]
    if np.isfinite(tomography.chi_squared):
        label = "Mean square of residuals over their errors"
        rows.append(Row(label, round(tomography.chi_squared, 4)))
    return rows
