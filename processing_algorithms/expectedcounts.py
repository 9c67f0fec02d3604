"""What a telescope will count behind a mountain."""

from __future__ import annotations

from dataclasses import dataclass
from types import ModuleType
from typing import Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
)

from ..muysc_qgis.radiography.settings import Physics
from ..muysc_qgis.staging import Staging
from ..muysc_qgis.telescope.directions import Pointing
from ..muysc_qgis.telescope.geometry import TelescopeGeometry
from ..muysc_qgis.telescope.merging import check_merge
from ..muysc_qgis.telescope.planning import ON_REQUEST, CountingPlan
from ..muysc_qgis.topography.sight import Sight
from ..muysc_qgis.topography.terrain_error import TerrainErrors
from ..muysc_qgis.workflows.expected_counts import TelescopeCounts, expected_counts
from ..muysc_qgis.workflows.simulation import check_range
from ..muysc_qgis.workflows.thickness_error import error_of_trajectories
from .base import MuyscAlgorithm, progress_of
from .outputs.documents import document_outputs, stage_drawn
from .outputs.rasters import raster_outputs, wanted
from .outputs.trajectories import AXES, stage_trajectories, table_output
from .parameters.physics import physics_parameters, read_physics
from .parameters.telescope import (
    geometry_parameters,
    plan_parameters,
    pointing_parameters,
    read_geometry,
    read_plan,
    read_pointing,
)
from .parameters.terrain import dem_parameters, read_dem
from .parameters.terrain_error import read_terrain_errors, terrain_error_parameters
from .parameters.values import read_number, read_optional
from .parameters.view import aperture_parameters, read_sight, sight_parameters

#: Quantity by output.
_OUTPUTS = {
    name.upper(): name
    for name in (
        "counts", "exposure", "relative_error", "density_resolution", "contrast_days",
        "open_sky_counts", "flux", "thickness", "rock_share", "acceptance",
        "thickness_error",
    )
}  # fmt: skip

_RANGE = ("MAX_RANGE", "NEAR_FIELD")


@dataclass(frozen=True)
class _Inputs:
    name: str
    sight: Sight
    notes: list[str]
    unused: tuple[str, ...]
    geometry: TelescopeGeometry
    formula: str
    pointing: Pointing
    physics: Physics
    plan: CountingPlan
    max_range_m: float | None
    near_field_m: float
    errors: TerrainErrors


class ExpectedCounts(MuyscAlgorithm):
    """Radiography along the trajectories that a telescope has."""

    NAME = "expectedcounts"
    TITLE = "Expected counts in a telescope"
    GROUP = "Telescope"
    GROUP_ID = "telescope"
    TAGS = ("counts", "exposure", "feasibility", "contrast", "resolution", "rate", "acceptance")
    NUMBERS = (
        ("TOTAL_RATE", "Muons along all known trajectories (per day)"),
        ("ROCK_RATE", "Muons along trajectories behind rock (per day)"),
        ("MEDIAN_COUNTS", "Median counts behind rock"),
        ("MEDIAN_EXPOSURE", "Median exposure behind rock (days)"),
        ("MEDIAN_DENSITY_RESOLUTION", "Median of the smallest visible contrast (%)"),
        ("MEDIAN_CONTRAST_DAYS", "Median time to see the contrast (days)"),
        ("TRAJECTORIES", "Trajectories or bins of them"),
        ("ROCK_TRAJECTORIES", "Trajectories behind rock"),
        ("UNKNOWN_TRAJECTORIES", "Trajectories without counts"),
        ("QUADRATURE_ERROR", "Error of the sums over sub-rays (counting errors)"),
        ("BORESIGHT_AZIMUTH", "Boresight azimuth (°)"),
        ("BORESIGHT_ELEVATION", "Boresight elevation (°)"),
        ("DETECTOR_ELEVATION", "Detector elevation (m)"),
        ("TARGET_DISTANCE", "Target distance (m)"),
    )

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        return [
            *dem_parameters(),
            *sight_parameters(),
            *geometry_parameters(),
            *pointing_parameters(),
            *plan_parameters(),
            *terrain_error_parameters(),
            *physics_parameters(),
            *(one for one in aperture_parameters() if one.name() in _RANGE),
            *raster_outputs(_OUTPUTS, ("COUNTS",), AXES),
            table_output(),
            *document_outputs(
                "Picture of the counts on the mountain with skyline, horizon and target, beside "
                "the counting error, the contrast that can be seen and the days that it takes."
            ),
        ]

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        geometry, formula, unused = read_geometry(self, parameters, context)
        plan = read_plan(self, parameters, context)
        for bars in (geometry.bars_x, geometry.bars_y):
            check_merge(bars, plan.merge)
        dem, layer = read_dem(self, parameters, context)
        sight, notes = read_sight(self, parameters, context, dem, layer)
        max_range = read_optional(self, parameters, "MAX_RANGE", context)
        near_field = read_number(self, parameters, "NEAR_FIELD", context)
        check_range(max_range, near_field)
        return _Inputs(
            self.parameterAsEnumString(parameters, "PRESET", context),
            sight,
            notes,
            unused,
            geometry,
            formula,
            read_pointing(self, parameters, context, sight),
            read_physics(self, parameters, context),
            plan,
            max_range,
            near_field,
            read_terrain_errors(self, parameters, context),
        )

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        counts = expected_counts(
            inputs.sight,
            inputs.geometry,
            inputs.pointing,
            inputs.physics,
            inputs.plan,
            inputs.formula,
            inputs.max_range_m,
            inputs.near_field_m,
            # The medians are numbers that models wire: they are always there.
            ON_REQUEST,
            progress_of(feedback, 0.0, 0.6),
        )
        _say(feedback, counts, inputs)
        files = (inputs.sight.frame.dem.path,)
        maps = dict(counts.maps)
        if wanted(parameters, "THICKNESS_ERROR"):
            maps["thickness_error"] = error_of_trajectories(
                inputs.sight,
                maps["thickness"],
                inputs.errors,
                inputs.max_range_m,
                inputs.near_field_m,
                progress_of(feedback, 0.6, 0.7),
            )
        results = stage_trajectories(self, _OUTPUTS, maps, parameters, context, staging, files)
        results |= stage_drawn(
            self, lambda: _drawing().counts_panel(counts, inputs.name),
            lambda provenance: _drawing().counts_report(
                counts, inputs.sight, inputs.name, inputs.unused, provenance
            ),
            results, parameters, context, feedback, staging, files,
        )  # fmt: skip
        return results | _numbers(counts, inputs.sight)


def _say(feedback: QgsProcessingFeedback, counts: TelescopeCounts, inputs: _Inputs) -> None:
    for note in inputs.notes:
        feedback.pushInfo(note)
    feedback.pushInfo(
        f"{counts.rock_trajectories} of {counts.trajectories} trajectories see rock, "
        f"{counts.unknown_trajectories} cannot be known."
    )
    feedback.pushInfo(
        f"{counts.rays:,} rays stand for the responses; their sums are off by up to "
        f"{counts.quadrature_error:.2g} counting errors in 95 % of the trajectories."
    )
    for cause, number_of in counts.unknown.items():
        feedback.pushInfo(f"  unknown because {cause}: {number_of} trajectories")
    for warning in (*inputs.unused, *counts.warnings):
        feedback.pushWarning(warning)


def _numbers(counts: TelescopeCounts, sight: Sight) -> dict[str, float]:
    return {
        "TOTAL_RATE": counts.rate_per_day(),
        "ROCK_RATE": counts.rate_per_day(behind_rock=True),
        "MEDIAN_COUNTS": counts.median("counts"),
        "MEDIAN_EXPOSURE": counts.median("exposure"),
        "MEDIAN_DENSITY_RESOLUTION": counts.median("density_resolution"),
        "MEDIAN_CONTRAST_DAYS": counts.median("contrast_days"),
        "TRAJECTORIES": counts.trajectories,
        "ROCK_TRAJECTORIES": counts.rock_trajectories,
        "UNKNOWN_TRAJECTORIES": counts.unknown_trajectories,
        "QUADRATURE_ERROR": counts.quadrature_error,
        "BORESIGHT_AZIMUTH": counts.pointing.azimuth_deg,
        "BORESIGHT_ELEVATION": counts.pointing.elevation_deg,
        "DETECTOR_ELEVATION": sight.detector_elevation_m,
        "TARGET_DISTANCE": sight.target_distance_m,
    }


def _drawing() -> ModuleType:
    # Loaded only where something is drawn: matplotlib may be missing.
    from ..muysc_qgis.plots import telescope_documents

    return telescope_documents
