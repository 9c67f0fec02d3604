"""Neighbourhoods of the unknowns: which are side by side, and how they go together."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import MuyscError
from .libraries import scipy_part
from .voxels import VoxelGrid

#: Correlation lengths kept between a volume and its periodic image (exp(−4) = 2 %).
_APART = 4.0

#: Standard deviations (g/cm³) and correlation lengths (m) whose squares and shares are numbers.
_PRIOR_RANGE = (1e-6, 1e9)


@dataclass(frozen=True)
class Lattice:
    """Unknowns on a regular grid of one to three axes, of which some cells may be missing.

    Parameters
    ----------
    step_m
        Distance of neighbours along each axis.
    active
        Array of bool over the grid: which cells are unknowns, in C order.
    """

    step_m: tuple[float, ...]
    active: np.ndarray

    @classmethod
    def of(cls, grid: VoxelGrid, active: np.ndarray | None = None) -> Lattice:
        """Return the lattice of a volume, all of it or its active voxels."""
        return cls(grid.size_m, np.ones(grid.shape, bool) if active is None else active)

    @property
    def count(self) -> int:
        """Number of unknowns."""
        return int(np.count_nonzero(self.active))

    def expand(self, values: np.ndarray, missing: float = math.nan) -> np.ndarray:
        """Return unknowns as an array over the grid, `missing` where there is none."""
        result = np.full(self.active.shape, missing)
        result[self.active] = values
        return result

    def _neighbours(self) -> list[tuple[np.ndarray, np.ndarray, float]]:
        """Return for each axis the pairs of neighbouring unknowns and their weight."""
        number = np.full(self.active.shape, -1, np.int64)
        number[self.active] = np.arange(self.count)
        middle = float(np.exp(np.mean(np.log(self.step_m))))
        found = []
        for axis, step in enumerate(self.step_m):
            low = number.take(np.arange(number.shape[axis] - 1), axis=axis).ravel()
            high = number.take(np.arange(1, number.shape[axis]), axis=axis).ravel()
            both = (low >= 0) & (high >= 0)
            found.append((low[both], high[both], middle / step))
        return found

    def pairs(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return both unknowns of each pair of neighbours, and its weight.

        The weight is the square of the mean step over the pair's, so that a sum over pairs of
        w Δ² stands for the same gradient whatever the shape of the voxels.
        """
        low, high, weight = zip(*self._neighbours())
        return (
            np.concatenate(low),
            np.concatenate(high),
            np.concatenate([np.full(len(some), w * w) for some, w in zip(low, weight)]),
        )

    def gradient(self) -> Any:
        """Return forward differences as a CSR matrix (n_axes · count, count), axis by axis.

        In the units of the unknowns per mean step; a row is empty where there is no neighbour.
        """
        sparse = scipy_part("sparse")
        count = self.count
        rows, columns, values = [], [], []
        for axis, (low, high, weight) in enumerate(self._neighbours()):
            rows += [axis * count + low, axis * count + low]
            columns += [high, low]
            values += [np.full(len(low), weight), np.full(len(low), -weight)]
        return sparse.csr_matrix(
            (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
            shape=(len(self.step_m) * count, count),
        )

    def covariance(self, deviation: float, length_m: float) -> _Covariance:
        """Return σ² exp(−d/ℓ) between the unknowns, as functions.

        Raises
        ------
        MuyscError
            If the standard deviation or the length is too small or too large to reckon with.
        """
        least, most = _PRIOR_RANGE
        if not (least <= deviation <= most and least <= length_m <= most):
            raise MuyscError(
                f"The prior has a standard deviation of {deviation:g} and a correlation length of "
                f"{length_m:g} m, which must both be above 0, {least:g} at least and {most:g} at "
                "most; give others."
            )
        return _Covariance(self, deviation, length_m)


class _Covariance:
    """Products with σ² exp(−d/ℓ) by Fourier transform on a grid large enough not to wrap.

    What the transform of a finite piece of exp(−d/ℓ) has below zero is set to zero, which keeps
    the matrix a covariance.
    """

    def __init__(self, lattice: Lattice, deviation: float, length_m: float) -> None:
        self._fft = scipy_part("fft")
        self._lattice = lattice
        shape = lattice.active.shape
        self._shape = tuple(
            1
            if n == 1
            else self._fft.next_fast_len(
                n + max(n - 1, math.ceil(_APART * length_m / step)), real=True
            )
            for n, step in zip(shape, lattice.step_m)
        )
        square = np.zeros(())
        for n, step in zip(self._shape, lattice.step_m):
            index = np.arange(n)
            offset = step * np.minimum(index, n - index)
            square = square[..., None] + offset**2
        kernel = deviation**2 * np.exp(-np.sqrt(square) / length_m)
        self.eigenvalues = np.maximum(self._fft.rfftn(kernel).real, 0.0)

    def kernel(self) -> np.ndarray:
        """Return the covariance over the distance in cells along each axis, of the lattice's shape.

        That which the products are with, float32.
        """
        whole = self._fft.irfftn(self.eigenvalues, s=self._shape, workers=-1)
        inside = tuple(slice(n) for n in self._lattice.active.shape)
        return np.ascontiguousarray(whole[inside], np.float32)

    @property
    def root_size(self) -> int:
        """Number of columns of the root."""
        return math.prod(self._shape)

    def _filtered(self, field: np.ndarray, spectrum: np.ndarray) -> np.ndarray:
        transformed = self._fft.rfftn(field, s=self._shape, workers=-1)
        transformed *= spectrum
        return self._fft.irfftn(transformed, s=self._shape, workers=-1)

    def _inside(self, field: np.ndarray) -> np.ndarray:
        inside = tuple(slice(n) for n in self._lattice.active.shape)
        return field[inside][self._lattice.active]

    def __call__(self, values: np.ndarray) -> np.ndarray:
        """Return C values, (count,)."""
        return self._inside(self._filtered(self._lattice.expand(values, 0.0), self.eigenvalues))

    def root(self, noise: np.ndarray) -> np.ndarray:
        """Return B noise, (count,), with B Bᵀ = C: white noise makes a draw from the prior."""
        return self._inside(self._filtered(noise.reshape(self._shape), np.sqrt(self.eigenvalues)))

    def root_transposed(self, values: np.ndarray) -> np.ndarray:
        """Return Bᵀ values, (root_size,)."""
        field = self._lattice.expand(values, 0.0)
        return self._filtered(field, np.sqrt(self.eigenvalues)).ravel()
