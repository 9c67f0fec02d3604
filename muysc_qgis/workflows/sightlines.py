"""The rays of several stations through one volume, and how far each runs in its rock."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, part, silent
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..tomography.crossings import Stretches
from ..tomography.ground import holds_rock
from ..tomography.lattice import Lattice
from ..tomography.projector import Paths, paths_through
from ..tomography.rays import Rays, joined
from ..tomography.rock import rock_along
from ..tomography.voxels import VoxelGrid
from ..topography.dem import Dem
from .station_data import UNKNOWN_ROCK, RockSeen, StationData
from .volume_frame import VolumeFrame
from .volume_ground import ground_below

#: Cause of rays that say nothing about the volume.
SKY = "the ray sees no rock"
MISSES = "the ray meets no rock of the volume"


@dataclass(frozen=True)
class Sightlines:
    """Rays that meet the rock of a volume, and what the path matrix follows from.

    Pixels are those of all stations one after the other; rays are the pixels that count.
    """

    frame: VolumeFrame
    #: The volume in the CRS of the frame.
    grid: VoxelGrid
    stations: tuple[StationData, ...]
    #: Which pixel each ray is.
    pixel: np.ndarray
    #: Lengths in the unknown voxels; rays, views (the number of the station) and columns.
    paths: Paths
    #: (n_rays,) slant length in rock along the whole ray and inside the volume, m.
    thickness_m: np.ndarray
    inside_m: np.ndarray
    #: Pixels that are no rays, by cause.
    lost: Mapping[str, int]

    @property
    def lattice(self) -> Lattice:
        """Where the unknowns are."""
        grid = self.paths.grid
        if self.paths.column is None:
            return Lattice.of(grid)
        return Lattice.of(grid, (self.paths.column >= 0).reshape(grid.shape))

    @property
    def outside_m(self) -> np.ndarray:
        """(n_rays,) slant length in rock outside the volume, m.

        What the ground of the volume, sampled from the DEM, is too high or low is in it with
        its sign, so that it does not count as density.
        """
        return self.thickness_m - self.inside_m

    def opacity(self, integral: np.ndarray, reference_density: float) -> np.ndarray:
        """Return opacities (g/cm²) of rays from density integrals (g/cm³ m) inside the volume."""
        return G_CM2_PER_M_WATER_EQUIVALENT * (integral + reference_density * self.outside_m)

    def per_pixel(self, values: np.ndarray, other: float = np.nan) -> list[np.ndarray]:
        """Return values of rays as an array for each station, `other` in other pixels."""
        sizes = [len(station) for station in self.stations]
        whole = np.full(sum(sizes), other)
        whole[self.pixel] = values
        return np.split(whole, np.cumsum(sizes)[:-1])


def lay_sightlines(
    stations: Sequence[StationData],
    rock: Sequence[RockSeen],
    grid: VoxelGrid,
    frame: VolumeFrame,
    dem: Dem,
    mask: bool = True,
    progress: Progress = silent,
) -> Sightlines:
    """Lay the rays of stations through a volume.

    Parameters
    ----------
    stations, rock
        Detectors, and where their rays are in rock (`rock_seen`).
    grid, frame
        The volume, in the CRS of the frame.
    dem
        Terrain over the whole volume.
    mask
        Whether the terrain is known: air is no unknown and rays count where they are in rock. If
        not, all voxels are unknown and rays count all the way through, those of the sky too.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If the DEM does not cover the volume, or no ray meets its rock.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    ground = ground_below(grid, frame, dem, part(progress, 0.0, 0.2))
    metric = frame.metric(grid)
    thickness = np.concatenate([seen.thickness_m for seen in rock])
    rays = rays_of(stations, frame)
    counts = {
        cause: int(sum(np.count_nonzero(seen.outcome == outcome) for seen in rock))
        for outcome, cause in UNKNOWN_ROCK.items()
    }
    known = np.isfinite(thickness)
    wanted = known & (thickness > 0) if mask else known
    counts[SKY] = int(np.count_nonzero(known & ~wanted))
    pixel = np.flatnonzero(wanted)
    rays, thickness = rays.take(pixel), thickness[pixel]
    below = _between(rock_along(metric, rays, ground, part(progress, 0.2, 1.0)), rays, stations)
    inside = np.bincount(below.ray, below.end_m - below.start_m, len(rays))
    if mask:
        paths = paths_through(metric, rays, below, holds_rock(metric, ground))
    else:
        paths = paths_through(metric, rays)
    meets = np.flatnonzero(paths.lengths_m() > 0)
    counts[MISSES] = len(pixel) - len(meets)
    if not len(meets):
        raise MuyscError(
            f"None of the {len(pixel)} rays in rock crosses rock of the volume (x "
            f"{grid.origin_m[0]:.7g} to {grid.end_m[0]:.7g}, y {grid.origin_m[1]:.7g} to "
            f"{grid.end_m[1]:.7g} in {frame.crs.name}, {grid.origin_m[2]:g} to {grid.end_m[2]:g} m "
            "high); choose an extent, base and top that the muograms look through."
        )
    return Sightlines(
        frame, grid, tuple(stations), pixel[meets], paths.take(meets), thickness[meets],
        inside[meets], counts,
    )  # fmt: skip


def rays_of(stations: Sequence[StationData], frame: VolumeFrame) -> Rays:
    """Return the rays of all pixels in the frame."""
    parts = []
    for number, one in enumerate(stations):
        place = (*frame.place(one.longitude, one.latitude), one.elevation_m)
        lines = frame.lines(place, one.azimuth_deg, one.elevation_deg)
        parts.append(Rays(*lines, np.full(len(one), number)))
    return joined(parts)


def _between(below: Stretches, rays: Rays, stations: Sequence[StationData]) -> Stretches:
    """Return stretches cut off where a station's near field ends and its range."""
    near = np.array([station.near_field_m for station in stations])
    far = np.array([np.inf if one.max_range_m is None else one.max_range_m for one in stations])
    level = np.linalg.norm(rays.direction[:, :2], axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        first, last = near[rays.view] / level, far[rays.view] / level
    # A vertical ray has neither.
    start = np.fmax(below.start_m, first[below.ray])
    end = np.fmin(below.end_m, last[below.ray])
    return Stretches(below.ray, start, end).take(end > start)
