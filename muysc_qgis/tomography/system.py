"""The linear system of a reconstruction: paths times densities give the data."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..errors import MuyscError
from .lattice import Lattice
from .operators import Projector


@dataclass(frozen=True)
class System:
    """A x = b with x the densities of the unknown voxels.

    Parameters
    ----------
    paths
        The projector A, lengths in m.
    data
        (n_rays,) b, in the unit of x times metres: density times length, which is the opacity in
        g/cm² over 100. NaN where unknown.
    lattice
        Where the unknowns are.
    view
        (n_rays,) detector of each ray.
    errors
        (n_rays,) standard errors of the data, or `None` if they are not known.

    Raises
    ------
    MuyscError
        If the shapes do not fit.
    """

    paths: Projector
    data: np.ndarray
    lattice: Lattice
    view: np.ndarray
    errors: np.ndarray | None = None

    def __post_init__(self) -> None:
        n_rays, n_unknowns = self.paths.shape
        errors = self.data if self.errors is None else self.errors
        if not n_rays == len(self.data) == len(self.view) == len(errors):
            raise MuyscError(
                f"There are {len(self.data)} data, {len(errors)} errors and {len(self.view)} views "
                f"for {n_rays} rays; give one of each for each ray."
            )
        if n_unknowns != self.lattice.count:
            raise MuyscError(
                f"The paths have {n_unknowns} unknowns and the lattice {self.lattice.count}; make "
                "both with the same active voxels."
            )

    def usable(self) -> System:
        """Return the system without rays of unknown data or without a path.

        Raises
        ------
        MuyscError
            If no ray is left.
        """
        known = np.isfinite(self.data) & (self.paths.forward(np.ones(self.paths.shape[1])) > 0)
        if self.errors is not None:
            known &= np.isfinite(self.errors) & (self.errors > 0)
        if known.all():
            return self
        if not known.any():
            raise MuyscError(
                f"None of the {len(self.data)} rays crosses rock of the volume with known data; "
                "choose an extent that the muograms look through."
            )
        which = np.flatnonzero(known)
        return replace(
            self,
            paths=self.paths.take(which),
            data=self.data[which],
            view=self.view[which],
            errors=None if self.errors is None else self.errors[which],
        )

    def weights(self) -> np.ndarray:
        """Return the (n_rays,) inverse variances over their mean; 1 where errors are unknown."""
        if self.errors is None:
            return np.ones(len(self.data))
        weights = 1.0 / np.asarray(self.errors, float) ** 2
        return weights / weights.mean()

    def homogeneous(self) -> float:
        """Return the one density that fits the data best, by weighted least squares."""
        length = self.paths.forward(np.ones(self.paths.shape[1])).astype(float)
        weights = self.weights()
        return float(np.sum(weights * length * self.data) / np.sum(weights * length**2))
