"""Panel and report of one simulation: what is drawn and told, in which order."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ..muogram import Muogram
from ..radiography.aperture import Aperture
from ..topography.footprint import Outline
from ..topography.relief import relief_around
from ..topography.section import terrain_section
from ..topography.sight import Sight
from ..workflows.simulation import Simulation, outlines
from .overview_map import overview_map
from .panel import muogram_panel, summary_panel
from .profile import section_panel
from .provenance import Provenance, physics_of, transformation_rows
from .rays import Ray
from .report import PixelCount, Report, ReportFigure, Row
from .style import REPORT_DPI, png_bytes

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Quantities of the second figure, as far as a simulation has them.
_FURTHER = ("opacity", "minimum_energy", "open_sky", "transmission", "exposure", "distance")
#: Margin of the map around what it shows, as a share of its size.
_MAP_MARGIN = 0.12


def panel(simulation: Simulation) -> Figure:
    """Draw thickness and flux side by side.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    return muogram_panel(simulation.muograms["thickness"], simulation.muograms["flux"])


def figures(
    simulation: Simulation, sight: Sight | None = None, aperture: Aperture | None = None
) -> list[ReportFigure]:
    """Draw the figures of the report; the map and the section where the terrain is known.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    drawn = [
        ReportFigure(
            "Rock thickness along each ray and muon flux behind it, with contours.",
            png_bytes(panel(simulation)),
            "Muograms of thickness and flux",
            is_panel=True,
        )
    ]
    if sight is not None and aperture is not None:
        drawn += [_map(simulation, sight, aperture), *_section(simulation, sight, aperture)]
    further = {name: simulation.muograms[name] for name in _FURTHER if name in simulation.muograms}
    drawn.append(
        ReportFigure(
            _further_caption(simulation, further),
            png_bytes(summary_panel(further), REPORT_DPI),
            "Muograms of " + ", ".join(one.kind.title.lower() for one in further.values()),
        )
    )
    return drawn


def _further_caption(simulation: Simulation, further: Mapping[str, Muogram]) -> str:
    caption = "The other quantities in the same directions."
    muons = simulation.muograms["flux"].metadata.get("MUONS")
    if "exposure" in further and muons is not None:
        caption += f" Exposure: the time in which a pixel counts {float(muons):g} muons."
    return caption


def _map(simulation: Simulation, sight: Sight, aperture: Aperture) -> ReportFigure:
    sector, seen = outlines(simulation, sight, aperture)
    # Where rays start in rock the ground seen has no extent.
    wedge, ground = _metres(sector), [_metres(one) for one in seen if one.distance_m.max() > 0]
    points = np.concatenate([wedge, *ground, np.zeros((1, 2))])
    low, high = points.min(axis=0), points.max(axis=0)
    margin = _MAP_MARGIN * float(np.max(high - low))
    relief = relief_around(
        sight.frame,
        (low[0] - margin, high[0] + margin),
        (low[1] - margin, high[1] + margin),
    )
    azimuth = np.radians(sight.boresight_azimuth_deg)
    target = (
        float(sight.target_distance_m * np.sin(azimuth)),
        float(sight.target_distance_m * np.cos(azimuth)),
    )
    figure = overview_map(relief, target, [wedge], ground)
    band = ": the band between the nearest and the farthest rock face along each azimuth"
    return ReportFigure(
        f"Detector, target, field of view and the ground seen{band}."
        if ground
        else "Detector, target and field of view.",
        png_bytes(figure, REPORT_DPI),
        "Map of the terrain around the detector",
    )


def _metres(outline: Outline) -> np.ndarray:
    """Return an outline as (n, 2) metres east and north of the detector."""
    angle = np.radians(outline.azimuth_deg)
    return np.column_stack([outline.distance_m * np.sin(angle), outline.distance_m * np.cos(angle)])


def _section(simulation: Simulation, sight: Sight, aperture: Aperture) -> list[ReportFigure]:
    middle = sight.boresight_elevation_deg
    half = aperture.elevation_width_deg / 2
    distance, ground = terrain_section(
        sight.frame, sight.detector_elevation_m, sight.boresight_azimuth_deg, middle - half
    )
    if np.count_nonzero(np.isfinite(ground)) < 2:
        return []
    rays = [
        Ray("to the target", middle, main=True),
        Ray("lowest", middle - half),
        Ray("highest", middle + half),
    ]
    described = simulation.muograms["flux"].metadata
    figure = section_panel(
        distance,
        ground,
        sight.detector_elevation_m,
        rays,
        sight.target_distance_m,
        sight.boresight_azimuth_deg,
        range_m=(
            float(described.get("NEAR_FIELD", 0.0)),
            float(described.get("MAX_RANGE", np.inf)),
        ),
    )
    return [
        ReportFigure(
            "Terrain along the boresight with the rock that rays cross. Heights are lowered by "
            "the curvature of the Earth, so that rays are straight.",
            png_bytes(figure, REPORT_DPI),
            "Section through the terrain along the boresight",
        )
    ]


def report(
    simulation: Simulation,
    drawn: list[ReportFigure],
    provenance: Provenance,
) -> Report:
    """Gather everything that the report of a simulation tells.

    Parameters
    ----------
    simulation
        What was computed.
    drawn
        See `figures`.
    provenance
        What it was computed from, and when.
    """
    flux = simulation.muograms["flux"]
    total = flux.values.size
    sky = int(np.count_nonzero(simulation.muograms["opacity"].values == 0))
    pixels = [PixelCount("Rock", simulation.rock_pixels)]
    if simulation.truncated_pixels:
        reach = f"still in rock at the maximum range of {flux.number('MAX_RANGE'):g} m"
        pixels.append(PixelCount("Rock, thickness cut", simulation.truncated_pixels, reach))
    pixels.append(PixelCount("Open sky", sky))
    pixels += [
        PixelCount("No flux", count, cause) for cause, count in simulation.unknown.items() if count
    ]
    told = Report(
        title="Muon radiography",
        subtitle=_subtitle(flux),
        figures=drawn,
        results=_results(simulation),
        pixels=pixels,
        pixel_total=total,
        warnings=simulation.warnings,
        citations=physics_of(flux.metadata),
    )
    return provenance.added_to(told)


def _subtitle(flux: Muogram) -> str:
    terrain = flux.metadata.get("DEM")
    return f"Simulated on the elevation model {terrain}" if terrain else "From a known muogram"


def _results(simulation: Simulation) -> list[Row]:
    flux = simulation.muograms["flux"]
    rows = [Row("Largest rock thickness", round(simulation.maximum_thickness_m, 1), "m")]
    for label, key, unit, digits in (
        ("Density of the rock", "DENSITY", "g/cm³", 4),
        ("Detector elevation", "DETECTOR_ELEVATION", "m", 1),
        ("Target elevation", "TARGET_ELEVATION", "m", 1),
        ("Distance of the target", "TARGET_DISTANCE", "m", 1),
        ("Boresight azimuth", "BORESIGHT_AZIMUTH", "°", 2),
        ("Boresight elevation", "BORESIGHT_ELEVATION", "°", 2),
        ("Standard error of the flux behind rock, median", "FLUX_ERROR", "%", 1),
    ):
        if key in flux.metadata:
            rows.append(Row(label, round(flux.number(key), digits), unit))
    for name in ("flux", "open_sky"):
        known = simulation.muograms[name].values
        known = known[np.isfinite(known)]
        if known.size:
            kind = simulation.muograms[name].kind
            rows.append(Row(f"Smallest {kind.title.lower()}", _rounded(known.min()), kind.unit))
            rows.append(Row(f"Largest {kind.title.lower()}", _rounded(known.max()), kind.unit))
    median = _rounded(simulation.median_exposure_days)
    rows.append(Row("Median exposure behind rock", median, "days"))
    return [*rows, *transformation_rows(flux.metadata)]


def _rounded(value: float) -> float:
    """Return a value to three digits: no flux model knows more."""
    return float(f"{value:.3g}")
