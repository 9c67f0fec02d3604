"""Panel and report as outputs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from types import MappingProxyType, ModuleType
from typing import TYPE_CHECKING, Any

from osgeo import gdal
from qgis.core import (
    Qgis,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFileDestination,
)
from qgis.PyQt.QtCore import QDateTime

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.radiography.aperture import Aperture
from ...muysc_qgis.staging import Staging
from ...muysc_qgis.topography.sight import Sight
from ...muysc_qgis.workflows.simulation import Simulation
from ..language import english_label
from ..parameters.values import explained
from .told import told

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...muysc_qgis.plots.provenance import Provenance
    from ...muysc_qgis.plots.report import Report


def document_outputs(
    panel: str = "Picture of thickness and flux side by side, with contours, skyline and target.",
    report: str = "One HTML file with panels, map, parameters, numbers, every warning and how to "
    "cite.",
) -> list[QgsProcessingParameterDefinition]:
    """Declare panel and report, given the help of each."""
    return [
        explained(
            QgsProcessingParameterFileDestination(
                "PANEL", "Panel", "PNG pictures (*.png)", None, True, False
            ),
            panel,
        ),
        explained(
            QgsProcessingParameterFileDestination(
                "REPORT", "Report", "HTML files (*.html)", None, True, True
            ),
            report,
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

    def drawing() -> ModuleType:
        from ...muysc_qgis.plots import documents

        return documents

    return stage_drawn(
        algorithm,
        lambda: drawing().panel(simulation),
        lambda provenance: drawing().report(
            simulation, drawing().figures(simulation, sight, aperture), provenance
        ),
        written, parameters, context, feedback, staging, inputs,
    )  # fmt: skip


def stage_drawn(
    algorithm: QgsProcessingAlgorithm,
    panel: Callable[[], Figure],
    report: Callable[[Provenance], Report],
    written: dict[str, str],
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    feedback: QgsProcessingFeedback,
    staging: Staging,
    inputs: tuple[str, ...],
    further: Mapping[str, Callable[[], Figure]] = MappingProxyType({}),
) -> dict[str, str]:
    """Draw and stage panel and report where wanted; return files by output name.

    `panel` draws, as `further` pictures do by output name; `report` takes what the run was made
    from. What a missing library keeps from being drawn is left out with a warning, and everything
    else is written all the same.
    """
    pictures: list[bytes] = []
    results: dict[str, str] = {}
    left_out = {}

    def write_the_report(path: Path) -> None:
        from ...muysc_qgis.plots.provenance import Provenance
        from ...muysc_qgis.plots.report import Row, write_report

        provenance = Provenance(
            [Row(*row) for row in told(algorithm, parameters, context)],
            _files(algorithm, parameters, {**written, **results}),
            QDateTime.currentDateTime().toString("yyyy-MM-dd HH:mm"),
            {"QGIS": Qgis.QGIS_VERSION, "GDAL": gdal.__version__},
        )
        content = report(provenance)
        pictures.extend(figure.png for figure in content.figures if figure.is_panel)
        write_report(path, content)

    def write_the_panel(path: Path) -> None:
        # The report may hold it already: drawing takes longer than all else.
        if pictures:
            path.write_bytes(pictures[0])
        else:
            _write_picture(panel, path)

    writers = {name: partial(_write_picture, draw) for name, draw in further.items()}
    writers |= {"REPORT": write_the_report, "PANEL": write_the_panel}
    for name, write in writers.items():
        suffix = ".html" if name == "REPORT" else ".png"
        path = destination(algorithm, parameters, name, context, suffix)
        if path is None:
            continue
        temporary = staging.add(path, inputs)
        library = _missing_for(write, temporary)
        if library is None:
            results[name] = path
        else:
            staging.give_up(temporary)
            left_out[english_label(algorithm.parameterDefinition(name))] = library
    if left_out:
        what, libraries = " and no ".join(left_out), " and ".join(sorted({*left_out.values()}))
        feedback.pushWarning(
            f"Without the Python library {libraries}, which is missing, there is no {what}; "
            "everything else was written."
        )
    return results


def _write_picture(draw: Callable[[], Figure], path: Path) -> None:
    from ...muysc_qgis.plots.style import png_bytes

    path.write_bytes(png_bytes(draw()))


def _missing_for(write: Callable[[Path], None], path: Path) -> str | None:
    """Write a document; return the library without which that cannot be done, None if it was."""
    try:
        write(path)
    except (ImportError, MuyscError) as error:
        # The page itself says in a sentence what it misses.
        missing = error if isinstance(error, ImportError) else error.__cause__
        if not isinstance(missing, ImportError):
            raise
        return (missing.name or "").partition(".")[0]
    return None


def _files(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    written: Mapping[str, str],
) -> dict[str, str]:
    """Return the files that go with a report by what they are."""
    files = {}
    for definition in algorithm.parameterDefinitions():
        name, path = definition.name(), None
        if name in written:
            path = written[name]
        elif definition.isDestination() and name != "REPORT":
            # What is drawn or written later, if it is a file with a name of its own.
            given = parameters.get(name)
            path = given if isinstance(given, str) and Path(given).suffix else None
        if path is not None:
            files[english_label(definition)] = path
    return files


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
