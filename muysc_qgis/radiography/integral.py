"""The integral muon spectrum I(>E) for many zenith angles at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .altitude import altitude_factor
from .interpolation import hermite
from .spectra import MODELS, differential_flux, kinetic_from_momentum, momentum_from_kinetic

#: Width of an interval of the energy grid in ln E. Gauss–Lobatto quadrature and
#: Hermite interpolation of ln I are then accurate to 4·10⁻⁵ for every model.
_LN_STEP = 0.4

#: The grid reaches at least this kinetic energy, GeV, …
_TOP_GEV = 1e6
#: … and this many times the highest energy asked for; the rest is a power law.
_TOP_MARGIN = 100.0

#: Nodes on 0 to 1 and weights of Gauss–Lobatto quadrature with four points.
_LOBATTO_NODES = 0.5 + 0.5 * np.array([-1.0, -np.sqrt(0.2), np.sqrt(0.2), 1.0])
_LOBATTO_WEIGHTS = np.array([1.0, 5.0, 5.0, 1.0]) / 12.0

#: Smallest intensity told from none, so that its logarithm stays finite.
_TINY = 1e-300


@dataclass(frozen=True)
class IntegralSpectrum:
    """ln I(>E) of ln E for a list of zenith angles, tabulated once.

    The table holds values and exact slopes dlnI/dlnE = −E Φ(E)/I, so that four
    numbers give any intensity, and a search on them gives the energy back.
    """

    #: (n_energy,) ln of kinetic energy in GeV, increasing.
    ln_energy: np.ndarray
    #: (n_zenith, n_energy) ln of intensity in cm⁻² s⁻¹ sr⁻¹.
    ln_intensity: np.ndarray
    #: (n_zenith, n_energy) dlnI/dlnE.
    slope: np.ndarray

    def __call__(
        self, row: np.ndarray, kinetic_energy_gev: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the muon intensity above an energy and how steeply it falls there.

        Parameters
        ----------
        row
            Index of the zenith angle; broadcasts with the energy.
        kinetic_energy_gev
            Kinetic energy in GeV, inside the table; NaN stays NaN.

        Returns
        -------
        intensity
            cm⁻² s⁻¹ sr⁻¹.
        index
            −dlnI/dlnE, interpolated linearly.
        """
        x = np.log(kinetic_energy_gev)
        known = np.where(np.isnan(x), self.ln_energy[0], x)
        k = np.clip(
            np.searchsorted(self.ln_energy, known, side="right") - 1, 0, len(self.ln_energy) - 2
        )
        width = np.diff(self.ln_energy)[k]
        t = (x - self.ln_energy[k]) / width
        here = row * len(self.ln_energy) + k
        value, slope = self.ln_intensity.ravel(), self.slope.ravel()
        slope0, slope1 = slope[here], slope[here + 1]
        ln_intensity = hermite(t, width, value[here], value[here + 1], slope0, slope1)
        return np.exp(ln_intensity), -(slope0 + t * (slope1 - slope0))

    @property
    def from_start(self) -> np.ndarray:
        """(n_zenith,) intensity above the lowest energy of the table, cm⁻² s⁻¹ sr⁻¹."""
        return np.exp(self.ln_intensity[:, 0])


def integral_spectrum(
    cos_zenith: np.ndarray,
    flux_model: str,
    gaisser_parameters: str,
    start_gev: float,
    highest_gev: float = 0.0,
    altitude_m: float | None = None,
) -> IntegralSpectrum:
    """Integrate a spectrum from every energy to infinity.

    Parameters
    ----------
    cos_zenith
        (n_zenith,) cosines of the zenith angle, above 0.
    flux_model, gaisser_parameters
        Keys of `MODELS` and `GAISSER_PARAMETERS`.
    start_gev
        Lowest kinetic energy that will be asked for, GeV.
    highest_gev
        Highest kinetic energy that will be asked for, GeV.
    altitude_m
        Height above sea level, m: the place in the table of a tabulated model, for the
        formulas a correction inside the integral; None for sea level.
    """
    grid = _energy_grid(flux_model, start_gev, highest_gev)
    width = np.diff(grid)
    # Ends of intervals coincide, so three of the four nodes make the whole sequence.
    ln_energy = np.append((grid[:-1, None] + width[:, None] * _LOBATTO_NODES[:3]).ravel(), grid[-1])
    energy = np.exp(ln_energy)
    density = energy * differential_flux(  # dI/dlnE
        energy,
        np.asarray(cos_zenith, dtype=float)[:, None],
        flux_model,
        gaisser_parameters,
        altitude_m or 0.0,
    )
    if altitude_m is not None and not MODELS[flux_model].tabulated:
        density *= altitude_factor(momentum_from_kinetic(energy), altitude_m)
    at_knots = density[:, ::3]
    first, second, third, fourth = _LOBATTO_WEIGHTS
    pieces = width * (
        first * at_knots[:, :-1]
        + second * density[:, 1::3]
        + third * density[:, 2::3]
        + fourth * at_knots[:, 1:]
    )
    # Beyond the last knot the density falls on as a power of the energy. It always falls,
    # but for angles so close to the horizon that some models make no sense at all.
    ends = np.log(np.maximum(density[:, -2:], _TINY))
    decline = np.maximum((ends[:, 0] - ends[:, 1]) / (ln_energy[-1] - ln_energy[-2]), 0.1)
    tail = at_knots[:, -1] / decline
    intensity = np.empty_like(at_knots)
    intensity[:, -1] = tail
    # From the top down, so that small intensities are sums of small pieces.
    intensity[:, :-1] = tail[:, None] + np.cumsum(pieces[:, ::-1], axis=1)[:, ::-1]
    intensity = np.maximum(intensity, _TINY)
    slope = np.where(intensity > _TINY, -at_knots / intensity, 0.0)
    return IntegralSpectrum(grid, np.log(intensity), slope)


def _energy_grid(flux_model: str, start_gev: float, highest_gev: float) -> np.ndarray:
    """Return ln of the kinetic energies of the knots, the model's breaks among them."""
    top_gev = max(_TOP_GEV, _TOP_MARGIN * start_gev, _TOP_MARGIN * highest_gev)
    breaks = [float(kinetic_from_momentum(np.array(p))) for p in MODELS[flux_model].breaks_gev]
    corners = [start_gev, *(e for e in breaks if start_gev < e < top_gev), top_gev]
    parts = []
    for low, high in zip(np.log(corners[:-1]), np.log(corners[1:])):
        count = int(np.ceil((high - low) / _LN_STEP))
        parts.append(np.linspace(low, high, count, endpoint=False))
    return np.append(np.concatenate(parts), np.log(top_gev))
