"""Gradient descent with the steps of Barzilai and Borwein, kept to densities above zero."""

from __future__ import annotations

from collections import deque

import numpy as np

from ...progress import Progress
from ..system import System
from .loop import iterate, within_bounds
from .options import Reconstruction, Settings
from .smoothness import LeastSquares

#: Objectives looked back on, and the least share of the promised descent
#: (Birgin, Martínez & Raydan 2000, doi:10.1137/S1052623497330963).
_MEMORY = 10
_DESCENT = 1e-4

#: Relative change of the model that ends the search.
_TOLERANCE = 1e-6


def solve(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the model of least squares, smoothed by differences of neighbours.

    Spectral projected gradient: the step is ‖Δx‖²/ΔxᵀHΔx (Barzilai & Borwein 1988,
    doi:10.1093/imanum/8.1.141), cut where the objective would rise above its last ten values.
    Without a penalty it follows the noise, if it is not stopped by the data's errors.
    """
    problem = LeastSquares.of(system, settings.regularization)
    recent: deque[float] = deque(maxlen=_MEMORY)
    length: list[float] = []

    def step(x: np.ndarray, residual: np.ndarray) -> np.ndarray:
        slope = problem.slope(x, residual)
        recent.append(problem.value(x, residual))
        if not length:
            length.append(_ratio(float(slope @ slope), problem.curvature_along(slope)))
        move = within_bounds(x - length[-1] * slope, settings) - x
        curvature, promise = problem.curvature_along(move), float(slope @ move)
        reached = recent[-1] + promise + 0.5 * curvature
        # 0/0 is an optimum: nothing moves, so that the step stays as it was.
        if curvature > 0:
            length[0] = _ratio(float(move @ move), curvature)
            if reached > max(recent) + _DESCENT * promise:
                move *= min(1.0, -promise / curvature)
        return x + move

    return iterate(
        system, settings, progress, step,
        objective=problem.value, discrepancy=not settings.regularization, tolerance=_TOLERANCE,
    )  # fmt: skip


def _ratio(above: float, below: float) -> float:
    """Return a quotient; 0 where nothing is left to descend."""
    return above / below if below > 0 else 0.0
