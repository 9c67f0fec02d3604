"""Parameters of the muon flux and of its attenuation in rock."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
)

from ...muysc_qgis.radiography.energy_loss import ENERGY_LOSSES
from ...muysc_qgis.radiography.gaisser import GAISSER_PARAMETERS
from ...muysc_qgis.radiography.materials import MATERIALS
from ...muysc_qgis.radiography.settings import (
    MAXIMUM_DENSITY_G_CM3,
    MAXIMUM_THRESHOLD_GEV,
    Physics,
)
from ...muysc_qgis.radiography.spectra import DEFAULT_MODEL, MODELS
from ...muysc_qgis.telescope.acceptance import trajectories
from ...muysc_qgis.workflows.simulation import Telescope
from .telescope import geometry_parameters, read_geometry
from .values import choice, number, read_choice, read_number, read_optional, switch

#: Detection threshold in GeV where none is given.
_USUAL_THRESHOLD_GEV = Physics().threshold_gev


def physics_parameters(density: bool = True) -> list[QgsProcessingParameterDefinition]:
    """Declare everything that `Physics` holds, with or without the density of the rock."""
    densities = ", ".join(
        f"{material.name} {material.density_g_cm3:g}" for material in MATERIALS.values()
    )
    declared = [
        choice(
            "MATERIAL", "Material",
            "Rock or other matter, whose stopping power slows the muons.",
            list(MATERIALS), "standard_rock",
        ),
        number(
            "DENSITY", "Density (g/cm³, empty: the material's own)",
            f"Give the mean density in g/cm³, above 0 and up to {MAXIMUM_DENSITY_G_CM3:g}. Empty "
            f"stands for the material's own: {densities}.",
            None, 0, MAXIMUM_DENSITY_G_CM3,
        ),
        choice(
            "FLUX_MODEL", "Muon flux model",
            "Where the muons come from. gsf-sibyll (recommended): a table over altitude from 0 to "
            "6000 m, zenith angle and energy, fitted to measured spectra, with its own error. The "
            "others are formulas for sea level that lie within 15 % of measured spectra only at "
            "the energies and zenith angles that Physics, and a warning, name.",
            list(MODELS), DEFAULT_MODEL,
        ),
        choice(
            "GAISSER_PARAMETERS", "Parameters of the Gaisser formula",
            "Constants of the formulas gaisser and gaisser-tang; the other models do not use them.",
            list(GAISSER_PARAMETERS), "gaisser", advanced=True,
        ),
        choice(
            "ENERGY_LOSS", "Energy loss",
            "csda: range table of the material (recommended). lesparre: polynomial for standard "
            "rock, up to 1 TeV. paper: energy over stopping power in place of the range, as in "
            "the first MUYSC; without answer beyond about 613 m of rock.",
            list(ENERGY_LOSSES), "csda", advanced=True,
        ),
        switch(
            "STRAGGLING", "Correct for straggling",
            "Whether to correct the flux for the fluctuations of the energy loss, which let more "
            "muons through thick rock than the mean loss does: 3 % more vertical ones at 1 km "
            "water equivalent, 13 % more at 3 km.",
            True, advanced=True,
        ),
        switch(
            "ALTITUDE_CORRECTION", "Correct for altitude",
            "Whether the flux of a formula grows with the altitude of the detector. Made for "
            "momenta above 10 GeV/c, altitudes below 1 km and zenith angles below 60°; beyond "
            "that a warning is given. With gsf-sibyll the altitude always counts.",
            True, advanced=True,
        ),
        number(
            "DETECTION_THRESHOLD", "Detection threshold (GeV, empty: 0.90, which is 1 GeV/c)",
            "Give the kinetic energy in GeV that a muon needs at the telescope to be detected, "
            f"behind the rock and in the open sky alike, above 0 and below "
            f"{MAXIMUM_THRESHOLD_GEV:g}. Empty stands for {_USUAL_THRESHOLD_GEV:.2f} GeV, which "
            "is p > 1 GeV/c. With a formula for the flux, empty counts every muon behind rock and "
            "those above 1 GeV/c in the open sky, as earlier versions did.",
            None, 0, MAXIMUM_THRESHOLD_GEV, advanced=True,
        ),
    ]  # fmt: skip
    return [one for one in declared if density or one.name() != "DENSITY"]


def read_physics(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    density: bool = True,
    flux_model: str | None = None,
) -> Physics:
    """Return the physics chosen, with the material's own density where none is declared.

    `flux_model` stands in where no FLUX_MODEL is declared.

    Raises
    ------
    MuyscError
        If a value cannot be used.
    """
    read = (algorithm, parameters)
    return Physics(
        material=read_choice(*read, "MATERIAL", context),
        density_g_cm3=read_optional(*read, "DENSITY", context) if density else None,
        flux_model=flux_model or read_choice(*read, "FLUX_MODEL", context),
        gaisser_parameters=read_choice(*read, "GAISSER_PARAMETERS", context),
        energy_loss=read_choice(*read, "ENERGY_LOSS", context),
        straggling=algorithm.parameterAsBool(parameters, "STRAGGLING", context),
        altitude_correction=algorithm.parameterAsBool(parameters, "ALTITUDE_CORRECTION", context),
        detection_threshold_gev=read_optional(*read, "DETECTION_THRESHOLD", context) or 0.0,
    )


def telescope_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare what turns a flux into an exposure time."""
    return [
        number(
            "ACCEPTANCE", "Acceptance of a pixel (cm² sr)",
            "Give the acceptance of one pixel in cm² sr, above 0. It divides the exposure time.",
            6.0, 0,
        ),
        number(
            "MUONS", "Muons per pixel",
            "Give the number of muons wanted in each pixel, above 0. 10 muons give the flux to "
            "about 32 %, 100 to 10 %.",
            10.0, 0,
        ),
        *geometry_parameters(optional=True),
    ]  # fmt: skip


def read_telescope(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Telescope:
    """Return acceptance and muons wanted.

    Raises
    ------
    MuyscError
        If a value cannot be used.
    """
    geometry, formula, notes = read_geometry(algorithm, parameters, context)
    return Telescope(
        read_number(algorithm, parameters, "ACCEPTANCE", context),
        read_number(algorithm, parameters, "MUONS", context),
        None if geometry is None else trajectories(geometry, formula),
        notes,
    )
