"""Muon spectra given in momentum: Bugaev's, and Reyna's way of inclining a vertical one.

All give dI/dp in cm⁻² s⁻¹ sr⁻¹ (GeV/c)⁻¹ at sea level as a function of the muon
momentum in GeV/c and, where it matters, the cosine of the zenith angle.
"""

from __future__ import annotations

import numpy as np

#: Momenta in GeV/c where the constants of Bugaev's spectrum change.
BUGAEV_BREAKS_GEV = (930.0, 1590.0, 4.2e5)

#: A and a0 to a3 of Bugaev's spectrum between the breaks (Bugaev et al. 1998,
#: doi:10.1103/PhysRevD.58.054001, table for sea level).
_BUGAEV = np.array([
    (2.950e-3, 0.3061, 1.2743, -0.263, 0.0252),
    (1.781e-2, 1.791, 0.304, 0.0, 0.0),
    (1.435e1, 3.672, 0.0, 0.0, 0.0),
    (1e3, 4.0, 0.0, 0.0, 0.0),
])  # fmt: skip

#: Amplitude and polynomial of the Reyna–Bugaev spectrum (Reyna 2006, hep-ph/0604145).
_REYNA_AMPLITUDE = 0.00253
_REYNA = (0.2455, 1.288, -0.2555, 0.0209)

#: Amplitude, cm⁻² s⁻¹ sr⁻¹ (GeV/c)⁻¹, and h1, h2, h3, s2 of the vertical spectrum of
#: Hebbeker & Timmermans (2002), doi:10.1016/S0927-6505(01)00180-3.
_HEBBEKER_AMPLITUDE = 0.86e-4
_HEBBEKER = (0.133, -2.521, -5.78, -2.11)

#: Momentum × cosθ, GeV/c, above which the Hebbeker cubic (which turns upwards at
#: 10⁷ GeV/c) is continued as a power law of the same slope.
HEBBEKER_END_GEV = 1e4


def bugaev(momentum_gev: np.ndarray) -> np.ndarray:
    """Return Bugaev's spectrum of vertical muons.

    dI/dp = A p^-(a3 y³ + a2 y² + a1 y + a0), y = log10 p, in four ranges of momentum.

    Parameters
    ----------
    momentum_gev
        Any shape, GeV/c.

    Returns
    -------
    numpy.ndarray
        cm⁻² s⁻¹ sr⁻¹ (GeV/c)⁻¹.
    """
    momentum_gev = np.asarray(momentum_gev, dtype=float)
    row = np.searchsorted(BUGAEV_BREAKS_GEV, momentum_gev, side="right")
    amplitude, a0, a1, a2, a3 = np.moveaxis(_BUGAEV[row], -1, 0)
    y = np.log10(momentum_gev)
    return amplitude * 10.0 ** (-y * (((a3 * y + a2) * y + a1) * y + a0))


def reyna_bugaev(momentum_gev: np.ndarray, cos_zenith: np.ndarray) -> np.ndarray:
    """Return Reyna's spectrum for all zenith angles.

    dI/dp = 0.00253 ζ^-(0.2455 + 1.288 y − 0.2555 y² + 0.0209 y³) cos³θ with
    ζ = p cosθ and y = log10 ζ (Reyna 2006, hep-ph/0604145).

    Parameters
    ----------
    momentum_gev, cos_zenith
        Arrays that broadcast; GeV/c and the cosine of the zenith angle.

    Returns
    -------
    numpy.ndarray
        cm⁻² s⁻¹ sr⁻¹ (GeV/c)⁻¹.
    """
    y = np.log10(momentum_gev * cos_zenith)
    a0, a1, a2, a3 = _REYNA
    power = 10.0 ** (-y * (((a3 * y + a2) * y + a1) * y + a0))
    return _REYNA_AMPLITUDE * power * np.power(cos_zenith, 3)


def reyna_hebbeker(momentum_gev: np.ndarray, cos_zenith: np.ndarray) -> np.ndarray:
    """Return the vertical spectrum of Hebbeker & Timmermans inclined in Reyna's way.

    dI/dp = 0.86e-4 · 10^H(y) cos³θ with y = log10(p cosθ) and
    H = h1 (y³/2 − 5y²/2 + 3y) + h2 (−2y³/3 + 3y² − 10y/3 + 1)
    + h3 (y³/6 − y²/2 + y/3) + s2 (y³/3 − 2y² + 11y/3 − 2).

    Parameters and result are those of `reyna_bugaev`.
    """
    h1, h2, h3, s2 = _HEBBEKER
    c3 = h1 / 2 - 2 * h2 / 3 + h3 / 6 + s2 / 3
    c2 = -5 * h1 / 2 + 3 * h2 - h3 / 2 - 2 * s2
    c1 = 3 * h1 - 10 * h2 / 3 + h3 / 3 + 11 * s2 / 3
    c0 = h2 - 2 * s2
    end = np.log10(HEBBEKER_END_GEV)
    slope = (3 * c3 * end + 2 * c2) * end + c1
    y = np.log10(momentum_gev * cos_zenith)
    inside = np.minimum(y, end)
    exponent = ((c3 * inside + c2) * inside + c1) * inside + c0 + slope * (y - inside)
    return _HEBBEKER_AMPLITUDE * 10.0**exponent * np.power(cos_zenith, 3)
