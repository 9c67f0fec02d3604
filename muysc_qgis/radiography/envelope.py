"""How well the flux is known: a model's own error, or how far the formulas lie apart."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..progress import Progress, part, silent
from .constants import MUON_MASS_GEV
from .gaisser import GAISSER_PARAMETERS
from .muon_sky import muon_sky
from .settings import Physics
from .spectra import AGREED_WITHIN, MODELS
from .transmission import attenuate
from .validity import OPEN_SKY_SLACK

#: Rays whose median stands for all.
_ENOUGH = 10_000


@dataclass(frozen=True)
class Envelope:
    """The smallest and the largest that each ray's value may well be."""

    #: Any shape; NaN where no model holds.
    minimum: np.ndarray
    maximum: np.ndarray
    #: Number of rays that each model holds for.
    rays: Mapping[str, int]


def model_envelope(
    opacity_g_cm2: np.ndarray,
    elevation_deg: np.ndarray,
    physics: Physics,
    altitude_m: float = 0.0,
    progress: Progress = silent,
) -> Envelope:
    """Return how small and how large the flux behind rock may well be.

    With a tabulated model, one standard error of it to either side. With a formula, the
    smallest and largest over the formulas that hold there: everything but the formula is
    as in `physics`, the set of Gaisser parameters included; one counts for a ray where
    `model_holds`, and in the open sky its lower limit is taken as loosely as by the warnings.

    Parameters
    ----------
    opacity_g_cm2, elevation_deg, physics, altitude_m, progress
        As in `attenuate`.

    Returns
    -------
    Envelope
        Of the flux in cm⁻² sr⁻¹ day⁻¹.

    Raises
    ------
    MuyscError
        As `attenuate`.
    Cancelled
        If `progress` asks for a stop.
    """
    opacity = np.asarray(opacity_g_cm2, dtype=float)
    cosine = np.sin(np.radians(np.asarray(elevation_deg, dtype=float)))
    if MODELS[physics.flux_model].tabulated:
        muons = attenuate(opacity, elevation_deg, physics, altitude_m, progress)
        error = flux_error(muons.minimum_energy_gev, cosine, physics, altitude_m)
        known = int(np.count_nonzero(np.isfinite(muons.flux)))
        return Envelope(
            muons.flux * (1.0 - error), muons.flux * (1.0 + error), {physics.flux_model: known}
        )

    def flux_of(model: Physics, progress: Progress) -> tuple[np.ndarray, np.ndarray]:
        muons = attenuate(opacity, elevation_deg, model, altitude_m, progress)
        start = np.fmax(muons.minimum_energy_gev, model.open_sky_start_gev)
        slack = np.where(opacity > 0, 1.0, OPEN_SKY_SLACK)
        return muons.flux, model_holds(model, cosine, start, slack)

    return envelope_over_models(physics, flux_of, progress)


def flux_error(
    minimum_energy_gev: np.ndarray, cos_zenith: np.ndarray, physics: Physics, altitude_m: float
) -> np.ndarray:
    """Return the relative standard error of the muon flux above an energy.

    That of a tabulated model at this energy, where most of the muons counted are. A formula
    has none of its own; it gets `AGREED_WITHIN`, to which its range is chosen.

    Parameters
    ----------
    minimum_energy_gev
        Kinetic energy in GeV from which muons count.
    cos_zenith
        Cosine of the zenith angle; broadcasts with the energy.
    physics
        Its flux model counts.
    altitude_m
        Height of the detector above sea level, m.

    Returns
    -------
    numpy.ndarray
        NaN where the energy is, and at and below the horizon.
    """
    energy, cosine = np.broadcast_arrays(minimum_energy_gev, cos_zenith)
    if not MODELS[physics.flux_model].tabulated:
        error: np.ndarray = np.full(energy.shape, AGREED_WITHIN)
    else:
        start = np.fmax(energy, physics.open_sky_start_gev)
        error = muon_sky().relative_error(start, cosine, altitude_m)
    return np.where((cosine > 0) & np.isfinite(energy), error, np.nan)


def typical_flux_error(
    minimum_energy_gev: np.ndarray,
    opacity_g_cm2: np.ndarray,
    elevation_deg: np.ndarray,
    physics: Physics,
    altitude_m: float,
) -> float:
    """Return the median relative standard error of the flux behind rock.

    Parameters
    ----------
    minimum_energy_gev, opacity_g_cm2
        Of each ray, any shape: kinetic energy in GeV and opacity in g/cm².
    elevation_deg
        Elevation above the horizon in degrees; broadcasts with them.
    physics, altitude_m
        As in `flux_error`.

    Returns
    -------
    float
        Of all rays where none meets rock, NaN where none is known.
    """
    known = np.isfinite(minimum_energy_gev)
    chosen = known & (opacity_g_cm2 > 0)
    chosen = np.flatnonzero(chosen if chosen.any() else known)
    chosen = chosen[:: 1 + len(chosen) // _ENOUGH]
    cosine = np.sin(np.radians(np.broadcast_to(elevation_deg, known.shape).ravel()[chosen]))
    error = flux_error(minimum_energy_gev.ravel()[chosen], cosine, physics, altitude_m)
    error = error[np.isfinite(error)]
    return float(np.median(error)) if error.size else float("nan")


def envelope_over_models(
    physics: Physics,
    evaluate: Callable[[Physics, Progress], tuple[np.ndarray, np.ndarray]],
    progress: Progress = silent,
) -> Envelope:
    """Return the smallest and largest value over the formulas.

    Parameters
    ----------
    physics
        Physics whose flux model is replaced by one after the other.
    evaluate
        Returns values for the physics given, and where they are to count; it tells the
        share done of its own work.
    progress
        Told the share done.

    Raises
    ------
    Cancelled
        If `progress` asks for a stop.
    """
    minimum = maximum = np.array(np.nan)
    rays = {}
    formulas = [name for name, model in MODELS.items() if not model.tabulated]
    for number, name in enumerate(formulas):
        within = part(progress, number / len(formulas), (number + 1) / len(formulas))
        values, holds = evaluate(replace(physics, flux_model=name), within)
        counted = np.where(holds, values, np.nan)
        minimum, maximum = np.fmin(minimum, counted), np.fmax(maximum, counted)
        rays[name] = int(np.count_nonzero(np.isfinite(counted)))
    return Envelope(minimum, maximum, rays)


def model_holds(
    physics: Physics,
    cos_zenith: np.ndarray,
    start_gev: np.ndarray,
    slack: float | np.ndarray = 1.0,
) -> np.ndarray:
    """Return where a flux model is asked within the range it was made for.

    Parameters
    ----------
    physics
        Flux model and Gaisser parameters.
    cos_zenith
        Cosine of the zenith angle.
    start_gev
        Kinetic energy in GeV from which the spectrum is integrated.
    slack
        Factor by which it may start below the range. All arrays broadcast.
    """
    model = MODELS[physics.flux_model]
    above = cos_zenith > 0
    cosine = np.where(above, cos_zenith, 1.0)
    lower, upper = model.energy_range_gev(cosine, GAISSER_PARAMETERS[physics.gaisser_parameters])
    energy = start_gev + MUON_MASS_GEV
    within_zenith = cosine >= np.cos(np.radians(model.maximum_zenith_deg + 1e-9))
    return above & within_zenith & (slack * energy >= lower) & (energy <= upper)
