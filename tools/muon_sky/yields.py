"""What comes out of a collision with a nucleus of air: secondaries, and how often they happen.

SIBYLL 2.3d (Riehn et al. 2020, doi:10.1103/PhysRevD.102.063002) from 60 GeV and UrQMD 3.4
(Bleicher et al. 1999, doi:10.1088/0954-3899/25/9/308) below, both through chromo (Dembinski,
Fedynitch, Prosekin 2023). Some 25 minutes of one core; run two at a time.
"""

from __future__ import annotations

import time
import warnings
from multiprocessing import Pool
from pathlib import Path

import numpy as np

from .grid import NODES_GEV, deposit
from .particles import (
    HADRONS,
    LAMBDA_GEV,
    NEUTRAL_KAON_GEV,
    NEUTRON_GEV,
    PION_GEV,
    PROTON_GEV,
    two_body_momentum,
)

#: Projectiles that are simulated. Pions of one charge stand for both.
PROJECTILES = ("p", "n", "pi+", "K+", "K-")
#: Kinetic energy in GeV from which SIBYLL takes over.
JOIN_GEV = 60.0
#: Collisions for each energy in SIBYLL, fewer where muons of all but the highest energies
#: do not come from: from these energies in GeV on a half, and a fifth.
_SIBYLL_EVENTS = {"p": 12000, "n": 12000, "pi+": 6000, "K+": 3000, "K-": 3000}
_FEWER = ((7e3, 0.5), (1e5, 0.2))
#: Seconds for each energy in UrQMD.
_URQMD_SECONDS = {"p": 60.0, "n": 45.0, "pi+": 10.0, "K+": 3.0, "K-": 3.0}
#: UrQMD takes no collision with less energy in the centre of mass than this, GeV.
_URQMD_LOWEST_GEV = 2.0
#: Composition of air by number of nuclei; argon is counted as oxygen, which SIBYLL knows.
_AIR = (("N", 0.7848), ("O", 0.2152))
#: Mean mass number of air, argon included, and the atomic mass unit in g times 10²⁷ mb/cm².
AIR_MASS_NUMBER = 14.55
MB_G_CM2 = 1660.539

_INDEX = {
    2212: "p", -2212: "p", 2112: "n", -2112: "n", 211: "pi", -211: "pi",
    321: "K+", -321: "K-", 130: "K0L",
}  # fmt: skip
#: Share of charged decays of the short-lived kaon, and of the eta's in charged pions.
_K0S_CHARGED = 0.692
_ETA_PIONS = 2 * 0.27
#: Hyperons: share of decays that give a proton, and a charged pion.
_HYPERONS = {3122: (0.641, 0.641), 3222: (0.516, 0.483), 3112: (0.0, 1.0), 3212: (0.641, 0.641)}


def counted(pid: np.ndarray, kinetic: np.ndarray, mass: np.ndarray) -> np.ndarray:
    """Return (n_hadron, n_node) numbers of the secondaries that the cascade knows.

    Short-lived ones decay first, evenly over the angle.
    """
    total = np.zeros((len(HADRONS), len(NODES_GEV)))
    for code, name in _INDEX.items():
        total[HADRONS.index(name)] += deposit(kinetic[pid == code])
    draw = np.random.default_rng(3)

    def decay(chosen: np.ndarray, name: str, at_rest: float, own: float, share: float) -> None:
        gamma = 1.0 + kinetic[chosen] / mass[chosen]
        momentum = np.sqrt(at_rest**2 - own**2)
        cosine = draw.uniform(-1, 1, gamma.size)
        lab = gamma * at_rest + np.sqrt(gamma**2 - 1) * momentum * cosine - own
        total[HADRONS.index(name)] += share * deposit(lab)

    for _ in range(2):  # two charged pions
        decay(pid == 310, "pi", NEUTRAL_KAON_GEV / 2, PION_GEV, _K0S_CHARGED)
    # The pions of an eta share its energy; their number is what counts here.
    decay(pid == 221, "pi", 0.5479 / 3, PION_GEV, _ETA_PIONS)
    for code, (protons, pions) in _HYPERONS.items():
        momentum = two_body_momentum(LAMBDA_GEV, PROTON_GEV, PION_GEV)
        for sign in (1, -1):
            one = pid == sign * code
            decay(one, "p", float(np.hypot(momentum, PROTON_GEV)), PROTON_GEV, protons)
            decay(one, "n", float(np.hypot(momentum, NEUTRON_GEV)), NEUTRON_GEV, 1 - protons)
            decay(one, "pi", float(np.hypot(momentum, PION_GEV)), PION_GEV, pions)
    return total


def _simulate(task: tuple[str, int]) -> tuple[str, int, float, np.ndarray]:
    """Return projectile, node, production cross-section in mb, and secondaries a collision."""
    from chromo.kinematics import CompositeTarget, FixedTarget, KinEnergy

    projectile, node = task
    kinetic = float(NODES_GEV[node])
    air = CompositeTarget(list(_AIR))
    generator = _generator(kinetic >= JOIN_GEV)
    generator.kinematics = FixedTarget(KinEnergy(kinetic), projectile, air)
    if kinetic >= JOIN_GEV:
        section = float(generator.cross_section().prod)
        share = min([1.0, *(share for start, share in _FEWER if kinetic > start)])
        number, found = _run(generator, int(share * _SIBYLL_EVENTS[projectile]))
        return projectile, node, section, found / number
    # UrQMD draws collisions until mesons are made, and knows no cross-section for that.
    number, found = 0, np.zeros((len(HADRONS), len(NODES_GEV)))
    end = time.monotonic() + _URQMD_SECONDS[projectile]
    while time.monotonic() < end:
        some = _run(generator, 200)
        number, found = number + some[0], found + some[1]
    return projectile, node, np.nan, found / number


def _run(generator, events: int) -> tuple[int, np.ndarray]:
    pid, energy, mass = [], [], []
    for event in generator(events):
        final = event.final_state()
        pid.append(np.array(final.pid))
        energy.append(np.array(final.en))
        mass.append(np.array(final.m))
    return events, _counted(pid, energy, mass)


def _counted(pid: list, energy: list, mass: list) -> np.ndarray:
    codes, masses = np.concatenate(pid), np.concatenate(mass)
    return counted(codes, np.maximum(np.concatenate(energy) - masses, 0.0), masses)


_made: dict[bool, object] = {}


def _generator(high: bool):
    """Return SIBYLL or UrQMD, one of each in a process."""
    if high not in _made:
        from chromo.kinematics import CompositeTarget, FixedTarget, KinEnergy
        from chromo.models import Sibyll23d, UrQMD34

        warnings.simplefilter("ignore")
        air = CompositeTarget(list(_AIR))
        top = NODES_GEV[-1] if high else JOIN_GEV
        _made[high] = (Sibyll23d if high else UrQMD34)(
            FixedTarget(KinEnergy(float(top)), "p", air), seed=20
        )
    return _made[high]


def _possible(projectile: str, kinetic: float) -> bool:
    mass = {"p": PROTON_GEV, "n": NEUTRON_GEV, "pi+": PION_GEV}.get(projectile, 0.4937)
    squared = mass**2 + PROTON_GEV**2 + 2 * PROTON_GEV * (kinetic + mass)
    return bool(squared > (1.02 * _URQMD_LOWEST_GEV) ** 2)


def make_yields(path: Path, processes: int = 2) -> None:
    """Simulate all collisions and write them to an npz file, going on where one was left.

    ``section``: (n_projectile, n_node) mb; ``yields``: (n_projectile, n_node, n_hadron,
    n_node) secondaries a collision. Below SIBYLL's energies the cross-section is taken to be
    that of its lowest; where UrQMD has no answer collisions absorb.
    """
    size = len(NODES_GEV)
    section = np.full((len(PROJECTILES), size), np.nan)
    secondaries = np.zeros((len(PROJECTILES), size, len(HADRONS), size))
    begun = path.with_name(f"{path.stem}_begun.npz")
    if begun.exists():
        kept = np.load(begun)
        section, secondaries = kept["section"], kept["yields"]
    tasks = [
        (projectile, node)
        for node, kinetic in enumerate(NODES_GEV)
        for row, projectile in enumerate(PROJECTILES)
        if _possible(projectile, float(kinetic)) and not secondaries[row, node].any()
    ]
    start = time.monotonic()
    with Pool(processes) as pool:
        for done, (projectile, node, mb, found) in enumerate(
            pool.imap_unordered(_simulate, tasks), 1
        ):
            row = PROJECTILES.index(projectile)
            section[row, node], secondaries[row, node] = mb, found
            if done % 20 == 0:
                np.savez(begun, section=section, yields=secondaries)
                print(
                    f"{done} of {len(tasks)} energies, {time.monotonic() - start:.0f} s", flush=True
                )
    low = NODES_GEV < JOIN_GEV
    section[:, low] = section[:, np.count_nonzero(low), None]
    np.savez_compressed(path, section=section, yields=secondaries)
    begun.unlink(missing_ok=True)
