"""Straight rays over a terrain profile: heights, rock crossed, its length as text.

Needs numpy alone.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Ray:
    """One ray of a section.

    Parameters
    ----------
    label
        What the ray is, for the legend: “to the target”.
    elevation_deg
        Angle above the horizon.
    main
        Drawn as the one that matters.
    """

    label: str
    elevation_deg: float
    main: bool = False


def ray_height_m(
    detector_elevation_m: float, elevation_deg: float, distance_m: np.ndarray
) -> np.ndarray:
    """Return the height of a ray at horizontal distances (m)."""
    return detector_elevation_m + distance_m * np.tan(np.radians(elevation_deg))


def rock_intervals(
    distance_m: np.ndarray, ground_m: np.ndarray, detector_elevation_m: float, elevation_deg: float
) -> np.ndarray:
    """Return where a ray runs below the ground.

    The ground is the straight line between profile points, and so is the ray:
    each crossing is where their difference changes sign.

    Parameters
    ----------
    distance_m
        (n,) increasing horizontal distances.
    ground_m
        (n,) ground heights in the straight-ray frame; NaN where unknown, and
        then neither rock nor air.
    detector_elevation_m
        Height at which the ray starts.
    elevation_deg
        Angle of the ray above the horizon.

    Returns
    -------
    (k, 2) horizontal distances at which the ray enters and leaves rock (m).
    """
    cover_m = ground_m - ray_height_m(detector_elevation_m, elevation_deg, distance_m)
    intervals: list[list[float]] = []
    for first in np.flatnonzero(np.isfinite(cover_m[1:]) & np.isfinite(cover_m[:-1])):
        start, end = float(distance_m[first]), float(distance_m[first + 1])
        at_start, at_end = float(cover_m[first]), float(cover_m[first + 1])
        if at_start <= 0 and at_end <= 0:
            continue
        if at_start < 0 or at_end < 0:
            crossing = start + (end - start) * at_start / (at_start - at_end)
            start, end = (crossing, end) if at_start < 0 else (start, crossing)
        if intervals and intervals[-1][1] == start:
            intervals[-1][1] = end
        else:
            intervals.append([start, end])
    return np.reshape(intervals, (-1, 2))


def rock_label(
    distance_m: np.ndarray,
    ground_m: np.ndarray,
    detector_elevation_m: float,
    ray: Ray,
    intervals_m: np.ndarray,
) -> str:
    """Return the rock that a ray crosses as text.

    The slant length is the horizontal one over the cosine of the elevation. It
    is a lower bound where the profile ends inside rock, or where the ground is
    unknown and the ray not yet above all of it.

    Parameters
    ----------
    distance_m, ground_m, detector_elevation_m
        As for `rock_intervals`.
    ray
        The ray.
    intervals_m
        (k, 2) from `rock_intervals`.
    """
    length = np.ptp(intervals_m, axis=1).sum() / np.cos(np.radians(ray.elevation_deg))
    known = np.isfinite(ground_m)
    heights = ray_height_m(detector_elevation_m, ray.elevation_deg, distance_m)
    highest = ground_m[known].max() if known.any() else np.inf
    hidden = np.any(~known & (heights < highest))
    cut = len(intervals_m) > 0 and intervals_m[-1, 1] == distance_m[-1]
    return f"{'at least ' if cut or hidden else ''}{length:.0f} m of rock"
