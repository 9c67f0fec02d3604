"""Damped least squares by LSMR: Tikhonov's smooth model, and the one nearest to the start."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...progress import Progress, report
from ..libraries import scipy_part
from ..system import System
from .loop import within_bounds
from .options import Reconstruction, Settings, misfit
from .smoothness import LeastSquares, mean_curvature

#: Relative accuracy of the solution: what float32 lengths can carry.
_ACCURACY = 1e-6


def solve_tikhonov(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the minimum of ½ ‖W½(b − Ax)‖² + ½ β d ‖Dx‖², D the differences of neighbours.

    Tikhonov 1963, solved as one stacked system by LSMR (Fong & Saunders 2011,
    doi:10.1137/10079687X). Densities beyond the bounds are brought back to them afterwards.
    """
    problem = LeastSquares.of(system, settings.regularization)
    return _solve(system, settings, progress, problem.strength, problem.gradient)


def solve_lsmr(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the minimum of ½ ‖W½(b − Ax)‖² + ½ β d ‖x − x₀‖², x₀ the start.

    Damped LSMR; with β = 0 it is stopped by the data's errors where they are known. Densities
    beyond the bounds are brought back to them afterwards.
    """
    strength = settings.regularization * mean_curvature(system, system.weights())
    return _solve(system, settings, progress, strength, None)


def _solve(
    system: System, settings: Settings, progress: Progress, strength: float, gradient: Any
) -> Reconstruction:
    linear = scipy_part("sparse.linalg")
    paths, root = system.paths, np.sqrt(system.weights())
    n_rays, n_unknowns = paths.shape
    n_extra = 0 if gradient is None else gradient.shape[0]
    scale = np.sqrt(strength)
    start = settings.start
    residual = system.data - paths.forward(start)
    products = [0]

    def forward(x: np.ndarray) -> np.ndarray:
        products[0] += 1
        report(progress, min(1.0, products[0] / (settings.iterations + 1)))
        top = root * paths.forward(x)
        return top if gradient is None else np.concatenate([top, scale * (gradient @ x)])

    def back(y: np.ndarray) -> np.ndarray:
        result = paths.back(root * y[:n_rays]).astype(float)
        return result if gradient is None else result + scale * (gradient.T @ y[n_rays:])

    operator = linear.LinearOperator(
        (n_rays + n_extra, n_unknowns), matvec=forward, rmatvec=back, dtype=float
    )
    target = root * residual
    if gradient is not None:
        target = np.concatenate([target, -scale * (gradient @ start)])
    # Undamped, the residual that the errors explain ends the iteration.
    enough = 0.0
    if not strength and system.errors is not None:
        before = misfit(system, residual)
        enough = settings.discrepancy / before if before > 0 else 1.0
    change, reason, done = linear.lsmr(
        operator, target, damp=scale if gradient is None else 0.0, atol=_ACCURACY,
        btol=max(enough, _ACCURACY), conlim=0, maxiter=settings.iterations,
    )[:3]  # fmt: skip
    report(progress, 1.0)
    values = within_bounds(start + change, settings)
    after = system.data - paths.forward(values)
    stopped_by = "iterations" if reason == 7 else "discrepancy" if enough else "converged"
    return Reconstruction(
        values, int(done), stopped_by,
        np.array([misfit(system, residual), misfit(system, after)]),
    )  # fmt: skip
