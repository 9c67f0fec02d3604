"""The muon sky beside measurements that it was fitted to, others, and another code."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import numpy as np

from muysc_qgis.radiography.constants import MUON_MASS_GEV
from muysc_qgis.radiography.measured_spectra import Spectra, read_spectra, vertical_spectra
from muysc_qgis.radiography.muon_sky import muon_sky
from muysc_qgis.radiography.spectra import kinetic_from_momentum

from .row import Row

#: Spectra at 30° to 80° that took no part in the fit.
INCLINED = Path(__file__).resolve().parents[2] / "tests" / "data" / "muon_spectra_inclined.csv"
_SECTION = "The muon sky"
#: Ends of the groups of momentum, GeV/c.
_GROUPS_GEV = (1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 3200.0)

#: Altitudes in m, zenith angles in degrees and momenta in GeV/c of the altitude factors.
ALTITUDES_M = (1000.0, 2500.0, 4500.0)
ZENITHS_DEG = (0.0, 60.0, 80.0)
MOMENTA_GEV = (20.0, 50.0, 100.0, 1000.0)


def model_flux(spectra: Spectra) -> np.ndarray:
    """Return the muon sky's dI/dp at measured points, cm⁻² s⁻¹ sr⁻¹ (GeV/c)⁻¹."""
    kinetic = kinetic_from_momentum(spectra.momentum_gev)
    flux = np.empty(len(spectra))
    for altitude in np.unique(spectra.altitude_m):
        here = spectra.altitude_m == altitude
        cosine = np.cos(np.radians(spectra.zenith_deg[here]))
        flux[here] = muon_sky().flux(kinetic[here], cosine, float(altitude))
    return flux * spectra.momentum_gev / (kinetic + MUON_MASS_GEV)


def all_spectra() -> list[tuple[str, Spectra]]:
    """Return every measured spectrum with its name and angle."""
    found = []
    for spectra in (vertical_spectra(), read_spectra(INCLINED)):
        for name in dict.fromkeys(spectra.experiment):
            own = spectra.where(spectra.experiment == name)
            for zenith in np.unique(own.zenith_deg):
                angle = "vertical" if zenith < 20 else f"{zenith:g}°"
                found.append((f"{name}, {angle}", own.where(own.zenith_deg == zenith)))
    return found


def rows() -> Iterator[Row]:
    """Yield how well the fitted spectra are met, and the others by groups of momentum."""
    spectra = vertical_spectra()
    off = model_flux(spectra) / spectra.flux - 1.0
    share = spectra.error / spectra.flux
    # L3+C's flux may be off as a whole, by about 3 % (Achard et al. 2004).
    level = np.ones(len(spectra))
    for name in ("BESS-TeV", "L3+C"):
        own = spectra.experiment == name
        weight = share[own] ** -2
        if name == "L3+C":
            level[own] = 1.0 + np.average(off[own], weights=weight)
        apart = (1.0 + off[own]) / level[own] - 1.0
        yield Row(
            _SECTION, f"{name}, root mean square difference of {own.sum()} points, weighted by "
            "their errors", float(np.sqrt(np.average(apart**2, weights=weight))), "1", 0.0,
            "fitted to it: within 4 %", reference_to=0.04,
        )  # fmt: skip
    yield Row(
        _SECTION, f"BESS-TeV and L3+C, root mean square difference of {len(off)} points, as they "
        "stand", float(np.sqrt(np.mean(off**2))), "1", 0.0, "fitted to it: within 4 %",
        reference_to=0.04,
    )  # fmt: skip
    for name, one in all_spectra():
        ratio = model_flux(one) / one.flux
        for low, high in zip(_GROUPS_GEV[:-1], _GROUPS_GEV[1:]):
            group = (one.momentum_gev >= low) & (one.momentum_gev < high)
            if np.count_nonzero(group) < 3:
                continue
            fitted = name.startswith(("BESS-TeV", "L3+C"))
            yield Row(
                _SECTION, f"{name}, {low:g} to {high:g} GeV/c, ours over measured",
                float(np.exp(np.mean(np.log(ratio[group])))), "1", 1.0,
                "fitted to it" if fitted else "not used in the fit", None,
            )  # fmt: skip


def altitude_rows(mulder: ModuleType) -> Iterator[Row]:
    """Yield altitude factors beside mulder's, which moves every muon down to the sea."""
    for altitude in ALTITUDES_M:
        for zenith in ZENITHS_DEG:
            momentum = np.array(MOMENTA_GEV)
            ours, other = altitude_factors(mulder, altitude, zenith, momentum)
            for p, factor, expected in zip(momentum, ours, other):
                yield Row(
                    _SECTION, f"Flux at {altitude:g} m over that at the sea, zenith "
                    f"{zenith:g}°, {p:g} GeV/c",
                    float(factor), "1", float(expected),
                    "mulder 0.3.7 (Niess 2022): losses and decay down to the sea", 0.02,
                    mulder=True,
                )  # fmt: skip


def altitude_factors(
    mulder: ModuleType, altitude_m: float, zenith_deg: float, momentum_gev: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return our flux at an altitude over that at the sea, and what mulder makes of it.

    Parameters
    ----------
    mulder
        The module.
    altitude_m, zenith_deg
        Of the detector, m and degrees.
    momentum_gev
        Momenta there, GeV/c.
    """
    kinetic = kinetic_from_momentum(momentum_gev)
    meter = mulder.Fluxmeter(mulder.Layer(-1.0), mode="continuous")
    sea = meter.transport(energy=kinetic, altitude=altitude_m, elevation=90.0 - zenith_deg)
    there = np.cos(np.radians(zenith_deg))
    level = muon_sky().flux(kinetic, there, 0.0)
    arrives = muon_sky().flux(
        np.asarray(sea.energy), np.sin(np.radians(np.asarray(sea.elevation))), 0.0
    )
    return (
        muon_sky().flux(kinetic, there, altitude_m) / level,
        np.asarray(sea.weight) * arrives / level,
    )
