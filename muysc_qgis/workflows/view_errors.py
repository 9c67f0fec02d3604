"""How near the views of a reconstruction are to those of the known model."""

from __future__ import annotations

import numpy as np

from ..tomography.figures_of_merit import ViewError, view_error
from ..volume import Volume
from .tomography_result import Tomography

#: Metres of a kilometre.
_KM = 1e3


def paper_errors(tomography: Tomography, truth: Volume) -> dict[str, ViewError]:
    """Return the paper's errors: of the top view normalised, of front and side in km.

    The views are sums along an axis. That from the top is divided by its largest value; those
    from the front and the side are lengths in rock of the reference density. Keys are those of
    `VIEW_AXES`.

    Raises
    ------
    MuyscError
        If the models do not fit each other.
    """
    grid, (known, found) = tomography.grid, both_known(tomography, truth)
    unit = tomography.reference_density * _KM
    errors = {"top": view_error(grid, found, known, "top")}
    for name in ("front", "side"):
        errors[name] = view_error(grid, found / unit, known / unit, name, normalised=False)
    return errors


def both_known(tomography: Tomography, truth: Volume) -> tuple[np.ndarray, np.ndarray]:
    """Return original and reconstruction (east, north, up), NaN where one is not known."""
    both = truth.known & tomography.density.known
    return (
        np.where(both, truth.values, np.nan), np.where(both, tomography.density.values, np.nan)
    )  # fmt: skip
