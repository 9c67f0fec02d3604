"""The physics a user chooses, checked once."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from .constants import OPEN_SKY_MOMENTUM_GEV
from .energy_loss import ENERGY_LOSSES
from .gaisser import GAISSER_PARAMETERS
from .materials import MATERIALS
from .spectra import DEFAULT_MODEL, MODELS, kinetic_from_momentum

#: Densest matter accepted, g/cm³; osmium, the densest element, has 22.6.
MAXIMUM_DENSITY_G_CM3 = 30.0
#: Thinnest, a thousandth of air's: metres of less are no numbers any more.
_MINIMUM_DENSITY_G_CM3 = 1e-6

#: Detection thresholds in GeV are below this.
MAXIMUM_THRESHOLD_GEV = 1e5


@dataclass(frozen=True)
class Physics:
    """How muons are produced and how rock stops them.

    Parameters
    ----------
    material
        Key of `MATERIALS`.
    density_g_cm3
        Density in g/cm³; None stands for the material's own.
    flux_model
        Key of `MODELS`.
    gaisser_parameters
        Key of `GAISSER_PARAMETERS`; counts for the models built on Gaisser's formula.
    energy_loss
        ``csda`` (the material's table), ``lesparre`` (polynomial) or ``paper``
        (energy over stopping power taken for the range).
    straggling
        Whether the fluctuations of the energy loss are corrected for.
    altitude_correction
        Whether the flux of a formula grows with the altitude of the detector; that of a
        tabulated model always does.
    detection_threshold_gev
        Kinetic energy in GeV from which muons are counted, behind the rock and in the open
        sky; 0 for the usual one, see `threshold_gev`.

    Raises
    ------
    MuyscError
        If a name is unknown or a number is out of range.
    """

    material: str = "standard_rock"
    density_g_cm3: float | None = None
    flux_model: str = DEFAULT_MODEL
    gaisser_parameters: str = "gaisser"
    energy_loss: str = "csda"
    straggling: bool = True
    altitude_correction: bool = True
    detection_threshold_gev: float = 0.0

    def __post_init__(self) -> None:
        _check_name("material", self.material, MATERIALS)
        _check_name("flux model", self.flux_model, MODELS)
        _check_name("set of Gaisser parameters", self.gaisser_parameters, GAISSER_PARAMETERS)
        _check_name("energy loss", self.energy_loss, ENERGY_LOSSES)
        density = self.density_g_cm3
        if density is not None and not _MINIMUM_DENSITY_G_CM3 <= density <= MAXIMUM_DENSITY_G_CM3:
            raise MuyscError(
                f"A density of {density:g} g/cm³ is not that of any matter; give one above 0, "
                f"{_MINIMUM_DENSITY_G_CM3:g} at least, and up to {MAXIMUM_DENSITY_G_CM3:g} g/cm³, "
                "or none for the material's own."
            )
        if not 0 <= self.detection_threshold_gev < MAXIMUM_THRESHOLD_GEV:
            raise MuyscError(
                f"A detection threshold of {self.detection_threshold_gev:g} GeV cannot be used; "
                f"give a kinetic energy from 0 to below {MAXIMUM_THRESHOLD_GEV:g} GeV."
            )
        for name in ("straggling", "altitude_correction"):
            if not isinstance(getattr(self, name), bool):
                raise MuyscError(
                    f"{name} is {getattr(self, name)!r}, which is neither true nor false; "
                    "give one of the two."
                )

    @property
    def density(self) -> float:
        """Density in g/cm³: the one given, else the material's own."""
        if self.density_g_cm3 is None:
            return MATERIALS[self.material].density_g_cm3
        return float(self.density_g_cm3)

    @property
    def threshold_gev(self) -> float:
        """Kinetic energy in GeV that a muon still needs behind the rock.

        The one given. Without one, that of 1 GeV/c with a tabulated model; with a formula
        none, as it has always been there, though their open sky starts at 1 GeV/c.
        """
        if self.detection_threshold_gev > 0 or not MODELS[self.flux_model].tabulated:
            return float(self.detection_threshold_gev)
        return self.open_sky_start_gev

    @property
    def open_sky_start_gev(self) -> float:
        """Kinetic energy in GeV from which the open sky counts: as given, or of 1 GeV/c."""
        if self.detection_threshold_gev > 0:
            return float(self.detection_threshold_gev)
        return float(kinetic_from_momentum(np.array(OPEN_SKY_MOMENTUM_GEV)))

    @property
    def altitude_counts(self) -> bool:
        """Whether the flux depends on the altitude of the detector."""
        return self.altitude_correction or MODELS[self.flux_model].tabulated


def _check_name(what: str, name: str, choices: Collection[str]) -> None:
    if not isinstance(name, str) or name not in choices:
        raise MuyscError(f"There is no {what} “{name}”; use one of {', '.join(choices)}.")


def check_altitude(altitude_m: float) -> None:
    """Refuse an altitude outside the muon-producing part of the atmosphere.

    Raises
    ------
    MuyscError
        If it is not a number from −1000 m to 10 000 m.
    """
    if not (math.isfinite(altitude_m) and -1000.0 <= altitude_m <= 10000.0):
        raise MuyscError(
            f"A detector altitude of {altitude_m:g} m is not on land; give the height above sea "
            "level in metres, between −1000 and 10000."
        )
