"""The volume whose densities are sought, cut into equal boxes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError

#: What is summed over in each view of a volume: up, north, east.
VIEW_AXES = {"top": 2, "front": 1, "side": 0}

#: Most voxels whose number fits the 32-bit indices of the path matrix.
_MOST_VOXELS = 2**31 - 1

#: Share of a voxel by which a volume may be overrun before another voxel is added.
_ROUNDING = 1e-9


@dataclass(frozen=True)
class VoxelGrid:
    """Equal boxes in a local frame; values are arrays [east, north, up].

    The frame (projection, and true north against grid north) is the caller's: only
    metres along three right-angled axes count here.

    Parameters
    ----------
    origin_m
        East, north and up of the lowest corner.
    size_m
        Edges of one voxel, east, north and up.
    shape
        Number of voxels east, north and up.

    Raises
    ------
    MuyscError
        If a number is not finite, an edge is not positive, or there is no voxel or too many.
    """

    origin_m: tuple[float, float, float]
    size_m: tuple[float, float, float]
    shape: tuple[int, int, int]

    def __post_init__(self) -> None:
        if not np.all(np.isfinite([*self.origin_m, *self.size_m])) or min(self.size_m) <= 0:
            raise MuyscError(
                f"The voxel size is {_sizes(self.size_m)}, which must be finite and above 0; "
                "give the edge of a voxel in metres."
            )
        if min(self.shape) < 1 or math.prod(self.shape) > _MOST_VOXELS:
            raise MuyscError(
                f"The volume has {' × '.join(map(str, self.shape))} voxels, where 1 to "
                f"{_MOST_VOXELS} in all can be used; change the extent or the voxel size."
            )

    @classmethod
    def covering(
        cls,
        low_m: Sequence[float],
        high_m: Sequence[float],
        size_m: float | Sequence[float] | np.ndarray,
    ) -> VoxelGrid:
        """Return the smallest grid of whole voxels that starts at `low_m` and covers `high_m`.

        Parameters
        ----------
        low_m, high_m
            East, north and up of two opposite corners.
        size_m
            Edge of a voxel, one for all or east, north and up.

        Raises
        ------
        MuyscError
            If the volume is empty or its voxels are too many.
        """
        size = np.broadcast_to(np.asarray(size_m, float), 3)
        low, high = np.asarray(low_m, float), np.asarray(high_m, float)
        if not np.all(np.isfinite(high - low)) or np.any(high <= low):
            raise MuyscError(
                f"The volume reaches from {_sizes(low)} to {_sizes(high)} (east, north, up), which "
                "is empty; give an extent wider than 0 and a top above the base."
            )
        if not np.all(size > 0):
            raise MuyscError(
                f"The voxel size is {_sizes(size)}, which must be above 0; give the edge of a "
                "voxel in metres."
            )
        number = np.maximum(1, np.ceil((high - low) / size - _ROUNDING))
        return cls(_triple(low), _triple(size), (int(number[0]), int(number[1]), int(number[2])))

    @property
    def count(self) -> int:
        """Number of voxels."""
        return math.prod(self.shape)

    @property
    def end_m(self) -> tuple[float, float, float]:
        """East, north and up of the highest corner."""
        return _triple(np.add(self.origin_m, np.multiply(self.size_m, self.shape)))

    @property
    def volume_m3(self) -> float:
        """Volume of one voxel, m³."""
        return math.prod(self.size_m)

    def resized(self, size_m: Sequence[float]) -> VoxelGrid:
        """Return a grid over the same volume with voxels of another size."""
        return self.covering(self.origin_m, self.end_m, size_m)

    def edges_m(self, axis: int) -> np.ndarray:
        """Return the (n + 1,) bounds of the voxels along an axis: 0 east, 1 north, 2 up."""
        return self.origin_m[axis] + self.size_m[axis] * np.arange(self.shape[axis] + 1)

    def centres_m(self, axis: int) -> np.ndarray:
        """Return the (n,) centres of the voxels along an axis: 0 east, 1 north, 2 up."""
        return self.origin_m[axis] + self.size_m[axis] * (np.arange(self.shape[axis]) + 0.5)

    def all_centres_m(self) -> np.ndarray:
        """Return the (count, 3) centres of all voxels, up running fastest."""
        axes = np.meshgrid(*(self.centres_m(axis) for axis in range(3)), indexing="ij")
        return np.stack([axis.ravel() for axis in axes], axis=1)

    def level_at(self, up_m: float) -> int:
        """Return the number of the elevation slice that holds a height, the upper on a bound.

        Raises
        ------
        MuyscError
            If the height is outside the volume.
        """
        low, high = self.origin_m[2], self.end_m[2]
        if not low <= up_m <= high:
            raise MuyscError(
                f"The slice at {up_m:g} m is outside the volume, which reaches from {low:g} to "
                f"{high:g} m; choose a height in between."
            )
        return min(int((up_m - low) / self.size_m[2]), self.shape[2] - 1)

    def check(self, values: np.ndarray) -> None:
        """Refuse values that are not one per voxel.

        Raises
        ------
        MuyscError
            If the shape is another one.
        """
        if values.shape != self.shape:
            raise MuyscError(
                f"The model has {values.shape} values for {self.shape} voxels (east, north, up); "
                "give one value for each voxel."
            )


def view(grid: VoxelGrid, values: np.ndarray, name: str) -> np.ndarray:
    """Return a volume summed along an axis: each voxel's value times its edge.

    Parameters
    ----------
    grid, values
        The volume; NaN where there is no rock, which counts nothing.
    name
        ``top`` (summed along up), ``front`` (along north) or ``side`` (along east).

    Returns
    -------
    numpy.ndarray
        (east, north), (east, up) or (north, up), in the values' unit times metres; NaN where no
        voxel of the column holds rock.

    Raises
    ------
    MuyscError
        If the view is unknown or the values do not fit the grid.
    """
    if name not in VIEW_AXES:
        raise MuyscError(f"“{name}” is not a view; use one of {', '.join(VIEW_AXES)}.")
    grid.check(values)
    axis = VIEW_AXES[name]
    known = np.isfinite(values)
    total = np.where(known, values, 0.0).sum(axis=axis) * grid.size_m[axis]
    return np.where(known.any(axis=axis), total, np.nan)


def _triple(values: Sequence[float] | np.ndarray) -> tuple[float, float, float]:
    """Return three plain numbers."""
    return float(values[0]), float(values[1]), float(values[2])


def _sizes(values: Sequence[float] | np.ndarray) -> str:
    """Return three lengths for a sentence."""
    return " × ".join(f"{value:g}" for value in values) + " m"
