"""Can this survey see it, in counts: the telescopes' own trajectories, several draws, a verdict.

What is counted comes from finer sub-rays and smaller voxels than what is fitted, behind factors,
boresights and terrain that are off as the priors say they may be.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, part, report, silent
from ..radiography.aperture import Aperture
from ..radiography.settings import Physics
from ..telescope.directions import Pointing
from ..tomography.counting import CountPriors
from ..tomography.counting.fit import fit_uniform
from ..tomography.counting.score import ScoreTest, elsewhere
from ..topography.dem import Dem
from .count_lines import CountLines, CountStation, lay_counts, taken, with_counts
from .count_tomography import CountChoices, fit_laid
from .known_model import KnownModel, density_in
from .reconstruction_test import KnownModelResult, check_bodies, known_result
from .simulated_counts import Campaign
from .sites import Station
from .volume_plan import VolumePlan

if TYPE_CHECKING:
    from pyproj import CRS

#: Times as many sub-rays along each side, and voxels, in what is counted as in what is fitted;
#: and the most voxels of the former.
_FINER_RAYS, _FINER_VOXELS, _MOST_FINE = 1.6, 2, 2_000_000

#: Places at which a body is looked for, at most.
_MOST_PLACES = 300

#: Standard errors, among all places, from which on a body counts as seen: chance does as much in
#: one of twenty surveys.
_SEEN = 1.645

#: Contrast (g/cm³) and radius over the correlation length of what is looked for without a body.
_LIGHT, _OF_LENGTH = -0.5, 0.5

#: Shares of the progress bar.
_LAID = 0.5


@dataclass(frozen=True)
class Verdict:
    """Whether a survey sees a body, over several draws of what it counts."""

    draws: int
    #: Standard errors of the body at its place, and what they are worth among all places; means,
    #: NaN without a body.
    significance: float
    overall: float
    #: Number of places that are independent of each other.
    places: float
    #: Share of draws in which the body is seen; and of draws of a mountain without it in which one
    #: is seen somewhere.
    seen: float
    false_alarms: float
    #: Contrast over the true one, mean and standard deviation over the draws.
    contrast: float
    contrast_spread: float
    #: Mean distance (m) from the body to where the score is largest.
    place_m: float
    chi_squared: float

    @property
    def text(self) -> str:
        """The verdict in a sentence or two."""
        draws = f"{self.draws} draw{'s' if self.draws > 1 else ''}"
        alarms = f"{100 * self.false_alarms:.0f} %"
        if not np.isfinite(self.significance):
            return (
                f"There is no body, and one is seen somewhere in {alarms} of {draws}; χ² is "
                f"{self.chi_squared:.3g} per datum."
            )
        return (
            f"This survey {'can' if self.seen > 0.5 else 'cannot'} see the body: "
            f"{self.significance:.1f} standard errors ({self.overall:.1f} among "
            f"{self.places:.0f} places), seen in {100 * self.seen:.0f} % of {draws}, the largest "
            f"signal {self.place_m:.0f} m from its middle; {100 * self.contrast:.0f} ± "
            f"{100 * self.contrast_spread:.0f} % of its contrast is found. Without it, one is "
            f"seen somewhere in {alarms}."
        )


def telescopes_at(
    stations: Sequence[Station],
    aperture: Aperture,
    physics: Physics,
    campaign: Campaign,
    efficiency: float = 1.0,
) -> list[CountStation]:
    """Return telescopes that have counted nothing yet.

    They count along their own trajectories, or in the pixels of a field of view where no
    telescope is chosen.

    Parameters
    ----------
    stations, aperture
        Where they stand and look.
    physics, campaign
        How muons are stopped, how long is counted and with what.
    efficiency
        Share of the muons that are counted.
    """
    if not 0 < efficiency <= 1:
        raise MuyscError(
            f"An efficiency of {efficiency:g} is impossible; give one above 0 and up to 1."
        )
    own, result = campaign.telescope.trajectories, []
    for station in stations:
        sight = station.sight
        azimuth, elevation = aperture.directions(
            sight.boresight_azimuth_deg, sight.boresight_elevation_deg
        )
        collected = np.full(
            (len(elevation), len(azimuth)), campaign.telescope.acceptance_cm2_sr
        ) if own is None else own.acceptance_cm2_sr  # fmt: skip
        around = (sight.boresight_azimuth_deg + 180.0) % 360.0 - 180.0
        result.append(
            CountStation(
                station.site.name, *sight.detector_wgs84, sight.detector_elevation_m,
                np.zeros(collected.shape), collected * campaign.days * efficiency, physics, own,
                None if own is None else Pointing(around, sight.boresight_elevation_deg),
                azimuth_deg=azimuth if own is None else None,
                elevation_deg=elevation if own is None else None,
                target=(*sight.target_wgs84, sight.target_elevation_m),
            )
        )  # fmt: skip
    return result


def judge_survey(
    stations: Sequence[CountStation],
    dem: Dem,
    plan: VolumePlan,
    model: KnownModel,
    campaign: Campaign,
    choices: CountChoices,
    draws: int = 3,
    crs: CRS | None = None,
    progress: Progress = silent,
) -> KnownModelResult:
    """Return what a survey finds of a known model in its first draw, and the verdict over all.

    Parameters
    ----------
    stations
        Telescopes (`telescopes_at`).
    dem, plan, crs
        Terrain and volume.
    model
        What is to be found.
    campaign
        Seed, and whether counts are drawn at all.
    choices
        How densities are found; factors, boresights and terrain are drawn from its priors.
    draws
        Number of surveys.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If a value cannot be used, or a body is outside the rock of the volume.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    if draws < 1:
        raise MuyscError(f"{draws} draws show nothing; give 1 or more.")
    priors = replace(choices.priors, mean=model.density)
    choices = replace(choices, reference_density=model.density, priors=priors)
    laid, fine = _laid(stations, dem, plan, choices, crs, part(progress, 0.0, _LAID))
    metric = laid.lines.paths.grid
    bodies = model.bodies(laid.lines.frame, metric)
    density, shares = density_in(metric, bodies, model.density)
    active = laid.lines.lattice.active
    truth = np.where(active, density, np.nan)
    check_bodies(bodies, shares, truth, laid.lines)
    places = _Places.of(laid, priors, density[active] - model.density)
    finer = density_in(fine.lines.paths.grid, bodies, model.density)[0][fine.lines.lattice.active]
    mountains = [_Mountain.of(fine, values, model.density) for values in
                 (finer, np.full(finer.shape, model.density))]  # fmt: skip
    results, rows = [], []
    for draw in range(draws):
        report(progress, _LAID + (1 - _LAID) * draw / draws)
        generator = np.random.default_rng(campaign.seed + draw)
        body, empty = (one.counts(fine, priors, generator, campaign.noise) for one in mountains)
        own = choices if draw == 0 else replace(choices, errors=False)
        found = fit_laid(stations, with_counts(laid, body), own)
        results.append(known_result(found.tomography, truth, bodies, shares, float(body.sum())))
        scores = places.scores(laid, priors, body)
        alarm = places.scores(laid, priors, empty)[1]
        rows.append((*scores, alarm, found.fit.chi_squared))
    report(progress, 1.0)
    own_score, _, place, alarms, chi = np.array(rows).T
    overall = np.array([elsewhere(one, places.count) for one in own_score])
    contrast = np.array([one.contrast for one in results])
    has_body = bool(bodies)
    verdict = Verdict(
        draws,
        float(own_score.mean()) if has_body else float("nan"),
        float(overall.mean()) if has_body else float("nan"),
        places.count,
        float(np.mean(overall > _SEEN)) if has_body else float("nan"),
        float(np.mean([elsewhere(one, places.count) > _SEEN for one in alarms])),
        float(contrast.mean()),
        float(contrast.std()),
        float(place.mean()) if has_body else float("nan"),
        float(chi.mean()),
    )
    return replace(results[0], verdict=verdict)


def _laid(
    stations: Sequence[CountStation],
    dem: Dem,
    plan: VolumePlan,
    choices: CountChoices,
    crs: CRS | None,
    progress: Progress,
) -> tuple[CountLines, CountLines]:
    """Return what is fitted, and what is counted with finer rays and voxels, of the same data."""
    length = choices.priors.terrain_length_m if choices.priors.terrain_m > 0 else None
    laid = lay_counts(
        stations, dem, plan, crs, choices.length_error_m, length, choices.memory_bytes,
        progress=part(progress, 0.0, 0.3),
    )  # fmt: skip
    grid = laid.lines.grid
    (west, south, base), (east, north, top) = grid.origin_m, grid.end_m
    times = _FINER_VOXELS if grid.count * _FINER_VOXELS**3 <= _MOST_FINE else 1
    finer = VolumePlan((west, east, south, north), grid.size_m[0] / times, None, base, top)
    fine = lay_counts(
        stations, dem, finer, laid.lines.frame.crs, 0.0, length, choices.memory_bytes,
        _FINER_RAYS, part(progress, 0.3, 1.0),
    )  # fmt: skip
    both = np.intersect1d(laid.pixel, fine.pixel)
    return (
        taken(laid, np.searchsorted(laid.pixel, both)),
        taken(fine, np.searchsorted(fine.pixel, both)),
    )


@dataclass(frozen=True)
class _Mountain:
    """What is expected of one mountain, and how that changes with boresights and terrain."""

    expected: np.ndarray
    turned: np.ndarray | None
    tilted: np.ndarray | None
    terrain: Any

    @classmethod
    def of(cls, fine: CountLines, densities: np.ndarray, mean: float) -> _Mountain:
        line = fine.model.at(densities, mean)
        return cls(line.expected, line.turned, line.tilted, line.terrain)

    def counts(
        self, fine: CountLines, priors: CountPriors, generator: np.random.Generator, noise: bool
    ) -> np.ndarray:
        """Return counts of one draw, as expected where there is no noise."""
        if not noise:
            return self.expected
        station = fine.model.station

        def each(deviation: float) -> np.ndarray:
            return deviation * generator.standard_normal(fine.model.stations)[station]

        change = each(priors.station) + priors.flux * generator.standard_normal()
        if self.turned is not None:
            change = change + each(priors.azimuth_deg) * self.turned
        if self.tilted is not None:
            change = change + each(priors.elevation_deg) * self.tilted
        ground = fine.model.ground
        if ground is not None and self.terrain is not None:
            covariance = ground.covariance(priors.terrain_m, priors.terrain_length_m)
            off = covariance.root(generator.standard_normal(covariance.root_size))
            change = change + self.terrain @ off
        return generator.poisson(self.expected * np.exp(np.clip(change, -5, 5))).astype(float)


@dataclass(frozen=True)
class _Places:
    """A body at its place, and balls as large at many others."""

    #: (n_unknowns, 1 + n_places) contrast of each, g/cm³; the body comes first.
    contrasts: np.ndarray
    #: (n_places,) distance of the balls from the body, m.
    distance_m: np.ndarray
    #: Number of places that are independent of each other.
    count: float

    @classmethod
    def of(cls, laid: CountLines, priors: CountPriors, contrast: np.ndarray) -> _Places:
        """Return the places for a body's contrast in each voxel, g/cm³."""
        grid, model = laid.lines.paths.grid, laid.model
        centres = grid.all_centres_m()[laid.lines.lattice.active.ravel()]
        line = model.at(np.full(model.lattice.count, priors.mean), priors.mean)
        seen = np.flatnonzero(np.asarray(abs(line.voxels).sum(axis=0)).ravel() > 0)
        weight = np.abs(contrast)
        if weight.any():
            size = grid.volume_m3 * float(weight.sum() / weight.max())
            light = float(contrast @ weight / weight.sum())
            middle = weight @ centres / weight.sum()
            radius = (0.75 * size / np.pi) ** (1 / 3)
        else:
            radius, light = _OF_LENGTH * priors.length_m, _LIGHT
            middle = centres[seen].mean(axis=0)
            contrast = np.where(np.linalg.norm(centres - middle, axis=1) < radius, light, 0.0)
        radius = max(radius, 0.6 * float(np.cbrt(grid.volume_m3)))
        chosen = centres[seen[:: max(1, len(seen) // _MOST_PLACES)]]
        balls = [light * (np.linalg.norm(centres - one, axis=1) < radius) for one in chosen]
        return cls(
            np.column_stack([contrast, *balls]),
            np.linalg.norm(chosen - middle, axis=1),
            max(1.0, len(seen) * grid.volume_m3 / (4 / 3 * np.pi * radius**3)),
        )

    def scores(
        self, laid: CountLines, priors: CountPriors, counts: np.ndarray
    ) -> tuple[float, float, float]:
        """Return the score of the body, the largest of the balls, and how far off that is (m)."""
        uniform = fit_uniform(with_counts(laid, counts).model, priors)
        test = ScoreTest.of(uniform.space, uniform.voxels @ self.contrasts)
        scores = test.scores(uniform.residual)
        largest = int(np.argmax(scores[1:]))
        return float(scores[0]), float(scores[1 + largest]), float(self.distance_m[largest])
