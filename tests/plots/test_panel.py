"""Panels of muograms: axes, units, skyline, target, legend, PNG."""

from dataclasses import replace
from io import BytesIO

import numpy as np
import pytest

pytest.importorskip("matplotlib")

import matplotlib.lines
import matplotlib.text
from matplotlib.colors import to_hex
from matplotlib.image import imread

from muysc_qgis.plots import style
from muysc_qgis.plots.limits import colour_limits
from muysc_qgis.plots.panel import muogram_panel, muogram_panels, summary_panel
from muysc_qgis.plots.style import png_bytes, save_png
from muysc_qgis.quantities import COLOUR_STOPS, QUANTITIES

pytestmark = pytest.mark.filterwarnings("error")


def pictures(figure):
    """Return the images of the muograms; their extents are angles."""
    return [image for axes in figure.axes for image in axes.images if image.get_gid() == "pixels"]


def texts(figure, gid):
    """Return what is written on a figure as a part of this kind."""
    return [one.get_text() for one in found(figure, gid)]


def found(figure, gid):
    return [one for one in figure.findobj(matplotlib.text.Text) if one.get_gid() == gid]


def scales(figure, kind):
    """Return for each scale of a kind its labels, and where on the page its ticks stand (pixels).

    Each label must stand beside its tick.
    """
    labels = iter(found(figure, f"{kind} labels"))
    across = kind in ("top", "bottom", "colour")
    collected = []
    for line in figure.findobj(matplotlib.lines.Line2D):
        if line.get_gid() == f"{kind} ticks":
            at = line.get_transform().transform(line.get_xydata())[:, 0 if across else 1]
            own = [next(labels) for _ in at]
            for text, place in zip(own, at):
                stands = text.get_transform().transform(text.get_position())[0 if across else 1]
                assert stands == pytest.approx(place)
            collected.append(([text.get_text() for text in own], at))
    return collected


def number(label):
    """Read a label as a number: “−20”, “0.5”, “30 000”, “2·10⁻⁷”."""
    plain = label.rstrip("° m").replace("−", "-").replace("\u202f", "")
    mantissa, _, power = plain.rpartition("10")
    if not power or power[0] not in "⁻⁰¹²³⁴⁵⁶⁷⁸⁹":
        return float(plain)
    exponent = power.translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
    return float(mantissa.rstrip("·") or 1) * 10.0 ** int(exponent)


def page_box(image):
    """Return left, right, bottom and top of an image on the page (pixels)."""
    left, right, bottom, top = image.get_extent()
    (x0, y0), (x1, y1) = image.get_transform().transform([(left, bottom), (right, top)])
    return x0, x1, y0, y1


def read_off(label_places, at):
    """Return the values at places along a linear scale, from its labels alone."""
    labels, places = label_places
    return np.polyval(np.polyfit(places, [number(label) for label in labels], 1), at)


def legend_labels(figure):
    return texts(figure, "legend")


def boxes(figure):
    """Return the text and the box of every text drawn."""
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    return [
        (text.get_text(), text.get_window_extent(renderer))
        for text in figure.findobj(matplotlib.text.Text)
        if text.get_visible() and text.get_text().strip()
    ]


def test_axes_have_titles_labels_and_units(mountain):
    figure = muogram_panel(mountain["thickness"], mountain["flux"])
    assert texts(figure, "title") == ["Rock thickness", "Muon flux"]
    assert texts(figure, "bottom name") == ["Azimuth from the boresight (°)"] * 2
    assert texts(figure, "left name") == ["Zenith angle (°)"] * 2
    assert texts(figure, "top name") == ["Azimuth from north (°)"] * 2
    assert texts(figure, "right name") == ["Elevation (°)"] * 2
    assert texts(figure, "colour name") == ["Rock thickness (m)", "Muon flux (cm⁻² sr⁻¹ day⁻¹)"]


def test_the_heading_tells_place_target_model_and_density(mountain):
    figure = muogram_panel(mountain["thickness"], mountain["flux"])
    heading = " ".join(text.get_text() for text in figure.texts)
    for part in (
        "40.81056° N",
        "14.41069° E",
        "604 m",
        "1883 m",
        "39.0°",
        "Gaisser (MUSIC/MUSUN)",
        "CSDA",
        "2.65 g/cm³",
    ):
        assert part in heading


def test_pixel_centres_are_the_ray_directions(mountain):
    muogram = mountain["thickness"]
    figure = muogram_panels([muogram])
    (image,) = pictures(figure)
    left, right, bottom, top = page_box(image)
    rows, columns = image.get_array().shape[:2]
    across = left + (np.arange(columns) + 0.5) * (right - left) / columns
    down = top + (np.arange(rows) + 0.5) * (bottom - top) / rows
    # As a reader finds them, by the labels of all four scales.
    for kind, at, expected in (
        ("bottom", across, muogram.azimuth_deg - 39.0),
        ("top", across, muogram.azimuth_deg),
        ("left", down, 90.0 - muogram.elevation_deg),
        ("right", down, muogram.elevation_deg),
    ):
        (scale,) = scales(figure, kind)
        assert read_off(scale, at) == pytest.approx(expected)
    # Zenith grows downwards on the page.
    assert top > bottom


def test_top_and_bottom_azimuths_agree_across_north(make_mountain):
    muograms = make_mountain(azimuth=-10.0, BORESIGHT_AZIMUTH=350.0)
    figure = muogram_panels([muograms["thickness"]])
    (image,) = pictures(figure)
    assert image.get_extent()[:2] == pytest.approx((-21.0, 21.0))
    (bottom,), ((labels, places),) = scales(figure, "bottom"), scales(figure, "top")
    for label, relative in zip(labels, read_off(bottom, places)):
        assert number(label) == pytest.approx((350.0 + relative) % 360.0, abs=1e-6)
    assert "0°" in labels
    assert texts(figure, "compass") == ["NNW", "N"]
    north = found(figure, "compass")[1]
    at = north.get_transform().transform(north.get_position())[0]
    assert at == pytest.approx(places[labels.index("0°")])


def test_zenith_and_elevation_ticks_agree(mountain):
    figure = muogram_panels([mountain["thickness"]])
    (zenith,), (elevation,) = scales(figure, "left"), scales(figure, "right")
    numbers = np.array([number(label) for label in elevation[0]])
    assert 90.0 - read_off(zenith, elevation[1]) == pytest.approx(numbers)


def test_the_skyline_runs_where_the_thickness_reaches_zero(make_mountain):
    muograms = make_mountain(columns=200, rows=200)
    figure = muogram_panel(muograms["thickness"], muograms["flux"])
    (axes,) = figure.axes
    lines = [
        item
        for item in axes.collections
        if to_hex(item.get_edgecolor()[0]) == style.INK
        and item.get_linewidth()[0] == style.LINE_WIDTH
    ]
    for image, line in zip(pictures(figure), lines):
        # On the page, as angles of the image under it.
        vertices = np.concatenate([path.vertices for path in line.get_paths()])
        drawn = line.get_transform().transform(vertices)
        points = image.get_transform().inverted().transform(drawn)
        expected = 70.0 + points[:, 0] ** 2 / 40.0
        pixel = 22.0 / 200
        # Half a pixel down, and half a pixel's width along the slope (21/20 at the edge).
        assert np.abs(points[:, 1] - expected).max() < pixel / 2 + 42.0 / 200 / 2 * 1.05 + 1e-9
        assert np.ptp(points[:, 0]) == pytest.approx(42.0)
    assert len(lines) == 2


def test_target_is_marked_at_its_zenith(mountain):
    figure = muogram_panel(mountain["thickness"], mountain["flux"])
    markers = [line for line in figure.axes[0].lines if line.get_gid() == "target"]
    for image, marker in zip(pictures(figure), markers):
        drawn = marker.get_transform().transform(marker.get_xydata())
        angles = image.get_transform().inverted().transform(drawn)
        assert angles == pytest.approx(np.array([[0.0, 75.0]]))
    assert len(markers) == 2


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
        assert texts(figure, "colour name") == [muogram.kind.label]
        (bar,) = [image for image in figure.axes[0].images if image.get_gid() == "colour bar"]
        left, right, *_ = page_box(bar)
        ((labels, places),) = scales(figure, "colour")
        assert len(labels) >= 3
        low, high = np.log(colour_limits(muogram.values, muogram.kind))
        expected = low + (places - left) / (right - left) * (high - low)
        assert [np.log(number(label)) for label in labels] == pytest.approx(expected)
        colours = bar.get_array()[0] / 255
        stops = COLOUR_STOPS[muogram.kind.colours]
        assert [to_hex(colours[0]), to_hex(colours[-1])] == [stops[0], stops[-1]]


def test_a_colour_bar_has_arrows_where_values_lie_beyond_it(mountain):
    shape = mountain["flux"].values.shape
    all_of_them = np.linspace(2.0, 3.0, np.prod(shape)).reshape(shape)
    low, high = colour_limits(all_of_them, QUANTITIES["density"])
    for values, expected in (
        (np.clip(all_of_them, low, high), []),
        (np.minimum(all_of_them, high), ["low"]),
        (np.maximum(all_of_them, low), ["high"]),
        (all_of_them, ["low", "high"]),
    ):
        figure = muogram_panels([mountain["flux"].with_values("density", values)])
        (bar,) = [image for image in figure.axes[0].images if image.get_gid() == "colour bar"]
        middle = np.mean(page_box(bar)[:2])
        arrows = [patch for patch in figure.axes[0].patches if patch.get_gid() == "beyond"]
        tips = [arrow.get_transform().transform(arrow.get_xy())[1, 0] for arrow in arrows]
        assert ["low" if tip < middle else "high" for tip in tips] == expected
        ends = {"low": COLOUR_STOPS["cividis"][0], "high": COLOUR_STOPS["cividis"][-1]}
        assert [to_hex(arrow.get_facecolor()) for arrow in arrows] == [ends[e] for e in expected]


def test_contour_labels_are_round_and_have_units(mountain):
    figure = muogram_panel(mountain["thickness"], mountain["flux"])
    left, right = (
        [
            text.get_text()
            for text in figure.axes[0].texts
            if box[0] < text.get_transform().transform(text.get_position())[0] < box[1]
        ]
        for box in map(page_box, pictures(figure))
    )
    assert len(left) >= 3
    assert {float(text.removesuffix(" m")) % 100 for text in left} == {0.0}
    decades = [number(text) for text in right]
    assert len(decades) >= 2
    assert np.log10(decades) == pytest.approx(np.round(np.log10(decades)))


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
    (image,) = pictures(muogram_panels([uneven]))
    left, right, bottom, top = image.get_extent()
    hole = np.argwhere(image.get_array()[..., 3] == 0)
    rows, columns = image.get_array().shape[:2]
    y, x = hole.mean(axis=0) + 0.5
    assert left + x / columns * (right - left) == pytest.approx(tangents[30], abs=0.1)
    assert top + y / rows * (bottom - top) == pytest.approx(75.0 + tangents[5], abs=0.1)


def test_one_angular_scale_for_azimuth_and_elevation(mountain):
    figure = muogram_panel(mountain["thickness"], mountain["flux"])
    left, right, bottom, top = page_box(pictures(figure)[0])
    assert (right - left) / 42.0 == pytest.approx((top - bottom) / 22.0)


def test_a_muogram_without_metadata_is_drawn_by_its_azimuth(mountain):
    bare = [replace(muogram, metadata={}) for muogram in mountain.values()]
    figure = muogram_panels(bare[:2])
    assert texts(figure, "bottom name") == ["Azimuth (°)"] * 2
    left, _ = pictures(figure)
    assert left.get_extent()[:2] == pytest.approx((18.0, 60.0))
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
    images = figure.axes[0].images
    assert len(images) == 4
    for image in images:
        left, right, bottom, top = (np.array(page_box(image)) * 120 / figure.dpi).astype(int)
        shown = pixels[pixels.shape[0] - top : pixels.shape[0] - bottom, left:right, :3]
        assert shown.std() > 0.05


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
    assert len(pictures(figure)) == 4
    assert texts(figure, "title") == [QUANTITIES[name].title for name in muograms]
    assert texts(figure, "colour name") == ["g/cm²", "cm⁻² sr⁻¹ day⁻¹", "Transmission", "m"]
    # What is NaN because there is no rock is sky, not unknown.
    assert legend_labels(figure) == ["Target", "Skyline", "Open sky"]
    assert imread(BytesIO(png_bytes(figure, 50))).shape[1] == 500


def test_small_pictures_of_the_same_directions_share_their_scales(mountain, make_mountain):
    flux = mountain["flux"]
    names = ("opacity", "minimum_energy", "exposure")
    six = {**mountain, **{name: flux.with_values(name, flux.values) for name in names}}
    figure = summary_panel(six)
    # Each row has its zenith angles, each column its azimuths.
    assert texts(figure, "left name") == ["Zenith angle (°)"] * 2
    assert texts(figure, "bottom name") == ["Azimuth from the boresight (°)"] * 3
    # Four: nothing stands below two of the three upper ones.
    four = {name: six[name] for name in list(six)[:4]}
    assert len(texts(summary_panel(four), "bottom name")) == 4
    other = {**four, "opacity": make_mountain(width=30.0)["thickness"]}
    assert len(texts(summary_panel(other), "left name")) == 4


def test_titles_are_shown_as_they_are(mountain):
    figure = muogram_panels([mountain["flux"]], title="Costs $5, not $6 " * 8, subtitle="50 % <b>")
    texts = "".join(text for text, _ in boxes(figure))
    assert texts.count("\\$5") == 8
    assert "50 % <b>" in texts
