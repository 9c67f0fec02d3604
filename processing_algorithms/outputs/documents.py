"""Panel and report as outputs."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from osgeo import gdal
from qgis.core import (
    Qgis,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingDestinationParameter,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFileDestination,
)
from qgis.PyQt.QtCore import QDateTime, Qt

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.radiography.aperture import Aperture
from ...muysc_qgis.staging import Staging
from ...muysc_qgis.topography.sight import Sight
from ...muysc_qgis.workflows.simulation import Simulation
from ..parameters.values import explained

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...muysc_qgis.plots.report import Report

#: Units that labels of parameters end with.
_UNITS = ("m", "cm", "°", "g/cm³", "cm² sr", "GeV", "days", "%")

_SUFFIXES = {"PANEL": ".png", "REPORT": ".html"}


def document_outputs(shown: str = "thickness and flux") -> list[QgsProcessingParameterDefinition]:
    """Declare panel and report, given what the panel shows."""
    return [
        explained(
            QgsProcessingParameterFileDestination(
                "PANEL", "Panel", "PNG pictures (*.png)", None, True, False
            ),
            f"Picture of {shown} side by side, with contours, skyline and target.",
        ),
        explained(
            QgsProcessingParameterFileDestination(
                "REPORT", "Report", "HTML files (*.html)", None, True, True
            ),
            "One HTML file with panels, map, parameters, numbers, every warning and how to cite.",
        ),
    ]


def stage_documents(
    algorithm: QgsProcessingAlgorithm,
    simulation: Simulation,
    written: dict[str, str],
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    feedback: QgsProcessingFeedback,
    staging: Staging,
    inputs: tuple[str, ...],
    sight: Sight | None = None,
    aperture: Aperture | None = None,
) -> dict[str, str]:
    """Draw and stage panel and report of a simulation; see `stage_drawn`."""

    def panel() -> Figure:
        from ...muysc_qgis.plots import documents

        return documents.panel(simulation)

    def report(*told: Any) -> Report:
        from ...muysc_qgis.plots import documents

        return documents.report(simulation, documents.figures(simulation, sight, aperture), *told)

    return stage_drawn(
        algorithm, panel, report, written, parameters, context, feedback, staging, inputs
    )


def stage_drawn(
    algorithm: QgsProcessingAlgorithm,
    panel: Callable[[], Figure],
    report: Callable[..., Report],
    written: dict[str, str],
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    feedback: QgsProcessingFeedback,
    staging: Staging,
    inputs: tuple[str, ...],
) -> dict[str, str]:
    """Draw and stage panel and report where wanted; return files by output name.

    `panel` draws; `report` takes parameters, files by label, date and versions. Where a
    library for drawing is missing, a warning says so and the rasters are written all the
    same.
    """
    staged = {
        name: staging.add(path, inputs)
        for name in _SUFFIXES
        if (path := destination(algorithm, parameters, name, context, _SUFFIXES[name]))
    }
    if not staged:
        return {}
    try:
        from ...muysc_qgis.plots.documents import Parameter
        from ...muysc_qgis.plots.report import write_report
        from ...muysc_qgis.plots.style import png_bytes

        drawn = None
        if "REPORT" in staged:
            content = report(
                _told(algorithm, parameters, context, Parameter),
                {algorithm.parameterDefinition(name).description(): written[name]
                 for name in written},
                QDateTime.currentDateTime().toString(Qt.DateFormat.ISODate),
                {"QGIS": Qgis.QGIS_VERSION, "GDAL": gdal.__version__},
            )  # fmt: skip
            write_report(staged["REPORT"], content)
            # The report may hold the panel already: drawing takes longer than all else.
            drawn = next((figure.png for figure in content.figures if figure.is_panel), None)
        if "PANEL" in staged:
            staged["PANEL"].write_bytes(png_bytes(panel()) if drawn is None else drawn)
    except ImportError as error:
        feedback.pushWarning(
            f"Panel and report need the Python library {error.name}, which is missing; the "
            "rasters were written without them."
        )
        return {}
    return {
        name: destination(algorithm, parameters, name, context, _SUFFIXES[name]) for name in staged
    }


def destination(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
    suffix: str,
) -> str | None:
    """Return where a file goes, None where it is not wanted.

    Raises
    ------
    MuyscError
        If the file name ends in something else.
    """
    if parameters.get(name) in (None, ""):
        return None
    path = algorithm.parameterAsFileOutput(parameters, name, context)
    if Path(path).suffix.lower() != suffix:
        raise MuyscError(f"{name} goes to “{path}”; give a file name that ends in {suffix}.")
    return path


def _told(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    kind: type,
) -> list[Any]:
    """Return every input parameter with its value, for the report."""
    rows = []
    for definition in algorithm.parameterDefinitions():
        if isinstance(definition, QgsProcessingDestinationParameter):
            continue
        value = parameters.get(definition.name())
        if value is None:
            value = definition.defaultValue()
        if value is None or value == "":
            value = "–"
        elif isinstance(value, list) and all(isinstance(one, (str, int, float)) for one in value):
            value = ", ".join(map(str, value))
        elif not isinstance(value, (str, int, float)):
            value = definition.valueAsPythonString(value, context).strip("'")
        label, unit = _split_unit(definition.description())
        rows.append(kind(label, value, unit))
    return rows


def _split_unit(label: str) -> tuple[str, str]:
    """Return “Density (g/cm³, empty: …)” as label and unit."""
    match = re.match(r"^(.*?) \(([^,)]+)(?:, (.*))?\)$", label)
    if match and match.group(2) in _UNITS:
        return match.group(1), match.group(2)
    return label, ""
