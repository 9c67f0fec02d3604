"""Rays through the terrain of a DEM: profiles and ray tracing joined."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..progress import Progress, report, silent
from ..radiography.raytracing import ProfilePieces, RockPaths, rock_along_rays
from .frame import LocalFrame
from .profiles import azimuth_groups, lay_paths, profile_pieces, reach_m


def trace_terrain(
    frame: LocalFrame,
    eye_m: float,
    azimuth_deg: np.ndarray,
    elevation_deg: np.ndarray,
    max_range_m: float | None = None,
    near_field_m: float = 0.0,
    progress: Progress = silent,
) -> RockPaths:
    """Measure the rock on straight rays from a detector through a DEM.

    Exact on the bilinear surface through the cell centres, with the curvature
    of the Earth and without refraction. Rays that share an azimuth share one
    terrain profile. The DEM is read in windows no larger than the rays need and
    worked on in blocks of bounded memory.

    Parameters
    ----------
    frame
        Frame of the detector.
    eye_m
        Height of the detector, in the DEM's heights.
    azimuth_deg
        (n_azimuth,) clockwise from true north.
    elevation_deg
        Above the horizontal, in (−90, 90]: (n_elevation,) increasing, the same
        for every azimuth, or (n_azimuth, 1) for one ray in each.
    max_range_m
        Largest horizontal distance looked at, None for as far as the DEM goes.
    near_field_m
        Terrain nearer than this (horizontally) is ignored.
    progress
        Told the share of azimuths done.

    Returns
    -------
    RockPaths
        (n_azimuth, n_elevation) each.

    Raises
    ------
    MuyscError
        If the DEM cannot be read.
    Cancelled
        If `progress` asks for a stop.
    """
    lowest = float(np.tan(np.radians(np.min(elevation_deg))))
    reach = reach_m(frame, eye_m, lowest)
    paths = lay_paths(frame, azimuth_deg, near_field_m, reach, max_range_m)

    def blocks() -> Iterator[ProfilePieces]:
        for group in azimuth_groups(paths):
            for pieces in profile_pieces(paths, group, eye_m, frame):
                report(progress, group.start / len(paths.end_m))
                yield pieces

    return rock_along_rays(blocks(), elevation_deg, paths.range_m)
