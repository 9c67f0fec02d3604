"""Every method: consistent data recovered, objectives falling, limits known in closed form."""

import numpy as np
import pytest

from muysc_qgis.errors import Cancelled, MuyscError
from muysc_qgis.progress import silent
from muysc_qgis.tomography.lattice import Lattice
from muysc_qgis.tomography.operators import RecomputedPaths, StoredPaths
from muysc_qgis.tomography.parallel_beam import ParallelBeam
from muysc_qgis.tomography.projector import path_matrix, paths_through
from muysc_qgis.tomography.rays import Rays
from muysc_qgis.tomography.solvers import METHODS, Options, art, bayes, method_of, reconstruct
from muysc_qgis.tomography.solvers.options import Settings, start_vector
from muysc_qgis.tomography.solvers.total_variation import norm
from muysc_qgis.tomography.system import System
from muysc_qgis.tomography.voxels import VoxelGrid

GRID = VoxelGrid((0, 0, 0), (10, 10, 10), (4, 4, 3))
ITERATIVE = sorted(set(METHODS) - {"bayes"})
#: Methods that end up at the data where nothing holds them back.
UNPENALISED = {
    "art": {"relaxation": 1.0}, "bart": {"relaxation": 1.5}, "sart": {"relaxation": 1.0},
    "sirt": {"relaxation": 1.9}, "mlem": {}, "osem": {"subsets": 4}, "pml-quad": {},
    "pml-hybrid": {}, "ospml-quad": {"subsets": 4}, "ospml-hybrid": {"subsets": 4}, "tv": {},
    "grad": {}, "tikhonov": {}, "lsmr": {},
}  # fmt: skip


SLOW = ("sirt", "mlem", "pml-quad", "pml-hybrid", "tv", "bart")


def paths_of(count=400, seed=0):
    generator = np.random.default_rng(seed)
    origin = generator.uniform((-30, -30, -20), (70, 70, 50), (count, 3))
    goal = generator.uniform((0, 0, 0), (40, 40, 30), (count, 3))
    direction = goal - origin
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    return paths_through(GRID, Rays(origin, direction, np.arange(count) % 10))


def system_of(truth, noise=0.0, paths=None, errors=None, seed=1):
    paths = paths or StoredPaths(path_matrix(paths_of()))
    data = paths.forward(truth).astype(float)
    if noise:
        errors = np.full(len(data), noise)
        data += noise * np.random.default_rng(seed).standard_normal(len(data))
    return System(paths, data, Lattice.of(GRID), np.arange(len(data)) % 10, errors)


def dense(system):
    return np.concatenate([block.toarray() for _, block in system.paths.blocks()]).astype(float)


@pytest.fixture(scope="module")
def truth():
    return np.random.default_rng(7).uniform(1.5, 3.0, GRID.count)


def off(values, truth):
    return np.linalg.norm(values - truth) / np.linalg.norm(truth)


@pytest.mark.parametrize("name", ITERATIVE)
def test_consistent_data_are_recovered(name, truth):
    """400 rays through 48 voxels determine each: without a penalty the truth comes out."""
    system = system_of(truth)
    iterations = 2000 if name in SLOW else 300
    options = Options(iterations=iterations, regularization=0.0, start=2.0, **UNPENALISED[name])
    result = reconstruct(name, system, options)
    assert off(result.values, truth) < 0.01
    assert result.misfit[-1] < 2e-3 * result.misfit[0]


@pytest.mark.parametrize("name", ["sirt", "mlem", "pml-quad", "pml-hybrid"])
@pytest.mark.parametrize("noise", [0.0, 1.0])
def test_what_is_minimised_falls_at_every_step(name, noise, truth):
    system = system_of(truth, noise)
    options = Options(iterations=60, discrepancy=0.0, relaxation=1.0, start=2.0)
    objective = reconstruct(name, system, options).objective
    assert len(objective) == 61
    assert np.all(np.diff(objective) <= 1e-6 * objective[0])
    assert objective[-1] < 0.9 * objective[0]


@pytest.mark.parametrize("name", sorted(set(METHODS)))
def test_every_method_runs_on_recomputed_paths(name, truth):
    """The same model from the stored matrix and from paths followed anew."""
    stored = system_of(truth, 0.5)
    recomputed = System(
        RecomputedPaths(paths_of()), stored.data, stored.lattice, stored.view, stored.errors
    )
    options = Options(iterations=3, discrepancy=0.0)
    expected = reconstruct(name, stored, options).values
    assert reconstruct(name, recomputed, options).values == pytest.approx(expected, rel=2e-3)


@pytest.mark.parametrize("name", sorted(set(METHODS) - {"bayes"}))
def test_densities_stay_above_zero_unless_allowed(name):
    truth = np.where(np.arange(GRID.count) % 5 == 0, 0.0, 2.5)
    system = system_of(truth, 8.0)
    options = {"iterations": 50, "discrepancy": 0.0, "regularization": 0.0}
    assert reconstruct(name, system, Options(**options)).values.min() >= 0
    free = reconstruct(name, system, Options(**options, nonnegative=False)).values.min()
    multiplies = name in ("mlem", "osem") or "pml" in name
    assert free >= 0 if multiplies else free < 0


@pytest.mark.parametrize("name", ["art", "bart", "sart", "sirt", "mlem", "osem", "grad", "lsmr"])
def test_fitting_ends_at_the_noise(name, truth):
    """Discrepancy principle: misfit at most 1 with the errors known, sooner for larger errors."""
    # Blocks go around the solution in steps that this many noisy rays must not widen.
    gentle = {"bart": {"relaxation": 0.3}, "osem": {"subsets": 2}}.get(name, {})
    options = Options(iterations=500, regularization=0.0, start=1.0, **gentle)
    result = reconstruct(name, system_of(truth, 2.0), options)
    assert result.stopped_by == "discrepancy"
    assert result.misfit[-1] <= 1.0 < result.misfit[0]
    strict = Options(iterations=30, regularization=0.0, start=1.0, discrepancy=0.0)
    assert reconstruct(name, system_of(truth, 2.0), strict).stopped_by != "discrepancy"


def test_a_sweep_of_art_is_kaczmarz_ray_by_ray(truth):
    """Against the textbook loop with dense rows, in the rays' own order."""
    system = system_of(truth, 1.0)
    rows, x = dense(system), np.full(GRID.count, 2.0)
    for row, value in zip(rows, system.data):
        x = x + 0.7 * (value - row @ x) / (row @ row) * row
    options = Options(
        iterations=1, relaxation=0.7, ordering="sequential", start=2.0, discrepancy=0.0
    )
    assert reconstruct("art", system, options).values == pytest.approx(x, rel=1e-4)


def test_a_sweep_over_disjoint_rays_is_kaczmarz_too():
    """Parallel rays of one voxel's spacing share none with the next but one."""
    beam = ParallelBeam(48, np.array([0.0, 30.0, 77.0, 130.0]), 68)
    paths = beam.paths()
    stored = StoredPaths(path_matrix(paths))
    data = stored.forward(np.random.default_rng(0).random(48 * 48)).astype(float)
    system = System(stored, data, beam.lattice(), paths.rays.view).usable()
    settings = Settings(
        1, 0.8, 0.0, "interleaved", 1, False, None, np.zeros(48 * 48), 0.0, 0.1, None, 1.0, 1.0,
        0, 1,
    )  # fmt: skip
    groups = art._groups(system, settings)
    assert groups is not None
    assert len(groups) > 4
    rows, x = dense(system), np.zeros(48 * 48)
    for ray in np.concatenate(groups):
        x = x + 0.8 * (system.data[ray] - rows[ray] @ x) / (rows[ray] @ rows[ray]) * rows[ray]
    assert art.solve(system, settings, silent).values == pytest.approx(x, abs=1e-4)


def test_least_squares_with_a_penalty_have_their_closed_forms(truth):
    """(AᵀWA + βd L) x = AᵀWb: L = DᵀD for tikhonov and grad, 1 about the start for lsmr."""
    generator = np.random.default_rng(3)
    errors = generator.uniform(0.5, 2.0, 400)
    system = system_of(truth, errors=errors)
    system.data[:] += errors * generator.standard_normal(400)
    weights = system.weights()
    assert weights == pytest.approx(errors**-2 / np.mean(errors**-2))
    rows, difference = dense(system), system.lattice.gradient().toarray()
    normal = rows.T @ (weights[:, None] * rows)
    strength = 0.3 * np.diag(normal).mean()
    right = rows.T @ (weights * system.data)
    smooth = np.linalg.solve(normal + strength * difference.T @ difference, right)
    near = np.linalg.solve(normal + strength * np.eye(48), right + strength * 2.0)
    options = Options(iterations=1000, regularization=0.3, start=2.0)
    assert reconstruct("tikhonov", system, options).values == pytest.approx(smooth, rel=1e-3)
    assert reconstruct("grad", system, options).values == pytest.approx(smooth, rel=1e-3)
    assert reconstruct("lsmr", system, options).values == pytest.approx(near, rel=1e-3)


def test_gradient_descent_stands_still_at_the_optimum():
    """Where the step is 0/0 nothing moves and nothing is divided."""
    system = system_of(np.full(GRID.count, 2.0))
    system.data[:] = system.paths.forward(np.full(GRID.count, 2.0, np.float32))
    with np.errstate(all="raise"):
        result = reconstruct("grad", system, Options(start=2.0, regularization=1.0))
    assert result.values == pytest.approx(np.full(GRID.count, 2.0))
    assert result.stopped_by == "converged"


def step_of(n_left, n_right, strength):
    """A row of voxels, each seen by a ray of its own: denoising of a step."""
    count = n_left + n_right
    grid = VoxelGrid((0, 0, 0), (10, 10, 10), (count, 1, 1))
    origin = np.stack([10 * np.arange(count) + 5.0, np.full(count, -5.0), np.full(count, 5.0)], 1)
    rays = Rays(origin, np.tile([0.0, 1.0, 0.0], (count, 1)), np.zeros(count, int))
    paths = StoredPaths(path_matrix(paths_through(grid, rays)))
    data = 10 * np.r_[np.full(n_left, 1.0), np.full(n_right, 3.0)]
    system = System(paths, data, Lattice.of(grid), np.zeros(count, int))
    return reconstruct("tv", system, Options(iterations=5000, regularization=strength, start=2.0))


def test_total_variation_shrinks_a_step_as_known():
    """With A = 10·1 and α = β · 100 · 2 the sides move by α/(100 n) towards each other."""
    result = step_of(4, 10, 0.25)
    expected = np.r_[np.full(4, 1 + 0.5 / 4), np.full(10, 3 - 0.5 / 10)]
    assert result.values == pytest.approx(expected, abs=2e-3)
    # Strong enough, it leaves the mean.
    assert step_of(4, 10, 4.0).values == pytest.approx(np.full(14, (4 + 30) / 14), abs=2e-3)


def test_the_power_iteration_finds_the_norm(truth):
    system = system_of(truth)
    weights = np.random.default_rng(0).uniform(0.5, 1.5, 400)
    expected = np.linalg.norm(np.sqrt(weights)[:, None] * dense(system), 2)
    assert norm(system.paths, weights) == pytest.approx(expected, rel=5e-3)


@pytest.mark.parametrize("name", ["pml-quad", "pml-hybrid"])
def test_penalised_likelihood_ends_where_its_slope_is_zero(name, truth):
    """A'(1 − b/Ax) + β Σ φ'(Δ) = 0 at the optimum, with the penalty's own derivative."""
    system = system_of(truth, 1.0)
    beta = 0.05
    result = reconstruct(
        name, system, Options(iterations=4000, regularization=beta, start=2.0, edge_density=0.2)
    )
    x, rows = result.values, dense(system)
    strength = beta * rows.sum(axis=0).mean() / 2.0
    difference = system.lattice.gradient().toarray()
    step = difference @ x
    pull = step / (1 + np.abs(step) / 0.2) if name == "pml-hybrid" else step
    likelihood = rows.T @ (1 - system.data / (rows @ x))
    slope = likelihood + strength * difference.T @ pull
    assert np.abs(slope).max() < 5e-3 * np.abs(likelihood).max()


def test_the_bayesian_mean_and_error_have_their_closed_form(truth):
    """Against the dense formulas with exp(−d/ℓ) between all voxels."""
    system = system_of(truth, 3.0)
    options = Options(
        prior_density=2.2, prior_deviation=0.4, correlation_length_m=15.0, iterations=500
    )
    result = reconstruct("bayes", system, options)
    centres, rows = GRID.all_centres_m(), dense(system)
    distance = np.linalg.norm(centres[:, None] - centres[None], axis=2)
    prior = 0.16 * np.exp(-distance / 15.0)
    gain = prior @ rows.T @ np.linalg.inv(rows @ prior @ rows.T + 9.0 * np.eye(400))
    expected = 2.2 + gain @ (system.data - rows @ np.full(48, 2.2))
    deviation = np.sqrt(np.diag(prior - gain @ rows @ prior))
    assert result.values == pytest.approx(expected, rel=2e-3)
    assert result.deviation == pytest.approx(deviation, rel=0.01)
    assert np.all(result.deviation < 0.4)


def test_sampled_errors_agree_with_the_full_ones(truth, monkeypatch):
    """200 draws give deviations to 5 %; the mean over 48 voxels lies nearer."""
    system = system_of(truth, 3.0, StoredPaths(path_matrix(paths_of(60))))
    options = Options(prior_deviation=0.4, correlation_length_m=15.0, posterior_samples=200)
    full = reconstruct("bayes", system, options)
    monkeypatch.setattr(bayes, "_MOST_DENSE", 10)
    sampled = reconstruct("bayes", system, options)
    assert sampled.values == pytest.approx(full.values)
    assert sampled.deviation == pytest.approx(full.deviation, rel=0.25)
    assert np.mean(sampled.deviation / full.deviation) == pytest.approx(1, abs=0.03)
    none = reconstruct("bayes", system, Options(posterior_samples=0))
    assert none.deviation is None


def test_the_covariance_of_missing_voxels_is_that_of_the_rest():
    active = np.random.default_rng(0).random((5, 4, 3)) < 0.6
    lattice = Lattice((10.0, 20.0, 5.0), active)
    centres = np.argwhere(active) * [10, 20, 5]
    distance = np.linalg.norm(centres[:, None] - centres[None], axis=2)
    covariance = lattice.covariance(0.5, 25.0)
    product = np.stack([covariance(unit) for unit in np.eye(lattice.count)])
    assert product == pytest.approx(0.25 * np.exp(-distance / 25), abs=2e-3)
    drawn = np.random.default_rng(1)
    noise = drawn.standard_normal((3, covariance.root_size))
    for one in noise:
        # B Bᵀ = C, and Bᵀ is the transpose of B.
        value = drawn.standard_normal(lattice.count)
        back = covariance.root_transposed(value)
        assert covariance.root(back) == pytest.approx(covariance(value))
        assert value @ covariance.root(one) == pytest.approx(back @ one)


def test_neighbours_do_not_reach_across_air():
    lattice = Lattice((1.0, 1.0), np.array([[True, False, True], [True, True, True]]))
    low, high, weight = lattice.pairs()
    assert sorted(zip(low.tolist(), high.tolist())) == [(0, 2), (1, 4), (2, 3), (3, 4)]
    assert np.all(weight == 1)
    expanded = lattice.expand(np.arange(5.0))
    assert np.array_equal(expanded, [[0, np.nan, 1], [2, 3, 4]], equal_nan=True)


def test_differences_count_per_length():
    """A field that rises evenly along each axis has the same gradient in flat voxels."""
    lattice = Lattice((20.0, 20.0, 5.0), np.ones((3, 3, 3), bool))
    place = np.argwhere(lattice.active) * [20.0, 20.0, 5.0]
    middle = 2000 ** (1 / 3)
    for axis in range(3):
        steps = lattice.gradient() @ place[:, axis]
        assert steps[np.abs(steps) > 1e-9] == pytest.approx(middle)


def test_rays_without_data_or_rock_are_left_out(truth):
    system = system_of(truth)
    system.data[::3] = np.nan
    away = Rays(np.array([[-5.0, 0, 0]]), np.array([[-1.0, 0, 0]]), np.array([0]))
    assert len(system.usable().data) == 400 - 134
    assert reconstruct("sirt", system, Options(iterations=500)).values == pytest.approx(
        truth, rel=0.1
    )
    lost = System(
        StoredPaths(path_matrix(paths_through(GRID, away))), np.ones(1), Lattice.of(GRID),
        np.zeros(1, int),
    )  # fmt: skip
    with pytest.raises(MuyscError, match="None of the 1 rays crosses rock"):
        reconstruct("sirt", lost)
    unsure = system_of(truth, errors=np.where(np.arange(400) % 4 == 0, 0.0, 1.0))
    assert len(unsure.usable().data) == 300


@pytest.mark.parametrize("name", ["art", "bart", "sart", "sirt", "mlem", "osem", "ospml-quad"])
def test_what_no_ray_meets_stays_as_it_was(name, truth):
    system = system_of(truth, paths=StoredPaths(path_matrix(paths_of(3))))
    values = reconstruct(name, system, Options(start=1.0, regularization=0.0)).values
    unseen = system.paths.coverage() == 0
    assert np.count_nonzero(unseen) > 10
    assert values[unseen] == pytest.approx(np.ones(unseen.sum()))


def test_noisy_rays_count_less(truth):
    """A tenth of the data is grossly wrong and says so."""
    errors = np.where(np.arange(400) % 10 == 3, 300.0, 1.0)
    for name in sorted(METHODS):
        system = system_of(truth, errors=errors)
        system.data[:] += errors * np.random.default_rng(2).standard_normal(400)
        blind = System(system.paths, system.data, system.lattice, system.view, np.ones(400))
        options = Options(iterations=40, discrepancy=0.0, regularization=0.01)
        assert off(reconstruct(name, system, options).values, truth) < 0.5 * off(
            reconstruct(name, blind, options).values, truth
        ), name


def test_the_best_homogeneous_density(truth):
    assert system_of(np.full(48, 2.4)).homogeneous() == pytest.approx(2.4, rel=1e-6)
    assert start_vector(system_of(np.full(48, 2.4)), None) == pytest.approx(np.full(48, 2.4))


@pytest.mark.parametrize("ordering", ["interleaved", "sequential", "random"])
@pytest.mark.parametrize("name", ["art", "bart", "sart", "osem", "ospml-quad"])
def test_any_order_serves(name, ordering, truth):
    options = Options(
        iterations=400, ordering=ordering, regularization=0.0, subsets=3, relaxation=0.9
    )
    assert off(reconstruct(name, system_of(truth), options).values, truth) < 0.02


@pytest.mark.parametrize("name", sorted(METHODS))
def test_every_method_can_be_stopped(name, truth):
    asked = []

    def progress(fraction):
        assert 0 <= fraction <= 1
        asked.append(fraction)
        return len(asked) < 4

    with pytest.raises(Cancelled):
        reconstruct(name, system_of(truth, 1.0), Options(discrepancy=0.0), progress)


@pytest.mark.parametrize("name", sorted(METHODS))
def test_progress_never_falls_and_ends_at_one(name, truth):
    told = []
    reconstruct(
        name, system_of(truth, 1.0), Options(iterations=7), lambda share: told.append(share) or True
    )
    assert told[-1] == 1.0
    assert np.all(np.diff(told) >= 0)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda s: reconstruct("fbp", s), "Filtered back-projection needs parallel rays"),
        (lambda s: reconstruct("gridrec", s), "Gridrec needs parallel rays all around"),
        (lambda s: method_of("magic"), "“magic” is not a reconstruction method; use one of art"),
        (lambda s: reconstruct("bayes", s), "needs the standard errors of the data"),
        (lambda s: Options(relaxation=2.5), "relaxation is 2.5"),
        (lambda s: Options(iterations=0), "number of iterations is 0; give at least 1"),
        (lambda s: Options(regularization=-1), "regularisation is -1; give at least 0"),
        (lambda s: Options(ordering="best"), "“best” is not an order of rays"),
        (lambda s: Options(edge_density=0), "density step"),
        (lambda s: reconstruct("sirt", s, Options(start=np.ones(3))), "3 values for 48 unknowns"),
        (lambda s: reconstruct("sirt", s, Options(start=np.nan)), "not finite"),
        (lambda s: System(s.paths, s.data[1:], s.lattice, s.view), "399 data"),
        (lambda s: System(s.paths, s.data, Lattice((1.0,), np.ones(3, bool)), s.view),
         "48 unknowns and the lattice 3"),
        (lambda s: s.lattice.covariance(0.1, 0), "correlation length of 0 m"),
        (lambda s: s.lattice.covariance(0.1, 1e-300), r"1e-06 at least"),
        (lambda s: s.lattice.covariance(3e162, 100.0), r"deviation of 3e\+162 and"),
    ],
)  # fmt: skip
def test_what_cannot_be_solved_is_refused(make, message, truth):
    with pytest.raises(MuyscError, match=message):
        make(system_of(truth))
