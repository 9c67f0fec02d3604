"""The ground over a volume: which voxels hold rock, and which parts of rays run in it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, report, silent
from .crossings import Lines, Stretches, cut
from .rays import Rays
from .voxels import VoxelGrid

#: Stretches cut at a time; bounds the memory.
_BLOCK = 1 << 12

#: Columns per voxel edge over which its share of rock is averaged.
_SAMPLES = 4

#: Stretches of one ray that are nearer to each other than this are one, m.
_SAME_M = 1e-9


@dataclass(frozen=True)
class HeightField:
    """Ground heights at the nodes of a regular grid, bilinear in between.

    Parameters
    ----------
    origin_m
        East and north of node [0, 0].
    step_m
        Distance of the nodes, east and north.
    height_m
        (n_east, n_north) at least 2 × 2, in the frame of the voxels.

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
        """Return the ground's height at points, which broadcast; beyond the rim the rim's."""
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


def within_volume(grid: VoxelGrid, rays: Rays, rock: Stretches | None = None) -> Stretches:
    """Return the parts of rays inside the volume, at most those in rock.

    Parameters
    ----------
    grid, rays
        The volume, and detectors within or outside it.
    rock
        Parts of the rays that are in rock; `None` takes whole rays.
    """
    start, end = np.zeros(len(rays)), np.full(len(rays), np.inf)
    for axis in range(3):
        low, high = grid.origin_m[axis], grid.end_m[axis]
        position, heading = rays.origin_m[:, axis], rays.direction[:, axis]
        with np.errstate(divide="ignore", invalid="ignore"):
            one, other = (low - position) / heading, (high - position) / heading
        along = heading == 0
        inside = (position >= low) & (position <= high)
        near = np.where(along, np.where(inside, -np.inf, np.inf), np.minimum(one, other))
        far = np.where(along, np.inf, np.maximum(one, other))
        start, end = np.maximum(start, near), np.minimum(end, far)
    if rock is None:
        rock = Stretches(np.arange(len(rays)), start, end)
    else:
        rock = Stretches(
            rock.ray,
            np.maximum(rock.start_m, start[rock.ray]),
            np.minimum(rock.end_m, end[rock.ray]),
        )
    return rock.take(rock.end_m > rock.start_m)


def rock_along(
    grid: VoxelGrid, rays: Rays, ground: HeightField, progress: Progress = silent
) -> Stretches:
    """Return the parts of rays that are inside the volume and below the ground.

    Exact for the bilinear ground: within one of its cells the ground below a straight line is a
    quadratic in the distance, whose roots are where the ray enters and leaves the rock.

    Returns
    -------
    Stretches
        Cost: O(pieces of ground crossed) in time, O(stretches) in memory.

    Raises
    ------
    MuyscError
        If the volume reaches beyond the terrain.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    ground.check_covers(grid)
    inside = within_volume(grid, rays)
    found = []
    for first in range(0, len(inside), _BLOCK):
        report(progress, first / len(inside))
        found.append(_below(inside.take(slice(first, first + _BLOCK)), rays, ground))
    report(progress, 1.0)
    if not found:
        return inside
    return Stretches(
        np.concatenate([part.ray for part in found]),
        np.concatenate([part.start_m for part in found]),
        np.concatenate([part.end_m for part in found]),
    )


def _below(stretches: Stretches, rays: Rays, ground: HeightField) -> Stretches:
    """Return the parts of stretches that are below the ground."""
    pieces = cut(rays.origin_m, rays.direction, stretches, ground.lines)
    ray = stretches.ray[pieces.stretch]
    constant, linear, quadratic = _depth(pieces.cells, ray, pieces.start_m, rays, ground)
    parts = list(_positive(constant, linear, quadratic, pieces.length_m))
    piece = np.concatenate([part[0] for part in parts])
    start = np.concatenate([part[1] for part in parts])
    end = np.concatenate([part[2] for part in parts])
    order = np.lexsort((start, piece))
    piece, start, end = piece[order], start[order], end[order]
    start, end = pieces.start_m[piece] + start, pieces.start_m[piece] + end
    stretch = pieces.stretch[piece]
    # What goes on over the border of a cell is one stretch.
    new = np.ones(len(piece), bool)
    new[1:] = (stretch[1:] != stretch[:-1]) | (start[1:] - end[:-1] > _SAME_M)
    begins = np.flatnonzero(new)
    last = np.append(begins[1:], len(piece)) - 1
    if not len(begins):
        last = begins
    return Stretches(stretches.ray[stretch[begins]], start[begins], end[last])


def _depth(
    cells: tuple[np.ndarray, ...], ray: np.ndarray, start: np.ndarray, rays: Rays,
    ground: HeightField,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:  # fmt: skip
    """Return the coefficients of the depth below ground over the distance from `start`."""
    i, j = cells
    height = ground.height_m
    corner = height[i, j]
    east = height[i + 1, j] - corner
    north = height[i, j + 1] - corner
    twist = height[i + 1, j + 1] - height[i + 1, j] - north
    point = rays.origin_m[ray] + start[:, None] * rays.direction[ray]
    u = (point[:, 0] - ground.origin_m[0]) / ground.step_m[0] - i
    v = (point[:, 1] - ground.origin_m[1]) / ground.step_m[1] - j
    du = rays.direction[ray, 0] / ground.step_m[0]
    dv = rays.direction[ray, 1] / ground.step_m[1]
    return (
        corner + east * u + north * v + twist * u * v - point[:, 2],
        east * du + north * dv + twist * (u * dv + v * du) - rays.direction[ray, 2],
        twist * du * dv,
    )


def _positive(
    constant: np.ndarray, linear: np.ndarray, quadratic: np.ndarray, length: np.ndarray
) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Yield piece, start and end of where quadratics are above 0 within 0 … length."""
    with np.errstate(divide="ignore", invalid="ignore"):
        discriminant = linear**2 - 4 * constant * quadratic
        # Without cancellation; a missing root is NaN or infinite and clipped away.
        q = -0.5 * (linear + np.copysign(np.sqrt(np.maximum(discriminant, 0)), linear))
        roots = np.stack([q / quadratic, constant / q])
    roots = np.where(np.isfinite(roots) & (discriminant >= 0), roots, np.inf)
    roots = np.clip(np.sort(roots, axis=0), 0, length)
    bounds = (np.zeros(len(length)), roots[0], roots[1], length)
    for low, high in zip(bounds[:-1], bounds[1:]):
        middle = 0.5 * (low + high)
        above = constant + (linear + quadratic * middle) * middle > 0
        which = np.flatnonzero(above & (high > low))
        yield which, low[which], high[which]
