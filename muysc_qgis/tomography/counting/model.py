"""Counts along trajectories of finite width, as a function of the densities of voxels."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...errors import MuyscError
from ...progress import Progress, report, silent
from ..lattice import Lattice
from ..libraries import scipy_part
from ..operators import Projector

#: g/cm² of one metre of rock of 1 g/cm³.
_PER_METRE = 100.0

#: Opacity (g/cm²) at which half of a deviation of the flux's fall with opacity has come in:
#: the range of muons of about 10 GeV.
HALF_WAY = 5000.0

#: From (n,) opacities (g/cm²) to (n,) flux (cm⁻² sr⁻¹ day⁻¹) and its derivative over opacity.
Flux = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]


@dataclass(frozen=True)
class CountModel:
    """μ = 𝓔 Σ_k w_k I(ϱ_k, θ_k, h): what is expected along each trajectory.

    A trajectory is as wide as its response, and sub-rays run through it. Some of them run through
    voxels of unknown density, all of them possibly through rock outside, which has the mean
    density.

    Parameters
    ----------
    paths
        (n_rays, n_unknowns) lengths in voxels, m, of the sub-rays that meet any.
    ray
        (n_rays,) which sub-ray each of them is.
    outside_m
        (n_sub,) length of each sub-ray in rock outside the voxels, m, 0 or more.
    weights
        (n_data, n_sub) CSR: share of each sub-ray in the response of a trajectory; rows add up
        to 1.
    exposure
        (n_data,) 𝓔, acceptance times days times efficiency, cm² sr days.
    counts
        (n_data,) counts, 0 among them.
    station
        (n_data,) number of each trajectory's station.
    flux
        I and dI/dϱ of the sub-rays, behind their opacities.
    lattice
        Where the unknowns are.
    turned, tilted
        Derivatives of the weights over azimuth and elevation of the station's boresight, per
        degree; None where they are not known.
    length_error_m
        Error of each length in rock that other trajectories do not share, m; 0 for none.
    terrain, ground
        (n_sub, n_nodes) CSR of ∂L/∂z, metres of rock for a metre that the terrain is higher at
        each node of a lattice; None where the terrain is known.

    Raises
    ------
    MuyscError
        If the shapes do not fit, or a count or an exposure cannot be used.
    """

    paths: Projector
    ray: np.ndarray
    outside_m: np.ndarray
    weights: Any
    exposure: np.ndarray
    counts: np.ndarray
    station: np.ndarray
    flux: Flux
    lattice: Lattice
    turned: Any = None
    tilted: Any = None
    length_error_m: float = 0.0
    terrain: Any = None
    ground: Lattice | None = None

    def __post_init__(self) -> None:
        n_data, n_sub = self.weights.shape
        per_datum = {len(self.exposure), len(self.counts), len(self.station)}
        if per_datum != {n_data} or len(self.outside_m) != n_sub:
            raise MuyscError(
                f"There are {len(self.counts)} counts, {len(self.exposure)} exposures and "
                f"{len(self.station)} stations for {n_data} trajectories; give one of each for "
                "each trajectory."
            )
        if self.paths.shape != (len(self.ray), self.lattice.count):
            raise MuyscError(
                f"The paths are those of {self.paths.shape[0]} rays in {self.paths.shape[1]} "
                f"voxels, where {len(self.ray)} and {self.lattice.count} are told; make both of "
                "one volume."
            )
        if not np.all(np.isfinite(self.counts) & (self.counts >= 0)):
            raise MuyscError("A count is negative or not finite; leave out what is not known.")
        if not np.all(np.isfinite(self.exposure) & (self.exposure > 0)):
            raise MuyscError(
                "An exposure is not above 0; give acceptance, days and efficiency above 0, and "
                "leave out trajectories that collect nothing."
            )

    @property
    def size(self) -> int:
        """Number of data."""
        return len(self.counts)

    @property
    def stations(self) -> int:
        """Number of stations."""
        return int(self.station.max(initial=-1)) + 1

    def opacity(self, densities: np.ndarray, mean: float) -> np.ndarray:
        """Return the opacity of each sub-ray, (n_sub,), g/cm².

        Parameters
        ----------
        densities
            (n_unknowns,) densities of the voxels, g/cm³.
        mean
            Density of the rock outside, g/cm³.
        """
        along = mean * self.outside_m
        along[self.ray] += self.paths.forward(densities)
        return _PER_METRE * np.maximum(along, 0.0)

    def at(self, densities: np.ndarray, mean: float, progress: Progress = silent) -> Linearisation:
        """Return what is expected of densities, and how it changes with them.

        Parameters
        ----------
        densities, mean
            As in `opacity`.
        progress
            Told the share done.

        Raises
        ------
        Cancelled
            If the receiver of the progress asks for a stop.
        """
        sparse = scipy_part("sparse")
        opacity = self.opacity(densities, mean)
        flux, slope = self.flux(opacity)
        slope = _PER_METRE * slope
        # By metre and g/cm³, so that a column is ∂ ln μ over a density.
        expected = self.weights @ flux
        scale = 1.0 / np.maximum(expected, np.finfo(float).tiny)
        falling = sparse.diags(scale) @ self.weights @ sparse.diags(slope)
        parts = []
        chosen = falling.tocsc()[:, self.ray].tocsc()
        for first, block in self.paths.blocks():
            report(progress, first / max(len(self.ray), 1))
            parts.append(chosen[:, first : first + block.shape[0]] @ block)
        voxels = (
            sum(parts[1:], parts[0])
            if parts
            else sparse.csr_matrix((self.size, self.lattice.count))
        )
        report(progress, 1.0)
        return Linearisation(
            self.exposure * expected,
            voxels.tocsr(),
            np.asarray(falling @ self.outside_m),
            scale * (self.weights @ (flux * opacity / (opacity + HALF_WAY))),
            None if self.turned is None else scale * (self.turned @ flux),
            None if self.tilted is None else scale * (self.tilted @ flux),
            mean * self.length_error_m * np.abs(np.asarray(falling.sum(axis=1)).ravel()),
            None if self.terrain is None else (mean * (falling @ self.terrain)).tocsr(),
        )  # fmt: skip

    def expected(self, densities: np.ndarray, mean: float) -> np.ndarray:
        """Return μ of densities, (n_data,)."""
        return self.exposure * (self.weights @ self.flux(self.opacity(densities, mean))[0])


@dataclass(frozen=True)
class Linearisation:
    """Expected counts at some densities, and ∂ ln μ over everything that may be otherwise."""

    #: (n_data,) μ, before factors of stations and flux.
    expected: np.ndarray
    #: (n_data, n_unknowns) CSR: over the densities of voxels, per g/cm³.
    voxels: Any
    #: (n_data,) over the density of the rock outside, per g/cm³.
    outside: np.ndarray
    #: (n_data,) over a deviation of the flux that grows with opacity, of 0 in the sky and up to 1.
    steeper: np.ndarray
    #: (n_data,) over azimuth and elevation of the boresight, per degree.
    turned: np.ndarray | None
    tilted: np.ndarray | None
    #: (n_data,) relative error from lengths in rock.
    length_error: np.ndarray
    #: (n_data, n_nodes) CSR: over the height of the terrain, per m; None where that is known.
    terrain: Any
