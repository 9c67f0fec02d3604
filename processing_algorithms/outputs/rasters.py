"""Muograms as raster outputs: declared, staged and styled."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterRasterDestination,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.muogram import Muogram, write_muogram
from ...muysc_qgis.quantities import QUANTITIES, Quantity
from ...muysc_qgis.staging import Staging
from ..parameters.values import explained
from .styles import StyleOnLoad, write_style

_HELP = {
    "thickness": "Length of each ray in rock, 0 in the sky.",
    "thickness_error": "Standard error of the thickness from those of terrain and pointing.",
    "opacity": "Thickness times density, the mass per area that a muon has to cross.",
    "minimum_energy": "Kinetic energy of the slowest muons that get through.",
    "flux": "Integral flux of the muons that get through.",
    "open_sky": "Integral flux that there would be without the rock.",
    "transmission": "Flux over open-sky flux, 1 in the sky.",
    "exposure": "Days until a pixel has counted the muons wanted.",
    "distance": "Length of each ray from the detector to the first rock.",
    "counts": "Muons expected along each trajectory in the time given.",
    "open_sky_counts": "Muons that there would be without the rock.",
    "rock_share": "Share of each trajectory's response that lies behind rock, 0 to 1.",
    "relative_error": "Standard error of the counts, in percent of them.",
    "density_resolution": "Smallest decrease of the mean density along the path that the counts "
    "show, in percent.",
    "contrast_days": "Days until the density contrast shows.",
    "acceptance": "Counts per time are the acceptance times the flux.",
    "solid_angle": "Solid angle of the directions that belong to each trajectory.",
    "detection_area": "Area of the front plane from which each trajectory reaches the back plane.",
    "path_length": "Length from plane to plane along each trajectory.",
    "angular_resolution": "Square root of the solid angle: the full width of the response.",
    "density": "Mean density along each ray; a lower limit where no muon was counted.",
    "density_error": "Standard error of the density, half of its interval.",
    "density_lower": "Lower end of the interval of one standard deviation.",
    "density_upper": "Upper end of the interval of one standard deviation.",
    "density_flags": "0 measured, 1 no rock, 2 lower limit, 3 as bright as the open sky, 4 not "
    "measured, 5 no density explains the flux, 6 too little rock to dim it, 7 skyline or rock of "
    "many lengths in it.",
    "density_regions": "Number of the region of merged pixels that shares one density, from 1.",
    "flux_minimum": "One standard error of the flux model below the flux; with a formula, the "
    "smallest flux over those that hold for the ray's energy and zenith.",
    "flux_maximum": "One standard error of the flux model above the flux; with a formula, the "
    "largest flux over those that hold for the ray's energy and zenith.",
    "density_minimum": "Density with a flux one standard error of the model lower; with a "
    "formula, the smallest over those that hold for the ray.",
    "density_maximum": "Density with a flux one standard error of the model higher; with a "
    "formula, the largest over those that hold for the ray.",
}


def raster_outputs(
    quantities: Mapping[str, str],
    always: Iterable[str],
    axes: str = "azimuth to the right and elevation upwards, degrees",
) -> list[QgsProcessingParameterDefinition]:
    """Declare raster destinations, given the quantity of each by output name."""
    return [
        explained(
            QgsProcessingParameterRasterDestination(
                output, QUANTITIES[name].label, None, output not in always, output in always
            ),
            f"{_HELP[name]} A GeoTIFF with {axes}.",
        )
        for output, name in quantities.items()
    ]


def destination(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> str | None:
    """Return the file of a raster destination, None where it is not wanted.

    Raises
    ------
    MuyscError
        If the file is no GeoTIFF by its name.
    """
    if parameters.get(name) in (None, ""):
        definition = algorithm.parameterDefinition(name)
        if not definition.createByDefault():
            return None
    path = algorithm.parameterAsOutputLayer(parameters, name, context)
    if not path:
        return None
    if Path(path).suffix.lower() not in (".tif", ".tiff"):
        raise MuyscError(
            f"{name} goes to “{path}”, and only GeoTIFF holds everything that later steps need; "
            "give a file name that ends in .tif."
        )
    return path


def wanted(parameters: dict[str, Any], *names: str) -> bool:
    """Return whether any of some optional outputs is asked for."""
    return any(parameters.get(name) not in (None, "") for name in names)


def stage_raster(
    staging: Staging,
    path: str,
    inputs: tuple[str, ...],
    context: QgsProcessingContext,
    values: np.ndarray,
    quantity: Quantity,
    **look: Any,
) -> Path:
    """Stage a raster's style and return the temporary path of the raster itself.

    `look` goes on to `write_style`.
    """
    temporary = staging.add(path, inputs)
    style = str(Path(path).with_suffix(".qml"))
    write_style(staging.add(style), values, quantity, **look)
    if context.willLoadLayerOnCompletion(path):
        context.layerToLoadOnCompletionDetails(path).setPostProcessor(StyleOnLoad(style))
    return temporary


def stage_muograms(
    algorithm: QgsProcessingAlgorithm,
    quantities: Mapping[str, str],
    muograms: Mapping[str, Muogram],
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
    inputs: tuple[str, ...],
) -> dict[str, str]:
    """Stage the muograms that are wanted; return files by output name."""
    results = {}
    for output, name in quantities.items():
        path = destination(algorithm, parameters, output, context)
        if path is not None:
            muogram = muograms[name]
            write_muogram(
                muogram,
                stage_raster(staging, path, inputs, context, muogram.values, muogram.kind),
            )
            results[output] = path
    return results
