"""What comes through as a function of the density: tabulated once, looked up and inverted often."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..progress import Progress, report, silent
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.interpolation import hermite
from ..radiography.settings import Physics
from ..radiography.transmission import attenuate
from .sub_rays import SubRays

#: Densities tabulated, g/cm³, and their spacing in the logarithm: a Hermite curve through them
#: is then right to 10⁻⁵ of the flux.
_LOWEST_G_CM3 = 0.02
_HIGHEST_G_CM3 = 50.0
_LN_STEP = 0.125

#: Smallest flux whose logarithm is taken.
_TINY = 1e-30

#: Elevations tabulated at a time.
_ROWS = 512


@dataclass(frozen=True)
class DensityCurves:
    """Sums of fluxes, or counts, behind rock of one density each.

    Parameters
    ----------
    ln_density
        (n_density,) logarithms of densities in g/cm³, evenly spaced.
    values
        (n, n_density) sums at these densities, falling.
    open_sky
        (n,) sums without rock.
    sky
        (n,) the part of the sums that no rock is in the way of.
    """

    ln_density: np.ndarray
    values: np.ndarray
    open_sky: np.ndarray
    sky: np.ndarray

    @classmethod
    def of(
        cls, rays: SubRays, physics: Physics, altitude_m: float, progress: Progress = silent
    ) -> DensityCurves:
        """Tabulate the mean flux of every element, cm⁻² sr⁻¹ day⁻¹.

        Parameters
        ----------
        rays
            The elements' sub-rays.
        physics, altitude_m
            As in `attenuate`; the density of the physics is not used.
        progress
            Told the share done.

        Raises
        ------
        Cancelled
            If `progress` asks for a stop.
        """
        count = int(np.ceil(np.log(_HIGHEST_G_CM3 / _LOWEST_G_CM3) / _LN_STEP)) + 1
        ln_density = np.log(_LOWEST_G_CM3) + _LN_STEP * np.arange(count)
        rock = rays.behind_rock()
        distinct, row = np.unique(rays.elevation_deg, return_inverse=True)
        bare = attenuate(np.zeros(len(distinct)), distinct, physics, altitude_m).open_sky[row]
        sky = rays.total(np.where(rays.thickness_m == 0, bare, 0.0))
        flux_at = _fluxes(rock, ln_density[0], count, physics, altitude_m)
        values = np.empty((rays.size, count))
        for number in range(count):
            report(progress, number / count)
            values[:, number] = sky + rock.total(flux_at(number))
        lost = np.isnan(rays.mean_thickness_m).ravel()
        values[lost], sky[lost] = np.nan, np.nan
        return cls(ln_density, values, rays.mean(bare).ravel(), sky)

    def summed(self, group: np.ndarray, weight: np.ndarray, count: int) -> DensityCurves:
        """Return the curves of sums over groups.

        Parameters
        ----------
        group
            (n,) number of the group, −1 for none.
        weight
            (n,) factor of each before the sum.
        count
            Number of groups.
        """
        chosen = group >= 0
        order = np.argsort(group[chosen], kind="stable")
        label, factor = group[chosen][order], weight[chosen][order]

        def total(values: np.ndarray) -> np.ndarray:
            return np.bincount(label, factor * values[chosen][order], count)

        return DensityCurves(
            self.ln_density,
            np.stack([total(one) for one in self.values.T], axis=1),
            total(self.open_sky),
            total(self.sky),
        )

    def at(self, density_g_cm3: np.ndarray) -> np.ndarray:
        """Return the sums at a density for each, (n,)."""
        density = np.broadcast_to(np.asarray(density_g_cm3, dtype=float), self.open_sky.shape)
        lowest = np.exp(self.ln_density[0])
        with np.errstate(divide="ignore"):
            place = (np.log(density) - self.ln_density[0]) / _LN_STEP
        last = len(self.ln_density) - 1
        place = np.clip(np.nan_to_num(place), 0.0, last)
        k = np.minimum(place.astype(int), last - 1)
        row = np.arange(len(density))
        logarithm, slope = self._logarithms
        inside = np.exp(
            hermite(
                place - k, np.asarray(_LN_STEP), logarithm[row, k], logarithm[row, k + 1],
                slope[row, k], slope[row, k + 1],
            )
        )  # fmt: skip
        # Little rock, or light, dims in proportion.
        share = np.clip(density / lowest, 0.0, 1.0)
        thin = self.open_sky + share * (self.values[:, 0] - self.open_sky)
        return np.where(np.isnan(density), np.nan, np.where(density < lowest, thin, inside))

    @cached_property
    def _logarithms(self) -> tuple[np.ndarray, np.ndarray]:
        """Logarithms of the sums and their slopes."""
        logarithm = np.log(np.maximum(self.values, _TINY))
        return logarithm, _slopes(logarithm)

    @property
    def highest_g_cm3(self) -> float:
        """The densest that is tabulated."""
        return float(np.exp(self.ln_density[-1]))


def _slopes(values: np.ndarray) -> np.ndarray:
    """Return the slopes along the last axis by differences of fourth order."""
    slope = np.gradient(values, _LN_STEP, axis=-1, edge_order=2)
    wide = (values[..., 4:] - values[..., :-4]) / (4 * _LN_STEP)
    slope[..., 2:-2] = (4 * slope[..., 2:-2] - wide) / 3
    return np.asarray(slope)


def _fluxes(
    rock: SubRays, ln_lowest: float, count: int, physics: Physics, altitude_m: float
) -> Callable[[int], np.ndarray]:
    """Return what gives the flux of every ray at the densities of the curves, by their number.

    Opacities are tabulated in steps as wide as those of the densities, so that every density
    looks at the same place between two opacities. Beyond the end of the range law nothing
    comes through; what is thinner than 1 g/cm² dims no more than that.
    """
    known = np.where(rock.thickness_m > 0, rock.thickness_m, np.nan)
    ln_opacity = np.log(known * G_CM2_PER_M_WATER_EQUIVALENT) + ln_lowest
    place = np.nan_to_num(ln_opacity / _LN_STEP)
    base = np.floor(place).astype(np.int64)
    share = place - base
    last = max(int(base.max(initial=0)) + count, 1) + 1
    distinct, row = np.unique(rock.elevation_deg, return_inverse=True)
    opacity = np.exp(_LN_STEP * np.arange(last + 1))
    flux = np.empty((len(distinct), len(opacity)))
    for first in range(0, len(distinct), _ROWS):
        part = slice(first, first + _ROWS)
        flux[part] = attenuate(opacity, distinct[part, None], physics, altitude_m).flux
    logarithm = np.log(np.maximum(np.nan_to_num(flux), _TINY))
    slope = _slopes(logarithm)
    # Weights of the values and slopes at both ends of an interval (cubic Hermite).
    rest = 1.0 - share
    weights = (
        rest**2 * (1.0 + 2.0 * share),
        share**2 * (1.0 + 2.0 * rest),
        _LN_STEP * share * rest**2,
        -_LN_STEP * share**2 * rest,
    )
    start = row.reshape(base.shape) * len(opacity)
    flat, bent = logarithm.ravel(), slope.ravel()

    def flux_at(number: int) -> np.ndarray:
        here = start + np.clip(base + number, 0, last - 1)
        return np.asarray(
            np.exp(
                weights[0] * flat[here]
                + weights[1] * flat[here + 1]
                + weights[2] * bent[here]
                + weights[3] * bent[here + 1]
            )
        )

    return flux_at
