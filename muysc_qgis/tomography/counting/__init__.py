"""Densities from counts: a Gaussian prior, a Poisson likelihood, and what else is uncertain."""

from .fit import CountFit, fit_counts
from .model import CountModel
from .priors import Band, CountPriors

#: Name of the method beside `tomography.solvers.METHODS`, and what it is.
COUNTS, COUNTS_TITLE = "counts", "Fit of counts, Gaussian prior and Poisson likelihood"

__all__ = [
    "COUNTS",
    "COUNTS_TITLE",
    "Band",
    "CountFit",
    "CountModel",
    "CountPriors",
    "fit_counts",
]
