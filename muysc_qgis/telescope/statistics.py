"""Counting statistics: what a number of counts can tell, exactly.

Needs scipy, which is imported where it is used.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..errors import MuyscError
from ..radiography.counting import check_positive

#: Largest significance in standard deviations; its tail still has a logarithm.
MAXIMUM_SIGMA = 30.0

#: Accuracy of the logarithm of the tails found, and steps that are enough for it.
_TOLERANCE = 1e-8
_STEPS = 60

#: Smallest probability whose logarithm is taken.
_TINY = 1e-300

#: Relative difference of rates that counts as none, and the factor by which a time found
#: from the likelihood ratio may be off.
_SAME_RATE = 1e-9
_FACTOR = 50.0

#: Relative change below which its third power is enough.
_SMALL = 1e-3


def significant_excess(counts: np.ndarray, sigma: float) -> np.ndarray:
    """Return how many counts are an excess of a significance, exactly.

    The number n, taken as continuous, with P(N ≥ n) = P(n, μ) = p for Poisson counts of
    mean μ, where p is the upper tail of the normal law beyond `sigma`, and P(n, μ) the
    regularised lower incomplete gamma function. For large μ it is μ + σ √μ.

    Parameters
    ----------
    counts
        Expected counts μ, any shape.
    sigma
        Significance in standard deviations, one-sided.

    Returns
    -------
    numpy.ndarray
        NaN where the counts are unknown or none.

    Raises
    ------
    MuyscError
        If the significance is not above 0 and finite.
    """
    from scipy.special import gammainc

    wanted = _log_tail(sigma)
    counts = np.asarray(counts, dtype=float)
    excess = np.full(counts.shape, np.nan)
    known = counts > 0
    mu = counts[known]

    def surplus(n: np.ndarray) -> np.ndarray:
        return np.log(np.maximum(gammainc(n, mu), _TINY)) - wanted

    # P(n, μ) falls with n, from above ½ at n = μ to below p at Bernstein's bound.
    beyond = -wanted / 3 + np.sqrt(wanted**2 / 9 - 2 * wanted * mu)
    excess[known] = _root(surplus, mu, mu + beyond + 1.0)
    return excess


def _log_tail(sigma: float) -> float:
    """Return the logarithm of the normal law's upper tail beyond a significance.

    Raises
    ------
    MuyscError
        If the significance is not above 0 or beyond all reason.
    """
    from scipy.special import log_ndtr

    check_positive(sigma, "significance in standard deviations")
    if sigma > MAXIMUM_SIGMA:
        raise MuyscError(
            f"A significance of {sigma:g} standard deviations is beyond all doubt; give one up "
            f"to {MAXIMUM_SIGMA:g}."
        )
    return float(log_ndtr(-sigma))


def days_for_contrast(
    rate_per_day: np.ndarray, changed_rate_per_day: np.ndarray, sigma: float
) -> np.ndarray:
    """Return the days after which a changed rate shows, by exact Poisson statistics.

    The shortest time T after which the counts expected with the change, n = r' T, have
    a probability of p or less (see `significant_excess`) of being reached by chance
    where r T are expected: P(n, r T) = p for more counts, Q(n + 1, r T) = p for fewer.
    With many counts it is the feasibility formula of Lesparre et al. (2010).

    Parameters
    ----------
    rate_per_day, changed_rate_per_day
        Counts per day expected without and with the change; arrays that broadcast.
    sigma
        Significance in standard deviations, one-sided.

    Returns
    -------
    numpy.ndarray
        Days; NaN where a rate is unknown or none, infinite where the change is none.

    Raises
    ------
    MuyscError
        If the significance is not above 0 and finite.
    """
    from scipy.special import gammainc, gammaincc

    wanted = _log_tail(sigma)
    rate, changed = np.broadcast_arrays(
        np.asarray(rate_per_day, dtype=float), np.asarray(changed_rate_per_day, dtype=float)
    )
    known = np.isfinite(rate) & np.isfinite(changed) & (rate > 0)
    days = np.where(known, np.inf, np.nan)
    # Rates closer than this cannot be told apart in any time that matters.
    different = known & (np.abs(changed - rate) > _SAME_RATE * rate)
    r, q = rate[different], np.maximum(changed[different], _TINY)
    more = q > r
    # The likelihood ratio gives a start within a factor of a few; near 0 by its series.
    change = q / r - 1
    series = change**2 / 2 - change**3 / 6
    start = sigma**2 / (2 * r * np.where(np.abs(change) < _SMALL, series, _information(change)))

    def surplus(time: np.ndarray) -> np.ndarray:
        mu, n = r * time, q * time
        tail = np.where(more, gammainc(np.maximum(n, 1e-12), mu), gammaincc(n + 1, mu))
        return np.log(np.maximum(tail, _TINY)) - wanted

    days[different] = np.exp(
        _root(
            lambda ln_time: surplus(np.exp(ln_time)),
            np.log(start / _FACTOR),
            np.log(start * _FACTOR + _FACTOR / r),
        )
    )
    return days


def _information(change: np.ndarray) -> np.ndarray:
    """Return (1 + x) ln(1 + x) − x, what a count tells of a relative change x."""
    ratio = np.maximum(1 + change, _TINY)
    return np.asarray(ratio * np.log(ratio) - change)


def _root(
    function: Callable[[np.ndarray], np.ndarray], low: np.ndarray, high: np.ndarray
) -> np.ndarray:
    """Return roots of a falling function between ends, by the Illinois method."""
    at_low, at_high = function(low), function(high)
    middle, before = low, np.zeros(low.shape, dtype=bool)
    for step in range(_STEPS):
        with np.errstate(invalid="ignore", divide="ignore"):
            middle = (low * at_high - high * at_low) / (at_high - at_low)
        middle = np.where(np.isfinite(middle), middle, 0.5 * (low + high))
        at_middle = function(middle)
        beyond = at_middle > 0
        weight = np.where((beyond == before) & (step > 0), 0.5, 1.0)
        at_high = np.where(beyond, weight * at_high, at_middle)
        at_low = np.where(beyond, at_middle, weight * at_low)
        low, high, before = np.where(beyond, middle, low), np.where(beyond, high, middle), beyond
        if not np.any(np.abs(at_middle) > _TOLERANCE):
            break
    return middle
