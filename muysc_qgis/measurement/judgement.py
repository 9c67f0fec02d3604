"""Whether densities can be: how they scatter, how far they reach, and what the sky says."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..progress import Progress, silent
from .density import Densities, Flag
from .observation import Observation
from .scene import Scene

#: Densities that rock has, g/cm³: from pumice to the densest lava.
LIGHTEST_G_CM3, DENSEST_G_CM3 = 0.5, 3.5


@dataclass(frozen=True)
class SkyCheck:
    """What pixels without rock saw over what they should have seen."""

    pixels: int
    #: NaN where there are no such pixels or no flux to compare with.
    ratio: float
    #: Standard error of the ratio, from counting or the errors given; NaN where unknown.
    error: float


def chi_squared(found: Densities, mean_density: float) -> float:
    """Return χ² per datum of densities about one for all; NaN for fewer than two.

    Parameters
    ----------
    found
        Densities; pixels of a region are one datum.
    mean_density
        g/cm³.
    """
    usable = (found.flags == Flag.MEASURED) & np.isfinite(found.error) & (found.error > 0)
    where = np.flatnonzero(usable)
    if found.region is not None and where.size:
        where = where[np.unique(found.region.ravel()[where], return_index=True)[1]]
    if where.size < 2:
        return float("nan")
    density, lower, upper = (
        one.ravel()[where] for one in (found.density, found.lower, found.upper)
    )
    # The side of the interval that the mean lies on.
    error = np.where(density > mean_density, density - lower, upper - density)
    return float(np.sum(((density - mean_density) / error) ** 2) / (where.size - 1))


def impossible(found: Densities) -> tuple[int, int]:
    """Return the pixels lighter and denser than any rock, beyond their errors."""
    measured = found.flags == Flag.MEASURED
    low = np.where(np.isfinite(found.lower), found.lower, found.density)
    high = np.where(np.isfinite(found.upper), found.upper, found.density)
    return (
        int(np.count_nonzero(measured & (high < LIGHTEST_G_CM3))),
        int(np.count_nonzero(measured & (low > DENSEST_G_CM3))),
    )


def check_sky(
    seen: Observation, scene: Scene, sky: np.ndarray, progress: Progress = silent
) -> SkyCheck:
    """Return what the pixels without rock say of acceptance and flux model.

    Parameters
    ----------
    seen, scene
        What was measured and where.
    sky
        (n_elevation, n_azimuth) pixels that see nothing but sky.
    progress
        Told the share done.
    """
    usable = sky & np.isfinite(seen.value) & (scene.elevation_deg > 0)
    number = int(np.count_nonzero(usable))
    if not number:
        return SkyCheck(0, float("nan"), float("nan"))
    bright = scene.flux_at(0.0, progress)[usable]
    value = (seen.value * seen.unit_flux(scene.physics, scene.altitude_m))[usable]
    if seen.counts is not None and seen.exposure is not None:
        counts = seen.counts[usable]
        weight = np.divide(counts, value, out=np.zeros_like(value), where=value > 0)
        expected, total = float(np.sum(bright * weight)), float(np.sum(counts))
        variance = 1.0 / total if total > 0 else float("nan")
        if seen.sky_counts is not None:
            variance += 1.0 / max(float(np.sum(seen.sky_counts[usable])), 1.0)
        if not (expected > 0 and total > 0):
            return SkyCheck(number, float("nan"), float("nan"))
        return SkyCheck(number, total / expected, total / expected * float(np.sqrt(variance)))
    ratio = float(np.median(value / bright))
    given = ((seen.ln_down + seen.ln_up) / 2.0)[usable]
    known = given[np.isfinite(given) & (given > 0)]
    error = float(np.sum(known**-2.0) ** -0.5) if known.size else float("nan")
    return SkyCheck(number, ratio, ratio * error)
