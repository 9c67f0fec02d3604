"""What a field of view covers on the ground."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

#: Steps (degrees) along the arc of an outline.
_ARC_STEP_DEG = 0.5


@dataclass(frozen=True)
class Outline:
    """A closed polygon in polar form around the detector."""

    azimuth_deg: np.ndarray
    distance_m: np.ndarray


def aperture_outline(azimuth_deg: np.ndarray, width_deg: float, radius_m: float) -> Outline:
    """Return the sector (or circle) that a field of view covers.

    Parameters
    ----------
    azimuth_deg
        (n,) azimuths of the pixel centres.
    width_deg
        Full width in azimuth.
    radius_m
        Radius of the sector.
    """
    middle = (azimuth_deg[0] + azimuth_deg[-1]) / 2
    count = max(2, int(np.ceil(width_deg / _ARC_STEP_DEG)) + 1)
    arc = middle + np.linspace(-width_deg / 2, width_deg / 2, count)
    if width_deg >= 360:
        return Outline(arc, np.full(count, radius_m))
    return Outline(
        np.concatenate([[middle], arc, [middle]]),
        np.concatenate([[0.0], np.full(count, radius_m), [0.0]]),
    )


def ground_seen(azimuth_deg: np.ndarray, distance_m: np.ndarray, width_deg: float) -> list[Outline]:
    """Return the bands between the nearest and the farthest rock face seen.

    One band for each run of azimuths with rock.

    Parameters
    ----------
    azimuth_deg
        (n,) azimuths of the pixel centres, evenly spaced.
    distance_m
        (n_elevation, n) horizontal distances to the first rock, NaN in the sky.
    width_deg
        Full width in azimuth, which n pixels fill.
    """
    sees = np.isfinite(distance_m).any(axis=0)
    filled = np.where(np.isfinite(distance_m), distance_m, np.nan)
    half = width_deg / len(azimuth_deg) / 2
    outlines = []
    edges = np.flatnonzero(np.diff(np.concatenate([[False], sees, [False]]).astype(int)))
    for start, end in edges.reshape(-1, 2):
        run = slice(start, end)
        nearest = np.nanmin(filled[:, run], axis=0)
        farthest = np.nanmax(filled[:, run], axis=0)
        # Each pixel is drawn to both of its sides, so that one alone has an area.
        sides = np.column_stack([azimuth_deg[run] - half, azimuth_deg[run] + half]).ravel()
        near, far = np.repeat(nearest, 2), np.repeat(farthest, 2)
        outlines.append(
            Outline(
                np.concatenate([sides, sides[::-1], sides[:1]]),
                np.concatenate([far, near[::-1], far[:1]]),
            )
        )
    return outlines
