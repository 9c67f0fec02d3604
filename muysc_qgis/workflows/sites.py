"""The same mountain from many places: one radiography for each site."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from ..errors import MuyscError
from ..progress import Progress, part, report, silent
from ..radiography.aperture import Aperture
from ..radiography.settings import Physics
from ..topography.dem import Dem
from ..topography.frame import ground_height
from ..topography.sight import Sight, take_sight
from .simulation import Simulation, Telescope, simulate

#: Site names in one sentence; the others are counted.
_NAMED = 5


@dataclass(frozen=True)
class Site:
    """A place for a telescope."""

    name: str
    #: (x, y) in the DEM's CRS.
    position: tuple[float, float]
    #: Height of the telescope above ground (m).
    height_m: float
    #: Start of the names of the site's files, see `file_stems`.
    stem: str


@dataclass(frozen=True)
class Station:
    """A site with its line of sight to the target."""

    site: Site
    sight: Sight


@dataclass(frozen=True)
class StationSummary:
    """What one site sees, in numbers."""

    site: Site
    detector_elevation_m: float
    distance_m: float
    boresight_azimuth_deg: float
    boresight_elevation_deg: float
    #: NaN where no thickness is known.
    maximum_thickness_m: float
    #: Of the pixels behind rock, NaN where there are none.
    median_exposure_days: float
    rock_pixels: int
    unknown_pixels: int

    @classmethod
    def of(cls, station: Station, simulation: Simulation) -> StationSummary:
        """Sum up a simulation."""
        sight = station.sight
        return cls(
            station.site,
            sight.detector_elevation_m,
            sight.target_distance_m,
            sight.boresight_azimuth_deg,
            sight.boresight_elevation_deg,
            simulation.maximum_thickness_m,
            simulation.median_exposure_days,
            simulation.rock_pixels,
            simulation.unknown_pixels,
        )


def stations_of(
    dem: Dem,
    sites: Iterable[Site],
    target: tuple[float, float],
    target_height_m: float,
    aperture: Aperture,
) -> tuple[list[Station], list[str]]:
    """Aim every site at a target.

    Parameters
    ----------
    dem
        Terrain.
    sites
        Where telescopes stand.
    target, target_height_m
        (x, y) in the DEM's CRS, and height above ground (m).
    aperture
        Field of view, which must not reach past the zenith from any site.

    Returns
    -------
    tuple
        The stations, and a sentence for each site that cannot be one.

    Raises
    ------
    MuyscError
        If the target is off the DEM or on no-data, or no site is left.
    """
    ground_height(dem, *target, "target")
    stations, skipped = [], []
    for site in sites:
        try:
            sight = take_sight(dem, site.position, target, site.height_m, target_height_m)
            aperture.directions(sight.boresight_azimuth_deg, sight.boresight_elevation_deg)
        except MuyscError as error:
            skipped.append(f"Site {site.name} was skipped. {error}")
        else:
            stations.append(Station(site, sight))
    if not stations:
        why = f": {skipped[0]}" if skipped else "."
        raise MuyscError(f"None of the {len(skipped)} sites can be used{why}")
    return stations, skipped


def simulate_stations(
    stations: Sequence[Station],
    aperture: Aperture,
    physics: Physics,
    telescope: Telescope,
    max_range_m: float | None = None,
    near_field_m: float = 0.0,
    progress: Progress = silent,
) -> Iterator[tuple[Station, Simulation]]:
    """Simulate a radiography from every station, one after the other.

    The arguments are those of `simulate`.

    Yields
    ------
    tuple
        The station and what it sees; only one simulation is in memory.

    Raises
    ------
    MuyscError
        If a number cannot be used or the DEM cannot be read.
    Cancelled
        If `progress` asks for a stop.
    """
    for index, station in enumerate(stations):
        share = part(progress, index / len(stations), (index + 1) / len(stations))
        yield (
            station,
            simulate(station.sight, aperture, physics, telescope, max_range_m, near_field_m, share),
        )
        report(share, 1.0)


def file_stems(names: Sequence[str | None]) -> list[str]:
    """Return safe starts of file names, one for each site, all different.

    Letters without accents, digits, hyphens and underscores stay. A site without
    a usable name gets its number, such as ``site_07``; of several with the same name the later
    ones get a number behind it.
    """
    digits = max(2, len(str(len(names))))
    stems: list[str] = []
    taken: set[str] = set()
    for number, name in enumerate(names, 1):
        plain = unicodedata.normalize("NFKD", name or "").encode("ascii", "ignore").decode()
        first = re.sub(r"[^A-Za-z0-9-]+", "_", plain).strip("_-") or f"site_{number:0{digits}d}"
        stem, again = first, 1
        # Some file systems take upper and lower case for the same.
        while stem.lower() in taken:
            again += 1
            stem = f"{first}_{again}"
        taken.add(stem.lower())
        stems.append(stem)
    return stems


def gathered(said: Iterable[tuple[str, str]]) -> list[str]:
    """Return (site, warning) pairs as sentences, those that differ in numbers alone as one.

    Each keeps the numbers of its first site and says how many more it holds for.
    """
    kinds: dict[str, tuple[str, list[str]]] = {}
    for name, warning in said:
        kind = re.sub(r"\d[\d.,]*", "#", warning)
        kinds.setdefault(kind, (warning, []))[1].append(name)
    return [f"{_listed(names)}: {warning}" for warning, names in kinds.values()]


def _listed(names: Sequence[str]) -> str:
    if len(names) == 1:
        return f"Site {names[0]}"
    more = f" and {len(names) - _NAMED} more" if len(names) > _NAMED else ""
    others = ", ".join(names[1:_NAMED]) + more
    return f"Site {names[0]} (and likewise {others})"
