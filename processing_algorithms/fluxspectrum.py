"""Muon spectra, energy losses and what they leave behind rock, compared."""

from __future__ import annotations

from dataclasses import dataclass
from types import ModuleType
from typing import Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterString,
)

from ..muysc_qgis.errors import MuyscError
from ..muysc_qgis.radiography.comparison import (
    MAXIMUM_THICKNESS_M,
    check_thickness,
    compare,
    zenith_angles,
)
from ..muysc_qgis.radiography.comparison_tables import COLUMNS, rows
from ..muysc_qgis.radiography.materials import MATERIALS
from ..muysc_qgis.radiography.settings import Physics, check_altitude
from ..muysc_qgis.radiography.spectra import MODELS
from ..muysc_qgis.staging import Staging
from ..muysc_qgis.tables import write_table
from .base import MuyscAlgorithm
from .outputs.documents import destination, document_outputs, stage_drawn
from .parameters.physics import physics_parameters, read_physics
from .parameters.values import choices, explained, number, read_choices, read_number

#: Table of the library by output, with label and help text.
_TABLES = {
    "TABLE": (
        "spectra",
        "Table of spectra",
        "CSV: differential flux of every model, zenith angle and kinetic energy, and whether the "
        "model was made for it.",
    ),
    "FLUX_TABLE": (
        "fluxes",
        "Table of fluxes behind rock",
        "CSV: flux, open sky and transmission of every model, zenith angle and opacity.",
    ),
    "ENERGY_LOSS_TABLE": (
        "energy_loss",
        "Table of energy losses",
        "CSV: stopping power and range of every material, and the polynomial beside it.",
    ),
    "MINIMUM_ENERGY_TABLE": (
        "minimum_energy",
        "Table of minimum energies",
        "CSV: kinetic energy that the material demands at every thickness, by each range law.",
    ),
}
_MATERIALS = ["standard_rock", "water", "granite", "basalt", "limestone"]


@dataclass(frozen=True)
class _Inputs:
    models: list[str]
    zenith_deg: tuple[float, ...]
    thickness_m: float
    physics: Physics
    altitude_m: float
    materials: list[str]


class FluxSpectrum(MuyscAlgorithm):
    """The models side by side: what each says, and where it holds."""

    NAME = "fluxspectrum"
    TITLE = "Compare muon spectra"
    GROUP = "Radiography"
    GROUP_ID = "radiography"
    TAGS = ("spectrum", "flux", "energy loss", "stopping power", "transmission", "opacity")
    NUMBERS = (
        ("OPACITY", "Opacity of the thickness (g/cm²)"),
        ("MINIMUM_ENERGY", "Minimum kinetic energy (GeV)"),
        ("LARGEST_RATIO", "Largest over smallest flux of the models that hold"),
    )

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        # One of the shared parameters becomes a list here.
        shared = [one for one in physics_parameters() if one.name() != "FLUX_MODEL"]
        return [
            choices(
                "FLUX_MODELS", "Muon flux models", "Parametrised spectra to compare.",
                list(MODELS), list(MODELS),
            ),
            explained(
                QgsProcessingParameterString(
                    "ZENITH_ANGLES", "Zenith angles (°)", "0, 30, 60, 75, 85"
                ),
                "List zenith angles in degrees, from 0 (overhead) to below 90, separated by "
                "commas; at most 12.",
            ),
            number(
                "THICKNESS", "Thickness of rock (m)",
                "Give the thickness of rock in m that the figures mark, above 0 and up to "
                f"{MAXIMUM_THICKNESS_M:g}.",
                500.0, 0, MAXIMUM_THICKNESS_M,
            ),
            *shared,
            number(
                "ALTITUDE", "Altitude of the detector (m)",
                "Give the height above sea level in m, −1000 to 10000. For the formulas it counts "
                "where the correction for altitude is on.",
                0.0, -1000, 10_000,
            ),
            choices(
                "MATERIALS", "Materials whose energy loss is compared",
                "The material of the rock is shown in any case.",
                list(MATERIALS), _MATERIALS, advanced=True,
            ),
            *(
                explained(
                    QgsProcessingParameterFileDestination(
                        name, label, "CSV files (*.csv)", None, True, name == "TABLE"
                    ),
                    text,
                )
                for name, (_, label, text) in _TABLES.items()
            ),
            *document_outputs(
                "Picture of spectra, energy losses, minimum energies, transmission and flux.",
                "One HTML file with figures, parameters, numbers, every warning and how to cite.",
            ),
        ]  # fmt: skip

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        models = read_choices(self, parameters, "FLUX_MODELS", context)
        if not models:
            raise MuyscError(f"FLUX_MODELS is empty; choose at least one of {', '.join(MODELS)}.")
        angles = parameters.get("ZENITH_ANGLES")
        if angles is None:
            angles = self.parameterDefinition("ZENITH_ANGLES").defaultValue()
        thickness = read_number(self, parameters, "THICKNESS", context)
        check_thickness(thickness)
        altitude = read_number(self, parameters, "ALTITUDE", context)
        check_altitude(altitude)
        return _Inputs(
            models,
            zenith_angles(str(angles)),
            thickness,
            read_physics(self, parameters, context, flux_model=models[0]),
            altitude,
            read_choices(self, parameters, "MATERIALS", context),
        )

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        comparison = compare(
            inputs.models,
            inputs.zenith_deg,
            inputs.thickness_m,
            inputs.physics,
            inputs.altitude_m,
            inputs.materials,
        )
        for warning in comparison.warnings:
            feedback.pushWarning(warning)
        results: dict[str, Any] = {}
        for name, (table, _, _) in _TABLES.items():
            path = destination(self, parameters, name, context, ".csv")
            if path:
                write_table(staging.add(path), COLUMNS[table], rows(comparison, table))
                results[name] = path
        results |= stage_drawn(
            self,
            lambda: _drawing().panel(comparison),
            lambda provenance: _drawing().report(comparison, provenance),
            results, parameters, context, feedback, staging, (),
        )  # fmt: skip
        return results | {
            "OPACITY": comparison.opacity_g_cm2,
            "MINIMUM_ENERGY": comparison.minimum_energy_gev,
            "LARGEST_RATIO": comparison.largest_ratio,
        }


def _drawing() -> ModuleType:
    # Loaded only where something is drawn: matplotlib may be missing.
    from ..muysc_qgis.plots.spectra import documents

    return documents
