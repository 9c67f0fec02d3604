"""The section along the boresight: rock crossed, and how it is drawn."""

import re

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.plots.profile import section_panel
from muysc_qgis.plots.rays import Ray, rock_intervals, rock_label

pytestmark = pytest.mark.filterwarnings("error")

#: A mountain like a tent: from 0 m at 1 km up to 500 m at 2 km, down to 0 m at 3 km.
DISTANCE = np.linspace(0.0, 5000.0, 501)
TENT = np.maximum(0.0, 500.0 - 0.5 * np.abs(DISTANCE - 2000.0))


def tent_crossings(elevation_deg):
    """Where a ray from the origin cuts the two slopes of the tent."""
    slope = np.tan(np.radians(elevation_deg))
    return 500.0 / (0.5 - slope), 1500.0 / (0.5 + slope)


@pytest.mark.parametrize("elevation", [2.0, 7.3, 12.0])
def test_rock_of_a_tent_is_that_of_its_two_slopes(elevation):
    (interval,) = rock_intervals(DISTANCE, TENT, 0.0, elevation)
    assert interval == pytest.approx(tent_crossings(elevation))
    near, far = interval
    length = (far - near) / np.cos(np.radians(elevation))
    label = rock_label(DISTANCE, TENT, 0.0, Ray("", elevation), interval[None])
    assert label == f"{length:.0f} m of rock"


def test_crossings_do_not_depend_on_where_the_profile_has_points():
    coarse = np.array([0.0, 1000.0, 2000.0, 3000.0, 5000.0])
    ground = np.array([0.0, 0.0, 500.0, 0.0, 0.0])
    assert rock_intervals(coarse, ground, 0.0, 5.0) == pytest.approx(
        rock_intervals(DISTANCE, TENT, 0.0, 5.0)
    )


def test_a_ray_above_the_summit_meets_no_rock():
    assert rock_intervals(DISTANCE, TENT, 0.0, 14.1).shape == (0, 2)
    assert rock_label(DISTANCE, TENT, 0.0, Ray("", 14.1), np.empty((0, 2))) == "0 m of rock"


def test_two_ridges_are_two_stretches():
    ground = TENT + np.maximum(0.0, 500.0 - np.abs(DISTANCE - 4000.0))
    stretches = rock_intervals(DISTANCE, ground, 200.0, 0.0)
    assert stretches == pytest.approx(np.array([[1400.0, 2600.0], [3700.0, 4300.0]]))


def test_unknown_ground_and_the_end_inside_rock_make_a_lower_bound():
    ray = Ray("", 0.0)
    wall = np.where(DISTANCE > 1000.0, 300.0, 0.0)
    inside = rock_intervals(DISTANCE, wall, 100.0, 0.0)
    assert rock_label(DISTANCE, wall, 100.0, ray, inside).startswith("at least ")
    holed = np.where(np.abs(DISTANCE - 4000.0) < 100.0, np.nan, TENT)
    known = rock_intervals(DISTANCE, holed, 200.0, 0.0)
    assert rock_label(DISTANCE, holed, 200.0, ray, known) == "at least 1200 m of rock"
    # Above all known ground a hole hides nothing.
    steep = rock_intervals(DISTANCE, holed, 0.0, 12.0)
    assert rock_label(DISTANCE, holed, 0.0, Ray("", 12.0), steep).startswith("3")


def drawn(figure):
    return figure.axes[0], texts(figure, "legend")


def texts(figure, gid):
    return [text.get_text() for text in figure.texts if text.get_gid() == gid]


@pytest.fixture
def figure():
    pytest.importorskip("matplotlib")
    rays = [Ray("to the target", 10.0, main=True), Ray("at the top of the aperture", 21.0)]
    return section_panel(DISTANCE, TENT, 0.0, rays, target_distance_m=2000.0, azimuth_deg=399.0)


def test_axes_and_legend_have_units_and_thickness(figure):
    _, labels = drawn(figure)
    (across,) = texts(figure, "bottom name")
    assert "azimuth 39.0° (m)" in across
    assert texts(figure, "left name") == ["Elevation (m)"]
    near, far = tent_crossings(10.0)
    length = (far - near) / np.cos(np.radians(10.0))
    assert f"Ray to the target, 10.0°: {length:.0f} m of rock" in labels
    assert "Ray at the top of the aperture, 21.0°: 0 m of rock" in labels
    assert {"Detector", "Target", "Rock"} <= set(labels)


def test_rock_is_highlighted_where_the_ray_crosses_it(figure):
    axes, _ = drawn(figure)
    (rock,) = [line for line in axes.lines if line.get_linewidth() == 5.0]
    near, far = tent_crossings(10.0)
    slope = np.tan(np.radians(10.0))
    assert rock.get_xydata() == pytest.approx(np.array([[near, near * slope], [far, far * slope]]))


@pytest.mark.parametrize("height", [0.01, 0.2, 1.0, 6.0])
def test_the_vertical_exaggeration_is_the_one_stated(height):
    pytest.importorskip("matplotlib")
    figure = section_panel(
        DISTANCE, TENT * height, 0.0, [Ray("to the target", 1.0, main=True)], 2000.0
    )
    axes, _ = drawn(figure)
    width_in, height_in = axes.get_window_extent().size
    actual = (height_in / np.ptp(axes.get_ylim())) / (width_in / np.ptp(axes.get_xlim()))
    (text,) = texts(figure, "bottom name")
    stated = re.search(r"vertical exaggeration × ([\d.]+)", text)
    assert ("no vertical" in text) != bool(stated)
    assert actual == pytest.approx(float(stated[1]) if stated else 1.0, rel=0.06)


def test_all_ground_and_the_target_are_in_view(figure):
    axes, _ = drawn(figure)
    low, high = axes.get_ylim()
    assert low < 0.0
    assert high > 500.0
    assert axes.get_xlim()[1] > 2000.0


def test_nothing_is_cut_off(figure):
    figure.canvas.draw()
    box = figure.get_tightbbox(figure.canvas.get_renderer())
    width, height = figure.get_size_inches()
    assert min(box.x0, box.y0) >= 0
    assert box.x1 <= width
    assert box.y1 <= height


def test_unknown_ground_is_named():
    pytest.importorskip("matplotlib")
    holed = np.where(np.abs(DISTANCE - 1500.0) < 100.0, np.nan, TENT)
    _, labels = drawn(section_panel(DISTANCE, holed, 0.0, [Ray("to the target", 5.0, main=True)]))
    assert "No elevation known" in labels


def test_a_profile_without_heights_is_refused():
    pytest.importorskip("matplotlib")
    with pytest.raises(MuyscError, match="0 known heights"):
        section_panel(DISTANCE, DISTANCE * np.nan, 0.0, [])


def test_rock_counts_between_the_near_field_and_the_maximum_range():
    pytest.importorskip("matplotlib")
    ray = Ray("to the target", 10.0, main=True)
    near, far = tent_crossings(10.0)
    middle, end = near + 100.0, far - 200.0
    figure = section_panel(DISTANCE, TENT, 0.0, [ray], 2000.0, range_m=(middle, end))
    axes, labels = drawn(figure)
    (rock,) = [line for line in axes.lines if line.get_linewidth() == 5.0]
    assert rock.get_xdata() == pytest.approx([middle, end])
    # What lies beyond the maximum range is not known, only that it is rock.
    length = (end - middle) / np.cos(np.radians(10.0))
    assert f"Ray to the target, 10.0°: at least {length:.0f} m of rock" in labels
    assert f"Near field ends, {middle:.0f} m" in labels
    assert f"Maximum range, {end:.0f} m" in labels
    rays = [line for line in axes.lines if line.get_linewidth() == 1.4]
    assert max(line.get_xdata()[-1] for line in rays) == pytest.approx(end)


def test_a_range_that_ends_in_a_gap_is_drawn():
    pytest.importorskip("matplotlib")
    holed = np.where(DISTANCE < 500.0, np.nan, TENT)
    figure = section_panel(DISTANCE, holed, 0.0, [Ray("", 5.0, main=True)], range_m=(0.0, 300.0))
    _, labels = drawn(figure)
    assert "Ray , 5.0°: at least 0 m of rock" in labels
