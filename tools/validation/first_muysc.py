"""What the first MUYSC answers: its published flux module, written anew from its formulas.

The formulas are those of ``Modules/FluxModels.py`` at commit 5295350 of the repository
Jhosgun/MUYSC. It differs from the printed paper in the exponent of the energy loss, 3.65 in
place of 4, which lets the minimum energy grow on where the printed one ends.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

SOURCE = "flux module of the first MUYSC (Jhosgun/MUYSC, FluxModels.py), worked out apart"

_MUON_MASS_GEV = 0.1056
_ROCK_G_CM3 = 2.65
#: It looks for the minimum energy up to 100 TeV, and sums the spectrum up to 10 TeV.
_SEARCHED_GEV = np.linspace(1.0, 1e5, 100_000)
_SUMMED_GEV = np.linspace(1.0, 1e4, 10_000)
_STEP_GEV = (1e4 - 1.0) / 10_000
_SECONDS_OF_A_DAY = 86400.0


@dataclass(frozen=True)
class FirstMuons:
    """What the first MUYSC finds behind rock."""

    minimum_energy_gev: float
    #: Fluxes per cm² sr day.
    flux: float
    open_sky: float

    @property
    def transmission(self) -> float:
        """Share of the open sky."""
        return self.flux / self.open_sky


def first_muons(thickness_m: float, zenith_deg: float) -> FirstMuons:
    """Return what the first MUYSC finds behind a thickness of standard rock."""
    minimum = _minimum_energy_gev(100.0 * thickness_m * _ROCK_G_CM3)
    spectrum = _spectrum(zenith_deg)
    arriving = minimum <= _SUMMED_GEV
    a_day = _STEP_GEV * _SECONDS_OF_A_DAY
    return FirstMuons(minimum, float(spectrum[arriving].sum()) * a_day, spectrum.sum() * a_day)


def _minimum_energy_gev(opacity_g_cm2: float) -> float:
    """Return the energy whose ratio to its own loss comes nearest to the opacity."""
    x = np.log10(_SEARCHED_GEV)
    exponent = 0.0154 * x**3.65 - 0.0461 * x**3 + 0.0368 * x**2 + 0.0801 * x + 0.2549
    ratio = 1e3 * _SEARCHED_GEV / 10**exponent
    return float(_SEARCHED_GEV[np.argmin(np.abs(ratio - opacity_g_cm2))]) - _MUON_MASS_GEV


def _spectrum(zenith_deg: float) -> np.ndarray:
    """Return Reyna's spectrum with the momentum itself as base, at sea level."""
    cosine = np.cos(np.radians(zenith_deg))
    momentum = np.sqrt(_SUMMED_GEV**2 - _MUON_MASS_GEV**2)
    y = np.log10(momentum * cosine)
    power = 0.2455 + 1.288 * y - 0.2555 * y**2 + 0.0209 * y**3
    return np.asarray(0.00253 * momentum**-power * cosine**3)
