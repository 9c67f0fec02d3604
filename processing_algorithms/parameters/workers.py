"""Parameters of who computes."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterString,
)

from ...muysc_qgis.errors import MuyscError
from .values import explained, number, read_optional


def workers_parameter() -> QgsProcessingParameterDefinition:
    """Declare how many processes compute."""
    return number(
        "WORKERS", "Worker processes (empty: one for each processor)",
        "Give the number of processes that compute, 0 or more; 0 and 1 compute in QGIS itself.",
        None, 0, whole=True, advanced=True,
    )  # fmt: skip


def scheduler_parameter() -> QgsProcessingParameterDefinition:
    """Declare the cluster that computes."""
    return explained(
        QgsProcessingParameterString(
            "SCHEDULER", "Dask scheduler (empty: this machine)", None, False, True
        ),
        "Address of the scheduler of a Dask cluster, such as tcp://10.0.0.1:8786, whose workers "
        "compute in place of this machine. It needs the Python library distributed.",
        advanced=True,
    )


def read_workers(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> int | None:
    """Return the number of workers, None for one for each processor.

    Raises
    ------
    MuyscError
        If the number is negative or no whole one.
    """
    workers = read_optional(algorithm, parameters, "WORKERS", context)
    if workers is not None and (workers < 0 or workers != round(workers)):
        raise MuyscError(
            f"{workers:g} worker processes are impossible; give a whole number from 0."
        )
    return None if workers is None else int(workers)
