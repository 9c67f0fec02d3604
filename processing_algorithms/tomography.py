"""Muon tomography: from muograms of several stations to densities in three dimensions."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
)

from ..muysc_qgis.staging import Staging
from ..muysc_qgis.topography.dem import Dem
from ..muysc_qgis.workflows.count_data import read_count_stations, refuse_other_method
from ..muysc_qgis.workflows.count_tomography import CountChoices, CountTomography, count_tomography
from ..muysc_qgis.workflows.muogram_data import bare_stations, read_survey
from ..muysc_qgis.workflows.named_view import NamedView
from ..muysc_qgis.workflows.tomography import TomographyChoices, projection_of, tomography
from ..muysc_qgis.workflows.tomography_result import Tomography
from ..muysc_qgis.workflows.volume_plan import VolumePlan
from .base import MuyscAlgorithm, progress_of
from .outputs.counts import count_outputs, stage_counts, told_of
from .outputs.documents import document_outputs, stage_drawn
from .outputs.rasters import wanted
from .outputs.section import Line, read_line, section_line, section_output, section_pictures
from .outputs.volume import stage_volumes, volume_outputs, write_voxels
from .parameters.counts import count_parameters, read_counting
from .parameters.muograms import muogram_layers, read_view_layers
from .parameters.reconstruction import read_reconstruction, reconstruction_parameters
from .parameters.terrain import dem_parameters, read_dem
from .parameters.volume import read_crs, read_plan, volume_parameters

if TYPE_CHECKING:
    from pyproj import CRS


@dataclass(frozen=True)
class _Inputs:
    paths: tuple[str, ...]
    muograms: list[NamedView]
    errors: list[NamedView]
    dem: Dem
    crs: CRS
    plan: VolumePlan
    choices: TomographyChoices
    line: Line | None
    acceptances: list[NamedView]
    #: How counts are fitted, where the muograms hold counts.
    counting: CountChoices | None


class TomographyAlgorithm(MuyscAlgorithm):
    """The third module: what several muograms say together."""

    NAME = "tomography"
    TITLE = "Muon tomography"
    GROUP = "Tomography"
    GROUP_ID = "tomography"
    TAGS = ("muogram", "density", "3D", "voxel", "inversion", "reconstruction", "volume")
    NUMBERS = (
        ("RESIDUAL", "Residual over data"),
        ("CHI_SQUARED", "Mean square of residuals over their errors"),
        ("ITERATIONS_DONE", "Iterations done"),
        ("MEAN_DENSITY", "Mean density of the voxels (g/cm³)"),
        ("REFERENCE", "Reference density used (g/cm³)"),
        ("RAYS", "Rays used"),
        ("VOXELS_SEEN", "Voxels with a density"),
        ("VOXELS_UNSEEN", "Voxels with rock that no ray passes"),
    )

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        return [
            muogram_layers(
                "MUOGRAMS", "Muograms",
                "Muograms of one quantity from several stations: counts, density, opacity, flux, "
                "transmission or thickness, or rasters in telescope angles. They say themselves "
                "what they hold and where their detectors stand; counts also say the days, and "
                "telescope or acceptance.",
            ),
            muogram_layers(
                "ERRORS", "Errors of the muograms",
                "Rasters of the standard errors, such as density error, one for each muogram, in "
                "any order: they are matched by detector and directions.",
                optional=True,
            ),
            muogram_layers(
                "ACCEPTANCES", "Acceptances of the counts",
                "Rasters of acceptances in cm² sr on the pixels of counts, in any order; without "
                "one, that of the telescope or of the metadata (ACCEPTANCE) counts.",
                optional=True,
            ),
            *dem_parameters(),
            *volume_parameters(),
            *reconstruction_parameters(),
            *count_parameters(),
            section_line(),
            *volume_outputs(),
            *count_outputs(),
            section_output(),
            *document_outputs(
                "Picture of slices and sections through the target, views from the top, the front "
                "and the side, and the rays per voxel, with a map of the stations.",
                "One HTML file with the panel, the misfit by iteration and station, parameters, "
                "numbers, every warning and how to cite.",
            ),
        ]  # fmt: skip

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        read = (self, parameters)
        choices = read_reconstruction(*read, context, wanted(parameters, "DENSITY_ERROR"))
        dem, _ = read_dem(*read, context)
        muograms = read_view_layers(*read, "MUOGRAMS", context)
        errors = read_view_layers(*read, "ERRORS", context)
        acceptances = read_view_layers(*read, "ACCEPTANCES", context)
        named = [NamedView(Path(path).stem, view) for view, path in muograms]
        crs = read_crs(*read, context) or projection_of(bare_stations(named), dem)
        counting = None
        if any(one.view.quantity == "counts" for one in named):
            refuse_other_method(choices.method, "METHOD" in parameters, choices.mask)
            counting = read_counting(*read, context, choices)
        return _Inputs(
            (dem.path, *(path for _, path in (*muograms, *errors, *acceptances))),
            named,
            [NamedView(Path(path).stem, view) for view, path in errors],
            dem,
            crs,
            read_plan(*read, context, crs),
            choices,
            read_line(*read, context, crs.to_wkt()),
            [NamedView(Path(path).stem, view) for view, path in acceptances],
            counting,
        )

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        result, counted, warnings = _found(inputs, feedback)
        _say(feedback, result, warnings)
        files = (parameters, context)
        staged = (staging, inputs.paths)
        results = stage_volumes(self, result, *files, *staged)
        if counted is not None:
            results |= stage_counts(self, counted, inputs.muograms, *files, *staged)
        results |= stage_drawn(
            self,
            lambda: _drawing().panel(result, inputs.dem),
            lambda provenance: _drawing().report(
                result,
                inputs.dem,
                provenance,
                warnings=warnings,
                discrepancy=inputs.choices.options.discrepancy,
                line_m=inputs.line,
            ),
            results, *files, feedback, *staged,
            section_pictures(result, inputs.dem, inputs.line),
        )  # fmt: skip
        results |= write_voxels(self, result, *files, staging)
        return results | _numbers(result)


def _found(
    inputs: _Inputs, feedback: QgsProcessingFeedback
) -> tuple[Tomography, CountTomography | None, tuple[str, ...]]:
    """Return densities, what the fit of counts tells beside them, and warnings on the data."""
    if inputs.counting is not None:
        stations = read_count_stations(inputs.muograms, inputs.acceptances)
        counted = count_tomography(
            stations, inputs.dem, inputs.plan, inputs.counting, inputs.crs,
            progress_of(feedback, 0.0, 0.9),
        )  # fmt: skip
        for text in told_of(counted):
            feedback.pushInfo(text)
        return counted.tomography, counted, ()
    data = read_survey(
        inputs.muograms,
        inputs.errors,
        inputs.dem,
        inputs.choices.reference_density,
        progress_of(feedback, 0.0, 0.2),
    )
    result = tomography(
        data.stations,
        inputs.dem,
        inputs.plan,
        inputs.choices,
        inputs.crs,
        data.rock,
        progress_of(feedback, 0.2, 0.9),
    )
    return result, None, data.warnings


def _say(feedback: QgsProcessingFeedback, result: Tomography, warnings: tuple[str, ...]) -> None:
    """Log what was used and found, the rays lost by cause, and every warning."""
    grid = result.grid
    feedback.pushInfo(
        f"{' × '.join(map(str, grid.shape))} voxels of {grid.size_m[0]:g} m, x "
        f"{grid.origin_m[0]:.10g} to {grid.end_m[0]:.10g}, y {grid.origin_m[1]:.10g} to "
        f"{grid.end_m[1]:.10g}, {grid.origin_m[2]:g} to {grid.end_m[2]:g} m high."
    )
    feedback.pushInfo(
        f"{result.rays} rays of {len(result.stations)} muograms; {result.seen_voxels} of "
        f"{result.rock_voxels} voxels with rock have a density, the others are passed by no ray."
    )
    for cause, count in result.lost.items():
        feedback.pushInfo(f"  not used because {cause}: {count} rays")
    found = result.reconstruction
    feedback.pushInfo(
        f"{result.method}: {found.iterations_done} iterations (end: {found.stopped_by}); "
        f"{100 * result.relative_residual:.3g} % of the opacity in the volume is left unexplained."
    )
    for warning in (*warnings, *result.warnings):
        feedback.pushWarning(warning)


def _numbers(result: Tomography) -> dict[str, float]:
    return {
        "RESIDUAL": result.relative_residual,
        "CHI_SQUARED": result.chi_squared,
        "ITERATIONS_DONE": result.reconstruction.iterations_done,
        "MEAN_DENSITY": result.mean_density,
        "REFERENCE": result.reference_density,
        "RAYS": result.rays,
        "VOXELS_SEEN": result.seen_voxels,
        "VOXELS_UNSEEN": result.unseen_voxels,
    }


def _drawing() -> ModuleType:
    # Loaded only where something is drawn: matplotlib may be missing.
    from ..muysc_qgis.plots.tomography import documents

    return documents
