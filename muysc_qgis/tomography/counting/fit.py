"""Fisher scoring: the densities that counts and priors together make most likely."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ...progress import Progress, part, report, silent
from ..libraries import scipy_part
from .deviance import deviance, expected_deviance
from .model import CountModel, Linearisation
from .posterior import Posterior
from .priors import Band, CountPriors, Nuisances, bounded
from .space import DataSpace, Field

#: Change of ln μ, over its error, that ends the steps.
_SETTLED = 0.05

#: Most halvings of a step that makes things worse.
_HALVINGS = 6

#: Relative accuracy of the solution of each step, of the last digits that matter, and of
#: what only errors follow from.
_ACCURACY, _ROUGH = 1e-4, 5e-2

#: Largest change of ln μ by factors and boresights.
_FAR = 20.0

#: Deviation (g/cm³) of voxels that have none, and iterations that suffice then.
_NO_DEVIATION, _UNIFORM_ITERATIONS = 1e-5, 100

#: Draws of the terrain's errors from which the size of their effect is known to 18 %.
_DRAWS = 16


@dataclass(frozen=True)
class CountFit:
    """Densities, all else that was estimated, and how well the counts are explained."""

    #: (n_unknowns,) g/cm³, and their standard errors; None where not asked for.
    densities: np.ndarray
    deviation: np.ndarray | None
    #: Density of the rock outside, and mean of the prior, g/cm³.
    mean: float
    bands: tuple[Band, ...]
    #: (n_nodes,) how much higher the terrain is, m; None where it is known.
    terrain_m: np.ndarray | None
    #: (n_data,) expected counts, and the variance of the counts with all errors of the model.
    expected: np.ndarray
    variance: np.ndarray
    #: Deviance over what it is expected to be: 1 for a perfect fit.
    chi_squared: float
    #: Numbers that the data settle rather than the prior.
    parameters: float
    iterations: int
    inner_iterations: int
    converged: bool
    #: χ² before the first step and after each.
    history: np.ndarray

    def residuals(self, counts: np.ndarray) -> np.ndarray:
        """Return (n − μ)/σ, (n_data,)."""
        return (counts - self.expected) / np.sqrt(self.variance)


@dataclass
class _State:
    """Where the search stands: what the priors are of, and what follows."""

    fields: list[np.ndarray]
    others: np.ndarray
    line: Linearisation
    bend: np.ndarray
    columns: np.ndarray
    expected: np.ndarray
    variance: np.ndarray
    #: xᵀ C⁻¹ x of all unknowns.
    penalty: float = 0.0


def fit_counts(
    model: CountModel,
    priors: CountPriors,
    steps: int = 5,
    inner: int = 200,
    errors: bool = False,
    progress: Progress = silent,
) -> CountFit:
    """Return the densities that counts and priors make most likely.

    Minimises Σ (μ − n ln μ) + ½ xᵀ C⁻¹ x by Fisher scoring: each step is the linear problem with
    the data's errors √μ, solved in the space of the data. Factors, boresights and terrain are
    part of x. Errors of the model that no unknown stands for add to the variance μ.

    Parameters
    ----------
    model
        Counts, and what is expected of densities.
    priors
        What is known before.
    steps
        Most steps; three do as a rule.
    inner
        Most iterations within each.
    errors
        Whether errors of the densities are wanted, exact and for up to 10 000 data.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If errors are wanted of too many data, or a prior cannot be used.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    search = _Search.of(model, priors)
    if errors:
        Posterior.check(model.size)
    state, history, done, total, converged = search.run(
        steps, inner, part(progress, 0.0, 0.4 if errors else 0.85)
    )
    return search.told(
        state, history, done, total, converged, errors, inner,
        part(progress, 0.4 if errors else 0.85, 1.0),
    )  # fmt: skip


@dataclass(frozen=True)
class Uniform:
    """A mountain of one density that explains counts as well as it can, with all else uncertain."""

    #: All that is uncertain but the densities of voxels.
    space: DataSpace
    #: (n_data,) counts less what the prior expects, over their errors, linear about what was found.
    residual: np.ndarray
    #: (n_data, n_unknowns) CSR: the counts' derivatives over densities, over their errors.
    voxels: Any


def fit_uniform(model: CountModel, priors: CountPriors, steps: int = 5) -> Uniform:
    """Return the uniform mountain that counts and priors make most likely.

    Parameters
    ----------
    model, priors
        As in `fit_counts`; the deviation of voxels is left out.
    steps
        Most steps.
    """
    search = _Search.of(model, replace(priors, deviation=_NO_DEVIATION))
    state = search.run(steps, _UNIFORM_ITERATIONS, silent)[0]
    space = search.space(state)
    voxels, *fields = space.fields
    residual = (model.counts - state.expected) / np.sqrt(state.variance)
    residual += space.predicted(state.fields, state.others)
    return Uniform(replace(space, fields=fields), residual, voxels.jacobian)


@dataclass(frozen=True)
class _Search:
    model: CountModel
    priors: CountPriors
    nuisances: Nuisances

    #: Products with the prior's covariance: of voxels, and of the terrain where it is uncertain.
    covariances: tuple[Any, ...]
    #: (n_nodes, n_draws) errors of the terrain drawn from its prior, m; None where it is known.
    drawn: np.ndarray | None = None

    @classmethod
    def of(cls, model: CountModel, priors: CountPriors) -> _Search:
        covariances = [model.lattice.covariance(priors.deviation, priors.length_m)]
        drawn = None
        if model.ground is not None and priors.terrain_m > 0:
            own = model.ground.covariance(priors.terrain_m, priors.terrain_length_m)
            covariances.append(own)
            generator = np.random.default_rng(0)
            drawn = np.stack(
                [own.root(generator.standard_normal(own.root_size)) for _ in range(_DRAWS)], axis=1
            )
        return cls(model, priors, Nuisances.of(model, priors), tuple(covariances), drawn)

    @property
    def has_terrain(self) -> bool:
        """Whether heights of the terrain are estimated."""
        return len(self.covariances) > 1

    @property
    def sizes(self) -> list[int]:
        """Number of values of each field."""
        sizes = [self.model.lattice.count]
        if self.has_terrain:
            sizes.append(self.model.terrain.shape[1])
        return sizes

    def run(
        self, steps: int, inner: int, progress: Progress
    ) -> tuple[_State, list[float], int, int, bool]:
        """Return where the steps end, the misfits, steps, iterations, and whether they sufficed."""
        state = self.state(
            [np.zeros(size) for size in self.sizes], np.zeros(len(self.nuisances.names))
        )
        history = [self.misfit(state)]
        solution, total, done = None, 0, 0
        for done in range(1, steps + 1):
            space = self.space(state)
            wanted = (self.model.counts - state.expected) / np.sqrt(state.variance)
            wanted += space.predicted(state.fields, state.others)
            share = part(progress, (done - 1) / steps, done / steps)
            solution, iterations, finished = space.solve(wanted, inner, _ACCURACY, solution, share)
            total += iterations
            following = self.step(state, space, solution)
            moved = np.log(following.expected / state.expected) * np.sqrt(state.expected)
            state = following
            history.append(self.misfit(state))
            if np.sqrt(np.mean(moved**2)) < _SETTLED:
                return state, history, done, total, finished
        return state, history, done, total, False

    def densities(self, fields: Sequence[np.ndarray], others: np.ndarray) -> Any:
        """Return the densities within bounds, the mean, and the derivative of the densities."""
        mean = self.priors.mean + others[0]
        low, high = self.priors.bounds
        values, bend = bounded(mean + fields[0], low, high)
        return values, float(np.clip(mean, max(low, 1e-3), high)), bend

    def state(self, fields: list[np.ndarray], others: np.ndarray) -> _State:
        """Return what follows from values of all unknowns."""
        values, mean, bend = self.densities(fields, others)
        line = self.model.at(values, mean)
        columns = self.nuisances.columns(self.model, line, bend)
        effect = self.nuisances.effect(columns, others)
        if self.has_terrain:
            effect = effect + line.terrain @ fields[1]
        expected = np.maximum(line.expected * np.exp(np.clip(effect, -_FAR, _FAR)), 1e-12)
        relative = line.length_error**2
        if self.drawn is not None:
            # A linear effect g z of the terrain misses up to (g z)² in ln μ where the share of sky
            # in a trajectory changes with it.
            relative = relative + np.mean((line.terrain @ self.drawn) ** 2, axis=1) ** 2
        variance = expected + expected**2 * relative
        return _State(fields, others, line, bend, columns, expected, variance)

    def space(self, state: _State) -> DataSpace:
        """Return the linear problem at a state."""
        sparse = scipy_part("sparse")
        scale = state.expected / np.sqrt(state.variance)
        weigh = sparse.diags(scale)
        matrices = [weigh @ state.line.voxels @ sparse.diags(state.bend)]
        deviations = [self.priors.deviation]
        lattices: list[Any] = [self.model.lattice]
        if self.has_terrain:
            matrices.append(weigh @ state.line.terrain)
            deviations.append(self.priors.terrain_m)
            lattices.append(self.model.ground)
        fields = [
            Field(lattice, covariance, matrix.tocsr(), deviation)
            for lattice, covariance, matrix, deviation in zip(
                lattices, self.covariances, matrices, deviations
            )
        ]
        return DataSpace(fields, scale[:, None] * state.columns, self.nuisances.deviations)

    def misfit(self, state: _State) -> float:
        """Return the deviance over the number of data."""
        counts, expected = self.model.counts, state.expected
        weight = expected / state.variance
        return float(np.sum(weight * deviance(counts, expected)) / len(counts))

    def step(self, state: _State, space: DataSpace, solution: np.ndarray) -> _State:
        """Return the next state: the whole step, or a part that does not make things worse."""
        fields, others = space.spread(solution)
        ahead = space.predicted(fields, others)
        behind = space.predicted(state.fields, state.others)
        # xᵀ C⁻¹ x of the new point, and its product with the old one, from K⁻¹ r alone.
        new, mixed = float(solution @ ahead), float(solution @ behind)
        before, share = self.objective(state), 1.0
        while True:
            rest = 1.0 - share
            following = self.state(
                [rest * old + share * one for old, one in zip(state.fields, fields)],
                rest * state.others + share * others,
            )
            following.penalty = (
                rest**2 * state.penalty + 2.0 * rest * share * mixed + share**2 * new
            )
            # A millesimal is what the linear problem is solved to.
            if self.objective(following) <= 1.001 * before or share < 0.5**_HALVINGS:
                return following
            share *= 0.5

    def objective(self, state: _State) -> float:
        """Return what is minimised, the misfit and the distance from the prior."""
        return len(state.expected) * self.misfit(state) + state.penalty

    def told(
        self,
        state: _State,
        history: list[float],
        steps: int,
        inner: int,
        converged: bool,
        errors: bool,
        most: int,
        progress: Progress,
    ) -> CountFit:
        """Return what was found, with the errors that are wanted."""
        space = self.space(state)
        values, mean, bend = self.densities(state.fields, state.others)
        deviation = None
        if errors:
            posterior = Posterior.of(space, part(progress, 0.0, 0.5))
            deviation = posterior.deviation(bend, part(progress, 0.5, 1.0))
            after = posterior.others()
            parameters = posterior.parameters()
        else:
            after, parameters = self._rough(space, most, progress)
        weight = state.expected / state.variance
        found = float(np.sum(weight * deviance(self.model.counts, state.expected)))
        due = float(np.sum(weight * expected_deviance(state.expected) + 1 - weight))
        report(progress, 1.0)
        return CountFit(
            values, deviation, mean, self._bands(state, after),
            state.fields[1] if self.has_terrain else None, state.expected, state.variance,
            found / max(due - parameters, 1.0), parameters, steps, inner, converged,
            np.array(history),
        )  # fmt: skip

    def _rough(self, space: DataSpace, most: int, progress: Progress) -> tuple[np.ndarray, float]:
        """Return the errors of the single numbers and the number of parameters, to a per cent."""
        generator = np.random.default_rng(0)
        count = len(space.deviations)
        noise = generator.choice([-1.0, 1.0], space.size)
        left = float(noise @ space.solve(noise, most, _ROUGH, None, part(progress, 0.0, 0.1))[0])
        # From K without the single numbers, in which nothing cancels: (D⁻¹ + Uᵀ K⁻¹ U)⁻¹.
        alone = replace(space, columns=space.columns[:, :0], deviations=space.deviations[:0])
        settled = np.empty((space.size, count))
        for number in range(count):
            share = part(progress, 0.1 + 0.9 * number / count, 0.1 + 0.9 * (number + 1) / count)
            settled[:, number] = alone.solve(space.columns[:, number], most, _ROUGH, None, share)[0]
        inner = space.columns.T @ settled
        root = space.deviations
        whole = np.eye(count) + root[:, None] * 0.5 * (inner + inner.T) * root
        return root * np.sqrt(np.diag(np.linalg.inv(whole))), space.size - left

    def _bands(self, state: _State, after: np.ndarray) -> tuple[Band, ...]:
        """Return the single numbers: densities and angles as they are, factors as factors."""
        rows = []
        for name, station, before, value, error in zip(
            self.nuisances.names, self.nuisances.stations, self.nuisances.deviations,
            state.others, after,
        ):  # fmt: skip
            if name == "mean":
                start = self.priors.mean
                row = Band(name, -1, start, before, start + value, error)
            elif name in ("factor", "flux"):
                row = Band(name, int(station), 1.0, before, float(np.exp(value)),
                           float(np.exp(value) * error))  # fmt: skip
            else:
                row = Band(name, int(station), 0.0, before, float(value), float(error))
            rows.append(row)
        return tuple(rows)
