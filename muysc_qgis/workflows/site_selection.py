"""Which of many places sees a target best: candidates, their worth, and the choice."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, silent
from ..survey.candidates import Candidates
from ..survey.choice import best_sites, check_width, telescope_set
from ..survey.run import Say, run_job, unheard
from ..topography.frame import transformed
from .site_assessment import NUMBERS, SurveyPlan, survey_job


@dataclass(frozen=True)
class Wanted:
    """How many sites to choose.

    Raises
    ------
    MuyscError
        If a number cannot be used.
    """

    #: Number of best sites, and how far (m) they are from each other at least.
    best: int = 10
    apart_m: float = 250.0
    #: Number of telescopes that go together.
    telescopes: int = 3
    #: Angle around the target up to which a telescope covers, None for 360°/telescopes.
    width_deg: float | None = None

    @property
    def width(self) -> float:
        """Angle around the target up to which a telescope covers, degrees."""
        return 360.0 / self.telescopes if self.width_deg is None else self.width_deg

    def __post_init__(self) -> None:
        if self.best < 1 or self.telescopes < 1:
            raise MuyscError(
                f"{self.best} best sites and {self.telescopes} telescopes leave nothing to choose; "
                "give at least 1 of each."
            )
        check_width(self.width)
        if not 0 <= self.apart_m < math.inf:
            raise MuyscError(
                f"Sites {self.apart_m:g} m apart are impossible; give a distance of 0 m or more."
            )


@dataclass(frozen=True)
class Selection:
    """Candidates with what each is worth, and those chosen."""

    candidates: Candidates
    #: (n,) by name in `site_assessment.NUMBERS`, NaN where unknown.
    numbers: Mapping[str, np.ndarray]
    #: Indices of the best candidates, best first.
    best: np.ndarray
    #: Indices of the telescopes that go together in the order of choice …
    telescopes: np.ndarray
    #: … and the mean coverage of the azimuths after each.
    coverage: np.ndarray
    #: Angle up to which each covers, degrees.
    width_deg: float
    warnings: tuple[str, ...]

    def map_of(self, number: str) -> np.ndarray:
        """Return one of `numbers` on the map, (rows, columns), NaN where there is no candidate.

        Of several candidates in one cell the best counts.
        """
        grid, values = self.candidates.grid, self.numbers[number]
        result = np.full(grid.rows * grid.columns, np.nan)
        # What is assigned last stays.
        order = np.argsort(np.nan_to_num(self.numbers["score"]), kind="stable")
        result[self.candidates.cell[order]] = values[order]
        return result.reshape(grid.rows, grid.columns)


def select_sites(
    plan: SurveyPlan,
    candidates: Candidates,
    wanted: Wanted,
    folder: Path,
    workers: int | None = None,
    scheduler: str = "",
    progress: Progress = silent,
    say: Say = unheard,
    warn: Say = unheard,
) -> Selection:
    """Assess all candidates and choose among them.

    Parameters
    ----------
    plan
        What is looked at from each.
    candidates
        Where telescopes may stand.
    wanted
        How many sites to choose.
    folder
        Where finished parts are kept until all is done, see `run_job`.
    workers, scheduler, progress, say, warn
        See `run_job`.

    Raises
    ------
    MuyscError
        If no candidate sees the target, or something cannot be computed.
    Cancelled
        If `progress` asks for a stop; finished parts are kept.
    """
    job = survey_job(plan, candidates.positions)
    results = run_job(job, folder, workers, scheduler, progress, say, warn)
    unusable = [result for result in results if isinstance(result, str)]
    unknown = [math.nan] * len(NUMBERS)
    table = np.array([unknown if isinstance(one, str) else one for one in results], float)
    numbers = dict(zip(NUMBERS, table.T))
    if len(unusable) == len(results):
        raise MuyscError(f"None of the {len(results)} candidates can be used: {unusable[0]}")
    if not np.any(numbers["score"] > 0):
        raise MuyscError(_unseen(plan, numbers))
    score = np.nan_to_num(numbers["score"])
    x, y = transformed(
        plan.dem.crs, candidates.grid.crs, candidates.x, candidates.y, by=plan.dem.transformation
    )
    telescopes, coverage = telescope_set(
        candidates.azimuth_deg, score, wanted.telescopes, wanted.width
    )
    return Selection(
        candidates,
        numbers,
        best_sites(score, x, y, wanted.best, wanted.apart_m),
        telescopes,
        coverage,
        wanted.width,
        tuple(_warnings(plan, numbers, unusable, wanted, len(telescopes))),
    )


def _unseen(plan: SurveyPlan, numbers: Mapping[str, np.ndarray]) -> str:
    """Return why no candidate sees the target."""
    thickness = numbers["thickness_m"][np.isfinite(numbers["thickness_m"])]
    if not thickness.size:
        found = "the body lies outside every field of view or behind unknown rock"
    else:
        found = (
            f"the median thickness of rock is {thickness.min():.0f} m at the least and "
            f"{thickness.max():.0f} m at the most"
        )
    return (
        f"None of the {len(numbers['score'])} candidates sees the target through "
        f"{plan.thickness_from_m:g} to {plan.thickness_to_m:g} m of rock: {found}; change these "
        "thicknesses, the target or the field of view."
    )


def _warnings(
    plan: SurveyPlan,
    numbers: Mapping[str, np.ndarray],
    unusable: list[str],
    wanted: Wanted,
    telescopes: int,
) -> list[str]:
    count = len(numbers["score"])
    said = [*plan.dem.doubts, *plan.view.telescope.notes]
    if unusable:
        often, _ = Counter(unusable).most_common(1)[0]
        said.append(f"{len(unusable)} of {count} candidates have no numbers: {often}")
    unknown = int(np.count_nonzero(numbers["unknown"] > 0))
    if unknown:
        said.append(
            f"From {unknown} of {count} candidates a part of the target lies behind rock that is "
            "unknown, because rays reach the DEM's edge or a gap in it; that part counts as not "
            "seen: use a larger DEM, or set a maximum range."
        )
    if telescopes < wanted.telescopes:
        said.append(
            f"{telescopes} telescopes cover all that can be covered; the other "
            f"{wanted.telescopes - telescopes} would add nothing."
        )
    return said
