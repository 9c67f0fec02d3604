"""Lengths of rays in voxels: how many there are, in blocks, and as one sparse matrix."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, report, silent
from .crossings import Lines, Stretches, count_pieces, cut
from .libraries import scipy_part
from .rays import Rays
from .rock import within_volume
from .voxels import VoxelGrid

#: Bytes of one stored length: float32 and a 32-bit column.
_BYTES = 8

#: Largest path matrix that is built unless the caller allows more, bytes.
MEMORY_LIMIT = 4 << 30

#: Crossings sorted at a time; bounds the memory and keeps it in the processor's cache.
_BLOCK = 1 << 18


@dataclass(frozen=True)
class Paths:
    """Rays through a volume: all that the path matrix follows from.

    Parameters
    ----------
    grid, rays
        The volume and the rays.
    stretches
        Parts of the rays that count, inside the volume (`within_volume`, `rock_along`).
    column
        (grid.count,) of int32: which unknown a voxel is, −1 for none. `None`: each its own.
    """

    grid: VoxelGrid
    rays: Rays
    stretches: Stretches
    column: np.ndarray | None = None

    @property
    def shape(self) -> tuple[int, int]:
        """Number of rays and of unknowns."""
        if self.column is None:
            return len(self.rays), self.grid.count
        return len(self.rays), int(self.column.max(initial=-1)) + 1

    @property
    def axes(self) -> tuple[Lines, ...]:
        """The planes between the voxels."""
        grid = self.grid
        return tuple(Lines(*axis) for axis in zip(grid.origin_m, grid.size_m, grid.shape))

    def lengths_m(self) -> np.ndarray:
        """Return the (n_rays,) length of each ray in the volume: the matrix's row sums."""
        part = self.stretches
        return np.bincount(part.ray, part.end_m - part.start_m, len(self.rays))

    def take(self, which: np.ndarray) -> Paths:
        """Return the paths of some rays, in the order given."""
        stretches = self.stretches
        number = np.bincount(stretches.ray, minlength=len(self.rays))
        begin = np.cumsum(number) - number
        chosen = np.repeat(np.arange(len(which)), number[which])
        within = np.arange(len(chosen)) - np.repeat(
            np.cumsum(number[which]) - number[which], number[which]
        )
        old = begin[which][chosen] + within
        return Paths(
            self.grid, self.rays.take(which),
            Stretches(chosen, stretches.start_m[old], stretches.end_m[old]), self.column,
        )  # fmt: skip


def paths_through(
    grid: VoxelGrid, rays: Rays, rock: Stretches | None = None, active: np.ndarray | None = None
) -> Paths:
    """Return the paths of rays through a volume.

    Parameters
    ----------
    grid, rays
        The volume, and rays from within or outside it.
    rock
        Parts of the rays that are in rock (`rock_along`, or as another code gives them); `None`
        takes the whole volume for rock.
    active
        (east, north, up) of bool: voxels that are unknowns. What runs through others is left
        out. `None` takes all.

    Raises
    ------
    MuyscError
        If no voxel is active or their array does not fit.
    """
    column = None
    if active is not None:
        grid.check(active)
        if not active.any():
            raise MuyscError(
                "No voxel of the volume holds rock, as its base is above the ground everywhere; "
                "lower the base or move the extent."
            )
        column = np.where(active.ravel(), np.cumsum(active.ravel(), dtype=np.int32) - 1, -1)
        column = column.astype(np.int32)
    return Paths(grid, rays, within_volume(grid, rays, rock), column)


def most_entries(paths: Paths) -> int:
    """Return the most lengths that the path matrix can have; O(rays).

    Exact but for crossings of two planes at one point, and for voxels left out.
    """
    rays = paths.rays
    return int(count_pieces(rays.origin_m, rays.direction, paths.stretches, paths.axes).sum())


def matrix_bytes(paths: Paths) -> int:
    """Return the memory that the path matrix needs at most, in bytes."""
    return _BYTES * (most_entries(paths) + len(paths.rays) + 1)


def check_memory(paths: Paths, limit: int = MEMORY_LIMIT) -> None:
    """Refuse a path matrix that does not fit the memory.

    Raises
    ------
    MuyscError
        If it is larger than `limit` bytes, naming a voxel size that fits.
    """
    need = matrix_bytes(paths)
    if need <= limit and need < _BYTES * np.iinfo(np.int32).max:
        return
    limit = min(limit, _BYTES * np.iinfo(np.int32).max)
    factor = need / limit
    while True:
        coarse = paths.grid.resized([_two_digits_up(factor * size) for size in paths.grid.size_m])
        # Whole voxels may reach further than the volume, and the rays in them too.
        further = np.subtract(coarse.end_m, coarse.origin_m) / np.subtract(
            paths.grid.end_m, paths.grid.origin_m
        )
        smaller = matrix_bytes(Paths(coarse, paths.rays, paths.stretches)) * further.max()
        if smaller <= limit or coarse.count == 1:
            break
        factor *= 1.1
    remedy = "use fewer rays"
    if smaller <= limit:
        edge = " × ".join(f"{size:g}" for size in coarse.size_m)
        remedy = f"use voxels of {edge} m or larger, or fewer rays"
    raise MuyscError(
        f"The paths of {len(paths.rays)} rays through {' × '.join(map(str, paths.grid.shape))} "
        f"voxels need {need / 2**30:.3g} GiB, more than the limit of {limit / 2**30:.3g} GiB; "
        f"{remedy}."
    )


def path_blocks(paths: Paths) -> Iterator[tuple[int, Any]]:
    """Yield the path matrix in blocks of rows: the first row, and a float32 CSR matrix."""
    sparse = scipy_part("sparse")
    n_columns = paths.shape[1]
    for first, last, indptr, indices, data in _raw_blocks(paths):
        yield (
            first,
            sparse.csr_matrix((data, indices, indptr), shape=(last - first, n_columns), copy=False),
        )


def path_matrix(paths: Paths, limit: int = MEMORY_LIMIT, progress: Progress = silent) -> Any:
    """Return the lengths of rays in voxels as one sparse matrix.

    Parameters
    ----------
    paths
        Rays through the volume.
    limit
        Most memory of the matrix, bytes.
    progress
        Told the share done.

    Returns
    -------
    scipy.sparse.csr_matrix
        (n_rays, n_unknowns) of float32, m. Cost: O(entries · log of a row's) in time; 8 bytes per
        entry and a bounded block beside them.

    Raises
    ------
    MuyscError
        If the matrix does not fit, or scipy is missing.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    sparse = scipy_part("sparse")
    check_memory(paths, limit)
    room = most_entries(paths)
    indices, data = np.empty(room, np.int32), np.empty(room, np.float32)
    indptr = np.zeros(len(paths.rays) + 1, np.int32)
    filled = 0
    for first, last, starts, some_indices, some_data in _raw_blocks(paths):
        report(progress, first / max(len(paths.rays), 1))
        end = filled + len(some_data)
        indices[filled:end], data[filled:end] = some_indices, some_data
        indptr[first : last + 1] = filled + starts
        filled = end
    report(progress, 1.0)
    # Given back in place: a copy would need the memory twice.
    indices.resize(filled, refcheck=False)
    data.resize(filled, refcheck=False)
    return sparse.csr_matrix((data, indices, indptr), shape=paths.shape, copy=False)


_RawBlock = tuple[int, int, np.ndarray, np.ndarray, np.ndarray]


def _raw_blocks(paths: Paths) -> Iterator[_RawBlock]:
    """Yield first and last row, row starts, columns and lengths of blocks of rays."""
    rays, stretches = paths.rays, paths.stretches
    pieces = count_pieces(rays.origin_m, rays.direction, stretches, paths.axes)
    begin = np.searchsorted(stretches.ray, np.arange(len(rays) + 1))
    first = 0
    for last in _block_ends(pieces, begin):
        some = stretches.take(slice(begin[first], begin[last]))
        yield (first, last, *_rows(paths, some, first, last))
        first = last


def _block_ends(pieces: np.ndarray, begin: np.ndarray) -> Iterator[int]:
    """Yield where blocks of rays end whose crossings fit the block."""
    n_rays, first = len(begin) - 1, 0
    widest = int(pieces.max(initial=1)) + 2
    most = max(1, _BLOCK // widest)
    while first < n_rays:
        # The last ray that still keeps the stretches within the block, or the next one.
        last = int(np.searchsorted(begin, begin[first] + most, side="right")) - 1
        first = min(max(last, first + 1), n_rays)
        yield first


def _rows(
    paths: Paths, stretches: Stretches, first: int, last: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return row starts, columns and lengths of the rays `first` to `last` − 1."""
    pieces = cut(paths.rays.origin_m, paths.rays.direction, stretches, paths.axes)
    _, n_north, n_up = paths.grid.shape
    i, j, k = pieces.cells
    voxel = (i * n_north + j) * n_up + k
    row = (stretches.ray - first)[pieces.stretch]
    length = pieces.length_m
    if paths.column is not None:
        voxel = paths.column[voxel]
        kept = voxel >= 0
        voxel, row, length = voxel[kept], row[kept], length[kept]
    # A ray that leaves the rock and enters it again within one voxel meets it once.
    again = np.zeros(len(voxel), bool)
    again[1:] = (voxel[1:] == voxel[:-1]) & (row[1:] == row[:-1])
    if again.any():
        begins = np.flatnonzero(~again)
        length, voxel, row = np.add.reduceat(length, begins), voxel[begins], row[begins]
    starts = np.zeros(last - first + 1, np.int32)
    np.cumsum(np.bincount(row, minlength=last - first), out=starts[1:])
    return starts, voxel.astype(np.int32, copy=False), length.astype(np.float32)


def _two_digits_up(value: float) -> float:
    """Return a value rounded up to two digits."""
    unit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return round(math.ceil(value / unit - 1e-9) * unit, 12)
