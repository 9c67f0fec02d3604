"""Terrain for those who have none: tiles of SRTM or Copernicus, put together."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from qgis.core import (
    QgsApplication,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterAuthConfig,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFile,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterString,
    QgsSettings,
)

from ..muysc_qgis.errors import MuyscError
from ..muysc_qgis.quantities import Quantity
from ..muysc_qgis.staging import Staging
from ..muysc_qgis.topography.srtm import Extent, Source, source_of, widen
from ..muysc_qgis.topography.srtm_cache import TileCache
from ..muysc_qgis.topography.srtm_download import download, notes_on
from ..muysc_qgis.topography.srtm_mosaic import Mosaic, fill_voids, write_dem
from ..muysc_qgis.topography.srtm_tiles import VOID
from .base import MuyscAlgorithm, progress_of
from .network import fetcher
from .outputs.rasters import destination, stage_raster
from .parameters.extent import read_extent
from .parameters.values import explained, given, number, read_within, switch

#: Where the settings of QGIS keep the source that a user prefers.
SOURCE_SETTING = "muysc/srtm_source"

#: For the colours of the layer.
_ELEVATION = Quantity("elevation", "Elevation", "m", "cividis", False)
#: Heights along each side that the colours are chosen from.
_SAMPLES = 500


@dataclass(frozen=True)
class _Inputs:
    extent: Extent
    source: Source
    most_tiles: int
    cache: TileCache
    authentication: str
    timeout_s: float | None
    retries: int
    #: None leaves voids as they are.
    fill_cells: int | None
    notes: tuple[str, ...]


class DownloadSrtm(MuyscAlgorithm):
    """The elevation model of an extent, from public servers or one's own."""

    NAME = "downloadsrtm"
    TITLE = "Download SRTM topography"
    GROUP = "Terrain"
    GROUP_ID = "terrain"
    TAGS = ("srtm", "dem", "elevation", "topography", "terrain", "copernicus", "download")
    NUMBERS = (
        ("TILES", "Tiles"),
        ("CACHED_TILES", "Tiles from the cache"),
        ("SEA_TILES", "Tiles taken as sea level"),
        ("VOID_PIXELS", "Cells without a height"),
        ("FILLED_PIXELS", "Cells that were filled"),
    )

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        return [
            explained(
                QgsProcessingParameterExtent("EXTENT", "Extent"),
                "Part of the map, in any coordinate reference system: detector, target and all "
                "rock behind it. As text: xmin,xmax,ymin,ymax [EPSG:code]; without a code and a "
                "project longitudes and latitudes.",
            ),
            number(
                "MARGIN", "Margin (m)",
                "Give the width of the strip added around the extent in m, 0 to 100000.",
                0.0, 0, 100_000,
            ),
            explained(
                QgsProcessingParameterString(
                    "SOURCE", "Source of the tiles", QgsSettings().value(SOURCE_SETTING, "srtm")
                ),
                "srtm: public Terrain Tiles, one arc second. copernicus: Copernicus GLO-30, one "
                "arc second, surface with trees and buildings. Or the address of tiles on "
                "https:// or file://, such as https://server/{latitude}/{tile}.hgt.gz, where "
                "{tile} stands for N40E014, {latitude} for N40 and {longitude} for E014; plain, "
                f"gzipped and zipped .hgt and GeoTIFF. The setting {SOURCE_SETTING} changes the "
                "default.",
            ),
            switch(
                "FILL_VOIDS", "Fill cells without a height",
                "Whether cells without a height take that of their neighbours, weighted by the "
                "inverse of the distance.",
                False,
            ),
            number(
                "FILL_DISTANCE", "How far to look for heights (cells)",
                "Give the distance at which voids are still filled in cells, a whole number from "
                "1 to 1000; one cell is about 30 m.",
                100, 1, 1000, advanced=True, whole=True,
            ),
            number(
                "MAX_TILES", "Largest number of tiles",
                "Give the number of tiles of one degree that may be downloaded, a whole number "
                "from 1 to 200. One has about 10 MB from srtm and 40 MB from copernicus.",
                16, 1, 200, advanced=True, whole=True,
            ),
            explained(
                QgsProcessingParameterAuthConfig("AUTHCFG", "Authentication", None, True),
                "Authentication configuration of QGIS, for servers that ask for a login.",
                advanced=True,
            ),
            number(
                "TIMEOUT", "Timeout (s, empty: that of QGIS)",
                "Give the seconds without a byte after which an attempt ends, 0.1 to 600.",
                None, 0.1, 600, advanced=True,
            ),
            number(
                "RETRIES", "Further attempts",
                "Give the number of further attempts after a timeout or a fault of the server, a "
                "whole number from 0 to 10; the pauses between them grow.",
                3, 0, 10, advanced=True, whole=True,
            ),
            explained(
                QgsProcessingParameterFile(
                    "CACHE", "Folder of kept tiles (empty: in the profile)",
                    QgsProcessingParameterFile.Behavior.Folder, optional=True,
                ),
                "Folder where tiles are kept and looked for; several runs may share it. Empty: "
                "cache/muysc in the profile of QGIS.",
                advanced=True,
            ),
            explained(
                QgsProcessingParameterRasterDestination("DEM", "Elevation model"),
                "GeoTIFF of heights in m in longitude and latitude (EPSG:4326), cell for cell as "
                "in the tiles; cells without a height have no data.",
            ),
        ]  # fmt: skip

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        read = (self, parameters)
        extent, notes = read_extent(*read, "EXTENT", context)
        margin_m, most_tiles, timeout_s, retries, fill_cells = (
            read_within(*read, name, context)
            for name in ("MARGIN", "MAX_TILES", "TIMEOUT", "RETRIES", "FILL_DISTANCE")
        )
        source = source_of(self.parameterAsString(parameters, "SOURCE", context))
        return _Inputs(
            widen(extent, margin_m),
            source,
            most_tiles,
            TileCache(self._cache_folder(parameters, context), source),
            self._authentication(parameters, context),
            timeout_s,
            retries,
            fill_cells if self.parameterAsBool(parameters, "FILL_VOIDS", context) else None,
            notes,
        )

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        for note in inputs.notes:
            feedback.pushInfo(note)
        path = destination(self, parameters, "DEM", context)
        if path is None:
            raise MuyscError("DEM is missing; give a file name that ends in .tif.")
        fetch = fetcher(feedback, inputs.authentication, inputs.timeout_s, inputs.retries)
        mosaic = download(
            inputs.extent, inputs.source, inputs.most_tiles, inputs.cache, fetch,
            progress_of(feedback, 0.0, 0.8),
        )  # fmt: skip
        if inputs.fill_cells is not None:
            mosaic = fill_voids(mosaic, inputs.fill_cells, progress_of(feedback, 0.8, 0.9))
        temporary = stage_raster(staging, path, (), context, _samples(mosaic), _ELEVATION)
        write_dem(temporary, mosaic, inputs.source, progress_of(feedback, 0.9, 1.0))
        notes, warnings = notes_on(mosaic, inputs.source)
        for note in notes:
            feedback.pushInfo(note)
        for warning in warnings:
            feedback.pushWarning(warning)
        return {
            "DEM": path,
            "TILES": mosaic.tiles,
            "CACHED_TILES": mosaic.cached_tiles,
            "SEA_TILES": len(mosaic.sea_tiles),
            "VOID_PIXELS": mosaic.void_cells,
            "FILLED_PIXELS": mosaic.filled_cells,
        }

    def _cache_folder(self, parameters: dict[str, Any], context: QgsProcessingContext) -> Path:
        if given(parameters, "CACHE"):
            return Path(self.parameterAsFile(parameters, "CACHE", context))
        return Path(QgsApplication.qgisSettingsDirPath()) / "cache" / "muysc"

    def _authentication(self, parameters: dict[str, Any], context: QgsProcessingContext) -> str:
        name = self.parameterAsString(parameters, "AUTHCFG", context)
        if name and name not in QgsApplication.authManager().configIds():
            raise MuyscError(
                f"AUTHCFG is “{name}”, which is no authentication of this profile; choose one, or "
                "make it in the settings of QGIS under Authentication."
            )
        return name


def _samples(mosaic: Mosaic) -> np.ndarray:
    """Return heights from all over the mosaic, NaN where there is none."""
    step = max(1, max(mosaic.heights.shape) // _SAMPLES)
    heights = mosaic.heights[::step, ::step].astype(float)
    heights[heights == VOID] = np.nan
    return heights
