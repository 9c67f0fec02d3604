"""In which order rays, views and subsets take their turn."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..operators import Projector
from ..system import System
from .options import Settings

#: Share of the views between one and the next: the golden section spreads any number of them.
_GOLDEN = (5**0.5 - 1) / 2

#: Widest gaps between rays of one view that are tried for making them disjoint.
_GAPS = (1, 2, 3, 4, 6, 8)


def spread(count: int) -> np.ndarray:
    """Return 0 … count − 1 so that each is far from those just before it."""
    return np.argsort(np.argsort((np.arange(count) * _GOLDEN) % 1.0)).astype(np.int64)


def turns(count: int, settings: Settings) -> np.ndarray:
    """Return the order in which `count` things take their turn."""
    if settings.ordering == "random":
        return np.random.default_rng(settings.seed).permutation(count)
    if settings.ordering == "interleaved":
        return spread(count)
    return np.arange(count)


def views(system: System, settings: Settings) -> list[np.ndarray]:
    """Return the rays of each view, the views in turn."""
    by_view = np.argsort(system.view, kind="stable")
    _, number = np.unique(system.view, return_counts=True)
    groups = np.split(by_view, np.cumsum(number)[:-1])
    return [groups[turn] for turn in turns(len(groups), settings)]


def single_rays(system: System, settings: Settings) -> np.ndarray:
    """Return all rays, one of each view after the other; each view's rays in turn."""
    if settings.ordering == "sequential":
        return np.arange(len(system.view))
    place = np.empty(len(system.view))
    for number, rays in enumerate(views(system, settings)):
        # Views of unequal size are dealt out at an even pace.
        place[rays] = (turns(len(rays), settings) + number * 1e-6) / len(rays)
    return np.argsort(place, kind="stable")


def dealt(system: System, settings: Settings, subsets: int) -> list[np.ndarray]:
    """Return the rays in subsets: whole views where there are enough, else rays of all views.

    Subsets of views that are far apart see every part of the volume; with fewer views than
    subsets each gets its share of every view's rays.

    Parameters
    ----------
    system, settings
        The rays' views, and the order in which these take their turn.
    subsets
        Number of subsets; fewer come out where there are fewer rays.
    """
    grouped = views(system, settings)
    if len(grouped) >= subsets:
        return [np.sort(np.concatenate(grouped[first::subsets])) for first in range(subsets)]
    order = np.argsort(system.view, kind="stable")
    parts = [np.sort(order[first::subsets]) for first in range(subsets)]
    return [part for part in parts if len(part)]


def disjoint_groups(paths: Projector, rays: np.ndarray) -> list[np.ndarray] | None:
    """Return the rays of a view in groups that share no voxel; `None` if there are none.

    Tried are every second ray, every third … in their order. Rays that share no voxel do not
    change each other's residual, so that correcting a group at once is the same as one by one.
    """
    block = paths.take(rays)
    matrices = [matrix for _, matrix in block.blocks()]
    if len(matrices) != 1:
        return None
    matrix = matrices[0]
    for gap in _GAPS:
        groups = [np.arange(first, len(rays), gap) for first in range(min(gap, len(rays)))]
        if all(_disjoint(matrix[group]) for group in groups):
            return [rays[group] for group in groups]
    return None


def _disjoint(matrix: Any) -> bool:
    seen = np.zeros(matrix.shape[1], bool)
    seen[matrix.indices] = True
    return int(np.count_nonzero(seen)) == len(matrix.indices)
