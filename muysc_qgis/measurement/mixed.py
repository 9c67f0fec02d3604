"""Pixels of which a single ray says too little: at the skyline, and where the rock is steep."""

from __future__ import annotations

import numpy as np

from ..progress import Progress, silent
from .density import Densities, Flag
from .pooling import flux_and_slope
from .scene import Scene

#: Variance of the place within a pixel that sees all of itself alike, and within a trajectory,
#: whose response falls to zero at its neighbours; in squares of their spacing.
BOX_VARIANCE = 1.0 / 12.0
HAT_VARIANCE = 1.0 / 6.0

#: Relative bias of a density that is too much where its error is not known.
_TOO_MUCH = 0.05


def beside_sky(thickness_m: np.ndarray, reach: int) -> np.ndarray:
    """Return the pixels with rock that have a pixel without any within a distance.

    Parameters
    ----------
    thickness_m
        (n_elevation, n_azimuth), 0 for the sky and NaN where unknown.
    reach
        Distance in pixels, across, up and along diagonals.
    """
    near = thickness_m == 0
    for _ in range(reach):
        padded = np.pad(near, 1)
        rows, columns = near.shape
        near = np.any(
            [padded[i : i + rows, j : j + columns] for i in range(3) for j in range(3)], axis=0
        )
    return near & (thickness_m > 0)


def bias_of_one_ray(thickness_m: np.ndarray, slope: np.ndarray, variance: float) -> np.ndarray:
    """Return by how much of itself a density is too low when one ray stands for a pixel.

    The flux falls with a power s of the thickness, so its mean over the pixel is larger than
    that behind the mean thickness by the share ½ s (s + 1) Var(ln L), to second order; and a
    share of the flux is the sth part of it in the density.

    Parameters
    ----------
    thickness_m
        (n_elevation, n_azimuth), 0 for the sky and NaN where unknown.
    slope
        s of each pixel.
    variance
        Of the place within a pixel, in squares of the spacing.
    """
    logarithm = np.log(np.where(thickness_m > 0, thickness_m, np.nan))
    total = np.zeros(thickness_m.shape)
    for axis in (0, 1):
        step = np.abs(np.diff(logarithm, axis=axis))
        ends = [(1, 0), (0, 1)]
        pads = [[(0, 0), (0, 0)] for _ in ends]
        for pad, end in zip(pads, ends):
            pad[axis] = end
        sides = [np.pad(step, pad, constant_values=np.nan) for pad in pads]
        total += np.nan_to_num(np.fmax(*sides)) ** 2 * variance
    return np.asarray(0.5 * (slope + 1.0) * total)


def mixed_pixels(
    found: Densities, scene: Scene, variance: float, progress: Progress = silent
) -> np.ndarray:
    """Return the pixels whose density is off by more than its error because it is of one ray.

    Parameters
    ----------
    found, scene
        Densities of pixels of one ray each.
    variance
        As in `bias_of_one_ray`.
    progress
        Told the share done.
    """
    measured = found.flags == Flag.MEASURED
    if not measured.any():
        return np.zeros(measured.shape, dtype=bool)
    _, slope = flux_and_slope(scene, float(np.median(found.density[measured])), progress)
    bias = bias_of_one_ray(scene.thickness_m, slope, variance)
    relative = found.error / np.where(found.density > 0, found.density, np.nan)
    allowed = np.where(np.isfinite(relative), relative, _TOO_MUCH)
    return scene.rock & (bias > allowed) & (found.flags != Flag.LOWER_LIMIT)
