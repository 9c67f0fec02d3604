"""One density for all rock that was seen, and how well it is known."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..progress import Progress, part, silent
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.transmission import attenuate
from .density import Densities, Flag, Scene, pooled, with_model
from .observation import Observation
from .poisson import EXACT_BELOW, logarithmic_errors
from .uniform import uniform_density

#: Relative step of the density that the slope of the flux is taken over.
_STEP = 1e-3


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

    For counts it is the root of Σ a N = Σ a 𝓔 I(100 ρ L, θ) over all pixels, those without
    a muon included. The weights a = s/(1 + 𝓔I/N₀ + u² 𝓔I), with the slope s = dlnI/dlnρ,
    the counts N₀ of the open sky and the uncertainty u of the model, are the inverse
    variances that a density would have in each pixel, taken at the expected counts: weights
    from the pixel's own counts, or leaving out pixels without any, would draw the mean to
    lower densities. For a flux or a transmission it is the mean weighted by the inverse
    squares of the errors of the densities.

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
    if seen.counts is None:
        return _weighted_mean(seen, found, scene.model_uncertainty)
    rock = scene.rock & np.isfinite(seen.value)
    if not rock.any():
        return _UNKNOWN
    total, density_for = pooled(seen, scene, np.where(rock, 0, -1))
    first = float(density_for(total[0], part(progress, 0.0, 0.4))[0])
    if min(float(kind[0]) for kind in total) < EXACT_BELOW or not first > 0:
        return _from_total(
            first, total, density_for, scene.model_uncertainty, part(progress, 0.4, 1.0)
        )
    return _from_weights(first, seen, scene, rock, seen.counts[rock], part(progress, 0.4, 1.0))


def _from_total(
    first: float,
    total: tuple[np.ndarray, ...],
    density_for: Callable[[np.ndarray, Progress], np.ndarray],
    uncertainty: float,
    progress: Progress,
) -> Mean:
    """Return the density of the sum of all counts, with its exact interval."""
    errors = logarithmic_errors(*total)
    halves = []
    for half, (down, up) in enumerate((errors, with_model(*errors, uncertainty))):
        ends = [
            density_for(total[0] * np.exp(shift), part(progress, turn / 4, (turn + 1) / 4))
            for turn, shift in enumerate((up, -down), start=2 * half)
        ]
        halves.append(float((ends[1] - ends[0])[0]) / 2.0)
    return Mean(first, halves[1], halves[0])


def _from_weights(
    first: float,
    seen: Observation,
    scene: Scene,
    rock: np.ndarray,
    counted: np.ndarray,
    progress: Progress,
) -> Mean:
    """Return the density of weighted sums of counts, given a first guess."""
    exposure = (seen.exposure / seen.unit_flux(scene.physics, scene.altitude_m))[rock]
    elevation = np.broadcast_to(scene.elevation_deg, rock.shape)[rock]
    length = scene.thickness_m[rock]

    def expected(density: float, turn: int) -> np.ndarray:
        opacity = density * length * G_CM2_PER_M_WATER_EQUIVALENT
        within = part(progress, turn / 10, (turn + 1) / 10)
        flux = attenuate(opacity, elevation, scene.physics, scene.altitude_m, within).flux
        return exposure * np.nan_to_num(flux)

    counts = expected(first, 0)
    more = expected(first * (1.0 + _STEP), 1)
    some = counts > 0
    ratio = np.divide(more, counts, out=np.ones_like(counts), where=some & (more > 0))
    slope = -np.log(ratio) / np.log1p(_STEP)
    # Variance of the counts over their mean, but for the model's part.
    spread = np.ones_like(counts)
    if seen.sky_counts is not None:
        spread += counts / seen.sky_counts[rock]
    uncertainty = scene.model_uncertainty
    weight = slope / (spread + uncertainty**2 * counts)
    density = float(
        uniform_density(
            np.array([np.sum(weight * counted)]),
            np.zeros(counts.shape, dtype=int),
            weight * exposure,
            length,
            elevation,
            scene.physics,
            scene.altitude_m,
            part(progress, 0.2, 1.0),
        )[0]
    )
    # How the weighted sum falls with ln ρ turns its errors into those of the density.
    fall = np.sum(weight * counts * slope)
    own = density * float(np.sqrt(np.sum(weight**2 * counts * spread)) / fall)
    model = density * uncertainty * float(np.sum(weight * counts) / fall)
    return Mean(density, float(np.hypot(own, model)), own)


def _weighted_mean(seen: Observation, found: Densities, uncertainty: float) -> Mean:
    """Return the mean of the pixels' densities, weighted by their errors where there are any."""
    measured = found.flags == Flag.MEASURED
    density, error = found.density[measured], found.error[measured]
    if not density.size:
        return _UNKNOWN
    usable = np.isfinite(error) & (error > 0)
    if not usable.any():
        return Mean(float(density.mean()), np.nan, np.nan)
    density, error = density[usable], error[usable]
    given = ((seen.ln_down + seen.ln_up) / 2.0)[measured][usable]
    # The shares of each density's error that the errors given, and the model, stand for.
    share = np.nan_to_num(given) / np.hypot(np.nan_to_num(given), uncertainty)
    weight = error**-2.0
    weight /= weight.sum()
    own = float(np.sqrt(np.sum((weight * error * share) ** 2)))
    model = float(np.sum(weight * error * np.sqrt(1.0 - share**2)))
    return Mean(
        float(np.sum(weight * density)),
        float(np.hypot(own, model)),
        own if np.isfinite(given).any() else np.nan,
    )
