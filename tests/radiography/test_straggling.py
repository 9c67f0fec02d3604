"""The straggling correction against full transport, and the whole chain against mulder."""

import numpy as np
import pytest

from muysc_qgis.radiography.constants import SECONDS_PER_DAY
from muysc_qgis.radiography.materials import MATERIALS
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.straggling import (
    maximum_opacity_g_cm2,
    radiative_scale,
    straggling_factor,
)
from muysc_qgis.radiography.transmission import attenuate

#: Intensity with mean losses only, and with all of them; Guan's spectrum is mulder's own.
MEAN = Physics(flux_model="guan", straggling=False)
FULL = Physics(flux_model="guan")


def ratio(opacity_km_we, zenith_deg):
    opacity = np.asarray(opacity_km_we) * 1e5
    full = attenuate(opacity, 90.0 - zenith_deg, FULL).flux
    return full / attenuate(opacity, 90.0 - zenith_deg, MEAN).flux


def test_ratio_of_full_transport_to_mean_losses():
    # The physics reference gives one ratio for each depth, whatever the zenith angle.
    depth = np.array([0.5, 1.0, 2.0, 3.0, 5.0])
    expected = [1.005, 1.015, 1.046, 1.113, 1.43]
    np.testing.assert_allclose(ratio(depth, 0.0), expected, rtol=0.05)


def test_factor_depends_on_zenith_by_the_steepness_of_the_spectrum():
    vertical, inclined = ratio(5.0, 0.0), ratio(5.0, 84.3)
    assert 1.03 < vertical / inclined < 1.10


def test_factor_is_one_without_rock_and_grows_with_rock_and_steepness():
    opacity = np.linspace(0, 1.5e6, 301)
    index = np.array([1.8, 2.2, 2.6, 3.0])[:, None]
    factor = straggling_factor(opacity, index)
    np.testing.assert_array_equal(factor[:, 0], 1.0)
    assert np.all(np.diff(factor[1:], axis=1) > 0)
    assert np.all(np.diff(factor[:, 1:], axis=0) >= 0)
    assert np.all(factor >= 1)


def test_factor_holds_beyond_its_table():
    end = maximum_opacity_g_cm2()
    assert end == 1.5e6
    assert straggling_factor(2 * end, 2.5) == straggling_factor(end, 2.5)


def test_materials_are_scaled_by_their_radiative_losses():
    assert radiative_scale("standard_rock") == 1
    assert radiative_scale("water") < radiative_scale("granite") < radiative_scale("basalt")
    water = straggling_factor(5e5, 2.5, "water")
    assert water == straggling_factor(5e5 * radiative_scale("water"), 2.5)


@pytest.mark.parametrize(
    ("material", "opacity_km_we", "expected"),
    [
        # Backward transport with mulder 0.3.7 of 30000 muons through slabs, s = 2.5, ±0.8 %.
        ("water", 6.0, 1.260),
        ("limestone", 6.0, 1.527),
        ("basalt", 6.0, 1.541),
        ("granite", 3.0, 1.118),
    ],
)
def test_scaling_agrees_with_transport_through_the_material(material, opacity_km_we, expected):
    assert material in MATERIALS
    factor = straggling_factor(opacity_km_we * 1e5, 2.5, material)
    assert factor == pytest.approx(expected, rel=0.015)


def mulder_intensity(mulder, mode, opacity_km_we, zenith_deg, count):
    """Intensity under a slab of standard rock, cm⁻² s⁻¹ sr⁻¹, by integrating mulder's flux."""
    length_m, zenith = opacity_km_we * 1e5 / 265.0, np.radians(zenith_deg)
    # The slab follows the Earth, so that a slanting path in it starts a little deeper.
    depth_m = length_m * np.cos(zenith) + (length_m * np.sin(zenith)) ** 2 / (2 * 6.371e6)
    meter = mulder.Fluxmeter(
        mulder.Layer(0.0, material="Rock"),
        mode=mode,
        reference=mulder.Reference("GCCLY15"),
        random=mulder.Random(11),
    )
    # Midpoints in ln E, below which the flux is constant and above which there is none.
    edges = np.linspace(np.log(1e-3), np.log(3e5), count + 1)
    energy = np.exp(0.5 * (edges[1:] + edges[:-1]))
    arguments = {} if mode == "continuous" else {"events": 1}
    flux = meter.flux(energy=energy, altitude=-depth_m, elevation=90.0 - zenith_deg, **arguments)
    flux = np.asarray(flux).reshape(count, -1)[:, 0]
    return float(np.sum(flux * energy) * (edges[1] - edges[0])) * 1e-4  # per cm²


POINTS = [(0.3, 0.0), (1.0, 60.0), (2.0, 75.5), (5.0, 84.3), (8.0, 0.0)]


@pytest.mark.parametrize(("opacity_km_we", "zenith_deg"), POINTS)
def test_intensity_with_mean_losses_matches_mulder(opacity_km_we, zenith_deg):
    mulder = pytest.importorskip("mulder")
    expected = mulder_intensity(mulder, "continuous", opacity_km_we, zenith_deg, 4000)
    flux = attenuate(opacity_km_we * 1e5, 90.0 - zenith_deg, MEAN).flux
    # mulder takes the zenith angle where the muon enters the rock, here up to 0.02° less.
    assert flux / SECONDS_PER_DAY == pytest.approx(expected, rel=4e-3)


@pytest.mark.parametrize(("opacity_km_we", "zenith_deg"), POINTS)
def test_intensity_with_all_losses_matches_mulder(opacity_km_we, zenith_deg):
    mulder = pytest.importorskip("mulder")
    # 30000 muons give the intensity to 1 %.
    expected = mulder_intensity(mulder, "mixed", opacity_km_we, zenith_deg, 30000)
    flux = attenuate(opacity_km_we * 1e5, 90.0 - zenith_deg, FULL).flux
    assert flux / SECONDS_PER_DAY == pytest.approx(expected, rel=0.04)
