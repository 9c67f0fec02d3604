"""Pictures of telescopes show what they say."""

import numpy as np
import pytest

from muysc_qgis.radiography.settings import Physics
from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.directions import Pointing
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.telescope.planning import CountingPlan
from muysc_qgis.telescope.presets import PRESETS
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.expected_counts import expected_counts

pytest.importorskip("matplotlib")

from muysc_qgis.plots.frames import new_axes
from muysc_qgis.plots.style import png_bytes
from muysc_qgis.plots.telescope_axes import draw_map, draw_net, label_angles
from muysc_qgis.plots.telescope_comparison import comparison_panel
from muysc_qgis.plots.telescope_counts import counts_panel
from muysc_qgis.plots.telescope_panel import telescope_panel
from muysc_qgis.trajectories import TrajectoryMap

TELESCOPE = TelescopeGeometry(8, 6, 10.0, 200.0)


@pytest.fixture(scope="module")
def counted(data_folder):
    dem = open_dem(data_folder / "vesuvius_srtmgl1.tif")
    sight = take_sight(dem, (14.410686, 40.810561), (14.424745, 40.823729))
    pointing = Pointing(sight.boresight_azimuth_deg, sight.boresight_elevation_deg)
    return expected_counts(sight, TELESCOPE, pointing, Physics(), CountingPlan())


def words(figure):
    from matplotlib.text import Text

    return [text.get_text() for text in figure.findobj(Text)]


def axes_of(values):
    from muysc_qgis.plots.style import new_figure

    rows, columns = values.shape
    x, y = 0.1 * (np.arange(columns) - columns // 2), 0.1 * (rows // 2 - np.arange(rows))
    axes = new_axes(new_figure(4, 4), (0.5, 0.5, 3, 3))
    scale, legend = draw_map(axes, TrajectoryMap("acceptance", values, x, y, {}))
    return axes, scale, legend


def test_pixels_stand_where_they_look():
    values = np.zeros((5, 7))
    values[0, 6] = 1.0
    axes, scale, legend = axes_of(values)
    (image,) = axes.images
    picture = image.get_array()
    # The first row is on top, the last column at the right.
    assert image.origin == "upper"
    assert tuple(image.get_extent()) == pytest.approx((-0.35, 0.35, -0.25, 0.25))
    assert tuple(picture[0, 6]) == tuple(scale.to_rgba(1.0, bytes=True))
    assert legend == {}


def test_unknown_pixels_are_hatched_and_in_the_legend():
    values = np.ones((3, 3))
    values[1, 1] = np.nan
    axes, _, legend = axes_of(values)
    assert list(legend) == ["Unknown"]
    assert axes.images[0].get_array()[1, 1, 3] == 0


def test_ticks_name_angles_at_their_tangents():
    axes, _, _ = axes_of(np.ones((21, 21)))
    label_angles(axes)
    labels = {
        text.get_text(): tick for tick, text in zip(axes.get_xticks(), axes.get_xticklabels())
    }
    assert labels["30"] == pytest.approx(np.tan(np.radians(30)))
    assert labels["−30"] == pytest.approx(-np.tan(np.radians(30)))


def test_the_net_runs_along_azimuths_and_elevations():
    axes, _, _ = axes_of(np.ones((21, 21)))
    pointing = Pointing(100.0, 20.0)
    draw_net(axes, pointing)
    names = [text.get_text() for text in axes.texts]
    assert "horizon" in names
    assert "90°" in names
    # Every line has one azimuth or one elevation.
    for line in axes.lines:
        azimuth, elevation = pointing.sky(*(np.asarray(one) for one in line.get_data()))
        assert min(np.nanmax(abs(one - np.nanmedian(one))) for one in (azimuth, elevation)) < 1e-6


def test_counts_are_drawn_with_skyline_target_and_numbers(counted):
    figure = counts_panel(counted, "custom")
    said = words(figure)
    for expected in ("Muon counts", "Counting error", "Skyline", "Target", "Open sky"):
        assert expected in said
    assert any("30 days of counting" in one for one in said)
    assert any("8 × 6 bars of 10 cm" in one for one in said)
    assert "Days to see −10 % of density" in said
    assert png_bytes(figure, 60).startswith(b"\x89PNG")


@pytest.mark.parametrize(
    "geometry", [TELESCOPE, TelescopeGeometry(1, 1, 30.0, 40.0), PRESETS["muraves"].geometry]
)
@pytest.mark.parametrize("formula", ["exact", "paper"])
def test_every_telescope_can_be_drawn(geometry, formula):
    figure = telescope_panel(trajectories(geometry, formula), "custom")
    said = words(figure)
    assert any(f"{geometry.bars_x} × {geometry.bars_y} bars" in one for one in said)
    assert "Path between the planes" in said
    assert png_bytes(figure, 50).startswith(b"\x89PNG")


def test_the_comparison_names_all_and_marks_one():
    said = words(comparison_panel(TELESCOPE, "custom", "exact"))
    for preset in PRESETS.values():
        assert preset.title in said
    assert "this telescope" in said
    assert "this telescope" not in words(
        comparison_panel(PRESETS["mute"].geometry, "mute", "exact")
    )
