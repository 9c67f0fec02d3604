"""Report of a survey: what is drawn and told, in which order."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..workflows.provenance import describe_transformation
from ..workflows.site_assessment import SurveyPlan
from ..workflows.site_selection import Selection
from .provenance import Provenance, physics_citations, transformation_rows
from .report import Citation, Report, ReportFigure, Row
from .style import REPORT_DPI, png_bytes
from .survey_panel import survey_maps, survey_panel

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_GREEDY = Citation(
    "Choice of telescopes: Nemhauser, G. L., Wolsey, L. A. & Fisher, M. L. (1978). An analysis of "
    "approximations for maximizing submodular set functions—I. Mathematical Programming, 14, "
    "265–294.",
    "https://doi.org/10.1007/BF01588971",
)


def panel(selection: Selection, plan: SurveyPlan) -> Figure:
    """Draw the panel of a survey.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    return survey_panel(selection, plan)


def report(
    selection: Selection,
    plan: SurveyPlan,
    provenance: Provenance,
) -> Report:
    """Gather everything that the report of a survey tells.

    Parameters
    ----------
    selection, plan
        What was found, and what was looked for.
    provenance
        What it was computed from, and when.
    """
    drawn = [
        ReportFigure(
            "Score of every candidate with the best sites by rank and the telescopes that go "
            "together; how well each azimuth around the target is covered; exposure time against "
            "the share of the target seen.",
            png_bytes(survey_panel(selection, plan)),
            "Map of scores, rose of azimuths, and exposure time against share seen",
            is_panel=True,
        ),
        ReportFigure(
            "Exposure time, share of the target seen, thickness of rock and free sky from every "
            "candidate.",
            png_bytes(survey_maps(selection, plan), REPORT_DPI),
            "Four maps of numbers of the candidates",
        ),
    ]
    candidates = selection.candidates
    physics = plan.view.physics
    told = Report(
        title="Where to put the telescope",
        subtitle=f"{len(candidates)} candidates on the elevation model {plan.dem.name}",
        figures=drawn,
        results=[*_rows(selection), *transformation_rows(describe_transformation(plan.dem))],
        warnings=selection.warnings,
        citations=[
            _GREEDY,
            *physics_citations(physics.flux_model, physics.energy_loss),
        ],
    )
    return provenance.added_to(told)


def _rows(selection: Selection) -> list[Row]:
    candidates, numbers = selection.candidates, selection.numbers
    seeing = int(np.count_nonzero(numbers["share_seen"] > 0))
    rows = [
        Row("Candidates", len(candidates)),
        Row("Candidates that see a part of the target", seeing),
        *(Row(f"Places {why}", count) for why, count in candidates.removed.items() if count),
    ]
    for word, chosen in (("Site", selection.best), ("Telescope", selection.telescopes)):
        rows += [
            Row(
                f"{word} {rank}",
                f"score {numbers['score'][index]:.3f}, "
                f"{100 * numbers['share_seen'][index]:.1f} % seen in "
                f"{numbers['exposure_days'][index]:.3g} days, "
                f"{candidates.distance_m[index]:.0f} m at {candidates.azimuth_deg[index]:.0f}°",
            )
            for rank, index in enumerate(chosen, 1)
        ]
    rows.append(Row("Mean coverage of the azimuths", float(selection.coverage[-1])))
    return rows
