"""Opacity from flux is the inverse of flux from opacity."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.radiography.energy_loss import csda_range
from muysc_qgis.radiography.inversion import opacity_from_flux
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate


@pytest.mark.parametrize(
    "physics",
    [
        Physics(),
        Physics(flux_model="guan", material="water", detection_threshold_gev=5.0),
        Physics(flux_model="reyna-bugaev", straggling=False, energy_loss="lesparre"),
        Physics(flux_model="bugaev", energy_loss="paper"),
        Physics(flux_model="reyna-hebbeker", altitude_correction=False),
        Physics(flux_model="gaisser", material="basalt"),
    ],
)
def test_round_trip(physics):
    longest = 1.6e5 if physics.energy_loss == "paper" else 4e5
    opacity = np.random.default_rng(1).uniform(2e3, longest, (40, 50))
    elevation = np.linspace(89, 2, 40)[:, None]
    muons = attenuate(opacity, elevation, physics, 1200.0)
    again = opacity_from_flux(muons.flux, elevation, physics, 1200.0)
    # Behind thin rock near the horizon nearly every muon comes through, so the flux says little.
    telling = muons.transmission < 0.95
    assert np.mean(telling) > 0.8
    np.testing.assert_allclose(again[telling], opacity[telling], rtol=2e-3)
    flux = attenuate(again, elevation, physics, 1200.0).flux
    np.testing.assert_allclose(flux, muons.flux, rtol=1e-3)


def test_very_thick_rock():
    opacity = np.array([1e6, 2e6, 2.9e6])
    flux = attenuate(opacity, 10.0, Physics()).flux
    np.testing.assert_allclose(opacity_from_flux(flux, 10.0, Physics()), opacity, rtol=2e-3)


def test_open_sky_or_more_means_no_rock():
    sky = float(attenuate(0.0, 30.0, Physics()).open_sky)
    flux = np.array([sky, 1.5 * sky])
    np.testing.assert_array_equal(opacity_from_flux(flux, 30.0, Physics()), 0.0)


def test_slightly_less_than_open_sky_means_a_little_rock():
    # A formula's open sky starts at 1 GeV/c, which crosses this much rock by itself.
    guan = Physics(flux_model="guan")
    sky = float(attenuate(0.0, 30.0, guan).open_sky)
    opacity = opacity_from_flux(np.array(0.999 * sky), 30.0, guan)
    assert float(opacity) == pytest.approx(float(csda_range(np.array(0.899908))), rel=0.05)


def test_unknown_stays_unknown():
    flux = np.array([np.nan, 0.0, 1.0, 1e-300])
    opacity = opacity_from_flux(flux, np.array([30.0, 30.0, -1.0, 30.0]), Physics())
    assert np.all(np.isnan(opacity))


def test_shape_is_kept():
    assert opacity_from_flux(1.0, 30.0, Physics()).shape == ()
    assert opacity_from_flux(np.ones((3, 4)), np.full((3, 1), 30.0), Physics()).shape == (3, 4)


@pytest.mark.parametrize("flux", [-1.0, np.inf])
def test_useless_flux_is_refused(flux):
    with pytest.raises(MuyscError, match="flux"):
        opacity_from_flux(np.array([flux]), 30.0, Physics())
