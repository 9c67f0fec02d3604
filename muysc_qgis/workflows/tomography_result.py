"""Densities of a volume, how well they explain the data, and what to say about them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..tomography.counting import COUNTS, COUNTS_TITLE
from ..tomography.solvers import METHODS, Reconstruction
from ..tomography.system import System
from ..tomography.voxels import VoxelGrid
from ..volume import Volume
from .sightlines import Sightlines

#: Share of the rays of the busiest slice that the target's own must have to be shown first.
_SHOWN = 0.25

#: Share of the voxels within a colour scale, and its least half width, g/cm³.
_COLOURED, _LEAST_WIDTH = 0.98, 0.05


@dataclass(frozen=True)
class Place:
    """A point on the map."""

    name: str
    #: In the CRS of the volume.
    x: float
    y: float
    #: Height, m.
    z: float


@dataclass(frozen=True)
class StationResidual:
    """What a reconstruction leaves unexplained of one station."""

    name: str
    rays: int
    #: Of data minus model, in opacity, g/cm².
    mean: float
    rms: float
    #: RMS over the RMS of the opacity inside the volume; NaN where that is 0.
    relative: float
    #: Square of residuals over their errors for each independent datum; NaN where errors are
    #: unknown.
    chi_squared: float


@dataclass(frozen=True)
class Tomography:
    """Densities of a volume, how they were reached, and what to say about them."""

    #: Density (g/cm³), rays per voxel, and posterior standard deviation where the method has one;
    #: NaN in air and, but for the rays, where no ray passes.
    density: Volume
    coverage: Volume
    deviation: Volume | None
    reconstruction: Reconstruction
    method: str
    reference_density: float
    stations: tuple[Place, ...]
    target: Place | None
    residuals: tuple[StationResidual, ...]
    #: ‖data − model‖ over ‖data‖ of the opacities inside the volume.
    relative_residual: float
    rays: int
    #: Square of residuals over their errors for each independent datum, 1 for a perfect fit; NaN
    #: where errors are not known.
    chi_squared: float
    #: Voxels with rock, and those of them that no ray passes.
    rock_voxels: int
    unseen_voxels: int
    #: Pixels that say nothing, by cause.
    lost: Mapping[str, int]
    #: One sentence each.
    warnings: tuple[str, ...]

    @property
    def grid(self) -> VoxelGrid:
        """The voxels in the CRS of the volume."""
        return self.density.grid

    @property
    def method_title(self) -> str:
        """What the method is called in texts."""
        return COUNTS_TITLE if self.method == COUNTS else METHODS[self.method].title

    @property
    def mask(self) -> bool:
        """Whether the terrain was known, so that all voxels hold rock."""
        return self.density.metadata.get("TERRAIN_MASK") != "no"

    @property
    def mean_density(self) -> float:
        """Mean of the voxels with a density, g/cm³."""
        return float(self.density.values[self.density.known].mean())

    @property
    def shown_level(self) -> int:
        """Number of the slice to show first: the target's, else the one with most rays."""
        rays = np.nansum(self.coverage.values, axis=(0, 1))
        low, high = self.grid.origin_m[2], self.grid.end_m[2]
        if self.target is not None and low <= self.target.z <= high:
            level = self.grid.level_at(self.target.z)
            if rays[level] >= _SHOWN * rays.max():
                return level
        return int(np.argmax(rays))

    @property
    def density_limits(self) -> tuple[float, float]:
        """Least and largest density of a colour scale, the reference in its middle."""
        values = self.density.values[self.density.known]
        off = np.abs(values - self.reference_density)
        width = float(np.quantile(off, _COLOURED)) if off.size else 0.0
        width = max(width, _LEAST_WIDTH)
        return self.reference_density - width, self.reference_density + width

    @property
    def seen_voxels(self) -> int:
        """Number of voxels with a density."""
        return self.rock_voxels - self.unseen_voxels


def result_of(
    lines: Sightlines,
    method: str,
    system: System,
    found: Reconstruction,
    reference: float,
    lost: Mapping[str, int],
    warnings: Sequence[str],
    share: np.ndarray | None = None,
) -> Tomography:
    """Put everything back on the map.

    Parameters
    ----------
    lines
        Stations, their rays and the volume.
    method, system, found
        What was solved and how, and the densities (g/cm³) of the unknowns.
    reference
        Density (g/cm³) of the rock outside the volume.
    lost
        Pixels that say nothing, by cause.
    warnings
        One sentence each.
    share
        (n_rays,) share of an independent datum that each ray is; None for one each.
    """
    share = np.ones(len(system.data)) if share is None else share
    lattice = system.lattice
    rays = system.paths.coverage()
    seen = rays > 0
    metadata: dict[str, str | float] = {
        "METHOD": method,
        "ITERATIONS": found.iterations_done,
        "REFERENCE_DENSITY": reference,
        "STATIONS": float(len(lines.stations)),
        "RAYS": float(len(system.data)),
        "TERRAIN_MASK": "no" if lines.paths.column is None else "yes",
    }
    crs = lines.frame.crs.to_wkt()

    def volume(quantity: str, values: np.ndarray) -> Volume:
        return Volume(quantity, lines.grid, lattice.expand(values), crs, metadata)

    residual = system.data - system.paths.forward(found.values)
    return Tomography(
        density=volume("density", np.where(seen, found.values, np.nan)),
        coverage=volume("coverage", rays.astype(float)),
        deviation=(
            None
            if found.deviation is None
            else volume("density_error", np.where(seen, found.deviation, np.nan))
        ),
        reconstruction=found,
        method=method,
        reference_density=reference,
        stations=tuple(
            Place(one.name, *lines.frame.place(one.longitude, one.latitude), one.elevation_m)
            for one in lines.stations
        ),
        target=target_of(lines),
        residuals=tuple(_residuals(lines, system, residual, share)),
        relative_residual=_relative(residual, system.data),
        rays=len(system.data),
        chi_squared=_chi_squared(system, residual, share, slice(None)),
        rock_voxels=lattice.count,
        unseen_voxels=int(np.count_nonzero(~seen)),
        lost=lost,
        warnings=tuple(warnings),
    )


def target_of(lines: Sightlines) -> Place | None:
    """Return the middle of what the stations look at."""
    targets = [one.target for one in lines.stations if one.target is not None]
    if not targets:
        return None
    longitude, latitude, height = np.mean(targets, axis=0).tolist()
    return Place("target", *lines.frame.place(longitude, latitude), height)


def _residuals(
    lines: Sightlines, system: System, residual: np.ndarray, share: np.ndarray
) -> list[StationResidual]:
    rows = []
    for number, station in enumerate(lines.stations):
        which = np.flatnonzero(system.view == number)
        left = residual[which]
        rows.append(
            StationResidual(
                station.name,
                len(which),
                G_CM2_PER_M_WATER_EQUIVALENT * float(left.mean()) if which.size else np.nan,
                G_CM2_PER_M_WATER_EQUIVALENT * _rms(left),
                _relative(left, system.data[which]),
                _chi_squared(system, residual, share, which) if which.size else np.nan,
            )
        )
    return rows


def _chi_squared(
    system: System, residual: np.ndarray, share: np.ndarray, which: np.ndarray | slice
) -> float:
    """Return the sum of squares over errors, for each independent datum."""
    if system.errors is None:
        return np.nan
    square = np.sum((residual[which] / system.errors[which]) ** 2)
    return float(square / np.sum(share[which]))


#: χ² per datum above which the densities do not explain the data.
MOST_CHI_SQUARED = 1.5

#: Densities (g/cm³) of rock, and the share of voxels beyond them that is worth a word.
LEAST_DENSITY, MOST_DENSITY, _SHARE = 0.5, 3.5, 0.005


def warnings_after(result: Tomography) -> list[str]:
    """Return a sentence for each thing that the densities show to be wrong."""
    said = []
    if result.chi_squared > MOST_CHI_SQUARED:
        worst = max(result.residuals, key=lambda one: np.nan_to_num(one.chi_squared))
        more = ""
        if result.reconstruction.stopped_by == "iterations":
            more = ", and give more iterations, as these did not suffice"
        said.append(
            f"The densities do not explain the data (χ² is {result.chi_squared:.3g} per datum, "
            f"where 1 is perfect, and {worst.chi_squared:.3g} of {worst.name}): errors are too "
            "small, muograms contradict each other, or wide pixels see thin and thick rock at "
            f"once; check them, or fit counts (method counts){more}."
        )
    return said + beyond_rock(result.density.values[result.density.known], result.mask)


def beyond_rock(densities: np.ndarray, mask: bool = True) -> list[str]:
    """Return the sentence on densities that no rock has, none where air is among the voxels."""
    low, high = densities < LEAST_DENSITY, densities > MOST_DENSITY
    share = float(np.mean(low | high)) if len(densities) and mask else 0.0
    if share <= _SHARE:
        return []
    return [
        f"{100 * share:.2g} % of the voxels have densities beyond {LEAST_DENSITY} to "
        f"{MOST_DENSITY} g/cm³ ({densities.min():.3g} to {densities.max():.3g}), which are those "
        "of no rock: noise or a wrong terrain drives them; give a smaller deviation of the prior "
        "(PRIOR_DEVIATION), larger errors, or bounds."
    ]


def _relative(residual: np.ndarray, data: np.ndarray) -> float:
    """Return the size of the residuals as a share of the data's, NaN where all data are 0."""
    size = _rms(data)
    return _rms(residual) / size if size > 0 else np.nan


def _rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(np.square(values)))) if len(values) else np.nan
