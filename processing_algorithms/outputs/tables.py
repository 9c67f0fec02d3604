"""Tables without geometry as layers."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterVectorDestination,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.staging import Staging
from ...muysc_qgis.tables import write_column_types, write_table
from ..compat import VECTOR
from ..parameters.values import explained, given


def table_layer(name: str, label: str, text: str) -> QgsProcessingParameterDefinition:
    """Declare a table that is loaded as a layer."""
    return explained(
        QgsProcessingParameterVectorDestination(name, label, VECTOR, None, True, True), text
    )


def table_destination(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> str | None:
    """Return the file of a table, None where it is not wanted.

    Raises
    ------
    MuyscError
        If it is no CSV file by its name.
    """
    if not given(parameters, name):
        return None
    path = str(algorithm.parameterAsOutputLayer(parameters, name, context))
    if Path(path).suffix.lower() != ".csv":
        raise MuyscError(f"{name} goes to “{path}”; give a file name that ends in .csv.")
    return path


def stage_table(
    staging: Staging, path: str, columns: Sequence[str], lines: Sequence[Sequence[object]]
) -> None:
    """Stage a table of at least one line, and the types of its columns beside it."""
    write_table(staging.add(path), columns, lines)
    write_column_types(staging.add(Path(path).with_suffix(".csvt")), lines[0])
