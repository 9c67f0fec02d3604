"""Maps and layers of a survey."""

from __future__ import annotations

from typing import Any

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterRasterDestination,
)

from ...muysc_qgis.quantities import QUANTITIES
from ...muysc_qgis.staging import Staging
from ...muysc_qgis.topography.drape import DrapedBlock
from ...muysc_qgis.topography.frame import transformed
from ...muysc_qgis.topography.raster import write_on_grid
from ...muysc_qgis.workflows.provenance import describe_transformation
from ...muysc_qgis.workflows.site_assessment import NUMBERS, SurveyPlan
from ...muysc_qgis.workflows.site_selection import Selection
from ..compat import VECTOR_POINT
from ..parameters.values import explained
from .points import Point, write_points
from .rasters import destination, stage_raster

BEST_SITES, TELESCOPE_SITES = "BEST_SITES", "TELESCOPE_SITES"

#: Quantity, and number of a candidate, by output.
_MAPS = {
    "SCORE": ("site_score", "score"),
    "EXPOSURE": ("exposure", "exposure_days"),
    "SHARE_SEEN": ("share_seen", "share_seen"),
    "THICKNESS": ("thickness", "thickness_m"),
    "SMALLEST_THICKNESS": ("thickness", "smallest_thickness_m"),
    "LARGEST_THICKNESS": ("thickness", "largest_thickness_m"),
    "FREE_SKY": ("free_sky", "free_sky"),
}
_ALWAYS = "SCORE"

_LABELS = {
    "SCORE": "Score",
    "EXPOSURE": "Days to the muons wanted",
    "SHARE_SEEN": "Share of the target seen",
    "THICKNESS": "Median thickness through the target",
    "SMALLEST_THICKNESS": "Smallest thickness through the target",
    "LARGEST_THICKNESS": "Largest thickness through the target",
    "FREE_SKY": "Share of free sky",
}
_HELP = {
    "SCORE": "From 0 to 1: the mean over the target body of T/(T + d) where it is seen and 0 "
    "elsewhere, for T days of the campaign and d days until the pixel has its muons.",
    "EXPOSURE": "Median days, over the part of the target body that is seen, until a pixel has the "
    "muons wanted.",
    "SHARE_SEEN": "Share of the target body's volume that is seen through rock between the "
    "thinnest and the thickest, 0 to 1.",
    "THICKNESS": "Median length in rock of the rays through the target body.",
    "SMALLEST_THICKNESS": "Least length in rock of the rays through the target body.",
    "LARGEST_THICKNESS": "Greatest length in rock of the rays through the target body.",
    "FREE_SKY": "Share of the pixels that see only sky, 0 to 1: where the telescope is calibrated.",
}


def map_outputs() -> list[QgsProcessingParameterDefinition]:
    """Declare the maps."""
    return [
        explained(
            QgsProcessingParameterRasterDestination(
                output, _LABELS[output], None, output != _ALWAYS, output == _ALWAYS
            ),
            f"{text} A GeoTIFF on the map with a cell for each candidate.",
        )
        for output, text in _HELP.items()
    ]


def site_outputs() -> list[QgsProcessingParameterDefinition]:
    """Declare the sites chosen."""
    return [
        explained(
            QgsProcessingParameterFeatureSink(name, label, VECTOR_POINT, None, True, True), text
        )
        for name, label, text in (
            (
                BEST_SITES,
                "Best sites",
                "Points of the candidates with the highest scores and their numbers, best first.",
            ),
            (
                TELESCOPE_SITES,
                "Telescopes that go together",
                "Points of the sites that cover the azimuths around the target best, in the order "
                "of choice: the layer of sites for Muograms from many sites.",
            ),
        )
    ]


def stage_maps(
    algorithm: QgsProcessingAlgorithm,
    selection: Selection,
    plan: SurveyPlan,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
) -> dict[str, str]:
    """Stage the maps that are wanted; return files by output name."""
    results = {}
    metadata: dict[str, str | float] = {
        "DEM": plan.dem.name,
        "CANDIDATES": len(selection.candidates),
        **describe_transformation(plan.dem),
    }
    for output, (name, number) in _MAPS.items():
        path = destination(algorithm, parameters, output, context)
        if path is None:
            continue
        values, quantity = selection.map_of(number), QUANTITIES[name]
        temporary = stage_raster(staging, path, (plan.dem.path,), context, values, quantity)
        write_on_grid(
            temporary, selection.candidates.grid, quantity, metadata, [DrapedBlock(0, values)],
            f"survey {number}",
        )  # fmt: skip
        results[output] = path
    return results


def write_sites(
    algorithm: QgsProcessingAlgorithm,
    selection: Selection,
    plan: SurveyPlan,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
) -> dict[str, str]:
    """Write the layers of sites that are wanted; called last, see `write_points`."""
    grid = selection.candidates.grid
    crs = QgsCoordinateReferenceSystem.fromWkt(grid.crs.to_wkt())
    places = np.column_stack(
        transformed(
            plan.dem.crs,
            grid.crs,
            selection.candidates.x,
            selection.candidates.y,
            by=plan.dem.transformation,
        )
    )
    measures = ("distance_m", "azimuth_deg", "slope_deg", "road_m")
    names = ("score", *(name for name in NUMBERS if name != "score"))

    def points(word: str, chosen: np.ndarray, extra: list[tuple[float, ...]]) -> list[Point]:
        digits = max(2, len(str(len(chosen))))
        return [
            Point(
                (float(places[index, 0]), float(places[index, 1])),
                (
                    f"{word}_{rank:0{digits}d}",
                    rank,
                    *(float(selection.numbers[name][index]) for name in names),
                    *(float(getattr(selection.candidates, name)[index]) for name in measures),
                    *more,
                ),
            )
            for rank, (index, more) in enumerate(zip(chosen, extra), 1)
        ]

    kinds: dict[str, type] = {
        "site": str, "rank": int, **dict.fromkeys((*names, *measures), float),
    }  # fmt: skip
    best = points("site", selection.best, [()] * len(selection.best))
    together = points(
        "telescope", selection.telescopes, [(float(mean),) for mean in selection.coverage]
    )
    write = (crs, parameters, context, staging)
    return {
        **write_points(algorithm, BEST_SITES, kinds, best, *write, sites="site"),
        **write_points(
            algorithm,
            TELESCOPE_SITES,
            {**kinds, "coverage": float},
            together,
            *write,
            sites="telescope",
        ),
    }
