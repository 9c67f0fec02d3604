"""Rasters of how wrong the thickness is when terrain and pointing are."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..muogram import Muogram
from ..progress import Progress, silent
from ..topography.sight import Sight
from ..topography.terrain_error import TerrainErrors, thickness_error
from ..trajectories import TrajectoryMap


def error_of_rays(
    sight: Sight,
    thickness: Muogram,
    errors: TerrainErrors,
    max_range_m: float | None = None,
    near_field_m: float = 0.0,
    progress: Progress = silent,
) -> Muogram:
    """Return the standard errors of a thickness muogram, one ray a pixel.

    Parameters
    ----------
    sight, max_range_m, near_field_m
        What it was simulated with.
    thickness
        The muogram.
    errors
        How well terrain and pointing are known.
    progress
        Told the share done.
    """
    found = thickness_error(
        sight.frame,
        sight.detector_elevation_m,
        thickness.azimuth_deg,
        thickness.elevation_deg[::-1],
        errors,
        max_range_m,
        near_field_m,
        progress=progress,
    )
    return thickness.with_values("thickness_error", found.T[::-1], **_described(errors))


def error_of_trajectories(
    sight: Sight,
    thickness: TrajectoryMap,
    errors: TerrainErrors,
    max_range_m: float | None = None,
    near_field_m: float = 0.0,
    progress: Progress = silent,
) -> TrajectoryMap:
    """Return the standard errors of the thickness along trajectories.

    On the ray in the middle of each, averaged over the patches of terrain that its width holds;
    see `thickness_error` for the parameters.
    """
    azimuth, elevation = thickness.directions_deg()
    found = thickness_error(
        sight.frame,
        sight.detector_elevation_m,
        azimuth.ravel(),
        elevation.reshape(-1, 1),
        errors,
        max_range_m,
        near_field_m,
        float(np.degrees(max(thickness.pixel_size))),
        progress,
    )
    return replace(
        thickness,
        quantity="thickness_error",
        values=found.reshape(azimuth.shape),
        metadata={
            **thickness.metadata,
            **_described(errors),
        },
    )


def _described(errors: TerrainErrors) -> dict[str, float]:
    return {
        "TERRAIN_ERROR": errors.terrain_m,
        "TERRAIN_CORRELATION": errors.correlation_m,
        "POINTING_ERROR": errors.pointing_deg,
    }
