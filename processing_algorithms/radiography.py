"""Muon radiography: from a DEM to muograms."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsRasterLayer,
)

from ..muysc_qgis.progress import Progress, silent
from ..muysc_qgis.radiography.aperture import Aperture
from ..muysc_qgis.radiography.settings import Physics
from ..muysc_qgis.staging import Staging
from ..muysc_qgis.topography.sight import Sight
from ..muysc_qgis.topography.terrain_error import TerrainErrors
from ..muysc_qgis.workflows.flux_spread import with_flux_spread
from ..muysc_qgis.workflows.simulation import Simulation, Telescope, check_range, simulate
from ..muysc_qgis.workflows.thickness_error import error_of_rays
from .base import MuyscAlgorithm, progress_of
from .outputs.documents import document_outputs, stage_documents
from .outputs.footprint import footprint_output, write_footprint
from .outputs.messages import say
from .outputs.rasters import raster_outputs, stage_muograms, wanted
from .parameters.physics import (
    physics_parameters,
    read_physics,
    read_telescope,
    telescope_parameters,
)
from .parameters.terrain import dem_parameters, read_dem
from .parameters.terrain_error import read_terrain_errors, terrain_error_parameters
from .parameters.values import read_number, read_optional
from .parameters.view import (
    aperture_parameters,
    read_aperture,
    read_sight,
    sight_parameters,
)

#: Quantity by output.
_OUTPUTS = {
    name.upper(): name
    for name in (
        "thickness", "opacity", "minimum_energy", "flux", "open_sky", "transmission", "exposure",
        "distance", "flux_minimum", "flux_maximum", "thickness_error",
    )
}  # fmt: skip


@dataclass(frozen=True)
class Inputs:
    """What a radiography starts from."""

    layer: QgsRasterLayer
    sight: Sight
    notes: list[str]
    aperture: Aperture
    max_range_m: float | None
    near_field_m: float
    physics: Physics
    telescope: Telescope
    errors: TerrainErrors = field(default_factory=TerrainErrors)

    def simulate(self, progress: Progress = silent) -> Simulation:
        """Simulate it.

        Raises
        ------
        MuyscError
            If a number cannot be used or the DEM cannot be read.
        Cancelled
            If `progress` asks for a stop.
        """
        return simulate(
            self.sight,
            self.aperture,
            self.physics,
            self.telescope,
            self.max_range_m,
            self.near_field_m,
            progress,
        )


class Radiography(MuyscAlgorithm):
    """The main job: what a telescope sees of a mountain."""

    NAME = "radiography"
    TITLE = "Muon radiography"
    GROUP = "Radiography"
    GROUP_ID = "radiography"
    TAGS = ("muogram", "thickness", "opacity", "flux", "exposure", "simulation")
    NUMBERS = (
        ("MAX_THICKNESS", "Largest thickness (m)"),
        ("DETECTOR_ELEVATION", "Detector elevation (m)"),
        ("BORESIGHT_AZIMUTH", "Boresight azimuth (°)"),
        ("BORESIGHT_ELEVATION", "Boresight elevation (°)"),
        ("TARGET_DISTANCE", "Target distance (m)"),
        ("ROCK_PIXELS", "Pixels with rock"),
        ("UNKNOWN_PIXELS", "Pixels without a flux"),
        ("MEDIAN_EXPOSURE", "Median exposure behind rock (days)"),
    )

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        return [
            *dem_parameters(),
            *sight_parameters(),
            *aperture_parameters(),
            *physics_parameters(),
            *telescope_parameters(),
            *terrain_error_parameters(),
            *raster_outputs(_OUTPUTS, always=("THICKNESS", "FLUX")),
            footprint_output(),
            *document_outputs(),
        ]

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Inputs:
        dem, layer = read_dem(self, parameters, context)
        sight, notes = read_sight(self, parameters, context, dem, layer)
        max_range = read_optional(self, parameters, "MAX_RANGE", context)
        near_field = read_number(self, parameters, "NEAR_FIELD", context)
        check_range(max_range, near_field)
        aperture = read_aperture(self, parameters, context)
        aperture.directions(sight.boresight_azimuth_deg, sight.boresight_elevation_deg)
        return Inputs(
            layer,
            sight,
            notes,
            aperture,
            max_range,
            near_field,
            read_physics(self, parameters, context),
            read_telescope(self, parameters, context),
            read_terrain_errors(self, parameters, context),
        )

    def compute(
        self,
        inputs: Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        sight = inputs.sight
        simulation = inputs.simulate(progress_of(feedback, 0.0, 0.7))
        if wanted(parameters, "FLUX_MINIMUM", "FLUX_MAXIMUM"):
            simulation = with_flux_spread(simulation, inputs.physics)
        if wanted(parameters, "THICKNESS_ERROR"):
            simulation = _with_errors(simulation, inputs, progress_of(feedback, 0.7, 0.75))
        say(feedback, simulation, inputs.notes)
        files = (sight.frame.dem.path,)
        results = stage_muograms(
            self, _OUTPUTS, simulation.muograms, parameters, context, staging, files
        )
        results |= stage_documents(
            self,
            simulation,
            results,
            parameters,
            context,
            feedback,
            staging,
            files,
            sight,
            inputs.aperture,
        )
        feedback.setProgress(95)
        crs = inputs.layer.crs()
        results |= write_footprint(
            self, simulation, sight, inputs.aperture, crs, parameters, context, staging
        )
        return results | _numbers(simulation, sight)


def _with_errors(simulation: Simulation, inputs: Inputs, progress: Progress) -> Simulation:
    """Add the errors of the thickness."""
    error = error_of_rays(
        inputs.sight,
        simulation.muograms["thickness"],
        inputs.errors,
        inputs.max_range_m,
        inputs.near_field_m,
        progress,
    )
    return replace(simulation, muograms={**simulation.muograms, error.quantity: error})


def _numbers(simulation: Simulation, sight: Sight) -> dict[str, float]:
    return {
        "MAX_THICKNESS": simulation.maximum_thickness_m,
        "DETECTOR_ELEVATION": sight.detector_elevation_m,
        "BORESIGHT_AZIMUTH": sight.boresight_azimuth_deg,
        "BORESIGHT_ELEVATION": sight.boresight_elevation_deg,
        "TARGET_DISTANCE": sight.target_distance_m,
        "ROCK_PIXELS": simulation.rock_pixels,
        "UNKNOWN_PIXELS": simulation.unknown_pixels,
        "MEDIAN_EXPOSURE": simulation.median_exposure_days,
    }
