"""Counts of several pixels together, and how much each of them tells of the density."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..progress import Progress, part, silent
from .observation import Observation
from .poisson import ratio_upper_limit, upper_limit
from .scene import Scene
from .uniform import Expected, uniform_density

#: Relative step of the density that the slope of the flux is taken over.
_STEP = 1e-3

#: Rounds in which a first guess of the density becomes one that weights may follow from.
_ROUNDS = 2


@dataclass(frozen=True)
class Pool:
    """Weighted sums of counts over regions, and the density that explains them."""

    #: (n_region,) Σ a N.
    total: np.ndarray
    #: (n_region,) plain counts that are as sure as the sum, (Σ a N)²/Σ a² N …
    effective: np.ndarray
    #: … and the same of the open sky, None where there is none.
    sky: np.ndarray | None
    _expected: Expected
    _highest: float
    #: (n_region,) weight of a count where there is none.
    _weight: np.ndarray

    @property
    def kinds(self) -> tuple[np.ndarray, ...]:
        """Effective counts, and those of the open sky where there are any."""
        return (self.effective,) if self.sky is None else (self.effective, self.sky)

    def density_for(self, total: np.ndarray, progress: Progress = silent) -> np.ndarray:
        """Return the density of each region at which a weighted sum is expected, g/cm³."""
        return uniform_density(total, self._expected, self._highest, progress)

    def most(self, confidence: float) -> np.ndarray:
        """Return the weighted sums that are not exceeded at a one-sided confidence."""
        if self.sky is None:
            most = upper_limit(self.effective, confidence)
        else:
            most = self.sky * ratio_upper_limit(self.effective, self.sky, confidence)
        some = self.effective > 0
        scale = np.where(some, self.total / np.where(some, self.effective, 1.0), self._weight)
        return np.asarray(scale * most)


def counts_per_flux(seen: Observation, scene: Scene) -> np.ndarray:
    """Return the counts that a flux of 1 cm⁻² sr⁻¹ day⁻¹ gives in each pixel."""
    return np.asarray(seen.exposure / seen.unit_flux(scene.physics, scene.altitude_m))


def pooled(
    seen: Observation, scene: Scene, region: np.ndarray, weight: np.ndarray | None = None
) -> Pool:
    """Return the counts of regions, and what gives their density.

    Parameters
    ----------
    seen, scene
        What was measured, as counts, and where.
    region
        (n_elevation, n_azimuth) number of each pixel's region from 0, −1 for none.
    weight
        (n_elevation, n_azimuth) weights a above 0; None for 1.
    """
    inside = region >= 0
    label, number = region[inside], int(region.max(initial=-1)) + 1
    factor = np.ones(region.shape) if weight is None else weight
    a = factor[inside]
    counts = seen.counts[inside] if seen.counts is not None else np.zeros(len(label))
    total = np.bincount(label, a * counts, number)
    square = np.bincount(label, a**2 * counts, number)
    effective = np.divide(total**2, square, out=np.zeros(number), where=square > 0)
    if weight is None:
        effective = total  # whole numbers stay whole
    sky = None
    if seen.sky_counts is not None:
        sky = np.bincount(label, seen.sky_counts[inside], number)
    exposure = np.where(inside, factor * counts_per_flux(seen, scene), 0.0)
    mean = np.bincount(label, a, number) / np.maximum(np.bincount(label, minlength=number), 1)
    return Pool(total, effective, sky, *scene.expected(region, exposure, number), mean)


@dataclass(frozen=True)
class Telling:
    """What each pixel would tell at one density, (n_elevation, n_azimuth) each."""

    density: float
    #: Counts expected, and how steeply they fall: −dlnμ/dlnρ.
    counts: np.ndarray
    slope: np.ndarray
    #: Counts through rock alone that would tell as much: R²/μ for R of the μ counts.
    equivalent: np.ndarray


def telling(
    seen: Observation, scene: Scene, density: float, progress: Progress = silent
) -> Telling:
    """Return what each pixel would tell if all rock had a density (g/cm³)."""
    per_flux = counts_per_flux(seen, scene)
    flux, slope = flux_and_slope(scene, density, progress)
    counts = per_flux * flux
    through_rock = np.maximum(counts - per_flux * scene.sky_flux, 0.0)
    equivalent = np.divide(through_rock**2, counts, out=np.zeros_like(counts), where=counts > 0)
    return Telling(density, counts, slope, equivalent)


def flux_and_slope(
    scene: Scene, density: float, progress: Progress = silent
) -> tuple[np.ndarray, np.ndarray]:
    """Return the flux of every pixel at a density (g/cm³), and −dlnI/dlnρ; 0 where it is none."""
    flux = scene.flux_at(density, part(progress, 0.0, 0.5))
    more = scene.flux_at(density * (1.0 + _STEP), part(progress, 0.5, 1.0))
    some = (flux > 0) & (more > 0)
    ratio = np.divide(more, flux, out=np.ones_like(flux), where=some)
    return flux, -np.log(ratio) / np.log1p(_STEP)


def first_telling(seen: Observation, scene: Scene, rock: np.ndarray) -> Telling:
    """Return what pixels tell at the one density that explains them best, roughly.

    Parameters
    ----------
    seen, scene
        What was measured, as counts, and where.
    rock
        (n_elevation, n_azimuth) pixels that take part.
    """
    found = telling(seen, scene, scene.physics.density)
    for _ in range(_ROUNDS):
        usable = rock & (found.slope > 0)
        pool = pooled(seen, scene, np.where(usable, 0, -1), np.maximum(found.slope, 0.0))
        density = pool.density_for(pool.total) if usable.any() else np.array([np.nan])
        if not density[0] > 0:
            break
        found = telling(seen, scene, float(density[0]))
    return found
