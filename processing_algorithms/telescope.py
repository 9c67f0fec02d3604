"""What a telescope collects from each direction."""

from __future__ import annotations

from dataclasses import dataclass
from types import ModuleType
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFileDestination,
)

from ..muysc_qgis.staging import Staging
from ..muysc_qgis.telescope.acceptance import trajectories
from ..muysc_qgis.telescope.geometry import TelescopeGeometry
from ..muysc_qgis.trajectories import maps_of
from .base import MuyscAlgorithm
from .outputs.documents import document_outputs, stage_drawn
from .outputs.rasters import raster_outputs
from .outputs.trajectories import AXES, stage_trajectories, table_output
from .parameters.telescope import geometry_parameters, read_geometry
from .parameters.values import explained

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Quantity by output.
_OUTPUTS = {
    name.upper(): name
    for name in (
        "acceptance", "solid_angle", "detection_area", "path_length", "angular_resolution",
    )
}  # fmt: skip

_COMPARISON = "COMPARISON"


@dataclass(frozen=True)
class _Inputs:
    name: str
    geometry: TelescopeGeometry
    formula: str
    notes: tuple[str, ...]


class Telescope(MuyscAlgorithm):
    """Acceptance, solid angle, area and length of every trajectory."""

    NAME = "telescope"
    TITLE = "Telescope parameters"
    GROUP = "Telescope"
    GROUP_ID = "telescope"
    TAGS = ("acceptance", "solid angle", "detector", "hodoscope", "geometric factor", "aperture")
    NUMBERS = (
        ("MAX_ACCEPTANCE", "Largest acceptance of a trajectory (cm² sr)"),
        ("MAX_SOLID_ANGLE", "Largest solid angle of a trajectory (sr)"),
        ("MAX_DETECTION_AREA", "Largest detection area (cm²)"),
        ("APERTURE", "Half aperture across (°)"),
        ("APERTURE_Y", "Half aperture up (°)"),
        ("ANGULAR_STEP", "Angle from one trajectory to the next (mrad)"),
        ("TRAJECTORIES", "Trajectories"),
        ("ETENDUE", "Étendue, all acceptances together (cm² sr)"),
    )

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        panel, report = document_outputs(
            "Picture of the telescope and its aperture, with acceptance, solid angle, detection "
            "area and path length as maps and sections.",
            "One HTML file with figures, parameters, numbers and how to cite.",
        )
        return [
            *geometry_parameters(),
            *raster_outputs(_OUTPUTS, ("ACCEPTANCE",), AXES),
            table_output(),
            panel,
            explained(
                QgsProcessingParameterFileDestination(
                    _COMPARISON, "Comparison", "PNG pictures (*.png)", None, True, False
                ),
                "Picture of this telescope beside all that were built.",
            ),
            report,
        ]

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        geometry, formula, notes = read_geometry(self, parameters, context)
        name = self.parameterAsEnumString(parameters, "PRESET", context)
        return _Inputs(name, geometry, formula, notes)

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        for note in inputs.notes:
            feedback.pushWarning(note)
        collected = trajectories(inputs.geometry, inputs.formula)
        maps = maps_of(collected, inputs.name)
        results = stage_trajectories(self, _OUTPUTS, maps, parameters, context, staging)
        feedback.setProgress(50)
        results |= stage_drawn(
            self, lambda: _drawing().panel(collected, inputs.name),
            lambda provenance: _drawing().report(collected, inputs.name, inputs.notes, provenance),
            results, parameters, context, feedback, staging, (),
            {_COMPARISON: lambda: _comparison(inputs)},
        )  # fmt: skip
        across, up = inputs.geometry.half_aperture_deg
        return results | {
            "MAX_ACCEPTANCE": collected.acceptance_cm2_sr.max(),
            "MAX_SOLID_ANGLE": collected.solid_angle_sr.max(),
            "MAX_DETECTION_AREA": collected.detection_area_cm2.max(),
            "APERTURE": across,
            "APERTURE_Y": up,
            "ANGULAR_STEP": 1e3 * inputs.geometry.step,
            "TRAJECTORIES": inputs.geometry.trajectories,
            "ETENDUE": collected.etendue_cm2_sr,
        }


def _comparison(inputs: _Inputs) -> Figure:
    from ..muysc_qgis.plots.telescope_comparison import comparison_panel

    return comparison_panel(inputs.geometry, inputs.name, inputs.formula)


def _drawing() -> ModuleType:
    # Loaded only where something is drawn: matplotlib may be missing.
    from ..muysc_qgis.plots import telescope_documents

    return telescope_documents
