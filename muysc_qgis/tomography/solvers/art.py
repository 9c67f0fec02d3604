"""ART: the rays correct the model one after the other (Kaczmarz's method)."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

from ...progress import Progress, report
from ..operators import StoredPaths
from ..system import System
from .loop import inverse, iterate, within_bounds
from .options import Reconstruction, Settings
from .order import disjoint_groups, single_rays, turns, views

#: Where rays of a view are that sparse, whole groups of them are corrected at once.
_FEWEST_IN_GROUP = 16


def ray_relaxation(system: System, settings: Settings) -> np.ndarray:
    """Return the relaxation of each ray: less where the data's error is above the median."""
    if system.errors is None:
        return np.full(len(system.data), settings.relaxation)
    variance = np.asarray(system.errors, float) ** 2
    return settings.relaxation * np.minimum(1.0, np.median(variance) / variance)


def solve(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the model after sweeps of x += λ (bᵢ − aᵢ·x)/‖aᵢ‖² aᵢ over all rays.

    Gordon, Bender & Herman 1970 (doi:10.1016/0022-5193(70)90109-8). Where every second, third …
    ray of a view shares no voxel with the others, such a group is one product with its rows;
    otherwise each ray is one short product with its row of the matrix. Both are the same sweep.
    """
    factor = ray_relaxation(system, settings) * inverse(system.paths.row_squares())
    groups = _groups(system, settings)
    if groups is not None:
        parts = list(zip(groups, system.paths.grouped(groups)))

        def step(x: np.ndarray, _: np.ndarray) -> np.ndarray:
            x = x.astype(system.paths.dtype)
            for rays, paths in parts:
                x += paths.back(factor[rays] * (system.data[rays] - paths.forward(x)))
            return within_bounds(x, settings).astype(float)

    else:
        order = single_rays(system, settings)
        sweeps = itertools.count()

        def step(x: np.ndarray, _: np.ndarray) -> np.ndarray:
            x = x.astype(system.paths.dtype)
            before, done = next(sweeps), 0
            for chunk in system.paths.chunks(order):
                report(progress, (before + done / len(order)) / settings.iterations)
                rays = order[done : done + chunk.shape[0]]
                _sweep(x, chunk, system.data[rays], factor[rays])
                done += len(rays)
            return within_bounds(x, settings).astype(float)

    return iterate(system, settings, progress, step)


def _groups(system: System, settings: Settings) -> list[np.ndarray] | None:
    """Return groups of rays without a common voxel, or `None` where they would be small."""
    if not isinstance(system.paths, StoredPaths):
        return None
    result = []
    for rays in views(system, settings):
        groups = disjoint_groups(system.paths, rays)
        if groups is None or len(rays) < _FEWEST_IN_GROUP * len(groups):
            return None
        result += [groups[turn] for turn in turns(len(groups), settings)]
    return result


def _sweep(x: np.ndarray, rows: Any, data: np.ndarray, factor: np.ndarray) -> None:
    """Correct the model, in place, by each row in turn."""
    indptr = rows.indptr.tolist()
    columns, values = rows.indices.astype(np.intp), rows.data
    begin = indptr[0]
    for end, target, scale in zip(indptr[1:], data.tolist(), factor.tolist()):
        if end > begin:
            where, length = columns[begin:end], values[begin:end]
            crossed = x.take(where)
            crossed += x.dtype.type(scale * (target - float(length.dot(crossed)))) * length
            x[where] = crossed
        begin = end
