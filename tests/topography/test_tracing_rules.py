"""What is known about a ray: gaps, edges, ranges, and where the detector stands."""

import numpy as np
import pytest

from muysc_qgis.radiography.raytracing import Outcome

CELL = 10.0


def ridge(east, north):
    """Return a ridge 500 m east of the detector, 200 m high, 400 m wide."""
    return np.maximum(0.0, 200.0 - np.abs(east - 500.0))


@pytest.fixture
def ridge_dem(metric_dem, place):
    """Return a function that writes the ridge, with the cells where `gap` unknown."""

    def make(gap=None, half_width=1500.0, shape=ridge, **keywords):
        def surface(east, north):
            heights = shape(east, north) + place.bulge(east, north)
            if gap is not None:
                heights[gap(east, north)] = np.nan
            return heights

        return metric_dem(surface, CELL, half_width, **keywords)

    return make


EAST = np.array([80.0, 90.0, 97.0])
RISING = np.array([2.0, 8.0, 15.0, 30.0, 50.0])


def through_ridge(azimuth, elevation):
    """Return distances at which rays from its foot's level enter and leave the ridge."""
    along = np.sin(np.radians(azimuth))[:, None]
    t = np.tan(np.radians(elevation))[None, :]
    with np.errstate(divide="ignore"):
        return np.where(along > t, 300.0 / (along - t), np.inf), 700.0 / (along + t)


def same(one, other, **keywords):
    for name in ("outcome", "thickness_m", "distance_m", "exit_m"):
        np.testing.assert_allclose(getattr(one, name), getattr(other, name), **keywords)


class TestGaps:
    def test_gap_beside_the_rays_does_not_matter(self, ridge_dem, trace):
        path = ridge_dem(lambda e, n: (np.abs(e - 500) < 60) & (n > 400))
        same(trace(path, 90.0, RISING, eye=0.0), trace(ridge_dem(), 90.0, RISING, eye=0.0))

    def test_ray_lower_than_the_highest_ground_is_unknown_past_a_gap(self, ridge_dem, trace):
        # A gap in the plain beyond the ridge, where rays are 800 tan(e) high.
        path = ridge_dem(lambda e, n: np.abs(e - 850) < 30)
        elevation = np.degrees(np.arctan(np.array([50.0, 195.0, 205.0, 400.0]) / 810.0))
        rock = trace(path, 90.0, elevation, eye=0.0)
        assert rock.outcome[0].tolist() == [
            Outcome.NO_DATA, Outcome.NO_DATA, Outcome.KNOWN, Outcome.KNOWN,
        ]  # fmt: skip
        assert np.isnan(rock.thickness_m[0, :2]).all()
        assert np.isnan(rock.exit_m[0, :2]).all()
        whole = trace(ridge_dem(), 90.0, elevation, eye=0.0)
        np.testing.assert_allclose(rock.thickness_m[0, 2:], whole.thickness_m[0, 2:], rtol=1e-12)
        # The ridge stands before the gap, so that the first rock is known.
        np.testing.assert_allclose(rock.distance_m, whole.distance_m, rtol=1e-12)

    def test_gap_in_the_flank_hides_the_first_rock(self, ridge_dem, trace):
        path = ridge_dem(lambda e, n: np.abs(e - 300) < 40)
        rock = trace(path, 90.0, np.array([5.0]), eye=0.0)
        assert rock.outcome[0, 0] == Outcome.NO_DATA
        assert np.isnan(rock.distance_m[0, 0])

    @pytest.mark.parametrize("beyond", [900.0, 620.0, 380.0])
    def test_no_data_to_the_end_is_the_edge_of_the_model(self, ridge_dem, trace, beyond):
        trailing = trace(ridge_dem(lambda e, n: e > beyond), EAST, RISING, eye=0.0)
        # The same where the raster itself ends there: the last known column is
        # the last whose both sides are known.
        last = np.floor(beyond / CELL) * CELL
        centre = (last - 1500.0, 0.0)
        cropped = trace(ridge_dem(centre=centre), EAST, RISING, eye=0.0)
        assert set(np.unique(trailing.outcome)) <= {Outcome.KNOWN, Outcome.EDGE}
        same(trailing, cropped, rtol=1e-6)
        in_rock = (through_ridge(EAST, RISING)[0] < last / np.sin(np.radians(EAST))[:, None]) & (
            through_ridge(EAST, RISING)[1] > last / np.sin(np.radians(EAST))[:, None]
        )
        np.testing.assert_array_equal(trailing.outcome == Outcome.EDGE, in_rock)

    def test_only_ground_on_its_way_judges_a_ray(self, ridge_dem, trace):
        # A tower between two rays far above it, higher than they are where they pass
        # a gap in the plain.
        def tower(east, north):
            return np.where((np.abs(east - 1300) < 15) & (np.abs(north - 40) < 15), 100.0, 0.0)

        path = ridge_dem(lambda e, n: np.abs(e - 300) < 30, shape=tower)
        across = 90.0 - np.degrees(np.arctan(40 / 1300))
        rock = trace(path, [90.0, across, 86.0], np.array([10.0]), eye=1.0)
        assert rock.outcome[:, 0].tolist() == [Outcome.KNOWN, Outcome.NO_DATA, Outcome.KNOWN]
        assert rock.thickness_m[0, 0] == rock.thickness_m[2, 0] == 0

    def test_one_ray_past_gaps_is_the_one_among_many(self, ridge_dem, trace):
        generator = np.random.default_rng(8)
        voids = generator.uniform(-1200.0, 1200.0, (40, 2))

        def hills(east, north):
            return 80.0 * (1 + np.sin(east / 150.0) * np.cos(north / 190.0))

        def gap(east, north):
            near = np.hypot(east[..., None] - voids[:, 0], north[..., None] - voids[:, 1])
            return near.min(axis=-1) < 25.0

        path = ridge_dem(gap, shape=hills, half_width=1300.0)
        azimuth, elevation = np.arange(0.0, 360.0, 5.0), np.array([-2.0, 0.0, 2.0, 5.0, 9.0, 20.0])
        many = trace(path, azimuth, elevation, eye=100.0)
        rays = [
            ray for code in (Outcome.KNOWN, Outcome.EDGE, Outcome.NO_DATA)
            for ray in np.argwhere(many.outcome == code)[::9]
        ]  # fmt: skip
        assert len(rays) > 40
        assert np.count_nonzero(many.outcome == Outcome.NO_DATA) > 60
        for row, column in rays:
            one = trace(path, azimuth[row], elevation[column], eye=100.0)
            for name in ("outcome", "thickness_m", "distance_m", "exit_m"):
                np.testing.assert_allclose(
                    getattr(one, name)[0, 0], getattr(many, name)[row, column], rtol=1e-9
                )


class TestEdgeAndRange:
    def test_ray_in_rock_at_the_edge_is_unknown(self, ridge_dem, trace):
        # The raster ends on the crest.
        path = ridge_dem(centre=(-1000.0, 0.0))
        rock = trace(path, EAST, RISING, eye=0.0)
        crest = np.degrees(np.arctan(200 / 500 * np.sin(np.radians(EAST))))
        below = RISING[None, :] < crest[:, None]
        np.testing.assert_array_equal(rock.outcome == Outcome.EDGE, below)
        np.testing.assert_array_equal(np.isnan(rock.thickness_m), below)
        assert np.all(rock.thickness_m[~below] == 0)
        near, _ = through_ridge(EAST, RISING)
        first = near / np.cos(np.radians(RISING))
        np.testing.assert_allclose(rock.distance_m[below], first[below], rtol=1e-6)

    def test_users_range_cuts_the_thickness(self, ridge_dem, trace):
        rock = trace(ridge_dem(), EAST, RISING, eye=0.0, max_range_m=510.0)
        near, far = through_ridge(EAST, RISING)
        cut = (near < 510.0) & (far > 510.0)
        assert 0 < np.count_nonzero(cut) < cut.size
        np.testing.assert_array_equal(rock.outcome == Outcome.TRUNCATED, cut)
        length = np.clip(np.minimum(far, 510.0) - near, 0, None) / np.cos(np.radians(RISING))
        np.testing.assert_allclose(rock.thickness_m, length, rtol=1e-6, atol=1e-6)

    def test_range_beyond_the_edge_changes_nothing(self, ridge_dem, trace):
        path = ridge_dem(centre=(-1000.0, 0.0))
        free = trace(path, EAST, RISING, eye=0.0)
        same(trace(path, EAST, RISING, eye=0.0, max_range_m=5000.0), free, rtol=1e-12)
        assert np.any(free.outcome == Outcome.EDGE)

    def test_near_field_ignores_what_is_nearer(self, ridge_dem, trace):
        def two(east, north):
            return np.maximum(ridge(east, north), np.maximum(0.0, 30.0 - np.abs(east - 50.0)))

        elevation = np.array([2.0, 8.0])
        both = trace(ridge_dem(shape=two), EAST, elevation, eye=0.0)
        far = trace(ridge_dem(shape=two), EAST, elevation, eye=0.0, near_field_m=150.0)
        alone = trace(ridge_dem(), EAST, elevation, eye=0.0)
        assert np.all(both.thickness_m > far.thickness_m + 10.0)
        np.testing.assert_allclose(far.thickness_m, alone.thickness_m, rtol=1e-9)
        np.testing.assert_allclose(far.distance_m, alone.distance_m, rtol=1e-9)

    def test_near_field_that_ends_in_rock_cuts_there(self, ridge_dem, trace):
        rock = trace(ridge_dem(), 90.0, np.array([5.0]), eye=0.0, near_field_m=450.0)
        _, far = through_ridge(np.array([90.0]), np.array([5.0]))
        cosine = np.cos(np.radians(5.0))
        assert rock.thickness_m[0, 0] == pytest.approx((far[0, 0] - 450.0) / cosine, rel=1e-6)
        assert rock.distance_m[0, 0] == pytest.approx(450.0 / cosine)

    @pytest.mark.parametrize("split", [200.0, 333.3, 500.0, 640.0])
    def test_ranges_that_complete_each_other_add_up(self, ridge_dem, trace, split):
        path = ridge_dem()
        whole = trace(path, EAST, RISING, eye=0.0)
        near = trace(path, EAST, RISING, eye=0.0, max_range_m=split)
        far = trace(path, EAST, RISING, eye=0.0, near_field_m=split)
        np.testing.assert_allclose(
            near.thickness_m + far.thickness_m, whole.thickness_m, rtol=1e-9, atol=1e-6
        )

    def test_near_field_beyond_the_edge_leaves_sky(self, ridge_dem, trace):
        path = ridge_dem(half_width=1000.0)
        rock = trace(path, EAST, RISING, eye=0.0, near_field_m=5000.0)
        assert np.all(rock.thickness_m == 0)


class TestDetector:
    def test_on_the_ground_sky_is_exactly_without_rock(self, data_folder, trace):
        path = str(data_folder / "vesuvius_srtmgl1.tif")
        # Away from the mountain, over falling ground.
        rock = trace(
            path, np.arange(200.0, 260.0, 1.7), np.array([4.0, 10.0, 60.0, 90.0]),
            14.410686, 40.810561, above=0.0,
        )  # fmt: skip
        assert np.all(rock.thickness_m == 0)
        assert np.isnan(rock.distance_m).all()
        assert np.isnan(rock.exit_m).all()

    @pytest.mark.parametrize("shift", [(0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.5, 0.5), (0.3, 0.8)])
    def test_on_a_slope_no_grid_line_underfoot_matters(self, metric_dem, trace, shift):
        # Cell centre, edge and corner underfoot; the plane rises to the east by 10°.
        slope = np.tan(np.radians(10.0))
        path = metric_dem(lambda e, n: 300.0 + slope * e, 10.0, 1000.0, shift)
        rock = trace(path, 90.0, np.array([9.9, 10.1, 45.0, 90.0]), above=0.0)
        assert np.all(rock.thickness_m[0, 1:] == 0)
        assert np.isnan(rock.distance_m[0, 1:]).all()
        assert rock.outcome[0, 0] == Outcome.EDGE
        assert rock.distance_m[0, 0] == 0

    @pytest.mark.parametrize("azimuth", [0.0, 45.0, 90.0, 180.0, 225.0, 270.0])
    @pytest.mark.parametrize("shift", [(0.0, 0.0), (0.5, 0.5), (0.3, 0.8)])
    def test_underground_the_ray_along_a_grid_line_is_no_special_case(
        self, ridge_dem, trace, azimuth, shift
    ):
        # Level ground 100 m up, on which the Earth's bulge leaves 5 mm.
        path = ridge_dem(shape=lambda e, n: 0 * e + 100.0, shift=shift)
        elevation = np.array([30.0, 89.9, 90.0])
        rock = trace(path, azimuth, elevation, eye=60.0)
        np.testing.assert_allclose(
            rock.thickness_m[0], 40.0 / np.sin(np.radians(elevation)), rtol=1e-5
        )

    def test_above_the_ground_the_ridge_is_lower(self, ridge_dem, trace):
        rock = trace(ridge_dem(), 90.0, np.array([5.0]), eye=60.0)
        t = np.tan(np.radians(5.0))
        near, far = (300.0 + 60.0) / (1 - t), (700.0 - 60.0) / (1 + t)
        cosine = np.cos(np.radians(5.0))
        assert rock.thickness_m[0, 0] == pytest.approx((far - near) / cosine, rel=1e-6)

    def test_within_the_ridge_only_the_rest_counts(self, ridge_dem, trace):
        rock = trace(ridge_dem(), [90.0, 270.0], np.array([0.0, 20.0, 90.0]), x=500.0, eye=100.0)
        t = np.tan(np.radians([0.0, 20.0]))
        expected = [*(100 / (1 + t) / np.cos(np.radians([0.0, 20.0]))), 100.0]
        # The Earth's bulge, added around the place 500 m away, is 20 mm here.
        np.testing.assert_allclose(rock.thickness_m, [expected, expected], atol=0.03)

    def test_looking_down_from_a_tower_ends_in_rock(self, ridge_dem, trace):
        path = ridge_dem()
        rock = trace(path, 270.0, np.array([-45.0, -10.0]), eye=50.0)
        assert np.all(rock.outcome == Outcome.EDGE)
        assert rock.distance_m[0, 0] == pytest.approx(50.0 * np.sqrt(2), rel=1e-5)
        cut = trace(path, 270.0, np.array([-45.0, -10.0]), eye=50.0, max_range_m=400.0)
        assert np.all(cut.outcome == Outcome.TRUNCATED)
        ground = 50.0 / np.tan(np.radians([45.0, 10.0]))
        np.testing.assert_allclose(
            cut.thickness_m[0], (400 - ground) / np.cos(np.radians([45.0, 10.0])), rtol=1e-4
        )

    def test_looking_down_into_a_valley_and_out_again(self, ridge_dem, trace):
        # On the crest, over a plain, at a second ridge 80 m below.
        def two(east, north):
            return np.maximum(ridge(east, north), np.maximum(0.0, 120.0 - np.abs(east - 1000.0)))

        elevation = np.array([-13.0, -11.0, -8.0])
        rock = trace(ridge_dem(shape=two), 90.0, elevation, x=500.0, eye=201.0)
        # Through the ridge into the plain; through the ridge alone; over it.
        assert rock.outcome[0].tolist() == [Outcome.EDGE, Outcome.KNOWN, Outcome.KNOWN]
        t, cosine = np.tan(np.radians(11.0)), np.cos(np.radians(11.0))
        near, far = (201.0 + 380.0) / (1 + t), (620.0 - 201.0) / (1 - t)
        assert rock.thickness_m[0, 1] == pytest.approx((far - near) / cosine, abs=0.2)
        assert rock.distance_m[0, 1] == pytest.approx(near / cosine, rel=1e-3)
        assert rock.thickness_m[0, 2] == 0

    def test_on_the_last_column_it_sees_inwards(self, metric_dem, trace):
        path = metric_dem(lambda e, n: 100.0 + 0 * e, 10.0, 500.0, centre=(-500.0, 0.0))
        rock = trace(path, [270.0, 225.0, 0.0, 180.0], np.array([30.0, 90.0]), eye=50.0)
        np.testing.assert_allclose(rock.thickness_m, [[100.0, 50.0]] * 4, rtol=1e-4)

    def test_on_the_last_column_what_lies_outwards_is_the_edge(self, metric_dem, trace):
        path = metric_dem(lambda e, n: 100.0 + 0 * e, 10.0, 500.0, centre=(-500.0, 0.0))
        elevation = np.array([10.0, 60.0])
        over = trace(path, [90.0, 45.0], elevation, above=2.0)
        assert np.all(over.outcome == Outcome.KNOWN)
        assert np.all(over.thickness_m == 0)
        under = trace(path, [90.0, 45.0], elevation, above=-2.0)
        assert np.all(under.outcome == Outcome.EDGE)
        assert np.isnan(under.thickness_m).all()

    @pytest.mark.parametrize("side", ["west", "east", "north", "south"])
    def test_along_the_outermost_cells_rounding_does_not_end_the_view(self, write_dem, trace, side):
        # A detector beyond the outermost cell centres by 1e-7 of a cell.
        step = 1e-4
        path = write_dem(
            np.full((300, 300), 100.0), "EPSG:4326",
            (-0.3 - step / 2, step, 0.0, 0.015 + step / 2, 0.0, -step),
        )  # fmt: skip
        west, east = -0.3 - 1e-11, -0.3 + 299 * step + 1e-11
        north, south = 0.015 + 1e-11, 0.015 - 299 * step - 1e-11
        x, y, azimuth = {
            "west": (west, 0.0, [0.0, 180.0]), "east": (east, 0.0, [0.0, 180.0]),
            "north": (-0.285, north, [90.0, 270.0]), "south": (-0.285, south, [90.0, 270.0]),
        }[side]  # fmt: skip
        rock = trace(path, azimuth, np.array([30.0]), x, y, above=-20.0)
        np.testing.assert_allclose(rock.thickness_m, 40.0, rtol=1e-4)

    def test_close_to_the_edge_underground(self, metric_dem, trace):
        # 3 m from the edge and 2 m down: only rays steeper than 34° get out.
        path = metric_dem(lambda e, n: 100.0 + 0 * e, 10.0, 500.0, centre=(-497.0, 0.0))
        rock = trace(path, 90.0, np.array([20.0, 33.0, 35.0, 70.0]), above=-2.0)
        assert rock.outcome[0].tolist() == [
            Outcome.EDGE, Outcome.EDGE, Outcome.KNOWN, Outcome.KNOWN,
        ]  # fmt: skip


class TestRays:
    def test_one_ray_has_one_of_everything(self, ridge_dem, trace):
        rock = trace(ridge_dem(), 90.0, 8.0, eye=0.0)
        for name in ("thickness_m", "distance_m", "exit_m", "outcome"):
            assert getattr(rock, name).shape == (1, 1)
        near, far = through_ridge(np.array([90.0]), np.array([8.0]))
        cosine = np.cos(np.radians(8.0))
        assert rock.thickness_m[0, 0] == pytest.approx((far - near)[0, 0] / cosine, rel=1e-6)

    def test_azimuths_come_back_in_the_order_they_were_given(self, data_folder, trace):
        path = str(data_folder / "vesuvius_srtmgl1.tif")
        here = (14.410686, 40.810561)
        azimuth, elevation = np.linspace(20.0, 60.0, 9), np.array([8.0, 14.0, 20.0])
        straight = trace(path, azimuth, elevation, *here, above=1.0)
        assert len(np.unique(straight.thickness_m[:, 0])) == 9
        order = np.array([4, 0, 8, 2, 6, 1, 7, 3, 5])
        mixed = trace(path, azimuth[order], elevation, *here, above=1.0)
        np.testing.assert_allclose(mixed.thickness_m, straight.thickness_m[order], rtol=1e-12)
        # North is crossed either way, and a turn more is the same direction.
        for turn in (-360.0, 360.0):
            turned = trace(path, azimuth + turn, elevation, *here, above=1.0)
            np.testing.assert_allclose(turned.thickness_m, straight.thickness_m, atol=1e-6)

    @pytest.mark.parametrize("above", [-20.0, 0.0, 1.5])
    def test_scattered_rays_are_those_of_the_grid(self, data_folder, trace, above):
        path = str(data_folder / "vesuvius_srtmgl1.tif")
        here = (14.410686, 40.810561)
        azimuth = np.linspace(-170.0, 180.0, 36)
        elevation = np.array([-20.0, -2.0, 0.0, 1.0, 5.0, 9.0, 14.0, 22.0, 40.0, 90.0])
        grid = trace(path, azimuth, elevation, *here, above=above)
        scattered = trace(
            path, np.repeat(azimuth, 10), np.tile(elevation, 36)[:, None], *here, above=above
        )
        assert {Outcome.KNOWN, Outcome.EDGE} <= set(np.unique(grid.outcome))
        for name in ("outcome", "thickness_m", "distance_m", "exit_m"):
            np.testing.assert_allclose(
                getattr(scattered, name)[:, 0], getattr(grid, name).ravel(), rtol=1e-9, atol=1e-7
            )

    def test_convex_hill_is_thinner_the_higher_one_looks(self, metric_dem, trace, place):
        def dome(east, north):
            distance = np.hypot(east - 800.0, north)
            return 500.0 - distance**2 / 900.0 + place.bulge(east, north)

        elevation = np.linspace(0.5, 40.0, 80)
        rock = trace(metric_dem(dome, 20.0, 2000.0), [80.0, 90.0, 95.0], elevation, eye=0.0)
        assert np.all(np.diff(rock.thickness_m, axis=1) <= 0)
        assert rock.thickness_m[1, 0] > 1000.0
        assert rock.thickness_m[1, -1] == 0

    @pytest.mark.parametrize("elevation", [2.0, 3.0, 5.0])
    def test_highest_mountain_on_earth_is_within_reach(self, write_dem, trace, place, elevation):
        # A wall of 8800 m where the ray has climbed to 8700 m over level ground.
        t, radius = np.tan(np.radians(elevation)), place.radius
        climbed = radius * (np.sqrt(t**2 + 2 * 8700.0 / radius) - t)
        cell = 500.0
        columns = int(climbed / cell) + 10
        heights = np.zeros((5, columns))
        heights[:, int(climbed / cell) :] = 8800.0
        path = write_dem(heights, place.metric_crs, (-cell / 2, cell, 0.0, 2.5 * cell, 0.0, -cell))
        rock = trace(path, 90.0, elevation, eye=0.0, max_range_m=climbed + 1000.0)
        assert rock.thickness_m[0, 0] > 500.0

    def test_flat_detector_site_sees_nothing_above_the_horizon(self, metric_dem, trace):
        path = metric_dem(lambda e, n: 0 * e, 50.0, 5000.0)
        rock = trace(path, np.arange(0.0, 360.0, 7.0), np.array([0.0, 0.001, 5.0]), above=0.0)
        assert np.all(rock.thickness_m == 0)
        assert np.all(rock.outcome == Outcome.KNOWN)
