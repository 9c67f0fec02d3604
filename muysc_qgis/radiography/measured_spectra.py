"""Measured muon spectra that the muon sky is fitted to, and that spectra are shown beside."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from .constants import MUON_MASS_GEV
from .materials import DATA_FOLDER
from .muon_sky import muon_sky
from .spectra import kinetic_from_momentum

#: Near-vertical spectra of BESS-TeV and L3+C.
VERTICAL = DATA_FOLDER / "muon_spectra_vertical.csv"


@dataclass(frozen=True)
class Spectra:
    """Points of measured spectra, both charges together; arrays are (n,)."""

    experiment: np.ndarray
    #: Height above sea level, m.
    altitude_m: np.ndarray
    zenith_deg: np.ndarray
    #: Momentum, GeV/c.
    momentum_gev: np.ndarray
    #: dI/dp in cm⁻² s⁻¹ sr⁻¹ (GeV/c)⁻¹, and its standard error.
    flux: np.ndarray
    error: np.ndarray

    def __len__(self) -> int:
        return len(self.flux)

    def where(self, chosen: np.ndarray) -> Spectra:
        """Return the points that a mask or an index chooses."""
        return Spectra(
            self.experiment[chosen],
            self.altitude_m[chosen],
            self.zenith_deg[chosen],
            self.momentum_gev[chosen],
            self.flux[chosen],
            self.error[chosen],
        )


@cache
def vertical_spectra() -> Spectra:
    """Return the vertical spectra that ship with the library."""
    return read_spectra(VERTICAL)


def read_spectra(path: Path) -> Spectra:
    """Return the points of a table of spectra.

    Parameters
    ----------
    path
        Text with commas: lines that start with # are comments, the next one names the
        columns, which come as the fields of `Spectra` do; an empty error is NaN.
    """
    lines = [line for line in path.read_text("utf-8").splitlines() if line and line[0] != "#"]
    rows = [line.split(",") for line in lines[1:]]
    numbers = np.array([[float(cell) if cell else np.nan for cell in row[1:6]] for row in rows])
    return Spectra(np.array([row[0] for row in rows]), *numbers.T)


#: Spectra are shown beside those of a zenith angle no farther away than this, degrees.
_NEAR_DEG = 20.0


def carried_to(zenith_deg: float, altitude_m: float) -> dict[str, tuple[np.ndarray, ...]]:
    """Return what the vertical spectra measured, as it would have been elsewhere.

    Each point is multiplied by the muon sky there over the muon sky where it was measured.

    Parameters
    ----------
    zenith_deg
        Zenith angle in degrees; spectra measured far from it are left out.
    altitude_m
        Height above sea level, m.

    Returns
    -------
    dict
        By experiment: kinetic energy in GeV, dI/dE in cm⁻² s⁻¹ sr⁻¹ GeV⁻¹ and its error.
    """
    sky = muon_sky()
    found: dict[str, tuple[np.ndarray, ...]] = {}
    every = vertical_spectra()
    for name in np.unique(every.experiment):
        points = every.where(every.experiment == name)
        own_deg, own_m = float(points.zenith_deg[0]), float(points.altitude_m[0])
        if abs(own_deg - zenith_deg) > _NEAR_DEG:
            continue
        kinetic = kinetic_from_momentum(points.momentum_gev)
        there, here = (
            sky.flux(kinetic, np.cos(np.radians(angle)), height)
            for angle, height in ((zenith_deg, altitude_m), (own_deg, own_m))
        )
        # dI/dE = dI/dp · E/p
        factor = there / here * (kinetic + MUON_MASS_GEV) / points.momentum_gev
        found[str(name)] = (kinetic, points.flux * factor, points.error * factor)
    return found
