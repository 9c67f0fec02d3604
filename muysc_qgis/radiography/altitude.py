"""More muons at altitude: the correction of the sea-level spectrum."""

from __future__ import annotations

import numpy as np

#: Scale height of the flux, m: a constant and a slope per GeV/c (Hebbeker &
#: Timmermans 2002, doi:10.1016/S0927-6505(01)00180-3).
_SCALE_HEIGHT_M = 4900.0
_SCALE_HEIGHT_M_PER_GEV = 750.0

#: Highest altitude, m, and lowest momentum, GeV/c, of the data behind the correction.
MAXIMUM_ALTITUDE_M = 1000.0
MINIMUM_MOMENTUM_GEV = 10.0


def altitude_factor(momentum_gev: np.ndarray, altitude_m: float) -> np.ndarray:
    """Return the muon flux at an altitude over that at sea level.

    exp(h/h0) with h0 = 4900 m + 750 m · p/(GeV/c).

    Parameters
    ----------
    momentum_gev
        Muon momentum in GeV/c, any shape.
    altitude_m
        Height h above sea level, m.
    """
    return np.exp(altitude_m / (_SCALE_HEIGHT_M + _SCALE_HEIGHT_M_PER_GEV * momentum_gev))
