"""What was to be found, the stations that looked for it, and how near the result is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterRasterDestination,
)

from ...muysc_qgis.staging import Staging
from ...muysc_qgis.workflows.reconstruction_test import KnownModelResult
from ...muysc_qgis.workflows.sites import Station
from ...muysc_qgis.workflows.view_errors import paper_errors
from ..compat import VECTOR_POINT
from ..parameters.values import explained
from .points import Point, write_points
from .rasters import destination
from .tables import stage_table, table_destination, table_layer
from .volume import stage_volume

TRUTH, STATIONS, TABLE = "TRUTH", "STATIONS", "TABLE"

#: What is declared as a number, told in the table and logged: output, label with unit.
NUMBERS = (
    ("CONTRAST", "Contrast found over the true one"),
    ("RELATIVE_L2", "Relative error of the densities"),
    ("SPREAD", "Standard deviation of the errors (g/cm³)"),
    ("BIAS", "Mean of the errors (g/cm³)"),
    ("TOP_ERROR", "Top view, normalised: mean |ε|"),
    ("TOP_SIGMA", "Top view, normalised: σ of |ε|"),
    ("FRONT_ERROR", "Front view: mean |ε| (km)"),
    ("FRONT_SIGMA", "Front view: σ of |ε| (km)"),
    ("SIDE_ERROR", "Side view: mean |ε| (km)"),
    ("SIDE_SIGMA", "Side view: σ of |ε| (km)"),
    ("MUONS_COUNTED", "Muons counted"),
    ("SITES_USED", "Sites used"),
    ("RAYS", "Rays used"),
    ("VOXELS_SEEN", "Voxels with a density"),
    ("VOXELS_UNSEEN", "Voxels with rock that no ray passes"),
    ("RESIDUAL", "Residual over data"),
    ("CHI_SQUARED", "Mean square of residuals over their errors"),
    ("ITERATIONS_DONE", "Iterations done"),
    ("SIGNIFICANCE", "Standard errors of the body at its place"),
    ("SIGNIFICANCE_OVERALL", "Standard errors of the body among all places"),
    ("SURVEYS_SEEING", "Surveys that see the body (%)"),
    ("FALSE_ALARMS", "Surveys that see a body where there is none (%)"),
    ("CONTRAST_SPREAD", "Standard deviation of the contrast over the surveys"),
    ("PLACE_ERROR", "Distance of the largest signal from the body (m)"),
)


#: Those that only the method counts tells.
_OF_VERDICT = (
    "SIGNIFICANCE", "SIGNIFICANCE_OVERALL", "SURVEYS_SEEING", "FALSE_ALARMS", "CONTRAST_SPREAD",
    "PLACE_ERROR",
)  # fmt: skip


def known_model_outputs() -> list[QgsProcessingParameterDefinition]:
    """Declare the known model, the stations and the table."""
    return [
        explained(
            QgsProcessingParameterRasterDestination(TRUTH, "Known model", None, True, False),
            "Density of the known model in the same voxels. A GeoTIFF on the map with a band for "
            "each elevation slice, the lowest first.",
        ),
        explained(
            QgsProcessingParameterFeatureSink(
                STATIONS, "Stations", VECTOR_POINT, None, True, False
            ),
            "Sites that were used, with their direction and distance to the target.",
        ),
        table_layer(
            TABLE, "Table of errors",
            "CSV: contrast, errors of the densities and of the views, and the numbers of the run.",
        ),
    ]  # fmt: skip


def numbers(found: KnownModelResult) -> dict[str, float]:
    """Return the numbers by output name."""
    result = found.tomography
    views = {
        f"{name.upper()}_{kind}": value
        for name, error in paper_errors(result, found.truth).items()
        for kind, value in (("ERROR", error.mean), ("SIGMA", error.deviation))
    }
    verdict = found.verdict
    nothing = float("nan")
    return views | {
        "SIGNIFICANCE": nothing if verdict is None else verdict.significance,
        "SIGNIFICANCE_OVERALL": nothing if verdict is None else verdict.overall,
        "SURVEYS_SEEING": nothing if verdict is None else 100 * verdict.seen,
        "FALSE_ALARMS": nothing if verdict is None else 100 * verdict.false_alarms,
        "CONTRAST_SPREAD": nothing if verdict is None else verdict.contrast_spread,
        "PLACE_ERROR": nothing if verdict is None else verdict.place_m,
        "CONTRAST": found.contrast,
        "RELATIVE_L2": found.relative_error,
        "SPREAD": found.spread,
        "BIAS": found.bias,
        "MUONS_COUNTED": found.muons,
        "SITES_USED": len(result.stations),
        "RAYS": result.rays,
        "VOXELS_SEEN": result.seen_voxels,
        "VOXELS_UNSEEN": result.unseen_voxels,
        "RESIDUAL": result.relative_residual,
        "CHI_SQUARED": result.chi_squared,
        "ITERATIONS_DONE": result.reconstruction.iterations_done,
    }


def stage_known_model(
    algorithm: QgsProcessingAlgorithm,
    found: KnownModelResult,
    values: Mapping[str, float],
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
    inputs: tuple[str, ...],
) -> dict[str, str]:
    """Stage the known model and the table where wanted; return files by output name."""
    results = {}
    path = destination(algorithm, parameters, TRUTH, context)
    if path is not None:
        stage_volume(path, found.truth, found.tomography, context, staging, inputs)
        results[TRUTH] = path
    table = table_destination(algorithm, parameters, TABLE, context)
    if table is not None:
        rows: list[tuple[str, float]] = [
            (label, values[name])
            for name, label in NUMBERS
            if found.verdict is not None or name not in _OF_VERDICT
        ]
        for body in found.bodies:
            rows.append((f"Body {body.name}: contrast found over the true one", body.contrast))
            rows.append((f"Body {body.name}: voxels", body.voxels))
            rows.append((f"Body {body.name}: voxels that rays pass", body.seen))
        stage_table(staging, table, ("figure", "value"), rows)
        results[TABLE] = table
    return results


def write_stations(
    algorithm: QgsProcessingAlgorithm,
    stations: Sequence[Station],
    found: KnownModelResult,
    crs: QgsCoordinateReferenceSystem,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
) -> dict[str, str]:
    """Write the stations as points; called last, see `write_layer`.

    Raises
    ------
    MuyscError
        If the layer cannot be written.
    """
    kinds = {
        "site": str, "detector_elevation_m": float, "distance_m": float, "azimuth_deg": float,
        "elevation_deg": float, "rays": int, "chi_squared": float,
    }  # fmt: skip
    points = [
        Point(
            station.site.position,
            (
                station.site.name,
                station.sight.detector_elevation_m,
                station.sight.target_distance_m,
                station.sight.boresight_azimuth_deg,
                station.sight.boresight_elevation_deg,
                residual.rays,
                residual.chi_squared,
            ),
        )
        for station, residual in zip(stations, found.tomography.residuals)
    ]
    return write_points(algorithm, STATIONS, kinds, points, crs, parameters, context, staging)
