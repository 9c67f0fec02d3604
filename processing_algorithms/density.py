"""Density of the rock from what a telescope measured."""

from __future__ import annotations

from dataclasses import dataclass
from types import ModuleType
from typing import Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterRasterLayer,
)

from ..muysc_qgis.errors import MuyscError
from ..muysc_qgis.measurement.density import Flag
from ..muysc_qgis.radiography.settings import Physics
from ..muysc_qgis.staging import Staging
from ..muysc_qgis.trajectories import TrajectoryMap
from ..muysc_qgis.views import View
from ..muysc_qgis.workflows.measured import Measurement
from ..muysc_qgis.workflows.measured_density import (
    UNKNOWN,
    DensityChoices,
    DensityResult,
    density_behind,
)
from ..muysc_qgis.workflows.view_rays import Ground
from .base import MuyscAlgorithm, progress_of
from .outputs.documents import document_outputs, stage_drawn
from .outputs.rasters import raster_outputs, stage_muograms, wanted
from .outputs.trajectories import stage_trajectories
from .parameters.ground import ground_parameters, read_ground
from .parameters.muograms import read_view_layer
from .parameters.physics import physics_parameters, read_physics
from .parameters.values import explained, given, number, read_number, read_optional

#: Quantity by output.
_OUTPUTS = {
    "OPACITY": "opacity",
    "DENSITY": "density",
    "DENSITY_ERROR": "density_error",
    "DENSITY_LOWER": "density_lower",
    "DENSITY_UPPER": "density_upper",
    "DENSITY_MINIMUM": "density_minimum",
    "DENSITY_MAXIMUM": "density_maximum",
    "FLAGS": "density_flags",
    "REGION_NUMBERS": "density_regions",
    "THICKNESS_SEEN": "thickness",
}
#: The muograms that a measurement can be, exactly one of which is given.
_MEASURED = ("COUNTS", "FLUX", "TRANSMISSION")


@dataclass(frozen=True)
class _Inputs:
    paths: tuple[str, ...]
    measurement: Measurement
    thickness: View | None
    physics: Physics
    choices: DensityChoices
    altitude_m: float | None
    ground: Ground | None
    notes: tuple[str, ...]


class Density(MuyscAlgorithm):
    """The inverse of radiography: from muons to density."""

    NAME = "density"
    TITLE = "Density from a measured muogram"
    GROUP = "Radiography"
    GROUP_ID = "radiography"
    TAGS = ("muogram", "density", "opacity", "inversion", "counts", "transmission", "measurement")
    NUMBERS = (
        ("MEAN_DENSITY", "Mean density (g/cm³)"),
        ("MEAN_DENSITY_ERROR", "Error of the mean density (g/cm³)"),
        ("MEAN_DENSITY_STATISTICAL_ERROR", "Part of it from counting (g/cm³)"),
        ("MEDIAN_DENSITY", "Median density (g/cm³)"),
        ("ROCK_PIXELS", "Pixels with rock"),
        ("DENSITY_PIXELS", "Pixels with a density"),
        ("LIMIT_PIXELS", "Pixels with a lower limit"),
        ("BRIGHT_PIXELS", "Pixels with rock as bright as the open sky"),
        ("UNKNOWN_PIXELS", "Pixels that cannot be known"),
        ("REGIONS", "Regions with a density of their own"),
        ("MIXED_PIXELS", "Pixels of which one ray says too little"),
        ("CHI_SQUARED", "Scatter of the densities about their mean (χ² per datum)"),
        ("SKY_RATIO", "Open sky seen over what the flux model promises"),
    )

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        return [
            _muogram("THICKNESS", "Thickness muogram", "Muogram of rock thickness in m, seen from "
                     "the same place on the same directions. One ray then stands for each pixel, "
                     "and those at the skyline have no density. Give this or, better, the DEM."),
            *ground_parameters(),
            _muogram("COUNTS", "Muon counts", "Muogram of muons counted in each pixel, whole "
                     "numbers. Give exactly one of counts, flux and transmission."),
            _muogram("FLUX", "Measured flux", "Muogram of measured flux in cm⁻² sr⁻¹ day⁻¹."),
            _muogram("TRANSMISSION", "Measured transmission", "Muogram of measured transmission, "
                     "flux over that of the open sky in the same direction, from 0 to 1."),
            _muogram("ERROR", "Errors of flux or transmission", "Muogram of the standard errors "
                     "of a measured flux or transmission, as the import writes it. Counts need "
                     "none."),
            number(
                "EXPOSURE", "Exposure (days, empty: as the counts say)",
                "Give the days of counting, above 0. Empty takes DAYS from the counts' metadata.",
                None, 0,
            ),
            number(
                "ACCEPTANCE", "Acceptance of a pixel (cm² sr, empty: as the counts say)",
                "Give the acceptance of one pixel in cm² sr, above 0, detection efficiency "
                "included. Empty takes ACCEPTANCE from the counts' metadata. Not used with an "
                "open-sky run.",
                None, 0,
            ),
            _muogram("ACCEPTANCES", "Acceptances of the pixels", "Raster of the acceptance of "
                     "every pixel in cm² sr, in place of one for all, such as Telescope "
                     "parameters writes it for counts in telescope angles."),
            _muogram("OPEN_SKY_COUNTS", "Counts in the open sky", "Muogram of muons that the same "
                     "telescope pixels counted in the open sky. Acceptance and efficiency then "
                     "drop out. Its elevations say where the telescope pointed."),
            number(
                "OPEN_SKY_EXPOSURE", "Exposure in the open sky (days, empty: as its counts say)",
                "Give the days of counting in the open sky, above 0. Empty takes DAYS from the "
                "metadata of the counts in the open sky.",
                None, 0,
            ),
            number(
                "MINIMUM_COUNTS", "Merge pixels up to (counts, 0: no merging)",
                "Give the counts that each region of merged pixels must reach, 0 or more. "
                "Neighbouring pixels then share one density. 20 and more make the errors "
                "symmetric. With a DEM counts are those expected through rock, less what the sky "
                "beside it hides. Only for counts.",
                20.0, 0,
            ),
            number(
                "MODEL_UNCERTAINTY", "Uncertainty of the flux model (%, empty: the model's own)",
                "Give the relative uncertainty of the flux in %, from 0 to below 100. It is the "
                "same for all pixels and does not average out. Empty takes the standard error of "
                "gsf-sibyll at the minimum energies, 5 % to 12 % as a rule, or 15 % for a formula.",
                None, 0, 100,
            ),
            number(
                "LIMIT_CONFIDENCE", "Confidence of lower limits (%)",
                "Give the one-sided confidence in % of the lower limit on density in pixels "
                "without a muon, above 50 and below 100.",
                95.0, 50, 100, advanced=True,
            ),
            number(
                "DETECTOR_ELEVATION", "Detector elevation (m, empty: the muogram's)",
                "Give the altitude of the detector in m, −1000 to 10000, for the altitude "
                "correction. Empty takes what the muograms say.",
                None, -1000, 10_000, advanced=True,
            ),
            *physics_parameters(density=False),
            *raster_outputs(_OUTPUTS, always=("DENSITY", "DENSITY_ERROR")),
            *document_outputs(
                "Picture of density and its error side by side, with contours, skyline and target."
            ),
        ]  # fmt: skip

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        names = [name for name in _MEASURED if given(parameters, name)]
        if len(names) != 1:
            raise MuyscError(
                f"{' and '.join(names) or 'None of COUNTS, FLUX and TRANSMISSION'} "
                f"{'are' if names else 'is'} given; choose exactly one measured muogram."
            )
        paths: list[str] = []

        def muogram(name: str) -> View | None:
            return taken(name) if given(parameters, name) else None

        def taken(name: str) -> View:
            read, path = read_view_layer(self, parameters, name, context)
            paths.append(path)
            return read

        values = taken(names[0])
        if values.quantity != names[0].lower():
            raise MuyscError(
                f"{names[0]} is a muogram of {values.quantity}; choose one of {names[0].lower()}."
            )
        ground, notes = read_ground(self, parameters, context)
        if ground is not None and given(parameters, "THICKNESS"):
            notes.append("With a DEM the thickness follows from it; THICKNESS is not used.")
        thickness = muogram("THICKNESS") if ground is None else None
        if ground is None and thickness is None:
            raise MuyscError(
                "Neither DEM nor THICKNESS is given; give the elevation model, or a muogram of the "
                "rock's thickness on the directions of the measurement."
            )
        if ground is not None:
            paths.append(ground.dem.path)
        read = (self, parameters)
        acceptance = read_optional(*read, "ACCEPTANCE", context)
        if acceptance is not None and given(parameters, "ACCEPTANCES"):
            raise MuyscError(
                "Both ACCEPTANCE and ACCEPTANCES are given; give one acceptance for all pixels, or "
                "a raster of them."
            )
        measurement = Measurement(
            values,
            muogram("ERROR"),
            muogram("OPEN_SKY_COUNTS"),
            read_optional(*read, "EXPOSURE", context),
            read_optional(*read, "OPEN_SKY_EXPOSURE", context),
            muogram("ACCEPTANCES") if acceptance is None else acceptance,
        )
        minimum = read_number(*read, "MINIMUM_COUNTS", context)
        if names[0] != "COUNTS" and not given(parameters, "MINIMUM_COUNTS"):
            minimum = 0.0
        uncertainty = read_optional(*read, "MODEL_UNCERTAINTY", context)
        choices = DensityChoices(
            None if uncertainty is None else uncertainty / 100,
            minimum,
            read_number(*read, "LIMIT_CONFIDENCE", context) / 100,
            wanted(parameters, "DENSITY_MINIMUM", "DENSITY_MAXIMUM"),
        )
        return _Inputs(
            tuple(paths),
            measurement,
            thickness,
            read_physics(self, parameters, context, density=False),
            choices,
            read_optional(*read, "DETECTOR_ELEVATION", context),
            ground,
            tuple(notes),
        )

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        result = density_behind(
            inputs.measurement,
            inputs.thickness,
            inputs.physics,
            inputs.choices,
            inputs.altitude_m,
            progress_of(feedback, 0.0, 0.8),
            inputs.ground,
        )
        for note in inputs.notes:
            feedback.pushInfo(note)
        _say(feedback, result)
        files = (parameters, context, staging, inputs.paths)
        stage = (
            stage_trajectories
            if isinstance(result.muograms["density"], TrajectoryMap)
            else stage_muograms
        )
        results = stage(self, _OUTPUTS, result.muograms, *files)
        results |= stage_drawn(
            self,
            lambda: _drawing().panel(result),
            lambda provenance: _drawing().report(result, _drawing().figures(result), provenance),
            results, parameters, context, feedback, staging, inputs.paths,
        )  # fmt: skip
        return results | _numbers(result)


def _muogram(name: str, label: str, text: str) -> QgsProcessingParameterDefinition:
    return explained(QgsProcessingParameterRasterLayer(name, label, None, True), text)


def _say(feedback: QgsProcessingFeedback, result: DensityResult) -> None:
    """Log the mean, the pixels without a density by cause, and every warning."""
    mean = result.mean
    feedback.pushInfo(
        f"{result.densities.count(Flag.MEASURED)} of {result.rock_pixels} pixels with rock have a "
        f"density; the mean is {mean.density:.4g} ± {mean.error:.2g} g/cm³."
    )
    for cause, count in result.unknown.items():
        if count:
            feedback.pushInfo(f"  {cause}: {count} pixels")
    for warning in result.warnings:
        feedback.pushWarning(warning)


def _numbers(result: DensityResult) -> dict[str, float]:
    found, mean = result.densities, result.mean
    return {
        "MEAN_DENSITY": mean.density,
        "MEAN_DENSITY_ERROR": mean.error,
        "MEAN_DENSITY_STATISTICAL_ERROR": mean.statistical_error,
        "MEDIAN_DENSITY": result.median_density,
        "ROCK_PIXELS": result.rock_pixels,
        "DENSITY_PIXELS": found.count(Flag.MEASURED),
        "LIMIT_PIXELS": found.count(Flag.LOWER_LIMIT),
        "BRIGHT_PIXELS": found.count(Flag.BRIGHT),
        "UNKNOWN_PIXELS": sum(found.count(flag) for flag in UNKNOWN),
        "REGIONS": found.regions,
        "MIXED_PIXELS": found.count(Flag.MIXED),
        "CHI_SQUARED": result.chi_squared,
        "SKY_RATIO": result.sky.ratio,
    }


def _drawing() -> ModuleType:
    # Loaded only where something is drawn: matplotlib may be missing.
    from ..muysc_qgis.plots import measured

    return measured
