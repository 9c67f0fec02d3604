"""Can this survey see it? Known bodies, simulated counts, and what is found again."""

from __future__ import annotations

from dataclasses import dataclass, replace
from types import ModuleType
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsRasterLayer,
)

from ..muysc_qgis.progress import Progress
from ..muysc_qgis.radiography.aperture import Aperture
from ..muysc_qgis.radiography.settings import Physics
from ..muysc_qgis.staging import Staging
from ..muysc_qgis.tomography.counting import COUNTS
from ..muysc_qgis.topography.dem import Dem
from ..muysc_qgis.topography.frame import to_wgs84
from ..muysc_qgis.workflows.count_tomography import CountChoices
from ..muysc_qgis.workflows.known_model import KnownModel
from ..muysc_qgis.workflows.reconstruction_test import KnownModelResult, reconstruct_known_model
from ..muysc_qgis.workflows.simulated_counts import Campaign
from ..muysc_qgis.workflows.sites import Station, stations_of
from ..muysc_qgis.workflows.survey_verdict import judge_survey, telescopes_at
from ..muysc_qgis.workflows.tomography import TomographyChoices
from ..muysc_qgis.workflows.volume_frame import projection_for
from ..muysc_qgis.workflows.volume_plan import VolumePlan
from .base import MuyscAlgorithm, progress_of
from .outputs.documents import document_outputs, stage_drawn
from .outputs.known_model import (
    NUMBERS,
    known_model_outputs,
    numbers,
    stage_known_model,
    write_stations,
)
from .outputs.rasters import wanted
from .outputs.volume import stage_volumes, volume_outputs, write_voxels
from .parameters.campaign import campaign_parameters, read_campaign, survey_parameters
from .parameters.counts import count_parameters, read_counting
from .parameters.known_model import model_parameters, read_model
from .parameters.physics import physics_parameters, read_physics
from .parameters.reconstruction import read_reconstruction, reconstruction_parameters
from .parameters.ring import read_stations, stations_parameters
from .parameters.terrain import dem_parameters, read_dem
from .parameters.values import read_count, read_number
from .parameters.view import aperture_parameters, read_aperture, read_point, target_parameters
from .parameters.volume import read_crs, read_plan, volume_parameters

if TYPE_CHECKING:
    from pyproj import CRS

#: Parameters of the field of view that a tomography has no use for.
_RANGE = ("MAX_RANGE", "NEAR_FIELD")

#: Voxels along the longest side, and pixels along both sides of a muogram, of a quick answer.
_VOXELS, _PIXELS = 40, 50


@dataclass(frozen=True)
class _Inputs:
    dem: Dem
    layer: QgsRasterLayer
    stations: list[Station]
    aperture: Aperture
    crs: CRS
    plan: VolumePlan
    model: KnownModel
    physics: Physics
    campaign: Campaign
    choices: TomographyChoices
    #: How counts are fitted, share of the muons counted, and number of surveys drawn.
    counting: CountChoices | None
    efficiency: float
    draws: int
    #: What was assumed, and a sentence for each site that was skipped.
    notes: list[str]
    skipped: list[str]


class ReconstructionTest(MuyscAlgorithm):
    """What a survey would find of a body that is known."""

    NAME = "reconstructiontest"
    TITLE = "Can this survey see it?"
    GROUP = "Tomography"
    GROUP_ID = "tomography"
    TAGS = ("muogram", "density", "3D", "voxel", "feasibility", "checkerboard", "resolution")
    NUMBERS = NUMBERS

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        aperture = [one for one in aperture_parameters() if one.name() not in _RANGE]
        volume = volume_parameters()
        defaults = {
            "AZIMUTH_PIXELS": _PIXELS, "ELEVATION_PIXELS": _PIXELS, "VOXELS": _VOXELS,
        }  # fmt: skip
        for one in (*aperture, *volume):
            if one.name() in defaults:
                one.setDefaultValue(defaults[one.name()])
        return [
            *dem_parameters(),
            *target_parameters(),
            *stations_parameters(),
            *model_parameters(),
            *aperture,
            *campaign_parameters(),
            *physics_parameters(density=False),
            *volume,
            *reconstruction_parameters(),
            *count_parameters(),
            *survey_parameters(),
            *volume_outputs(),
            *known_model_outputs(),
            *document_outputs(
                "Picture of the known model, of what is found and of the error, summed from the "
                "top, the front and the side, and in slices through the target.",
                "One HTML file with the panel, what is found of each body, the misfit by "
                "iteration and station, parameters, numbers, every warning and how to cite.",
            ),
        ]

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        read = (self, parameters)
        choices = read_reconstruction(*read, context, wanted(parameters, "DENSITY_ERROR"))
        dem, layer = read_dem(*read, context)
        target, notes = read_point(*read, "TARGET", context, dem, layer)
        target_height = read_number(*read, "TARGET_HEIGHT", context)
        aperture = read_aperture(*read, context)
        physics = read_physics(*read, context, density=False)
        sites, assumed, lost = read_stations(*read, context, dem, layer, target)
        stations, skipped = stations_of(dem, sites, target, target_height, aperture)
        crs = read_crs(*read, context) or projection_for(
            dem, *to_wgs84(dem.crs, *target, dem.transformation)
        )
        model, more = read_model(*read, context, dem, layer, target, crs, physics.density)
        return _Inputs(
            dem,
            layer,
            stations,
            aperture,
            crs,
            read_plan(*read, context, crs),
            model,
            replace(physics, density_g_cm3=model.density),
            read_campaign(*read, context),
            choices,
            read_counting(*read, context, replace(choices, reference_density=model.density))
            if choices.method == COUNTS
            else None,
            read_number(*read, "EFFICIENCY", context) / 100,
            read_count(*read, "DRAWS", context),
            [*notes, *assumed, *more],
            [*lost, *skipped],
        )

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        found = _found(inputs, progress_of(feedback, 0.0, 0.9))
        _say(feedback, inputs, found)
        values = numbers(found)
        files = (parameters, context)
        staged = (staging, (inputs.dem.path,))
        results = stage_volumes(self, found.tomography, *files, *staged)
        results |= stage_known_model(self, found, values, *files, *staged)
        results |= stage_drawn(
            self,
            lambda: _drawing().known_model_panel(found.tomography, found.truth),
            lambda provenance: _drawing().known_model_report(
                found,
                inputs.dem,
                provenance,
                warnings=inputs.skipped,
                discrepancy=inputs.choices.options.discrepancy,
            ),
            results, *files, feedback, *staged,
        )  # fmt: skip
        results |= write_voxels(self, found.tomography, *files, staging)
        crs = inputs.layer.crs()
        results |= write_stations(self, inputs.stations, found, crs, *files, staging)
        return results | values


def _found(inputs: _Inputs, progress: Progress) -> KnownModelResult:
    """Return what is found from counts along trajectories, or from pixels of one ray each."""
    if inputs.counting is not None:
        telescopes = telescopes_at(
            inputs.stations, inputs.aperture, inputs.physics, inputs.campaign, inputs.efficiency
        )
        return judge_survey(
            telescopes, inputs.dem, inputs.plan, inputs.model, inputs.campaign, inputs.counting,
            inputs.draws, inputs.crs, progress,
        )  # fmt: skip
    return reconstruct_known_model(
        inputs.stations,
        inputs.aperture,
        inputs.dem,
        inputs.plan,
        inputs.model,
        inputs.physics,
        inputs.campaign,
        inputs.choices,
        inputs.crs,
        progress,
    )


def _say(feedback: QgsProcessingFeedback, inputs: _Inputs, found: KnownModelResult) -> None:
    """Log what was used and found, the rays lost by cause, and every warning."""
    result = found.tomography
    for text in inputs.notes:
        feedback.pushInfo(text)
    for text in (*inputs.skipped, *inputs.campaign.telescope.notes):
        feedback.pushWarning(text)
    feedback.pushInfo(
        f"{result.rays} rays of {len(result.stations)} stations; {result.seen_voxels} of "
        f"{result.rock_voxels} voxels with rock have a density, the others are passed by no ray."
    )
    for cause, count in result.lost.items():
        feedback.pushInfo(f"  not used because {cause}: {count} rays")
    for body in found.bodies:
        feedback.pushInfo(
            f"Body {body.name}: {100 * body.contrast:.3g} % of the contrast is found; rays pass "
            f"{body.seen} of its {body.voxels} voxels."
        )
    feedback.pushInfo(
        f"The densities are off by {found.bias:.3g} ± {found.spread:.3g} g/cm³, "
        f"{100 * found.relative_error:.3g} % of them."
    )
    if found.verdict is not None:
        feedback.pushInfo(found.verdict.text)
    for text in result.warnings:
        feedback.pushWarning(text)


def _drawing() -> ModuleType:
    # Loaded only where something is drawn: matplotlib may be missing.
    from ..muysc_qgis.plots.tomography import documents

    return documents
