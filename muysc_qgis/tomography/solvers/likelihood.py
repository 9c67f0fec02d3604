"""MLEM, OSEM and penalised likelihood with quadratic and hybrid penalties."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ...progress import Progress
from ..lattice import Lattice
from ..operators import Projector
from ..system import System
from .loop import inverse, iterate, level, within_bounds
from .options import Reconstruction, Settings
from .order import dealt

#: Smallest start relative to its mean: what is zero stays zero under multiplication.
_LEAST = 1e-6


def solve_mlem(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the most likely model if data were Poisson counts: x *= Aᵀ(w b/Ax) / Aᵀw.

    Shepp & Vardi 1982 (doi:10.1109/TMI.1982.4307558). Densities stay positive, and the divergence
    of Kullback and Leibler between data and model falls at every step.
    """
    return _solve(system, settings, progress, subsets=1, penalty=None)


def solve_osem(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the model after sweeps of MLEM's step by subsets of rays.

    Hudson & Larkin 1994 (doi:10.1109/42.363108), rescaled after Byrne 1996 (IEEE Transactions on
    Image Processing 5, 792) so that a subset counts less in a voxel that others see better:
    xⱼ += xⱼ (Aᵀ(w b/Ax) − Aᵀw)ⱼ / maxₛ (Aₛᵀwₛ)ⱼ, which for alike subsets is the plain step.
    """
    return _solve(system, settings, progress, settings.subsets, penalty=None)


def solve_pml_quad(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the model of largest likelihood less β Σ w ½Δ² over neighbours (`_penalised`)."""
    return _solve(system, settings, progress, 1, _penalty(system, settings, None))


def solve_pml_hybrid(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the same with φ(Δ) = δ²(|Δ|/δ − ln(1 + |Δ|/δ)), which spares edges (`_penalised`)."""
    penalty = _penalty(system, settings, settings.edge_density)
    return _solve(system, settings, progress, 1, penalty)


def solve_ospml_quad(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return `solve_pml_quad`'s model by subsets of rays."""
    penalty = _penalty(system, settings, None)
    return _solve(system, settings, progress, settings.subsets, penalty)


def solve_ospml_hybrid(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return `solve_pml_hybrid`'s model by subsets of rays."""
    penalty = _penalty(system, settings, settings.edge_density)
    return _solve(system, settings, progress, settings.subsets, penalty)


@dataclass(frozen=True)
class _Penalty:
    """Differences between neighbours, and what they cost."""

    low: np.ndarray
    high: np.ndarray
    #: (n_pairs,) strength times weight.
    strength: np.ndarray
    #: Step from which the cost goes over to linear; `None`: quadratic.
    edge: float | None

    @classmethod
    def on(cls, lattice: Lattice, strength: float, edge: float | None) -> _Penalty:
        low, high, weight = lattice.pairs()
        return cls(low, high, strength * weight, edge)

    def value(self, x: np.ndarray) -> float:
        step = np.abs(x[self.high] - x[self.low])
        if self.edge is None:
            return float(np.sum(self.strength * 0.5 * step**2))
        ratio = step / self.edge
        return float(np.sum(self.strength * self.edge**2 * (ratio - np.log1p(ratio))))

    def parabola(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return per unknown Σ ω and Σ ω (xⱼ + xₖ), ω = φ'(Δ)/Δ: half the step's curvature."""
        strength = self.strength
        if self.edge is not None:
            strength = strength / (1.0 + np.abs(x[self.high] - x[self.low]) / self.edge)
        both = strength * (x[self.high] + x[self.low])
        weight, total = (
            np.bincount(self.low, some, len(x)) + np.bincount(self.high, some, len(x))
            for some in (strength, both)
        )
        return weight, total


def _penalty(system: System, settings: Settings, edge: float | None) -> _Penalty | None:
    """Return the penalty, its strength relative to the likelihood's mean curvature Aᵀw / x."""
    if not settings.regularization:
        return None
    curvature = float(np.mean(system.paths.back(system.weights()), dtype=float))
    strength = settings.regularization * curvature / level(settings.start)
    return _Penalty.on(system.lattice, strength, edge)


def _solve(
    system: System, settings: Settings, progress: Progress, subsets: int, penalty: _Penalty | None
) -> Reconstruction:
    weights = system.weights()
    data = np.maximum(system.data, 0.0)
    groups = dealt(system, settings, subsets)
    parts = [
        (rays, paths, paths.back(weights[rays]))
        for rays, paths in zip(groups, system.paths.grouped(groups))
    ]
    most = np.max([column for _, _, column in parts], axis=0).astype(float)

    def step(x: np.ndarray, residual: np.ndarray) -> np.ndarray:
        for rays, paths, column in parts:
            # The loop has just projected the model, which serves where all rays are one subset.
            model = paths.forward(x).astype(float) if len(parts) > 1 else system.data - residual
            # Each voxel's surrogate has one top, so that cutting it off keeps the ascent.
            x = within_bounds(_update(x, paths, weights[rays], data[rays], model, column), settings)
        return x

    def _update(
        x: np.ndarray, paths: Projector, weight: np.ndarray, some: np.ndarray,
        model: np.ndarray, column: np.ndarray,
    ) -> np.ndarray:  # fmt: skip
        gain = x * (paths.back(weight * some * inverse(model)) + np.maximum(most - column, 0))
        if penalty is None:
            # What no ray meets stays as it is.
            return np.where(most > 0, gain * inverse(most), x)
        return _penalised(x, gain, most, penalty, 1.0 / len(parts))

    def objective(x: np.ndarray, residual: np.ndarray) -> float:
        cost = _divergence(data, system.data - residual, weights)
        return cost + (penalty.value(x) if penalty is not None else 0.0)

    least = _LEAST * level(settings.start)
    positive = replace(settings, start=np.maximum(settings.start, least))
    return iterate(
        system, positive, progress, step,
        objective=objective, discrepancy=penalty is None,
    )  # fmt: skip


def _penalised(
    x: np.ndarray, gain: np.ndarray, column: np.ndarray, penalty: _Penalty, share: float
) -> np.ndarray:
    """Return the maximum of the separable surrogate of De Pierro 1995 (doi:10.1109/42.370409).

    For each unknown the positive root of 2 Ω x² + (C − Σ ω (xⱼ + xₖ)) x − e = 0, with e MLEM's
    numerator; the objective falls at every step.
    """
    weight, total = penalty.parabola(x)
    a, b = 2 * share * weight, column - share * total
    root = np.sqrt(b * b + 4 * a * gain)
    # Without cancellation for either sign of b.
    with np.errstate(divide="ignore", invalid="ignore"):
        result = np.where(b > 0, 2 * gain / (b + root), (root - b) / (2 * a))
    return np.where(np.isfinite(result), result, x)


def _divergence(data: np.ndarray, model: np.ndarray, weights: np.ndarray) -> float:
    """Return Σ w (m − b + b ln(b/m)), 0 where the model equals the data."""
    with np.errstate(divide="ignore", invalid="ignore"):
        logarithm = np.where(data > 0, data * np.log(data / model), 0.0)
    return float(np.sum(weights * (model - data + logarithm)))
