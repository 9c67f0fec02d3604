"""The sub-rays of a measured muogram's pixels, traced through a DEM from where it was measured."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..forward.responses import PixelResponses, Responses, TelescopeResponses
from ..forward.sub_rays import SubRays
from ..muogram import Muogram
from ..progress import Progress, part, silent
from ..telescope.acceptance import Trajectories, trajectories
from ..telescope.geometry import TelescopeGeometry
from ..telescope.merging import merge_sum, merged_bins
from ..topography.dem import Dem
from ..topography.frame import from_wgs84, ground_height, local_frame
from ..trajectories import TrajectoryMap
from ..views import View
from .forward_model import converged, first_rays, trace_sub_rays

#: Rays for each pixel of a muogram that is as wide as a bar of a telescope, degrees; smaller
#: pixels need fewer.
_RAYS, _FEWEST, _WIDE_DEG = 3.0, 1.0, 0.5

#: Height of a detector over the ground of the DEM (m) from which it is worth a warning, and
#: below the ground.
_HIGH_M, _DEEP_M = 30.0, 5.0

#: Tangents that differ by less than this share of their spacing are the same.
_SAME = 1e-3


@dataclass(frozen=True)
class Ground:
    """A DEM, and where on it was measured.

    Parameters
    ----------
    dem
        Terrain.
    detector
        (x, y) in the DEM's CRS; None for what the muogram says (DETECTOR_LON, DETECTOR_LAT).
    height_m
        Of the detector above ground; None for what the muogram says.
    """

    dem: Dem
    detector: tuple[float, float] | None = None
    height_m: float | None = None


@dataclass(frozen=True)
class SeenThrough:
    """What a muogram's pixels see of the terrain."""

    rays: SubRays
    #: Height of the detector in the DEM's heights, m.
    eye_m: float
    #: Longitude and latitude on WGS 84, degrees.
    detector_wgs84: tuple[float, float]
    warnings: tuple[str, ...]


def see_through(
    view: View,
    ground: Ground,
    eye_m: float | None,
    excess: Callable[[SubRays, float], np.ndarray],
    progress: Progress = silent,
) -> SeenThrough:
    """Trace the sub-rays of the pixels of a measured muogram.

    Parameters
    ----------
    view
        The measurement. Its metadata say NEAR_FIELD and MAX_RANGE where there are such.
    ground
        The terrain.
    eye_m
        Height of the detector in the DEM's heights; None for the height above ground that is
        given or that the muogram says (DETECTOR_HEIGHT), else its DETECTOR_ELEVATION, else on
        the ground.
    excess
        Returns the error of a quadrature in errors of the measurement, given the sub-rays and the
        height of the detector.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If the detector is not known or off the DEM, or the pixels' directions are not known.
    Cancelled
        If `progress` asks for a stop.
    """
    dem = ground.dem
    if ground.detector is not None:
        detector = ground.detector
    elif {"DETECTOR_LON", "DETECTOR_LAT"} <= set(view.metadata):
        place = view.number("DETECTOR_LON"), view.number("DETECTOR_LAT")
        detector = from_wgs84(dem.crs, *place, dem.transformation)
    else:
        raise MuyscError(
            "Where the muons were counted is neither given nor in the muogram's metadata (keys "
            "DETECTOR_LON and DETECTOR_LAT); give DETECTOR, a point on the DEM."
        )
    frame = local_frame(dem, *detector, "detector")
    foot = ground_height(dem, *detector, "detector")
    eye = _eye(view, ground, foot) if eye_m is None else eye_m
    limits = [
        view.number(key) if key in view.metadata else None for key in ("MAX_RANGE", "NEAR_FIELD")
    ]

    def trace(rays_per_pixel: float, progress: Progress) -> SubRays:
        responses, together = responses_of(view)
        rays = trace_sub_rays(
            frame, eye, responses, rays_per_pixel, limits[0], limits[1] or 0.0, progress
        )
        return rays if together is None else rays.taken_together(*together)

    step = responses_of(view)[0].window.step_deg[0]
    first = first_rays(_RAYS, step)
    if isinstance(view, Muogram):
        first = max(_FEWEST, min(first, _RAYS * step / _WIDE_DEG))
    rays = converged(trace, lambda one: excess(one, eye), first, part(progress, 0.0, 1.0))
    return SeenThrough(rays, eye, frame.wgs84(), tuple(_warnings(dem, eye - foot)))


def _eye(view: View, ground: Ground, foot: float) -> float:
    if ground.height_m is not None:
        return foot + ground.height_m
    if "DETECTOR_HEIGHT" in view.metadata:
        return foot + view.number("DETECTOR_HEIGHT")
    if "DETECTOR_ELEVATION" in view.metadata:
        return view.number("DETECTOR_ELEVATION")
    return foot


def _warnings(dem: Dem, above_m: float) -> list[str]:
    warnings = [*dem.assumptions]
    if not -_DEEP_M <= above_m <= _HIGH_M:
        warnings.append(
            f"The detector is {abs(above_m):.0f} m {'above' if above_m > 0 else 'below'} the "
            f"ground of {dem.name}; check its place and elevation, or give DETECTOR_HEIGHT."
        )
    return warnings


def responses_of(
    view: View,
) -> tuple[Responses, tuple[tuple[int, int], np.ndarray, np.ndarray] | None]:
    """Return how the pixels of a muogram see the sky, and how trajectories go together to them.

    Raises
    ------
    MuyscError
        If it has no direction, or its axes are not those of its telescope.
    """
    if isinstance(view, Muogram):
        return PixelResponses(view.azimuth_deg, view.elevation_deg, _pixel_size(view)), None
    geometry, merge = telescope_of(view)
    responses = TelescopeResponses(geometry, view.pointing)
    if merge == 1:
        return responses, None
    formula = str(view.metadata.get("FORMULA", "exact"))
    acceptance = trajectories(geometry, formula).acceptance_cm2_sr.ravel()
    return responses, (*merged_bins(geometry, merge), acceptance)


def telescope_of(view: TrajectoryMap) -> tuple[TelescopeGeometry, int]:
    """Return the telescope of a raster in telescope angles, and how many trajectories it merges.

    From its metadata, or from its axes where these say nothing.

    Raises
    ------
    MuyscError
        If the two do not go together.
    """
    if describes_telescope(view):
        geometry = TelescopeGeometry(
            int(view.number("BARS_X")), int(view.number("BARS_Y")),
            view.number("PIXEL_SIZE"), view.number("SEPARATION"),
        )  # fmt: skip
        merge = int(view.number("MERGE")) if "MERGE" in view.metadata else 1
    else:
        rows, columns = view.values.shape
        step = view.pixel_size[0]
        geometry = TelescopeGeometry((columns + 1) // 2, (rows + 1) // 2, 100.0 * step, 100.0)
        merge = 1
    (rows, columns), _ = merged_bins(geometry, merge)
    step = merge * geometry.step
    x = step * (np.arange(columns) - (columns - 1) / 2)
    y = -step * (np.arange(rows) - (rows - 1) / 2)
    if (rows, columns) != view.values.shape or not (
        np.allclose(view.x, x, atol=_SAME * step) and np.allclose(view.y, y, atol=_SAME * step)
    ):
        raise MuyscError(
            f"The raster in telescope angles has {view.values.shape[1]} × {view.values.shape[0]} "
            f"pixels that are not all trajectories of a telescope of {geometry.bars_x} × "
            f"{geometry.bars_y} bars; give a raster as Expected counts in a telescope writes it, "
            "or leave the DEM out."
        )
    return geometry, merge


def describes_telescope(view: View) -> bool:
    """Return whether a raster says which telescope it is of."""
    return {"BARS_X", "BARS_Y", "PIXEL_SIZE", "SEPARATION"} <= set(view.metadata)


def acceptance_of(view: View) -> np.ndarray | None:
    """Return the acceptance of each pixel of a telescope, cm² sr, its efficiency included.

    None for muograms and for rasters that do not say which telescope they are of.

    Raises
    ------
    MuyscError
        If the raster is not of that telescope.
    """
    if not isinstance(view, TrajectoryMap) or not describes_telescope(view):
        return None
    geometry, merge = telescope_of(view)
    collected: Trajectories = trajectories(geometry, str(view.metadata.get("FORMULA", "exact")))
    efficiency = view.number("EFFICIENCY") if "EFFICIENCY" in view.metadata else 1.0
    return np.asarray(merge_sum(collected.acceptance_cm2_sr, merge) * efficiency)


def _pixel_size(view: Muogram) -> tuple[float, float]:
    """Return width and height of a pixel in degrees; a lonely row is as high as it is wide."""
    sizes = [
        abs(float(axis[-1] - axis[0])) / (len(axis) - 1) if len(axis) > 1 else 0.0
        for axis in (view.azimuth_deg, view.elevation_deg)
    ]
    width, height = sizes[0] or sizes[1] or 1.0, sizes[1] or sizes[0] or 1.0
    return width, height
