"""Which voxels a tomography gets: what the user asks for, and what the rays suggest."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..tomography.voxels import VoxelGrid
from ..topography.dem import Dem
from ..topography.frame import transformed
from ..topography.sampling import heights_at
from .station_data import RockSeen, StationData
from .volume_frame import VolumeFrame

#: Voxels along the longest side unless asked for otherwise.
VOXELS = 50

#: Share of the rock on the rays that a default volume may leave out at either end.
_LEFT_OUT = 0.05

#: And below, where the lowest rays are few.
_LEFT_OUT_BELOW = 0.02

#: Where along its rock each ray is sampled.
_ALONG = np.linspace(0.0, 1.0, 9)

#: Voxel sizes are these times a power of ten.
_STEPS = (1.0, 1.2, 1.5, 1.8, 2.0, 2.2, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0)

#: Points along a side at which the highest ground is looked for, and the DEM's edge.
_PROBES, _ALONG_SIDE = 200, 33


@dataclass(frozen=True)
class VolumePlan:
    """What is asked of the volume; `None` is settled by the rays.

    Raises
    ------
    MuyscError
        If the numbers contradict each other.
    """

    #: Least x, largest x, least y, largest y in the CRS of the frame.
    extent: tuple[float, float, float, float] | None = None
    #: Edge of a voxel, m.
    voxel_size_m: float | None = None
    #: Voxels along the longest side, where no size is given.
    voxels: int | None = None
    base_m: float | None = None
    top_m: float | None = None

    def __post_init__(self) -> None:
        if self.voxel_size_m is not None and not 0 < self.voxel_size_m < np.inf:
            raise MuyscError(
                f"A voxel size of {self.voxel_size_m:g} m cannot be used; give one above 0 m."
            )
        if self.voxels is not None and self.voxels < 1:
            raise MuyscError(
                f"{self.voxels} voxels along the longest side are too few; give 1 or more."
            )
        if self.base_m is not None and self.top_m is not None and self.base_m >= self.top_m:
            raise MuyscError(
                f"The base of the volume at {self.base_m:g} m is not below its top at "
                f"{self.top_m:g} m; give a top above the base."
            )


def volume_grid(
    plan: VolumePlan,
    frame: VolumeFrame,
    stations: Sequence[StationData],
    rock: Sequence[RockSeen],
    dem: Dem,
) -> VoxelGrid:
    """Return the voxels, in the CRS of the frame.

    Without an extent, the rectangle that holds nine tenths of the rock on the rays in each
    direction, trimmed to the DEM; without a base, from where all but the lowest fiftieth of that
    rock is above it; without a top, to the highest ground.

    Parameters
    ----------
    plan
        What is asked for.
    frame
        A frame near the volume.
    stations, rock
        Detectors, and where their rays are in rock (`rock_seen`).
    dem
        Terrain, beyond which the volume must not reach.

    Raises
    ------
    MuyscError
        If no ray sees rock, or nothing is left of the volume.
    """
    x, y, up = _rock_points(frame, stations, rock)
    extent = plan.extent or _suggested(x, y, frame, dem)
    inside = (x >= extent[0]) & (x <= extent[1]) & (y >= extent[2]) & (y <= extent[3])
    if not inside.any() and (plan.base_m is None or plan.top_m is None):
        raise MuyscError(
            f"No ray meets rock between x {extent[0]:.7g} and {extent[1]:.7g}, y {extent[2]:.7g} "
            f"and {extent[3]:.7g} ({frame.crs.name}); choose an extent that the muograms look "
            "through."
        )
    top = _highest(extent, frame, dem) if plan.top_m is None else plan.top_m
    base = plan.base_m
    if base is None:
        below = up[inside & (up < top)]
        if not below.size:
            raise MuyscError(
                f"No ray meets rock below the top of the volume at {top:g} m; give a higher top."
            )
        base = float(np.quantile(below, _LEFT_OUT_BELOW))
    if not base < top:
        raise MuyscError(
            f"The base of the volume at {base:g} m is not below its top at {top:g} m, the highest "
            "ground or what was given; give a lower base or a higher top."
        )
    low = np.array([extent[0], extent[2], base])
    high = np.array([extent[1], extent[3], top])
    size = plan.voxel_size_m or _rounded(float(np.max(high - low)) / (plan.voxels or VOXELS))
    # What was not asked for lies on whole multiples of the voxel, so that runs match.
    for axis, asked in enumerate((plan.extent, plan.extent, plan.base_m)):
        if asked is None:
            low[axis] = size * (math.ceil if axis < 2 else math.floor)(low[axis] / size)
            if axis < 2:
                high[axis] = max(size * math.floor(high[axis] / size), low[axis] + size)
    grid = VoxelGrid.covering(low.tolist(), high.tolist(), size)
    (west, south, _), (east, north, _) = grid.origin_m, grid.end_m
    if not all(_on_dem((west, east, south, north), frame, dem)):
        raise MuyscError(
            f"The volume, x {west:.7g} to {east:.7g} and y {south:.7g} to {north:.7g} "
            f"({frame.crs.name}), reaches beyond the elevation model {dem.name}; choose a smaller "
            "extent or a larger elevation model."
        )
    return grid


def _rock_points(
    frame: VolumeFrame, stations: Sequence[StationData], rock: Sequence[RockSeen]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return positions in the CRS and heights of points along the rock of all rays."""
    found = []
    for station, seen in zip(stations, rock):
        meets = np.flatnonzero((seen.thickness_m > 0) & np.isfinite(seen.exit_m))
        slant = seen.distance_m[meets, None] + _ALONG * (seen.exit_m - seen.distance_m)[meets, None]
        elevation = np.radians(station.elevation_deg[meets])[:, None]
        level = slant * np.cos(elevation)
        origin, direction = frame.lines(
            (*frame.place(station.longitude, station.latitude), station.elevation_m),
            station.azimuth_deg[meets], station.elevation_deg[meets],
        )  # fmt: skip
        heading = direction[:, :2] / np.linalg.norm(direction[:, :2], axis=1, keepdims=True)
        east = origin[:, :1] + level * heading[:, :1]
        north = origin[:, 1:2] + level * heading[:, 1:]
        up = station.elevation_m + slant * np.sin(elevation) + level**2 / (2 * frame.radius_m)
        found.append(np.stack([east, north, up]).reshape(3, -1))
    east, north, up = np.concatenate(found, axis=1)
    if not up.size:
        raise MuyscError(
            f"No ray of the {len(stations)} muograms meets rock of known thickness in the "
            "elevation model; check that muograms and elevation model are of one place."
        )
    return frame.middle[0] + frame.scale * east, frame.middle[1] + frame.scale * north, up


def _suggested(
    x: np.ndarray, y: np.ndarray, frame: VolumeFrame, dem: Dem
) -> tuple[float, float, float, float]:
    """Return the rectangle that holds most of the rock on the rays, on the DEM."""
    bounds = [np.quantile(axis, [_LEFT_OUT, 1 - _LEFT_OUT]) for axis in (x, y)]
    (west, east), (south, north) = bounds
    # Shrunk towards its middle as long as a side reaches beyond the DEM.
    middle = np.median(x), np.median(y)
    for _ in range(_PROBES):
        known = _on_dem((west, east, south, north), frame, dem)
        if all(known):
            break
        south += 0.0 if known[0] else 0.02 * (middle[1] - south)
        north -= 0.0 if known[1] else 0.02 * (north - middle[1])
        west += 0.0 if known[2] else 0.02 * (middle[0] - west)
        east -= 0.0 if known[3] else 0.02 * (east - middle[0])
    return float(west), float(east), float(south), float(north)


def _on_dem(extent: tuple[float, float, float, float], frame: VolumeFrame, dem: Dem) -> list[bool]:
    """Return whether the south, north, west and east side of an extent are on the DEM."""
    west, east, south, north = extent
    x, y = np.linspace(west, east, _ALONG_SIDE), np.linspace(south, north, _ALONG_SIDE)
    sides = ((x, 0 * x + south), (x, 0 * x + north), (0 * y + west, y), (0 * y + east, y))
    return [bool(dem.contains(*_cells(*side, frame, dem)).all()) for side in sides]


def _highest(extent: tuple[float, float, float, float], frame: VolumeFrame, dem: Dem) -> float:
    """Return the highest ground within an extent, from evenly spaced probes."""
    x = np.linspace(extent[0], extent[1], _PROBES)
    # Row by row, so that little of a fine DEM is in memory.
    ground = np.concatenate([
        heights_at(dem, *_cells(x, np.full_like(x, y), frame, dem))
        for y in np.linspace(extent[2], extent[3], _PROBES)
    ])  # fmt: skip
    if not np.isfinite(ground).any():
        raise MuyscError(
            f"The extent x {extent[0]:.7g} to {extent[1]:.7g}, y {extent[2]:.7g} to "
            f"{extent[3]:.7g} ({frame.crs.name}) is off the elevation model {dem.name}; choose one "
            "on it."
        )
    return float(np.nanmax(ground))


def _cells(
    x: np.ndarray, y: np.ndarray, frame: VolumeFrame, dem: Dem
) -> tuple[np.ndarray, np.ndarray]:
    """Return the DEM's grid positions of positions in the CRS of the frame."""
    return dem.grid_position(*transformed(frame.crs, dem.crs, x, y, by=dem.transformation))


def _rounded(size: float) -> float:
    """Return a size rounded up to a number that is easy to read."""
    unit = 10.0 ** math.floor(math.log10(size))
    return unit * next(step for step in _STEPS if step * unit >= size * (1 - 1e-9))
