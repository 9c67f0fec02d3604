"""Which parts of rays run inside a volume, and in its rock."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..progress import Progress, report, silent
from .crossings import Stretches, cut
from .ground import HeightField
from .rays import Rays
from .voxels import VoxelGrid

#: Stretches cut at a time; bounds the memory.
_BLOCK = 1 << 12

#: Stretches of one ray that are nearer to each other than this are one, m.
_SAME_M = 1e-9


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

    Parameters
    ----------
    grid, rays
        The volume, and detectors within or outside it.
    ground
        The terrain over the whole volume.
    progress
        Told the share done.

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
    # A bilinear cell lies between its lowest and its highest corner.
    height = ground.height_m
    corners = [height[:-1, :-1], height[1:, :-1], height[:-1, 1:], height[1:, 1:]]
    bounds = np.min(corners, axis=0), np.max(corners, axis=0)
    found = []
    for first in range(0, len(inside), _BLOCK):
        report(progress, first / len(inside))
        found.append(_below(inside.take(slice(first, first + _BLOCK)), rays, ground, bounds))
    report(progress, 1.0)
    if not found:
        return inside
    return Stretches(
        np.concatenate([part.ray for part in found]),
        np.concatenate([part.start_m for part in found]),
        np.concatenate([part.end_m for part in found]),
    )


def _below(
    stretches: Stretches, rays: Rays, ground: HeightField, bounds: tuple[np.ndarray, np.ndarray]
) -> Stretches:
    """Return the parts of stretches that are below the ground, whose cells have known bounds."""
    pieces = cut(rays.origin_m, rays.direction, stretches, ground.lines)
    ray = stretches.ray[pieces.stretch]
    # Most pieces are far above or below their cell of ground, which needs no roots.
    first_up = rays.origin_m[ray, 2] + pieces.start_m * rays.direction[ray, 2]
    last_up = first_up + pieces.length_m * rays.direction[ray, 2]
    cell = pieces.cells[0] * np.int64(bounds[0].shape[1]) + pieces.cells[1]
    lowest, highest = (bound.take(cell) for bound in bounds)
    under = np.maximum(first_up, last_up) < lowest
    meets = np.flatnonzero(~under & (np.minimum(first_up, last_up) < highest))
    some = ray[meets]
    depth = _depth(
        tuple(cells[meets] for cells in pieces.cells), some, pieces.start_m[meets], rays, ground
    )
    whole = np.flatnonzero(under)
    parts = [(whole, np.zeros(len(whole)), pieces.length_m[whole])]
    parts += [
        (meets[which], low, high) for which, low, high in _positive(*depth, pieces.length_m[meets])
    ]
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
