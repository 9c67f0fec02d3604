"""What a place is worth for a telescope: one radiography, and what it says of the target.

Every candidate is a `simulate` of its own, so that its numbers are those that a
radiography from there gives. The target is a body of rock, sampled by points of
equal volume; each takes what the pixel in its direction holds.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, silent
from ..radiography.counting import check_positive
from ..survey.body import TargetBody, target_body
from ..survey.held_dem import held_dem, hold
from ..survey.job import Compute, Job
from ..topography.dem import Dem
from ..topography.frame import local_frame
from ..topography.profiles import PATH_STEP_M
from ..topography.sight import take_sight
from .view_settings import ViewSettings

#: Name under which workers find `prepare`.
_FUNCTION = "workflows.site_assessment:prepare"

_CANDIDATES = "candidates"
_BODY = "body_"


@dataclass(frozen=True)
class SurveyPlan:
    """What is looked at from every candidate, and what counts as seeing it.

    Raises
    ------
    MuyscError
        If a number cannot be used.
    """

    dem: Dem
    #: (x, y) in the DEM's CRS.
    target: tuple[float, float]
    #: Above ground.
    target_height_m: float
    detector_height_m: float
    #: What each candidate looks with.
    view: ViewSettings
    #: Radius of the target body, and its depth below the ground at the target.
    radius_m: float = 300.0
    depth_m: float = 300.0
    #: Rock in m, from and to, through which a part of the body is seen.
    thickness_from_m: float = 50.0
    thickness_to_m: float = 1000.0
    #: Days of the campaign.
    days: float = 100.0

    def __post_init__(self) -> None:
        check_positive(self.days, "number of days of the campaign")
        if not 0 <= self.thickness_from_m < self.thickness_to_m < np.inf:
            raise MuyscError(
                f"Thicknesses from {self.thickness_from_m:g} to {self.thickness_to_m:g} m leave "
                "nothing; give a first one of 0 m or more and a larger second one."
            )

    def body(self) -> TargetBody:
        """Return the target body."""
        return target_body(self.dem, self.target, self.radius_m, self.depth_m)


@dataclass(frozen=True)
class Assessment:
    """What a candidate is worth. All numbers but the score are NaN where nothing is known."""

    #: Median days, over the part of the body that is seen, until a pixel has the muons wanted.
    exposure_days: float
    #: Share of the body's volume seen through rock between the two thicknesses, 0 to 1.
    share_seen: float
    #: Median, smallest and largest thickness of rock on the way through the body (m).
    thickness_m: float
    smallest_thickness_m: float
    largest_thickness_m: float
    #: Share of the pixels that see only sky, 0 to 1.
    free_sky: float
    #: Share of the body's volume behind pixels whose rock is unknown, 0 to 1.
    unknown: float
    #: Mean over the body of T/(T + d) where it is seen and 0 elsewhere: T days of the campaign,
    #: d days until the pixel has its muons.
    score: float
    detector_elevation_m: float


#: Names of the numbers in the order in which workers send them.
NUMBERS = tuple(field.name for field in fields(Assessment))


def assess(
    plan: SurveyPlan,
    body: TargetBody,
    position: tuple[float, float],
    progress: Progress = silent,
) -> Assessment:
    """Return what a candidate at a position of the DEM's CRS is worth.

    Parameters
    ----------
    plan, body
        What is looked at, and what of it matters.
    position
        (x, y) in the DEM's CRS.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If the candidate cannot be used.
    Cancelled
        If `progress` asks for a stop.
    """
    sight = take_sight(
        plan.dem, position, plan.target, plan.detector_height_m, plan.target_height_m
    )
    simulation = plan.view.simulate(sight, progress)
    thickness = simulation.muograms["thickness"]
    pixel = thickness.pixel_of(*body.seen_from(sight.frame, sight.detector_elevation_m))
    inside = pixel >= 0
    rock = np.where(inside, thickness.values.ravel()[pixel], 0.0)
    days = np.where(inside, simulation.muograms["exposure"].values.ravel()[pixel], np.nan)
    known = np.isfinite(days)
    seen = known & (rock >= plan.thickness_from_m) & (rock <= plan.thickness_to_m)
    behind = known & (rock > 0)
    sky = np.count_nonzero(simulation.muograms["flux"].values[thickness.values == 0] > 0)
    return Assessment(
        _known(np.median, days[seen]),
        float(np.mean(seen)),
        _known(np.median, rock[behind]),
        _known(np.min, rock[behind]),
        _known(np.max, rock[behind]),
        sky / thickness.values.size,
        float(np.mean(np.isnan(rock))),
        float(np.sum(plan.days / (plan.days + days[seen])) / len(seen)),
        sight.detector_elevation_m,
    )


def _known(summary: Callable[[np.ndarray], Any], values: np.ndarray) -> float:
    """Return what sums up some values, NaN where there are none."""
    return float(summary(values)) if values.size else float("nan")


def survey_job(plan: SurveyPlan, candidates: np.ndarray) -> Job:
    """Return the assessment of candidates as work that can be handed out.

    Parameters
    ----------
    plan
        What is looked at.
    candidates
        (n, 2) positions in the DEM's CRS.

    Raises
    ------
    MuyscError
        If the target is off the DEM, or the terrain does not fit into memory.
    """
    held, arrays = hold(plan.dem, _window(plan, candidates))
    body = plan.body()
    plain = {
        field.name: getattr(plan, field.name)
        for field in fields(plan)
        if field.name not in ("dem", "view")
    }
    array = {f"{_BODY}{field.name}": getattr(body, field.name) for field in fields(body)}
    return Job(
        _FUNCTION,
        {
            "dem": held,
            "view": plan.view.plain(),
            "plan": {**plain, "target": list(plan.target)},
        },
        {**arrays, **array, _CANDIDATES: np.asarray(candidates, float)},
        len(candidates),
    )


def prepare(settings: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Compute:
    """Return what assesses a candidate by its number, from what `survey_job` gave away.

    It returns the numbers in the order of `NUMBERS`, or the sentence that says why the
    candidate cannot be used.
    """
    plan = SurveyPlan(
        dem=held_dem(settings["dem"], arrays),
        view=ViewSettings.of(settings["view"]),
        **{**settings["plan"], "target": tuple(settings["plan"]["target"])},
    )
    body = TargetBody(*(arrays[f"{_BODY}{field.name}"] for field in fields(TargetBody)))

    def compute(item: int, progress: Progress) -> list[float] | str:
        x, y = arrays[_CANDIDATES][item]
        try:
            assessment = assess(plan, body, (float(x), float(y)), progress)
        except MuyscError as error:
            return str(error)
        return [float(getattr(assessment, name)) for name in NUMBERS]

    return compute


def _window(plan: SurveyPlan, candidates: np.ndarray) -> tuple[int, int, int, int]:
    """Return first column and row and the size of the terrain that rays from candidates reach."""
    dem = plan.dem
    if plan.view.max_range_m is None or dem.wraps:
        return 0, 0, dem.columns, dem.rows
    column, row = dem.grid_position(candidates[:, 0], candidates[:, 1])
    extremes = {int(np.argmin(column)), int(np.argmax(column)), int(np.argmin(row)),
                int(np.argmax(row))}  # fmt: skip
    # Profiles are laid in whole steps, so they read a little more than the range.
    reach = 1.01 * plan.view.max_range_m + 2 * PATH_STEP_M
    far = [dem.grid_position(*plan.target)]
    for index in extremes:
        frame = local_frame(dem, float(candidates[index, 0]), float(candidates[index, 1]), "site")
        far.append(frame.ground_positions(np.arange(0.0, 360.0, 5.0), reach))
    far_columns, far_rows = (
        np.concatenate([np.atleast_1d(one[axis]) for one in far]) for axis in (0, 1)
    )
    left, right = _clipped(far_columns, dem.columns)
    top, bottom = _clipped(far_rows, dem.rows)
    return left, top, right - left, bottom - top


def _clipped(positions: np.ndarray, cells: int) -> tuple[int, int]:
    """Return first and last + 1 of the cells that positions span, clipped to the raster."""
    first = int(np.clip(np.floor(positions.min()) - 1, 0, cells - 2))
    return first, int(np.clip(np.ceil(positions.max()) + 2, first + 2, cells))
