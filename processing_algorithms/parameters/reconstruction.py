"""Parameters of how densities are found from rays."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
)

from ...muysc_qgis.radiography.settings import MAXIMUM_DENSITY_G_CM3
from ...muysc_qgis.tomography.counting import COUNTS, COUNTS_TITLE
from ...muysc_qgis.tomography.solvers import METHODS, ORDERINGS, PARALLEL_ONLY, Options, method_of
from ...muysc_qgis.workflows.tomography import TomographyChoices
from .values import (
    choice,
    given,
    number,
    read_choice,
    read_count,
    read_number,
    read_optional,
    switch,
)
from .volume import read_memory


def reconstruction_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare the method and its settings."""
    methods = "; ".join(f"{name}: {method.title}" for name, method in METHODS.items())
    methods += f"; {COUNTS}: {COUNTS_TITLE}"
    return [
        choice(
            "METHOD", "Method",
            f"How densities are found. {methods}. Those of the family art and sirt follow the "
            "data alone; pml, tv, grad, tikhonov and lsmr prefer smooth models, tv with sharp "
            "edges; bayes weighs data against a prior and tells its errors; counts does so for "
            "rasters of counts, with trajectories as wide as they are and pixels without a muon.",
            [*METHODS, COUNTS], TomographyChoices().method,
        ),
        number(
            "ITERATIONS", "Iterations (empty: the method's own)",
            "Give the most iterations, 1 or more; a sweep over all rays is one. Methods that "
            "reach the data's errors or converge end sooner.",
            None, 1, whole=True,
        ),
        number(
            "RELAXATION", "Relaxation (empty: the method's own)",
            "Give the share of each correction that art, bart, sart and sirt apply, above 0 and "
            "below 2.",
            None, 0, 2,
        ),
        number(
            "REGULARIZATION", "Regularisation (empty: the method's own)",
            "Give the strength of the penalty on rough models of pml, ospml, tv, grad, tikhonov "
            "and lsmr, 0 or more; at 1 a step between neighbours weighs as much as the misfit of a "
            "voxel.",
            None, 0,
        ),
        number(
            "REFERENCE_DENSITY", "Reference density (g/cm³, empty: the muograms' mean)",
            f"Give the density in g/cm³, above 0 and up to {MAXIMUM_DENSITY_G_CM3:g}, of the rock "
            "outside the volume, of the start and of the prior.",
            None, 0, MAXIMUM_DENSITY_G_CM3,
        ),
        number(
            "RELATIVE_ERROR", "Error of the opacities (%)",
            "Give the standard error of opacities in % where there are no rasters of errors, 0 or "
            "more; it is at least that of a tenth of the mean opacity. 0 stands for unknown: then "
            "all rays count the same, no method stops at the errors, and bayes cannot be used.",
            5.0, 0, 1000,
        ),
        number(
            "LENGTH_ERROR", "Error of the path lengths (m)",
            "Give the standard error of a ray's length in rock in m, 0 or more: what the "
            "elevation model does not show. It adds to the other errors.",
            2.0, 0, advanced=True,
        ),
        switch(
            "NONNEGATIVE", "Keep densities above zero",
            "Whether densities below zero are lifted to it; bayes does not.",
            True, advanced=True,
        ),
        number(
            "HIGHEST_DENSITY", "Highest density (g/cm³, empty: none)",
            "Give the density in g/cm³, above 0, that none may exceed, such as that of the rock "
            "without pores; bayes knows none.",
            None, 0, MAXIMUM_DENSITY_G_CM3, advanced=True,
        ),
        choice(
            "ORDERING", "Order of the rays",
            "interleaved: stations far apart take turns. sequential: as they come. random: drawn.",
            list(ORDERINGS), "interleaved", advanced=True,
        ),
        number(
            "SUBSETS", "Subsets (empty: the method's own)",
            "Give the number of parts of bart, osem and ospml that the rays are dealt into, 1 or "
            "more.",
            None, 1, advanced=True, whole=True,
        ),
        number(
            "DISCREPANCY", "Stop at this multiple of the errors",
            "Give the misfit, in standard errors, at which the methods without a penalty stop, 0 "
            "or more; 0 never stops.",
            1.0, 0, advanced=True,
        ),
        number(
            "EDGE_DENSITY", "Density step of the hybrid penalty (g/cm³)",
            "Give the step between neighbours in g/cm³, above 0, from which the penalty of "
            "pml-hybrid and ospml-hybrid grows no faster than the step.",
            0.1, 0, advanced=True,
        ),
        number(
            "PRIOR_DEVIATION", "Standard deviation of the prior (g/cm³)",
            "Give how far densities are from the reference before any muon, in g/cm³, above 0; "
            "for bayes and counts.",
            0.2, 0, advanced=True,
        ),
        number(
            "CORRELATION_LENGTH", "Correlation length of the prior (m)",
            "Give the distance in m, above 0, over which densities are alike; for bayes and "
            "counts.",
            200.0, 0, advanced=True,
        ),
        number(
            "POSTERIOR_SAMPLES", "Draws for the error of the density",
            "Give how often bayes solves for drawn data, 1 or more, where the error of the density "
            "is wanted from more than 2000 rays; n draws tell it to 71/√n %.",
            10, 1, advanced=True, whole=True,
        ),
    ]  # fmt: skip


def read_reconstruction(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    errors_wanted: bool = False,
) -> TomographyChoices:
    """Return how densities, and their errors if wanted, are to be found.

    Raises
    ------
    MuyscError
        If a value cannot be used.
    """
    read = (algorithm, parameters)

    def optional(name: str) -> float | None:
        return read_optional(*read, name, context)

    def count_of(name: str) -> int | None:
        return read_count(*read, name, context) if given(parameters, name) else None

    if parameters.get("METHOD") in PARALLEL_ONLY:
        method_of(parameters["METHOD"])  # says why not
    error = read_number(*read, "RELATIVE_ERROR", context)
    options = Options(
        iterations=count_of("ITERATIONS"),
        relaxation=optional("RELAXATION"),
        regularization=optional("REGULARIZATION"),
        ordering=read_choice(*read, "ORDERING", context),
        subsets=count_of("SUBSETS"),
        nonnegative=algorithm.parameterAsBool(parameters, "NONNEGATIVE", context),
        highest=optional("HIGHEST_DENSITY"),
        discrepancy=read_number(*read, "DISCREPANCY", context),
        edge_density=read_number(*read, "EDGE_DENSITY", context),
        prior_deviation=read_number(*read, "PRIOR_DEVIATION", context),
        correlation_length_m=read_number(*read, "CORRELATION_LENGTH", context),
        deviation=errors_wanted,
        posterior_samples=read_count(*read, "POSTERIOR_SAMPLES", context),
    )
    return TomographyChoices(
        method=read_choice(*read, "METHOD", context),
        options=options,
        reference_density=optional("REFERENCE_DENSITY"),
        mask=algorithm.parameterAsBool(parameters, "TERRAIN_MASK", context),
        relative_error=error / 100 if error else None,
        length_error_m=read_number(*read, "LENGTH_ERROR", context),
        memory_bytes=read_memory(*read, context),
    )
