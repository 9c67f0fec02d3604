"""Volumes as outputs: rasters with a band for each slice, points, residuals and sections."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterRasterDestination,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.staging import Staging
from ...muysc_qgis.volume import VOLUME_QUANTITIES, Volume, write_volume
from ...muysc_qgis.workflows.tomography_result import Tomography
from ..compat import VECTOR_POINT
from ..parameters.values import explained
from .points import Point, write_points
from .rasters import destination, stage_raster
from .tables import stage_table, table_destination, table_layer

POINTS, RESIDUALS = "POINTS", "RESIDUALS"

#: Output, quantity of the volume, its attribute of a `Tomography`, and what it is.
_RASTERS = (
    ("DENSITY", "density", "density", "Density of each voxel with rock that a ray passes."),
    ("COVERAGE", "coverage", "coverage", "Number of rays through each voxel with rock."),
    (
        "DENSITY_ERROR", "density_error", "deviation",
        "Standard error of each density, of the methods bayes and counts.",
    ),
)  # fmt: skip

#: Made unless the user says no; the others the other way round.
_BY_DEFAULT = ("DENSITY", "COVERAGE")

#: Columns of the table of residuals, with their units.
_COLUMNS = (
    "muogram", "rays", "mean residual (g/cm²)", "RMS residual (g/cm²)", "relative residual (%)",
    "chi squared per ray",
)  # fmt: skip


def volume_outputs() -> list[QgsProcessingParameterDefinition]:
    """Declare the rasters, the points and the table of residuals."""
    return [
        *(
            explained(
                QgsProcessingParameterRasterDestination(
                    output, VOLUME_QUANTITIES[quantity].label, None, output != "DENSITY",
                    output in _BY_DEFAULT,
                ),
                f"{text} A GeoTIFF on the map with a band for each elevation slice, the lowest "
                "first.",
            )
            for output, quantity, _, text in _RASTERS
        ),
        explained(
            QgsProcessingParameterFeatureSink(
                POINTS, "Voxels as points", VECTOR_POINT, None, True, False
            ),
            "Centre of each voxel with a density as a point with height, with density, rays and, "
            "where there is one, the error: for 3-D views.",
        ),
        table_layer(
            RESIDUALS, "Residuals",
            "CSV: what the densities leave unexplained of each muogram.",
        ),
    ]  # fmt: skip


def stage_volumes(
    algorithm: QgsProcessingAlgorithm,
    result: Tomography,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
    inputs: tuple[str, ...],
) -> dict[str, str]:
    """Stage the rasters and the table that are wanted; return files by output name."""
    results = {}
    for output, _, attribute, _ in _RASTERS:
        path = destination(algorithm, parameters, output, context)
        if path is None:
            continue
        volume: Volume | None = getattr(result, attribute)
        if volume is None:
            raise MuyscError(
                f"{output} is asked for, and {result.method} tells no errors of {result.rays} "
                "rays; use bayes, with draws for the error (POSTERIOR_SAMPLES) beyond 2000 rays."
            )
        stage_volume(path, volume, result, context, staging, inputs)
        results[output] = path
    table = table_destination(algorithm, parameters, RESIDUALS, context)
    if table is not None:
        rows = [
            (one.name, one.rays, one.mean, one.rms, 100 * one.relative, one.chi_squared)
            for one in result.residuals
        ]
        stage_table(staging, table, _COLUMNS, rows)
        results[RESIDUALS] = table
    return results


def stage_volume(
    path: str,
    volume: Volume,
    result: Tomography,
    context: QgsProcessingContext,
    staging: Staging,
    inputs: tuple[str, ...],
) -> None:
    """Stage a volume with its style; densities are coloured as those of the result."""
    kind, limits = volume.kind, None
    if volume.quantity == "density":
        # As panel and report draw it: about the reference density.
        kind, limits = replace(kind, colours="blue_red"), result.density_limits
    temporary = stage_raster(
        staging, path, inputs, context, volume.values, kind,
        band=result.shown_level + 1, limits=limits, elevations=volume.grid.edges_m(2),
    )  # fmt: skip
    write_volume(volume, temporary)


def write_voxels(
    algorithm: QgsProcessingAlgorithm,
    result: Tomography,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
) -> dict[str, str]:
    """Write the voxels as points; called last, see `write_layer`.

    Raises
    ------
    MuyscError
        If the layer cannot be written.
    """
    known = result.density.known.ravel()
    kinds = {"density": float, "rays": int}
    columns = [result.density.values.ravel()[known].tolist()]
    columns.append(result.coverage.values.ravel()[known].astype(int).tolist())
    if result.deviation is not None:
        kinds["density_error"] = float
        columns.append(result.deviation.values.ravel()[known].tolist())
    points = (
        Point(tuple(place), values)
        for place, values in zip(result.grid.all_centres_m()[known].tolist(), zip(*columns))
    )
    crs = QgsCoordinateReferenceSystem.fromWkt(result.density.crs)
    return write_points(
        algorithm, POINTS, kinds, points, crs, parameters, context, staging, has_heights=True
    )
