"""The ground over a volume, and which voxels hold rock."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from .crossings import Lines
from .voxels import VoxelGrid

#: Columns per voxel edge over which its share of rock is averaged.
_SAMPLES = 4


@dataclass(frozen=True)
class HeightField:
    """Ground heights at the nodes of a regular grid, bilinear in between.

    Parameters
    ----------
    origin_m
        East and north of node [0, 0], in the frame of the voxels.
    step_m
        Distance of the nodes, east and north.
    height_m
        (n_east, n_north) at least 2 × 2, in the same frame.

    Raises
    ------
    MuyscError
        If there are too few nodes, their distance is not positive, or a height is unknown.
    """

    origin_m: tuple[float, float]
    step_m: tuple[float, float]
    height_m: np.ndarray

    def __post_init__(self) -> None:
        if self.height_m.ndim != 2 or min(self.height_m.shape) < 2 or not min(self.step_m) > 0:
            raise MuyscError(
                f"The terrain has {self.height_m.shape} heights every {self.step_m} m, where at "
                "least 2 × 2 at distances above 0 are needed; choose a larger extent."
            )
        if not np.all(np.isfinite(self.height_m)):
            missing = np.count_nonzero(~np.isfinite(self.height_m))
            raise MuyscError(
                f"The terrain has {missing} unknown heights over the volume; fill the elevation "
                "model's gaps or choose an extent without them."
            )

    @property
    def lines(self) -> tuple[Lines, Lines]:
        """The cells between the nodes."""
        shape = self.height_m.shape
        return (
            Lines(self.origin_m[0], self.step_m[0], shape[0] - 1),
            Lines(self.origin_m[1], self.step_m[1], shape[1] - 1),
        )

    def check_covers(self, grid: VoxelGrid) -> None:
        """Refuse a volume that reaches beyond the terrain.

        Raises
        ------
        MuyscError
            If it does.
        """
        slack = 1e-6 * np.array(self.step_m)
        low = np.array(self.origin_m)
        high = low + np.multiply(self.step_m, np.array(self.height_m.shape) - 1)
        over = np.maximum(low - grid.origin_m[:2], np.array(grid.end_m[:2]) - high)
        if np.any(over > slack):
            raise MuyscError(
                f"The volume reaches {over.max():.4g} m beyond the elevation model; choose a "
                "smaller extent or a larger elevation model."
            )

    def at(self, east_m: np.ndarray, north_m: np.ndarray) -> np.ndarray:
        """Return the ground's height (m) at points, which broadcast; beyond the rim the rim's."""
        position = []
        for points, low, step, count in zip(
            (east_m, north_m), self.origin_m, self.step_m, self.height_m.shape
        ):
            scaled = np.clip((np.asarray(points, float) - low) / step, 0, count - 1)
            cell = np.minimum(scaled.astype(np.int64), count - 2)
            position.append((cell, scaled - cell))
        (i, u), (j, v) = position
        height = self.height_m
        west = height[i, j] * (1 - v) + height[i, j + 1] * v
        east = height[i + 1, j] * (1 - v) + height[i + 1, j + 1] * v
        return west * (1 - u) + east * u


def rock_fraction(grid: VoxelGrid, ground: HeightField) -> np.ndarray:
    """Return the share of each voxel that is below the ground.

    Returns
    -------
    numpy.ndarray
        (east, north, up), 0 in air to 1 in rock: the mean over 4 × 4 columns per voxel.

    Raises
    ------
    MuyscError
        If the volume reaches beyond the terrain.
    """
    ground.check_covers(grid)
    offsets = (np.arange(_SAMPLES) + 0.5) / _SAMPLES
    total = np.zeros(grid.shape)
    bottom = grid.edges_m(2)[:-1]
    for east in offsets:
        for north in offsets:
            height = ground.at(
                (grid.edges_m(0)[:-1] + east * grid.size_m[0])[:, None],
                (grid.edges_m(1)[:-1] + north * grid.size_m[1])[None, :],
            )
            total += np.clip((height[:, :, None] - bottom) / grid.size_m[2], 0, 1)
    return total / _SAMPLES**2


def holds_rock(grid: VoxelGrid, ground: HeightField) -> np.ndarray:
    """Return which voxels the ground may reach into: the unknowns of a reconstruction.

    Returns
    -------
    numpy.ndarray
        (east, north, up) of bool: no voxel that holds rock is missing, and each other one that is
        marked touches a terrain cell that is as high.

    Raises
    ------
    MuyscError
        If the volume reaches beyond the terrain.
    """
    ground.check_covers(grid)
    highest = ground.height_m
    # A bilinear cell is nowhere higher than its highest corner.
    for axis, lines in enumerate(ground.lines):
        edges = (grid.edges_m(axis) - lines.low_m) / lines.step_m
        first = np.clip(np.floor(edges[:-1]).astype(int), 0, lines.count)
        last = np.clip(np.ceil(edges[1:]).astype(int), first, lines.count)
        highest = np.stack([
            highest.take(np.arange(low, high + 1), axis=axis).max(axis=axis)
            for low, high in zip(first, last)
        ], axis=axis)  # fmt: skip
    return highest[:, :, None] > grid.edges_m(2)[:-1]
