"""Panels of muograms: axes, units, skyline, target, legend, PNG."""

import subprocess
import sys
from dataclasses import replace
from io import BytesIO

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.colors import to_hex
from matplotlib.image import imread

from muysc_qgis.errors import MuyscError
from muysc_qgis.plots import style
from muysc_qgis.plots.colours import colour_scale, pixel_colours, sky_mask
from muysc_qgis.plots.contours import label_places
from muysc_qgis.plots.limits import colour_limits
from muysc_qgis.plots.panel import muogram_panel, muogram_panels, png_bytes, save_png, summary_panel
from muysc_qgis.quantities import COLOUR_STOPS, QUANTITIES

pytestmark = pytest.mark.filterwarnings("error")


def axes_with(figure, **labels):
    """Return the axes whose labels are these."""
    return [
        axes
        for axes in figure.axes
        if all(getattr(axes, f"get_{name}")() == text for name, text in labels.items())
    ]


def pictures(figure):
    return [axes for axes in figure.axes if axes.images]


def legend_labels(figure):
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


def boxes(figure):
    """Return the text and the box of every text drawn."""
    import matplotlib.text

    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    return [
        (text.get_text(), text.get_window_extent(renderer))
        for text in figure.findobj(matplotlib.text.Text)
        if text.get_visible() and text.get_text().strip() and on_axis(text)
    ]


def on_axis(text):
    """Leave out the tick labels that matplotlib keeps outside the limits."""
    for axes in text.figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            low, high = sorted(axis.get_view_interval())
            for tick in axis.get_major_ticks():
                if text in (tick.label1, tick.label2):
                    return low - 1e-9 <= tick.get_loc() <= high + 1e-9
    return True


def test_axes_have_titles_labels_and_units(mountain):
    figure = muogram_panel(mountain["thickness"], mountain["flux"])
    left, right = pictures(figure)
    assert left.get_title(loc="left") == "Rock thickness"
    assert right.get_title(loc="left") == "Muon flux"
    for axes in (left, right):
        assert axes.get_xlabel() == "Azimuth from the boresight (°)"
        assert axes.get_ylabel() == "Zenith angle (°)"
    assert len(axes_with(figure, xlabel="Azimuth from north (°)")) == 2
    assert len(axes_with(figure, ylabel="Elevation (°)")) == 2
    assert len(axes_with(figure, xlabel="Rock thickness (m)")) == 1
    assert len(axes_with(figure, xlabel="Muon flux (cm⁻² sr⁻¹ day⁻¹)")) == 1


def test_the_heading_tells_place_target_model_and_density(mountain):
    figure = muogram_panel(mountain["thickness"], mountain["flux"])
    heading = " ".join(text.get_text() for text in figure.texts)
    for part in (
        "40.81056° N",
        "14.41069° E",
        "604 m",
        "1883 m",
        "39.0°",
        "Gaisser–Tang",
        "CSDA",
        "2.65 g/cm³",
    ):
        assert part in heading


def test_pixel_centres_are_the_ray_directions(mountain):
    muogram = mountain["thickness"]
    axes = pictures(muogram_panels([muogram]))[0]
    (image,) = axes.images
    left, right, bottom, top = image.get_extent()
    rows, columns = image.get_array().shape[:2]
    across = left + (np.arange(columns) + 0.5) * (right - left) / columns
    down = top + (np.arange(rows) + 0.5) * (bottom - top) / rows
    assert across + 39.0 == pytest.approx(muogram.azimuth_deg)
    assert 90.0 - down == pytest.approx(muogram.elevation_deg)
    # Zenith grows downwards on the page.
    assert axes.get_ylim()[0] > axes.get_ylim()[1]


def test_top_and_bottom_azimuths_agree_across_north(make_mountain):
    muograms = make_mountain(azimuth=-10.0, BORESIGHT_AZIMUTH=350.0)
    figure = muogram_panels([muograms["thickness"]])
    (axes,) = pictures(figure)
    (top,) = axes_with(figure, xlabel="Azimuth from north (°)")
    assert axes.get_xlim() == pytest.approx((-21.0, 21.0))
    assert top.get_xlim() == axes.get_xlim()
    labels = [label.get_text() for label in top.get_xticklabels()]
    for position, label in zip(top.get_xticks(), labels):
        assert float(label[:-1]) == pytest.approx((350.0 + position) % 360.0)
    assert "0°" in labels
    assert [text.get_text() for text in top.texts] == ["NNW", "N"]


def test_zenith_and_elevation_ticks_agree(mountain):
    figure = muogram_panels([mountain["thickness"]])
    (axes,) = pictures(figure)
    (right,) = axes_with(figure, ylabel="Elevation (°)")
    assert right.get_ylim() == axes.get_ylim()
    for position, label in zip(right.get_yticks(), right.get_yticklabels()):
        assert float(label.get_text()) == pytest.approx(90.0 - position)


def test_the_skyline_runs_where_the_thickness_reaches_zero(make_mountain):
    muograms = make_mountain(columns=200, rows=200)
    for axes in pictures(muogram_panel(muograms["thickness"], muograms["flux"])):
        lines = [item for item in axes.collections if to_hex(item.get_edgecolor()[0]) == style.INK]
        points = np.concatenate([path.vertices for line in lines for path in line.get_paths()])
        expected = 70.0 + points[:, 0] ** 2 / 40.0
        pixel = 22.0 / 200
        # Half a pixel down, and half a pixel's width along the slope (21/20 at the edge).
        assert np.abs(points[:, 1] - expected).max() < pixel / 2 + 42.0 / 200 / 2 * 1.05 + 1e-9
        assert np.ptp(points[:, 0]) == pytest.approx(42.0)


def test_target_is_marked_at_its_zenith(mountain):
    for axes in pictures(muogram_panel(mountain["thickness"], mountain["flux"])):
        (marker,) = axes.lines
        assert marker.get_xydata() == pytest.approx(np.array([[0.0, 75.0]]))


def test_legend_names_what_is_drawn_and_nothing_else(mountain):
    thickness, flux = mountain["thickness"], mountain["flux"]
    assert legend_labels(muogram_panel(thickness, flux)) == ["Target", "Skyline", "Open sky"]
    holed = flux.values.copy()
    holed[-5:, :5] = np.nan
    panel = muogram_panel(thickness, replace(flux, values=holed))
    assert legend_labels(panel) == ["Target", "Skyline", "Open sky", "Unknown"]
    rock = replace(thickness, values=thickness.values + 100.0, metadata={})
    assert legend_labels(muogram_panels([rock])) == []


def test_colour_bar_spans_the_limits_that_map_styles_use(mountain):
    for muogram in mountain.values():
        figure = muogram_panels([muogram])
        (bar,) = axes_with(figure, xlabel=muogram.kind.label)
        assert bar.get_xlim() == pytest.approx(colour_limits(muogram.values, muogram.kind))


def test_contour_labels_are_round_and_have_units(mountain):
    left, right = pictures(muogram_panel(mountain["thickness"], mountain["flux"]))
    lengths = [text.get_text() for text in left.texts]
    assert len(lengths) >= 3
    assert {float(text.removesuffix(" m")) % 100 for text in lengths} == {0.0}
    decades = [float(text.get_text()) for text in right.texts]
    assert len(decades) >= 2
    assert np.log10(decades) == pytest.approx(np.round(np.log10(decades)))


def test_sky_unknown_and_zero_pixels_have_their_own_look():
    quantity = QUANTITIES["thickness"]
    values = np.array([[0.0, np.nan, 10.0, 1000.0]])
    scale = colour_scale(values, quantity)
    picture = pixel_colours(values, quantity, sky_mask(values, quantity), scale)[0] / 255
    assert to_hex(picture[0]) == style.SKY
    assert picture[1, 3] == 0
    assert to_hex(picture[2]) == COLOUR_STOPS["viridis"][0]
    assert to_hex(picture[3]) == COLOUR_STOPS["viridis"][-1]
    counts = QUANTITIES["counts"]
    picture = pixel_colours(values, counts, None, colour_scale(values, counts))[0] / 255
    assert to_hex(picture[0]) == COLOUR_STOPS["magma"][0]


def test_flux_of_the_open_sky_keeps_its_colour(mountain):
    flux = mountain["flux"]
    sky = sky_mask(mountain["thickness"].values, mountain["thickness"].kind)
    picture = pixel_colours(flux.values, flux.kind, sky, colour_scale(flux.values, flux.kind))
    assert to_hex(picture[0, 0] / 255) == COLOUR_STOPS["magma"][-1]


@pytest.mark.parametrize(
    ("shape", "note"),
    [
        ({"elevation": 50.0}, "Open sky in every direction"),
        ({"elevation": -20.0}, None),
        ({"columns": 1, "rows": 1, "width": 1.0, "height": 1.0}, None),
        ({"rows": 1, "height": 1.0}, None),
        ({"columns": 1, "width": 1.0}, None),
        ({"columns": 360, "width": 360.0}, None),
        ({"columns": 20, "width": 10.0, "height": 60.0}, None),
        ({"columns": 400, "rows": 300}, None),
    ],
)
def test_every_field_of_view_is_drawn_with_nothing_cut_off_or_overlapping(
    make_mountain, shape, note
):
    muograms = make_mountain(**shape)
    figure = muogram_panel(muograms["thickness"], muograms["flux"])
    drawn = boxes(figure)
    assert note is None or note in [text for text, _ in drawn]
    page = figure.bbox
    for text, box in drawn:
        corners = page.contains(box.x0, box.y0), page.contains(box.x1, box.y1)
        assert corners == (True, True), text
    for number, (text, box) in enumerate(drawn):
        for other, second in drawn[:number]:
            apart = min(box.x1, second.x1) - max(box.x0, second.x0) < 1 or (
                min(box.y1, second.y1) - max(box.y0, second.y0) < 1
            )
            assert apart, f"{text!r} over {other!r}"


def test_unevenly_spaced_directions_keep_their_places(make_mountain):
    muogram = make_mountain(columns=41, rows=41)["thickness"]
    tangents = np.degrees(np.arctan(np.linspace(-0.8, 0.8, 41)))
    values = np.full((41, 41), 100.0)
    values[5, 30] = np.nan
    uneven = replace(
        muogram, values=values, azimuth_deg=39.0 + tangents, elevation_deg=15.0 - tangents
    )
    (image,) = pictures(muogram_panels([uneven]))[0].images
    left, right, bottom, top = image.get_extent()
    hole = np.argwhere(image.get_array()[..., 3] == 0)
    rows, columns = image.get_array().shape[:2]
    y, x = hole.mean(axis=0) + 0.5
    assert left + x / columns * (right - left) == pytest.approx(tangents[30], abs=0.1)
    assert top + y / rows * (bottom - top) == pytest.approx(75.0 + tangents[5], abs=0.1)


def test_one_angular_scale_for_azimuth_and_elevation(mountain):
    figure = muogram_panel(mountain["thickness"], mountain["flux"])
    axes = pictures(figure)[0]
    width, height = axes.get_window_extent().size
    assert width / 42.0 == pytest.approx(height / 22.0)


def test_a_muogram_without_metadata_is_drawn_by_its_azimuth(mountain):
    bare = [replace(muogram, metadata={}) for muogram in mountain.values()]
    figure = muogram_panels(bare[:2])
    (left, _) = pictures(figure)
    assert left.get_xlabel() == "Azimuth (°)"
    assert left.get_xlim() == pytest.approx((18.0, 60.0))
    assert legend_labels(figure) == ["Skyline", "Open sky"]
    unreadable = replace(mountain["flux"], metadata={"BORESIGHT_AZIMUTH": "north", "DENSITY": "?"})
    assert pictures(muogram_panels([unreadable]))


def test_unknown_everywhere_is_said(mountain):
    flux = mountain["flux"]
    figure = muogram_panels([replace(flux, values=flux.values * np.nan)])
    assert "No direction has a known value" in [text for text, _ in boxes(figure)]
    assert "Unknown" in legend_labels(figure)


def test_png_has_the_size_asked_for_and_every_picture_has_content(mountain, tmp_path):
    figure = muogram_panel(mountain["thickness"], mountain["flux"])
    path = tmp_path / "päd panel.png"
    save_png(figure, path, dpi=120)
    pixels = imread(path)
    width, height = figure.get_size_inches()
    assert pixels.shape[1] == 1200 == round(120 * width)
    assert pixels.shape[0] == pytest.approx(120 * height, abs=1)
    for axes in figure.axes:
        box = axes.get_position()
        rows = slice(int((1 - box.y1) * pixels.shape[0]), int((1 - box.y0) * pixels.shape[0]))
        columns = slice(int(box.x0 * 1200), int(box.x1 * 1200))
        assert pixels[rows, columns, :3].std() > 0.05


def test_a_png_that_cannot_be_written_is_said(mountain, tmp_path):
    figure = muogram_panels([mountain["flux"]])
    with pytest.raises(MuyscError, match="cannot be written"):
        save_png(figure, tmp_path / "missing" / "panel.png")


def test_summary_draws_every_quantity_with_its_unit(mountain):
    thickness = mountain["thickness"]
    muograms = {
        "opacity": thickness.with_values("opacity", thickness.values * 265.0),
        "open_sky": mountain["open_sky"],
        "transmission": thickness.with_values(
            "transmission", mountain["flux"].values / mountain["open_sky"].values
        ),
        "distance": thickness.with_values(
            "distance", np.where(thickness.values > 0, 1000.0 + thickness.values, np.nan)
        ),
    }
    figure = summary_panel(muograms)
    drawn = pictures(figure)
    assert [axes.get_title(loc="left") for axes in drawn] == [
        QUANTITIES[name].title for name in muograms
    ]
    assert len(axes_with(figure, xlabel="g/cm²")) == 1
    assert len(axes_with(figure, xlabel="cm⁻² sr⁻¹ day⁻¹")) == 1
    assert len(axes_with(figure, xlabel="Transmission")) == 1
    assert len(axes_with(figure, xlabel="m")) == 1
    # What is NaN because there is no rock is sky, not unknown.
    assert legend_labels(figure) == ["Target", "Skyline", "Open sky"]
    assert imread(BytesIO(png_bytes(figure, 50))).shape[1] == 500


def test_titles_are_shown_as_they_are(mountain):
    figure = muogram_panels([mountain["flux"]], title="Costs $5, not $6 " * 8, subtitle="50 % <b>")
    texts = "".join(text for text, _ in boxes(figure))
    assert texts.count("\\$5") == 8
    assert "50 % <b>" in texts


def test_no_muogram_is_an_error():
    with pytest.raises(MuyscError, match="at least one muogram"):
        muogram_panels([])
    with pytest.raises(MuyscError, match="at least one muogram"):
        summary_panel({})


def test_without_matplotlib_the_error_says_what_to_install(mountain, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.backends.backend_agg", None)
    with pytest.raises(MuyscError, match=r"matplotlib.*install"):
        muogram_panels([mountain["flux"]])


def test_pyplot_is_never_loaded(data_folder):
    code = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "import numpy as np\n"
        "from muysc_qgis.muogram import Muogram\n"
        "from muysc_qgis.plots.panel import muogram_panels, png_bytes\n"
        "values, angles = np.arange(25.0).reshape(5, 5), np.arange(5.0)\n"
        "png_bytes(muogram_panels([Muogram('thickness', values, angles, -angles)]))\n"
        "sys.exit('matplotlib.pyplot' in sys.modules)\n"
    )
    root = str(data_folder.parent.parent)
    run = subprocess.run([sys.executable, "-c", code, root], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr


def test_labels_stand_on_their_line_away_from_everything_else():
    x = np.linspace(0.0, 10.0, 101)
    upper = np.column_stack([x, np.full_like(x, 1.0)])
    lower = np.column_stack([x, np.where(x < 5, 0.9, 0.0)])
    wall = np.array([[9.0, 1.0], [9.0, 0.0]])
    none = np.empty((0, 2))
    first, second = label_places([[upper], [lower]], [wall], none, (1.0, 1.0))
    assert first[1] == 1.0
    assert 5.0 < first[0] < 9.0
    assert second[1] == 0.0
    ((x_marked, _),) = label_places([[upper]], [], np.array([[2.0, 1.0]]), (1.0, 1.0))
    assert x_marked > 5.0
    short = upper[:5]
    assert label_places([[short], []], [], none, (1.0, 1.0)) == []
    assert label_places([[upper]], [upper + np.array([0.0, 0.05])], none, (1.0, 1.0)) == []
