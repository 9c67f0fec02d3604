"""Rasters in telescope angles, and tables of trajectories, as outputs."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFileDestination,
)

from ...muysc_qgis.staging import Staging
from ...muysc_qgis.trajectories import TrajectoryMap, write_trajectories, write_trajectory_table
from ..parameters.values import explained
from .documents import destination as document
from .rasters import destination, stage_raster

#: What the axes of these rasters are, for help texts.
AXES = (
    "the telescope's right to the right and its up upwards, as tangents of the angle from the "
    "boresight"
)

TABLE = "TABLE"


def table_output() -> QgsProcessingParameterDefinition:
    """Declare the table of trajectories."""
    return explained(
        QgsProcessingParameterFileDestination(
            TABLE, "Table of trajectories", "CSV files (*.csv)", None, True, False
        ),
        "CSV with a row for each trajectory and units in the header.",
    )


def stage_trajectories(
    algorithm: QgsProcessingAlgorithm,
    quantities: Mapping[str, str],
    maps: Mapping[str, TrajectoryMap],
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
    inputs: tuple[str, ...] = (),
) -> dict[str, str]:
    """Stage the rasters and the table that are wanted; return files by output name."""
    results = {}
    for output, name in quantities.items():
        path = destination(algorithm, parameters, output, context)
        if path is not None:
            one = maps[name]
            write_trajectories(
                one, stage_raster(staging, path, inputs, context, one.values, one.kind)
            )
            results[output] = path
    table = document(algorithm, parameters, TABLE, context, ".csv")
    if table is not None:
        write_trajectory_table(maps, staging.add(table, inputs))
        results[TABLE] = table
    return results
