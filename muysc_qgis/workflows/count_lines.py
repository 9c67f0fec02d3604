"""From counts of several stations to a model of them over the densities of a volume."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, part, silent
from ..radiography.raytracing import Outcome
from ..radiography.settings import Physics
from ..telescope.acceptance import Trajectories
from ..telescope.directions import Pointing
from ..tomography.counting import CountModel
from ..tomography.libraries import scipy_part
from ..tomography.operators import projector_of
from ..tomography.projector import MEMORY_LIMIT
from ..topography.dem import Dem
from ..topography.frame import from_wgs84, local_frame
from .beams import Beams, look_around, telescope_beams
from .flux_table import FluxTable
from .pixel_beams import look_at_pixels, pixel_beams
from .sightlines import Sightlines
from .station_data import RockSeen, StationData, rock_seen
from .tomography import survey
from .volume_plan import VolumePlan

if TYPE_CHECKING:
    from pyproj import CRS

#: Why a trajectory says nothing.
NO_COUNT = "it has no count"
NO_EXPOSURE = "it collects nothing"
HORIZON = "a part of it looks at or below the horizon"
UNKNOWN_ROCK = "a part of it meets the edge of the elevation model in rock, or a gap in it"


@dataclass(frozen=True)
class CountStation:
    """A detector and what it counted along each trajectory or in each pixel.

    Raises
    ------
    MuyscError
        If the shapes do not fit.
    """

    name: str
    #: WGS 84 degrees, and m in the heights of the terrain model.
    longitude: float
    latitude: float
    elevation_m: float
    #: (n_y, n_x) counts, NaN where unknown.
    counts: np.ndarray
    #: (n_y, n_x) acceptance times days times efficiency, cm² sr days.
    exposure: np.ndarray
    physics: Physics
    #: The telescope's own trajectories, merged to bins; or middles of a muogram's pixels.
    trajectories: Trajectories | None = None
    pointing: Pointing | None = None
    merge: int = 1
    azimuth_deg: np.ndarray | None = None
    elevation_deg: np.ndarray | None = None
    near_field_m: float = 0.0
    max_range_m: float | None = None
    target: tuple[float, float, float] | None = None

    def __post_init__(self) -> None:
        if self.counts.shape != self.exposure.shape:
            raise MuyscError(
                f"{self.name} has counts of the shape {self.counts.shape} and exposures of the "
                f"shape {self.exposure.shape}; give one for each trajectory."
            )

    def bare(self, azimuth_deg: np.ndarray, elevation_deg: np.ndarray) -> StationData:
        """Return the station with rays of its own."""
        return StationData(
            self.name, self.longitude, self.latitude, self.elevation_m, azimuth_deg,
            elevation_deg, near_field_m=self.near_field_m, max_range_m=self.max_range_m,
            target=self.target,
        )  # fmt: skip


@dataclass(frozen=True)
class CountLines:
    """Counts of several stations, their sub-rays through a volume, and what is left out."""

    lines: Sightlines
    model: CountModel
    #: Number of each datum among the pixels of all stations, one after the other.
    pixel: np.ndarray
    #: Pixels of each station.
    shapes: tuple[tuple[int, int], ...]
    #: (n_data,) share of the response behind rock.
    rock_share: np.ndarray
    lost: dict[str, int] = field(default_factory=dict)

    def per_station(self, values: np.ndarray) -> list[np.ndarray]:
        """Return values of data as an array of pixels for each station, NaN in others."""
        sizes = [rows * columns for rows, columns in self.shapes]
        whole = np.full(sum(sizes), np.nan)
        whole[self.pixel] = values
        parts = np.split(whole, np.cumsum(sizes)[:-1])
        return [one.reshape(shape) for one, shape in zip(parts, self.shapes)]


def beams_of(
    station: CountStation, dem: Dem, finer: float = 1.0, progress: Progress = silent
) -> Beams:
    """Return the sub-rays of a station, `finer` times as many along each side as are needed.

    Raises
    ------
    MuyscError
        If the station is off the DEM, or says neither telescope nor directions.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    x, y = from_wgs84(dem.crs, station.longitude, station.latitude, dem.transformation)
    frame = local_frame(dem, x, y, f"detector of {station.name}")
    eye = frame, station.elevation_m
    limits = station.max_range_m, station.near_field_m
    if station.trajectories is not None and station.pointing is not None:
        geometry = station.trajectories.geometry
        cells = look_around(geometry, station.pointing, *eye, *limits, progress=progress)
        return telescope_beams(
            geometry, station.pointing, cells, station.trajectories.acceptance_cm2_sr,
            station.merge, finer,
        )  # fmt: skip
    azimuth, elevation = station.azimuth_deg, station.elevation_deg
    if azimuth is None or elevation is None:
        raise MuyscError(f"{station.name} has no directions; give a telescope or a muogram's.")
    cells = look_at_pixels(azimuth, elevation, *eye, *limits, progress=progress)
    return pixel_beams(azimuth, elevation, cells, finer)


def rock_of_beams(
    station: CountStation, beams: Beams, dem: Dem, progress: Progress = silent
) -> tuple[StationData, RockSeen]:
    """Return the sub-rays of a station as rays, and the rock along them.

    Raises
    ------
    MuyscError
        If the station is off the DEM.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    data = station.bare(beams.azimuth_deg, beams.elevation_deg)
    traced = np.flatnonzero(~beams.sky)
    thickness = np.zeros(beams.count)
    near, far = np.full(beams.count, np.nan), np.full(beams.count, np.nan)
    outcome = np.full(beams.count, int(Outcome.KNOWN))
    if len(traced):
        some = station.bare(beams.azimuth_deg[traced], beams.elevation_deg[traced])
        seen = rock_seen(some, dem, progress)
        thickness[traced], outcome[traced] = seen.thickness_m, seen.outcome
        near[traced], far[traced] = seen.distance_m, seen.exit_m
    return data, RockSeen(thickness, near, far, outcome)


def lay_counts(
    stations: Sequence[CountStation],
    dem: Dem,
    plan: VolumePlan,
    crs: CRS | None = None,
    length_error_m: float = 0.0,
    terrain_length_m: float | None = None,
    memory_bytes: int = MEMORY_LIMIT,
    finer: float = 1.0,
    progress: Progress = silent,
) -> CountLines:
    """Return what several stations count as a function of the densities of a volume.

    Parameters
    ----------
    stations
        What was counted.
    dem, plan, crs, memory_bytes
        As in `tomography`.
    length_error_m
        Error of the lengths in rock that trajectories do not share, m.
    terrain_length_m
        Distance (m) over which errors of the terrain are alike; None where it is known.
    finer
        Times as many sub-rays along each side of a trajectory as a fit needs.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If a value cannot be used, or no trajectory meets rock of the volume.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    beams, bare, rock = [], [], []
    for number, station in enumerate(stations):
        share = part(progress, 0.5 * number / len(stations), 0.5 * (number + 1) / len(stations))
        own = beams_of(station, dem, finer, part(share, 0.0, 0.1))
        data, seen = rock_of_beams(station, own, dem, part(share, 0.1, 1.0))
        beams.append(own)
        bare.append(data)
        rock.append(seen)
    lines = survey(bare, dem, plan, True, crs, rock, memory_bytes, part(progress, 0.5, 0.85))
    return _modelled(
        stations, beams, rock, lines, dem, length_error_m, terrain_length_m, memory_bytes,
        part(progress, 0.85, 1.0),
    )  # fmt: skip


def _modelled(
    stations: Sequence[CountStation],
    beams: Sequence[Beams],
    rock: Sequence[RockSeen],
    lines: Sightlines,
    dem: Dem,
    length_error_m: float,
    terrain_length_m: float | None,
    memory_bytes: int,
    progress: Progress,
) -> CountLines:
    from .terrain_errors import terrain_changes

    sparse = scipy_part("sparse")
    weights, turned, tilted = (
        sparse.block_diag([getattr(one, name) for one in beams], format="csr")
        for name in ("weights", "turned", "tilted")
    )
    thickness = np.concatenate([seen.thickness_m for seen in rock])
    counts = np.concatenate([one.counts.ravel() for one in stations]).astype(float)
    exposure = np.concatenate([one.exposure.ravel() for one in stations]).astype(float)
    view = np.concatenate([np.full(one.counts.size, n) for n, one in enumerate(stations)])
    unknown = np.isnan(thickness)
    whole = np.asarray(weights.sum(axis=1)).ravel() > 0
    causes = {
        NO_COUNT: ~(counts >= 0),
        NO_EXPOSURE: ~(np.isfinite(exposure) & (exposure > 0)),
        HORIZON: ~whole,
        UNKNOWN_ROCK: weights @ unknown.astype(float) > 0,
    }
    lost, left = {}, np.ones(len(counts), bool)
    for cause, which in causes.items():
        lost[cause] = int(np.count_nonzero(left & which))
        left &= ~which
    pixel = np.flatnonzero(left)
    if not len(pixel):
        raise MuyscError(
            f"None of the {len(counts)} trajectories has a count, an exposure and known rock; "
            "check counts, acceptance and elevation model."
        )
    inside = np.zeros(len(thickness))
    inside[lines.pixel] = lines.paths.lengths_m()
    outside = np.maximum(np.nan_to_num(thickness) - inside, 0.0)
    paths = projector_of(lines.paths, memory_bytes, progress)
    terrain, ground = None, None
    if terrain_length_m is not None:
        terrain, ground = terrain_changes(lines.stations, rock, lines, dem, terrain_length_m)
    rock_share = weights @ (np.nan_to_num(thickness) > 0).astype(float)
    model = CountModel(
        paths, lines.pixel, outside, weights[pixel], exposure[pixel], counts[pixel], view[pixel],
        _flux_of(stations, beams), lines.lattice, turned[pixel], tilted[pixel], length_error_m,
        terrain, ground,
    )  # fmt: skip
    return CountLines(
        lines, model, pixel, tuple((len(one.counts), one.counts.shape[1]) for one in stations),
        rock_share[pixel],
        {cause: count for cause, count in lost.items() if count},
    )  # fmt: skip


@dataclass(frozen=True)
class _Fluxes:
    """The flux behind the rock of each sub-ray, from a table for each station."""

    tables: tuple[FluxTable, ...]
    elevation_deg: tuple[np.ndarray, ...]

    def __call__(self, opacity: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        ends = np.cumsum([len(one) for one in self.elevation_deg])[:-1]
        found = [
            table(own, elevation)
            for table, own, elevation in zip(
                self.tables, np.split(opacity, ends), self.elevation_deg
            )
        ]
        flux, slope = zip(*found)
        return np.concatenate(flux), np.concatenate(slope)


def _flux_of(stations: Sequence[CountStation], beams: Sequence[Beams]) -> _Fluxes:
    tables = []
    for station, own in zip(stations, beams):
        tables.append(
            FluxTable.of(
                float(own.elevation_deg.min()), float(own.elevation_deg.max()), station.physics,
                station.elevation_m if station.physics.altitude_counts else 0.0,
            )
        )  # fmt: skip
    return _Fluxes(tuple(tables), tuple(own.elevation_deg for own in beams))


def taken(laid: CountLines, which: np.ndarray) -> CountLines:
    """Return some of the data, by their numbers."""
    model = laid.model
    return replace(
        laid,
        pixel=laid.pixel[which],
        rock_share=laid.rock_share[which],
        model=replace(
            model, weights=model.weights[which], exposure=model.exposure[which],
            counts=model.counts[which], station=model.station[which],
            turned=None if model.turned is None else model.turned[which],
            tilted=None if model.tilted is None else model.tilted[which],
        ),
    )  # fmt: skip


def with_counts(laid: CountLines, counts: np.ndarray) -> CountLines:
    """Return the same lines with other counts, (n_data,)."""
    return replace(laid, model=replace(laid.model, counts=counts))
