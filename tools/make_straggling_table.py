"""Make the table of the straggling correction that ships with the library.

For a spectrum whose integral falls as I(>E) ∝ E^-s above a depth of rock, the ratio
f(ϱ, s) of the intensity with all fluctuations of the energy loss to that with mean
losses is found by backward Monte Carlo transport through a slab of standard rock:
the same histories serve every s, weighted by the spectrum at the energy they end with.
ln f/s is stored as a polynomial of s at each opacity.

Needs mulder, which transports with the PUMAS library (Niess 2022,
doi:10.1016/j.cpc.2022.108438). Takes about ten minutes; run from anywhere::

    python tools/make_straggling_table.py [histories]
"""

from __future__ import annotations

import sys
from pathlib import Path

import mulder
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from muysc_qgis.radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from muysc_qgis.radiography.materials import DATA_FOLDER

#: Opacities of the table, km w.e.
OPACITIES_KM_WE = (0.2, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 15.0)
#: Indices s of the integral spectra; muons behind rock have 1 to 3.
INDICES = np.linspace(1.0, 4.0, 7)
#: Kinetic energies behind the rock, GeV, that are followed back.
ENERGY_RANGE_GEV = (1e-2, 1e6)
#: Histories for each opacity.
HISTORIES = 400_000
#: Share of the histories spread evenly in ln E, the rest following mean losses.
EVEN_SHARE = 0.2


def slab(mode: str, name: str, cutoff: float = 0.01) -> mulder.Fluxmeter:
    """Return a meter that transports muons through endless rock of one material."""
    physics = mulder.Physics(cutoff=cutoff)
    return mulder.Fluxmeter(
        mulder.Layer(0.0, material=name), mode=mode, physics=physics, random=mulder.Random(20)
    )


def origin(
    meter: mulder.Fluxmeter, energy_gev: np.ndarray, depth_m: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return energies on top of the rock and weights of muons of given energies below it."""
    states = meter.transport(energy=energy_gev, altitude=-depth_m, elevation=90.0)
    return np.ravel(states.energy), np.ravel(states.weight)


def factors(
    opacity_g_cm2: float, histories: int, name: str = "Rock", density: float = 2.65
) -> tuple[np.ndarray, np.ndarray]:
    """Return f and its standard error for every index."""
    depth_m = opacity_g_cm2 / (density * 100.0)
    ln_energy = np.linspace(*np.log(ENERGY_RANGE_GEV), 8001)
    energy = np.exp(ln_energy)
    source, weight = origin(slab("continuous", name), energy, depth_m)
    mean = weight * energy * source ** -(INDICES[:, None] + 1.0)  # dI/dlnE with mean losses
    step = ln_energy[1] - ln_energy[0]
    expected = (mean.sum(axis=1) - 0.5 * (mean[:, 0] + mean[:, -1])) * step

    # Energies behind the rock, drawn where muons of index 2.5 arrive.
    density_of_draws = (1 - EVEN_SHARE) * mean[3] / (mean[3].sum() * step)
    density_of_draws += EVEN_SHARE / (ln_energy[-1] - ln_energy[0])
    cumulative = np.concatenate(
        ([0.0], np.cumsum(0.5 * step * (density_of_draws[1:] + density_of_draws[:-1])))
    )
    random = np.random.default_rng(5)
    share = (np.arange(histories) + random.random(histories)) / histories * cumulative[-1]
    drawn = np.exp(np.interp(share, cumulative, ln_energy))
    drawn_density = np.interp(np.log(drawn), ln_energy, density_of_draws) / cumulative[-1]
    source, weight = origin(slab("mixed", name), drawn, depth_m)
    score = weight * drawn / drawn_density * source ** -(INDICES[:, None] + 1.0)
    ratio = score / expected[:, None]
    return ratio.mean(axis=1), ratio.std(axis=1) / np.sqrt(histories)


def coefficients(ratio: np.ndarray, error: np.ndarray) -> np.ndarray:
    """Return c0 to c3 of (ln f)/s = c0 + c1 s + c2 s² + c3 s³, by least squares."""
    return np.polyfit(INDICES, np.log(ratio) / INDICES, 3, w=INDICES * ratio / error)[::-1]


def main(histories: int) -> None:
    """Transport the histories and write the table."""
    lines = []
    for opacity_km_we in OPACITIES_KM_WE:
        opacity = opacity_km_we * 1000.0 * G_CM2_PER_M_WATER_EQUIVALENT
        ratio, error = factors(opacity, histories)
        c = coefficients(ratio, error)
        fitted = np.exp(INDICES * np.polyval(c[::-1], INDICES))
        print(f"{opacity_km_we:5.1f} km w.e.: f {np.round(ratio, 4)}, errors {np.round(error, 4)}, "
              f"fit off by {np.round(fitted / ratio - 1, 4)}", flush=True)  # fmt: skip
        lines.append(f"{opacity:.6g}," + ",".join(f"{value:.5f}" for value in c))
    header = [
        "Straggling correction f(opacity, s) in standard rock: (ln f)/s = c0 + c1 s + c2 s^2",
        "+ c3 s^3, s = -dlnI/dlnE of the integral spectrum at the minimum energy, fitted for s",
        "from 1 to 4. Made by tools/make_straggling_table.py with mulder "
        f"{mulder.config.VERSION}, which uses",
        "PUMAS (Niess 2022, doi:10.1016/j.cpc.2022.108438): backward Monte Carlo with",
        f"stochastic losses above 1 %, {histories} histories for each opacity.",
        "opacity_g_cm2,c0,c1,c2,c3",
    ]
    text = "\n".join([f"# {line}" for line in header] + ["0,0,0,0,0", *lines]) + "\n"
    (DATA_FOLDER / "straggling.csv").write_text(text, encoding="ascii")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else HISTORIES)
