"""What the least-squares methods share: the weighted misfit and a penalty on differences."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..system import System


@dataclass(frozen=True)
class LeastSquares:
    """½ ‖W½ (b − Ax)‖² + ½ β d ‖Dx‖², d the mean diagonal of AᵀWA.

    With that scale the strength β means the same whatever the units, the voxels and the rays: at
    β = 1 a difference of neighbours costs as much as the misfit of one voxel of average coverage.
    """

    system: System
    weights: np.ndarray
    #: β d.
    strength: float
    #: D, forward differences between neighbours, or `None` where the strength is 0.
    gradient: Any

    @classmethod
    def of(cls, system: System, regularization: float) -> LeastSquares:
        """Return the problem with a penalty of the given strength β."""
        weights = system.weights()
        strength = regularization * mean_curvature(system, weights)
        gradient = system.lattice.gradient() if strength else None
        return cls(system, weights, strength, gradient)

    def value(self, x: np.ndarray, residual: np.ndarray) -> float:
        """Return the objective."""
        misfit = 0.5 * float(np.sum(self.weights * residual**2))
        if self.gradient is None:
            return misfit
        return misfit + 0.5 * self.strength * float(np.sum(np.square(self.gradient @ x)))

    def slope(self, x: np.ndarray, residual: np.ndarray) -> np.ndarray:
        """Return the gradient of the objective."""
        slope = -self.system.paths.back(self.weights * residual).astype(float)
        if self.gradient is not None:
            slope += self.strength * (self.gradient.T @ (self.gradient @ x))
        return slope

    def curvature_along(self, step: np.ndarray) -> float:
        """Return stepᵀ H step with H the second derivatives of the objective."""
        projected = self.system.paths.forward(step).astype(float)
        curvature = float(np.sum(self.weights * projected**2))
        if self.gradient is not None:
            curvature += self.strength * float(np.sum(np.square(self.gradient @ step)))
        return curvature


def mean_curvature(system: System, weights: np.ndarray) -> float:
    """Return the mean of Σᵢ wᵢ aᵢⱼ² over the voxels that a ray meets."""
    squares = system.paths.column_squares(weights)
    return float(squares[squares > 0].mean()) if np.any(squares > 0) else 0.0
