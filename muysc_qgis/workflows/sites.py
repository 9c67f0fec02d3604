"""The same mountain from many places: one radiography for each site."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from ..errors import MuyscError
from ..muogram import write_muogram
from ..progress import Progress, silent
from ..radiography.aperture import Aperture
from ..survey.held_dem import plain_dem, reopened_dem
from ..survey.job import Compute, Job
from ..survey.run import Say, run_job, unheard
from ..topography.dem import Dem
from ..topography.frame import ground_height
from ..topography.sight import Sight, take_sight
from .simulation import Simulation
from .view_settings import ViewSettings

#: Name under which workers find `prepare`.
_FUNCTION = "workflows.sites:prepare"

#: Sites handed out together.
_TOGETHER = 8

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
    #: (x, y) of the target in the DEM's CRS, and its height above ground (m).
    target: tuple[float, float]
    target_height_m: float


@dataclass(frozen=True)
class StationNumbers:
    """What one site sees, in numbers."""

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
    def of(cls, sight: Sight, simulation: Simulation) -> StationNumbers:
        """Sum up a simulation."""
        return cls(
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
            stations.append(Station(site, sight, target, target_height_m))
    if not stations:
        why = f": {skipped[0]}" if skipped else "."
        raise MuyscError(f"None of the {len(skipped)} sites can be used{why}")
    return stations, skipped


@dataclass(frozen=True)
class StationMuograms:
    """What one site sees."""

    site: Site
    numbers: StationNumbers
    #: One sentence each.
    warnings: tuple[str, ...]
    #: File by quantity, for the time being.
    files: Mapping[str, Path]


def make_muograms(
    stations: Sequence[Station],
    view: ViewSettings,
    quantities: Sequence[str],
    folder: Path,
    workers: int | None = None,
    progress: Progress = silent,
    say: Say = unheard,
    warn: Say = unheard,
) -> list[StationMuograms]:
    """Simulate a radiography from every station and write its muograms.

    Parameters
    ----------
    stations
        Where telescopes stand, all on one DEM.
    view
        What each of them looks with.
    quantities
        What to write.
    folder
        Empty folder for the muograms, from which the caller takes them.
    workers, progress, say, warn
        See `run_job`.

    Raises
    ------
    MuyscError
        If a number cannot be used or a file cannot be read or written.
    Cancelled
        If `progress` asks for a stop.
    """
    job = Job(
        _FUNCTION,
        {
            "dem": plain_dem(stations[0].sight.frame.dem),
            "view": view.plain(),
            "stations": [
                {
                    "position": station.site.position,
                    "height_m": station.site.height_m,
                    "target": station.target,
                    "target_height_m": station.target_height_m,
                }
                for station in stations
            ],
            "quantities": list(quantities),
            "folder": str(folder),
        },
        {},
        len(stations),
        "sites",
        _TOGETHER,
    )
    results = run_job(job, folder / "job", workers, "", progress, say, warn)
    return [
        StationMuograms(
            station.site,
            StationNumbers(**result["numbers"]),
            tuple(result["warnings"]),
            {quantity: _file(folder, item, quantity) for quantity in quantities},
        )
        for item, (station, result) in enumerate(zip(stations, results))
    ]


def prepare(settings: Mapping[str, Any], arrays: Mapping[str, Any]) -> Compute:
    """Return what writes the muograms of a station by its number, see `make_muograms`."""
    dem, view = reopened_dem(settings["dem"]), ViewSettings.of(settings["view"])
    folder = Path(settings["folder"])

    def compute(item: int, progress: Progress) -> dict[str, Any]:
        plain = settings["stations"][item]
        sight = take_sight(
            dem,
            tuple(plain["position"]),
            tuple(plain["target"]),
            plain["height_m"],
            plain["target_height_m"],
        )
        simulation = view.simulate(sight, progress)
        for quantity in settings["quantities"]:
            write_muogram(simulation.muograms[quantity], _file(folder, item, quantity))
        return {
            "numbers": asdict(StationNumbers.of(sight, simulation)),
            "warnings": list(simulation.warnings),
        }

    return compute


def _file(folder: Path, item: int, quantity: str) -> Path:
    return folder / f"{item}_{quantity}.tif"


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
