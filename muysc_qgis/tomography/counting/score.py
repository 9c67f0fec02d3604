"""Whether counts show a body: how many standard errors, and how often chance does as much."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...progress import Progress, silent
from ..libraries import scipy_part
from .posterior import Posterior
from .space import DataSpace


@dataclass(frozen=True)
class ScoreTest:
    """Scores of bodies at several places, against a mountain without any.

    The score is g·K⁻¹r/√(g·K⁻¹g), with the residuals r and what a body changes g, both over
    the errors, and K the covariance of counting, factors, boresights and terrain: of a standard
    normal distribution if there is no body (Rao 1948, doi:10.1017/S0305004100023987).
    """

    #: L⁻¹ with K = L Lᵀ, and L⁻¹ g over its length, (n_data, n_places).
    posterior: Posterior
    templates: np.ndarray

    @classmethod
    def of(cls, space: DataSpace, changes: np.ndarray, progress: Progress = silent) -> ScoreTest:
        """Return the test.

        Parameters
        ----------
        space
            Data against all that is uncertain but the densities.
        changes
            (n_data, n_places) what each body adds to the counts, over their errors.
        progress
            Told the share done.

        Raises
        ------
        MuyscError
            If there are more than 10 000 data.
        Cancelled
            If the receiver of the progress asks for a stop.
        """
        posterior = Posterior.of(space, progress)
        found = posterior.solved(changes)
        length = np.linalg.norm(found, axis=0)
        return cls(posterior, found / np.where(length > 0, length, np.inf))

    def scores(self, residual: np.ndarray) -> np.ndarray:
        """Return the score of each body for residuals over their errors, (n_places,)."""
        return np.asarray(self.templates.T @ self.posterior.solved(residual))


def elsewhere(score: float, places: float) -> float:
    """Return the standard errors that a score is worth where it was looked for in many places.

    Parameters
    ----------
    score
        Largest score.
    places
        Number of places that are independent of each other, 1 or more.
    """
    normal = scipy_part("stats").norm
    tail = float(normal.logsf(score))
    if tail < -600:
        # Beyond the smallest number, where the tail is that of exp(−score²/2).
        return float(np.sqrt(max(score**2 - 2 * np.log(places), 0.0)))
    # 1 − (1 − p)^N, of a chance p that may be nearly 1 or nearly 0.
    chance = min(float(np.exp(tail)), 1 - 1e-12)
    return float(normal.isf(-np.expm1(places * np.log1p(-chance))))
