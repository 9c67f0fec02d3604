"""Rays over profiles made by hand, against a plain loop over pieces and rays."""

import math

import numpy as np
import pytest

from muysc_qgis.radiography.raytracing import Outcome, ProfilePieces, rock_along_rays

UNKNOWN = (math.nan, math.nan, math.nan)


def profile(*pieces, ray=0):
    """Return pieces given as (start, end, (constant, linear, quadratic))."""
    rows = np.array([(start, end, *terms) for start, end, terms in pieces], float)
    return ProfilePieces(np.full(len(rows), ray), *rows.T)


def look(elevation, *pieces, range_m=math.inf):
    return rock_along_rays([profile(*pieces)], np.atleast_1d(elevation), np.array([range_m]))


def joined(profiles):
    """Join the profiles of several rays into one block."""
    names = ("ray", "start_m", "end_m", "constant", "linear", "quadratic")
    return ProfilePieces(*(np.concatenate([getattr(p, name) for p in profiles]) for name in names))


def rock_by_loop(pieces, elevation):
    """Return thickness, first and last rock of one ray, by the roots on each piece."""
    tangent, cosine = math.tan(math.radians(elevation)), math.cos(math.radians(elevation))
    total, first, last = 0.0, math.nan, math.nan
    for start, end, (constant, linear, quadratic) in pieces:
        roots = np.roots([quadratic, linear - tangent, constant])
        roots = roots[np.isreal(roots)].real
        cuts = [start, *sorted(r for r in roots if start < r < end), end]
        for a, b in zip(cuts, cuts[1:]):
            s = (a + b) / 2
            if constant + (linear + quadratic * s) * s > tangent * s:
                total += b - a
                first = a if math.isnan(first) else first
                last = b
    return total / cosine, first / cosine, last / cosine


def random_profile(generator):
    """Return a continuous profile of quadratics, whose ends are air."""
    s = np.concatenate([[0.0], np.sort(generator.uniform(5.0, 2000.0, 60)), [2010.0]])
    height = generator.uniform(-100.0, 900.0, len(s)) * np.sin(np.pi * s / s[-1])
    height[0], height[-1] = -2.0, -300.0
    pieces = []
    for a, b, ha, hb in zip(s, s[1:], height, height[1:]):
        bend = generator.normal(0.0, 0.02)
        slope = (hb - ha) / (b - a) - bend * (b - a)
        # ha + slope (s − a) + bend (s − a)², in powers of s.
        pieces.append((a, b, (ha - slope * a + bend * a * a, slope - 2 * bend * a, bend)))
    return pieces


@pytest.mark.parametrize("seed", range(5))
def test_random_profiles_agree_with_a_plain_loop(seed):
    generator = np.random.default_rng(seed)
    profiles = [random_profile(generator) for _ in range(4)]
    elevation = np.sort(generator.uniform(0.1, 60.0, 25))
    blocks = [joined([profile(*pieces, ray=ray) for ray, pieces in enumerate(profiles)])]
    rock = rock_along_rays(blocks, elevation, np.full(4, np.inf))
    exact = np.array([[rock_by_loop(pieces, e) for e in elevation] for pieces in profiles])
    assert np.all(rock.outcome == Outcome.KNOWN)
    assert rock.thickness_m.max() > 500.0
    np.testing.assert_allclose(rock.thickness_m, exact[..., 0], rtol=1e-9, atol=1e-7)
    np.testing.assert_allclose(rock.distance_m, exact[..., 1], rtol=1e-9)
    np.testing.assert_allclose(rock.exit_m, exact[..., 2], rtol=1e-9)


def test_blocks_cut_anywhere_give_the_same():
    pieces = random_profile(np.random.default_rng(11))
    elevation = np.linspace(1.0, 50.0, 30)
    whole = look(elevation, *pieces)
    blocks = [profile(*pieces[:7]), profile(*pieces[7:8]), profile(*pieces[8:])]
    cut = rock_along_rays(blocks, elevation, np.array([np.inf]))
    np.testing.assert_allclose(cut.thickness_m, whole.thickness_m, rtol=1e-12)
    np.testing.assert_array_equal(cut.distance_m, whole.distance_m)
    np.testing.assert_array_equal(cut.exit_m, whole.exit_m)


def test_one_elevation_for_each_ray_is_the_diagonal_of_the_grid():
    generator = np.random.default_rng(3)
    profiles = [random_profile(generator) for _ in range(6)]
    elevation = np.linspace(3.0, 40.0, 6)
    block = joined([profile(*pieces, ray=ray) for ray, pieces in enumerate(profiles)])
    grid = rock_along_rays([block], elevation, np.full(6, np.inf))
    scattered = rock_along_rays([block], elevation[:, None], np.full(6, np.inf))
    assert scattered.thickness_m.shape == (6, 1)
    for name in ("thickness_m", "distance_m", "exit_m", "outcome"):
        np.testing.assert_array_equal(
            getattr(scattered, name)[:, 0], np.diagonal(getattr(grid, name))
        )


def test_vertical_ray_from_below_measures_the_depth():
    rock = look([89.0, 90.0], (0.0, 100.0, (30.0, 0.0, 0.0)))
    assert rock.thickness_m[0, 1] == pytest.approx(30.0, rel=1e-12)
    assert rock.thickness_m[0, 0] == pytest.approx(30.0 / math.sin(math.radians(89.0)))


def test_vertical_ray_from_the_open_meets_nothing():
    rock = look([90.0], (0.0, 10.0, (-1.0, 0.0, 0.0)), (10.0, 50.0, (900.0, 0.0, 0.0)))
    assert rock.thickness_m[0, 0] == 0
    assert np.isnan(rock.distance_m[0, 0])


def test_wall_is_crossed_at_its_faces():
    wall = [(0, 50, (-1, 0, 0)), (50, 80, (400, 0, 0)), (80, 200, (-1, 0, 0))]
    rock = look([30.0], *wall)
    cosine = math.cos(math.radians(30.0))
    assert rock.thickness_m[0, 0] == pytest.approx(30 / cosine)
    assert rock.distance_m[0, 0] == pytest.approx(50 / cosine)
    assert rock.exit_m[0, 0] == pytest.approx(80 / cosine)


def test_ray_along_the_ground_is_in_the_open():
    # A plane through the detector's foot, and rays on, over and under it.
    rock = look([9.0, 10.0, 11.0], (0, 300, (0.0, math.tan(math.radians(10.0)), 0.0)))
    assert rock.outcome[0].tolist() == [Outcome.EDGE, Outcome.KNOWN, Outcome.KNOWN]
    np.testing.assert_array_equal(rock.thickness_m[0, 1:], 0.0)
    assert np.all(np.isnan(rock.distance_m[0, 1:]))


def test_ray_that_only_touches_a_crest_meets_no_rock():
    # Crests one rounding step higher than the ray, where its stretch in rock may
    # round to nothing.
    generator = np.random.default_rng(0)
    elevation = np.sort(generator.uniform(1.0, 60.0, 400))
    profiles = []
    for ray, tangent in enumerate(np.tan(np.radians(elevation))):
        s = generator.uniform(10.0, 1000.0)
        crest = np.nextafter(tangent * s, np.inf)
        near, far = ((crest - slope * s, slope, 0.0) for slope in (tangent + 1.0, tangent - 1.0))
        profiles.append(profile((s - 5.0, s, near), (s, s + 5.0, far), ray=ray))
    rock = rock_along_rays([joined(profiles)], elevation[:, None], np.full(400, np.inf))
    assert rock.thickness_m.max() < 1e-9
    assert 0 < np.count_nonzero(rock.thickness_m) < 400
    np.testing.assert_array_equal(np.isfinite(rock.distance_m), rock.thickness_m > 0)
    np.testing.assert_array_equal(np.isfinite(rock.exit_m), rock.thickness_m > 0)


def test_rock_at_the_profile_end_is_unknown_but_where_it_begins_is_known():
    rock = look([5.0], (0, 100, (-1, 0, 0)), (100, 200, (50, 0, 0)))
    assert rock.outcome[0, 0] == Outcome.EDGE
    assert np.isnan(rock.thickness_m[0, 0])
    assert np.isnan(rock.exit_m[0, 0])
    assert rock.distance_m[0, 0] == pytest.approx(100 / math.cos(math.radians(5.0)))


def test_rock_at_the_users_range_is_cut_there():
    rock = look([5.0], (0, 100, (-1, 0, 0)), (100, 200, (50, 0, 0)), range_m=200.0)
    assert rock.outcome[0, 0] == Outcome.TRUNCATED
    assert rock.thickness_m[0, 0] == pytest.approx(100 / math.cos(math.radians(5.0)))


def test_gap_matters_to_rays_lower_than_the_highest_ground():
    # Ground up to 50 m before the gap, which begins 200 m away.
    pieces = [
        (0, 100, (-1, 0, 0)), (100, 200, (50, 0, 0)), (200, 300, UNKNOWN), (300, 400, (-1, 0, 0)),
    ]  # fmt: skip
    lower, higher = math.degrees(math.atan(49 / 200)), math.degrees(math.atan(51 / 200))
    rock = look([lower, higher], *pieces)
    assert rock.outcome[0].tolist() == [Outcome.NO_DATA, Outcome.KNOWN]
    assert np.isnan(rock.thickness_m[0, 0])
    # The higher ray meets the block's near side, over which it rises before the gap.
    assert rock.thickness_m[0, 1] > 0


def test_gap_at_the_top_of_a_slope_matters_up_to_its_rim():
    # The ground rises to 50 m where the gap begins.
    pieces = [
        (0, 100, (-1, 0, 0)),
        (100, 200, (-51, 0.505, 0)),
        (200, 250, UNKNOWN),
        (250, 300, (-9, 0, 0)),
    ]
    lower, higher = math.degrees(math.atan(49 / 200)), math.degrees(math.atan(51 / 200))
    rock = look([lower, higher], *pieces)
    assert rock.outcome[0].tolist() == [Outcome.NO_DATA, Outcome.KNOWN]
    assert rock.thickness_m[0, 1] == 0


def test_first_rock_before_a_gap_is_known_and_past_it_is_not():
    block, gap, sky = (80.0, 0, 0), UNKNOWN, (-1.0, 0, 0)
    before = look(5.0, (0, 50, sky), (50, 60, block), (60, 70, gap), (70, 80, sky))
    past = look(5.0, (0, 50, sky), (50, 60, gap), (60, 70, block), (70, 80, sky))
    assert before.outcome[0, 0] == past.outcome[0, 0] == Outcome.NO_DATA
    assert before.distance_m[0, 0] == pytest.approx(50 / math.cos(math.radians(5.0)))
    assert np.isnan(past.distance_m[0, 0])


def test_gap_to_the_end_is_the_edge_even_in_several_blocks():
    near = profile((0, 100, (-1, 0, 0)), (100, 150, UNKNOWN))
    far = profile((150, 900, UNKNOWN))
    rock = rock_along_rays([near, far], np.array([-5.0, 5.0]), np.array([np.inf]))
    assert rock.outcome[0].tolist() == [Outcome.EDGE, Outcome.KNOWN]
    assert rock.thickness_m[0, 1] == 0


def test_nothing_known_of_the_terrain_is_sky():
    rock = rock_along_rays([], np.array([1.0, 2.0]), np.array([np.inf, np.inf]))
    assert rock.thickness_m.shape == (2, 2)
    assert np.all(rock.thickness_m == 0)
