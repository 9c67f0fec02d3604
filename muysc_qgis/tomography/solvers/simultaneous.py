"""SIRT, SART and BART: all rays, the rays of a view, or blocks of rays correct at once."""

from __future__ import annotations

import numpy as np

from ...progress import Progress
from ..operators import Projector
from ..system import System
from .art import ray_relaxation
from .loop import inverse, iterate, within_bounds
from .options import Reconstruction, Settings
from .order import dealt, views


def solve_sirt(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the model after iterations of x += λ C⁻¹ Aᵀ W R⁻¹ (b − Ax).

    R holds the row sums of A, W the weights of the data and C the column sums of WA; Gregor &
    Benson 2008 (doi:10.1109/TMI.2008.923696). It lowers ‖b − Ax‖ weighted by W/R at every step.
    """
    paths, weights = system.paths, system.weights()
    row = weights * inverse(paths.forward(np.ones(paths.shape[1])))
    column = settings.relaxation * inverse(paths.back(weights))

    def step(x: np.ndarray, residual: np.ndarray) -> np.ndarray:
        return within_bounds(x + column * paths.back(row * residual), settings)

    def objective(_: np.ndarray, residual: np.ndarray) -> float:
        return 0.5 * float(np.sum(row * residual**2))

    return iterate(system, settings, progress, step, objective=objective)


def solve_sart(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the model after sweeps of x += C⁻¹ Aᵀ Λ R⁻¹ (b − Ax) view by view.

    Andersen & Kak 1984 (doi:10.1016/0161-7346(84)90008-7); Λ holds the relaxation, which is less
    for rays whose data are less sure, so that a view of such rays counts less too.
    """
    relaxation = ray_relaxation(system, settings)
    groups = views(system, settings)
    parts = []
    for rays, paths in zip(groups, system.paths.grouped(groups)):
        row = relaxation[rays] * inverse(paths.forward(np.ones(paths.shape[1])))
        # float32: as many vectors of all unknowns as there are views.
        column = inverse(paths.back(np.ones(len(rays)))).astype(np.float32)
        parts.append((rays, paths, row, column))

    def step(x: np.ndarray, _: np.ndarray) -> np.ndarray:
        x = x.astype(system.paths.dtype)
        for rays, paths, row, column in parts:
            x += column * paths.back(row * (system.data[rays] - paths.forward(x)))
        return within_bounds(x, settings).astype(float)

    return iterate(system, settings, progress, step)


def solve_bart(system: System, settings: Settings, progress: Progress) -> Reconstruction:
    """Return the model after sweeps of ART's correction by blocks, averaged in each voxel.

    With sⱼ the number of the block's rays in voxel j: xⱼ += λ Σᵢ aᵢⱼ (bᵢ − aᵢ·x) / Σₖ sₖ aᵢₖ²,
    the component averaging of Censor, Gordon & Gordon 2001 (doi:10.1109/42.959302), which
    converges for any block and λ below 2.
    """
    relaxation = ray_relaxation(system, settings)
    groups = dealt(system, settings, settings.subsets)
    parts = [
        (rays, paths, relaxation[rays] * inverse(_averaged_squares(paths)))
        for rays, paths in zip(groups, system.paths.grouped(groups))
    ]

    def step(x: np.ndarray, _: np.ndarray) -> np.ndarray:
        x = x.astype(system.paths.dtype)
        for rays, paths, row in parts:
            x += paths.back(row * (system.data[rays] - paths.forward(x)))
        return within_bounds(x, settings).astype(float)

    return iterate(system, settings, progress, step)


def _averaged_squares(paths: Projector) -> np.ndarray:
    """Return Σⱼ sⱼ aᵢⱼ² for each ray, sⱼ being the rays that meet voxel j."""
    meeting = paths.coverage().astype(float)
    parts = [block.multiply(block) @ meeting for _, block in paths.blocks()]
    return np.concatenate([np.zeros(0), *parts])
