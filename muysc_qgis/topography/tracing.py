"""Rays through the terrain of a DEM: profiles and ray tracing joined."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ..progress import Progress, silent
from ..progress import part as share
from ..radiography.raytracing import Outcome, ProfilePieces, RockPaths, rock_along_rays
from .frame import LocalFrame
from .profiles import azimuth_parts, lay_paths, profile_pieces, reach_m


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
    # By azimuth, so that rays traced together need a narrow window of the DEM.
    order = np.argsort(azimuth_deg, kind="stable")
    azimuth = np.asarray(azimuth_deg, float)[order]
    elevation = np.asarray(elevation_deg, float)
    if elevation.ndim > 1:
        elevation = elevation[order]
    tangent = np.tan(np.radians(elevation))
    lowest = np.broadcast_to(tangent.min(axis=-1), azimuth.shape)
    highest = np.broadcast_to(tangent.max(axis=-1), azimuth.shape)
    reach = reach_m(frame, eye_m, float(lowest.min()))
    farthest = reach if max_range_m is None else min(reach, max_range_m)
    range_m = np.full(len(azimuth), np.inf)  # known when the paths are laid

    def blocks(tangents: tuple[np.ndarray, np.ndarray] | None) -> Iterator[ProfilePieces]:
        for part in azimuth_parts(len(azimuth), farthest):
            rays = None if tangents is None else (tangents[0][part], tangents[1][part])
            paths = lay_paths(frame, azimuth[part], near_field_m, reach, max_range_m, rays)
            range_m[part] = paths.range_m
            done = share(progress, part.start / len(azimuth), part.stop / len(azimuth))
            for pieces in profile_pieces(paths, slice(0, len(paths.end_m)), eye_m, frame, done):
                yield replace(pieces, ray=pieces.ray + part.start)

    rock = rock_along_rays(blocks((lowest, highest)), elevation, range_m)
    if np.any(rock.outcome == Outcome.NO_DATA):
        # Rays over gaps are judged by the highest ground on the profiles, and level
        # pieces are somewhat higher: once more with all the detail.
        rock = rock_along_rays(blocks(None), elevation, range_m)
    back = np.argsort(order)
    return RockPaths(
        rock.thickness_m[back], rock.distance_m[back], rock.exit_m[back], rock.outcome[back]
    )
