"""The overview map: light, places, areas, scale."""

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.collections import PolyCollection
from matplotlib.patches import Rectangle

from muysc_qgis.errors import MuyscError
from muysc_qgis.plots.map_marks import bar_length
from muysc_qgis.plots.overview_map import overview_map, shaded
from muysc_qgis.topography.relief import Relief

pytestmark = pytest.mark.filterwarnings("error")

AXIS = np.linspace(-3000.0, 3000.0, 61)


def relief(height):
    east, north = np.meshgrid(AXIS, AXIS)
    return Relief(AXIS, AXIS, height(east, north))


@pytest.fixture
def cone():
    return relief(lambda east, north: np.maximum(0.0, 1000.0 - np.hypot(east - 1000, north - 1200)))


def legend_labels(figure):
    return [text.get_text() for text in figure.texts if text.get_gid() == "legend"]


def test_slopes_towards_the_north_west_are_the_bright_ones():
    # A straight ridge from south-west to north-east.
    picture = shaded(relief(lambda east, north: 2000.0 - 0.5 * np.abs(north - east)))
    brightness = picture[..., :3].sum(axis=-1)
    north_west, south_east = brightness[15, 15], brightness[-16, -16]
    assert north_west > 1.5 * south_east


def test_the_first_row_of_the_picture_is_the_northernmost():
    picture = shaded(relief(lambda east, north: 0.01 * north))
    brightness = picture[..., :3].sum(axis=-1)
    assert np.all(np.diff(brightness.mean(axis=1)) < 0)


def test_unknown_heights_are_transparent_and_named():
    terrain = relief(lambda east, north: np.where(east > 2000, np.nan, east + north))
    picture = shaded(terrain)
    assert np.array_equal(picture[..., 3] == 0, np.isnan(terrain.elevation_m[::-1]))
    assert "No elevation known" in legend_labels(overview_map(terrain))
    unknown = relief(lambda east, north: east * np.nan)
    assert "No elevation known" in legend_labels(overview_map(unknown))


def test_places_and_areas_stand_where_they_are_in_kilometres(cone):
    wedge = np.array([[0.0, 0.0], [500.0, 2000.0], [2000.0, 500.0]])
    figure = overview_map(cone, (1000.0, 1200.0), [wedge], [wedge / 2], "Casina", "Gran Cono")
    axes = figure.axes[0]
    detector, line, target = axes.lines
    assert detector.get_xydata().tolist() == [[0.0, 0.0]]
    assert target.get_xydata().tolist() == [[1.0, 1.2]]
    assert line.get_xydata().tolist() == [[0.0, 0.0], [1.0, 1.2]]
    areas = [item for item in axes.collections if isinstance(item, PolyCollection)]
    corners = [area.get_paths()[0].vertices[:3].tolist() for area in areas]
    assert (wedge / 1e3).tolist() in corners
    assert (wedge / 2e3).tolist() in corners
    assert legend_labels(figure) == [
        "Casina", "Gran Cono", "Line to the target, 1562 m", "Field of view", "Ground seen",
        "Elevation, every 100 m",
    ]  # fmt: skip
    names = [text.get_text() for text in figure.texts if (text.get_gid() or "").endswith(" name")]
    assert names == ["East of the detector (km)", "North of the detector (km)"]


def test_cells_are_drawn_around_their_points(cone):
    (image,) = overview_map(cone).axes[0].images
    assert image.get_extent() == pytest.approx([-3.05, 3.05, -3.05, 3.05])


def test_both_axes_have_one_scale(cone):
    figure = overview_map(cone)
    figure.canvas.draw()
    axes = figure.axes[0]
    width, height = axes.get_window_extent().size
    assert width / np.ptp(axes.get_xlim()) == pytest.approx(height / np.ptp(axes.get_ylim()))


def test_the_scale_bar_is_as_long_as_it_says(cone):
    axes = overview_map(cone).axes[0]
    (label,) = [text.get_text() for text in axes.texts if text.get_text().endswith(" km")]
    halves = [
        patch
        for patch in axes.patches
        if isinstance(patch, Rectangle) and patch.get_height() == 0.01
    ]
    share = sum(half.get_width() for half in halves)
    assert share * np.ptp(axes.get_xlim()) == pytest.approx(float(label.split()[0]))


def test_bar_and_arrow_hide_neither_detector_nor_target(cone):
    axes = overview_map(cone, (1000.0, 1200.0)).axes[0]
    detector, _, target = axes.lines
    names = [text for text in axes.texts if text.get_text() in ("N", "1 km")]
    boxes = [patch for patch in axes.patches if isinstance(patch, Rectangle)]
    assert (len(names), len(boxes)) == (2, 3)
    highest = max(one.get_zorder() for one in (*names, *boxes))
    assert highest < min(detector.get_zorder(), target.get_zorder())


@pytest.mark.parametrize(
    ("longest", "length"),
    [(1.0, 1.0), (1.9, 1.0), (2.0, 2.0), (4.9, 2.0), (0.07, 0.05), (9.0, 5.0)],
)
def test_bar_lengths_are_round_and_no_longer_than_allowed(longest, length):
    assert bar_length(longest) == pytest.approx(length)


def test_flat_ground_equal_names_and_no_target_are_drawn():
    flat = relief(lambda east, north: np.full_like(east, 12.0))
    assert legend_labels(overview_map(flat)) == ["Detector"]
    figure = overview_map(flat, (100.0, 0.0), detector_name="$A$", target_name="$A$")
    assert legend_labels(figure) == [r"\$A\$", r"\$A\$", "Line to the target, 100 m"]


def test_nothing_is_cut_off(cone):
    figure = overview_map(
        cone, (1000.0, 1200.0), subtitle="A long subtitle " * 20, title="Long " * 40
    )
    figure.canvas.draw()
    box = figure.get_tightbbox(figure.canvas.get_renderer())
    width, height = figure.get_size_inches()
    assert box.x0 >= 0
    assert box.y0 >= 0
    assert box.x1 <= width
    assert box.y1 <= height


def test_a_relief_whose_shapes_do_not_fit_is_refused():
    with pytest.raises(MuyscError, match="does not fit"):
        Relief(AXIS, AXIS[:5], np.zeros((61, 61)))
    with pytest.raises(MuyscError, match="two points a side"):
        Relief(AXIS[:1], AXIS[:1], np.zeros((1, 1)))
