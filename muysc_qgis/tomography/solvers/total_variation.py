"""Least squares with total variation, which keeps the edges of bodies sharp."""

from __future__ import annotations

import numpy as np

from ...progress import Progress, report
from ..operators import Projector
from ..system import System
from .loop import inverse, iterate, level, within_bounds
from .options import Reconstruction, Settings
from .smoothness import LeastSquares, mean_curvature

#: Steps of the power iteration, and the margin for what it is short of the norm.
_POWER_STEPS = 25
_MARGIN = 1.02

#: Relative change of the model that ends the search.
_TOLERANCE = 1e-7


def norm(paths: Projector, weights: np.ndarray, seed: int = 1) -> float:
    """Return ‖W½ A‖₂ by power iteration, from below to a few thousandths.

    Parameters
    ----------
    paths, weights
        A, and the (n_rays,) diagonal of W.
    seed
        Of the vector that it begins with.
    """
    # The leading vector of a matrix without negative entries has none.
    x = np.random.default_rng(seed).uniform(0.5, 1.0, paths.shape[1])
    size = 0.0
    for _ in range(_POWER_STEPS):
        size = float(np.linalg.norm(x))
        if size == 0.0:
            return 0.0
        x = paths.back(weights * paths.forward(x / size)).astype(float)
    return float(np.sqrt(np.linalg.norm(x)))


def solve(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the minimum of ½ ‖W½(b − Ax)‖² + α Σ |∇x| over voxels, by Chambolle & Pock 2011.

    doi:10.1007/s10851-010-0251-1, algorithm 1; steps from ‖W½A‖₂ by power iteration and the bound
    on the norm of differences, both halves scaled to the same norm (Sidky, Jørgensen & Pan 2012,
    doi:10.1088/0031-9155/57/10/3065). α is the regularisation times the mean diagonal of AᵀWA
    times the start's mean density.
    """
    paths, weights, lattice = system.paths, system.weights(), system.lattice
    root = np.sqrt(weights)
    report(progress, 0.0)
    size = _MARGIN * norm(paths, weights, settings.seed)
    gradient = lattice.gradient()
    # ‖D‖₂² is at most 4 Σ w² over the axes, as each difference has two ends.
    middle = np.exp(np.mean(np.log(lattice.step_m)))
    steep = 2.0 * float(np.sqrt(sum((middle / step) ** 2 for step in lattice.step_m)))
    alpha = settings.regularization * mean_curvature(system, weights) * level(settings.start)
    problem = LeastSquares(system, weights, 0.0, None)

    # Everything in units in which ‖W½A‖ is 1; differences are scaled to the same norm.
    n_axes, count = len(lattice.step_m), lattice.count
    most = alpha / size**2 * steep
    # The norm of both together is at most √2, and its square times both steps at most 1.
    primal = dual = 2**-0.5
    data_multiplier = np.zeros(paths.shape[0])
    edge_multiplier = np.zeros((n_axes, count))
    last_x, last_residual = settings.start, system.data - paths.forward(settings.start)

    def step(x: np.ndarray, residual: np.ndarray) -> np.ndarray:
        nonlocal data_multiplier, edge_multiplier, last_x, last_residual
        # The extrapolation 2 xₙ − xₙ₋₁ holds for the residual too, which saves its projection.
        ahead, leap = 2 * residual - last_residual, 2 * x - last_x
        last_x, last_residual = x, residual
        data_multiplier = (data_multiplier - dual * root * ahead / size) / (1 + dual)
        edge_multiplier = edge_multiplier + dual / steep * (gradient @ leap).reshape(n_axes, count)
        length = np.sqrt(np.sum(edge_multiplier**2, axis=0))
        edge_multiplier = edge_multiplier * np.minimum(1.0, most * inverse(length))
        pull = paths.back(root * data_multiplier).astype(float) / size
        pull += gradient.T @ edge_multiplier.ravel() / steep
        return within_bounds(x - primal * pull, settings)

    def objective(x: np.ndarray, residual: np.ndarray) -> float:
        steps = np.sqrt(np.sum((gradient @ x).reshape(n_axes, count) ** 2, axis=0))
        return problem.value(x, residual) + alpha * float(np.sum(steps))

    return iterate(
        system, settings, progress, step,
        objective=objective, discrepancy=False, tolerance=_TOLERANCE,
    )  # fmt: skip
