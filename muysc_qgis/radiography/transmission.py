"""From opacity to muon flux and transmission, and back."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..progress import Progress, silent
from .batches import blocks, checked
from .constants import SECONDS_PER_DAY
from .energy_loss import minimum_energy
from .integral import IntegralSpectrum, integral_spectrum
from .settings import Physics, check_altitude
from .straggling import straggling_factor
from .validity import count_departures, sentences


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


def attenuate(
    opacity_g_cm2: np.ndarray,
    elevation_deg: np.ndarray,
    physics: Physics,
    altitude_m: float = 0.0,
    progress: Progress = silent,
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
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If an opacity is negative or infinite, an elevation is no angle from −90° to 90°,
        the shapes do not fit or the altitude is not on land.
    Cancelled
        If `progress` asks for a stop.
    """
    opacity, elevation, shape = checked(opacity_g_cm2, elevation_deg, "opacity", "g/cm²")
    check_altitude(altitude_m)
    results = np.empty((4, *opacity.shape))  # in the order of Attenuation
    counts: Counter[str] = Counter()
    for block, block_elevation in blocks(opacity.shape, elevation, progress):
        rho = opacity[block]
        energy = minimum_energy(rho, physics)
        sky = Sky.at(
            block_elevation, physics, altitude_m, float(np.fmax.reduce(energy, None, initial=0.0))
        )
        flux = sky.flux_behind(rho, energy)
        for result, values in zip(results, (energy, flux, sky.open_sky, flux / sky.open_sky)):
            result[block] = values
        known = ~np.isnan(rho)
        counts["opacity"] += int(np.count_nonzero(~known))
        counts["horizon"] += int(np.count_nonzero(known & np.isnan(sky.open_sky)))
        counts["energy loss"] += int(
            np.count_nonzero(known & np.isnan(energy) & ~np.isnan(sky.open_sky))
        )
        counts += count_departures(
            rho, sky.cos_zenith, energy, physics.open_sky_start_gev, physics, altitude_m
        )
    energy, flux, open_sky, transmission = (result.reshape(shape) for result in results)
    return Attenuation(
        energy,
        flux,
        open_sky,
        transmission,
        sentences(counts, physics, altitude_m),
        {cause: counts[cause] for cause in ("opacity", "horizon", "energy loss")},
    )


@dataclass(frozen=True)
class Sky:
    """The muons that arrive from some directions, ready to be sent through rock."""

    physics: Physics
    #: Cosine of the zenith angle of each direction.
    cos_zenith: np.ndarray
    #: Flux without rock from each direction, cm⁻² sr⁻¹ day⁻¹; NaN at and below the horizon.
    open_sky: np.ndarray
    #: Integral spectra of the distinct zenith angles …
    spectrum: IntegralSpectrum
    #: … and which of them each direction has.
    row: np.ndarray

    @classmethod
    def at(
        cls, elevation_deg: np.ndarray, physics: Physics, altitude_m: float, highest_gev: float
    ) -> Sky:
        """Tabulate the sky.

        Parameters
        ----------
        elevation_deg
            Elevations above the horizon in degrees.
        physics
            Flux model and corrections.
        altitude_m
            Height of the detector above sea level, m.
        highest_gev
            Highest minimum energy that will be asked for, GeV.
        """
        cos_zenith = np.sin(np.radians(elevation_deg))
        above = cos_zenith > 0
        # Below the horizon there is no spectrum; a vertical one stands in and is not used.
        distinct, row = np.unique(np.where(above, cos_zenith, 1.0), return_inverse=True)
        row = row.reshape(cos_zenith.shape)
        spectrum = integral_spectrum(
            distinct,
            physics.flux_model,
            physics.gaisser_parameters,
            physics.open_sky_start_gev,
            highest_gev,
            altitude_m if physics.altitude_counts else None,
        )
        open_sky = np.where(above, spectrum.from_start[row], np.nan) * SECONDS_PER_DAY
        return cls(physics, cos_zenith, open_sky, spectrum, row)

    def flux_behind(self, opacity_g_cm2: np.ndarray, minimum_energy_gev: np.ndarray) -> np.ndarray:
        """Return the flux behind rock, cm⁻² sr⁻¹ day⁻¹, never above the open sky.

        Parameters
        ----------
        opacity_g_cm2, minimum_energy_gev
            Opacity in g/cm² and the kinetic energy in GeV it demands; arrays that
            broadcast with the directions.
        """
        begin = np.maximum(minimum_energy_gev, self.physics.open_sky_start_gev)
        intensity, index = self.spectrum(self.row, begin)
        if self.physics.straggling:
            intensity *= straggling_factor(opacity_g_cm2, index, self.physics.material)
        # No rock: the open sky, whatever the curve between two knots says.
        behind = np.where(opacity_g_cm2 == 0, np.inf, intensity * SECONDS_PER_DAY)
        return np.minimum(behind, self.open_sky)
