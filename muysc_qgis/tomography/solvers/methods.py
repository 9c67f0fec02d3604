"""All methods by name, with their defaults."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ...errors import MuyscError
from ...progress import Progress, report, silent
from ..system import System
from . import art, bayes, descent, likelihood, simultaneous, tikhonov, total_variation
from .options import Options, Reconstruction, Settings, start_vector


@dataclass(frozen=True)
class Method:
    """One way from data to densities, with its defaults where `Options` leave them open."""

    #: As in scripts, and as in texts.
    name: str
    title: str
    #: From a system without unusable rays and the settings to densities, telling the share done;
    #: raises `Cancelled` where that asks for a stop.
    solve: Callable[[System, Settings, Progress], Reconstruction]
    iterations: int
    relaxation: float = 1.0
    regularization: float = 0.0
    subsets: int = 8


#: Methods by their name in scripts. The strengths are those that served the fan-beam trial
#: with 2 % noise best, within a factor of two.
METHODS = {
    method.name: method
    for method in (
        Method("art", "ART (Kaczmarz)", art.solve, 10, relaxation=0.3),
        Method("bart", "ART by blocks", simultaneous.solve_bart, 10),
        Method("sart", "SART", simultaneous.solve_sart, 10, relaxation=0.5),
        Method("sirt", "SIRT", simultaneous.solve_sirt, 50),
        Method("mlem", "MLEM", likelihood.solve_mlem, 50),
        Method("osem", "OSEM", likelihood.solve_osem, 10),
        Method(
            "pml-quad", "Penalised likelihood, quadratic", likelihood.solve_pml_quad, 100,
            regularization=0.1,
        ),
        Method(
            "pml-hybrid", "Penalised likelihood, hybrid", likelihood.solve_pml_hybrid, 100,
            regularization=0.2,
        ),
        Method(
            "ospml-quad", "Penalised likelihood by subsets, quadratic",
            likelihood.solve_ospml_quad, 20, regularization=0.1,
        ),
        Method(
            "ospml-hybrid", "Penalised likelihood by subsets, hybrid",
            likelihood.solve_ospml_hybrid, 20, regularization=0.2,
        ),
        Method("tv", "Total variation", total_variation.solve, 300, regularization=0.1),
        Method("grad", "Gradient descent", descent.solve, 100, regularization=1.0),
        Method("tikhonov", "Tikhonov", tikhonov.solve_tikhonov, 200, regularization=1.0),
        Method("lsmr", "Damped LSMR", tikhonov.solve_lsmr, 200, regularization=1.0),
        Method("bayes", "Bayesian, Gaussian prior", bayes.solve, 200),
    )
}  # fmt: skip

#: Methods that exist only for evenly spaced parallel rays, by name.
PARALLEL_ONLY = {"fbp": "Filtered back-projection", "gridrec": "Gridrec"}


def method_of(name: str) -> Method:
    """Return a method by name.

    Raises
    ------
    MuyscError
        If there is none of the name, or it cannot be used on muograms.
    """
    if name in PARALLEL_ONLY:
        raise MuyscError(
            f"{PARALLEL_ONLY[name]} needs parallel rays all around the object, and muograms look "
            "out from single points over part of the horizon; choose another method, such as sirt."
        )
    if name not in METHODS:
        raise MuyscError(
            f"“{name}” is not a reconstruction method; use one of {', '.join(METHODS)}."
        )
    return METHODS[name]


def reconstruct(
    name: str, system: System, options: Options | None = None, progress: Progress = silent
) -> Reconstruction:
    """Return the densities that explain the data, by one of `METHODS`.

    Parameters
    ----------
    name
        Key of `METHODS`.
    system
        Paths, data and where the unknowns are; rays of unknown data are left out.
    options
        What to change of the method's defaults.
    progress
        Told the share done.

    Returns
    -------
    Reconstruction
        Densities of the unknowns; `Lattice.expand` puts them on the grid.

    Raises
    ------
    MuyscError
        If there is no such method, no usable ray, or an option does not fit.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    method = method_of(name)
    options = options or Options()
    report(progress, 0.0)
    usable = system.usable()

    def settled(given: float | None, default: float) -> float:
        return default if given is None else given

    settings = Settings(
        iterations=int(settled(options.iterations, method.iterations)),
        relaxation=settled(options.relaxation, method.relaxation),
        regularization=settled(options.regularization, method.regularization),
        ordering=options.ordering,
        subsets=int(settled(options.subsets, method.subsets)),
        nonnegative=options.nonnegative,
        highest=options.highest,
        start=start_vector(usable, options.start),
        discrepancy=options.discrepancy,
        edge_density=options.edge_density,
        prior_density=options.prior_density,
        prior_deviation=options.prior_deviation,
        correlation_length_m=options.correlation_length_m,
        deviation=options.deviation,
        posterior_samples=options.posterior_samples,
        seed=options.seed,
    )
    return method.solve(usable, settings, progress)
