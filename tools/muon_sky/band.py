"""What the fit cannot know of the sky: an error besides that of its amplitudes.

Added in quadrature, each a relative standard error:

- 4 % everywhere: season and pressure (2 to 4 % of the open sky, 1 % behind rock), and the
  spread of spectrometers among each other where all of them are at their best;
- up to 11 % towards the horizon, where spectrometers that were left out of the fit scatter
  by that much and more, and where nothing vertical tells kaons from pions;
- the Sun and the geomagnetic cutoff, which move the primaries below some tens of GeV: 10 %
  of vertical muons above 1 GeV/c, falling as the energy that the muon had where it was made;
- decay on the way: the survival of slow inclined muons hangs on where they were made and
  on their losses; a twelfth of the logarithm of it;
- above 100 GeV the share of kaons at large angles and the primaries near the knee: 4 % a
  decade.

docs/physics.md lists the sizes of what moves the flux in time and place, and what these
numbers were held against: spectra that took no part in the fit.
"""

from __future__ import annotations

import numpy as np

_EVERYWHERE = 0.04
_INCLINED = 0.11
_SUN_AT_1_GEV, _LOSS_GEV = 0.10, 2.0
_DECAY = 1.0 / 12.0
_HIGH, _HIGH_FROM_GEV = 0.04, 100.0


def unknown_error(
    kinetic_gev: np.ndarray, made_gev: np.ndarray, survival: np.ndarray, cos_zenith: float
) -> np.ndarray:
    """Return the relative standard error that no fit to vertical spectra knows.

    Parameters
    ----------
    kinetic_gev
        Kinetic energy at the detector, GeV.
    made_gev
        Mean kinetic energy of these muons where they were made, GeV.
    survival
        Share of them that reaches the detector. All broadcast.
    cos_zenith
        Cosine of the zenith angle.
    """
    sun = _SUN_AT_1_GEV * (1.0 + _LOSS_GEV) / made_gev
    decay = _DECAY * np.abs(np.log(survival))
    high = _HIGH * np.log10(np.maximum(kinetic_gev / _HIGH_FROM_GEV, 1.0))
    inclined = _INCLINED * (1.0 - cos_zenith)
    return np.sqrt(_EVERYWHERE**2 + inclined**2 + sun**2 + decay**2 + high**2)
