"""Rays that together stand for what trajectories or pixels see."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..progress import Progress, silent
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.raytracing import Outcome
from ..radiography.settings import Physics
from ..radiography.transmission import Attenuation, attenuate
from .nodes import Nodes
from .responses import Responses


@dataclass(frozen=True)
class SubRays:
    """A quadrature over the responses of elements: trajectories of a telescope, or pixels.

    The mean of anything over the response of an element is Σ_k w_k f_k over its entries;
    a ray serves every element that sees it. Entries are ordered by element.

    Parameters
    ----------
    shape
        Rows and columns of the elements, which are numbered row by row.
    azimuth_deg, elevation_deg
        (n_ray,) directions.
    thickness_m
        (n_ray,) rock along each ray, 0 for the sky and NaN where unknown.
    outcome
        (n_ray,) codes of `Outcome`.
    odd
        (n_ray,) true for every other ray: each half is a coarser quadrature of its own, and
        their difference tells the error.
    element, ray
        (n_entry,) which ray each element sees, …
    weight
        … and with which weight: 1 in sum for each element.
    below
        (n_element,) true for elements that see too much below the horizon to be known.
    """

    shape: tuple[int, int]
    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    thickness_m: np.ndarray
    outcome: np.ndarray
    odd: np.ndarray
    element: np.ndarray
    ray: np.ndarray
    weight: np.ndarray
    below: np.ndarray

    @classmethod
    def of(cls, nodes: Nodes, responses: Responses) -> SubRays:
        """Return the sub-rays of elements from nodes that cover all they see."""
        count = int(np.prod(responses.shape))
        area = nodes.width_deg * nodes.height_deg * np.cos(np.radians(nodes.elevation_deg))
        extent = np.stack([nodes.width_deg, nodes.height_deg], axis=1)
        rock = nodes.thickness_m != 0
        # How much rock and how much sky an element sees is known from all that rays stand for …
        ray, element, response = responses.entries(nodes.azimuth_deg, nodes.elevation_deg, extent)
        weight = response * area[ray]
        behind = rock[ray]
        shared = np.bincount(element[behind], weight[behind], count)
        bright = ray[~behind], element[~behind], weight[~behind]
        # … and the flux through rock in the middle of it alone.
        (stone,) = np.nonzero(rock)
        ray, element, response = responses.entries(
            nodes.azimuth_deg[stone], nodes.elevation_deg[stone], np.zeros((len(stone), 2))
        )
        weight = response * area[stone[ray]]
        total = np.bincount(element, weight, count)
        weight *= (shared / np.where(total > 0, total, 1.0))[element]
        ray, element, weight = (
            np.concatenate(one) for one in zip((stone[ray], element, weight), bright)
        )
        # Rays that nothing sees are left out.
        seen = np.zeros(len(area), dtype=bool)
        seen[ray] = True
        place = np.cumsum(seen) - 1
        order = np.argsort(element, kind="stable")
        ray, element, weight = place[ray[order]], element[order], weight[order]
        total = np.bincount(element, weight, count)
        return cls(
            responses.shape,
            nodes.azimuth_deg[seen],
            nodes.elevation_deg[seen],
            nodes.thickness_m[seen],
            nodes.outcome[seen],
            nodes.odd[seen],
            element.astype(np.int32),
            ray.astype(np.int32),
            weight / total[element],
            responses.below,
        )

    @classmethod
    def single(cls, thickness_m: np.ndarray, elevation_deg: np.ndarray) -> SubRays:
        """Return one ray for each pixel: what a thickness muogram knows of them.

        Parameters
        ----------
        thickness_m
            (n_elevation, n_azimuth), NaN where unknown.
        elevation_deg
            Degrees, of a shape that broadcasts with it.
        """
        number = np.arange(thickness_m.size, dtype=np.int32)
        elevation = np.broadcast_to(elevation_deg, thickness_m.shape).ravel()
        nothing = np.zeros(thickness_m.size, dtype=bool)
        return cls(
            (thickness_m.shape[0], thickness_m.shape[1]),
            np.full(thickness_m.size, np.nan),
            elevation,
            thickness_m.ravel(),
            np.zeros(thickness_m.size, dtype=np.uint8),
            nothing,
            number,
            number,
            np.ones(thickness_m.size),
            elevation <= 0,
        )

    def taken_together(
        self, shape: tuple[int, int], group: np.ndarray, share: np.ndarray
    ) -> SubRays:
        """Return the sub-rays of groups of elements, such as bins of trajectories.

        Parameters
        ----------
        shape
            Rows and columns of the groups.
        group
            (n_element,) number of each element's group from 0, −1 for none.
        share
            (n_element,) weight of each element, of any sum: acceptance times time, as a rule.
        """
        count = int(np.prod(shape))
        member = group >= 0
        total = np.bincount(group[member], share[member], count)
        own = np.zeros(self.size)
        own[member] = share[member] / total[group[member]]
        kept = member[self.element]
        element, ray = group[self.element[kept]].astype(np.int64), self.ray[kept]
        weight = self.weight[kept] * own[self.element[kept]]
        # A ray that several elements of a group see has one entry.
        key, place = np.unique(element * len(self.azimuth_deg) + ray, return_inverse=True)
        element, ray = np.divmod(key, max(1, len(self.azimuth_deg)))
        below = np.bincount(group[member], self._unseen[member], count) > 0
        return replace(
            self,
            shape=shape,
            element=element.astype(np.int32),
            ray=ray.astype(np.int32),
            weight=np.bincount(place, weight, len(key)),
            below=below,
        )

    def count(self, outcome: Outcome) -> int:
        """Return the number of rays with an outcome."""
        return int(np.count_nonzero(self.outcome == outcome))

    def touched(self, rays: np.ndarray) -> np.ndarray:
        """Return which elements see any of some rays, `shape` of bool.

        Parameters
        ----------
        rays
            (n_ray,) of bool.
        """
        seen = np.bincount(self.element[rays[self.ray]], minlength=self.size)
        return np.asarray(seen > 0).reshape(self.shape)

    @property
    def size(self) -> int:
        """Number of elements."""
        return int(np.prod(self.shape))

    def mean(self, values: np.ndarray) -> np.ndarray:
        """Return the mean over each element's response.

        Parameters
        ----------
        values
            (n_ray,) of anything; NaN where unknown.

        Returns
        -------
        numpy.ndarray
            `shape`; NaN where any value is, below the horizon, and where nothing is seen.
        """
        return np.where(self._unseen, np.nan, self.total(values)).reshape(self.shape)

    def mean_and_error(self, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the mean over each element's response, and the error of the quadrature.

        The error is half the difference between the means over either half of the rays: that
        of a quadrature half as fine, and so more than that of the whole as a rule.
        """
        chosen = self.odd[self.ray]
        parts = self.weight * values[self.ray]
        halves = []
        for half in (chosen, ~chosen):
            weight = np.bincount(self.element, np.where(half, self.weight, 0.0), self.size)
            total = np.bincount(self.element, np.where(half, parts, 0.0), self.size)
            halves.append(total / np.where(weight > 0, weight, np.nan))
        error = np.abs(halves[0] - halves[1]) / 2
        return self.mean(values), np.where(self._unseen, np.nan, error).reshape(self.shape)

    def total(self, values: np.ndarray) -> np.ndarray:
        """Return Σ w f over each element's entries, (n_element,); see `mean`."""
        return np.bincount(self.element, self.weight * values[self.ray], self.size)

    def behind_rock(self) -> SubRays:
        """Return the rays that cross rock, known or not; weights do not add up to 1 any more."""
        rock = self.thickness_m != 0
        kept = rock[self.ray]
        place = np.cumsum(rock) - 1
        return replace(
            self,
            azimuth_deg=self.azimuth_deg[rock],
            elevation_deg=self.elevation_deg[rock],
            thickness_m=self.thickness_m[rock],
            outcome=self.outcome[rock],
            odd=self.odd[rock],
            element=self.element[kept],
            ray=place[self.ray[kept]].astype(np.int32),
            weight=self.weight[kept],
        )

    @cached_property
    def _unseen(self) -> np.ndarray:
        return self.below | (np.bincount(self.element, minlength=self.size) == 0)

    @cached_property
    def rock_share(self) -> np.ndarray:
        """`shape`, share of each response behind rock; what is unknown counts as rock."""
        sky = self.thickness_m == 0
        share = np.clip(self.mean(np.where(sky, 0.0, 1.0)), 0.0, 1.0)
        # Exact where there is nothing else, whatever the rounding of a sum.
        share = np.where(self.touched(sky) | np.isnan(share), share, 1.0)
        return np.where(self.touched(~sky) | np.isnan(share), share, 0.0)

    @cached_property
    def mean_thickness_m(self) -> np.ndarray:
        """`shape`, mean rock over each response, the sky as 0 m; NaN where any is unknown."""
        return self.mean(self.thickness_m)

    def muons(
        self,
        density_g_cm3: float | np.ndarray,
        physics: Physics,
        altitude_m: float,
        progress: Progress = silent,
    ) -> Attenuation:
        """Return what is left of the flux along every ray.

        Parameters
        ----------
        density_g_cm3
            Of the rock, one for all or (n_ray,) along each.
        physics, altitude_m, progress
            As in `attenuate`; the density of the physics is not used.
        """
        opacity = self.thickness_m * (density_g_cm3 * G_CM2_PER_M_WATER_EQUIVALENT)
        return attenuate(opacity, self.elevation_deg, physics, altitude_m, progress)


def error_in_counting_errors(
    flux: np.ndarray, error: np.ndarray, exposure: np.ndarray
) -> np.ndarray:
    """Return errors of a mean flux as shares of the counting errors, of at least one count.

    Parameters
    ----------
    flux, error
        Mean flux and the error of its quadrature.
    exposure
        Counts for a flux of 1, that is acceptance times time.
    """
    return np.asarray(error * exposure / np.sqrt(np.maximum(flux * exposure, 1.0)))
