"""From what several stations counted to the densities of a volume.

The data flow one way: counts → sub-rays of each trajectory → rock along them → volume → model of
the counts → densities. `tomography` goes from opacities instead, one ray a pixel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, part, silent
from ..tomography.counting import COUNTS, Band, CountFit, CountPriors, fit_counts
from ..tomography.projector import MEMORY_LIMIT
from ..tomography.solvers import Reconstruction
from ..topography.dem import Dem
from ..volume import Volume
from .count_lines import CountLines, CountStation, lay_counts
from .count_warnings import warnings_of
from .tomography_result import Place, StationResidual, Tomography, target_of

if TYPE_CHECKING:
    from pyproj import CRS

    from .volume_plan import VolumePlan

#: Most steps, and most iterations within each.
STEPS, INNER = 6, 300

#: Mean density (g/cm³) before any muon, where nothing is given.
_ROCK = 2.65


@dataclass(frozen=True)
class CountChoices:
    """What the user decides on the way from counts to densities."""

    #: Before any muon; its mean is replaced by that of the stations' rock where it is None.
    reference_density: float | None = None
    priors: CountPriors = field(default_factory=lambda: CountPriors(_ROCK))
    #: Error (m) of lengths in rock that trajectories do not share.
    length_error_m: float = 0.0
    inner: int = INNER
    #: Whether errors of the densities are wanted.
    errors: bool = False
    memory_bytes: int = MEMORY_LIMIT


@dataclass(frozen=True)
class CountTomography:
    """Densities of a volume, and what else was estimated from counts."""

    tomography: Tomography
    fit: CountFit
    laid: CountLines
    stations: tuple[CountStation, ...]

    def station_name(self, band: Band) -> str:
        """Return whose a number is."""
        return "all" if band.station < 0 else self.stations[band.station].name

    def residuals(self) -> list[np.ndarray]:
        """Return (n − μ)/σ of each station's pixels, NaN where they are not used."""
        return self.laid.per_station(self.fit.residuals(self.laid.model.counts))


def count_tomography(
    stations: Sequence[CountStation],
    dem: Dem,
    plan: VolumePlan,
    choices: CountChoices,
    crs: CRS | None = None,
    progress: Progress = silent,
) -> CountTomography:
    """Return the densities that explain what several stations counted.

    Parameters
    ----------
    stations
        Counts by trajectory or pixel of each, 0 among them.
    dem, plan, crs
        As in `tomography`.
    choices
        What is known before, and what is wanted.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If a value cannot be used or the counts say nothing about the volume.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    priors = choices.priors
    laid = lay_counts(
        stations, dem, plan, crs, choices.length_error_m,
        priors.terrain_length_m if priors.terrain_m > 0 else None, choices.memory_bytes,
        progress=part(progress, 0.0, 0.6),
    )  # fmt: skip
    return fit_laid(stations, laid, choices, part(progress, 0.6, 1.0))


def fit_laid(
    stations: Sequence[CountStation],
    laid: CountLines,
    choices: CountChoices,
    progress: Progress = silent,
) -> CountTomography:
    """Return the densities that explain counts whose sub-rays are laid.

    Parameters
    ----------
    stations, choices, progress
        As in `count_tomography`.
    laid
        Their sub-rays (`lay_counts`).

    Raises
    ------
    MuyscError
        If a value cannot be used or the counts say nothing about the volume.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    if not np.any(laid.rock_share > 0):
        raise MuyscError(
            f"All {laid.model.size} trajectories see only sky; point telescopes at the mountain, "
            "or check where the detectors stand."
        )
    mean = choices.reference_density
    if mean is None:
        mean = float(np.mean([one.physics.density for one in stations]))
    priors = replace(choices.priors, mean=mean)
    fit = fit_counts(laid.model, priors, STEPS, choices.inner, choices.errors, progress)
    return CountTomography(_result(stations, laid, fit), fit, laid, tuple(stations))


def _result(stations: Sequence[CountStation], laid: CountLines, fit: CountFit) -> Tomography:
    """Put everything back on the map."""
    lines, model = laid.lines, laid.model
    line = model.at(fit.densities, fit.mean)
    sees = line.voxels.copy()
    sees.data = np.ones_like(sees.data)
    # Sub-rays are many; what crosses a voxel is told by trajectories.
    coverage = np.asarray(sees.sum(axis=0)).ravel()
    seen = coverage > 0
    metadata: dict[str, str | float] = {
        "METHOD": COUNTS,
        "ITERATIONS": float(fit.iterations),
        "REFERENCE_DENSITY": fit.mean,
        "STATIONS": float(len(stations)),
        "RAYS": float(model.size),
        "TERRAIN_MASK": "yes",
    }
    crs = lines.frame.crs.to_wkt()

    def volume(quantity: str, values: np.ndarray) -> Volume:
        return Volume(quantity, lines.grid, model.lattice.expand(values), crs, metadata)

    opacity, slope = _opacities(laid, fit)
    off = np.where(slope < 0, (model.counts / fit.expected - 1) / np.minimum(slope, -1e-12), np.nan)
    relative_error = np.sqrt(fit.variance) / fit.expected
    with np.errstate(divide="ignore"):
        weight = np.where(slope < 0, (slope / relative_error) ** 2, 0.0)
    residuals = tuple(
        _residual(one.name, model.station == number, laid, fit, off, opacity, weight)
        for number, one in enumerate(stations)
    )
    found = Reconstruction(
        fit.densities, fit.iterations, "converged" if fit.converged else "iterations",
        np.sqrt(fit.history), deviation=fit.deviation,
    )  # fmt: skip
    everything = _residual("all", np.ones(model.size, bool), laid, fit, off, opacity, weight)
    return Tomography(
        density=volume("density", np.where(seen, fit.densities, np.nan)),
        coverage=volume("coverage", coverage),
        deviation=(
            None
            if fit.deviation is None
            else volume("density_error", np.where(seen, fit.deviation, np.nan))
        ),
        reconstruction=found,
        method=COUNTS,
        reference_density=fit.mean,
        stations=tuple(
            Place(one.name, *lines.frame.place(one.longitude, one.latitude), one.elevation_m)
            for one in stations
        ),
        target=target_of(lines),
        residuals=residuals,
        relative_residual=everything.relative,
        rays=model.size,
        chi_squared=fit.chi_squared,
        rock_voxels=model.lattice.count,
        unseen_voxels=int(np.count_nonzero(~seen)),
        lost=laid.lost,
        warnings=tuple(warnings_of(stations, laid, fit, fit.densities[seen])),
    )


def _opacities(laid: CountLines, fit: CountFit) -> tuple[np.ndarray, np.ndarray]:
    """Return the mean opacity along each trajectory (g/cm²), and ∂ ln μ over it."""
    model = laid.model
    opacity = model.opacity(fit.densities, fit.mean)
    flux, fall = model.flux(opacity)
    mean = model.weights @ flux
    return model.weights @ opacity, (model.weights @ fall) / np.maximum(mean, 1e-300)


def _residual(
    name: str, which: np.ndarray, laid: CountLines, fit: CountFit, off: np.ndarray,
    opacity: np.ndarray, weight: np.ndarray,
) -> StationResidual:  # fmt: skip
    """Return what is left of some data: opacities weighed by what the counts say of them."""
    counts, rock = laid.model.counts, which & (weight > 0) & (laid.rock_share > 0)
    square = float("nan")
    if which.any():
        square = float(np.mean((counts - fit.expected)[which] ** 2 / fit.variance[which]))
    if not rock.any():
        return StationResidual(name, int(which.sum()), np.nan, np.nan, np.nan, square)
    mean = float(np.average(off[rock], weights=weight[rock]))
    rms = float(np.sqrt(np.average(off[rock] ** 2, weights=weight[rock])))
    size = float(np.sqrt(np.average(opacity[rock] ** 2, weights=weight[rock])))
    return StationResidual(
        name, int(which.sum()), mean, rms, rms / size if size > 0 else np.nan, square
    )
