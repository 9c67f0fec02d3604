"""Linear least squares by LSMR, told and stopped as the other methods are."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...progress import Progress, report
from ..libraries import scipy_part

#: Relative accuracy of the solution: what float32 lengths can carry.
_ACCURACY = 1e-6

#: How scipy's LSMR says that the iterations were used up.
_USED_UP = 7


def solve_linear(
    forward: Callable[[np.ndarray], np.ndarray],
    back: Callable[[np.ndarray], np.ndarray],
    target: np.ndarray,
    count: int,
    iterations: int,
    progress: Progress,
    *,
    damp: float = 0.0,
    enough: float = 0.0,
) -> tuple[np.ndarray, int, bool]:
    """Return the minimum of ‖A x − b‖² + damp² ‖x‖², the iterations, and whether they sufficed.

    Fong & Saunders 2011 (doi:10.1137/10079687X), begun at 0.

    Parameters
    ----------
    forward, back
        Products with A and Aᵀ.
    target
        (n,) b.
    count
        Length of x.
    iterations
        Most of them.
    progress
        Told the share done at each product with A.
    damp
        Weight of the size of x.
    enough
        Residual over the size of b that is small enough to end at.

    Raises
    ------
    MuyscError
        If scipy is missing.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    linear = scipy_part("sparse.linalg")
    products = 0

    def told(x: np.ndarray) -> np.ndarray:
        nonlocal products
        products += 1
        report(progress, min(1.0, products / (iterations + 1)))
        return forward(x)

    operator = linear.LinearOperator((len(target), count), matvec=told, rmatvec=back, dtype=float)
    solution, reason, done = linear.lsmr(
        operator, target, damp=damp, atol=_ACCURACY, btol=max(enough, _ACCURACY), conlim=0,
        maxiter=iterations,
    )[:3]  # fmt: skip
    return solution, int(done), reason != _USED_UP
