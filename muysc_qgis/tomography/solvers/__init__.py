"""Ways from data to densities, by name."""

from .methods import METHODS, PARALLEL_ONLY, Method, method_of, reconstruct
from .options import ORDERINGS, Options, Reconstruction

__all__ = [
    "METHODS",
    "ORDERINGS",
    "PARALLEL_ONLY",
    "Method",
    "Options",
    "Reconstruction",
    "method_of",
    "reconstruct",
]
