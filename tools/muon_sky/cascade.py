"""The hadron cascade down a line of air, and the muons that reach its end.

One-dimensional: all goes straight on. The hadrons of each cell of energy are followed in
exponential steps of slant depth, in which they interact or decay; the muons then lose
energy and decay along the same line. Everything is linear in the amplitudes of meson
production by nucleons, so that one cascade gives the muons of each amplitude.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from scipy.interpolate import PchipInterpolator

from .atmosphere import AirPath
from .grid import LN_STEP, NODES_GEV
from .particles import CTAU_CM, HADRONS, MASS_GEV, MUON_CTAU_CM, MUON_GEV, decay_matrix
from .yields import AIR_MASS_NUMBER, MB_G_CM2, PROJECTILES

NUCLEONS, MESONS = (0, 1), (2, 3, 4, 5)
#: Projectile energies in GeV of the amplitudes of pion production; tents in the logarithm.
PION_TENTS_GEV = (4.0, 15.0, 60.0, 400.0, 6000.0)
#: What each amplitude scales.
AMPLITUDES = (*(f"pions at {energy:g} GeV" for energy in PION_TENTS_GEV), "kaons")

_CM2_PER_M2 = 1e4
#: Every so many points of a line are stepped through by muons, and the step of the energy
#: that widths are taken over.
_ALONG, _STEP = 8, 1e-3
#: Slant depth in g/cm² of the first step, its growth, the widest, and where all hadrons are gone.
_FIRST, _GROWTH, _WIDEST, _LAST = 0.02, 1.2, 10.0, 3000.0


def tents(energy_gev: np.ndarray) -> np.ndarray:
    """Return (n_tent, n) shares of the pion amplitudes at projectile energies; their sum is 1."""
    corners = np.log(PION_TENTS_GEV)
    return np.stack([np.interp(np.log(energy_gev), corners, row) for row in np.eye(len(corners))])


@dataclass(frozen=True)
class Matter:
    """Collisions, decays and losses in air, ready for the cascade."""

    #: (n_hadron, n_node) interactions a g/cm².
    interaction: np.ndarray
    #: (n_hadron, n_node, n_hadron, n_node) secondaries a collision.
    secondaries: np.ndarray
    #: Muons in air: ln of the kinetic energies in GeV and of the densities in g/cm³, even,
    muon_ln_energy: np.ndarray
    muon_ln_density: np.ndarray
    #: and (n_density, n_energy) ln of the stopping power in GeV cm²/g. Thin air slows fast
    #: muons more, by up to 7 %, because it polarises less.
    muon_ln_loss: np.ndarray

    @classmethod
    def read(cls, yields: Path) -> Matter:
        """Return it from the file of `make_yields`, and mulder's table of air."""
        import mulder

        stored = np.load(yields)
        section, simulated = smoothed(stored["section"]), smoothed_yields(stored["yields"])
        row = {name: PROJECTILES.index(name) for name in PROJECTILES}
        kaons = (simulated[row["K+"]] + simulated[row["K-"]]) / 2
        sections = [section[row[name]] for name in ("p", "n", "pi+", "K+", "K-", "K+")]
        secondaries = np.stack(
            [*(simulated[row[name]] for name in ("p", "n", "pi+", "K+", "K-")), kaons]
        )
        energy = np.geomspace(1e-2, 1e9, 1101)
        density = np.geomspace(1e-8, 1.3e-3, 12)
        return cls(
            np.stack(sections) / (AIR_MASS_NUMBER * MB_G_CM2),
            secondaries,
            np.log(energy),
            np.log(density),
            np.log([_loss_in_air(mulder, energy, one) for one in density]),
        )

    def loss(self, kinetic_gev: np.ndarray, density_g_cm3: float) -> np.ndarray:
        """Return the stopping power of air for muons, GeV cm²/g."""
        return np.exp(
            _bilinear(
                self.muon_ln_density, self.muon_ln_energy, self.muon_ln_loss,
                np.log(density_g_cm3), np.log(kinetic_gev),
            )
        )  # fmt: skip

    @cached_property
    def from_nucleons(self) -> np.ndarray:
        """(n_amplitude, n_nucleon, n_node, n_meson, n_node) mesons a collision."""
        full = self.secondaries[np.ix_(NUCLEONS, range(len(NODES_GEV)), MESONS)]
        parts = np.zeros((len(AMPLITUDES), *full.shape))
        for number, share in enumerate(tents(NODES_GEV)):
            parts[number, :, :, 0] = share[None, :, None] * full[:, :, 0]
        parts[-1, :, :, 1:] = full[:, :, 1:]
        return parts


def _loss_in_air(mulder, energy_gev: np.ndarray, density_g_cm3: float) -> np.ndarray:
    """Return PUMAS' stopping power in GeV cm²/g of air of a density."""
    from mulder.materials import Material

    air = mulder.Physics().compile("Air").definition
    name = f"air_{density_g_cm3:.3e}"
    Material.define(name, composition=dict(air.composition), density=density_g_cm3 * 1e3, I=air.I)
    per_m = mulder.Physics().compile(name).stopping_power(energy_gev)
    return np.asarray(per_m) / (100.0 * density_g_cm3)


def _bilinear(
    rows: np.ndarray, columns: np.ndarray, table: np.ndarray, row: float, column: np.ndarray
) -> np.ndarray:
    """Interpolate a table with evenly spaced axes, at one row and many columns."""
    at = np.clip((row - rows[0]) / (rows[1] - rows[0]), 0, len(rows) - 1 - 1e-9)
    low = int(at)
    curve = table[low] + (at - low) * (table[low + 1] - table[low])
    place = np.clip((column - columns[0]) / (columns[1] - columns[0]), 0, len(columns) - 1 - 1e-9)
    cell = place.astype(int)
    return curve[cell] + (place - cell) * (curve[cell + 1] - curve[cell])


def smoothed(section: np.ndarray) -> np.ndarray:
    """Return cross-sections averaged over neighbouring energies, against their noise."""
    padded = np.pad(section, ((0, 0), (1, 1)), mode="edge")
    return 0.25 * padded[:, :-2] + 0.5 * section + 0.25 * padded[:, 2:]


def smoothed_yields(yields: np.ndarray) -> np.ndarray:
    """Return yields averaged over neighbouring projectiles, at the same share of the energy."""
    result = 0.5 * yields
    for shift in (-1, 1):
        moved = np.roll(yields, (shift, shift), axis=(1, 3))
        # What was rolled over the ends, or has no secondaries, keeps its own.
        edge = 0 if shift == 1 else -1
        moved[:, edge] = yields[:, edge]
        moved[..., edge] = yields[..., edge]
        empty = moved.sum(axis=(2, 3), keepdims=True) == 0
        result += 0.25 * np.where(empty, yields, moved)
    result[yields.sum(axis=(2, 3)) == 0] = 0.0
    return result


@dataclass(frozen=True)
class Production:
    """Muons made along a line."""

    #: (n_step,) distance of the middle of a step from the detector, cm, and depth, g/cm².
    distance_cm: np.ndarray
    depth: np.ndarray
    #: (n_step, n_amplitude, n_node) muons in each cell, per m² s sr.
    muons: np.ndarray


def depths(total: float) -> np.ndarray:
    """Return the slant depths in g/cm² between which the steps go."""
    edges = [0.0, _FIRST]
    end = min(total, _LAST)
    while edges[-1] < end:
        edges.append(edges[-1] + min(edges[-1] * (_GROWTH - 1.0), _WIDEST))
    edges[-1] = end
    return np.array(edges)


def produce(path: AirPath, matter: Matter, primaries: np.ndarray) -> Production:
    """Follow the hadrons down a line.

    Parameters
    ----------
    path
        The line.
    matter
        See there.
    primaries
        (2, n_node) protons and neutrons in each cell at the top, per m² s sr.
    """
    edges = depths(path.total)
    middle = np.sqrt(np.maximum(edges[:-1], _FIRST / 4) * edges[1:])
    distance, density = path.at_depth(middle)
    momentum = np.sqrt(NODES_GEV * (NODES_GEV + 2 * MASS_GEV[:, None]))
    per_cm = MASS_GEV[:, None] / (momentum * CTAU_CM[:, None])
    size = len(NODES_GEV)
    nn = matter.secondaries[np.ix_(NUCLEONS, range(size), NUCLEONS)].reshape(2 * size, 2 * size)
    nm = matter.from_nucleons.reshape(len(AMPLITUDES), 2 * size, 4 * size)
    mm = matter.secondaries[np.ix_(MESONS, range(size), MESONS)].reshape(4 * size, 4 * size)
    names = [HADRONS[one] for one in MESONS]
    to_pion = np.stack([decay_matrix(name, "pi") for name in names])
    to_muon = np.stack([decay_matrix(name, "mu") for name in names])
    hit_n = matter.interaction[list(NUCLEONS)].ravel()
    hit_m = matter.interaction[list(MESONS)].ravel()
    nucleons = primaries.ravel().astype(float)
    mesons = np.zeros((len(AMPLITUDES), 4 * size))
    muons = np.empty((len(middle), len(AMPLITUDES), size))
    for step, width in enumerate(np.diff(edges)):
        decay = (per_cm[list(MESONS)] / density[step]).ravel()
        stay_n = np.exp(-hit_n * width)
        rate = hit_m + decay
        stay_m = np.exp(-rate * width)
        # Mean over the step of what enters it, and of what is born evenly within it.
        old = -np.expm1(-rate * width) / (rate * width)
        new = (1.0 - old) / rate
        old_n = -np.expm1(-hit_n * width) / (hit_n * width)
        born_n = (nucleons * old_n * hit_n) @ nn
        for _ in range(2):
            mean_n = nucleons * old_n + born_n * (1.0 - old_n) / hit_n
            born_n = (mean_n * hit_n) @ nn
        collisions = mean_n * hit_n
        source = np.einsum("i,aij->aj", collisions, nm)
        born = source
        for _ in range(2):
            mean = mesons * old + born * new
            decays = (mean * decay).reshape(len(AMPLITUDES), 4, size)
            feed = np.zeros_like(decays)
            feed[:, 0] = np.einsum("ahi,hij->aj", decays[:, 1:], to_pion[1:])
            born = source + (mean * hit_m) @ mm + feed.reshape(len(AMPLITUDES), -1)
        mean = mesons * old + born * new
        decays = (mean * decay).reshape(len(AMPLITUDES), 4, size)
        muons[step] = np.einsum("ahi,hij->aj", decays, to_muon) * width
        mesons = mesons * stay_m + born * old * width
        nucleons = nucleons * stay_n + born_n * old_n * width
    return Production(distance, middle, muons)


@dataclass(frozen=True)
class Arrival:
    """Muons at a detector, by kinetic energy there."""

    #: (n_amplitude, n_energy) per cm² s sr GeV.
    muons: np.ndarray
    #: (n_energy,) mean kinetic energy in GeV where they were made, in the logarithm.
    made_gev: np.ndarray
    #: (n_energy,) share that did not decay on the way.
    survival: np.ndarray


def at_detector(
    made: Production, path: AirPath, matter: Matter, kinetic_gev: np.ndarray
) -> Arrival:
    """Return the muons that arrive.

    Along each line the energy at any point follows from that at the detector by the losses
    in the air between; the muon's proper time says how many survive.

    Parameters
    ----------
    made, path, matter
        See there.
    kinetic_gev
        (n_energy,) kinetic energies at the detector, GeV.
    """
    # Both from the detector back: the energies themselves, and a little above them, which
    # gives the width that an interval of energies had where it was made.
    distance, density = path.distance_cm[::_ALONG], path.density[::_ALONG]
    middle = np.sqrt(density[:-1] * density[1:])
    depth = path.depth[::_ALONG]
    energy = np.concatenate([kinetic_gev, kinetic_gev * (1 + _STEP)])
    energies, ages = [energy], [np.zeros_like(energy)]
    for piece, air, length in zip(-np.diff(depth), middle, np.diff(distance)):
        half = energy + 0.5 * piece * matter.loss(energy, air)
        slow = matter.loss(half, air)
        momentum = np.sqrt(half * (half + 2 * MUON_GEV))
        ages.append(ages[-1] + length * MUON_GEV / (momentum * MUON_CTAU_CM))
        energy = energy + piece * slow
        energies.append(energy)
    along = np.stack(energies, 1)
    count = len(kinetic_gev)

    def at_production(values: np.ndarray) -> np.ndarray:
        return np.stack([np.interp(made.distance_cm, distance, one) for one in values])

    started = np.exp(at_production(np.log(along[:count])))
    above = np.exp(at_production(np.log(along[count:])))
    jacobian = (above - started) / (_STEP * kinetic_gev[:, None])
    age = at_production(np.stack(ages, 1)[:count])
    weight = np.exp(-age) * jacobian / started / LN_STEP
    ln_nodes = np.log(NODES_GEV)
    arriving = np.empty((len(AMPLITUDES), *weight.shape))
    ln_made = np.log(np.maximum(made.muons, 1e-300))
    # Monotone between nodes: no ringing where an amplitude's muons end.
    curve = PchipInterpolator(ln_nodes, np.moveaxis(ln_made, 2, 0)).derivative()
    slopes = np.moveaxis(curve(ln_nodes), 0, 2)
    sought = np.log(started)
    cell = np.clip(np.searchsorted(ln_nodes, sought) - 1, 0, len(ln_nodes) - 2)
    t = (sought - ln_nodes[cell]) / LN_STEP
    steps = np.arange(len(made.depth))
    for number in range(len(AMPLITUDES)):
        v, d = ln_made[:, number], slopes[:, number] * LN_STEP
        v0, v1, d0, d1 = v[steps, cell], v[steps, cell + 1], d[steps, cell], d[steps, cell + 1]
        value = (
            v0 * (1 + 2 * t) * (1 - t) ** 2 + v1 * t**2 * (3 - 2 * t)
            + d0 * t * (1 - t) ** 2 + d1 * t**2 * (t - 1)
        )  # fmt: skip
        arriving[number] = np.exp(value) * weight
    arriving /= _CM2_PER_M2
    every = arriving.sum(axis=0)
    flux = every.sum(axis=1)
    return Arrival(
        arriving.sum(axis=2),
        np.exp(np.sum(every * sought, axis=1) / flux),
        flux / np.sum(every * np.exp(age), axis=1),
    )
