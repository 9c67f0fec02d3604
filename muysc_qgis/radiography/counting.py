"""How long to count, and what density error the counts leave."""

from __future__ import annotations

import numpy as np

from ..errors import MuyscError


def exposure_days(
    flux_per_cm2_sr_day: np.ndarray, acceptance_cm2_sr: float | np.ndarray, muons: float
) -> np.ndarray:
    """Return the days in which a number of muons is expected: N/(I·𝒯).

    Parameters
    ----------
    flux_per_cm2_sr_day
        Muon flux I in cm⁻² sr⁻¹ day⁻¹, any shape.
    acceptance_cm2_sr
        Acceptance 𝒯 in cm² sr, one for all or one for each ray.
    muons
        Number N of muons wanted.

    Returns
    -------
    numpy.ndarray
        Days; NaN where the flux is unknown or no muon comes through.

    Raises
    ------
    MuyscError
        If the acceptance or the number of muons is not above 0 and finite.
    """
    check_positive(acceptance_cm2_sr, "acceptance in cm² sr")
    check_positive(muons, "number of muons")
    rate = np.asarray(flux_per_cm2_sr_day, dtype=float) * acceptance_cm2_sr
    # Longer than a number can say is infinitely long.
    with np.errstate(over="ignore"):
        return muons / np.where(rate > 0, rate, np.nan)


def feasibility_days(
    flux_per_cm2_sr_day: np.ndarray,
    changed_flux_per_cm2_sr_day: np.ndarray,
    acceptance_cm2_sr: float | np.ndarray,
    sigma: float = 1.0,
) -> np.ndarray:
    """Return the days after which a change of opacity shows.

    ΔT = σ² I(ϱ)/(𝒯 [I(ϱ + δϱ) − I(ϱ)]²), the feasibility formula of Lesparre et al.
    (2010), doi:10.1111/j.1365-246X.2010.04790.x, with their c = σ².

    Parameters
    ----------
    flux_per_cm2_sr_day, changed_flux_per_cm2_sr_day
        Muon flux behind the expected and behind the changed opacity, cm⁻² sr⁻¹ day⁻¹;
        arrays that broadcast.
    acceptance_cm2_sr
        Acceptance 𝒯 in cm² sr, one for all or one for each ray.
    sigma
        Significance in standard deviations.

    Returns
    -------
    numpy.ndarray
        Days; NaN where a flux is unknown, infinite where the change is none.

    Raises
    ------
    MuyscError
        If the acceptance or the significance is not above 0 and finite.
    """
    check_positive(acceptance_cm2_sr, "acceptance in cm² sr")
    check_positive(sigma, "significance in standard deviations")
    flux = np.asarray(flux_per_cm2_sr_day, dtype=float)
    difference = np.asarray(changed_flux_per_cm2_sr_day, dtype=float) - flux
    with np.errstate(divide="ignore", invalid="ignore"):
        return sigma**2 * flux / (acceptance_cm2_sr * difference**2)


def check_positive(value: float | np.ndarray, name: str) -> None:
    """Refuse what is not above 0 and finite; NaN among several values is unknown, not wrong.

    Raises
    ------
    MuyscError
        With the name and the first value that is not.
    """
    values = np.asarray(value, dtype=float)
    bad = values[~((values > 0) & (values < np.inf)) & ~(np.isnan(values) & (values.ndim > 0))]
    if bad.size:
        raise MuyscError(f"The {name} is {bad[0]:g}; give a finite number above 0.")
