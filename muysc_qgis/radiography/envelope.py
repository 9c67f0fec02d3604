"""How far the flux models that hold for a ray lie apart."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..progress import Progress, part, silent
from .constants import MUON_MASS_GEV
from .gaisser import GAISSER_PARAMETERS
from .settings import Physics
from .spectra import MODELS
from .transmission import attenuate, open_sky_start_gev
from .validity import OPEN_SKY_SLACK


@dataclass(frozen=True)
class Envelope:
    """The smallest and the largest of what several flux models say of each ray."""

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
    """Return the smallest and largest flux behind rock over the models that hold there.

    Everything but the flux model is as in `physics`, the set of Gaisser parameters
    included. A model counts for a ray where `model_holds`; in the open sky its lower
    limit is taken as loosely as by the warnings.

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

    def flux_of(model: Physics, progress: Progress) -> tuple[np.ndarray, np.ndarray]:
        muons = attenuate(opacity, elevation_deg, model, altitude_m, progress)
        start = np.fmax(muons.minimum_energy_gev, open_sky_start_gev(model))
        slack = np.where(opacity > 0, 1.0, OPEN_SKY_SLACK)
        return muons.flux, model_holds(model, cosine, start, slack)

    return envelope_over_models(physics, flux_of, progress)


def envelope_over_models(
    physics: Physics,
    evaluate: Callable[[Physics, Progress], tuple[np.ndarray, np.ndarray]],
    progress: Progress = silent,
) -> Envelope:
    """Return the smallest and largest value over the flux models.

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
    for number, name in enumerate(MODELS):
        within = part(progress, number / len(MODELS), (number + 1) / len(MODELS))
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
