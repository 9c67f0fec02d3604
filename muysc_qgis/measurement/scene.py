"""Where a telescope looked, and what comes through rock there."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..errors import MuyscError
from ..forward.curves import DensityCurves
from ..forward.sub_rays import SubRays
from ..progress import Progress, silent
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.energy_loss import minimum_energy
from ..radiography.envelope import typical_flux_error
from ..radiography.inversion import opacity_from_flux
from ..radiography.settings import Physics
from ..radiography.transmission import attenuate
from .observation import pixels
from .uniform import Expected, expected_of_pixels, uniform_density

#: A flux this close to that of the open sky, relative to it, is not dimmed; sums over many
#: rays are rounded.
_UNDIMMED = 1e-12
_UNDIMMED_SUM = 1e-7

#: Largest relative uncertainty of the flux model accepted.
_MAXIMUM_UNCERTAINTY = 1.0


@dataclass(frozen=True)
class Scene:
    """Where the telescope looked, and how muons are produced and stopped.

    With sub-rays a pixel sees what they see: rock of many lengths, and sky beside it. Without
    them it is one ray.

    Raises
    ------
    MuyscError
        If a thickness is negative or infinite, or the uncertainty is no share.
    """

    #: (n_elevation, n_azimuth) rock along each ray, or mean over the response of each pixel, m.
    thickness_m: np.ndarray
    #: Elevation of the rays in degrees, (n_elevation, 1) or one for each.
    elevation_deg: np.ndarray
    physics: Physics
    altitude_m: float
    #: Relative uncertainty of the flux model, the same for all pixels.
    model_uncertainty: float = 0.0
    #: What each pixel sees, None for one ray each.
    rays: SubRays | None = None
    #: (n_elevation, n_azimuth) pixels of which one ray says too little, None for none.
    mixed: np.ndarray | None = None

    def __post_init__(self) -> None:
        bad = self.thickness_m[(self.thickness_m < 0) | np.isinf(self.thickness_m)]
        if bad.size:
            raise MuyscError(
                f"The thickness is negative or infinite in {pixels(bad.size)}, such as "
                f"{bad[0]:g} m; give 0 for the sky and no-data where unknown."
            )
        check_uncertainty(self.model_uncertainty)

    @cached_property
    def curves(self) -> DensityCurves | None:
        """Mean flux of every pixel as a function of the density, None for one ray each."""
        if self.rays is None:
            return None
        return DensityCurves.of(self.rays, self.physics, self.altitude_m)

    @cached_property
    def flux_error(self) -> float:
        """The flux model's own relative error at the energies that the rock demands.

        The median over pixels at the material's own density, near enough for an error; 0
        where there is none to know.
        """
        opacity = self.thickness_m * (self.physics.density * G_CM2_PER_M_WATER_EQUIVALENT)
        energy = minimum_energy(opacity, self.physics)
        error = typical_flux_error(
            energy, opacity, self.elevation_deg, self.physics, self.altitude_m
        )
        return error if np.isfinite(error) else 0.0

    @cached_property
    def too_thin(self) -> np.ndarray:
        """Where the material at its own density would dim no flux, (n_elevation, n_azimuth)."""
        if self.curves is not None:
            bright = self.curves.at(np.asarray(self.physics.density)) > self.curves.open_sky * (
                1.0 - _UNDIMMED_SUM
            )
            return (self.thickness_m > 0) & bright.reshape(self.thickness_m.shape)
        opacity = self.thickness_m * self.physics.density * G_CM2_PER_M_WATER_EQUIVALENT
        muons = attenuate(opacity, self.elevation_deg, self.physics, self.altitude_m)
        return (self.thickness_m > 0) & (muons.transmission > 1.0 - _UNDIMMED)

    @cached_property
    def rock(self) -> np.ndarray:
        """Where there is rock above the horizon that dims the flux, (n_elevation, n_azimuth)."""
        rock = (self.thickness_m > 0) & (self.elevation_deg > 0) & ~self.too_thin
        return rock if self.mixed is None else rock & ~self.mixed

    def without(self, mixed: np.ndarray) -> Scene:
        """Return the same scene with more pixels of which one ray says too little."""
        other = replace(self, mixed=mixed if self.mixed is None else mixed | self.mixed)
        # Costly, and the same.
        vars(other)["too_thin"] = self.too_thin
        return other

    def flux_at(self, density_g_cm3: float, progress: Progress = silent) -> np.ndarray:
        """Return the flux of every pixel at one density; 0 beyond the end of the range law.

        Returns
        -------
        numpy.ndarray
            (n_elevation, n_azimuth), cm⁻² sr⁻¹ day⁻¹; NaN where the rock is unknown.
        """
        if self.curves is not None:
            return self.curves.at(np.asarray(density_g_cm3)).reshape(self.thickness_m.shape)
        opacity = density_g_cm3 * self.thickness_m * G_CM2_PER_M_WATER_EQUIVALENT
        flux = attenuate(opacity, self.elevation_deg, self.physics, self.altitude_m, progress).flux
        return np.where(np.isnan(opacity), np.nan, np.nan_to_num(flux))

    @property
    def sky_flux(self) -> np.ndarray:
        """(n_elevation, n_azimuth) flux that no rock is in the way of; 0 for one ray each."""
        if self.curves is None:
            return np.zeros(self.thickness_m.shape)
        return self.curves.sky.reshape(self.thickness_m.shape)

    def density_of(
        self, flux: np.ndarray, chosen: np.ndarray, progress: Progress = silent
    ) -> np.ndarray:
        """Return the density of each pixel at which it has a flux.

        Parameters
        ----------
        flux
            (n_elevation, n_azimuth), cm⁻² sr⁻¹ day⁻¹.
        chosen
            Which pixels have rock and a flux.

        Returns
        -------
        numpy.ndarray
            g/cm³, NaN elsewhere and where there is no such density.
        """
        if self.curves is None:
            opacity = opacity_from_flux(
                np.where(chosen, flux, np.nan),
                self.elevation_deg, self.physics, self.altitude_m, progress,
            )  # fmt: skip
            length = np.where(chosen, self.thickness_m, np.nan)
            return np.asarray(opacity / (length * G_CM2_PER_M_WATER_EQUIVALENT))
        density = np.full(self.thickness_m.shape, np.nan)
        one = np.where(chosen, np.cumsum(chosen).reshape(chosen.shape) - 1, -1)
        expected, highest = self.expected(one, np.ones(chosen.shape), int(chosen.sum()))
        density[chosen] = uniform_density(flux[chosen], expected, highest, progress)
        return density

    def expected(
        self, region: np.ndarray, exposure: np.ndarray, number: int
    ) -> tuple[Expected, float]:
        """Return the counts of regions as a function of their densities, and the highest of these.

        Parameters
        ----------
        region
            (n_elevation, n_azimuth) number of each pixel's region from 0, −1 for none.
        exposure
            (n_elevation, n_azimuth) counts for a flux of 1 cm⁻² sr⁻¹ day⁻¹, with any weight.
        number
            Number of regions.
        """
        if self.curves is not None:
            summed = self.curves.summed(region.ravel(), exposure.ravel(), number)
            return lambda density, _: summed.at(density), summed.highest_g_cm3
        inside = region >= 0
        elevation = np.broadcast_to(self.elevation_deg, region.shape)
        return expected_of_pixels(
            region[inside],
            exposure[inside],
            self.thickness_m[inside],
            elevation[inside],
            self.physics,
            self.altitude_m,
            number,
        ), 1e4


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
