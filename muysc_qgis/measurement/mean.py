"""One density for all rock that was seen, and how well it is known."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..progress import Progress, part, silent
from .density import Densities, Flag, with_model
from .observation import Observation
from .poisson import EXACT_BELOW, logarithmic_errors
from .pooling import Pool, counts_per_flux, first_telling, flux_and_slope, pooled, telling
from .scene import Scene
from .uniform import uniform_density

#: A pixel farther off than this many of its errors, by the scatter of all, counts for no more
#: than it would there (Huber 1964, doi:10.1214/aoms/1177703732) …
_FAR = 3.0
#: … and as many muons more, because few counts scatter unevenly.
_SLACK = 3.0

#: Median of the size of a normal deviate.
_MEDIAN_DEVIATE = 0.6745

#: Rounds of weights and density.
_ROUNDS = 3


@dataclass(frozen=True)
class Mean:
    """One density for all rock seen, with its errors, g/cm³; NaN where unknown."""

    density: float
    #: With the flux model's uncertainty, which does not average out.
    error: float
    #: From counting (or the errors given) alone.
    statistical_error: float


_UNKNOWN = Mean(np.nan, np.nan, np.nan)


def mean_density(
    seen: Observation, scene: Scene, found: Densities, progress: Progress = silent
) -> Mean:
    """Return the one density that explains all pixels with rock.

    The root of Σ a v = Σ a v(ρ) over all pixels, those without a muon included, for what was
    measured, v, and what one density would give, v(ρ). The weights a are the inverse variances
    that a density would have in each pixel, taken at what is expected: weights from the pixel's
    own counts, or leaving out pixels without any, would draw the mean to lower densities.
    Pixels that are off by more than three times the scatter count for less, so that a few
    that cannot be right do not rule.

    For counts a = s/(1 + 𝓔I/N₀ + u² 𝓔I), with the slope s = −dlnI/dlnρ, the counts N₀ of the
    open sky and the uncertainty u of the model; for a flux or a transmission I with the
    relative error σ it is a = s/(I (σ² + u²)).

    Parameters
    ----------
    seen, scene
        What was measured and where.
    found
        From `measure_density`.
    progress
        Told the share done.

    Raises
    ------
    Cancelled
        If `progress` asks for a stop.
    """
    rock = scene.rock & np.isfinite(seen.value)
    if seen.counts is None:
        return _of_values(seen, scene, rock, found, progress)
    if not rock.any():
        return _UNKNOWN
    if scene.rays is None:
        pool = pooled(seen, scene, np.where(rock, 0, -1))
        first = float(pool.density_for(pool.total, part(progress, 0.0, 0.4))[0])
    else:
        told = first_telling(seen, scene, rock)
        rock &= told.slope > 0
        if not rock.any():
            return _UNKNOWN
        pool = pooled(seen, scene, np.where(rock, 0, -1), np.maximum(told.slope, 0.0))
        first = float(pool.density_for(pool.total, part(progress, 0.0, 0.4))[0])
    if min(float(kind[0]) for kind in pool.kinds) < EXACT_BELOW or not first > 0:
        return _of_sum(first, pool, scene.model_uncertainty, part(progress, 0.4, 1.0))
    return _of_counts(first, seen, scene, rock, part(progress, 0.4, 1.0))


def _of_sum(first: float, pool: Pool, uncertainty: float, progress: Progress) -> Mean:
    """Return the density of the sum of all counts, with its exact interval."""
    errors = logarithmic_errors(*pool.kinds)
    halves = []
    for half, (down, up) in enumerate((errors, with_model(*errors, uncertainty))):
        ends = [
            pool.density_for(pool.total * np.exp(shift), part(progress, turn / 4, (turn + 1) / 4))
            for turn, shift in enumerate((up, -down), start=2 * half)
        ]
        halves.append(float((ends[1] - ends[0])[0]) / 2.0)
    return Mean(first, halves[1], halves[0])


def _of_counts(
    first: float, seen: Observation, scene: Scene, rock: np.ndarray, progress: Progress
) -> Mean:
    """Return the density of weighted sums of counts, given a first guess."""
    uncertainty, density = scene.model_uncertainty, first
    per_flux, own_counts = counts_per_flux(seen, scene), seen.counts
    counted = np.where(rock, np.nan if own_counts is None else own_counts, 0.0)
    own = model = np.nan
    for turn in range(_ROUNDS):
        done = part(progress, turn / _ROUNDS, (turn + 1) / _ROUNDS)
        told = telling(seen, scene, density, part(done, 0.0, 0.2))
        counts, slope = np.where(rock, told.counts, 0.0), np.where(rock, told.slope, 0.0)
        # Variance of the counts over their mean, but for the model's part.
        spread = np.ones_like(counts)
        if seen.sky_counts is not None:
            spread += np.divide(
                counts, seen.sky_counts, out=np.zeros_like(counts), where=seen.sky_counts > 0
            )
        variance = counts * spread + (uncertainty * counts) ** 2
        near = _nearness(counted - counts, np.sqrt(variance), rock & (slope > 0), _SLACK)
        weight = near * slope / (spread + uncertainty**2 * counts)
        expected, highest = scene.expected(np.where(rock, 0, -1), weight * per_flux, 1)
        total = np.array([np.sum(weight * counted)])
        found = float(uniform_density(total, expected, highest, part(done, 0.2, 1.0))[0])
        if not found > 0:
            break
        # How the weighted sum falls with ln ρ turns its errors into those of the density.
        fall = np.sum(weight * counts * slope)
        own = found * float(np.sqrt(np.sum(weight**2 * counts * spread)) / fall)
        model = found * uncertainty * float(np.sum(weight * counts) / fall)
        density = found
    return Mean(density, float(np.hypot(own, model)), own)


def _of_values(
    seen: Observation, scene: Scene, rock: np.ndarray, found: Densities, progress: Progress
) -> Mean:
    """Return the density of weighted sums of fluxes or transmissions."""
    unit = seen.unit_flux(scene.physics, scene.altitude_m)
    given = (seen.ln_down + seen.ln_up) / 2.0
    measured = found.density[(found.flags == Flag.MEASURED) & rock]
    if not measured.size:
        return _UNKNOWN
    told = bool(np.isfinite(given[rock]).any())
    relative = given if told else np.ones(rock.shape)
    rock = rock & np.isfinite(relative) & (relative > 0)
    if not rock.any():
        return _UNKNOWN
    uncertainty, density = scene.model_uncertainty, float(np.median(measured))
    flux = np.where(rock, seen.value * unit, 0.0)
    own = model = np.nan
    for turn in range(_ROUNDS):
        done = part(progress, turn / _ROUNDS, (turn + 1) / _ROUNDS)
        there = flux_and_slope(scene, density, part(done, 0.0, 0.2))
        rock = rock & (there[0] > 0) & (there[1] > 0)
        if not rock.any():
            break
        bright, slope = np.where(rock, there[0], 1.0), np.where(rock, there[1], 0.0)
        # Errors grow with the value: one that is too low is not the surer for it.
        error = np.where(rock, relative, 1.0) * np.maximum(1.0, flux / bright)
        near = _nearness(flux - bright, bright * np.hypot(error, uncertainty), rock, 0.0, told)
        weight = np.where(rock, near * slope / (bright * (error**2 + uncertainty**2)), 0.0)
        expected, highest = scene.expected(np.where(rock, 0, -1), weight, 1)
        total = np.array([np.sum(weight * flux)])
        answer = float(uniform_density(total, expected, highest, part(done, 0.2, 1.0))[0])
        if not answer > 0:
            break
        density = answer
        fall = np.sum(weight * bright * slope)
        own = density * float(np.sqrt(np.sum((weight * bright * error) ** 2)) / fall)
        model = density * uncertainty * float(np.sum(weight * bright) / fall)
    if not told:
        return Mean(density, model if uncertainty > 0 else np.nan, np.nan)
    return Mean(density, float(np.hypot(own, model)), own)


def _nearness(
    off: np.ndarray, error: np.ndarray, chosen: np.ndarray, slack: float, known: bool = True
) -> np.ndarray:
    """Return factors of at most 1 that keep far pixels from counting for more than others.

    Parameters
    ----------
    off, error
        How far values are from what is expected, and their standard errors.
    chosen
        Which pixels take part.
    slack
        What values may be farther off, in their own unit.
    known
        Whether the errors are; else the scatter alone says what is far.
    """
    pulls = np.abs(off[chosen]) / np.maximum(error[chosen], 1e-300)
    scatter = float(np.median(pulls)) / _MEDIAN_DEVIATE if pulls.size else 1.0
    allowed = _FAR * max(scatter, 1.0 if known else 1e-9) * error + slack
    return np.asarray(np.minimum(1.0, allowed / np.maximum(np.abs(off), 1e-300)))
