"""Confidence intervals of counted muons and of ratios of counts."""

from __future__ import annotations

import numpy as np

#: Share of a normal distribution within one standard deviation of its mean.
ONE_SIGMA = 0.6826894921370859

#: Below this many counts the interval is exact; from here on it is that of a normal
#: distribution, because the exact one holds the truth more often than it says.
EXACT_BELOW = 20


def exact_interval(
    counts: np.ndarray, confidence: float = ONE_SIGMA
) -> tuple[np.ndarray, np.ndarray]:
    """Return the central confidence interval of a Poisson mean.

    Garwood (1936), doi:10.1093/biomet/28.3-4.437: the means for which N counts or more,
    and N or fewer, have the probability (1 − confidence)/2. It holds the truth at least
    as often as it says.

    Parameters
    ----------
    counts
        Number N of counts, whole numbers of 0 or more, any shape; NaN stays NaN.
    confidence
        Between 0 and 1.

    Returns
    -------
    lower, upper
        Means, the lower one 0 for no counts.
    """
    from scipy.special import gammaincinv

    # Many pixels share few counts, and each inverse takes long.
    counts, pixel = _distinct(counts)
    tail = (1.0 - confidence) / 2.0
    # A Poisson sum is an incomplete gamma function of its mean.
    lower = gammaincinv(np.where(counts > 0, counts, np.nan), tail)
    lower = np.where(counts == 0, 0.0, lower)
    return lower[pixel], gammaincinv(counts + 1.0, 1.0 - tail)[pixel]


def upper_limit(counts: np.ndarray, confidence: float) -> np.ndarray:
    """Return the mean that is not exceeded at a one-sided confidence.

    Parameters
    ----------
    counts
        Number N of counts, any shape.
    confidence
        Between 0 and 1; no counts at 0.95 give the familiar −ln 0.05 = 3.0.
    """
    from scipy.special import gammaincinv

    counts, pixel = _distinct(counts)
    return np.asarray(gammaincinv(counts + 1.0, confidence)[pixel])


def exact_ratio_interval(
    counts: np.ndarray, reference: np.ndarray, confidence: float = ONE_SIGMA
) -> tuple[np.ndarray, np.ndarray]:
    """Return the central confidence interval of the ratio of two Poisson means.

    Given the sum of the counts, the first is binomial with p = r/(1 + r); the interval
    of p is that of Clopper & Pearson (1934), doi:10.1093/biomet/26.4.404.

    Parameters
    ----------
    counts, reference
        Whole numbers of 0 or more; arrays that broadcast.
    confidence
        Between 0 and 1.

    Returns
    -------
    lower, upper
        Ratios, the lower one 0 for no counts and the upper one infinite for none of
        the reference.
    """
    from scipy.special import betaincinv

    counts, reference = np.broadcast_arrays(
        np.asarray(counts, dtype=float), np.asarray(reference, dtype=float)
    )
    tail = (1.0 - confidence) / 2.0
    known = ~(np.isnan(counts) | np.isnan(reference))
    some, some_reference = known & (counts > 0), known & (reference > 0)
    lower = betaincinv(np.where(some, counts, np.nan), reference + 1.0, tail)
    upper = betaincinv(counts + 1.0, np.where(some_reference, reference, np.nan), 1.0 - tail)
    lower = np.where(known & (counts == 0), 0.0, lower)
    upper = np.where(known & (reference == 0), np.inf, upper / (1.0 - upper))
    return lower / (1.0 - lower), upper


def ratio_upper_limit(counts: np.ndarray, reference: np.ndarray, confidence: float) -> np.ndarray:
    """Return the ratio of two Poisson means that is not exceeded at a one-sided confidence."""
    # The upper end of a central interval leaves half of what is outside above it.
    return exact_ratio_interval(counts, reference, 2.0 * confidence - 1.0)[1]


def logarithmic_errors(
    counts: np.ndarray, reference: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Return how far one standard deviation reaches from a rate or ratio, in its logarithm.

    Parameters
    ----------
    counts
        Number N of counts, any shape.
    reference
        Counts that they are divided by, None for an exactly known exposure.

    Returns
    -------
    down, up
        ln of the estimate over the lower end, and of the upper end over the estimate:
        N^-1/2 (with that of the reference in quadrature) from `EXACT_BELOW` counts on, else
        from the exact intervals. NaN where there are no counts.
    """
    counts = np.asarray(counts, dtype=float)
    some = np.where(counts > 0, counts, np.nan)
    if reference is None:
        few = counts < EXACT_BELOW
        normal = 1.0 / np.sqrt(some)
        lower, upper = exact_interval(np.where(few, some, np.nan))
        estimate = some
    else:
        reference = np.asarray(reference, dtype=float)
        some_reference = np.where(reference > 0, reference, np.nan)
        few = (counts < EXACT_BELOW) | (reference < EXACT_BELOW)
        normal = np.sqrt(1.0 / some + 1.0 / some_reference)
        lower, upper = exact_ratio_interval(np.where(few, some, np.nan), some_reference)
        estimate = some / some_reference
    # Of next to no count, as may be expected but not counted, there is no lower end.
    with np.errstate(divide="ignore", over="ignore"):
        return (
            np.where(few, np.log(estimate / lower), normal),
            np.where(few, np.log(upper / estimate), normal),
        )


def _distinct(counts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the distinct counts, and which of them each pixel has, in the pixels' shape."""
    counts = np.asarray(counts, dtype=float)
    distinct, pixel = np.unique(counts, return_inverse=True)
    return distinct, pixel.reshape(counts.shape)
