"""The grid of kinetic energies that hadrons and muons are counted on, and how to fill it."""

from __future__ import annotations

import numpy as np

#: Nodes a decade, as wide apart as the cells that the particles are counted in.
NODES_PER_DECADE = 8
#: Kinetic energies of the nodes in GeV: 0.1 GeV to 10⁸ GeV.
NODES_GEV = 10.0 ** (np.arange(-8, 8 * NODES_PER_DECADE + 1) / NODES_PER_DECADE)
#: Width of a cell in ln T.
LN_STEP = float(np.log(10.0) / NODES_PER_DECADE)

#: Besides the number of particles their sum of T^1.7 is kept, because a parent spectrum
#: T^-2.7 weights its daughters that way (Gaisser 1990, the spectrum-weighted moments).
_MOMENT = 1.7


def deposit(kinetic_gev: np.ndarray, weight: np.ndarray | float = 1.0) -> np.ndarray:
    """Return how many particles each node gets, keeping their number and their moment.

    A particle between two nodes goes to both, in shares that keep the sum of T^0 and of
    T^1.7. Particles below the first node are dropped, those above the last go there.

    Parameters
    ----------
    kinetic_gev
        (n,) kinetic energies in GeV.
    weight
        (n,) numbers of particles, or one for all.

    Returns
    -------
    numpy.ndarray
        (len(NODES_GEV),) numbers of particles.
    """
    kinetic_gev = np.asarray(kinetic_gev, dtype=float)
    keep = kinetic_gev >= NODES_GEV[0]
    energy = np.minimum(kinetic_gev[keep], NODES_GEV[-1])
    weight = np.broadcast_to(weight, kinetic_gev.shape)[keep]
    moments = NODES_GEV**_MOMENT
    low = np.clip(np.searchsorted(NODES_GEV, energy, side="right") - 1, 0, len(NODES_GEV) - 2)
    share = (energy**_MOMENT - moments[low]) / (moments[low + 1] - moments[low])
    share = np.clip(share, 0.0, 1.0)
    size = len(NODES_GEV)
    return np.bincount(low, weight * (1.0 - share), size) + np.bincount(
        low + 1, weight * share, size
    )
