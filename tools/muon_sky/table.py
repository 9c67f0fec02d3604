"""The table of the muon sky as it ships: nodes, values, their error, and the file."""

from __future__ import annotations

import datetime
from importlib.metadata import version
from pathlib import Path

import numpy as np

from muysc_qgis.radiography.muon_sky import read_muon_sky

from .atmosphere import air_path
from .band import unknown_error
from .cascade import Arrival, Matter, at_detector, produce
from .fit import Fit

#: Nodes of the table.
ALTITUDES_M = np.array([0.0, 600.0, 1250.0, 1900.0, 2600.0, 3300.0, 4100.0, 5000.0, 6000.0])
ZENITH_DEG = np.array(
    [0, 22, 35, 45, 53, 60, 66, 71, 75, 78.2, 80.7, 82.7, 84.3, 85.5, 86.5, 87.3, 87.9, 88.4, 88.8,
     89.1, 89.32, 89.5]
)  # fmt: skip
ENERGIES_GEV = np.concatenate(
    [np.geomspace(0.25, 30, 19, endpoint=False), np.geomspace(30, 1e6, 25)]
)


class Cascades:
    """Muons of every amplitude at any place and angle; each is followed once."""

    def __init__(self, matter: Matter, primaries: np.ndarray) -> None:
        self.matter, self.primaries = matter, primaries
        self._made: dict[tuple[float, float], object] = {}

    def arrival(self, altitude_m: float, cos_zenith: float, kinetic_gev: np.ndarray) -> Arrival:
        """Return the muons at an altitude in m, from an angle, at kinetic energies in GeV."""
        key = (altitude_m, cos_zenith)
        if key not in self._made:
            path = air_path(altitude_m, cos_zenith)
            self._made[key] = (path, produce(path, self.matter, self.primaries))
        path, made = self._made[key]
        return at_detector(made, path, self.matter, kinetic_gev)

    def muons(self, altitude_m: float, cos_zenith: float, kinetic_gev: np.ndarray) -> np.ndarray:
        """Return (n_amplitude, n_energy) muons per cm² s sr GeV."""
        return self.arrival(altitude_m, cos_zenith, kinetic_gev).muons


def error_of(
    arrival: Arrival, fitted: Fit, kinetic_gev: np.ndarray, cos_zenith: float
) -> np.ndarray:
    """Return the relative standard error: of the fit, and of what it cannot know."""
    unknown = unknown_error(kinetic_gev, arrival.made_gev, arrival.survival, cos_zenith)
    return np.hypot(fitted.relative_error(arrival.muons), unknown)


def write_table(path: Path, cascades: Cascades, fitted: Fit, notes: list[str]) -> None:
    """Compute the table and write it.

    Parameters
    ----------
    path
        Where to.
    cascades, fitted
        What the flux is made of.
    notes
        Lines on how well the fit meets its data, for the header.
    """
    cosines = np.cos(np.radians(ZENITH_DEG[::-1]))
    lines = [f"# {line}".rstrip() for line in (*_HEADER, *notes, _made())]
    lines.append(",".join(["0", "0", *(f"{c:.7f}" for c in (*cosines, *cosines))]))
    for altitude in ALTITUDES_M:
        arrivals = [cascades.arrival(altitude, float(f"{c:.7f}"), ENERGIES_GEV) for c in cosines]
        ln_flux = np.log([fitted.flux(one.muons) for one in arrivals])
        percent = 100 * np.array(
            [error_of(one, fitted, ENERGIES_GEV, c) for one, c in zip(arrivals, cosines)]
        )
        for number, energy in enumerate(ENERGIES_GEV):
            values = [f"{v:.4f}" for v in ln_flux[:, number]]
            errors = [f"{v:.3g}" for v in percent[:, number]]
            lines.append(",".join([f"{altitude:g}", f"{energy:.7g}", *values, *errors]))
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def interpolation_error(
    path: Path, cascades: Cascades, fitted: Fit
) -> tuple[float, tuple[float, ...]]:
    """Return the largest relative error of a table halfway between its nodes, and where it is.

    The place is altitude in m, zenith angle in degrees and kinetic energy in GeV.

    Parameters
    ----------
    path
        The table.
    cascades, fitted
        What it was made of.
    """
    sky, worst, place = read_muon_sky(path), 0.0, ()
    energy = np.sqrt(ENERGIES_GEV[:-1] * ENERGIES_GEV[1:])
    for altitude in (ALTITUDES_M[:-1] + ALTITUDES_M[1:]) / 2:
        for zenith in (ZENITH_DEG[:-1] + ZENITH_DEG[1:]) / 2:
            cosine = float(np.cos(np.radians(zenith)))
            exact = fitted.flux(cascades.muons(float(altitude), cosine, energy))
            off = sky.flux(energy, np.array(cosine), float(altitude)) / exact - 1.0
            if np.abs(off).max() > worst:
                worst = float(np.abs(off).max())
                place = (float(altitude), zenith, float(energy[np.abs(off).argmax()]))
    return worst, place


def _made() -> str:
    used = ", ".join(f"{name} {version(name)}" for name in ("chromo", "crflux", "mulder"))
    return f"Made by `make sky` on {datetime.date.today():%Y-%m-%d} with {used}."


_HEADER = (
    "The flux of cosmic muons, both charges, over altitude, zenith angle and kinetic energy.",
    "Primaries: Global Spline Fit (Dembinski et al. 2017, arXiv:1711.11432), modulated as in",
    "July 1998. Hadrons: SIBYLL 2.3d (Riehn et al. 2020, doi:10.1103/PhysRevD.102.063002) from",
    "60 GeV, UrQMD 3.4 (Bleicher et al. 1999, doi:10.1088/0954-3899/25/9/308) below, in a",
    "one-dimensional cascade through the U.S. Standard Atmosphere 1976 on a round Earth.",
    "Muons: mean losses in air by PUMAS (Niess 2022, doi:10.1016/j.cpc.2022.108438), decay.",
    "First line: cosines of the zenith angle at the detector, twice. Other lines: altitude in m,",
    "kinetic energy in GeV, ln of dI/dE in 1/(cm2 s sr GeV) at each angle, then the standard",
    "error in % at each angle: the fit's covariance, and what it cannot know (tools/muon_sky).",
)
