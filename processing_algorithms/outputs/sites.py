"""A folder of muograms from many sites, and the layer that indexes it."""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, get_type_hints

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFolderDestination,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.muogram import read_muogram
from ...muysc_qgis.staging import Staging
from ...muysc_qgis.workflows.sites import StationMuograms, StationNumbers
from ..compat import VECTOR_POINT
from ..parameters.values import explained
from .points import Point, write_points
from .rasters import stage_raster

FOLDER, INDEX = "FOLDER", "INDEX"

#: Fields of the index that hold numbers, with the Python type of each.
_NUMBERS: dict[str, type] = get_type_hints(StationNumbers)


def folder_output() -> QgsProcessingParameterDefinition:
    """Declare the folder."""
    return explained(
        QgsProcessingParameterFolderDestination(FOLDER, "Folder of the muograms"),
        "Holds a GeoTIFF for each site and quantity, such as site_01_thickness.tif. Muograms of "
        "an earlier run under the same names are replaced; other files are not.",
    )


def index_output() -> QgsProcessingParameterDefinition:
    """Declare the index."""
    return explained(
        QgsProcessingParameterFeatureSink(
            INDEX, "Index of the muograms", VECTOR_POINT, None, True, True
        ),
        "Layer of the sites with the name of each file in the folder, detector elevation, distance "
        "and direction of the target, largest thickness, median exposure and unknown pixels.",
    )


def muogram_file(stem: str, quantity: str) -> str:
    """Return the name of a site's file."""
    return f"{stem}_{quantity}.tif"


def check_folder(folder: Path, stems: Iterable[str], quantities: Sequence[str]) -> list[str]:
    """Return what is to be said of files that stand in the folder already.

    Raises
    ------
    MuyscError
        If a file to write exists and is no muogram of the same quantity.
    """
    if not folder.is_dir():
        return []
    replaced = {}
    for stem in stems:
        for quantity in quantities:
            path = folder / muogram_file(stem, quantity)
            if path.exists():
                _refuse_foreign(path, quantity)
                replaced[path] = quantity
    others = sorted(path.name for path in folder.glob("*.tif") if path not in replaced)
    said = []
    if replaced:
        said.append(f"{len(replaced)} muograms of an earlier run in {folder} are replaced.")
    if others:
        said.append(
            f"{folder} holds {len(others)} other rasters, such as {others[0]}; they are left as "
            "they are and do not belong to this run."
        )
    return said


def _refuse_foreign(path: Path, quantity: str) -> None:
    try:
        own = read_muogram(path).quantity == quantity
    except MuyscError:
        own = False
    if not own:
        raise MuyscError(
            f"{path} exists and is no muogram of {quantity}, so it is not replaced; choose another "
            "folder or move the file."
        )


def stage_station(
    station: StationMuograms,
    folder: Path,
    context: QgsProcessingContext,
    staging: Staging,
    inputs: tuple[str, ...],
) -> None:
    """Stage the muograms of one site with their styles."""
    for quantity, file in station.files.items():
        muogram = read_muogram(file)
        path = str(folder / muogram_file(station.site.stem, quantity))
        staged = stage_raster(staging, path, inputs, context, muogram.values, muogram.kind)
        shutil.move(file, staged)


def write_index(
    algorithm: QgsProcessingAlgorithm,
    stations: Iterable[StationMuograms],
    quantities: Sequence[str],
    crs: QgsCoordinateReferenceSystem,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
) -> dict[str, str]:
    """Write the index; called last, see `write_layer`.

    Raises
    ------
    MuyscError
        If the layer cannot be written.
    """
    kinds = {**dict.fromkeys(("site", *quantities), str), **_NUMBERS}
    points = [
        Point(
            station.site.position,
            (
                station.site.name,
                *(muogram_file(station.site.stem, quantity) for quantity in quantities),
                *(getattr(station.numbers, name) for name in _NUMBERS),
            ),
        )
        for station in stations
    ]
    write = (crs, parameters, context, staging)
    return write_points(algorithm, INDEX, kinds, points, *write, sites="site")
