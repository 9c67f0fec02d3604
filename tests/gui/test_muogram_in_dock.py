"""The muogram in the dock: its colours, its pixels, and what it says of them."""

import sys

import numpy as np
import pytest
from qgis.core import QgsCoordinateReferenceSystem, QgsDistanceArea, QgsProject
from qgis.PyQt.QtCore import QPointF
from qgis.PyQt.QtGui import QColor


def through_rock(preview):
    """Return a pixel with a single stretch of rock, not too thick."""
    thickness = preview.muogram("thickness").values
    near = np.abs(thickness - 1000)
    return tuple(int(index) for index in np.unravel_index(np.nanargmin(near), near.shape))


@pytest.mark.parametrize("name", ["thickness", "flux", "transmission", "exposure", "counts"])
def test_pixels_have_the_colours_of_panels_and_maps(planned, gui, name):
    """The same as the figures made by matplotlib, to a step of the 256 shades."""
    from muysc_qgis.plots.colours import colour_scale, pixel_colours
    from muysc_qgis.quantities import QUANTITIES

    preview = planned.planner.preview
    values = preview.muogram(name).values
    sky = preview.muogram("opacity").values == 0
    image = gui("colours").picture_of(values, QUANTITIES[name], sky)
    scale = colour_scale(values, QUANTITIES[name])
    wanted = pixel_colours(values, QUANTITIES[name], sky, scale)
    for row in range(0, 100, 7):
        for column in range(0, 100, 7):
            if wanted[row, column, 3] == 0:
                continue
            seen = QColor(image.pixel(column, row))
            got = (seen.red(), seen.green(), seen.blue())
            np.testing.assert_allclose(got, wanted[row, column, :3].astype(int), atol=6)


def test_unknown_pixels_are_grey_as_in_panels(gui):
    from muysc_qgis.plots.style import UNKNOWN_LOOK
    from muysc_qgis.quantities import QUANTITIES

    values = np.array([[np.nan, 10.0], [0.0, 100.0]])
    image = gui("colours").picture_of(values, QUANTITIES["thickness"], values == 0)
    assert QColor(image.pixel(0, 0)).name() == UNKNOWN_LOOK["facecolor"]


@pytest.mark.parametrize("width", [240, 300, 700])
def test_every_pixel_is_found_where_it_is_shown(planned, width):
    view = planned.muogram.view
    view.setFixedWidth(width)
    view.grab()
    for pixel in ((0, 0), (0, 99), (99, 0), (99, 99), (50, 20)):
        assert view.pixel_at(view.place_of(*pixel)) == pixel
    assert view.pixel_at(QPointF(1, 1)) is None


def test_the_skyline_runs_between_rock_and_sky_only(gui):
    sky = np.array([[True, True, True], [True, False, True], [False, False, False]])
    known = np.ones_like(sky)
    known[2, 2] = False
    below, beside = gui("muogram_picture").skyline(sky, known)
    assert {tuple(one) for one in below.tolist()} == {(1, 1), (2, 0)}
    assert {tuple(one) for one in beside.tolist()} == {(1, 1), (1, 2)}


def test_hovering_tells_the_values_of_a_pixel(planned, hand):
    preview = planned.planner.preview
    row, column = through_rock(preview)
    hand.hover(row, column)
    flux = preview.muogram("flux")
    said = planned.muogram.readout.text().replace("\u00a0", " ").replace("\u2060", "")
    azimuth, elevation = flux.azimuth_deg[column] % 360, flux.elevation_deg[row]
    assert f"Azimuth {azimuth:.1f}°" in said
    assert f"Elevation {elevation:.1f}°" in said
    assert f"Zenith {90 - elevation:.1f}°" in said
    thickness = preview.muogram("thickness").values[row, column]
    assert f"Rock {thickness:.0f} m" in said
    assert "Opacity" in said
    assert "g/cm²" in said
    assert "cm⁻² sr⁻¹ day⁻¹" in said
    assert f"{preview.muogram('exposure').values[row, column]:.3g} days" in said


@pytest.mark.parametrize("name", ["transmission", "counts"])
def test_the_quantity_that_is_shown_is_told_as_well(planned, hand, name):
    quantity = planned.muogram.quantity
    quantity.setCurrentIndex(quantity.findData(name))
    row, column = through_rock(planned.planner.preview)
    hand.hover(row, column)
    last = planned.muogram.readout.text().split("<td")[-1]
    assert quantity.currentText() in last
    mantissa = last.rsplit(" ", 1)[-1].split("<")[0].split("·")[0]
    value = planned.planner.preview.muogram(name).values[row, column]
    assert f"{value:.2e}".startswith(f"{float(mantissa):.2e}"[:4])


def test_hovering_draws_the_ray_as_far_as_it_is_in_rock(planned, hand, iface):
    preview = planned.planner.preview
    row, column = through_rock(preview)
    hand.hover(row, column)
    drawn = planned.planner.items.ray_in_rock
    measure = QgsDistanceArea()
    measure.setSourceCrs(
        iface.mapCanvas().mapSettings().destinationCrs(),
        QgsProject.instance().transformContext(),
    )
    measure.setEllipsoid("WGS84")
    elevation = np.radians(preview.muogram("flux").elevation_deg[row])
    thickness = preview.muogram("thickness").values[row, column]
    assert measure.measureLength(drawn) / np.cos(elevation) == pytest.approx(thickness, rel=2e-3)
    hand.move(QPointF(1, 1))
    assert planned.planner.items.ray_in_rock.isEmpty()
    assert "Target" in planned.muogram.readout.text()


def test_the_section_crosses_as_much_rock_as_the_muogram_says(planned):
    preview = planned.planner.preview
    thickness = preview.muogram("thickness").values
    elevation_deg = preview.muogram("thickness").elevation_deg
    for row in range(40, 100, 12):
        for column in range(0, 100, 9):
            section = planned.planner.section(row, column)
            level = np.ptp(section.rock_m, axis=1).sum()
            slant = level / np.cos(np.radians(elevation_deg[row]))
            # Neighbouring samples are joined by straight lines.
            assert slant == pytest.approx(thickness[row, column], abs=0.5)


def test_a_ray_into_the_sky_has_no_rock_on_the_map(planned, hand):
    hand.hover(0, 50)
    assert planned.planner.items.ray_in_rock.isEmpty()
    assert "Open sky" in planned.muogram.readout.text()


def test_clicking_a_pixel_shows_its_section(planned, hand):
    pixel = through_rock(planned.planner.preview)
    window = hand.open_section(*pixel)
    assert window.picture.image.width() > 1000
    assert window.isVisible()


def test_without_matplotlib_a_sentence_stands_in_for_the_section(planned, hand, monkeypatch):
    for name in [name for name in sys.modules if name.split(".")[0] == "matplotlib"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    planned.form.azimuth.setValue(50)
    hand.settle()
    assert planned.planner.preview is not None
    window = hand.open_section(60, 50)
    assert "matplotlib" in window.told.text()
    assert window.picture.image.isNull()


def test_the_picture_is_copied_and_saved(planned, qgis_application, tmp_path, monkeypatch, gui):
    planned.muogram.copy.click()
    copied = qgis_application.clipboard().image()
    assert copied.width() == gui("muogram_view").PICTURE_WIDTH
    path = tmp_path / "muogram"
    dialog = gui("picture_actions").QFileDialog
    monkeypatch.setattr(dialog, "getSaveFileName", lambda *_: (str(path), ""))
    planned.muogram.save.click()
    assert path.with_suffix(".png").stat().st_size > 10_000


def test_the_wedge_follows_the_map_into_another_system(planned, iface, hand):
    before = planned.planner.items.field_of_view.boundingBox()
    iface.mapCanvas().setDestinationCrs(QgsCoordinateReferenceSystem("EPSG:4326"))
    after = planned.planner.items.field_of_view.boundingBox()
    assert before.width() > 1000
    assert after.width() < 1
    # The telescope is the wedge's corner, to the last digit.
    assert after.buffered(1e-9).contains(planned.planner.items.markers[0].center())
