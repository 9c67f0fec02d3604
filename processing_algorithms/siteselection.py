"""Which of many places sees the target best."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
)

from ..muysc_qgis.errors import Cancelled
from ..muysc_qgis.staging import Staging
from ..muysc_qgis.survey.blocks import remove_finished
from ..muysc_qgis.survey.search import Search
from ..muysc_qgis.workflows.simulation import check_range
from ..muysc_qgis.workflows.site_assessment import SurveyPlan
from ..muysc_qgis.workflows.site_selection import Selection, Wanted, select_sites
from ..muysc_qgis.workflows.view_settings import ViewSettings
from .base import MuyscAlgorithm, progress_of
from .outputs.documents import document_outputs, stage_drawn
from .outputs.rasters import destination
from .outputs.survey import map_outputs, site_outputs, stage_maps, write_sites
from .parameters.physics import (
    physics_parameters,
    read_physics,
    read_telescope,
    telescope_parameters,
)
from .parameters.survey import (
    candidate_parameters,
    choice_parameters,
    read_search,
    read_wanted,
    target_body_parameters,
)
from .parameters.terrain import dem_parameters, read_dem
from .parameters.values import read_number, read_optional
from .parameters.view import (
    aperture_parameters,
    detector_height_parameter,
    read_aperture,
    read_point,
    target_parameters,
)
from .parameters.workers import read_workers, scheduler_parameter, workers_parameter

#: Pixels across and up by default: coarser than a muogram, of which nobody sees the pixels.
_PIXELS = 64


@dataclass(frozen=True)
class _Inputs:
    plan: SurveyPlan
    search: Search
    notes: list[str]
    wanted: Wanted
    workers: int | None
    scheduler: str


class SiteSelection(MuyscAlgorithm):
    """A radiography from every place around a target, and the choice among them."""

    NAME = "siteselection"
    TITLE = "Where to put the telescope"
    GROUP = "Survey"
    GROUP_ID = "survey"
    TAGS = ("site", "survey", "candidates", "visibility", "suitability", "dask", "coverage")
    NUMBERS = (
        ("CANDIDATES_DONE", "Candidates"),
        ("CANDIDATES_SEEING", "Candidates that see a part of the target"),
        ("BEST_SCORE", "Highest score"),
        ("BEST_EXPOSURE", "Days to the muons wanted at the best site"),
        ("BEST_SHARE_SEEN", "Share of the target seen from the best site"),
        ("COVERAGE", "Mean coverage of the azimuths by the telescopes that go together"),
    )

    def __init__(self) -> None:
        super().__init__()
        self._finished: Path | None = None

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        aperture = aperture_parameters()
        for one in aperture:
            if one.name().endswith("PIXELS"):
                one.setDefaultValue(_PIXELS)
        return [
            *dem_parameters(),
            *target_parameters(),
            detector_height_parameter(),
            *candidate_parameters(),
            *target_body_parameters(),
            *choice_parameters(),
            *aperture,
            *physics_parameters(),
            *telescope_parameters(),
            workers_parameter(),
            scheduler_parameter(),
            *map_outputs(),
            *site_outputs(),
            *document_outputs(
                "Picture of the score on the map with the sites chosen, the azimuths around the "
                "target that the telescopes cover, and exposure times against the share seen."
            ),
        ]

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        read = (self, parameters)
        dem, layer = read_dem(*read, context)
        target, assumed = read_point(*read, "TARGET", context, dem, layer)
        max_range = read_optional(*read, "MAX_RANGE", context)
        (
            near_field, target_height, detector_height, radius, depth, thin, thick, days,
        ) = (
            read_number(*read, name, context)
            for name in (
                "NEAR_FIELD", "TARGET_HEIGHT", "DETECTOR_HEIGHT", "TARGET_RADIUS", "TARGET_DEPTH",
                "MINIMUM_THICKNESS", "MAXIMUM_THICKNESS", "DAYS",
            )
        )  # fmt: skip
        check_range(max_range, near_field)
        plan = SurveyPlan(
            dem,
            target,
            target_height,
            detector_height,
            ViewSettings(
                read_aperture(*read, context),
                read_physics(*read, context),
                read_telescope(*read, context),
                max_range,
                near_field,
            ),
            radius,
            depth,
            thin,
            thick,
            days,
        )
        plan.body()
        search, notes = read_search(*read, context, dem, layer, target)
        return _Inputs(
            plan,
            search,
            [*assumed, *notes],
            read_wanted(*read, context),
            read_workers(*read, context),
            self.parameterAsString(parameters, "SCHEDULER", context).strip(),
        )

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        folder = Path(f"{destination(self, parameters, 'SCORE', context)}.partial").absolute()
        for note in inputs.notes:
            feedback.pushInfo(note)
        candidates = inputs.search.candidates()
        feedback.pushInfo(f"{len(candidates)} candidates keep to all limits.")
        for limit, count in candidates.removed.items():
            if count:
                feedback.pushInfo(f"  Left out because {limit}: {count}")
        try:
            selection = select_sites(
                inputs.plan,
                candidates,
                inputs.wanted,
                folder,
                inputs.workers,
                inputs.scheduler,
                progress_of(feedback, 0.0, 0.95),
                feedback.pushInfo,
                feedback.pushWarning,
            )
        except Cancelled:
            feedback.pushInfo(
                f"What is finished is kept in {folder}; run again with the same SCORE to go on."
            )
            raise
        for warning in selection.warnings:
            feedback.pushWarning(warning)
        self._finished = folder
        results = stage_maps(self, selection, inputs.plan, parameters, context, staging)
        files = (inputs.plan.dem.path,)
        results |= stage_drawn(
            self,
            lambda: _drawing().panel(selection, inputs.plan),
            lambda provenance: _drawing().report(selection, inputs.plan, provenance),
            results, parameters, context, feedback, staging, files,
        )  # fmt: skip
        results |= write_sites(self, selection, inputs.plan, parameters, context, staging)
        return results | _numbers(selection)

    def postProcessAlgorithm(
        self, context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        # Only now every file stands where it belongs.
        if self._finished is not None:
            remove_finished(self._finished)
        return {}


def _numbers(selection: Selection) -> dict[str, float]:
    best = selection.best[0]
    return {
        "CANDIDATES_DONE": len(selection.candidates),
        "CANDIDATES_SEEING": int((selection.numbers["share_seen"] > 0).sum()),
        "BEST_SCORE": selection.numbers["score"][best],
        "BEST_EXPOSURE": selection.numbers["exposure_days"][best],
        "BEST_SHARE_SEEN": selection.numbers["share_seen"][best],
        "COVERAGE": selection.coverage[-1],
    }


def _drawing() -> ModuleType:
    # Loaded only where something is drawn: matplotlib may be missing.
    from ..muysc_qgis.plots import survey_documents

    return survey_documents
