"""Densities from counts, against closed forms and draws whose truth is known."""

from dataclasses import replace

import numpy as np
import pytest
from scipy import sparse

from muysc_qgis.errors import MuyscError
from muysc_qgis.tomography.counting import CountModel, CountPriors, fit_counts
from muysc_qgis.tomography.counting.deviance import deviance, expected_deviance
from muysc_qgis.tomography.counting.fit import _Search
from muysc_qgis.tomography.counting.posterior import Posterior
from muysc_qgis.tomography.counting.priors import bounded
from muysc_qgis.tomography.lattice import Lattice
from muysc_qgis.tomography.operators import StoredPaths

SIZE, EDGE_M, SUB = 9, 40.0, 3
ROCK = 2.6


def flux(opacity):
    """Return a flux that falls with the third power, as behind a kilometre of rock."""
    value = 1e-2 * (1 + opacity / 2e4) ** -3
    return value, -3 / (opacity + 2e4) * value


@pytest.fixture(scope="module")
def square():
    """Return a model of a square of voxels that two stations look through, three sub-rays each."""
    lattice = Lattice((EDGE_M, EDGE_M), np.ones((SIZE, SIZE), bool))
    rng = np.random.default_rng(5)
    rows = []
    for station in range(2):
        for line in range(SIZE):
            for _ in range(SUB * 6):
                row = np.zeros((SIZE, SIZE))
                cells = np.arange(SIZE)
                other = np.clip(np.round(line + rng.normal(0, 0.2) * (cells - 4)), 0, SIZE - 1)
                index = (cells, other.astype(int)) if station else (other.astype(int), cells)
                row[index] = rng.uniform(0.9, 1.1) * EDGE_M
                rows.append(row.ravel())
    lengths = sparse.csr_matrix(np.array(rows, np.float32))
    # Every seventh datum looks at the sky beside the rock: its sub-rays meet no voxel.
    n_data = len(rows) // SUB
    weights = sparse.kron(sparse.identity(n_data), np.full((1, SUB), 1 / SUB), format="csr")
    sky = sparse.csr_matrix((np.ones(4), (np.arange(4), np.arange(4))))
    weights = sparse.block_diag([weights, sky], format="csr")
    station = np.concatenate([np.repeat([0, 1], n_data // 2), [0, 0, 1, 1]])
    return CountModel(
        StoredPaths(lengths), np.arange(len(rows)), np.zeros(len(rows) + 4), weights,
        np.full(n_data + 4, 2e6), np.ones(n_data + 4), station, flux, lattice,
    )  # fmt: skip


def counted(model, densities, factors=(1.0, 1.0), seed=1):
    mean = model.expected(densities, ROCK) * np.array(factors)[model.station]
    return replace(model, counts=np.random.default_rng(seed).poisson(mean).astype(float))


PRIORS = CountPriors(ROCK, 0.1, 0.2, 80.0, station=0.1, flux=0.0, lowest=None)


def dense(search, state):
    """Return G, the prior's covariance and the names of the unknowns, densely."""
    space = search.space(state)
    field = space.fields[0]
    count = field.lattice.count
    prior = np.stack([field.covariance(row) for row in np.eye(count)])
    jacobian = np.hstack([field.jacobian.toarray(), space.columns])
    whole = np.zeros((count + len(space.deviations),) * 2)
    whole[:count, :count] = prior
    whole[count:, count:] = np.diag(space.deviations**2)
    return space, jacobian, whole


def test_a_step_and_its_errors_are_those_of_the_dense_formula(square):
    """x = (Gᵀ G + C⁻¹)⁻¹ Gᵀ r with errors from the inverse, all of them in full."""
    search = _Search.of(square, PRIORS)
    state = search.state([np.zeros(SIZE**2)], np.zeros(3))
    space, jacobian, prior = dense(search, state)
    inverse = np.linalg.inv(np.linalg.inv(prior) + jacobian.T @ jacobian)
    target = np.random.default_rng(2).normal(size=space.size)
    solution, _, finished = space.solve(target, 500, 1e-10)
    fields, others = space.spread(solution)
    assert finished
    assert np.concatenate([*fields, others]) == pytest.approx(
        inverse @ jacobian.T @ target, rel=1e-5
    )
    posterior = Posterior.of(space)
    both = np.hstack([np.eye(SIZE**2), np.ones((SIZE**2, 1)), np.zeros((SIZE**2, 2))])
    expected = np.sqrt(np.diag(both @ inverse @ both.T))
    assert posterior.deviation(np.ones(SIZE**2)) == pytest.approx(expected, rel=1e-4)
    assert posterior.others() == pytest.approx(np.sqrt(np.diag(inverse))[-3:], rel=1e-6)
    resolved = np.trace(jacobian @ inverse @ jacobian.T)
    assert posterior.parameters() == pytest.approx(resolved, rel=0.1)


def test_the_linearisation_is_the_derivative(square):
    values = np.full(SIZE**2, ROCK) + 0.1 * np.random.default_rng(3).normal(size=SIZE**2)
    line = square.at(values, ROCK)
    for voxel in (0, 40, 77):
        step = np.zeros(SIZE**2)
        step[voxel] = 1e-2
        change = np.log(square.expected(values + step, ROCK) / square.expected(values - step, ROCK))
        assert line.voxels[:, [voxel]].toarray().ravel() == pytest.approx(
            change / 2e-2, rel=1e-2, abs=1e-6
        )


def test_stated_errors_hold_over_draws_from_the_prior(square):
    """Of densities drawn from the prior, 68 % lie within one error."""
    covariance = square.lattice.covariance(PRIORS.deviation, PRIORS.length_m)
    rng = np.random.default_rng(11)
    off, misfits = [], []
    for draw in range(12):
        truth = ROCK + 0.1 * rng.normal()
        truth = truth + covariance.root(rng.standard_normal(covariance.root_size))
        model = counted(square, truth, rng.normal(1, 0.1, 2), draw)
        found = fit_counts(model, PRIORS, errors=True)
        assert found.converged
        off.append((found.densities - truth) / found.deviation)
        misfits.append(found.chi_squared)
    off = np.concatenate(off)
    assert 0.62 < np.mean(np.abs(off) < 1) < 0.74
    assert np.mean(misfits) == pytest.approx(1.0, abs=0.06)


def test_a_factor_of_a_station_is_found_and_told_with_its_error(square):
    model = counted(square, np.full(SIZE**2, ROCK), (0.95, 1.05))
    found = fit_counts(model, PRIORS, errors=True)
    factors = [band for band in found.bands if band.name == "factor"]
    for band, truth in zip(factors, (0.95, 1.05)):
        assert band.after == pytest.approx(truth, abs=0.01)
        assert band.after_error < 0.02
        assert (band.before, band.before_error) == (1.0, 0.1)


def test_rough_errors_are_near_the_exact_ones(square):
    model = counted(square, np.full(SIZE**2, ROCK))
    exact, rough = (fit_counts(model, PRIORS, errors=errors) for errors in (True, False))
    assert [band.after_error for band in rough.bands] == pytest.approx(
        [band.after_error for band in exact.bands], rel=0.05
    )
    assert rough.densities == pytest.approx(exact.densities, abs=1e-6)
    assert rough.deviation is None


def test_pixels_without_a_muon_are_data(square):
    """Behind rock that lets hardly a muon through, leaving out zeros makes it too light."""
    truth = 3.0
    thin = replace(square, exposure=square.exposure / 80)
    priors = replace(PRIORS, mean_deviation=1.0, deviation=0.02, station=0.0)
    found = []
    for seed in range(8):
        model = counted(thin, np.full(SIZE**2, truth), seed=seed)
        assert np.mean(model.counts == 0) > 0.2
        some = np.flatnonzero(model.counts > 0)
        counting = replace(
            model, counts=model.counts[some], exposure=model.exposure[some],
            station=model.station[some], weights=model.weights[some],
        )  # fmt: skip
        found.append([fit_counts(one, priors).mean for one in (model, counting)])
    all_data, without_zeros = np.mean(found, axis=0)
    assert all_data == pytest.approx(truth, abs=0.12)
    assert without_zeros < all_data - 0.1


def test_bounds_bind_and_are_never_crossed(square):
    truth = np.full(SIZE**2, ROCK)
    truth.reshape(SIZE, SIZE)[3:6, 3:6] = 1.2
    model = counted(square, truth)
    free = fit_counts(model, PRIORS)
    assert free.densities.min() < 1.9
    held = fit_counts(model, replace(PRIORS, lowest=2.0, highest=2.8))
    assert held.densities.min() >= 2.0
    assert held.densities.max() <= 2.8
    with pytest.raises(MuyscError, match="not within the bounds"):
        replace(PRIORS, lowest=2.7)


def test_bounded_is_the_identity_inside():
    values = np.linspace(-1, 5, 61)
    found, slope = bounded(values, 0.5, 3.0)
    inside = (values > 0.8) & (values < 2.7)
    assert found[inside] == pytest.approx(values[inside], abs=1e-5)
    assert np.all(np.diff(found) >= -1e-12)
    assert found.min() >= 0.5
    assert found.max() <= 3.0
    assert np.gradient(found, values)[1:-1] == pytest.approx(slope[1:-1], abs=0.3)


@pytest.mark.parametrize("mean", [0.01, 0.3, 3.0, 11.9, 12.1, 300.0])
def test_the_expected_deviance_is_the_mean_over_draws(mean):
    draws = np.random.default_rng(1).poisson(mean, 400_000).astype(float)
    assert expected_deviance(np.array([mean]))[0] == pytest.approx(
        deviance(draws, np.full(draws.shape, mean)).mean(), rel=0.02
    )


def test_wrong_input_is_refused(square):
    with pytest.raises(MuyscError, match="count is negative"):
        replace(square, counts=-square.counts)
    with pytest.raises(MuyscError, match="exposure is not above 0"):
        replace(square, exposure=0 * square.exposure)
    with pytest.raises(MuyscError, match="one of each for each trajectory"):
        replace(square, exposure=square.exposure[1:])
    with pytest.raises(MuyscError, match="up to 10000 data"):
        Posterior.check(10_001)
