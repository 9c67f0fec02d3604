"""Data against priors: solutions in the space of the data, whose number is the smaller one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...progress import Progress, report, silent
from ..lattice import Lattice


@dataclass(frozen=True)
class Field:
    """Values on a lattice with a correlated Gaussian prior, and what the data say of them."""

    lattice: Lattice
    #: Products with the prior's covariance (`Lattice.covariance`).
    covariance: Any
    #: (n_data, n) CSR: the data's derivatives, over their errors.
    jacobian: Any
    deviation: float


@dataclass(frozen=True)
class DataSpace:
    """K = 1 + Σ G C Gᵀ + U D Uᵀ, the data's covariance before any datum, over their errors.

    Tarantola 2005 (doi:10.1137/1.9780898717921), section 3.2: from K⁻¹ follow the densities,
    x = C Gᵀ K⁻¹ r, and their errors. Nothing here is of the size of the voxels squared.

    Parameters
    ----------
    fields
        Voxels, and the terrain where it is uncertain.
    columns
        (n_data, n_others) U, the data's derivatives over single numbers, over their errors.
    deviations
        (n_others,) prior standard deviations √D of these.
    """

    fields: Sequence[Field]
    columns: np.ndarray
    deviations: np.ndarray

    @property
    def size(self) -> int:
        """Number of data."""
        return len(self.columns)

    def spread(self, values: np.ndarray) -> tuple[list[np.ndarray], np.ndarray]:
        """Return C Gᵀ values of each field, and D Uᵀ values of the single numbers."""
        return (
            [field.covariance(field.jacobian.T @ values) for field in self.fields],
            self.deviations**2 * (self.columns.T @ values),
        )

    def predicted(self, fields: Sequence[np.ndarray], others: np.ndarray) -> np.ndarray:
        """Return G x + U θ, (n_data,)."""
        total = self.columns @ others
        for field, values in zip(self.fields, fields):
            total = total + field.jacobian @ values
        return np.asarray(total)

    def product(self, values: np.ndarray) -> np.ndarray:
        """Return K values."""
        return values + self.predicted(*self.spread(values))

    def solve(
        self,
        target: np.ndarray,
        iterations: int,
        accuracy: float,
        start: np.ndarray | None = None,
        progress: Progress = silent,
    ) -> tuple[np.ndarray, int, bool]:
        """Return K⁻¹ target by conjugate gradients, the iterations, and whether they sufficed.

        Hestenes & Stiefel 1952 (doi:10.6028/jres.049.044). One product with the covariance an
        iteration, where least squares on the voxels would take two.

        Parameters
        ----------
        target
            (n_data,).
        iterations
            Most of them.
        accuracy
            Residual over the size of the target that is small enough to end at.
        start
            What to begin with; None for 0.
        progress
            Told the share done.

        Raises
        ------
        Cancelled
            If the receiver of the progress asks for a stop.
        """
        value = np.zeros(self.size) if start is None else start.copy()
        residual = target - self.product(value) if start is not None else target.copy()
        direction, square = residual.copy(), float(residual @ residual)
        enough = (accuracy**2) * float(target @ target)
        for done in range(iterations):
            if square <= enough:
                return value, done, True
            report(progress, done / iterations)
            image = self.product(direction)
            step = square / float(direction @ image)
            value += step * direction
            residual -= step * image
            before, square = square, float(residual @ residual)
            direction = residual + (square / before) * direction
        return value, iterations, square <= enough
