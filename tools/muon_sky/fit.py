"""Amplitudes of the cascade from measured vertical spectra, and how well they are known."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from muysc_qgis.radiography.measured_spectra import Spectra

from .cascade import AMPLITUDES
from .particles import MUON_GEV

#: Common error of L3+C's normalisation (Achard et al. 2004).
_L3_NORMALISATION = 0.03
#: How far an amplitude may be from that of the interaction models before any measurement:
#: the spread of models and accelerator data on meson production (Barr et al. 2006,
#: doi:10.1103/PhysRevD.74.094009).
_PRIOR = 0.3

#: Muons of each amplitude, (n_amplitude, n) per cm² s sr GeV, at kinetic energies in GeV,
#: of altitude in m and cosine of the zenith angle.
Muons = Callable[[float, float, np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Fit:
    """Amplitudes, the same for every place and angle."""

    #: (n_amplitude,) factors on the production of mesons by nucleons.
    amplitude: np.ndarray
    #: (n_amplitude, n_amplitude), scaled by χ² per degree of freedom where that is above 1.
    covariance: np.ndarray
    #: Factor on L3+C's flux that its normalisation takes.
    normalisation: float
    chi2: float
    points: int

    def flux(self, muons: np.ndarray) -> np.ndarray:
        """Return the sum over amplitudes of (n_amplitude, …) muons."""
        return np.tensordot(self.amplitude, muons, 1)

    def relative_error(self, muons: np.ndarray) -> np.ndarray:
        """Return the relative standard error that the fit's covariance gives that sum."""
        variance = np.einsum("a...,ab,b...->...", muons, self.covariance, muons)
        return np.sqrt(variance) / self.flux(muons)


def predicted(spectra: Spectra, muons: Muons) -> np.ndarray:
    """Return (n_amplitude, n_point) dI/dp of each amplitude where a spectrum was measured."""
    result = np.empty((len(AMPLITUDES), len(spectra)))
    energy = np.hypot(spectra.momentum_gev, MUON_GEV)
    places = np.stack([spectra.altitude_m, spectra.zenith_deg], 1)
    for altitude, zenith in np.unique(places, axis=0):
        here = (spectra.altitude_m == altitude) & (spectra.zenith_deg == zenith)
        flux = muons(altitude, float(np.cos(np.radians(zenith))), energy[here] - MUON_GEV)
        # dI/dp = dI/dE · p/E
        result[:, here] = flux * spectra.momentum_gev[here] / energy[here]
    return result


def fit(spectra: Spectra, muons: Muons) -> Fit:
    """Return the amplitudes that meet measured vertical spectra best.

    Parameters
    ----------
    spectra
        Of BESS-TeV and L3+C; the latter's share one normalisation.
    muons
        The cascade.
    """
    parts = predicted(spectra, muons)
    normalised = spectra.experiment == "L3+C"

    def residuals(unknown: np.ndarray) -> np.ndarray:
        model = unknown[:-1] @ parts * np.where(normalised, unknown[-1], 1.0)
        return np.concatenate(
            [
                (model - spectra.flux) / spectra.error,
                (unknown[:-1] - 1.0) / _PRIOR,
                [(unknown[-1] - 1.0) / _L3_NORMALISATION],
            ]
        )

    found = least_squares(residuals, np.ones(len(AMPLITUDES) + 1))
    covariance = np.linalg.inv(found.jac.T @ found.jac)[:-1, :-1]
    chi2 = float(np.sum(found.fun[: len(spectra)] ** 2))
    freedom = len(spectra) - len(found.x)
    return Fit(
        found.x[:-1], covariance * max(1.0, chi2 / freedom), float(found.x[-1]), chi2, len(spectra)
    )
