"""What a reconstruction can be asked for, and what it returns."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from ...errors import MuyscError
from ..system import System

#: Orders in which rays or views take their turn.
ORDERINGS = ("interleaved", "sequential", "random")


@dataclass(frozen=True)
class Options:
    """Settings shared by all methods; `None` takes the method's own default.

    Raises
    ------
    MuyscError
        If a number is out of its range or there is no such order.
    """

    #: Most iterations; a sweep over all rays is one.
    iterations: int | None = None
    #: Share of each correction that is applied, above 0 and below 2.
    relaxation: float | None = None
    #: Strength of the penalty relative to the data's; 0 for none.
    regularization: float | None = None
    #: One of `ORDERINGS`: views spread out, in their order, or drawn.
    ordering: str = "interleaved"
    #: Parts that the rays are dealt into; `None` takes the method's own.
    subsets: int | None = None
    #: Whether densities below zero are lifted to it.
    nonnegative: bool = True
    #: Density (g/cm³) that none exceeds, such as that of the rock without pores; `None`: no limit.
    highest: float | None = None
    #: Model to begin with (g/cm³): one density or one per unknown; `None` takes the best one.
    start: float | np.ndarray | None = None
    #: Multiple of the data's errors at which fitting ends, where they are known; 0 never ends.
    discrepancy: float = 1.0
    #: Density step (g/cm³) from which the hybrid penalty goes over from quadratic to linear.
    edge_density: float = 0.1
    #: Prior of the Bayesian method: mean (`None`: the start) and standard deviation in g/cm³, and
    #: the distance ℓ of its correlation exp(−d/ℓ).
    prior_density: float | None = None
    prior_deviation: float = 0.3
    correlation_length_m: float = 100.0
    #: Whether the Bayesian method tells the errors of the densities, which takes long.
    deviation: bool = True
    #: Draws from the posterior for the error of large models; 0 leaves it out.
    posterior_samples: int = 0
    #: Seed of everything drawn.
    seed: int = 1

    def __post_init__(self) -> None:
        _at_least("number of iterations", self.iterations, 1)
        _at_least("regularisation", self.regularization, 0)
        _at_least("number of subsets", self.subsets, 1)
        _at_least("discrepancy", self.discrepancy, 0)
        _at_least("number of posterior samples", self.posterior_samples, 0)
        if self.relaxation is not None and not 0 < self.relaxation < 2:
            raise MuyscError(
                f"The relaxation is {self.relaxation:g}, and beyond 0 to 2 the methods do not "
                "converge; give a number in between, such as 0.5."
            )
        if self.highest is not None and not self.highest > 0:
            raise MuyscError(
                f"The highest density is {self.highest:g} g/cm³, which leaves no rock; give one "
                "above 0."
            )
        if not self.edge_density > 0:
            raise MuyscError(
                f"The density step of the hybrid penalty is {self.edge_density:g} g/cm³; give one "
                "above 0."
            )
        if self.ordering not in ORDERINGS:
            raise MuyscError(
                f"“{self.ordering}” is not an order of rays; use one of {', '.join(ORDERINGS)}."
            )


@dataclass(frozen=True)
class Settings:
    """Options with every number settled, and the start as a vector."""

    iterations: int
    relaxation: float
    regularization: float
    ordering: str
    subsets: int
    nonnegative: bool
    highest: float | None
    start: np.ndarray
    discrepancy: float
    edge_density: float
    prior_density: float | None
    prior_deviation: float
    correlation_length_m: float
    posterior_samples: int
    seed: int
    deviation: bool = True


@dataclass(frozen=True)
class Reconstruction:
    """Densities, and how they were reached."""

    #: (n_unknowns,) in the unit of the system's x.
    values: np.ndarray
    iterations_done: int
    #: ``iterations``, ``discrepancy`` or ``converged``.
    stopped_by: str
    #: Misfit before each iteration and after the last: root mean square of (b − Ax)/σ, or of
    #: b − Ax over that of b where the errors are not known.
    misfit: np.ndarray
    #: What the method minimises, likewise; empty where it minimises nothing.
    objective: np.ndarray = field(default_factory=lambda: np.empty(0))
    #: (n_unknowns,) posterior standard deviation, of the Bayesian method.
    deviation: np.ndarray | None = None


def start_vector(system: System, start: float | np.ndarray | None) -> np.ndarray:
    """Return the model to begin with.

    Raises
    ------
    MuyscError
        If it has another number of values than there are unknowns, or one that is not finite.
    """
    value = system.homogeneous() if start is None else start
    vector = np.array(value, float)
    if vector.ndim and vector.shape != (system.lattice.count,):
        raise MuyscError(
            f"The start model has {vector.size} values for {system.lattice.count} unknowns; give "
            "one for each, or a single density."
        )
    if not np.all(np.isfinite(vector)):
        raise MuyscError("The start model holds a value that is not finite; give a density.")
    return np.broadcast_to(vector, (system.lattice.count,)).copy()


def misfit(system: System, residual: np.ndarray) -> float:
    """Return the root mean square residual, over the errors or over the data's own."""
    if system.errors is not None:
        return math.sqrt(float(np.mean((residual / system.errors) ** 2)))
    scale = float(np.mean(np.square(system.data, dtype=float)))
    square = float(np.mean(np.square(residual, dtype=float)))
    return math.sqrt(square / scale) if scale > 0 else math.sqrt(square)


def _at_least(what: str, value: float | None, least: float) -> None:
    if value is not None and not value >= least:
        raise MuyscError(f"The {what} is {value:g}; give at least {least:g}.")
