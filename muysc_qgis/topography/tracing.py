"""Rays through the terrain of a DEM: profiles and ray tracing joined."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, replace

import numpy as np

from ..progress import Progress, part, silent
from ..radiography.raytracing import Outcome, ProfilePieces, RockPaths, rock_along_rays
from .frame import LocalFrame
from .profiles import azimuth_runs, lay_paths, profile_pieces, reach_m


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
    reach = reach_m(frame, eye_m, lowest)
    end = float(reach.max()) if max_range_m is None else min(float(reach.max()), max_range_m)

    def trace(chosen: np.ndarray, level: bool, progress: Progress) -> RockPaths:
        """Trace the rays of some azimuths, over level ground where they meet none."""
        own = elevation if elevation.ndim == 1 else elevation[chosen]
        range_m = np.full(len(chosen), np.inf)  # known when the paths are laid

        def blocks() -> Iterator[ProfilePieces]:
            for run in azimuth_runs(len(chosen), end):
                rays = chosen[run]
                tangents = (lowest[rays], highest[rays]) if level else None
                paths = lay_paths(
                    frame, azimuth[rays], near_field_m, reach[rays], max_range_m, tangents
                )
                range_m[run] = paths.range_m
                done = part(progress, run.start / len(chosen), run.stop / len(chosen))
                for pieces in profile_pieces(paths, slice(0, len(rays)), eye_m, frame, done):
                    yield replace(pieces, ray=pieces.ray + run.start)

        return rock_along_rays(blocks(), own, range_m)

    rock = trace(np.arange(len(azimuth)), True, progress)
    names = [field.name for field in fields(RockPaths)]
    doubtful = np.flatnonzero((rock.outcome == Outcome.NO_DATA).any(axis=1))
    if doubtful.size:
        # Rays over gaps are judged by the highest ground on their way, and level
        # ground is somewhat higher than what it stands for.
        detailed = trace(doubtful, False, part(progress, 1.0, 1.0))
        for name in names:
            getattr(rock, name)[doubtful] = getattr(detailed, name)
    back = np.argsort(order)
    return RockPaths(*(getattr(rock, name)[back] for name in names))
