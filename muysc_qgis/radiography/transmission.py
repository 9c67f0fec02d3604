"""From opacity to muon flux and transmission, and back."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from .constants import OPEN_SKY_MOMENTUM_GEV, SECONDS_PER_DAY
from .energy_loss import minimum_energy
from .integral import IntegralSpectrum, integral_spectrum
from .settings import Physics, check_altitude
from .spectra import kinetic_from_momentum
from .straggling import straggling_factor
from .validity import count_departures, sentences

#: Rays computed at a time; bounds the memory and keeps it in the processor's cache.
_BLOCK = 1 << 16

#: Distinct zenith angles tabulated at a time.
_ZENITH_BLOCK = 1 << 12


@dataclass(frozen=True)
class Attenuation:
    """What is left of the muon flux behind rock, ray by ray.

    Arrays have the broadcast shape of opacity and elevation; NaN is what cannot be known.
    """

    #: Kinetic energy in GeV that a muon needs; the detection threshold where there is no rock.
    minimum_energy_gev: np.ndarray
    #: Muon flux behind the rock, cm⁻² sr⁻¹ day⁻¹.
    flux: np.ndarray
    #: Muon flux without rock, cm⁻² sr⁻¹ day⁻¹.
    open_sky: np.ndarray
    #: Flux over open sky, 1 where there is no rock.
    transmission: np.ndarray
    #: One sentence for each kind of ray that leaves the range of a formula, with counts.
    warnings: tuple[str, ...]
    #: Rays without a flux by cause: ``opacity`` (unknown), ``horizon`` (zenith angle of
    #: 90° or more), ``energy loss`` (no minimum energy).
    unanswered: Mapping[str, int]


def open_sky_start_gev(physics: Physics) -> float:
    """Return the kinetic energy in GeV from which the open sky counts.

    The detection threshold, or the energy of 1 GeV/c if there is none.
    """
    if physics.detection_threshold_gev > 0:
        return float(physics.detection_threshold_gev)
    return float(kinetic_from_momentum(np.array(OPEN_SKY_MOMENTUM_GEV)))


def attenuate(
    opacity_g_cm2: np.ndarray,
    elevation_deg: np.ndarray,
    physics: Physics,
    altitude_m: float = 0.0,
) -> Attenuation:
    """Return the muon flux behind rock.

    I(ϱ, θ) = f ∫ Φ(E, θ) dE from E_min(ϱ) to infinity, with the altitude correction
    inside the integral and the straggling factor f; the transmission is I/I(0, θ).

    Parameters
    ----------
    opacity_g_cm2
        Opacity ϱ in g/cm²: 0 for sky, NaN where unknown.
    elevation_deg
        Elevation above the horizon in degrees; broadcasts with the opacity: (n, 1)
        against (n, m) for the rows of a muogram, (n,) against (n,) for single rays.
    physics
        Material, flux model and corrections.
    altitude_m
        Height of the detector above sea level, m.

    Raises
    ------
    MuyscError
        If an opacity is negative or infinite, an elevation is no angle from −90° to 90°,
        the shapes do not fit or the altitude is not on land.
    """
    opacity, elevation, shape = _checked(opacity_g_cm2, elevation_deg, "opacity", "g/cm²")
    check_altitude(altitude_m)
    results = np.empty((4, *opacity.shape))
    start = open_sky_start_gev(physics)
    counts: Counter[str] = Counter()
    for block, block_elevation in _blocks(opacity.shape, elevation):
        rho = opacity[block]
        energy = minimum_energy(rho, physics)
        cos_zenith = np.sin(np.radians(block_elevation))
        sky_is_known = cos_zenith > 0
        begin = np.fmax(energy, start)
        row, table = _table(cos_zenith, physics, start, float(begin.max()), altitude_m)
        open_sky = np.where(sky_is_known, table.from_start[row], np.nan) * SECONDS_PER_DAY
        begin = np.where(np.isnan(energy) | ~sky_is_known, np.nan, begin)
        flux = _behind_rock(rho, begin, row, table, physics)
        flux = np.where(rho == 0, open_sky, np.minimum(flux, open_sky))
        for result, values in zip(results, (energy, flux, open_sky, flux / open_sky)):
            result[block] = values
        counts["opacity"] += int(np.count_nonzero(np.isnan(rho)))
        counts["horizon"] += int(np.count_nonzero(~np.isnan(rho) & ~sky_is_known))
        counts["energy loss"] += int(
            np.count_nonzero(~np.isnan(rho) & np.isnan(energy) & sky_is_known)
        )
        counts += count_departures(rho, cos_zenith, energy, start, physics, altitude_m)
    energy, flux, open_sky, transmission = (result.reshape(shape) for result in results)
    return Attenuation(
        energy,
        flux,
        open_sky,
        transmission,
        sentences(counts, physics, altitude_m),
        {cause: counts[cause] for cause in ("opacity", "horizon", "energy loss")},
    )


def _behind_rock(
    opacity_g_cm2: np.ndarray,
    begin_gev: np.ndarray,
    row: np.ndarray,
    table: IntegralSpectrum,
    physics: Physics,
) -> np.ndarray:
    """Return the flux of muons above an energy behind rock, cm⁻² sr⁻¹ day⁻¹."""
    intensity, index = table(row, begin_gev)
    if physics.straggling:
        intensity = intensity * straggling_factor(opacity_g_cm2, index, physics.material)
    return intensity * SECONDS_PER_DAY


def _table(
    cos_zenith: np.ndarray,
    physics: Physics,
    start_gev: float,
    highest_gev: float,
    altitude_m: float,
) -> tuple[np.ndarray, IntegralSpectrum]:
    """Return the integral spectra of the distinct zenith angles, and which is whose."""
    # Below the horizon there is no spectrum; a vertical one stands in and is not used.
    distinct, row = np.unique(np.where(cos_zenith > 0, cos_zenith, 1.0), return_inverse=True)
    table = integral_spectrum(
        distinct,
        physics.flux_model,
        physics.gaisser_parameters,
        start_gev,
        highest_gev,
        altitude_m if physics.altitude_correction else None,
    )
    return row.reshape(cos_zenith.shape), table


def _checked(
    values: np.ndarray, elevation_deg: np.ndarray, name: str, unit: str
) -> tuple[np.ndarray, np.ndarray, tuple[int, ...]]:
    """Return values broadcast to at least one dimension, elevations with as many, the shape."""
    values = np.asarray(values, dtype=float)
    elevation = np.asarray(elevation_deg, dtype=float)
    try:
        shape = np.broadcast_shapes(values.shape, elevation.shape)
    except ValueError:
        raise MuyscError(
            f"The {name} has shape {values.shape} and the elevation {elevation.shape}; give one "
            "elevation for each row, or for each ray."
        ) from None
    bad = values[(values < 0) | np.isinf(values)]
    if bad.size:
        raise MuyscError(
            f"{bad.size} values of {name} are negative or infinite, such as {bad[0]:g} {unit}; "
            "give values of 0 or more, and no-data where unknown."
        )
    bad = elevation[~(np.abs(elevation) <= 90)]
    if bad.size:
        raise MuyscError(
            f"{bad.size} elevations are no angles above the horizon, such as {bad[0]:g}°; give "
            "degrees from −90 to 90."
        )
    full = shape or (1,)
    values = np.broadcast_to(values, full)
    return values, elevation.reshape((1,) * (len(full) - elevation.ndim) + elevation.shape), shape


def _blocks(
    shape: tuple[int, ...], elevation: np.ndarray
) -> Iterator[tuple[tuple[slice, ...], np.ndarray]]:
    """Cut rays along the first axis; yield each block's slice and its elevations."""
    row_size = max(1, int(np.prod(shape[1:])))
    step = max(1, _BLOCK // row_size)
    if elevation.shape[0] > 1:
        step = min(step, max(1, _ZENITH_BLOCK // max(1, elevation[0].size)))
    for first in range(0, shape[0], step):
        block = (slice(first, first + step),)
        yield block, elevation if elevation.shape[0] == 1 else elevation[block]
