"""The figures of a comparison: axes, units, curves, and what is faded or shaded."""

import numpy as np
import pytest
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_hex

from muysc_qgis.plots.provenance import Provenance
from muysc_qgis.plots.report import report_html
from muysc_qgis.plots.spectra import attenuation, documents, energy_spectra, looks, losses
from muysc_qgis.plots.style import png_bytes
from muysc_qgis.radiography.comparison import compare
from muysc_qgis.radiography.energy_loss import ENERGY_LOSSES
from muysc_qgis.radiography.materials import MATERIALS
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.spectra import MODELS

pytest.importorskip("matplotlib")

ANGLES = (0.0, 60.0, 85.0)


@pytest.fixture(scope="module")
def comparison():
    return compare(list(MODELS), ANGLES, 500.0, Physics(), 0.0, ["water", "granite"])


@pytest.fixture(scope="module")
def spectrum_axes(comparison):
    """Pairs of spectrum and ratio, by zenith angle."""
    axes = documents.spectrum_figure(comparison).axes
    return dict(zip(ANGLES, zip(axes[::2], axes[1::2])))


def lines_of(axes, model):
    colour, _ = looks.MODEL_LOOKS[model]
    return [line for line in axes.lines if line.get_color() == colour and len(line.get_xdata()) > 2]


def test_every_model_law_and_material_can_be_told_apart():
    assert set(looks.MODEL_LOOKS) == set(MODELS)
    assert set(looks.LAW_LOOKS) == set(losses.LAW_TITLES) == set(ENERGY_LOSSES)
    for look in (looks.MODEL_LOOKS, looks.LAW_LOOKS):
        assert len({colour for colour, _ in look.values()}) == len(look)
    assert len({looks.material_look(i) for i in range(len(MATERIALS))}) == len(MATERIALS)
    for count in (1, 2, 8):
        assert len(set(looks.zenith_colours(count))) == count


def test_one_cell_for_each_angle_with_names_and_units(spectrum_axes):
    for angle, (main, ratio) in spectrum_axes.items():
        assert main.get_title(loc="left") == f"Zenith angle {angle:g}°"
        assert ratio.get_xlabel() == "Kinetic energy (GeV)"
        assert main.get_xscale() == main.get_yscale() == ratio.get_xscale() == "log"
        assert main.get_xlim() == ratio.get_xlim() == (1.0, 1e5)
    assert spectrum_axes[0.0][0].get_ylabel() == "dI/dE (cm⁻² s⁻¹ sr⁻¹ GeV⁻¹)"


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("angle", ANGLES)
def test_a_curve_is_strong_where_the_model_holds_and_faded_elsewhere(
    comparison, spectrum_axes, model, angle
):
    curve = next(
        one for one in comparison.spectra if one.model == model and one.zenith_deg == angle
    )
    faded, strong = lines_of(spectrum_axes[angle][0], model)
    assert faded.get_alpha() == looks.FADED
    assert strong.get_alpha() is None
    np.testing.assert_array_equal(np.isfinite(strong.get_ydata()), curve.holds)
    drawn = np.where(np.isfinite(strong.get_ydata()), strong.get_ydata(), faded.get_ydata())
    np.testing.assert_array_equal(drawn, curve.flux)
    # No gap between the two.
    assert np.all(np.isfinite(faded.get_ydata()) | curve.holds)


def test_ratios_are_to_the_default_model(comparison, spectrum_axes):
    assert energy_spectra.reference_model(comparison) == "gsf-sibyll"
    for line in lines_of(spectrum_axes[0.0][1], "gsf-sibyll"):
        known = line.get_ydata()[np.isfinite(line.get_ydata())]
        np.testing.assert_allclose(known, 1.0)
    alone = compare(["guan", "bugaev"], [0.0], 100.0, Physics())
    assert energy_spectra.reference_model(alone) == "guan"


def test_the_area_that_counts_starts_at_the_minimum_energy(comparison, spectrum_axes):
    for main, _ in spectrum_axes.values():
        (area,) = (
            one
            for one in main.collections
            if isinstance(one, PolyCollection) and to_hex(one.get_facecolor()[0]) == looks.COUNTED
        )
        corners = area.get_paths()[0].vertices
        assert corners[:, 0].min() == pytest.approx(comparison.minimum_energy_gev)
        assert corners[:, 0].max() == pytest.approx(1e5)
        (text,) = main.texts
        assert "> 412.2 GeV" in text.get_text()
        assert "cm⁻² sr⁻¹ day⁻¹" in text.get_text()


def test_nothing_is_shaded_where_the_energy_is_unknown():
    thick = compare(["guan"], [30.0], 700.0, Physics(energy_loss="paper"))
    main, _ = documents.spectrum_figure(thick).axes
    # The error bars of measured points alone.
    assert not [one for one in main.collections if isinstance(one, PolyCollection)]
    assert png_bytes(documents.panel(thick), 40)


def test_losses_and_minimum_energies_have_units_and_differences(comparison):
    stopping, difference, energy, law = documents.loss_figure(comparison).axes
    assert stopping.get_ylabel() == "Stopping power (MeV cm²/g)"
    assert difference.get_xlabel() == "Kinetic energy (GeV)"
    assert difference.get_ylabel().endswith("(%)")
    assert energy.get_ylabel() == "Minimum kinetic energy (GeV)"
    assert law.get_xlabel() == "Thickness (m)"
    named = [text.get_text() for text in stopping.get_legend().get_texts()]
    expected = [MATERIALS[name].title for name in ("standard_rock", "water", "granite")]
    assert named == [*expected, "Polynomial of Lesparre et al."]
    laws = [text.get_text() for text in energy.get_legend().get_texts()]
    assert laws == [*losses.LAW_TITLES.values(), "500 m: 412.2 GeV (csda)"]
    rock = next(one for one in comparison.losses if one.material == "standard_rock")
    drawn = difference.lines[0].get_ydata()
    np.testing.assert_allclose(drawn, 100 * (rock.polynomial / rock.stopping_power - 1))


def test_transmission_and_flux_have_units_and_a_thickness_above(comparison):
    axes = documents.attenuation_figure(comparison).axes
    labels = {one.get_ylabel() for one in axes}
    assert {"Transmission (flux / open sky)", "Muon flux (cm⁻² sr⁻¹ day⁻¹)"} <= labels
    opacity = [one for one in axes if one.get_xlabel() == "Opacity (g/cm²)"]
    thickness = [one for one in axes if one.get_xlabel() == "Thickness at 2.65 g/cm³ (m)"]
    assert len(opacity) == len(thickness) == 2
    np.testing.assert_allclose(
        np.array(opacity[0].get_xlim()) / 265.0, thickness[0].get_xlim(), rtol=1e-12
    )


def test_bands_span_the_models_that_hold(comparison):
    flux = documents.attenuation_figure(comparison).axes[1]
    band = flux.collections[0].get_paths()[0].vertices
    curves = [one for one in comparison.attenuations if one.zenith_deg == 0.0]
    where = np.argmin(np.abs(np.log(curves[0].opacity_g_cm2 / 1e5)))
    opacity = curves[0].opacity_g_cm2[where]
    holding = [one.flux[where] for one in curves if one.holds[where]]
    assert len(holding) > 2
    at = band[np.isclose(band[:, 0], opacity), 1]
    assert (at.min(), at.max()) == pytest.approx((min(holding), max(holding)))


@pytest.mark.parametrize(
    "angles", [(0.0,), (0.0, 80.0), (0.0, 40.0, 60.0, 80.0), tuple(map(float, range(0, 84, 7)))]
)
def test_the_page_grows_with_the_angles_and_draws(angles):
    one = compare(["guan", "bugaev"], angles, 50.0, Physics(), 2000.0)
    figure = documents.panel(one)
    rows = {1: 1, 2: 1, 4: 2, 12: 4}[len(angles)]
    height = energy_spectra.height_in(one) + losses.HEIGHT_IN + attenuation.HEIGHT_IN
    assert figure.get_size_inches()[1] == pytest.approx(height)
    assert 3.5 < (energy_spectra.height_in(one) - 1.1) / rows < 4.0
    assert png_bytes(figure, 30).startswith(b"\x89PNG")


def test_texts_stay_on_the_page(comparison):
    figure = documents.panel(comparison)
    renderer = figure.canvas.get_renderer()
    figure.draw(renderer)
    width, height = figure.canvas.get_width_height()
    for text in figure.texts:
        box = text.get_window_extent(renderer)
        assert box.x0 >= 0
        assert box.x1 <= width
        assert box.y0 >= 0
        assert box.y1 <= height


def test_the_report_tells_fluxes_warnings_and_whom_to_cite(comparison):
    page = report_html(
        documents.report(comparison, Provenance(outputs={"Table of spectra": "/x/t.csv"}))
    )
    assert "Flux, Guan et al. at 85°" in page
    assert "Flux, Bugaev at 85°, outside the model’s range" in page.replace("&#39;", "’")
    assert "farther from the zenith than the 10°" in page
    assert "t.csv" in page
    for name in MODELS:
        assert MODELS[name].citation.split(" (")[0].replace("&", "&amp;") in page
    assert page.count("data:image/png;base64") == 3
