"""The nucleons that come down on the air."""

from __future__ import annotations

import warnings

import numpy as np

from .grid import LN_STEP, NODES_GEV
from .particles import PROTON_GEV


def nucleons() -> np.ndarray:
    """Return (2, n_node) protons and neutrons in each cell, per m² s sr.

    The Global Spline Fit, Dembinski, H. P., et al. (2017), PoS ICRC2017 533,
    arXiv:1711.11432, with the Sun's modulation of July 1998, as crflux has it.
    """
    from crflux.models import GlobalSplineFitBeta

    with warnings.catch_warnings():
        # crflux prefers later fits, which another package brings.
        warnings.simplefilter("ignore", DeprecationWarning)
        fit = GlobalSplineFitBeta()
    _, protons, neutrons = fit.p_and_n_flux(NODES_GEV + PROTON_GEV)
    return np.stack([protons, neutrons]) * NODES_GEV * LN_STEP
