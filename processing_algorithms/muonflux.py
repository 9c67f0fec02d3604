"""Muon flux behind rock that is already known."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterRasterLayer,
)

from ..muysc_qgis.errors import MuyscError
from ..muysc_qgis.muogram import Muogram
from ..muysc_qgis.radiography.settings import Physics
from ..muysc_qgis.staging import Staging
from ..muysc_qgis.workflows.flux_spread import with_flux_spread
from ..muysc_qgis.workflows.provenance import altitude_of
from ..muysc_qgis.workflows.simulation import Telescope, through_rock
from .base import MuyscAlgorithm, progress_of
from .outputs.documents import document_outputs, stage_documents
from .outputs.messages import say
from .outputs.rasters import raster_outputs, stage_muograms, wanted
from .parameters.muograms import read_muogram_layer
from .parameters.physics import (
    physics_parameters,
    read_physics,
    read_telescope,
    telescope_parameters,
)
from .parameters.values import explained, given, number, read_optional

#: Quantity by output. The inputs have the plain names of thickness and opacity.
_OUTPUTS = {
    "THICKNESS_OUTPUT": "thickness",
    "OPACITY_OUTPUT": "opacity",
    "MINIMUM_ENERGY": "minimum_energy",
    "FLUX": "flux",
    "OPEN_SKY": "open_sky",
    "TRANSMISSION": "transmission",
    "EXPOSURE": "exposure",
    "FLUX_MINIMUM": "flux_minimum",
    "FLUX_MAXIMUM": "flux_maximum",
}


@dataclass(frozen=True)
class _Inputs:
    path: str
    rock: Muogram
    altitude_m: float | None
    physics: Physics
    telescope: Telescope


class MuonFlux(MuyscAlgorithm):
    """The same physics as radiography, from a muogram instead of a DEM."""

    NAME = "muonflux"
    TITLE = "Muon flux through rock"
    GROUP = "Radiography"
    GROUP_ID = "radiography"
    TAGS = ("muogram", "thickness", "opacity", "flux", "exposure")
    NUMBERS = (
        ("MAX_THICKNESS", "Largest thickness (m)"),
        ("ROCK_PIXELS", "Pixels with rock"),
        ("UNKNOWN_PIXELS", "Pixels without a flux"),
        ("MEDIAN_EXPOSURE", "Median exposure behind rock (days)"),
    )

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        return [
            explained(
                QgsProcessingParameterRasterLayer("THICKNESS", "Thickness muogram", None, True),
                "Muogram of rock thickness in m, as radiography writes it. Give this or an opacity "
                "muogram.",
            ),
            explained(
                QgsProcessingParameterRasterLayer("OPACITY", "Opacity muogram", None, True),
                "Muogram of opacity in g/cm². Give this or a thickness muogram.",
            ),
            number(
                "DETECTOR_ELEVATION", "Detector elevation (m, empty: the muogram's)",
                "Give the altitude of the detector in m, −1000 to 10000, for the altitude "
                "correction. Empty takes what the muogram says.",
                None, -1000, 10_000, advanced=True,
            ),
            *physics_parameters(),
            *telescope_parameters(),
            *raster_outputs(_OUTPUTS, always=("FLUX",)),
            *document_outputs(),
        ]  # fmt: skip

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        names = [name for name in ("THICKNESS", "OPACITY") if given(parameters, name)]
        if len(names) != 1:
            state = (
                "Both THICKNESS and OPACITY are" if names else "Neither THICKNESS nor OPACITY is"
            )
            raise MuyscError(f"{state} given; choose exactly one muogram to start from.")
        rock, path = read_muogram_layer(self, parameters, names[0], context)
        if rock.quantity != names[0].lower():
            raise MuyscError(
                f"{names[0]} is a muogram of {rock.quantity}; choose one of {names[0].lower()}."
            )
        physics = read_physics(self, parameters, context)
        altitude = altitude_of(
            rock, physics, read_optional(self, parameters, "DETECTOR_ELEVATION", context)
        )
        return _Inputs(path, rock, altitude, physics, read_telescope(self, parameters, context))

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        simulation = through_rock(
            inputs.rock,
            inputs.physics,
            inputs.telescope,
            inputs.altitude_m,
            progress_of(feedback, 0.0, 0.6),
        )
        if wanted(parameters, "FLUX_MINIMUM", "FLUX_MAXIMUM"):
            simulation = with_flux_spread(simulation, inputs.physics, inputs.altitude_m)
        say(feedback, simulation)
        files = (inputs.path,)
        results = stage_muograms(
            self, _OUTPUTS, simulation.muograms, parameters, context, staging, files
        )
        results |= stage_documents(
            self, simulation, results, parameters, context, feedback, staging, files
        )
        return results | {
            "MAX_THICKNESS": simulation.maximum_thickness_m,
            "ROCK_PIXELS": simulation.rock_pixels,
            "UNKNOWN_PIXELS": simulation.unknown_pixels,
            "MEDIAN_EXPOSURE": simulation.median_exposure_days,
        }
