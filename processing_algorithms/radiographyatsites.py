"""Muograms of one mountain from many sites."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsRasterLayer,
)

from ..muysc_qgis.errors import MuyscError
from ..muysc_qgis.staging import Staging
from ..muysc_qgis.topography.dem import Dem
from ..muysc_qgis.workflows.simulation import check_range
from ..muysc_qgis.workflows.sites import (
    Station,
    StationMuograms,
    gathered,
    make_muograms,
    stations_of,
)
from ..muysc_qgis.workflows.view_settings import ViewSettings
from .base import MuyscAlgorithm, progress_of
from .outputs.sites import (
    FOLDER,
    check_folder,
    folder_output,
    index_output,
    stage_station,
    write_index,
)
from .parameters.physics import (
    physics_parameters,
    read_physics,
    read_telescope,
    telescope_parameters,
)
from .parameters.sites import read_sites, sites_parameters
from .parameters.terrain import dem_parameters, read_dem
from .parameters.values import choices, read_choices, read_number, read_optional
from .parameters.view import (
    aperture_parameters,
    read_aperture,
    read_point,
    target_parameters,
)
from .parameters.workers import read_workers, workers_parameter

_QUANTITIES = (
    "thickness", "opacity", "flux", "minimum_energy", "open_sky", "transmission", "exposure",
    "distance",
)  # fmt: skip


@dataclass(frozen=True)
class _Inputs:
    dem: Dem
    layer: QgsRasterLayer
    stations: list[Station]
    #: What was assumed, and a sentence for each site that was skipped.
    notes: list[str]
    skipped: list[str]
    quantities: list[str]
    view: ViewSettings
    workers: int | None


class RadiographyAtSites(MuyscAlgorithm):
    """The main job from every point of a layer."""

    NAME = "radiographyatsites"
    TITLE = "Muograms from many sites"
    GROUP = "Survey"
    GROUP_ID = "survey"
    TAGS = ("muogram", "thickness", "flux", "stations", "survey", "batch")
    NUMBERS = (
        ("SITES_DONE", "Sites with muograms"),
        ("SITES_SKIPPED", "Sites skipped"),
        ("MUOGRAMS", "Muograms written"),
        ("MAX_THICKNESS", "Largest thickness from any site (m)"),
        ("MEDIAN_EXPOSURE", "Median over the sites of the median exposure (days)"),
        ("UNKNOWN_PIXELS", "Pixels without a flux from all sites"),
    )

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        return [
            *dem_parameters(),
            *sites_parameters(),
            *target_parameters(),
            choices(
                "QUANTITIES", "Quantities",
                "What to write for each site, one raster each.",
                list(_QUANTITIES), ["thickness", "opacity", "flux"],
            ),
            *aperture_parameters(),
            *physics_parameters(),
            *telescope_parameters(),
            workers_parameter(),
            folder_output(),
            index_output(),
        ]  # fmt: skip

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        read = (self, parameters)
        dem, layer = read_dem(*read, context)
        target, assumed = read_point(*read, "TARGET", context, dem, layer)
        target_height = read_number(*read, "TARGET_HEIGHT", context)
        max_range = read_optional(*read, "MAX_RANGE", context)
        near_field = read_number(*read, "NEAR_FIELD", context)
        check_range(max_range, near_field)
        aperture = read_aperture(*read, context)
        quantities = read_choices(*read, "QUANTITIES", context)
        if not quantities:
            raise MuyscError(
                f"QUANTITIES is empty; choose at least one of {', '.join(_QUANTITIES)}."
            )
        sites, notes, lost = read_sites(*read, context, dem, layer)
        stations, skipped = stations_of(dem, sites, target, target_height, aperture)
        return _Inputs(
            dem,
            layer,
            stations,
            [*assumed, *notes],
            [*lost, *skipped],
            quantities,
            ViewSettings(
                aperture,
                read_physics(*read, context),
                read_telescope(*read, context),
                max_range,
                near_field,
            ),
            read_workers(*read, context),
        )

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        quantities, files = inputs.quantities, (inputs.dem.path,)
        folder = Path(self.parameterAsString(parameters, FOLDER, context)).absolute()
        stems = [station.site.stem for station in inputs.stations]
        for text in inputs.notes:
            feedback.pushInfo(text)
        for text in (*inputs.skipped, *check_folder(folder, stems, quantities)):
            feedback.pushWarning(text)
        with TemporaryDirectory(prefix="muysc-") as temporary:
            stations = make_muograms(
                inputs.stations,
                inputs.view,
                quantities,
                Path(temporary),
                inputs.workers,
                progress_of(feedback, 0.0, 0.9),
                feedback.pushInfo,
                feedback.pushWarning,
            )
            for station in stations:
                stage_station(station, folder, context, staging, files)
        said = [(one.site.name, warning) for one in stations for warning in one.warnings]
        for text in gathered(said):
            feedback.pushWarning(text)
        crs = inputs.layer.crs()
        index = write_index(self, stations, quantities, crs, parameters, context, staging)
        return {FOLDER: str(folder), **index, **_numbers(inputs, stations)}


def _numbers(inputs: _Inputs, stations: list[StationMuograms]) -> dict[str, float]:
    thickness = np.array([one.numbers.maximum_thickness_m for one in stations])
    exposure = np.array([one.numbers.median_exposure_days for one in stations])
    return {
        "SITES_DONE": len(stations),
        "SITES_SKIPPED": len(inputs.skipped),
        "MUOGRAMS": len(stations) * len(inputs.quantities),
        "MAX_THICKNESS": float(np.fmax.reduce(thickness)),
        "MEDIAN_EXPOSURE": _median(exposure),
        "UNKNOWN_PIXELS": sum(one.numbers.unknown_pixels for one in stations),
    }


def _median(values: np.ndarray) -> float:
    known = values[np.isfinite(values)]
    return float(np.median(known)) if known.size else float("nan")
