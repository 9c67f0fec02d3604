"""How far counts are from what is expected, and how far they should be."""

from __future__ import annotations

import numpy as np

#: Expected counts from which the series holds to 2·10⁻³; below, all counts are summed over.
_MANY = 12.0
_MOST = 64


def deviance(counts: np.ndarray, expected: np.ndarray) -> np.ndarray:
    """Return 2 (n ln(n/μ) − n + μ), what a count contributes to twice the log-likelihood lost.

    Parameters
    ----------
    counts, expected
        (n,) n, 0 or more, and μ, above 0.
    """
    ratio = np.where(counts > 0, counts / expected, 1.0)
    return 2.0 * (counts * np.log(ratio) - counts + expected)


def expected_deviance(expected: np.ndarray) -> np.ndarray:
    """Return the mean of the deviance of Poisson counts with the expectation μ.

    1 + 1/(6μ) + 1/(6μ²) for many counts, and towards 0 where hardly any is expected: so a sum
    over data of few counts is compared with what it should be, where (n − μ)²/μ would be 1 on the
    mean and anything in a sample.

    Parameters
    ----------
    expected
        (n,) μ, above 0.
    """
    expected = np.asarray(expected, float)
    result = 1.0 + 1.0 / (6.0 * expected) + 1.0 / (6.0 * expected**2)
    few = expected < _MANY
    mean = expected[few]
    probability = np.exp(-mean)
    total = 2.0 * mean * probability
    for count in range(1, _MOST):
        probability = probability * mean / count
        total += probability * deviance(np.full(mean.shape, float(count)), mean)
    result[few] = total
    return result
