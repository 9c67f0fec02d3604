"""A muogram back on the map."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterRasterLayer,
)

from ..muysc_qgis.errors import MuyscError
from ..muysc_qgis.muogram import View
from ..muysc_qgis.staging import Staging
from ..muysc_qgis.topography.dem import Dem
from ..muysc_qgis.topography.drape import SIDES, check_detector, drape
from ..muysc_qgis.topography.raster import write_on_grid
from ..muysc_qgis.trajectories import read_view
from .base import MuyscAlgorithm, progress_of
from .outputs.rasters import destination, stage_raster
from .parameters.terrain import dem_parameters, raster_layer, read_dem
from .parameters.values import choice, explained, read_choice


@dataclass(frozen=True)
class _Inputs:
    path: str
    muogram: View
    dem: Dem
    side: str


class Drape(MuyscAlgorithm):
    """Projects a muogram onto the rock face that its detector sees."""

    NAME = "drape"
    TITLE = "Drape muogram on the terrain"
    GROUP = "Radiography"
    GROUP_ID = "radiography"
    TAGS = ("muogram", "project", "georeference")
    NUMBERS = (("CELLS", "Cells with a value"),)

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        return [
            explained(
                QgsProcessingParameterRasterLayer("MUOGRAM", "Muogram"),
                "Muogram of any quantity, or raster of expected counts in telescope angles; it "
                "says itself where its detector stands.",
            ),
            *dem_parameters(),
            choice(
                "SIDE", "Side of the rock",
                "near: the face towards the detector, where rays enter the first rock. far: the "
                "face away from it, where rays leave the last rock.",
                list(SIDES), "near",
            ),
            explained(
                QgsProcessingParameterRasterDestination("OUTPUT", "Draped muogram"),
                "GeoTIFF on the grid and in the coordinate reference system of the DEM; cells that "
                "the detector does not see have no data.",
            ),
        ]  # fmt: skip

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        path = raster_layer(self, parameters, "MUOGRAM", context).source()
        muogram = read_view(path)
        dem, _ = read_dem(self, parameters, context)
        check_detector(muogram, dem)
        return _Inputs(path, muogram, dem, read_choice(self, parameters, "SIDE", context))

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        muogram, dem = inputs.muogram, inputs.dem
        path = destination(self, parameters, "OUTPUT", context)
        if path is None:
            raise MuyscError("OUTPUT is missing; give a file name that ends in .tif.")
        temporary = stage_raster(
            staging, path, (inputs.path, dem.path), context, muogram.values, muogram.kind
        )
        blocks = drape(muogram, dem, inputs.side, progress_of(feedback, 0.0, 1.0))
        cells = write_on_grid(
            temporary,
            dem,
            muogram.kind,
            {**muogram.metadata, "SIDE": inputs.side},
            blocks,
            f"draped {muogram.kind.name}",
        )
        if cells:
            feedback.pushInfo(f"{cells} cells of the DEM carry a value.")
        else:
            feedback.pushWarning(
                f"The detector sees no cell of {dem.name} on the {inputs.side} side within the "
                "muogram: the raster is empty; check that DEM and muogram are of one place."
            )
        return {"OUTPUT": path, "CELLS": cells}
