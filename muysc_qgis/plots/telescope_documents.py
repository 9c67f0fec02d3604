"""Panels and reports of telescopes: what is drawn and told, in which order."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..telescope.acceptance import CITATIONS, Trajectories, plane_etendue
from ..telescope.geometry import TelescopeGeometry
from ..telescope.presets import PRESETS
from ..topography.sight import Sight
from ..workflows.expected_counts import TelescopeCounts
from .provenance import Provenance, physics_of, transformation_rows
from .report import Citation, PixelCount, Report, ReportFigure, Row
from .style import REPORT_DPI, png_bytes
from .telescope_comparison import comparison_panel
from .telescope_counts import FURTHER, counts_panel
from .telescope_panel import telescope_panel, telescope_title

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: The work behind the time that a contrast takes.
_FEASIBILITY = Citation(
    f"Feasibility: {PRESETS['lesparre2010'].citation}", PRESETS["lesparre2010"].url
)

__all__ = ["counts_panel", "counts_report", "panel", "report"]


def panel(collected: Trajectories, name: str) -> Figure:
    """Draw the panel of one telescope.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    return telescope_panel(collected, name)


def report(
    collected: Trajectories,
    name: str,
    notes: tuple[str, ...],
    provenance: Provenance,
) -> Report:
    """Gather everything that the report of a telescope tells.

    Parameters
    ----------
    collected, name
        The telescope.
    notes
        What the user must know, a sentence each.
    provenance
        What it was computed from, and when.
    """
    geometry = collected.geometry
    drawn = [
        ReportFigure(
            "The telescope with a muon, what it sees, and its acceptance by both formulas; below, "
            "maps over all trajectories with their sections across and along the diagonal.",
            png_bytes(telescope_panel(collected, name)),
            "Drawing, aperture and acceptance of the telescope",
            is_panel=True,
        ),
        ReportFigure(
            "The telescope beside those that were built. The effective area is the acceptance "
            "over the solid angle of its response.",
            png_bytes(comparison_panel(geometry, name, collected.formula), REPORT_DPI),
            "Comparison of telescopes",
        ),
    ]
    told = Report(
        title="Telescope parameters",
        subtitle=telescope_title(name),
        figures=drawn,
        results=_telescope_rows(geometry, collected),
        warnings=notes,
        citations=[*_telescope_citations(name), *(Citation(f"Acceptance: {c}") for c in CITATIONS)],
    )
    return provenance.added_to(told)


def _telescope_rows(geometry: TelescopeGeometry, collected: Trajectories) -> list[Row]:
    across, up = geometry.half_aperture_deg
    rows = [
        Row("Trajectories", geometry.trajectories),
        Row("Largest acceptance", float(collected.acceptance_cm2_sr.max()), "cm² sr"),
        Row("Largest solid angle", float(collected.solid_angle_sr.max()), "sr"),
        Row("Largest detection area", float(collected.detection_area_cm2.max()), "cm²"),
        Row("Shortest path", float(collected.path_length_cm.min()), "cm"),
        Row("Longest path", float(collected.path_length_cm.max()), "cm"),
        Row("Half aperture across", across, "°"),
        Row("Half aperture up", up, "°"),
        Row("Angle from one trajectory to the next", 1e3 * geometry.step, "mrad"),
        Row("Angular resolution", float(collected.angular_resolution_mrad.max()), "mrad"),
        Row("Étendue, all trajectories", collected.etendue_cm2_sr, "cm² sr"),
    ]
    if collected.formula == "paper":
        rows.append(Row("Étendue of the two planes, exact", plane_etendue(geometry), "cm² sr"))
    return rows


def counts_report(
    counts: TelescopeCounts,
    sight: Sight,
    name: str,
    notes: tuple[str, ...],
    provenance: Provenance,
) -> Report:
    """Gather everything that the report of expected counts tells.

    Parameters
    ----------
    counts, sight, name
        What was computed, from where, for which telescope.
    notes
        What the user must know, a sentence each.
    provenance
        What it was computed from, and when.
    """
    drawn = [
        ReportFigure(
            "Counts on the mountain, their error, the smallest decrease of the density that they "
            "show, and the days that the contrast takes. Thin lines are azimuths and elevations.",
            png_bytes(counts_panel(counts, name)),
            "Maps of counts and of what they show, in telescope angles",
            is_panel=True,
        ),
        ReportFigure(
            "Exposure time, counts of the open sky, mean flux and mean thickness on the same "
            "trajectories.",
            png_bytes(counts_panel(counts, name, FURTHER), REPORT_DPI),
            "Further maps in telescope angles",
        ),
    ]
    flux = counts.maps["flux"]
    pixels = [PixelCount("behind rock", counts.rock_trajectories)]
    pixels += [PixelCount("unknown", number, cause) for cause, number in counts.unknown.items()]
    told = Report(
        title="Expected counts in a telescope",
        subtitle=f"{telescope_title(name)} on the elevation model {sight.frame.dem.name}",
        figures=drawn,
        results=[*_count_rows(counts, sight), *transformation_rows(flux.metadata)],
        pixels=pixels,
        pixel_total=counts.trajectories,
        warnings=[*notes, *counts.warnings],
        citations=[
            *_telescope_citations(name),
            *(Citation(f"Acceptance: {one}") for one in CITATIONS),
            _FEASIBILITY,
            *physics_of(flux.metadata),
        ],
    )
    return provenance.added_to(told)


def _count_rows(counts: TelescopeCounts, sight: Sight) -> list[Row]:
    plan, geometry = counts.plan, counts.geometry
    return [
        Row("Detector elevation", sight.detector_elevation_m, "m"),
        Row("Distance of the target", sight.target_distance_m, "m"),
        Row("Boresight azimuth", counts.pointing.azimuth_deg, "°"),
        Row("Boresight elevation", counts.pointing.elevation_deg, "°"),
        Row("Roll", counts.pointing.roll_deg, "°"),
        Row("Bars", f"{geometry.bars_x} × {geometry.bars_y}"),
        Row("Width of a bar", geometry.pixel_size_cm, "cm"),
        Row("Separation of the planes", geometry.separation_cm, "cm"),
        Row("Trajectories or bins of them", counts.trajectories),
        Row("Muons along all known trajectories", counts.rate_per_day(), "per day"),
        Row("Muons behind rock", counts.rate_per_day(behind_rock=True), "per day"),
        Row("Median counts behind rock", counts.median("counts")),
        Row(f"Median time for {plan.muons:g} muons behind rock", counts.median("exposure"), "days"),
        Row(
            f"Median of the smallest contrast seen at {plan.sigma:g} σ",
            counts.median("density_resolution"),
            "%",
        ),
        Row(
            f"Median time to see {plan.contrast_percent:+g} % of density".replace("-", "−"),
            counts.median("contrast_days"),
            "days",
        ),
    ]


def _telescope_citations(name: str) -> list[Citation]:
    if name not in PRESETS:
        return []
    return [Citation(f"Telescope: {PRESETS[name].citation}", PRESETS[name].url)]
