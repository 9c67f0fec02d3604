"""The sea-level spectra against published values and their own limits."""

import numpy as np
import pytest
from scipy.integrate import quad

from muysc_qgis.radiography.constants import MUON_MASS_GEV
from muysc_qgis.radiography.gaisser import (
    GAISSER_PARAMETERS,
    cos_zenith_at_production,
    effective_cos_zenith,
    gaisser,
    gaisser_tang,
    guan,
)
from muysc_qgis.radiography.reyna import (
    BUGAEV_BREAKS_GEV,
    HEBBEKER_END_GEV,
    bugaev,
    reyna_bugaev,
    reyna_hebbeker,
)
from muysc_qgis.radiography.spectra import (
    MODELS,
    differential_flux,
    kinetic_from_momentum,
    momentum_from_kinetic,
)

# The values at single energies and the integrals are those of the project's physics
# reference, computed there from the published formulas independently of this code.


def test_gaisser_tang_vertical_values():
    energy = np.array([1.0, 3.0, 10.0, 100.0, 1000.0])
    expected = [2.621e-3, 1.112e-3, 1.362e-4, 2.874e-7, 1.304e-10]
    np.testing.assert_allclose(gaisser_tang(energy, 1.0), expected, rtol=5e-4)


def test_bugaev_values():
    momentum = np.array([10.0, 100.0, 1000.0])
    np.testing.assert_allclose(bugaev(momentum), [1.340e-4, 2.892e-7, 1.386e-10], rtol=5e-4)


def test_reyna_hebbeker_vertical_values():
    momentum = np.array([10.0, 100.0, 1000.0])
    expected = [1.168e-4, 2.591e-7, 1.427e-10]
    np.testing.assert_allclose(reyna_hebbeker(momentum, 1.0), expected, rtol=5e-4)


def test_guan_vertical_values():
    np.testing.assert_allclose(guan(np.array([10.0, 100.0]), 1.0), [1.167e-4, 2.829e-7], rtol=5e-4)


@pytest.mark.parametrize(
    ("zenith_deg", "intensity"),
    [
        (0, 7.016e-3),
        (30, 5.519e-3),
        (60, 2.070e-3),
        (75, 5.832e-4),
        (80, 2.646e-4),
        (85, 6.684e-5),
        (88, 1.072e-5),
    ],
)
def test_reyna_bugaev_intensity_above_1_gev(zenith_deg, intensity):
    cosine = np.cos(np.radians(zenith_deg))
    value, _ = quad(lambda u: np.exp(u) * reyna_bugaev(np.exp(u), cosine), 0, np.log(1e6))
    assert value == pytest.approx(intensity, rel=3e-4)


def test_reyna_bugaev_is_bugaev_for_vertical_muons_within_their_fits():
    # Reyna refitted the constants of Bugaev et al.; both describe vertical muons.
    momentum = np.geomspace(3, 300, 20)
    np.testing.assert_allclose(reyna_bugaev(momentum, 1.0), bugaev(momentum), rtol=0.15)


def test_bugaev_is_continuous_across_its_breaks():
    below = bugaev(np.array(BUGAEV_BREAKS_GEV) * (1 - 1e-9))
    above = bugaev(np.array(BUGAEV_BREAKS_GEV) * (1 + 1e-9))
    np.testing.assert_allclose(above, below, rtol=4e-3)  # the table's printed digits


def test_hebbeker_continues_smoothly_and_keeps_falling():
    ends = HEBBEKER_END_GEV * np.array([0.999, 1.001])
    inside, outside = np.log(reyna_hebbeker(ends, 1.0))
    assert outside - inside == pytest.approx(-3.3 * np.log(1.001 / 0.999), rel=0.05)
    tail = reyna_hebbeker(np.geomspace(1e4, 1e9, 50), 1.0)
    assert np.all(np.diff(np.log(tail)) / np.diff(np.log(np.geomspace(1e4, 1e9, 50))) < -3)


def test_tang_approaches_gaisser_at_high_energy():
    # Energy loss and decay in the air no longer matter at 10 TeV; prompt muons do little.
    ratio = gaisser_tang(np.array(1e4), 1.0) / gaisser(np.array(1e4), 1.0)
    assert ratio == pytest.approx(1.0, abs=0.03)


def test_gaisser_at_low_projected_energy_is_the_bare_power_law():
    p = GAISSER_PARAMETERS["volkova"]
    value = gaisser(np.array(1.0), np.array(1e-6), p)
    assert value == pytest.approx(p.amplitude * (1 + p.kaon_weight), rel=1e-6)


def test_effective_cosines_are_1_overhead_and_positive_at_the_horizon():
    for cosine in (cos_zenith_at_production, effective_cos_zenith):
        assert cosine(np.array(1.0)) == pytest.approx(1.0)
        assert 0.09 < cosine(np.array(0.0)) < 0.11


@pytest.mark.parametrize("model", MODELS)
def test_every_model_is_positive_and_falls_with_energy(model):
    energy = np.geomspace(20, 1e6, 100)[:, None]
    cosine = np.cos(np.radians([0.0, 40.0, 75.0, 89.0]))
    flux = differential_flux(energy, cosine, model)
    assert flux.shape == (100, 4)
    assert np.all(flux > 0)
    # Near the horizon muons of tens of GeV still decay, so the flux falls from higher up.
    falling = np.broadcast_to(energy * cosine**2 > 10, flux.shape)
    assert np.all(np.diff(flux, axis=0)[falling[:-1]] < 0)


@pytest.mark.parametrize("model", MODELS)
def test_models_agree_where_all_are_fitted(model):
    # Vertical muons of 200 GeV: published spectra differ by some 15 %.
    assert differential_flux(np.array(200.0), np.array(1.0), model) == pytest.approx(
        differential_flux(np.array(200.0), np.array(1.0), "bugaev"), rel=0.16
    )


def test_momentum_spectra_are_converted_to_energy():
    kinetic = np.array([0.05, 1.0, 50.0])
    momentum = np.sqrt((kinetic + MUON_MASS_GEV) ** 2 - MUON_MASS_GEV**2)
    expected = reyna_bugaev(momentum, 0.5) * (kinetic + MUON_MASS_GEV) / momentum
    np.testing.assert_allclose(differential_flux(kinetic, 0.5, "reyna-bugaev"), expected)


def test_momentum_and_kinetic_energy_are_inverse():
    momentum = np.geomspace(1e-3, 1e6, 50)
    np.testing.assert_allclose(
        momentum_from_kinetic(kinetic_from_momentum(momentum)), momentum, rtol=1e-12
    )


def test_energy_ranges_follow_model_zenith_and_parameters():
    vertical, inclined = np.array(1.0), np.array(0.5)
    default = GAISSER_PARAMETERS["gaisser"]
    assert MODELS["gaisser"].energy_range_gev(inclined, default) == (200.0, 1e5)
    assert MODELS["reyna-bugaev"].energy_range_gev(inclined, default) == (1.0, 4000.0)
    # At the horizon Tang's limit stays at 1 GeV/cosθ*.
    horizon = MODELS["gaisser-tang"].energy_range_gev(np.array(1e-9), default)[0]
    assert horizon == pytest.approx(10, rel=0.02)
    # A set fitted from 2 TeV does not become valid at 1 GeV by Tang's extension.
    aglietta = GAISSER_PARAMETERS["aglietta"]
    assert MODELS["gaisser-tang"].energy_range_gev(vertical, default)[0] == 1.0
    assert MODELS["gaisser-tang"].energy_range_gev(vertical, aglietta) == (2e3, 4e4)


def test_guan_is_the_reference_flux_of_mulder():
    mulder = pytest.importorskip("mulder")
    reference = mulder.Reference("GCCLY15")
    kinetic = np.geomspace(1e-2, 1e6, 60)
    for elevation in (90.0, 45.0, 15.0, 2.0):
        flux = np.asarray(reference.flux(energy=kinetic, elevation=elevation)) * 1e-4  # per cm²
        cosine = np.sin(np.radians(elevation))
        np.testing.assert_allclose(differential_flux(kinetic, cosine, "guan"), flux, rtol=1e-3)
