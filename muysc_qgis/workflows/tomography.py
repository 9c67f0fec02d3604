"""From what several stations saw to the densities of a volume.

The data flow one way: stations → rock along their rays → volume → paths → densities.
`tomography` does it all; `survey` and `reconstruct_volume` are its halves, between which data
may be simulated.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, part, report, silent
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.settings import MAXIMUM_DENSITY_G_CM3
from ..tomography.counting import COUNTS
from ..tomography.operators import Projector, projector_of
from ..tomography.projector import MEMORY_LIMIT, Paths, check_memory
from ..tomography.solvers import Options, method_of, reconstruct
from ..tomography.system import System
from ..tomography.voxels import VoxelGrid
from ..topography.dem import Dem
from ..topography.frame import from_wgs84
from .ray_data import ray_data
from .sightlines import Sightlines, lay_sightlines
from .station_data import RockSeen, StationData, rock_of_all
from .tomography_result import Tomography, result_of, warnings_after
from .volume_frame import VolumeFrame, projection_for
from .volume_plan import VolumePlan, volume_grid

if TYPE_CHECKING:
    from pyproj import CRS

#: Numbers of 8 bytes that a solver keeps for each voxel, roughly: model, step, weights,
#: neighbours and their multipliers; and the Bayesian method on its padded grid.
_NUMBERS_PER_VOXEL = {"bayes": 100}
_FEW_NUMBERS_PER_VOXEL = 40

#: Shares of the progress bar.
_LAID = 0.3
#: Of it, and of the rest.
_TRACED, _BUILT = 0.5, 0.3


@dataclass(frozen=True)
class TomographyChoices:
    """What the user decides on the way to densities.

    Raises
    ------
    MuyscError
        If there is no such method or a number is out of range.
    """

    #: Key of `tomography.solvers.METHODS`, or `COUNTS`.
    method: str = "bayes"
    options: Options = field(default_factory=Options)
    #: Density (g/cm³) of the rock outside the volume and of the start; None for the mean that the
    #: data say.
    reference_density: float | None = None
    #: Whether the terrain is known: no unknowns in air.
    mask: bool = True
    #: Relative error of opacities that have none of their own; None where it is not known.
    relative_error: float | None = None
    #: Error (m) of the length in rock, from what the terrain model leaves out; it adds to errors.
    length_error_m: float = 0.0
    #: Most memory of the path matrix; beyond it the paths are recomputed at every step.
    memory_bytes: int = MEMORY_LIMIT

    def __post_init__(self) -> None:
        if self.method != COUNTS:
            method_of(self.method)
        density = self.reference_density
        if density is not None and not 0 < density <= MAXIMUM_DENSITY_G_CM3:
            raise MuyscError(
                f"A reference density of {density:g} g/cm³ is not that of any rock; give one above "
                f"0 and up to {MAXIMUM_DENSITY_G_CM3:g} g/cm³, or none for the mean that the "
                "muograms say."
            )
        for name, value in (("relative error", self.relative_error),
                            ("length error", self.length_error_m)):  # fmt: skip
            if value is not None and not 0 <= value < np.inf:
                raise MuyscError(f"A {name} of {value:g} cannot be used; give 0 or more.")
        if self.memory_bytes <= 0:
            raise MuyscError(
                f"A memory of {self.memory_bytes / 2**30:g} GiB holds no path; give more than 0."
            )


def tomography(
    stations: Sequence[StationData],
    dem: Dem,
    plan: VolumePlan,
    choices: TomographyChoices,
    crs: CRS | None = None,
    rock: Sequence[RockSeen] | None = None,
    progress: Progress = silent,
) -> Tomography:
    """Return the densities that explain what several stations saw.

    Parameters
    ----------
    stations
        Opacity by direction of each.
    dem
        Terrain: what is rock, and what the rays cross outside the volume.
    plan, choices
        See there.
    crs
        Projected coordinate reference system; None for the DEM's own or the UTM zone.
    rock
        Where the rays of each station are in rock, if that is known already (`rock_seen`).
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If a value cannot be used or the rays say nothing about the volume.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    lines = survey(
        stations, dem, plan, choices.mask, crs, rock, choices.memory_bytes,
        part(progress, 0.0, _LAID),
    )  # fmt: skip
    return reconstruct_volume(lines, choices, part(progress, _LAID, 1.0))


def survey(
    stations: Sequence[StationData],
    dem: Dem,
    plan: VolumePlan,
    mask: bool = True,
    crs: CRS | None = None,
    rock: Sequence[RockSeen] | None = None,
    memory_bytes: int = MEMORY_LIMIT,
    progress: Progress = silent,
) -> Sightlines:
    """Return the rays of stations through a volume, whatever they see.

    Parameters
    ----------
    stations, dem, plan, crs, rock, progress
        As in `tomography`; opacities are not needed.
    mask, memory_bytes
        As in `TomographyChoices`.

    Raises
    ------
    MuyscError
        If there is no station, a value cannot be used or no ray meets the rock of the volume.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    if rock is None:
        rock = rock_of_all(stations, dem, part(progress, 0.0, _TRACED))
    crs = crs or projection_of(stations, dem)
    by = dem.transformation
    rough = VolumeFrame.around(crs, from_wgs84(crs, *_somewhere(stations), by), by)
    grid = volume_grid(plan, rough, stations, rock, dem)
    _check_voxels(grid, memory_bytes)
    middle = [0.5 * (low + high) for low, high in zip(grid.origin_m, grid.end_m)]
    frame = VolumeFrame.around(crs, (middle[0], middle[1]), by)
    return lay_sightlines(stations, rock, grid, frame, dem, mask, part(progress, _TRACED, 1.0))


def projection_of(stations: Sequence[StationData], dem: Dem) -> CRS:
    """Return the DEM's own CRS where its lengths are true metres, else the UTM zone.

    Raises
    ------
    MuyscError
        If there is no station.
    """
    return projection_for(dem, *_somewhere(stations))


def _somewhere(stations: Sequence[StationData]) -> tuple[float, float]:
    """Return longitude and latitude of the first target, or of the first station.

    Raises
    ------
    MuyscError
        If there is no station.
    """
    if not stations:
        raise MuyscError("No muogram is given; choose those of one station or more.")
    # A mean longitude would mean nothing across the antimeridian.
    targets = (one.target[:2] for one in stations if one.target is not None)
    return next(targets, (stations[0].longitude, stations[0].latitude))


def reconstruct_volume(
    lines: Sightlines, choices: TomographyChoices, progress: Progress = silent
) -> Tomography:
    """Return the densities that explain the opacities of stations whose rays are laid.

    Parameters
    ----------
    lines
        Stations with their opacities, and their rays (`survey`).
    choices
        How densities are found.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If the opacities are missing, the voxels need too much memory, or a value cannot be used.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    if choices.method == COUNTS:
        raise MuyscError(
            "The method counts fits rasters of counts, and opacities follow from these muograms; "
            "choose rasters of counts, or another method such as bayes."
        )
    _check_voxels(lines.grid, choices.memory_bytes, choices.method)
    known = ray_data(
        lines, choices.reference_density, choices.relative_error, choices.length_error_m
    )
    reference, used = known.reference_density, known.used
    warnings = _warnings(lines, used, choices)
    paths = lines.paths.take(used)
    projector, more = _projector(paths, choices, part(progress, 0.0, _BUILT))
    data = known.opacity / G_CM2_PER_M_WATER_EQUIVALENT - reference * lines.outside_m[used]
    errors = None if known.error is None else known.error / G_CM2_PER_M_WATER_EQUIVALENT
    system = System(projector, data, lines.lattice, paths.rays.view, errors)
    options = _with_reference(choices.options, reference)
    # Pixels of one measurement scatter together, so that its error is reached earlier.
    reached = options.discrepancy * float(np.sqrt(known.share.mean()))
    found = reconstruct(
        choices.method, system, replace(options, discrepancy=reached),
        part(progress, _BUILT, 1.0),
    )  # fmt: skip
    report(progress, 1.0)
    if found.stopped_by == "discrepancy" and not found.iterations_done:
        warnings.append(
            f"One density of {reference:.4g} g/cm³ explains the data within their errors, so that "
            f"{choices.method} had nothing to do; give smaller errors if they are known."
        )
    if choices.method == "bayes" and found.stopped_by == "iterations":
        warnings.append(
            f"bayes did not settle within {found.iterations_done} iterations, so that the "
            "densities are smoother than data and prior say; give more iterations."
        )
    warnings += more
    result = result_of(
        lines, choices.method, system, found, reference, known.lost, warnings, known.share
    )
    return replace(result, warnings=(*result.warnings, *warnings_after(result)))


def _check_voxels(grid: VoxelGrid, memory_bytes: int, method: str = "") -> None:
    """Refuse voxels of which not even the vectors fit the memory."""
    need = 8 * _NUMBERS_PER_VOXEL.get(method, _FEW_NUMBERS_PER_VOXEL) * grid.count
    if need > memory_bytes:
        factor = 1.02 * (need / memory_bytes) ** (1 / 3)
        raise MuyscError(
            f"{' × '.join(map(str, grid.shape))} voxels of {grid.size_m[0]:g} m need about "
            f"{need / 2**30:.3g} GiB{method and f' with {method}'}, more than the limit of "
            f"{memory_bytes / 2**30:.3g} GiB; use voxels of {factor * grid.size_m[0]:.3g} m or "
            "larger, or allow more memory."
        )


def _projector(
    paths: Paths, choices: TomographyChoices, progress: Progress
) -> tuple[Projector, tuple[str, ...]]:
    """Return the path matrix, or what recomputes it with a warning where it does not fit."""
    warnings: tuple[str, ...] = ()
    try:
        check_memory(paths, choices.memory_bytes)
    except MuyscError as error:
        warnings = (f"The paths are recomputed at every step, which is slow. {error}",)
    return projector_of(paths, choices.memory_bytes, progress), warnings


def _with_reference(options: Options, reference: float) -> Options:
    """Return options that start from the reference density where nothing else is asked for."""
    if options.start is None:
        options = replace(options, start=reference)
    if options.prior_density is None:
        options = replace(options, prior_density=reference)
    return options


def _warnings(lines: Sightlines, used: np.ndarray, choices: TomographyChoices) -> list[str]:
    """Return what limits the result before anything is computed."""
    warnings = []
    if len(lines.stations) == 1:
        warnings.append(
            "There is one station only, so that nothing tells near rock from far: densities are "
            "smeared along its rays; add stations that look from other sides."
        )
    without = [
        station.name
        for number, station in enumerate(lines.stations)
        if not np.any(lines.paths.rays.view[used] == number)
    ]
    if without:
        warnings.append(
            f"{', '.join(without)}: no ray of known opacity crosses the rock of the volume, so "
            "this says nothing about it; choose a larger extent or leave it out."
        )
    if choices.method == "bayes" and not choices.mask:
        warnings.append(
            "The prior of bayes expects rock of the reference density where there is air; with "
            "air among the unknowns choose another method, such as sirt."
        )
    share = 1 - lines.inside_m[used].sum() / lines.thickness_m[used].sum()
    if share > 0.5:
        density = choices.reference_density
        taken = "the mean density" if density is None else f"{density:g} g/cm³"
        warnings.append(
            f"{100 * share:.0f} % of the rock on the rays is outside the volume and taken for "
            f"rock of {taken}; choose a larger extent or a lower base."
        )
    return warnings
