"""Damped least squares by LSMR: Tikhonov's smooth model, and the one nearest to the start."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...progress import Progress, report
from ..system import System
from .least_squares import solve_linear
from .loop import within_bounds
from .options import Reconstruction, Settings, misfit
from .smoothness import LeastSquares, mean_curvature


def solve_tikhonov(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the minimum of ½ ‖W½(b − Ax)‖² + ½ β d ‖Dx‖², D the differences of neighbours.

    Tikhonov 1963, solved as one stacked system by LSMR. Densities beyond the bounds are brought
    back to them afterwards.
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
    paths, root = system.paths, np.sqrt(system.weights())
    n_rays, n_unknowns = paths.shape
    scale = np.sqrt(strength)
    start = settings.start
    residual = system.data - paths.forward(start)

    def forward(x: np.ndarray) -> np.ndarray:
        top = root * paths.forward(x)
        return top if gradient is None else np.concatenate([top, scale * (gradient @ x)])

    def back(y: np.ndarray) -> np.ndarray:
        result = paths.back(root * y[:n_rays]).astype(float)
        return result if gradient is None else result + scale * (gradient.T @ y[n_rays:])

    target = root * residual
    if gradient is not None:
        target = np.concatenate([target, -scale * (gradient @ start)])
    # Undamped, the residual that the errors explain ends the iteration.
    enough = 0.0
    if not strength and system.errors is not None:
        before = misfit(system, residual)
        enough = settings.discrepancy / before if before > 0 else 1.0
    change, done, finished = solve_linear(
        forward, back, target, n_unknowns, settings.iterations, progress,
        damp=scale if gradient is None else 0.0, enough=enough,
    )  # fmt: skip
    report(progress, 1.0)
    values = within_bounds(start + change, settings)
    after = system.data - paths.forward(values)
    stopped_by = "iterations" if not finished else "discrepancy" if enough else "converged"
    return Reconstruction(
        values, done, stopped_by,
        np.array([misfit(system, residual), misfit(system, after)]),
    )  # fmt: skip
