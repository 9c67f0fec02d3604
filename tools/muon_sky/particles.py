"""Masses, lifetimes and decays of the particles between the primaries and the muons.

Values: Workman, R. L., et al. (Particle Data Group) (2022), Prog. Theor. Exp. Phys.
2022, 083C01, doi:10.1093/ptep/ptac097.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from .grid import NODES_GEV, deposit

MUON_GEV = 0.1056583755
PION_GEV = 0.13957039
NEUTRAL_PION_GEV = 0.1349768
KAON_GEV = 0.493677
NEUTRAL_KAON_GEV = 0.497611
PROTON_GEV = 0.93827209
NEUTRON_GEV = 0.93956542
LAMBDA_GEV = 1.115683
#: Mean life of the muon times the speed of light, cm.
MUON_CTAU_CM = 65_863.8

#: Order in which the cascade keeps the hadrons. Pions of both charges are one kind: air
#: has as many neutrons as protons, so what one charge does the other does mirrored.
HADRONS = ("p", "n", "pi", "K+", "K-", "K0L")
MASS_GEV = np.array([PROTON_GEV, NEUTRON_GEV, PION_GEV, KAON_GEV, KAON_GEV, NEUTRAL_KAON_GEV])
#: Mean life times the speed of light, cm.
CTAU_CM = np.array([np.inf, np.inf, 780.45, 371.1, 371.1, 1533.6])

#: Branching ratios.
_K_TO_MU = 0.6356
_K_TO_2PI = 0.2067
_K_TO_3PI_CHARGED = 0.05583
_K_TO_3PI_NEUTRAL = 0.0176
_K_TO_PI_MU = 0.03352
_KL_TO_PI_MU = 0.2704
_KL_TO_PI_E = 0.4055
_KL_TO_3PI = 0.1254

#: Quantiles of the angle of a decay, and draws of decays into three.
_ANGLES = 400
_DRAWS = 4000


def two_body_momentum(parent: float, first: float, second: float) -> float:
    """Return the momentum in GeV/c of both daughters where the parent rests (masses in GeV)."""
    return float(
        np.sqrt((parent**2 - (first + second) ** 2) * (parent**2 - (first - second) ** 2))
        / (2.0 * parent)
    )


@cache
def three_body_energies(parent: float, masses: tuple[float, float, float]) -> np.ndarray:
    """Return (n, 3) energies in GeV of three daughters where the parent rests.

    Even over the Dalitz plot, which is phase space alone.
    """
    draw = np.random.default_rng(1)
    a, b, c = masses
    found: list[np.ndarray] = []
    number = 0
    while number < _DRAWS:
        # The Dalitz plot is even in the energies of two daughters.
        first = draw.uniform(a, (parent**2 + a**2 - (b + c) ** 2) / (2 * parent), 4 * _DRAWS)
        second = draw.uniform(b, (parent**2 + b**2 - (a + c) ** 2) / (2 * parent), 4 * _DRAWS)
        third = parent - first - second
        momenta = np.sqrt(
            np.maximum(np.stack([first**2 - a**2, second**2 - b**2, third**2 - c**2]), 0.0)
        )
        closes = (2.0 * momenta.max(axis=0) <= momenta.sum(axis=0)) & (third >= c)
        found.append(np.stack([first, second, third], axis=1)[closes])
        number += int(closes.sum())
    return np.concatenate(found)[:_DRAWS]


def boosted(
    energy: np.ndarray | float, mass: float, parent_kinetic: float, parent_mass: float
) -> np.ndarray:
    """Return kinetic energies in GeV after a boost, over even cosines of the angle.

    Parameters
    ----------
    energy
        One energy where the parent rests, or one for each angle.
    mass
        Of the daughter.
    parent_kinetic, parent_mass
        Of the parent; all in GeV.
    """
    energy = np.atleast_1d(energy)
    count = max(_ANGLES, energy.size)
    cosine = (np.arange(count) + 0.5) / count * 2.0 - 1.0
    if energy.size > 1:
        cosine = np.random.default_rng(2).permutation(cosine)
    gamma = 1.0 + parent_kinetic / parent_mass
    momentum = np.sqrt(np.maximum(energy**2 - mass**2, 0.0))
    return gamma * energy + np.sqrt(gamma**2 - 1.0) * momentum * cosine - mass


def _decays(hadron: str) -> list[tuple[str, float, np.ndarray | float, float]]:
    """Return daughter, number of them a decay, energies at rest and mass, for each kind."""
    if hadron == "pi":
        momentum = two_body_momentum(PION_GEV, MUON_GEV, 0.0)
        return [("mu", 1.0, float(np.hypot(momentum, MUON_GEV)), MUON_GEV)]
    if hadron in ("K+", "K-"):
        to_muon = two_body_momentum(KAON_GEV, MUON_GEV, 0.0)
        to_pion = two_body_momentum(KAON_GEV, PION_GEV, NEUTRAL_PION_GEV)
        charged = three_body_energies(KAON_GEV, (PION_GEV, PION_GEV, PION_GEV))
        neutral = three_body_energies(KAON_GEV, (PION_GEV, NEUTRAL_PION_GEV, NEUTRAL_PION_GEV))
        semi = three_body_energies(KAON_GEV, (MUON_GEV, NEUTRAL_PION_GEV, 0.0))
        return [
            ("mu", _K_TO_MU, float(np.hypot(to_muon, MUON_GEV)), MUON_GEV),
            ("mu", _K_TO_PI_MU, semi[:, 0], MUON_GEV),
            ("pi", _K_TO_2PI, float(np.hypot(to_pion, PION_GEV)), PION_GEV),
            ("pi", 3 * _K_TO_3PI_CHARGED, charged[:, 0], PION_GEV),
            ("pi", _K_TO_3PI_NEUTRAL, neutral[:, 0], PION_GEV),
        ]
    if hadron == "K0L":
        with_muon = three_body_energies(NEUTRAL_KAON_GEV, (MUON_GEV, PION_GEV, 0.0))
        with_electron = three_body_energies(NEUTRAL_KAON_GEV, (0.000511, PION_GEV, 0.0))
        three = three_body_energies(NEUTRAL_KAON_GEV, (PION_GEV, PION_GEV, NEUTRAL_PION_GEV))
        return [
            ("mu", _KL_TO_PI_MU, with_muon[:, 0], MUON_GEV),
            ("pi", _KL_TO_PI_MU, with_muon[:, 1], PION_GEV),
            ("pi", _KL_TO_PI_E, with_electron[:, 1], PION_GEV),
            ("pi", 2 * _KL_TO_3PI, three[:, 0], PION_GEV),
        ]
    return []


@cache
def decay_matrix(hadron: str, daughter: str) -> np.ndarray:
    """Return (n_node, n_node) daughters at each node (second axis) of a decay at each (first)."""
    mass = float(MASS_GEV[HADRONS.index(hadron)])
    matrix = np.zeros((len(NODES_GEV), len(NODES_GEV)))
    for name, number, energy, daughter_mass in _decays(hadron):
        if name != daughter:
            continue
        for row, kinetic in enumerate(NODES_GEV):
            spectrum = boosted(energy, daughter_mass, kinetic, mass)
            matrix[row] += number / spectrum.size * deposit(spectrum)
    return matrix
