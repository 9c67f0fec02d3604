"""What part of the sky a telescope sees, and how finely it is to be looked at."""

from __future__ import annotations

import numpy as np

from ..errors import MuyscError
from .directions import Pointing
from .geometry import TelescopeGeometry

#: Lowest elevation of a ray in degrees. No flux model has an answer at or below the
#: horizon, and so little above it the flux is still known.
LOWEST_DEG = 1e-6

#: Most rays along a side for each step between two trajectories.
MAXIMUM_RAYS = 50


def corner_tangents(geometry: TelescopeGeometry) -> tuple[np.ndarray, np.ndarray]:
    """Return the tangents of the corners between trajectories and at the rim.

    Returns
    -------
    tuple
        (2 N_x + 1,) to the right, increasing, and (2 N_y + 1,) upwards, decreasing. All
        but the outermost are the middles of trajectories.
    """
    x = geometry.step * np.arange(-geometry.bars_x, geometry.bars_x + 1)
    y = geometry.step * np.arange(geometry.bars_y, -geometry.bars_y - 1, -1)
    return x, y


def reaches_horizon(geometry: TelescopeGeometry, pointing: Pointing) -> np.ndarray:
    """Return which trajectories look, in part, at or below the horizon.

    Returns
    -------
    numpy.ndarray
        (2 N_y − 1, 2 N_x − 1) of bool.
    """
    _, height = pointing.sky(*np.meshgrid(*corner_tangents(geometry)))
    below = height < LOWEST_DEG
    # A response reaches as far as the middles of the neighbours.
    across = below[:, :-2] | below[:, 1:-1] | below[:, 2:]
    return np.asarray(across[:-2] | across[1:-1] | across[2:])


def check_rays(rays_per_bar: float) -> None:
    """Refuse a number of rays that is too small to see anything or too large to trace.

    Raises
    ------
    MuyscError
        If it is no number from 1 to 50.
    """
    if not 1 <= rays_per_bar <= MAXIMUM_RAYS:
        raise MuyscError(
            f"{rays_per_bar:g} rays a bar are impossible; give a number from 1 to {MAXIMUM_RAYS}."
        )


def sees_zenith(geometry: TelescopeGeometry, pointing: Pointing) -> bool:
    """Return whether the zenith is in the field of view."""
    x, y = pointing.plane(np.zeros(()), np.asarray(90.0))
    step = geometry.step
    return bool(abs(x) <= geometry.bars_x * step and abs(y) <= geometry.bars_y * step)
