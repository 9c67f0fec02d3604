"""A measured flux with its errors, whatever it was measured as."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..radiography.counting import check_positive
from ..radiography.settings import Physics
from ..radiography.transmission import attenuate
from .poisson import logarithmic_errors, ratio_upper_limit, upper_limit

#: A measured transmission may exceed 1 by this many of its standard errors.
_ERRORS_ABOVE_ONE = 3.0


@dataclass(frozen=True)
class Observation:
    """What a telescope saw in each direction, all arrays (n_elevation, n_azimuth).

    The value is a flux in cm⁻² sr⁻¹ day⁻¹, or the share of a flux of the open sky, which
    only a flux model can turn into one.
    """

    #: Flux or share; NaN where not measured.
    value: np.ndarray
    #: One standard deviation down and up, in the logarithm of the value; NaN where unknown.
    ln_down: np.ndarray
    ln_up: np.ndarray
    #: What the value does not exceed at the confidence chosen, for pixels without a muon.
    limit: np.ndarray
    #: Elevation in degrees of the open sky that the value is a share of; None for a flux.
    sky_elevation_deg: np.ndarray | None = None
    #: Muons counted, and the counts for which the value would be 1; None for no counts.
    counts: np.ndarray | None = None
    exposure: np.ndarray | None = None
    #: Muons counted in the open sky, where the exposure comes from them.
    sky_counts: np.ndarray | None = None
    #: One-sided confidence of the limits.
    confidence: float = 0.95

    def unit_flux(self, physics: Physics, altitude_m: float) -> np.ndarray:
        """Return the flux in cm⁻² sr⁻¹ day⁻¹ that a value of 1 stands for."""
        if self.sky_elevation_deg is None:
            return np.ones_like(self.value)
        none = np.zeros_like(self.sky_elevation_deg)
        sky = attenuate(none, self.sky_elevation_deg, physics, altitude_m).open_sky
        return np.broadcast_to(sky, self.value.shape)


def from_counts(
    counts: np.ndarray,
    exposure_days: float,
    acceptance_cm2_sr: float | np.ndarray,
    confidence: float,
    expected: bool = False,
) -> Observation:
    """Return the flux that counts stand for: N/(𝒯 t).

    Parameters
    ----------
    counts
        (n_elevation, n_azimuth) muons counted, NaN where not measured.
    exposure_days
        Time t of counting.
    acceptance_cm2_sr
        Acceptance 𝒯, one for all or one for each pixel.
    confidence
        Of the limit for pixels without a muon, between 0 and 1.
    expected
        Whether the counts are those expected, which may be fractions.

    Raises
    ------
    MuyscError
        If counts are negative or fractional, or time or acceptance not above 0.
    """
    if expected:
        _check_no_less_than_zero(counts, "muon counts", "are")
    else:
        check_counts(counts, "muon counts")
    check_positive(exposure_days, "exposure in days")
    check_positive(acceptance_cm2_sr, "acceptance in cm² sr")
    exposure = np.broadcast_to(exposure_days * np.asarray(acceptance_cm2_sr), counts.shape)
    down, up = logarithmic_errors(counts)
    return Observation(
        counts / exposure,
        down,
        up,
        upper_limit(counts, confidence) / exposure,
        counts=counts,
        exposure=exposure,
        confidence=confidence,
    )


def from_count_ratio(
    counts: np.ndarray,
    sky_counts: np.ndarray,
    days_per_sky_day: float,
    sky_elevation_deg: np.ndarray,
    confidence: float,
) -> Observation:
    """Return the share of the open sky that two runs of one telescope stand for.

    (N/t)/(N₀/t₀), pixel by pixel: the acceptance of a pixel is the same in both runs
    and drops out. The open sky may have been another part of the sky; its elevation
    says which flux the share is of.

    Parameters
    ----------
    counts, sky_counts
        (n_elevation, n_azimuth) muons counted towards the rock and in the open sky.
    days_per_sky_day
        Time of counting towards the rock over that in the open sky.
    sky_elevation_deg
        Elevation of the pixels in the run in the open sky in degrees, (n_elevation, 1) or
        one for each.
    confidence
        Of the limit for pixels without a muon, between 0 and 1.

    Raises
    ------
    MuyscError
        If counts are negative or fractional, or a time is not above 0.
    """
    check_counts(counts, "muon counts")
    check_counts(sky_counts, "open-sky counts")
    check_positive(days_per_sky_day, "ratio of the two exposures")
    exposure = np.where(sky_counts > 0, sky_counts, np.nan) * days_per_sky_day
    down, up = logarithmic_errors(counts, sky_counts)
    # Needed where nothing was counted alone, and each takes long.
    none = np.where(counts == 0, counts, np.nan)
    limit = ratio_upper_limit(none, np.where(sky_counts > 0, sky_counts, np.nan), confidence)
    return Observation(
        counts / exposure,
        down,
        up,
        limit / days_per_sky_day,
        sky_elevation_deg,
        counts,
        exposure,
        sky_counts,
        confidence,
    )


def from_values(
    values: np.ndarray,
    errors: np.ndarray | None,
    confidence: float,
    sky_elevation_deg: np.ndarray | None = None,
) -> Observation:
    """Return a measured flux, or transmission where the elevation of the sky is given.

    Parameters
    ----------
    values
        (n_elevation, n_azimuth) flux in cm⁻² sr⁻¹ day⁻¹ or transmission, NaN where not
        measured.
    errors
        Standard errors of the values, None where unknown.
    confidence
        Of the limit for pixels whose value is 0, between 0 and 1.
    sky_elevation_deg
        Elevation of the pixels in degrees, (n_elevation, 1) or one for each; None for a flux.

    Raises
    ------
    MuyscError
        If values or errors are negative or infinite.
    """
    name = "flux" if sky_elevation_deg is None else "transmission"
    _check_no_less_than_zero(values, f"measured {name}")
    if errors is None:
        unknown = np.full(values.shape, np.nan)
        return Observation(values, unknown, unknown, unknown, sky_elevation_deg)
    from scipy.special import ndtri

    _check_no_less_than_zero(errors, f"error of the measured {name}")
    relative = errors / np.where(values > 0, values, np.nan)
    with np.errstate(divide="ignore"):
        # An error as large as the value leaves no lower end.
        down = -np.log(np.maximum(1.0 - relative, 0.0))
    return Observation(
        values, down, np.log1p(relative), values + ndtri(confidence) * errors, sky_elevation_deg
    )


def check_transmission(
    values: np.ndarray, errors: np.ndarray | None, thickness_m: np.ndarray
) -> None:
    """Refuse a measured transmission above 1 behind rock, beyond its errors.

    Raises
    ------
    MuyscError
        Naming the number of pixels and the largest value.
    """
    margin = 0.0 if errors is None else _ERRORS_ABOVE_ONE * np.nan_to_num(errors)
    bad = values[(thickness_m > 0) & (values - margin > 1)]
    if bad.size:
        raise MuyscError(
            f"The measured transmission is above 1 in {pixels(bad.size)} with rock, up to "
            f"{bad.max():g}; give shares from 0 to 1 (not percent), and no-data where the "
            "measurement failed."
        )


def check_counts(counts: np.ndarray, name: str) -> None:
    """Refuse counts that no counter gives.

    Raises
    ------
    MuyscError
        If a count is negative, infinite or fractional.
    """
    _check_no_less_than_zero(counts, name, "are")
    bad = counts[np.isfinite(counts) & (counts != np.round(counts))]
    if bad.size:
        raise MuyscError(
            f"The {name} are fractional in {pixels(bad.size)}, such as {bad[0]:g}; give whole "
            "numbers of muons as counted (for rates, give a flux muogram with its errors)."
        )


def pixels(count: int) -> str:
    """Return a number of pixels in words that fit it."""
    return f"{count} pixel" if count == 1 else f"{count} pixels"


def _check_no_less_than_zero(values: np.ndarray, name: str, verb: str = "is") -> None:
    bad = values[(values < 0) | np.isinf(values)]
    if bad.size:
        raise MuyscError(
            f"The {name} {verb} negative or infinite in {pixels(bad.size)}, such as {bad[0]:g}; "
            "give values of 0 or more, and no-data where unknown."
        )
