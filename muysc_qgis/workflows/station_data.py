"""Opacity by direction as each station saw it: the data of a tomography."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, part, silent
from ..radiography.raytracing import Outcome, RockPaths
from ..topography.dem import Dem
from ..topography.frame import from_wgs84, local_frame
from ..topography.tracing import trace_terrain


@dataclass(frozen=True)
class StationData:
    """A detector, its directions, and what it saw in them.

    Raises
    ------
    MuyscError
        If the arrays do not fit each other.
    """

    name: str
    #: WGS 84 degrees.
    longitude: float
    latitude: float
    #: In the heights of the terrain model, m.
    elevation_m: float
    #: (n,) clockwise from true north and above the horizontal.
    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    #: (n,) g/cm² along the whole ray, 0 in the sky and NaN where unknown; None before a simulation.
    opacity: np.ndarray | None = None
    #: (n,) standard errors of it, None where they are not known.
    error: np.ndarray | None = None
    #: (n,) share of an independent datum that each is: 1/n where n pixels carry one measurement.
    #: None where each is one.
    share: np.ndarray | None = None
    #: Horizontal distance within which terrain was ignored, and beyond which it was; m.
    near_field_m: float = 0.0
    max_range_m: float | None = None
    #: What it looks at: WGS 84 longitude and latitude, and height (m).
    target: tuple[float, float, float] | None = None
    #: Which rays have no opacity, (n,) of bool by cause.
    lost: Mapping[str, np.ndarray] = field(default_factory=dict)

    def __post_init__(self) -> None:
        arrays = (self.azimuth_deg, self.elevation_deg, self.opacity, self.error, self.share)
        shapes = {array.shape for array in arrays if array is not None}
        if shapes != {(len(self.azimuth_deg),)}:
            raise MuyscError(
                f"{self.name} has directions, opacities and errors of the shapes {shapes}; give "
                "one of each for each ray."
            )

    def __len__(self) -> int:
        return len(self.azimuth_deg)

    def with_opacity(self, opacity: np.ndarray, error: np.ndarray | None) -> StationData:
        """Return the station with other data (g/cm²), one for each ray."""
        return replace(self, opacity=opacity, error=error)


@dataclass(frozen=True)
class RockSeen:
    """Where the rays of a station are in the rock of a DEM; (n,) each, slant lengths in m."""

    #: NaN where it cannot be known.
    thickness_m: np.ndarray
    #: To the first rock and out of the last, NaN where there is none.
    distance_m: np.ndarray
    exit_m: np.ndarray
    #: `Outcome` of each ray.
    outcome: np.ndarray


def rock_seen(station: StationData, dem: Dem, progress: Progress = silent) -> RockSeen:
    """Trace the rays of a station through the terrain.

    Parameters
    ----------
    station
        Detector and directions.
    dem
        Terrain.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If the station is off the DEM.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    x, y = from_wgs84(dem.crs, station.longitude, station.latitude, dem.transformation)
    frame = local_frame(dem, x, y, f"detector of {station.name}")
    limits = (station.max_range_m, station.near_field_m, progress)
    # Rays that share an azimuth share a profile; those of a muogram all do.
    azimuth, column = np.unique(station.azimuth_deg, return_inverse=True)
    elevation, row = np.unique(station.elevation_deg, return_inverse=True)
    if len(azimuth) * len(elevation) == len(station):
        rock = trace_terrain(frame, station.elevation_m, azimuth, elevation, *limits)
        which: tuple[np.ndarray, ...] = (column, row)
    else:
        rock = trace_terrain(
            frame, station.elevation_m, station.azimuth_deg, station.elevation_deg[:, None],
            *limits,
        )  # fmt: skip
        which = (np.arange(len(station)), np.zeros(len(station), int))
    return _taken(rock, which)


def rock_of_all(
    stations: Sequence[StationData], dem: Dem, progress: Progress = silent
) -> list[RockSeen]:
    """Trace the rays of several stations; see `rock_seen`.

    Raises
    ------
    MuyscError
        If a station is off the DEM.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    ends = np.linspace(0.0, 1.0, len(stations) + 1)
    return [
        rock_seen(station, dem, part(progress, start, end))
        for station, start, end in zip(stations, ends[:-1], ends[1:])
    ]


def _taken(rock: RockPaths, which: tuple[np.ndarray, ...]) -> RockSeen:
    return RockSeen(
        rock.thickness_m[which], rock.distance_m[which], rock.exit_m[which], rock.outcome[which]
    )


#: Why a ray has no thickness, by outcome.
UNKNOWN_ROCK = {
    Outcome.EDGE: "the ray reaches the edge of the elevation model in rock",
    Outcome.NO_DATA: "the ray passes a gap in the elevation model",
}
