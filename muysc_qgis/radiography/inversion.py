"""The opacity that explains a muon flux."""

from __future__ import annotations

import numpy as np

from ..progress import Progress, silent
from .batches import blocks, checked
from .energy_loss import csda_range, range_law
from .roots import falling_roots
from .settings import Physics, check_altitude
from .transmission import Sky

#: Halvings of the energy range before the faster search.
_HALVINGS = 3


def opacity_from_flux(
    flux_per_cm2_sr_day: np.ndarray,
    elevation_deg: np.ndarray,
    physics: Physics,
    altitude_m: float = 0.0,
    progress: Progress = silent,
) -> np.ndarray:
    """Return the opacity behind which a muon flux is left: the inverse of `attenuate`.

    Parameters
    ----------
    flux_per_cm2_sr_day
        Measured flux in cm⁻² sr⁻¹ day⁻¹; NaN where unknown.
    elevation_deg
        Elevation above the horizon in degrees; broadcasts with the flux as in `attenuate`.
    physics
        Material, flux model and corrections.
    altitude_m
        Height of the detector above sea level, m.
    progress
        Told the share done.

    Returns
    -------
    numpy.ndarray
        g/cm²; 0 where the flux is that of the open sky or more, NaN where it is unknown,
        0, or less than any rock of the range law leaves, and at or below the horizon.

    Raises
    ------
    MuyscError
        If a flux is negative or infinite, an elevation is no angle from −90° to 90°, the
        shapes do not fit or the altitude is not on land.
    Cancelled
        If `progress` asks for a stop.
    """
    flux, elevation, shape = checked(flux_per_cm2_sr_day, elevation_deg, "flux", "cm⁻² sr⁻¹ day⁻¹")
    check_altitude(altitude_m)
    highest_gev = _highest_energy(physics)
    opacity = np.empty(flux.shape)
    for block, block_elevation in blocks(flux.shape, elevation, progress):
        sky = Sky.at(block_elevation, physics, altitude_m, highest_gev)
        opacity[block] = _search(np.where(flux[block] > 0, flux[block], np.nan), sky, highest_gev)
    return opacity.reshape(shape)


def _highest_energy(physics: Physics) -> float:
    """Return the highest kinetic energy in GeV that the range law gives to an opacity."""
    law = range_law(physics.material, physics.energy_loss)
    # Just below the end, where rounding would decide whether there is an answer.
    return float(np.exp(law.range_of_energy.x[-1])) * (1 - 1e-9) - law.rest_energy_gev


def _search(flux: np.ndarray, sky: Sky, highest_gev: float) -> np.ndarray:
    """Return the opacities of one block.

    The unknown is ln of the minimum energy, in which ln I is nearly straight.
    """
    physics = sky.physics
    ln_flux = np.log(flux)

    def opacity_at(ln_energy: np.ndarray) -> np.ndarray:
        energy = np.append(np.exp(ln_energy).ravel(), physics.threshold_gev)
        length = csda_range(energy, physics.material, physics.energy_loss)
        behind = length[-1] if physics.threshold_gev > 0 else 0.0
        return np.maximum(length[:-1].reshape(ln_energy.shape) - behind, 0.0)

    def excess(ln_energy: np.ndarray) -> np.ndarray:
        return np.log(sky.flux_behind(opacity_at(ln_energy), np.exp(ln_energy))) - ln_flux

    low = np.full(flux.shape, np.log(physics.open_sky_start_gev))
    high = np.full(flux.shape, np.log(highest_gev))
    at_low, at_high = np.log(sky.open_sky) - ln_flux, excess(high)
    is_sky, has_answer = at_low <= 0, at_high <= 0
    sought = ~is_sky & has_answer
    found = falling_roots(excess, low, high, at_low, at_high, sought, _HALVINGS)
    return np.where(is_sky, 0.0, np.where(has_answer, opacity_at(found), np.nan))
