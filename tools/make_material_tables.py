"""Make the tables of muon energy loss that ship with the library.

Needs mulder, which computes them with the PUMAS library (Niess 2022,
doi:10.1016/j.cpc.2022.108438). Takes a few minutes; run from anywhere::

    python tools/make_material_tables.py [material …]
"""

from __future__ import annotations

import sys
from pathlib import Path

import mulder
import mulder.materials
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from muysc_qgis.radiography.materials import DATA_FOLDER, MATERIALS, Material

#: Steps of a decade at which the library tabulates, so that nothing is interpolated
#: twice; above 10 TeV the range is smooth enough for three of them.
_FINE = (1, 1.2, 1.4, 1.7, 2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6, 7, 8, 9)
_COARSE = (1, 2, 5)
_FINE_DECADES = range(-3, 4)
_COARSE_DECADES = range(4, 9)


def energies_gev() -> np.ndarray:
    """Return the kinetic energies of the tables, 1 MeV to 10⁹ GeV."""
    fine = [step * 10.0**decade for decade in _FINE_DECADES for step in _FINE]
    coarse = [step * 10.0**decade for decade in _COARSE_DECADES for step in _COARSE]
    return np.array([*fine, *coarse, 1e9])


def compiled(material: Material, physics: mulder.Physics) -> mulder.CompiledMaterial:
    """Return the tables of a material, computed from its composition and density."""
    name = f"muysc_{material.name}"
    if isinstance(material.composition, str):
        if material.composition == "Rk":
            return physics.compile("Rock")
        composition: str | dict[str, float] = material.composition
    else:
        total = sum(material.composition.values())
        composition = {key: value / total for key, value in material.composition.items()}
    excitation = material.excitation_energy_ev
    mulder.materials.Material.define(
        name,
        composition=composition,
        density=material.density_g_cm3 * 1e3,  # g/cm³ to kg/m³
        I=None if excitation is None else excitation * 1e-9,  # eV to GeV
    )
    return physics.compile(name)


def main(names: list[str]) -> None:
    """Write the tables of the named materials, or of all."""
    physics = mulder.Physics()
    energy = energies_gev()
    for material in (MATERIALS[name] for name in names or MATERIALS):
        table = compiled(material, physics)
        g_cm2_per_m = 100.0 * material.density_g_cm3
        stopping = table.stopping_power(energy) / g_cm2_per_m * 1e3  # GeV/m to MeV cm²/g
        csda_range = table.range(energy) * g_cm2_per_m  # m to g/cm²
        fractions = ", ".join(f"{k} {v:.5f}" for k, v in table.definition.composition)
        excitation = "Bragg's additivity rule"
        if material.excitation_energy_ev is not None:
            excitation = f"{material.excitation_energy_ev:g} eV"
        header = [
            f"Energy loss of muons in {material.title.lower()}, {material.density_g_cm3:g} g/cm3.",
            f"Composition by mass: {fractions} ({material.source}).",
            f"Mean excitation energy: {excitation}.",
            f"Made by tools/make_material_tables.py with mulder {mulder.config.VERSION}, which",
            "uses PUMAS (Niess 2022, doi:10.1016/j.cpc.2022.108438); cross-sections:",
            f"bremsstrahlung {physics.bremsstrahlung}, pair production {physics.pair_production}, "
            f"photonuclear {physics.photonuclear}.",
            "kinetic_energy_gev,stopping_power_mev_cm2_g,csda_range_g_cm2",
        ]
        lines = [f"# {line}" for line in header]
        lines += [f"{e:.6g},{s:.6g},{r:.7g}" for e, s, r in zip(energy, stopping, csda_range)]
        path = DATA_FOLDER / f"{material.name}.csv"
        path.write_text("\n".join(lines) + "\n", encoding="ascii")


if __name__ == "__main__":
    main(sys.argv[1:])
