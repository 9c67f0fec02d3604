"""The iteration that the methods share: steps, misfit, stopping, cancelling."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...progress import Progress, report
from ..system import System
from .options import Reconstruction, Settings, misfit

#: From a model and its residual b − Ax to the next model.
Step = Callable[[np.ndarray, np.ndarray], np.ndarray]
#: From a model and its residual to what is minimised.
Objective = Callable[[np.ndarray, np.ndarray], float]


def iterate(
    system: System,
    settings: Settings,
    progress: Progress,
    step: Step,
    *,
    objective: Objective | None = None,
    discrepancy: bool = True,
    tolerance: float = 0.0,
) -> Reconstruction:
    """Repeat a step until the data are explained, nothing changes, or the iterations are done.

    Parameters
    ----------
    system, settings, progress
        What to solve and how.
    step
        One iteration.
    objective
        What the method minimises, for the record.
    discrepancy
        Whether fitting ends at the data's errors, as it should where nothing but the number of
        iterations holds noise back.
    tolerance
        Relative change of the model below which it counts as converged; 0 never.

    Raises
    ------
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    x = settings.start
    misfits, objectives = [], []
    stopped_by = "iterations"
    done = 0
    while True:
        residual = system.data - system.paths.forward(x)
        misfits.append(misfit(system, residual))
        if objective is not None:
            objectives.append(objective(x, residual))
        if discrepancy and system.errors is not None and misfits[-1] <= settings.discrepancy:
            stopped_by = "discrepancy"
            break
        if stopped_by == "converged" or done == settings.iterations:
            break
        report(progress, done / settings.iterations)
        following = step(x, residual)
        if tolerance and np.linalg.norm(following - x) <= tolerance * np.linalg.norm(x):
            stopped_by = "converged"
        x = following
        done += 1
    report(progress, 1.0)
    return Reconstruction(x, done, stopped_by, np.array(misfits), np.array(objectives))


def within_bounds(x: np.ndarray, settings: Settings) -> np.ndarray:
    """Return the model with densities beyond the bounds asked for brought back to them."""
    if settings.nonnegative:
        x = np.maximum(x, 0.0)
    return x if settings.highest is None else np.minimum(x, settings.highest)


def level(start: np.ndarray) -> float:
    """Return the density that strengths of penalties are relative to, never 0."""
    return float(np.mean(np.abs(start))) or 1.0


def inverse(values: np.ndarray) -> np.ndarray:
    """Return 1 / values, 0 where they are 0: what no ray meets is not corrected."""
    values = np.asarray(values, float)
    return np.divide(1.0, values, out=np.zeros(values.shape), where=values > 0)
