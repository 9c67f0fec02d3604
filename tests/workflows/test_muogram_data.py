"""What muograms of several stations say of opacities, and which do not go together."""

from dataclasses import replace

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.muogram import Muogram
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.muogram_data import read_survey
from muysc_qgis.workflows.named_view import NamedView
from muysc_qgis.workflows.simulation import Telescope, simulate

DETECTOR, CRATER = (14.410686, 40.810561), (14.4265, 40.8215)
#: g/cm³
ERROR = 0.3


def changed(one, quantity, values, **metadata):
    """Another quantity on the directions of a muogram."""
    return NamedView(f"{one.name}_{quantity}", one.view.with_values(quantity, values, **metadata))


@pytest.fixture(scope="module")
def thickness(dem):
    places = [from_wgs84(dem.crs, *place) for place in (DETECTOR, CRATER)]
    simulation = simulate(take_sight(dem, *places), Aperture(20, 6, 6, 4), Physics(), Telescope())
    return simulation.muograms["thickness"]


@pytest.mark.parametrize(("minimum_counts", "share"), [(100.0, 1.0), (0.0, 6.0), (None, 6.0)])
def test_merged_pixels_weigh_as_much_as_their_region(dem, thickness, minimum_counts, share):
    """Weights are 1/σ²: those of a region's pixels add up to that of its one measurement."""
    assert thickness.values.shape == (4, 6)
    assert (thickness.values > 0).all()
    region = np.repeat(np.arange(4), 6).reshape(4, 6)
    said = {} if minimum_counts is None else {"MINIMUM_COUNTS": minimum_counts}
    density = thickness.with_values("density", 2.0 + 0.1 * region, **said)
    errors = thickness.with_values("density_error", np.full((4, 6), ERROR), **said)
    data = read_survey([NamedView("density", density)], [NamedView("errors", errors)], dem)
    error = data.stations[0].error / (100.0 * data.rock[0].thickness_m)
    weights = np.bincount(region.ravel(), error**-2)
    np.testing.assert_allclose(weights, share / ERROR**2, rtol=1e-9)


@pytest.mark.parametrize("model", [0.03, 0.06])
def test_the_error_of_the_flux_model_is_common_and_taken_out(dem, thickness, model):
    """The error of `density` with and without it: what is left is the counting error."""
    from muysc_qgis.measurement.density import Scene, measure_density
    from muysc_qgis.measurement.observation import from_counts
    from muysc_qgis.radiography.transmission import attenuate

    elevation = thickness.elevation_deg[:, None]
    altitude = thickness.number("DETECTOR_ELEVATION")
    flux = attenuate(100 * 2.4 * thickness.values, elevation, Physics(), altitude).flux
    seen = from_counts(np.full(flux.shape, 1000.0), 1.0, 1000.0 / flux, 0.95)
    plain, both = (
        measure_density(seen, Scene(thickness.values, elevation, Physics(), altitude, share), 0.0)
        for share in (0.0, model)
    )
    said = {"MODEL_UNCERTAINTY": model}
    density = NamedView("a", thickness.with_values("density", both.density, **said))
    errors = NamedView("b", thickness.with_values("density_error", both.error, **said))
    data = read_survey([density], [errors], dem)
    found = data.stations[0].error / (100.0 * data.rock[0].thickness_m)
    np.testing.assert_allclose(found, plain.error.ravel(), rtol=0.1)
    assert np.all(both.error > 1.3 * plain.error)
    assert sum("common to all pixels" in text for text in data.warnings) == 1


def test_pixels_without_a_muon_that_are_left_out_are_told(dem, thickness):
    values = np.full(thickness.values.shape, 2.4)
    errors = np.where(np.arange(values.size).reshape(values.shape) < 5, np.nan, 0.1)
    for minimum, told in ((0.0, True), (20.0, False)):
        said = {"MINIMUM_COUNTS": minimum, "FLAGS": "0 unknown"}
        density = NamedView("a", thickness.with_values("density", values, **said))
        error = NamedView("b", thickness.with_values("density_error", errors, **said))
        warnings = read_survey([density], [error], dem).warnings
        assert any("5 pixels counted no muon" in text for text in warnings) is told


def test_errors_find_their_muograms_in_any_order(dem, views):
    given = views("opacity")[:3]
    errors = [
        changed(one, "opacity_error", np.full(one.view.values.shape, 100.0 * (number + 1)))
        for number, one in enumerate(given)
    ]
    data = read_survey(given, errors[::-1], dem)
    assert [np.nanmedian(one.error) for one in data.stations] == [100, 200, 300]


def test_errors_are_those_of_their_detector_where_directions_are_the_same(dem, views):
    (near,) = views("opacity")[:1]
    beside = {"DETECTOR_LON": near.number("DETECTOR_LON") + 0.001}
    far = changed(near, "opacity", near.view.values, **beside)
    errors = [
        changed(one, "opacity_error", np.full(one.view.values.shape, size))
        for one, size in ((far, 200.0), (near, 100.0))
    ]
    data = read_survey([near, far], errors, dem)
    assert [np.nanmedian(one.error) for one in data.stations] == [100, 200]


def test_the_sky_has_no_density_and_no_opacity(dem, views):
    (one,) = views("thickness")[:1]
    density = changed(one, "density", np.where(one.view.values > 0, 2.4, np.nan))
    (station,) = read_survey([density], [], dem).stations
    sky = one.view.values.ravel() == 0
    assert np.count_nonzero(sky) > 10
    assert np.all(station.opacity[sky] == 0)


def test_rock_as_bright_as_the_sky_says_nothing_and_is_told(dem, views):
    (one,) = views("flux")[:1]
    values = one.view.values.copy()
    darkest = np.nanargmin(values)
    values.flat[darkest] = 1e3
    (station,) = read_survey([changed(one, "flux", values)], [], dem).stations
    bright = np.flatnonzero(station.lost["as bright as the open sky: density 0"])
    assert bright.tolist() == [darkest]
    assert np.isnan(station.opacity[bright]).all()


def test_errors_of_a_flux_become_those_of_the_opacity(dem, views):
    """σ(ln ϱ) = σ(ln I) / |d ln I/d ln ϱ|, with the slope by finite differences of the data."""
    given = views("flux")[:1]
    share = 0.01
    errors = [changed(one, "flux_error", share * one.view.values) for one in given]
    (station,) = read_survey(given, errors, dem).stations
    brighter = changed(given[0], "flux", given[0].view.values * (1 - share))
    (denser,) = read_survey([replace(brighter, name=given[0].name)], [], dem).stations
    rock = station.opacity > 1e4
    np.testing.assert_allclose(
        station.error[rock], (denser.opacity - station.opacity)[rock], rtol=0.03
    )


def test_muograms_of_another_terrain_are_warned_of(dem, views):
    (one,) = views("thickness")[:1]
    high = one.view.number("DETECTOR_ELEVATION") + 60
    moved = changed(one, "thickness", 1.2 * one.view.values, DETECTOR_ELEVATION=high)
    assert read_survey([one], [], dem).warnings[1:] == ()
    _, ground, thickness = read_survey([moved], [], dem).warnings
    assert "its detector stands 60 m above the ground of vesuvius_srtmgl1.tif" in ground
    assert "through the elevation model differ by" in thickness


REFUSALS = [
    (lambda v: [v["opacity"][0], v["flux"][1]], [], r"different quantities: opacity .* and flux"),
    (lambda v: [], [], r"No muogram is given"),
    (lambda v: [changed(v["flux"][0], "counts", v["flux"][0].view.values)], [],
     r"hold counts, and opacity follows from density, opacity, flux"),
    (lambda v: v["opacity"][:2], lambda v: v["flux"][:1], r"are opacity_error; choose such"),
    (lambda v: v["opacity"][1:3],
     lambda v: [changed(v["opacity"][0], "opacity_error", v["opacity"][0].view.values)],
     r"belong to none of the muograms"),
    (lambda v: v["opacity"][:2],
     lambda v: [changed(v["opacity"][0], "opacity_error", v["opacity"][0].view.values)],
     r"site_1_opacity has no errors, which 1 of 2 muograms have"),
]  # fmt: skip


@pytest.mark.parametrize(("muograms", "errors", "sentence"), REFUSALS)
def test_muograms_that_do_not_go_together_are_refused(dem, views, muograms, errors, sentence):
    given = {name: views(name) for name in ("opacity", "flux")}
    with pytest.raises(MuyscError, match=sentence):
        read_survey(muograms(given), errors(given) if errors else [], dem)


@pytest.mark.parametrize(
    ("quantity", "key"),
    [("opacity", "DETECTOR_LON"), ("flux", "FLUX_MODEL"), ("thickness", "DENSITY")],
)
def test_missing_metadata_name_the_key_and_the_file(dem, views, quantity, key):
    one = views(quantity)[0]
    metadata = {name: value for name, value in one.view.metadata.items() if name != key}
    bare = Muogram(
        quantity, one.view.values, one.view.azimuth_deg, one.view.elevation_deg, metadata
    )
    with pytest.raises(MuyscError, match=rf"site_0_{quantity} .*lacks the metadata key {key} \("):
        read_survey([NamedView(one.name, bare)], [], dem)


@pytest.mark.parametrize("height", ["inf", "nan", "1e999", "high"])
def test_metadata_that_are_no_finite_numbers_are_refused(dem, views, height):
    one = views("thickness")[0]
    odd = replace(one.view, metadata={**one.view.metadata, "DETECTOR_ELEVATION": height})
    sentence = f"DETECTOR_ELEVATION of site_0_thickness is “{height}”, which is not a finite number"
    with pytest.raises(MuyscError, match=sentence):
        read_survey([NamedView(one.name, odd)], [], dem)
    with pytest.raises(MuyscError, match=f"“{height}”, which is not a finite number"):
        odd.number("DETECTOR_ELEVATION")
