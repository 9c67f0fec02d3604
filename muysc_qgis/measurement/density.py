"""The mean density along each ray that explains what was measured."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import IntEnum

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, part, silent
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.energy_loss import minimum_energy
from ..radiography.envelope import Envelope, envelope_over_models, model_holds
from ..radiography.settings import Physics
from ..radiography.spectra import MODELS
from ..radiography.validity import OPEN_SKY_SLACK
from .observation import Observation
from .poisson import logarithmic_errors
from .pooling import first_telling, pooled
from .regions import merge_pixels
from .scene import Scene


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
    #: One ray says too little of what the pixel sees: rock and sky, or rock of many lengths.
    MIXED = 7


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
    """Return how small and how large the densities may be for what the flux is known.

    With a tabulated model, those of one standard error of it to either side; with a formula,
    the smallest and largest over the formulas that hold.

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
    if MODELS[scene.physics.flux_model].tabulated:
        return _within_band(seen, scene, minimum_counts, progress)
    cosine = np.sin(np.radians(scene.elevation_deg))

    def density_of(physics: Physics, progress: Progress) -> tuple[np.ndarray, np.ndarray]:
        there = replace(scene, physics=physics, model_uncertainty=0.0)
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


def _within_band(
    seen: Observation, scene: Scene, minimum_counts: float, progress: Progress
) -> Envelope:
    """Return the densities with a flux model one standard error darker, and brighter."""
    ends = []
    for turn, factor in enumerate((1.0 - scene.flux_error, 1.0 + scene.flux_error)):
        exposure = None if seen.exposure is None else seen.exposure * factor
        there = replace(
            seen, value=seen.value / factor, limit=seen.limit / factor, exposure=exposure
        )
        found = measure_density(
            there, scene, minimum_counts, part(progress, turn / 2, (turn + 1) / 2)
        )
        ends.append(np.where(found.flags == Flag.MEASURED, found.density, np.nan))
    known = int(np.count_nonzero(np.isfinite(ends[0])))
    return Envelope(ends[0], ends[1], {scene.physics.flux_model: known})


def _single(seen: Observation, scene: Scene, progress: Progress) -> Densities:
    """Return densities pixel by pixel."""
    unit = seen.unit_flux(scene.physics, scene.altitude_m)
    rock = scene.rock & np.isfinite(seen.value)

    def density_at(value: np.ndarray, turn: int) -> np.ndarray:
        within = part(progress, turn / 4, (turn + 1) / 4)
        return scene.density_of(value * unit, rock & np.isfinite(value), within)

    none = rock & (seen.value == 0)
    down, up = with_model(seen.ln_down, seen.ln_up, scene.model_uncertainty)
    density = density_at(seen.value, 0)
    # With less than comes past the rock there is no most dense, as there is without a muon.
    none |= rock & np.isnan(density) & (seen.value * unit <= scene.sky_flux)
    # A limit holds for the flux of the least favourable model.
    limit = density_at(np.where(none, seen.limit * np.exp(scene.model_uncertainty), np.nan), 1)
    density = np.where(none, limit, density)
    lower = np.where(none, limit, density_at(seen.value * np.exp(up), 2))
    upper = density_at(np.where(none, np.nan, seen.value * np.exp(-down)), 3)
    none &= np.isfinite(density)
    return _flagged(seen, scene, density, lower, upper, none, None)


def _merged(
    seen: Observation, scene: Scene, minimum_counts: float, progress: Progress
) -> Densities:
    """Return densities of regions, each pixel with that of its region."""
    rock = scene.rock & np.isfinite(seen.value)
    counts = np.zeros(rock.shape) if seen.counts is None else seen.counts
    weight = None
    if scene.rays is not None:
        # What was counted beside the rock says nothing of it. Regions follow from what is
        # expected, so that chance has no hand in their shape.
        told = first_telling(seen, scene, rock)
        rock &= told.slope > 0
        counts, weight = told.equivalent, np.maximum(told.slope, 0.0)
    region = merge_pixels(
        np.where(rock, counts, 0.0), rock, minimum_counts, part(progress, 0.0, 0.25)
    )
    pool = pooled(seen, scene, region, weight)
    down, up = with_model(*logarithmic_errors(*pool.kinds), scene.model_uncertainty)
    ends = [
        pool.density_for(pool.total * np.exp(shift), part(progress, turn / 4, (turn + 1) / 4))
        for turn, shift in enumerate((np.zeros_like(up), up, -down), start=1)
    ]
    none = pool.total == 0
    # With less than comes past the rock there is no most dense, as there is without a muon.
    none |= (np.isnan(ends[0]) & (scene.rays is not None)) & (pool.total > 0)
    if none.any():
        limits = pool.most(seen.confidence) * np.exp(scene.model_uncertainty)
        limit = pool.density_for(np.where(none, limits, np.nan), part(progress, 1.0, 1.0))
        ends = [np.where(none, limit, ends[0]), np.where(none, limit, ends[1]), ends[2]]
        none &= np.isfinite(limit)
    density, lower, upper = (np.append(end, np.nan)[region] for end in ends)
    return _flagged(
        seen, scene, density, lower, upper, rock & np.append(none, False)[region], region
    )


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
    if scene.mixed is not None:
        flags[scene.mixed] = Flag.MIXED
    flags[np.isnan(seen.value) | np.isnan(scene.thickness_m)] = Flag.NOT_MEASURED
    flags[scene.thickness_m == 0] = Flag.SKY
    nothing = np.isin(flags, (Flag.SKY, Flag.NOT_MEASURED, Flag.MIXED))
    density, lower, upper = (np.where(nothing, np.nan, end) for end in (density, lower, upper))
    return Densities(density, (upper - lower) / 2.0, lower, upper, flags, region)
