"""The one density of several pixels that lets through as many muons as were counted."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import numpy as np

from ..progress import Progress, part, silent
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.roots import falling_roots
from ..radiography.settings import Physics
from ..radiography.transmission import attenuate

#: Densities tried, g/cm³: from next to nothing to beyond any matter, because a thickness
#: that is wrong must show as a density that cannot be.
_LOWEST_G_CM3 = 1e-4
_HIGHEST_G_CM3 = 1e4

#: Halvings of this range before the faster search.
_HALVINGS = 8

#: Counts expected of each region, given its density and what is told the share done.
Expected = Callable[[np.ndarray, Progress], np.ndarray]


def uniform_density(
    counts: np.ndarray,
    expected: Expected,
    highest_g_cm3: float = _HIGHEST_G_CM3,
    progress: Progress = silent,
) -> np.ndarray:
    """Return the density of each region at which as many counts are expected as there were.

    The mean of the opacities would be wrong where the thickness varies, because the flux
    falls with the opacity along a curve; the expected counts add up exactly.

    Parameters
    ----------
    counts
        (n_region,) counts N of the regions, or anything else that falls with the density.
    expected
        What is expected at densities, (n_region,) from (n_region,); see `expected_of_pixels`.
    highest_g_cm3
        Densities up to this are tried.
    progress
        Told the share done.

    Returns
    -------
    numpy.ndarray
        (n_region,) g/cm³; 0 where more was counted than the open sky gives, NaN where
        nothing was counted or less than the densest lets through.

    Raises
    ------
    Cancelled
        If `progress` asks for a stop.
    """
    ln_counts = np.log(np.where(counts > 0, counts, np.nan))
    tries = itertools.count()

    def excess(density: np.ndarray) -> np.ndarray:
        tried = next(tries)
        within = part(progress, _share_done(tried), _share_done(tried + 1))
        return np.log(np.maximum(expected(density, within), np.finfo(float).tiny)) - ln_counts

    low = np.full(len(counts), np.log(_LOWEST_G_CM3))
    high = np.full(len(counts), np.log(highest_g_cm3))
    at_low, at_high = excess(np.exp(low)), excess(np.exp(high))
    is_sky, has_answer = excess(np.zeros(len(counts))) <= 0, at_high <= 0
    found = falling_roots(
        lambda ln_density: excess(np.exp(np.nan_to_num(ln_density))),
        low, high, at_low, at_high, ~is_sky & has_answer, _HALVINGS,
    )  # fmt: skip
    answer = np.where(has_answer, np.exp(found), np.nan)
    return np.where(np.isnan(ln_counts), np.nan, np.where(is_sky, 0.0, answer))


def expected_of_pixels(
    region: np.ndarray,
    exposure: np.ndarray,
    thickness_m: np.ndarray,
    elevation_deg: np.ndarray,
    physics: Physics,
    altitude_m: float,
    number: int,
) -> Expected:
    """Return what Σ 𝓔 I(100 ρ L, θ) over the pixels of each region is at densities.

    Parameters
    ----------
    region
        (n_pixel,) number of each pixel's region.
    exposure
        (n_pixel,) counts 𝓔 for a flux of 1 cm⁻² sr⁻¹ day⁻¹, that is cm² sr days.
    thickness_m
        (n_pixel,) thickness L of rock, above 0.
    elevation_deg
        (n_pixel,) elevation in degrees, above 0.
    physics, altitude_m
        As in `attenuate`.
    number
        Number of regions.
    """

    def expected(density: np.ndarray, progress: Progress) -> np.ndarray:
        opacity = density[region] * thickness_m * G_CM2_PER_M_WATER_EQUIVALENT
        flux = attenuate(opacity, elevation_deg, physics, altitude_m, progress).flux
        # Beyond the end of the range law nothing comes through.
        return np.bincount(region, exposure * np.nan_to_num(flux), number)

    return expected


def _share_done(tried: int) -> float:
    """Return the share done after some densities; about twenty are tried as a rule."""
    return float(1.0 - 0.9**tried)
