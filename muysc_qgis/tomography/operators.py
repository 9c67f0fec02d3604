"""Forward and back projection, from a stored matrix or by recomputing the paths."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from ..progress import Progress, silent
from .projector import MEMORY_LIMIT, Paths, matrix_bytes, path_blocks, path_matrix

#: Entries of a stored matrix handled at a time where a copy of them is needed.
_BLOCK = 1 << 22

#: Rays handled at a time where rows are wanted one by one.
_ROWS = 1 << 12


class Projector(ABC):
    """What every solver needs of the path matrix A, (n_rays, n_unknowns)."""

    shape: tuple[int, int]

    @abstractmethod
    def blocks(self) -> Iterator[tuple[int, Any]]:
        """Yield the matrix in blocks of rows: the first row, and a CSR matrix."""

    @abstractmethod
    def take(self, which: np.ndarray) -> Projector:
        """Return the projector of some rays, in the order given."""

    @property
    def dtype(self) -> np.dtype:
        """Number type of the projections."""
        return np.dtype(np.float32)

    def forward(self, x: np.ndarray) -> np.ndarray:
        """Return A x, (n_rays,)."""
        x = x.astype(self.dtype, copy=False)
        result = np.zeros(self.shape[0], self.dtype)
        for first, block in self.blocks():
            result[first : first + block.shape[0]] = block @ x
        return result

    def back(self, y: np.ndarray) -> np.ndarray:
        """Return Aᵀ y, (n_unknowns,)."""
        y = y.astype(self.dtype, copy=False)
        result = np.zeros(self.shape[1], self.dtype)
        for first, block in self.blocks():
            result += block.T @ y[first : first + block.shape[0]]
        return result

    # scipy's names, so that any of these can be used as a linear operator.
    matvec = forward
    rmatvec = back

    def row_squares(self) -> np.ndarray:
        """Return Σⱼ aᵢⱼ², (n_rays,) of float64."""
        parts = [np.zeros(0)]
        ones = np.ones(self.shape[1], self.dtype)
        parts += [block.multiply(block) @ ones for _, block in self.blocks()]
        return np.concatenate(parts).astype(float)

    def column_squares(self, weights: np.ndarray) -> np.ndarray:
        """Return Σᵢ wᵢ aᵢⱼ², (n_unknowns,) of float64."""
        total = np.zeros(self.shape[1])
        for first, block in self.blocks():
            part = weights[first : first + block.shape[0]].astype(self.dtype)
            total += block.multiply(block).T @ part
        return total

    def coverage(self) -> np.ndarray:
        """Return how many rays meet each unknown, (n_unknowns,)."""
        total = np.zeros(self.shape[1], np.int64)
        for _, block in self.blocks():
            total += np.bincount(block.indices, minlength=self.shape[1])
        return total

    def chunks(self, order: np.ndarray) -> Iterator[Any]:
        """Yield CSR matrices of rows in an order, few rows at a time."""
        for first in range(0, len(order), _ROWS):
            for _, block in self.take(order[first : first + _ROWS]).blocks():
                yield block

    def grouped(self, groups: Sequence[np.ndarray]) -> list[Projector]:
        """Return a projector for each group of rays."""
        return [self.take(group) for group in groups]


class StoredPaths(Projector):
    """A path matrix in memory."""

    def __init__(self, matrix: Any) -> None:
        self.matrix = matrix
        self._transposed = matrix.T
        self.shape = matrix.shape

    @property
    def dtype(self) -> np.dtype:
        """Number type of the matrix; other vectors would make scipy copy it."""
        return self.matrix.dtype

    def forward(self, x: np.ndarray) -> np.ndarray:
        """Return A x, (n_rays,)."""
        return self.matrix @ x.astype(self.dtype, copy=False)

    def back(self, y: np.ndarray) -> np.ndarray:
        """Return Aᵀ y, (n_unknowns,)."""
        return self._transposed @ y.astype(self.dtype, copy=False)

    matvec = forward
    rmatvec = back

    def blocks(self) -> Iterator[tuple[int, Any]]:
        """Yield the matrix in blocks of rows that share its memory."""
        indptr, first = self.matrix.indptr, 0
        while first < self.shape[0]:
            last = int(np.searchsorted(indptr, indptr[first] + _BLOCK, side="right")) - 1
            last = min(max(last, first + 1), self.shape[0])
            yield first, _rows(self.matrix, first, last)
            first = last

    def take(self, which: np.ndarray) -> StoredPaths:
        """Return the projector of some rays; a copy."""
        return StoredPaths(self.matrix[which])

    def grouped(self, groups: Sequence[np.ndarray]) -> list[Projector]:
        """Return a projector for each group; together one copy, or none if they follow rows."""
        order = np.concatenate([*groups, np.zeros(0, np.int64)]).astype(np.int64)
        whole = len(order) and np.array_equal(order, np.arange(order[0], order[0] + len(order)))
        matrix = self.matrix if whole else self.matrix[order]
        ends = np.cumsum([len(group) for group in groups]) + (int(order[0]) if whole else 0)
        return [
            StoredPaths(_rows(matrix, int(end) - len(group), int(end)))
            for group, end in zip(groups, ends)
        ]


class RecomputedPaths(Projector):
    """The paths themselves: every projection follows the rays anew, in bounded memory.

    For volumes whose matrix does not fit; each product costs as much as building the matrix.
    """

    def __init__(self, paths: Paths) -> None:
        self.paths = paths
        self.shape = paths.shape

    def blocks(self) -> Iterator[tuple[int, Any]]:
        """Yield the matrix in blocks of rows, computed as they are asked for."""
        return path_blocks(self.paths)

    def take(self, which: np.ndarray) -> RecomputedPaths:
        """Return the projector of some rays."""
        return RecomputedPaths(self.paths.take(which))


def _rows(matrix: Any, first: int, last: int) -> Any:
    """Return consecutive rows of a CSR matrix without copying them."""
    begin, end = matrix.indptr[first], matrix.indptr[last]
    return type(matrix)(
        (
            matrix.data[begin:end],
            matrix.indices[begin:end],
            matrix.indptr[first : last + 1] - begin,
        ),
        shape=(last - first, matrix.shape[1]),
        copy=False,
    )


def projector_of(paths: Paths, limit: int = MEMORY_LIMIT, progress: Progress = silent) -> Projector:
    """Return the stored matrix where it fits `limit` bytes, else the recomputing projector.

    Raises
    ------
    MuyscError
        If scipy is missing.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    if matrix_bytes(paths) <= limit:
        return StoredPaths(path_matrix(paths, limit, progress))
    return RecomputedPaths(paths)
