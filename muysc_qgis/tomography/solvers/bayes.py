"""The mean of the densities given data and a Gaussian prior, and how sure they are."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...errors import MuyscError
from ...progress import Progress, part, report
from ..libraries import scipy_part
from ..system import System
from .least_squares import solve_linear
from .options import Reconstruction, Settings, misfit

#: Most rays for which the posterior's errors are computed in full.
_MOST_DENSE = 2000

#: Most numbers of the dense matrices of the full computation.
_MOST_NUMBERS = 1 << 25


def solve(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return ρ₀ + C Aᵀ (A C Aᵀ + Σ)⁻¹ (b − A ρ₀) with C = σρ² exp(−d/ℓ), Σ the data's variances.

    Tarantola 2005 (doi:10.1137/1.9780898717921), section 3.2. Densities are not kept within
    bounds, which no Gaussian is. The posterior's standard deviations follow in full for up to
    2000 rays; for more, from draws of prior and data if asked for: the error of each draw's
    solution is a draw of the posterior, so that n draws give deviations to a relative 1/√(2n).

    Raises
    ------
    MuyscError
        If the errors of the data are not known.
    """
    if system.errors is None:
        raise MuyscError(
            "The Bayesian method weighs data against the prior, so it needs the standard errors of "
            "the data, which are missing; give them or choose another method."
        )
    posterior = _Posterior.of(system, settings)
    prior = (
        settings.start
        if settings.prior_density is None
        else np.full(system.lattice.count, settings.prior_density)
    )
    residual = system.data - system.paths.forward(prior)
    n_rays, n_unknowns = system.paths.shape
    small = n_rays <= _MOST_DENSE and n_rays * n_unknowns <= _MOST_NUMBERS
    draws = settings.posterior_samples if settings.deviation and not small else 0
    share = 1.0 / (1 + draws)
    change, done, finished = posterior.update(residual, part(progress, 0.0, share))
    deviation = None
    if settings.deviation and small:
        deviation = posterior.full_deviation()
    elif draws:
        deviation = posterior.sampled_deviation(draws, part(progress, share, 1.0))
    report(progress, 1.0)
    values = prior + change
    after = system.data - system.paths.forward(values)
    return Reconstruction(
        values, done, "converged" if finished else "iterations",
        np.array([misfit(system, residual), misfit(system, after)]), deviation=deviation,
    )  # fmt: skip


@dataclass(frozen=True)
class _Posterior:
    """A, C and Σ, with the data in units of their errors."""

    system: System
    settings: Settings
    covariance: Any
    #: (n_rays,) 1/σ.
    scale: np.ndarray

    @classmethod
    def of(cls, system: System, settings: Settings) -> _Posterior:
        covariance = system.lattice.covariance(
            settings.prior_deviation, settings.correlation_length_m
        )
        errors = np.asarray(system.errors, float)
        return cls(system, settings, covariance, 1.0 / errors)

    def update(self, residual: np.ndarray, progress: Progress) -> tuple[np.ndarray, int, bool]:
        """Return C Aᵀ (A C Aᵀ + Σ)⁻¹ residual, the iterations, and whether they sufficed.

        With C = B Bᵀ it is B z for the z that minimises ‖Σ^-½ (residual − A B z)‖² + ‖z‖². LSMR
        lowers that from the first step on, so that too few of them leave a smoother model.
        """
        paths, scale = self.system.paths, self.scale

        def forward(z: np.ndarray) -> np.ndarray:
            return scale * paths.forward(self.covariance.root(z))

        def back(y: np.ndarray) -> np.ndarray:
            return self.covariance.root_transposed(paths.back(scale * y))

        solution, done, finished = solve_linear(
            forward, back, scale * residual, self.covariance.root_size, self.settings.iterations,
            progress, damp=1.0,
        )  # fmt: skip
        return self.covariance.root(solution), done, finished

    def full_deviation(self) -> np.ndarray:
        """Return √diag(C − C Aᵀ (A C Aᵀ + Σ)⁻¹ A C)."""
        linalg = scipy_part("linalg")
        paths, scale = self.system.paths, self.scale
        rows = np.concatenate([block.toarray() for _, block in paths.blocks()]).astype(float)
        rows *= scale[:, None]
        spread = np.stack([self.covariance(row) for row in rows])
        inner = spread @ rows.T
        inner[np.diag_indices_from(inner)] += 1.0
        factor = linalg.cholesky(0.5 * (inner + inner.T), lower=True)
        half = linalg.solve_triangular(factor, spread, lower=True)
        variance = self.settings.prior_deviation**2 - np.sum(half**2, axis=0)
        return np.sqrt(np.maximum(variance, 0.0))

    def sampled_deviation(self, draws: int, progress: Progress) -> np.ndarray:
        """Return the standard deviations of draws from the posterior."""
        generator = np.random.default_rng(self.settings.seed)
        paths = self.system.paths
        square = np.zeros(paths.shape[1])
        for draw in range(draws):
            truth = self.covariance.root(generator.standard_normal(self.covariance.root_size))
            noise = generator.standard_normal(paths.shape[0]) / self.scale
            share = part(progress, draw / draws, (draw + 1) / draws)
            estimate, _, _ = self.update(paths.forward(truth) + noise, share)
            square += (truth - estimate) ** 2
        return np.sqrt(square / draws)
