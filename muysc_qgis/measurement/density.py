"""The mean density along each ray that explains what was measured."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, part, silent
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.energy_loss import minimum_energy
from ..radiography.envelope import Envelope, envelope_over_models, model_holds
from ..radiography.inversion import opacity_from_flux
from ..radiography.settings import Physics
from ..radiography.transmission import attenuate
from ..radiography.validity import OPEN_SKY_SLACK
from .observation import Observation, pixels
from .poisson import logarithmic_errors
from .regions import merge_pixels
from .uniform import uniform_density

#: A flux this close to that of the open sky, relative to it, is not dimmed.
_UNDIMMED = 1e-12

#: Largest relative uncertainty of the flux model accepted.
_MAXIMUM_UNCERTAINTY = 1.0


class Flag(IntEnum):
    """What a pixel's density is."""

    MEASURED = 0
    #: No rock, so there is no density.
    SKY = 1
    #: No muon was counted; the density is the least that explains this.
    LOWER_LIMIT = 2
    #: As much flux as from the open sky, or more: the density is 0.
    BRIGHT = 3
    #: The measurement or the thickness is missing.
    NOT_MEASURED = 4
    #: No density of any matter explains the flux, or no flux model has an answer.
    NO_ANSWER = 5
    #: So little rock that it stops no muon of those that count.
    TOO_THIN = 6


@dataclass(frozen=True)
class Densities:
    """Densities in g/cm³, arrays (n_elevation, n_azimuth), NaN where there is none."""

    #: The estimate; a lower limit where flagged so.
    density: np.ndarray
    #: Half of `upper` − `lower`; NaN for limits and where there is no upper end.
    error: np.ndarray
    #: Ends of the interval of one standard deviation.
    lower: np.ndarray
    upper: np.ndarray
    #: `Flag` of each pixel.
    flags: np.ndarray
    #: Number of each pixel's region from 0, −1 for none; None if nothing was merged.
    region: np.ndarray | None

    def opacity(self, thickness_m: np.ndarray) -> np.ndarray:
        """Return the opacity in g/cm², density times thickness; 0 in the sky."""
        opacity = self.density * thickness_m * G_CM2_PER_M_WATER_EQUIVALENT
        return np.where(self.flags == Flag.SKY, 0.0, opacity)

    @property
    def regions(self) -> int:
        """Number of regions with a density of their own."""
        if self.region is None:
            return self.count(Flag.MEASURED)
        return int(self.region.max(initial=-1)) + 1

    def count(self, flag: Flag) -> int:
        """Return the number of pixels with a flag."""
        return int(np.count_nonzero(self.flags == flag))


@dataclass(frozen=True)
class Scene:
    """Where the telescope looked, and how muons are produced and stopped.

    Raises
    ------
    MuyscError
        If a thickness is negative or infinite, or the uncertainty is no share.
    """

    #: (n_elevation, n_azimuth) rock along each ray, m.
    thickness_m: np.ndarray
    #: Elevation of the rays in degrees, (n_elevation, 1) or one for each.
    elevation_deg: np.ndarray
    physics: Physics
    altitude_m: float
    #: Relative uncertainty of the flux model, the same for all pixels.
    model_uncertainty: float = 0.0

    def __post_init__(self) -> None:
        bad = self.thickness_m[(self.thickness_m < 0) | np.isinf(self.thickness_m)]
        if bad.size:
            raise MuyscError(
                f"The thickness is negative or infinite in {pixels(bad.size)}, such as "
                f"{bad[0]:g} m; give 0 for the sky and no-data where unknown."
            )
        check_uncertainty(self.model_uncertainty)

    @cached_property
    def too_thin(self) -> np.ndarray:
        """Where the material at its own density would dim no flux, (n_elevation, n_azimuth)."""
        opacity = self.thickness_m * self.physics.density * G_CM2_PER_M_WATER_EQUIVALENT
        muons = attenuate(opacity, self.elevation_deg, self.physics, self.altitude_m)
        return (self.thickness_m > 0) & (muons.transmission > 1.0 - _UNDIMMED)

    @cached_property
    def rock(self) -> np.ndarray:
        """Where there is rock above the horizon that dims the flux, (n_elevation, n_azimuth)."""
        return (self.thickness_m > 0) & (self.elevation_deg > 0) & ~self.too_thin


def check_uncertainty(share: float) -> None:
    """Refuse an uncertainty of the flux model that is no share of the flux.

    Raises
    ------
    MuyscError
        If it is not from 0 to below 1.
    """
    if not 0 <= share < _MAXIMUM_UNCERTAINTY:
        raise MuyscError(
            f"A flux-model uncertainty of {100 * share:g} % cannot be used; give one from 0 to "
            f"below {100 * _MAXIMUM_UNCERTAINTY:g} %."
        )


def check_minimum(counts: float) -> None:
    """Refuse a number of counts that pixels cannot be merged up to.

    Raises
    ------
    MuyscError
        If it is not 0 (no merging) or more, and finite.
    """
    if not 0 <= counts < np.inf:
        raise MuyscError(f"A minimum of {counts:g} counts cannot be reached; give 0 or more.")


def measure_density(
    seen: Observation, scene: Scene, minimum_counts: float = 0.0, progress: Progress = silent
) -> Densities:
    """Return density, error and flag of every pixel.

    The opacity is the inverse of I(ϱ, θ) and the density ϱ/(100 L). An interval of one
    standard deviation in ln I, counting error and model uncertainty in quadrature, becomes
    one in the density: to first order σρ/ρ = σ(ln I)/|dlnI/dlnϱ|.

    Parameters
    ----------
    seen
        What was measured.
    scene
        Thickness, directions and physics.
    minimum_counts
        Neighbouring pixels are merged until each region has counted as many; 0 for no
        merging.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If pixels are to be merged that hold no counts, or a value cannot be used.
    Cancelled
        If `progress` asks for a stop.
    """
    if minimum_counts > 0:
        if seen.counts is None or seen.exposure is None:
            raise MuyscError(
                f"Pixels can be merged up to {minimum_counts:g} counts only where muons were "
                "counted; give muon counts, or 0 for no merging."
            )
        return _merged(seen, scene, minimum_counts, progress)
    return _single(seen, scene, progress)


def model_densities(
    seen: Observation, scene: Scene, minimum_counts: float = 0.0, progress: Progress = silent
) -> Envelope:
    """Return the smallest and largest density over the flux models that hold.

    Parameters
    ----------
    seen, scene, minimum_counts, progress
        As in `measure_density`.

    Raises
    ------
    MuyscError
        As there.
    Cancelled
        If `progress` asks for a stop.
    """
    cosine = np.sin(np.radians(scene.elevation_deg))

    def density_of(physics: Physics, progress: Progress) -> tuple[np.ndarray, np.ndarray]:
        there = Scene(scene.thickness_m, scene.elevation_deg, physics, scene.altitude_m)
        found = measure_density(seen, there, minimum_counts, progress)
        measured = found.flags == Flag.MEASURED
        opacity = found.opacity(scene.thickness_m)
        start = physics.open_sky_start_gev
        holds = model_holds(physics, cosine, np.fmax(minimum_energy(opacity, physics), start))
        if seen.sky_elevation_deg is not None:
            sky = np.sin(np.radians(seen.sky_elevation_deg))
            holds &= model_holds(physics, sky, np.array(start), OPEN_SKY_SLACK)
        return found.density, holds & measured

    return envelope_over_models(scene.physics, density_of, progress)


def _single(seen: Observation, scene: Scene, progress: Progress) -> Densities:
    """Return densities pixel by pixel."""
    unit = seen.unit_flux(scene.physics, scene.altitude_m)
    rock = scene.rock & np.isfinite(seen.value)

    def density_at(value: np.ndarray, turn: int) -> np.ndarray:
        flux = np.where(rock, value * unit, np.nan)
        opacity = opacity_from_flux(
            flux,
            scene.elevation_deg,
            scene.physics,
            scene.altitude_m,
            part(progress, turn / 4, (turn + 1) / 4),
        )
        length = np.where(rock, scene.thickness_m, np.nan)
        return opacity / (length * G_CM2_PER_M_WATER_EQUIVALENT)

    none = rock & (seen.value == 0)
    down, up = with_model(seen.ln_down, seen.ln_up, scene.model_uncertainty)
    # A limit holds for the flux of the least favourable model.
    limit = density_at(np.where(none, seen.limit * np.exp(scene.model_uncertainty), np.nan), 0)
    density = np.where(none, limit, density_at(seen.value, 1))
    lower = np.where(none, limit, density_at(seen.value * np.exp(up), 2))
    upper = density_at(np.where(none, np.nan, seen.value * np.exp(-down)), 3)
    return _flagged(seen, scene, density, lower, upper, none, None)


def _merged(
    seen: Observation, scene: Scene, minimum_counts: float, progress: Progress
) -> Densities:
    """Return densities of regions, each pixel with that of its region."""
    rock = scene.rock & np.isfinite(seen.value)
    counts = np.zeros(rock.shape) if seen.counts is None else seen.counts
    region = merge_pixels(
        np.where(rock, counts, 0.0), rock, minimum_counts, part(progress, 0.0, 0.25)
    )
    total, density_for = pooled(seen, scene, region)
    down, up = with_model(*logarithmic_errors(*total), scene.model_uncertainty)
    ends = [
        density_for(total[0] * np.exp(shift), part(progress, turn / 4, (turn + 1) / 4))
        for turn, shift in enumerate((np.zeros_like(up), up, -down), start=1)
    ]
    if not total[0].any() and rock.any():
        # A picture without any muon is one region, and its density has a limit.
        most = np.nanmax((seen.limit * seen.exposure)[rock]) * np.exp(scene.model_uncertainty)
        ends[0] = ends[1] = density_for(np.array([most]), part(progress, 1.0, 1.0))
    density, lower, upper = (np.append(end, np.nan)[region] for end in ends)
    none = rock & (np.append(total[0], 1.0)[region] == 0)
    return _flagged(seen, scene, density, lower, upper, none, region)


def pooled(
    seen: Observation, scene: Scene, region: np.ndarray
) -> tuple[tuple[np.ndarray, ...], Callable[[np.ndarray, Progress], np.ndarray]]:
    """Return the counts of regions (and of the open sky), and their density for given counts.

    Parameters
    ----------
    seen, scene
        What was measured, as counts, and where.
    region
        (n_elevation, n_azimuth) number of each pixel's region from 0, −1 for none.
    """
    inside = region >= 0
    label, number = region[inside], int(region.max(initial=-1)) + 1
    exposure = seen.exposure / seen.unit_flux(scene.physics, scene.altitude_m)
    elevation = np.broadcast_to(scene.elevation_deg, region.shape)

    def density_for(counts: np.ndarray, progress: Progress) -> np.ndarray:
        return uniform_density(
            counts,
            label,
            exposure[inside],
            scene.thickness_m[inside],
            elevation[inside],
            scene.physics,
            scene.altitude_m,
            progress,
        )

    kinds = [kind for kind in (seen.counts, seen.sky_counts) if kind is not None]
    return tuple(np.bincount(label, kind[inside], number) for kind in kinds), density_for


def with_model(
    down: np.ndarray, up: np.ndarray, uncertainty: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return errors in ln I with the model's in quadrature; the model's alone if unknown.

    Parameters
    ----------
    down, up
        Errors of the measurement, NaN where unknown.
    uncertainty
        Relative uncertainty of the flux model.
    """
    if uncertainty <= 0:
        return down, up
    return (
        np.hypot(np.nan_to_num(down, posinf=np.inf), uncertainty),
        np.hypot(np.nan_to_num(up), uncertainty),
    )


def _flagged(
    seen: Observation,
    scene: Scene,
    density: np.ndarray,
    lower: np.ndarray,
    upper: np.ndarray,
    none: np.ndarray,
    region: np.ndarray | None,
) -> Densities:
    """Gather densities with the flag of each pixel, the stronger reason last."""
    flags = np.full(density.shape, int(Flag.MEASURED))
    flags[density == 0] = Flag.BRIGHT
    flags[none] = Flag.LOWER_LIMIT
    flags[np.isnan(density)] = Flag.NO_ANSWER
    flags[scene.too_thin] = Flag.TOO_THIN
    flags[np.isnan(seen.value) | np.isnan(scene.thickness_m)] = Flag.NOT_MEASURED
    flags[scene.thickness_m == 0] = Flag.SKY
    nothing = (flags == Flag.SKY) | (flags == Flag.NOT_MEASURED)
    density, lower, upper = (np.where(nothing, np.nan, end) for end in (density, lower, upper))
    return Densities(density, (upper - lower) / 2.0, lower, upper, flags, region)
