"""How sure densities are, exactly: in blocks of voxels, in memory of the data squared."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...errors import MuyscError
from ...progress import Progress, part, report, silent
from ..libraries import scipy_part
from .space import DataSpace, Field

#: Most data whose errors are computed: K takes 800 MB then.
MOST_DATA = 10_000

#: Random vectors for the trace of K⁻¹.
_PROBES = 32

#: Numbers of a block of the prior's covariance; bounds the memory.
_BLOCK = 1 << 23


@dataclass(frozen=True)
class Posterior:
    """The factor L of K = L Lᵀ, from which all errors follow."""

    space: DataSpace
    factor: np.ndarray

    @staticmethod
    def check(data: int) -> None:
        """Refuse data whose covariance would not fit.

        Raises
        ------
        MuyscError
            If there are more than 10 000.
        """
        if data > MOST_DATA:
            raise MuyscError(
                f"Errors of densities are computed from up to {MOST_DATA} data, and there are "
                f"{data}; merge trajectories, or leave the errors out."
            )

    @classmethod
    def of(cls, space: DataSpace, progress: Progress = silent) -> Posterior:
        """Return it for a linear problem.

        Parameters
        ----------
        space
            Data against priors.
        progress
            Told the share done.

        Raises
        ------
        MuyscError
            If there are too many data.
        Cancelled
            If the receiver of the progress asks for a stop.
        """
        cls.check(space.size)
        linalg = scipy_part("linalg")
        whole = (space.columns * space.deviations**2) @ space.columns.T
        count = len(space.fields)
        for number, field in enumerate(space.fields):
            share = part(progress, number / count, 0.95 * (number + 1) / count)
            for chosen, rows in _blocks(field, share):
                whole += (field.jacobian[:, chosen] @ rows.T).T
        whole[np.diag_indices_from(whole)] += 1.0
        whole = 0.5 * (whole + whole.T)
        factor = linalg.cholesky(whole, lower=True, overwrite_a=True, check_finite=False)
        report(progress, 1.0)
        return cls(space, factor)

    def deviation(self, bend: np.ndarray, progress: Progress = silent) -> np.ndarray:
        """Return the standard errors of the densities, mean and deviations together.

        √(aᵀ (C − C Gᵀ K⁻¹ G C) a), with the mean density as one of the unknowns.

        Parameters
        ----------
        bend
            (n_unknowns,) derivative of densities over what the prior is of.
        progress
            Told the share done.

        Raises
        ------
        Cancelled
            If the receiver of the progress asks for a stop.
        """
        field, mean = self.space.fields[0], self.space.deviations[0] ** 2
        shared = mean * self.space.columns[:, :1]
        prior = field.deviation**2 + mean
        result = np.empty(field.lattice.count)
        for chosen, rows in _blocks(field, progress):
            half = self.solved(rows + shared)
            result[chosen] = prior - np.sum(half**2, axis=0)
        return bend * np.sqrt(np.maximum(result, 0.0))

    def others(self) -> np.ndarray:
        """Return the standard errors of the single numbers."""
        deviations = self.space.deviations
        half = self.solved(self.space.columns * deviations)
        return deviations * np.sqrt(np.maximum(1.0 - np.sum(half**2, axis=0), 0.0))

    def parameters(self) -> float:
        """Return how many numbers the data settle rather than the prior: n − tr K⁻¹.

        By Hutchinson's estimate of the trace (1990, doi:10.1080/03610919008812866).
        """
        generator = np.random.default_rng(0)
        noise = generator.choice([-1.0, 1.0], (self.space.size, _PROBES))
        return float(self.space.size - np.sum(self.solved(noise) ** 2) / _PROBES)

    def solved(self, columns: np.ndarray) -> np.ndarray:
        """Return L⁻¹ columns."""
        linalg: Any = scipy_part("linalg")
        return np.asarray(
            linalg.solve_triangular(self.factor, columns, lower=True, check_finite=False)
        )


def _blocks(field: Field, progress: Progress) -> Iterator[tuple[slice, np.ndarray]]:
    """Yield blocks of unknowns and G C of them, (n_data, n_block)."""
    kernel = field.covariance.kernel()
    cells = [axis.astype(np.int32) for axis in np.nonzero(field.lattice.active)]
    count = field.lattice.count
    width = max(1, _BLOCK // max(count, 1))
    for first in range(0, count, width):
        report(progress, first / count)
        chosen = slice(first, min(first + width, count))
        apart = tuple(np.abs(axis[:, None] - axis[None, chosen]) for axis in cells)
        yield chosen, field.jacobian @ kernel[apart]
    report(progress, 1.0)
