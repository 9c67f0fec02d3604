"""The tables of a comparison, one row for each point, with units in the column names."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from .comparison import AttenuationCurve, Comparison
from .constants import G_CM2_PER_M_WATER_EQUIVALENT

#: Columns of each table, by the name of the table.
COLUMNS = {
    "spectra": (
        "model", "zenith_deg", "kinetic_energy_GeV", "flux_per_cm2_s_sr_GeV", "within_validity",
        "relative_error",
    ),
    "fluxes": (
        "model", "zenith_deg", "thickness_m", "opacity_g_per_cm2", "minimum_energy_GeV",
        "flux_per_cm2_sr_day", "open_sky_per_cm2_sr_day", "transmission", "within_validity",
        "open_sky_within_validity",
    ),
    "energy_loss": (
        "material", "kinetic_energy_GeV", "stopping_power_MeV_cm2_per_g", "csda_range_g_per_cm2",
        "lesparre_MeV_cm2_per_g", "lesparre_minus_table_percent",
    ),
    "minimum_energy": (
        "energy_loss", "thickness_m", "opacity_g_per_cm2", "minimum_energy_GeV",
    ),
}  # fmt: skip

#: What a cell may hold.
Cell = object

#: Fields of an attenuation curve that have one value for each opacity.
_POINTWISE = (
    "opacity_g_cm2", "minimum_energy_gev", "flux", "open_sky", "transmission", "holds",
)  # fmt: skip


def rows(comparison: Comparison, table: str) -> list[tuple[Cell, ...]]:
    """Return the rows of one table.

    Parameters
    ----------
    comparison
        What is tabulated.
    table
        Key of `COLUMNS`, whose order the cells have. Fluxes at the thickness asked for
        stand among the others, at the place of their opacity.
    """
    if table == "spectra":
        return [
            (one.model, one.zenith_deg, *point)
            for one in comparison.spectra
            for point in zip(one.kinetic_energy_gev, one.flux, map(int, one.holds), one.error)
        ]
    if table == "fluxes":
        return [point for pair in _flux_curves(comparison) for point in _flux_rows(*pair)]
    if table == "energy_loss":
        return [
            (one.material, energy, loss, length, fit, 100.0 * (fit / loss - 1.0))
            for one in comparison.losses
            for energy, loss, length, fit in zip(
                one.kinetic_energy_gev, one.stopping_power, one.csda_range, one.polynomial
            )
        ]
    return [
        (one.energy_loss, *point)
        for one in comparison.minimum_energies
        for point in zip(one.thickness_m, one.opacity_g_cm2, one.minimum_energy_gev)
    ]


def _flux_curves(comparison: Comparison) -> Iterable[tuple[AttenuationCurve, float]]:
    """Yield every curve with the thickness asked for in its place, and the density."""
    for curve, marked in zip(comparison.attenuations, comparison.behind):
        where = np.searchsorted(curve.opacity_g_cm2, marked.opacity_g_cm2[0])
        changed: dict[str, Any] = {
            name: np.insert(getattr(curve, name), where, getattr(marked, name)[0])
            for name in _POINTWISE
            if marked.opacity_g_cm2[0] not in curve.opacity_g_cm2
        }
        yield replace(curve, **changed), comparison.physics.density


def _flux_rows(curve: AttenuationCurve, density: float) -> list[tuple[Cell, ...]]:
    return [
        (curve.model, curve.zenith_deg, *point, int(curve.sky_holds))
        for point in zip(
            curve.opacity_g_cm2 / (G_CM2_PER_M_WATER_EQUIVALENT * density),
            curve.opacity_g_cm2,
            curve.minimum_energy_gev,
            curve.flux,
            curve.open_sky,
            curve.transmission,
            map(int, curve.holds),
        )
    ]
