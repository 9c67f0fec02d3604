"""Can this survey see it? Known bodies, what stations would count, and what is found again.

The data flow one way: known model → opacity along the stations' rays → counts → opacity
as measured → densities → how near they are to the model. The opacity does not come
from the matrix that is inverted: thickness is traced through the terrain model itself, and
bodies are added on voxels of half the size.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, part, silent
from ..radiography.aperture import Aperture
from ..radiography.settings import Physics
from ..tomography.figures_of_merit import contrast_recovered, relative_error
from ..tomography.ground import rock_fraction
from ..tomography.operators import RecomputedPaths
from ..tomography.projector import paths_through
from ..tomography.rock import rock_along
from ..tomography.voxels import VoxelGrid
from ..topography.dem import Dem
from ..volume import Volume
from .known_model import KnownModel, PlacedBody, density_in
from .sightlines import Sightlines
from .simulated_counts import Campaign, count_muons, station_data
from .sites import Station
from .tomography import TomographyChoices, reconstruct_volume, survey
from .tomography_result import Tomography
from .volume_ground import ground_below
from .volume_plan import VolumePlan

if TYPE_CHECKING:
    from pyproj import CRS

    from .survey_verdict import Verdict

#: Voxels of the known model along one of the volume's, and the most of them.
_FINER, _MOST_FINE = 2, 32_000_000

#: Share of a voxel from which on it counts as inside a body.
_INSIDE = 0.5

#: Shares of the progress bar.
_SURVEYED, _COUNTED = 0.25, 0.35


@dataclass(frozen=True)
class BodyFound:
    """What is found of one body."""

    name: str
    #: Voxels with rock of it, and those of them that rays pass.
    voxels: int
    seen: int
    #: Contrast over the true one; NaN where it has none or no ray passes it.
    contrast: float


@dataclass(frozen=True)
class KnownModelResult:
    """What was to be found, what was found, and how near they are."""

    tomography: Tomography
    truth: Volume
    bodies: tuple[BodyFound, ...]
    #: ‖R − T‖ / ‖T‖ over the voxels that rays pass.
    relative_error: float
    #: Standard deviation and mean of R − T over them, g/cm³.
    spread: float
    bias: float
    #: Muons counted by all stations; NaN without noise.
    muons: float
    #: Over several draws, of the method counts; None of others.
    verdict: Verdict | None = None

    @property
    def contrast(self) -> float:
        """Contrast found over the true one, the mean over bodies by their volume seen."""
        known = [one for one in self.bodies if np.isfinite(one.contrast)]
        if not known:
            return float("nan")
        return float(np.average([one.contrast for one in known], weights=[o.seen for o in known]))


def reconstruct_known_model(
    stations: Sequence[Station],
    aperture: Aperture,
    dem: Dem,
    plan: VolumePlan,
    model: KnownModel,
    physics: Physics,
    campaign: Campaign,
    choices: TomographyChoices,
    crs: CRS | None = None,
    progress: Progress = silent,
) -> KnownModelResult:
    """Return what a survey finds of a known model.

    Parameters
    ----------
    stations, aperture
        Where telescopes stand and look, and their field of view.
    dem, plan, crs
        Terrain and volume, as in `tomography`.
    model
        What is to be found.
    physics, campaign
        How muons are stopped and counted; the density is the model's.
    choices
        How densities are found.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If a value cannot be used, a body is outside the rock of the volume, or the rays say
        nothing about it.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    data = [station_data(station, aperture) for station in stations]
    lines = survey(data, dem, plan, choices.mask, crs, progress=part(progress, 0.0, _SURVEYED))
    return find_known_model(
        lines, stations, aperture, dem, model, physics, campaign, choices,
        part(progress, _SURVEYED, 1.0),
    )  # fmt: skip


def find_known_model(
    lines: Sightlines,
    stations: Sequence[Station],
    aperture: Aperture,
    dem: Dem,
    model: KnownModel,
    physics: Physics,
    campaign: Campaign,
    choices: TomographyChoices,
    progress: Progress = silent,
) -> KnownModelResult:
    """Return what stations whose rays are laid find of a known model.

    Parameters
    ----------
    lines
        The stations' rays through the volume (`survey`).
    stations, aperture, dem, model, physics, campaign, choices, progress
        As in `reconstruct_known_model`.

    Raises
    ------
    MuyscError
        As there.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    metric = lines.paths.grid
    bodies = model.bodies(lines.frame, metric)
    density, shares = density_in(metric, bodies, model.density)
    truth = _truth(lines, density, dem)
    check_bodies(bodies, shares, truth, lines)
    opacity = lines.opacity(
        model.density * lines.inside_m + _contrast_along(lines, bodies, model.density, dem),
        model.density,
    )
    seen, muons = _observe(
        lines, opacity, stations, aperture, physics, campaign, part(progress, 0.0, _COUNTED)
    )
    found = reconstruct_volume(seen, choices, part(progress, _COUNTED, 1.0))
    return known_result(found, truth, bodies, shares, muons)


def known_result(
    found: Tomography,
    truth: np.ndarray,
    bodies: Sequence[PlacedBody],
    shares: Sequence[np.ndarray],
    muons: float,
) -> KnownModelResult:
    """Return how near a tomography is to what was to be found.

    Parameters
    ----------
    found
        The tomography.
    truth
        (east, north, up) g/cm³, NaN where there is no unknown.
    bodies, shares
        What is in the rock, and which share of each voxel.
    muons
        Muons counted.
    """
    values = found.density.values
    known = np.isfinite(values) & np.isfinite(truth)
    off = values[known] - truth[known]
    return KnownModelResult(
        found,
        found.density.with_values("density", truth),
        tuple(_found(body, share, shares, values, truth) for body, share in zip(bodies, shares)),
        relative_error(values, truth),
        float(off.std()),
        float(off.mean()),
        muons,
    )


def _truth(lines: Sightlines, density: np.ndarray, dem: Dem) -> np.ndarray:
    """Return what a perfect reconstruction would find, NaN where there is no unknown."""
    if lines.paths.column is not None:
        return np.where(lines.lattice.active, density, np.nan)
    # Voxels that are partly air are thinner rock where the terrain is not known.
    ground = ground_below(lines.grid, lines.frame, dem)
    return density * rock_fraction(lines.paths.grid, ground)


def check_bodies(
    bodies: Sequence[PlacedBody],
    shares: Sequence[np.ndarray],
    truth: np.ndarray,
    lines: Sightlines,
) -> None:
    """Refuse a body that is outside the rock of the volume.

    Raises
    ------
    MuyscError
        If one is.
    """
    grid = lines.grid
    for body, share in zip(bodies, shares):
        if not np.any(share[np.nan_to_num(truth) > 0] > 0):
            raise MuyscError(
                f"The body “{body.name}” is outside the rock of the volume (x "
                f"{grid.origin_m[0]:.7g} to {grid.end_m[0]:.7g}, y {grid.origin_m[1]:.7g} to "
                f"{grid.end_m[1]:.7g} in {lines.frame.crs.name}, {grid.origin_m[2]:g} to "
                f"{grid.end_m[2]:g} m high); move it, or change extent, base and top."
            )


def _contrast_along(
    lines: Sightlines, bodies: Sequence[PlacedBody], rock_density: float, dem: Dem
) -> np.ndarray:
    """Return what the bodies add along each ray, g/cm³ m."""
    grid, rays = lines.paths.grid, lines.paths.rays
    if not bodies:
        return np.zeros(len(rays))
    finer = _FINER if grid.count * _FINER**3 <= _MOST_FINE else 1
    east, north, up = (size / finer for size in grid.size_m)
    n_east, n_north, n_up = (count * finer for count in grid.shape)
    fine = VoxelGrid(grid.origin_m, (east, north, up), (n_east, n_north, n_up))
    rock = lines.paths.stretches
    if lines.paths.column is None:
        rock = rock_along(grid, rays, ground_below(lines.grid, lines.frame, dem))
    contrast = density_in(fine, bodies, rock_density)[0] - rock_density
    return RecomputedPaths(paths_through(fine, rays, rock)).forward(contrast.ravel()).astype(float)


def _observe(
    lines: Sightlines,
    opacity: np.ndarray,
    stations: Sequence[Station],
    aperture: Aperture,
    physics: Physics,
    campaign: Campaign,
    progress: Progress,
) -> tuple[Sightlines, float]:
    """Return the lines with what is seen along them, and the muons counted."""
    exact = [
        data.with_opacity(values, None)
        for data, values in zip(lines.stations, lines.per_pixel(opacity))
    ]
    if not campaign.noise:
        return replace(lines, stations=tuple(exact)), float("nan")
    generator = np.random.default_rng(campaign.seed)
    counted = [
        count_muons(
            data, station, thickness, aperture, physics, campaign, generator,
            part(progress, number / len(exact), (number + 1) / len(exact)),
        )
        for number, (data, station, thickness) in enumerate(
            zip(exact, stations, lines.per_pixel(lines.thickness_m))
        )
    ]  # fmt: skip
    pixels = sum(one.pixels for one in counted)
    if not pixels:
        raise MuyscError(
            f"No muon is counted behind the rock of the volume in {campaign.days:g} days; count "
            "longer, or use a larger acceptance or pixels."
        )
    return (
        replace(lines, stations=tuple(one.data for one in counted)),
        sum(one.muons for one in counted),
    )


def _found(
    body: PlacedBody,
    share: np.ndarray,
    shares: Sequence[np.ndarray],
    values: np.ndarray,
    truth: np.ndarray,
) -> BodyFound:
    """Return what is found of a body against the rock that is in none."""
    rock = np.nan_to_num(truth) > 0
    inside = rock & (share >= min(_INSIDE, share[rock].max()))
    others = np.sum(shares, axis=0) - share > 0
    seen = inside & np.isfinite(values)
    try:
        contrast = contrast_recovered(np.where(others & ~inside, np.nan, values), truth, inside)
    except MuyscError:
        # No ray passes it, or it is as dense as the rock around.
        contrast = float("nan")
    return BodyFound(
        body.name, int(np.count_nonzero(inside)), int(np.count_nonzero(seen)), contrast
    )
