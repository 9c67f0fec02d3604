"""The materials muons can cross, and their tables of energy loss.

Importing this module reads no file; a table is read when it is first needed.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

#: Folder of the tables that ship with the library.
DATA_FOLDER = Path(__file__).parent / "data"

#: Density averages of rocks are those of Telford, Geldart & Sheriff (1990), Applied
#: Geophysics, Cambridge University Press, chapter 2; compositions of igneous rocks those of
#: Nockolds, Knox & Chinner (1978) as given by Fowler (2005), The Solid Earth, table 9.1.
_ROCKS = "mean analysis of Nockolds et al. (1978), in Fowler (2005), The Solid Earth, table 9.1"


@dataclass(frozen=True)
class Material:
    """A uniform medium."""

    name: str
    title: str
    #: Density in g/cm³ where the user gives none.
    density_g_cm3: float
    #: Constituents by mass percent, or by formula; what the table was made from.
    composition: dict[str, float] | str
    #: Where composition and density come from.
    source: str
    #: Mean excitation energy in eV; None leaves it to the additivity rule of Bragg.
    excitation_energy_ev: float | None = None


#: Every material by its name in the interface.
MATERIALS = {
    material.name: material
    for material in (
        Material(
            "standard_rock", "Standard rock", 2.65, "Rk",
            "Z = 11, A = 22: Groom, Mokhov & Striganov (2001), doi:10.1006/adnd.2001.0861",
            136.4,
        ),
        Material(
            "water", "Water", 1.0, "H2O",
            "Groom, Mokhov & Striganov (2001), doi:10.1006/adnd.2001.0861", 79.7,
        ),
        Material(
            "ice", "Ice", 0.918, "H2O",
            "Particle Data Group, Atomic and Nuclear Properties: water (solid ice)", 79.7,
        ),
        Material(
            "limestone", "Limestone (calcite)", 2.71, "CaCO3",
            "stoichiometric calcite and its mineral density",
        ),
        Material(
            "dolomite", "Dolomite", 2.87, "CaMgC2O6",
            "stoichiometric dolomite and its mineral density",
        ),
        Material(
            "quartzite", "Quartzite and quartz sandstone", 2.65, "SiO2",
            "stoichiometric quartz and its mineral density",
        ),
        Material(
            "granite", "Granite", 2.64,
            {"SiO2": 70.4, "TiO2": 0.4, "Al2O3": 14.4, "Fe2O3": 1.0, "FeO": 1.9, "MnO": 0.1,
             "MgO": 0.8, "CaO": 2.0, "Na2O": 3.2, "K2O": 5.0, "P2O5": 0.2},
            _ROCKS,
        ),
        Material(
            "granodiorite", "Granodiorite", 2.73,
            {"SiO2": 66.9, "TiO2": 0.6, "Al2O3": 15.7, "Fe2O3": 1.3, "FeO": 2.6, "MnO": 0.1,
             "MgO": 1.6, "CaO": 3.6, "Na2O": 3.8, "K2O": 3.1, "P2O5": 0.2},
            _ROCKS,
        ),
        Material(
            "diorite", "Diorite", 2.85,
            {"SiO2": 51.9, "TiO2": 1.5, "Al2O3": 16.4, "Fe2O3": 2.7, "FeO": 7.0, "MnO": 0.2,
             "MgO": 6.1, "CaO": 8.4, "Na2O": 3.4, "K2O": 1.3, "P2O5": 0.4},
            _ROCKS,
        ),
        Material(
            "andesite", "Andesite", 2.61,
            {"SiO2": 54.9, "TiO2": 1.0, "Al2O3": 17.7, "Fe2O3": 2.4, "FeO": 5.6, "MnO": 0.2,
             "MgO": 4.9, "CaO": 7.9, "Na2O": 3.7, "K2O": 1.1, "P2O5": 0.3},
            _ROCKS,
        ),
        Material(
            "basalt", "Basalt", 2.99,
            {"SiO2": 50.8, "TiO2": 2.0, "Al2O3": 14.1, "Fe2O3": 2.9, "FeO": 9.1, "MnO": 0.2,
             "MgO": 6.3, "CaO": 10.4, "Na2O": 2.2, "K2O": 0.8, "P2O5": 0.2},
            _ROCKS,
        ),
        Material(
            "gabbro", "Gabbro", 3.03,
            {"SiO2": 48.4, "TiO2": 1.3, "Al2O3": 16.8, "Fe2O3": 2.6, "FeO": 7.9, "MnO": 0.2,
             "MgO": 8.1, "CaO": 11.1, "Na2O": 2.3, "K2O": 0.6, "P2O5": 0.2},
            _ROCKS,
        ),
        Material(
            "concrete", "Concrete (Portland)", 2.3,
            {"H": 1.0, "C": 0.1, "O": 52.9107, "Na": 1.6, "Mg": 0.2, "Al": 3.3872, "Si": 33.7021,
             "K": 1.3, "Ca": 4.4, "Fe": 1.4},
            "NIST ESTAR material 144, concrete, Portland", 135.2,
        ),
    )
}  # fmt: skip


@dataclass(frozen=True)
class EnergyLossTable:
    """Energy loss of muons in a material, on increasing kinetic energies."""

    #: (n,) GeV.
    kinetic_energy_gev: np.ndarray
    #: (n,) mean energy loss, GeV cm²/g.
    stopping_power: np.ndarray
    #: (n,) range in the continuous-slowing-down approximation, g/cm².
    csda_range: np.ndarray


@cache
def energy_loss_table(material: str) -> EnergyLossTable:
    """Return the table of a material, reading its file at the first call.

    Parameters
    ----------
    material
        Key of `MATERIALS`.
    """
    columns = np.loadtxt(
        DATA_FOLDER / f"{MATERIALS[material].name}.csv", delimiter=",", comments="#", unpack=True
    )
    columns.setflags(write=False)
    energy, stopping_mev, csda_range = columns
    return EnergyLossTable(energy, stopping_mev * 1e-3, csda_range)  # MeV to GeV
