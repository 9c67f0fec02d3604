"""Muon spectra built on Gaisser's formula: plain, as in MUSIC and MUSUN, and Guan's.

All three give dI/dE in cm⁻² s⁻¹ sr⁻¹ GeV⁻¹ at sea level as a function of the
*total* muon energy in GeV and the cosine of the zenith angle; both broadcast.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class GaisserParameters:
    """Constants of A E^-γ [1/(1 + E cosθ/Eπ) + B/(1 + E cosθ/EK) + rc]."""

    title: str
    #: A in cm⁻² s⁻¹ sr⁻¹ GeV^(γ-1).
    amplitude: float
    #: B, the weight of kaons against pions.
    kaon_weight: float
    #: γ, the index of the spectrum.
    index: float
    #: Eπ in GeV, where pions interact as often as they decay.
    pion_energy_gev: float
    #: EK in GeV, the same for kaons.
    kaon_energy_gev: float
    #: Energies in GeV between which the constants were fitted.
    fitted_from_gev: float
    fitted_to_gev: float


#: Published constant sets: Volkova, Zatsepin & Kuz'michev (1979); Gaisser (1990),
#: Cosmic Rays and Particle Physics; Klimushin, Bugaev & Sokalski (2001),
#: doi:10.1103/PhysRevD.64.014016; Aglietta et al. (LVD, 1998),
#: doi:10.1103/PhysRevD.58.092005; Ambrosio et al. (MACRO, 1995),
#: doi:10.1103/PhysRevD.52.3793.
GAISSER_PARAMETERS = {
    "volkova": GaisserParameters(
        "Volkova et al. 1979", 0.1258, 0.0588, 2.65, 100.0, 650.0, 100.0, 1e5
    ),
    "gaisser": GaisserParameters(
        "Gaisser 1990", 0.14, 0.054, 2.70, 115.0 / 1.1, 850.0 / 1.1, 100.0, 1e5
    ),
    "klimushin": GaisserParameters(
        "Klimushin et al. 2001", 0.175, 0.037, 2.72, 103.0, 810.0, 300.0, 2.5e5
    ),
    "aglietta": GaisserParameters(
        "Aglietta et al. 1998", 0.256, 0.054, 2.77, 115.0 / 1.1, 850.0 / 1.1, 2e3, 4e4
    ),
    "ambrosio": GaisserParameters(
        "Ambrosio et al. 1995", 0.26, 0.054, 2.78, 115.0 / 1.1, 850.0 / 1.1, 500.0, 2e4
    ),
}

#: Share of prompt muons, rc, added to the bracket of the modified form.
PROMPT_SHARE = 1e-4

#: Energy loss in the atmosphere, GeV per g/cm².
_AIR_LOSS_GEV_CM2_G = 0.00206
#: Depth of the atmosphere and mean depth of muon production, g/cm².
_AIR_DEPTH_G_CM2 = 1030.0
_PRODUCTION_DEPTH_G_CM2 = 120.0
#: Production height over the radius of the Earth, both in km.
_PRODUCTION_HEIGHT_RATIO = 32.0 / 6370.0

#: p1 to p5 of the effective cosine (Chirkin 2004, hep-ph/0407078, table 1).
_CHIRKIN = (0.102573, -0.068287, 0.958633, 0.0407253, 0.817285)


def gaisser(
    total_energy_gev: np.ndarray,
    cos_zenith: np.ndarray,
    parameters: GaisserParameters = GAISSER_PARAMETERS["gaisser"],
) -> np.ndarray:
    """Return Gaisser's spectrum, for a flat Earth and muons that do not decay.

    dI/dE = A E^-γ [1/(1 + E cosθ/Eπ) + B/(1 + E cosθ/EK)], meant for
    E > 100 GeV/cosθ and θ < 70°.

    Parameters
    ----------
    total_energy_gev, cos_zenith
        Arrays that broadcast; total energy in GeV, cosine of the zenith angle.
    parameters
        Constants of the formula.

    Returns
    -------
    numpy.ndarray
        cm⁻² s⁻¹ sr⁻¹ GeV⁻¹.
    """
    return parameters.amplitude * _power_and_bracket(
        total_energy_gev, total_energy_gev * cos_zenith, parameters, prompt=0.0
    )


def _power_and_bracket(
    energy: np.ndarray, projected: np.ndarray, parameters: GaisserParameters, prompt: float
) -> np.ndarray:
    """Return E^-γ times the bracket, `projected` being E cosθ."""
    bracket = (
        1.0 / (1.0 + projected / parameters.pion_energy_gev)
        + parameters.kaon_weight / (1.0 + projected / parameters.kaon_energy_gev)
        + prompt
    )
    return energy**-parameters.index * bracket


def cos_zenith_at_production(cos_zenith: np.ndarray) -> np.ndarray:
    """Return the cosine of the zenith angle at the height of production, 32 km.

    cosθ* = sqrt(1 − (1 − cos²θ)/(1 + 32/6370)²), the curved-Earth cosine of the
    MUSUN generator (Kudryavtsev 2009, doi:10.1016/j.cpc.2008.10.013).
    """
    return np.sqrt(1.0 - (1.0 - np.square(cos_zenith)) / (1.0 + _PRODUCTION_HEIGHT_RATIO) ** 2)


def gaisser_tang(
    total_energy_gev: np.ndarray,
    cos_zenith: np.ndarray,
    parameters: GaisserParameters = GAISSER_PARAMETERS["gaisser"],
) -> np.ndarray:
    """Return Gaisser's spectrum as MUSIC and MUSUN modify it for low energies and the horizon.

    dI/dE = A_T Ê^-γ [1/(1 + Ê cosθ*/Eπ) + B/(1 + Ê cosθ*/EK) + rc], where
    Ê = E + ΔE is the energy at production, ΔE = 0.00206 (1030/cosθ* − 120) GeV
    the loss in the air, and A_T = A (120 cosθ*/1030)^{1.04/[(E + ΔE/2) cosθ*]}
    the share that does not decay on the way (Kudryavtsev 2009,
    doi:10.1016/j.cpc.2008.10.013, after Dar 1983, doi:10.1103/PhysRevLett.51.227).

    Tang et al. (2006, doi:10.1103/PhysRevD.74.053007), whose name the model has in the
    interface, print another one: A_T = 1.1 (90 √(cosθ + 0.001)/1030)^{4.5/(E cosθ*)} and
    ΔE = 2.06·10⁻³ (950/cosθ* − 90), which is farther from measured spectra.

    Parameters and result are those of `gaisser`.
    """
    cosine = cos_zenith_at_production(cos_zenith)
    loss = _AIR_LOSS_GEV_CM2_G * (_AIR_DEPTH_G_CM2 / cosine - _PRODUCTION_DEPTH_G_CM2)
    decay_exponent = 1.04 / ((total_energy_gev + 0.5 * loss) * cosine)
    survival = np.exp(decay_exponent * np.log(_PRODUCTION_DEPTH_G_CM2 / _AIR_DEPTH_G_CM2 * cosine))
    initial = total_energy_gev + loss
    return (
        parameters.amplitude
        * survival
        * _power_and_bracket(initial, initial * cosine, parameters, PROMPT_SHARE)
    )


def effective_cos_zenith(cos_zenith: np.ndarray) -> np.ndarray:
    """Return Chirkin's effective cosine, which stays above 0 at the horizon.

    cosθ* = sqrt[(x² + p1² + p2 x^p3 + p4 x^p5)/(1 + p1² + p2 + p4)], x = cosθ
    (Chirkin 2004, hep-ph/0407078).
    """
    p1, p2, p3, p4, p5 = _CHIRKIN
    return np.sqrt(
        (np.square(cos_zenith) + p1**2 + p2 * cos_zenith**p3 + p4 * cos_zenith**p5)
        / (1.0 + p1**2 + p2 + p4)
    )


def guan(total_energy_gev: np.ndarray, cos_zenith: np.ndarray) -> np.ndarray:
    """Return Gaisser's spectrum as modified by Guan et al. for low energies.

    dI/dE = 0.14 [E (1 + 3.64/(E cosθ*^1.29))]^-2.7
    [1/(1 + 1.1 E cosθ*/115) + 0.054/(1 + 1.1 E cosθ*/850)], with Chirkin's cosθ*
    (Guan et al. 2015, arXiv:1509.06176).

    Parameters and result are those of `gaisser`; the constants are fixed.
    """
    cosine = effective_cos_zenith(cos_zenith)
    parameters = GAISSER_PARAMETERS["gaisser"]
    return parameters.amplitude * _power_and_bracket(
        total_energy_gev + 3.64 / cosine**1.29, total_energy_gev * cosine, parameters, prompt=0.0
    )
