"""The figures by which candidate sites are compared, site by site in the background."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ..progress import Progress
from ..workflows.planning import SiteFigures, figures_of_site
from .background import Background
from .plan import Plan
from .preview import request_for
from .sites import Site


@dataclass(frozen=True)
class _Answer:
    """What was found for one plan: figures, or why there are none."""

    plan: Plan
    figures: SiteFigures | None
    problem: str = ""


class Comparison(QObject):
    """Knows the figures of every site that was asked for, for the plan at hand."""

    #: Something is known that was not.
    answered = pyqtSignal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._known: dict[Plan, _Answer] = {}
        self._open: list[Plan] = []
        self._background = Background(self)
        self._background.computed.connect(self._take)
        self._background.failed.connect(self._refuse)

    @property
    def busy(self) -> bool:
        """Whether figures are being computed."""
        return self._background.busy

    def compare(self, plan: Plan, sites: list[Site]) -> None:
        """Compute what is not yet known of the sites, with all else as in the plan."""
        wanted = [plan_at(plan, site) for site in sites]
        self._known = {one: self._known[one] for one in wanted if one in self._known}
        self._open = [one for one in wanted if one not in self._known]
        self._background.cancel()
        self._next()

    def stop(self) -> None:
        """Compute nothing more for now."""
        self._open = []
        self._background.cancel()

    def close(self) -> None:
        """Stop for good."""
        self._open = []
        self._background.close()

    def figures(self, plan: Plan, site: Site) -> SiteFigures | None:
        """Return the figures of a site, None while they are unknown."""
        answer = self._known.get(plan_at(plan, site))
        return answer.figures if answer else None

    def problem(self, plan: Plan, site: Site) -> str:
        """Return why a site has no figures, empty where that is not known."""
        answer = self._known.get(plan_at(plan, site))
        return answer.problem if answer else ""

    def _next(self) -> None:
        if self._open:
            plan = self._open[0]
            self._background.submit(lambda: _computation(plan))

    def _take(self, answer: _Answer) -> None:
        self._answer(answer)
        self._next()

    def _refuse(self, problem: str) -> None:
        if self._open:
            self._answer(_Answer(self._open[0], None, problem))
            self._next()

    def _answer(self, answer: _Answer) -> None:
        self._known[answer.plan] = answer
        self._open = [plan for plan in self._open if plan != answer.plan]
        self.answered.emit()


def _computation(plan: Plan) -> Callable[[Progress], _Answer]:
    """Read a plan; return what computes the figures of its detector."""
    inputs = request_for(plan).inputs
    view = (inputs.sight, inputs.aperture, inputs.physics, inputs.telescope)
    return lambda progress: _Answer(plan, figures_of_site(*view, progress))


def plan_at(plan: Plan, site: Site) -> Plan:
    """Return a plan with the detector at a site."""
    return replace(plan, detector=site.place, detector_height_m=site.height_m)
