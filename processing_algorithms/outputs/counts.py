"""What a fit of counts tells beside densities: factors, boresights and residual muograms."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFolderDestination,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.muogram import Muogram, write_muogram
from ...muysc_qgis.staging import Staging
from ...muysc_qgis.trajectories import TrajectoryMap, write_trajectories
from ...muysc_qgis.workflows.count_tomography import CountTomography
from ...muysc_qgis.workflows.named_view import NamedView
from ..parameters.values import explained, given
from .rasters import stage_raster
from .tables import stage_table, table_destination, table_layer

STATION_FACTORS, RESIDUAL_MUOGRAMS = "STATION_FACTORS", "RESIDUAL_MUOGRAMS"

#: Quantity of the residual muograms.
RESIDUAL = "residual"

#: What the numbers are called in the table, and their units.
_CALLED = {
    "mean": ("mean density", "g/cm³"),
    "flux": ("factor of the flux", "1"),
    "flux_fall": ("fall of the flux with opacity", "1"),
    "factor": ("factor of the counts", "1"),
    "azimuth": ("turn of the boresight", "°"),
    "elevation": ("rise of the boresight", "°"),
}

_COLUMNS = (
    "station", "quantity", "unit", "before", "error before", "found", "error",
    "away from before over its error",
)  # fmt: skip

#: Standard errors at the ends of the colour scale.
_LIMITS = (-4.0, 4.0)


def count_outputs() -> list[QgsProcessingParameterDefinition]:
    """Declare the table and the folder."""
    return [
        table_layer(
            STATION_FACTORS, "Factors and boresights",
            "CSV, of the method counts: mean density, factor of the flux, and factor and boresight "
            "of each station, with what was known before and the errors of both.",
        ),
        explained(
            QgsProcessingParameterFolderDestination(
                RESIDUAL_MUOGRAMS, "Folder of residual muograms", None, True, False
            ),
            "Holds a GeoTIFF for each raster of counts, of the method counts: counts less "
            "what the densities expect, over the standard error; noise of size 1 where all is "
            "explained.",
        ),
    ]  # fmt: skip


def told_of(found: CountTomography) -> list[str]:
    """Return a sentence for each number that was estimated beside the densities."""
    said = []
    for band in found.fit.bands:
        name, unit = _CALLED[band.name]
        of = "" if band.station < 0 else f"{found.station_name(band)}: "
        said.append(
            f"  {of}{name} {band.after:.4g} ± {band.after_error:.2g}{'' if unit == '1' else ' '}"
            f"{'' if unit == '1' else unit} (before: {band.before:.4g} ± {band.before_error:.2g})"
        )
    said.append(
        f"  the counts settle about {found.fit.parameters:.0f} numbers; {found.laid.model.size} "
        f"trajectories, {int((found.laid.model.counts == 0).sum())} of them without a muon."
    )
    return said


def stage_counts(
    algorithm: QgsProcessingAlgorithm,
    found: CountTomography,
    views: list[NamedView],
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
    inputs: tuple[str, ...],
) -> dict[str, str]:
    """Stage what is wanted; return files by output name.

    Raises
    ------
    MuyscError
        If two rasters of counts have one name.
    """
    results = {}
    table = table_destination(algorithm, parameters, STATION_FACTORS, context)
    if table is not None:
        rows = []
        for band in found.fit.bands:
            name, unit = _CALLED[band.name]
            # What was known exactly is where it was.
            off = band.after - band.before
            away = off / band.before_error if band.before_error > 0 else 0.0
            rows.append((
                found.station_name(band), name, unit, band.before, band.before_error, band.after,
                band.after_error, away,
            ))  # fmt: skip
        stage_table(staging, table, _COLUMNS, rows)
        results[STATION_FACTORS] = table
    if given(parameters, RESIDUAL_MUOGRAMS):
        folder = str(algorithm.parameterAsString(parameters, RESIDUAL_MUOGRAMS, context))
        names = [one.name for one in views]
        if len(set(names)) < len(names):
            raise MuyscError(
                "Two rasters of counts have one name, so that their residual muograms would too; "
                "rename one, or leave RESIDUAL_MUOGRAMS out."
            )
        Path(folder).mkdir(parents=True, exist_ok=True)
        for one, values in zip(views, found.residuals()):
            _stage_residual(one, values, Path(folder), context, staging, inputs)
        results[RESIDUAL_MUOGRAMS] = folder
    return results


def _stage_residual(
    one: NamedView,
    values: np.ndarray,
    folder: Path,
    context: QgsProcessingContext,
    staging: Staging,
    inputs: tuple[str, ...],
) -> None:
    view = one.view
    path = str(folder / f"{one.name}_{RESIDUAL}.tif")
    if isinstance(view, Muogram):
        muogram = view.with_values(RESIDUAL, values)
        temporary = stage_raster(
            staging, path, inputs, context, values, muogram.kind, limits=_LIMITS
        )
        write_muogram(muogram, temporary)
    elif isinstance(view, TrajectoryMap):
        trajectories = replace(view, quantity=RESIDUAL, values=values)
        temporary = stage_raster(
            staging, path, inputs, context, values, trajectories.kind, limits=_LIMITS
        )
        write_trajectories(trajectories, temporary)
