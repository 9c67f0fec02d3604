"""Energy loss of muons in matter, their range, and the energy that rock demands.

Three range laws R(E), each a monotone curve of kinetic energy:

``csda``
    The range in the continuous-slowing-down approximation, from the material's table.
``lesparre``
    The same integral ∫dE/S over the polynomial of Lesparre et al. (2010) for
    standard rock, fitted up to 1 TeV.
``paper``
    E/S with that polynomial, E being the total energy. It is not a range: it has its
    maximum at 1878 GeV and 613 m of standard rock, beyond which it has no answer.
    Kept to reproduce the published numbers.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from .constants import MUON_MASS_GEV
from .interpolation import HermiteCurve
from .materials import energy_loss_table

if TYPE_CHECKING:
    from .settings import Physics

#: Range laws by their names in the interface, with the work to cite for each.
ENERGY_LOSSES = {
    "csda": "tables made with mulder and PUMAS: Niess (2022), doi:10.1016/j.cpc.2022.108438",
    "lesparre": "Lesparre et al. (2010), doi:10.1111/j.1365-246X.2010.04790.x",
    "paper": "Lesparre et al. (2010), doi:10.1111/j.1365-246X.2010.04790.x, used as in MUYSC",
}

#: l4 to l0 of log10(S / MeV g⁻¹ cm²) as a polynomial of log10(E / GeV), standard rock
#: (Lesparre et al. 2010, doi:10.1111/j.1365-246X.2010.04790.x).
_LESPARRE = (0.0154, -0.0461, 0.0368, 0.0801, 0.2549)

#: Energy in GeV up to which the polynomial follows the tables it was fitted to.
LESPARRE_LIMIT_GEV = 1000.0

#: log10 of the kinetic energies in GeV between which the polynomial is tabulated. Above
#: 10 TeV, where it is three times too high, it has no answer.
_LESPARRE_DECADES = (-3.0, 4.0)
_LESPARRE_KNOTS = 281


@dataclass(frozen=True)
class RangeLaw:
    """R(E) and its inverse on the energies where both are known."""

    #: ln(range, g/cm²) of ln(energy, GeV).
    range_of_energy: HermiteCurve
    #: ln(energy, GeV) of ln(range, g/cm²).
    energy_of_range: HermiteCurve
    #: Energy of the law minus kinetic energy, GeV: the muon mass if the law is in total energy.
    rest_energy_gev: float

    @property
    def maximum_range_g_cm2(self) -> float:
        """Largest range that has an energy, g/cm²."""
        return float(np.exp(self.energy_of_range.x[-1]))


def _lesparre_stopping_power(kinetic_energy_gev: np.ndarray) -> np.ndarray:
    """Return dE/dϱ of the polynomial in GeV cm²/g."""
    exponent = np.polyval(_LESPARRE, np.log10(kinetic_energy_gev))
    return 10.0 ** (exponent - 3.0)  # MeV to GeV


def stopping_power(
    kinetic_energy_gev: np.ndarray, material: str = "standard_rock", energy_loss: str = "csda"
) -> np.ndarray:
    """Return the mean energy loss of muons.

    Parameters
    ----------
    kinetic_energy_gev
        Kinetic energy in GeV, any shape, above 0.
    material
        Key of `MATERIALS`; only ``csda`` distinguishes materials.
    energy_loss
        ``csda``, or ``lesparre`` or ``paper``, which share the polynomial
        S = 10^(l4 x⁴ + l3 x³ + l2 x² + l1 x + l0) MeV g⁻¹ cm², x = log10(E/GeV).

    Returns
    -------
    numpy.ndarray
        GeV cm²/g; NaN outside the table (1 MeV to 10⁹ GeV).
    """
    if energy_loss != "csda":
        return _lesparre_stopping_power(np.asarray(kinetic_energy_gev, dtype=float))
    return np.exp(_stopping_curve(material)(np.log(kinetic_energy_gev)))


@cache
def _stopping_curve(material: str) -> HermiteCurve:
    """Return ln(stopping power) of ln(kinetic energy)."""
    table = energy_loss_table(material)
    return HermiteCurve.through(np.log(table.kinetic_energy_gev), np.log(table.stopping_power))


def range_law(material: str = "standard_rock", energy_loss: str = "csda") -> RangeLaw:
    """Return the range law of a material, made at the first call.

    Parameters
    ----------
    material
        Key of `MATERIALS`; only ``csda`` distinguishes materials.
    energy_loss
        One of `ENERGY_LOSSES`.
    """
    return _range_law(material if energy_loss == "csda" else "standard_rock", energy_loss)


@cache
def _range_law(material: str, energy_loss: str) -> RangeLaw:
    if energy_loss == "csda":
        table = energy_loss_table(material)
        energy, length = table.kinetic_energy_gev, table.csda_range
        slope = energy / (table.stopping_power * length)  # dlnR/dlnE, as dR/dE = 1/S
    elif energy_loss == "lesparre":
        energy = np.logspace(*_LESPARRE_DECADES, _LESPARRE_KNOTS)
        length = _lesparre_range(energy)
        slope = energy / (_lesparre_stopping_power(energy) * length)
    else:
        log_energy = _up_to_the_peak()
        energy = 10.0**log_energy
        length = energy / _lesparre_stopping_power(energy)
        slope = 1.0 - np.polyval(np.polyder(_LESPARRE), log_energy)
    ln_energy, ln_range = np.log(energy), np.log(length)
    return RangeLaw(
        HermiteCurve(ln_energy, ln_range, slope),
        HermiteCurve(ln_range, ln_energy, 1.0 / slope),
        rest_energy_gev=MUON_MASS_GEV if energy_loss == "paper" else 0.0,
    )


def _lesparre_range(kinetic_energy_gev: np.ndarray) -> np.ndarray:
    """Return ∫dE/S of the polynomial at increasing energies, starting from E/S at the first."""
    ln_energy = np.log(kinetic_energy_gev)
    half = np.diff(ln_energy) / 2
    nodes, weights = np.polynomial.legendre.leggauss(3)
    energy = np.exp((ln_energy[:-1] + half)[:, None] + half[:, None] * nodes)
    pieces = half * ((energy / _lesparre_stopping_power(energy)) @ weights)
    first = kinetic_energy_gev[0] / _lesparre_stopping_power(kinetic_energy_gev[0])
    return first + np.concatenate(([0.0], np.cumsum(pieces)))


def _up_to_the_peak() -> np.ndarray:
    """Return log10(E/GeV) from 1 MeV to just below the maximum of E/S.

    The knots close in on the maximum, where the inverse rises vertically.
    """
    # dln(E/S)/dlnE = 1 − dlog10 S/dlog10 E vanishes at the maximum.
    roots = np.roots(np.polysub([1.0], np.polyder(_LESPARRE)))
    peak = roots[np.isreal(roots)].real.min()
    near = 0.05
    even = np.linspace(_LESPARRE_DECADES[0], peak - near, _LESPARRE_KNOTS)
    closing_in = peak - near * np.geomspace(1.0, 1e-5, _LESPARRE_KNOTS)
    return np.concatenate((even, closing_in[1:]))


def csda_range(
    kinetic_energy_gev: np.ndarray, material: str = "standard_rock", energy_loss: str = "csda"
) -> np.ndarray:
    """Return how much matter a muon crosses before it stops.

    Parameters
    ----------
    kinetic_energy_gev
        Kinetic energy in GeV, any shape, 0 or more.
    material
        Key of `MATERIALS`; only ``csda`` distinguishes materials.
    energy_loss
        One of `ENERGY_LOSSES`.

    Returns
    -------
    numpy.ndarray
        g/cm²; NaN above the highest energy of the range law. Below 1 MeV the range
        is taken as proportional to the energy.
    """
    law = range_law(material, energy_loss)
    energy = np.asarray(kinetic_energy_gev, dtype=float) + law.rest_energy_gev
    return _through_origin(law.range_of_energy, energy)


def minimum_energy(opacity_g_cm2: np.ndarray, physics: Physics) -> np.ndarray:
    """Return the kinetic energy that a muon needs to be seen behind rock.

    R(E_min) = ϱ + R(E_det), with the range law of `physics` and the detection
    threshold E_det.

    Parameters
    ----------
    opacity_g_cm2
        Opacity ϱ in g/cm², any shape, 0 or more.
    physics
        Material, range law and threshold.

    Returns
    -------
    numpy.ndarray
        GeV; NaN where the opacity is NaN or the range law has no answer.
    """
    threshold = physics.threshold_gev
    opacity_g_cm2 = np.asarray(opacity_g_cm2, dtype=float)
    law = range_law(physics.material, physics.energy_loss)
    total = opacity_g_cm2
    if threshold > 0:
        total = total + csda_range(np.array(threshold), physics.material, physics.energy_loss)
    energy = _through_origin(law.energy_of_range, total) - law.rest_energy_gev
    # No rock, no loss: exactly the threshold, and an answer even beyond the range law.
    return np.where(opacity_g_cm2 == 0, threshold, np.maximum(energy, threshold))


def _through_origin(curve: HermiteCurve, value: np.ndarray) -> np.ndarray:
    """Return exp(curve(ln value)), in proportion to the value below the first knot."""
    first = np.exp(curve.x[0])
    return np.exp(curve(np.log(np.maximum(value, first)))) * np.minimum(value / first, 1.0)
