"""What every algorithm shares: errors, progress, help, outputs that appear together."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProcessingOutputDefinition,
    QgsProcessingOutputNumber,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFolderDestination,
)
from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtGui import QIcon

from ..muysc_qgis.errors import Cancelled, MuyscError
from ..muysc_qgis.progress import Progress
from ..muysc_qgis.staging import Staging, check_destination
from ..muysc_qgis.translation import language, tr
from .language import translated
from .outputs.layers import file_of, files_read

ROOT = Path(__file__).resolve().parent.parent
HELP_FOLDER = Path(__file__).parent / "help"
#: One page for each algorithm, made by ``make reference``.
PAGES = ROOT / "docs" / "reference"
#: One icon for each group of the toolbox, by its id.
GROUP_ICONS = ROOT / "icons" / "groups"


class MuyscAlgorithm(QgsProcessingAlgorithm):
    """An algorithm that declares, converts, calls the library once and writes.

    Subclasses set the class attributes and implement `declare`, `read` and `compute`.
    """

    NAME = ""
    TITLE = ""
    GROUP = ""
    GROUP_ID = ""
    TAGS: tuple[str, ...] = ()
    #: Name and label of every number that it returns.
    NUMBERS: tuple[tuple[str, str], ...] = ()

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        """Return the parameters in the order of the dialog."""
        raise NotImplementedError

    def declare_outputs(self) -> None:
        """Add the outputs that are no destination parameters, through `addOutput`."""
        for name, label in self.NUMBERS:
            self.addOutput(QgsProcessingOutputNumber(name, label))

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Any:
        """Convert parameters to the library's types.

        Raises
        ------
        MuyscError
            If a value cannot be used.
        """
        raise NotImplementedError

    def compute(
        self,
        inputs: Any,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        """Call the library and stage its results.

        Raises
        ------
        MuyscError
            If something cannot be computed or written.
        Cancelled
            If the user stopped it.
        """
        raise NotImplementedError

    # What QGIS asks for.

    def createInstance(self) -> MuyscAlgorithm:
        return type(self)()

    def name(self) -> str:
        return self.NAME

    def displayName(self) -> str:
        return tr(self.TITLE)

    def group(self) -> str:
        return tr(self.GROUP)

    def groupId(self) -> str:
        return self.GROUP_ID

    def tags(self) -> list[str]:
        return ["muon", "muography", "volcano", *self.TAGS]

    def icon(self) -> QIcon:
        return QIcon(str(GROUP_ICONS / f"{self.GROUP_ID}.svg"))

    def helpUrl(self) -> str:
        return help_url(self.name())

    def shortHelpString(self) -> str:
        return " ".join(map(tr, help_paragraphs(self.NAME)))

    def initAlgorithm(self, configuration: dict[str, Any] | None = None) -> None:
        for parameter in self.declare():
            self.addParameter(translated(parameter))
        self.declare_outputs()

    def addOutput(self, output: QgsProcessingOutputDefinition) -> bool:
        output.setDescription(tr(output.description()))
        return super().addOutput(output)

    def checkParameterValues(
        self, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> tuple[bool, str]:
        try:
            self.read(parameters, context)
        except MuyscError as error:
            return False, str(error)
        except ImportError as error:
            return False, missing_library(error)
        return super().checkParameterValues(parameters, context)

    def processAlgorithm(
        self,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
    ) -> dict[str, Any]:
        self._warn_of_undeclared(parameters, feedback)
        staging = Staging()
        try:
            with staging:
                inputs = self.read(parameters, context)
                self._check_destinations(parameters, context)
                results = self.compute(inputs, parameters, context, feedback, staging)
                staging.commit()
        except MuyscError as error:
            raise QgsProcessingException(staging.by_destination(str(error))) from error
        except OSError as error:
            raise QgsProcessingException(
                staging.by_destination(_trouble_with_files(error))
            ) from error
        except Cancelled:
            raise QgsProcessingException("Cancelled; no output was written.") from None
        except ImportError as error:
            raise QgsProcessingException(missing_library(error)) from error
        except MemoryError:
            raise QgsProcessingException(
                "There is not enough memory for this; use fewer pixels or a shorter range."
            ) from None
        return {name: _plain(value) for name, value in results.items()}

    def _check_destinations(
        self, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> None:
        """Refuse destinations that cannot be written, or are read, before anything is computed."""
        inputs = tuple(
            file
            for definition in self.parameterDefinitions()
            if not definition.isDestination()
            for file in files_read(parameters.get(definition.name()), context)
        )
        for definition in self.parameterDefinitions():
            if isinstance(definition, QgsProcessingParameterFolderDestination):
                continue  # the files in it are checked when they are staged
            path = file_of(parameters.get(definition.name()))
            if definition.isDestination() and path is not None:
                check_destination(path, inputs)

    def _warn_of_undeclared(
        self, parameters: dict[str, Any], feedback: QgsProcessingFeedback
    ) -> None:
        declared = {definition.name() for definition in self.parameterDefinitions()}
        for name in parameters:
            if name not in declared:
                feedback.pushWarning(
                    f"{name} is no parameter of {self.id()} and was ignored; the parameters are "
                    f"{', '.join(sorted(declared))}."
                )


def help_url(name: str) -> str:
    """Return the page of an algorithm, which comes with the plugin and needs no network."""
    pages = [PAGES / language() / f"{name}.html", PAGES / f"{name}.html"]
    return QUrl.fromLocalFile(str(next(filter(Path.is_file, pages), pages[-1]))).toString()


def help_paragraphs(name: str) -> list[str]:
    """Return the paragraphs of a help page, each on one line."""
    page = (HELP_FOLDER / f"{name}.html").read_text(encoding="utf-8")
    # QGIS would make a paragraph of every line.
    return [f"{' '.join(one.split())}</p>" for one in page.split("</p>") if one.strip()]


def progress_of(feedback: QgsProcessingFeedback, start: float, end: float) -> Progress:
    """Return the library's progress for a stretch (0 to 1) of the progress bar."""

    def progress(fraction: float) -> bool:
        feedback.setProgress(100 * (start + (end - start) * fraction))
        return not feedback.isCanceled()

    return progress


def missing_library(error: ImportError) -> str:
    """Return how to get the library that could not be imported."""
    library = (error.name or "").split(".")[0]
    return (
        f"The Python library {library} is missing; install it for the Python of QGIS "
        f"(python3-{library} on Debian and in the OSGeo4W setup on Windows)."
    )


def _trouble_with_files(error: OSError) -> str:
    """Return what a disk or a network share did not do."""
    return (
        f"{error.filename or 'A file'} cannot be read or written ({error.strerror or error}); make "
        "room on the disk, or choose another place."
    )


def _plain(value: Any) -> Any:
    """Return a numpy scalar as a Python number; QGIS prints nothing for others."""
    return value.item() if hasattr(value, "item") else value
