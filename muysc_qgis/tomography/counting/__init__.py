"""Densities from counts: a Gaussian prior, a Poisson likelihood, and what else is uncertain."""

from .fit import CountFit, fit_counts
from .model import CountModel
from .priors import Band, CountPriors

__all__ = ["Band", "CountFit", "CountModel", "CountPriors", "fit_counts"]
