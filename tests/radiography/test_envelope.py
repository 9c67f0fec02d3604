"""The spread of the flux models: which ones count where, and that it encloses them."""

import numpy as np
import pytest

from muysc_qgis.radiography.envelope import model_envelope, model_holds
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.spectra import MODELS
from muysc_qgis.radiography.transmission import attenuate

OPACITY = np.array([0.0, 5e3, 3e4, 2e5, 6e5])
ELEVATION_DEG = np.array([[85.0], [40.0], [15.0], [5.0]])
FORMULA = Physics(flux_model="gaisser-tang")


def fluxes():
    return {
        name: attenuate(OPACITY, ELEVATION_DEG, Physics(flux_model=name)).flux
        for name, model in MODELS.items()
        if not model.tabulated
    }


def test_the_ends_are_fluxes_of_models():
    spread = model_envelope(OPACITY, ELEVATION_DEG, FORMULA)
    stack = np.stack(list(fluxes().values()))
    for end in (spread.minimum, spread.maximum):
        assert np.any(np.isclose(stack, end, rtol=1e-12), axis=0)[np.isfinite(end)].all()
    assert np.all(spread.minimum <= spread.maximum)
    # Behind rock the models differ, most of all near the horizon; none is off by factors.
    inclined = spread.maximum[2:, 2:4] / spread.minimum[2:, 2:4]
    assert np.all((inclined > 1.03) & (inclined < 2.5))


def test_every_model_that_holds_is_enclosed():
    spread = model_envelope(OPACITY, ELEVATION_DEG, FORMULA)
    cosine = np.sin(np.radians(ELEVATION_DEG))
    for name, flux in fluxes().items():
        energy = attenuate(OPACITY, ELEVATION_DEG, Physics(flux_model=name)).minimum_energy_gev
        counts = model_holds(Physics(flux_model=name), cosine, energy) & (OPACITY > 0)
        assert np.all((spread.minimum <= flux)[counts])
        assert np.all((flux <= spread.maximum)[counts])


@pytest.mark.parametrize(
    ("model", "zenith_deg", "energy_gev", "holds"),
    [
        # The ranges of the models' own papers, as the catalogue has them.
        ("gaisser", 60.0, 300.0, True),
        ("gaisser", 60.0, 150.0, False),  # 100/cos 60° = 200 GeV
        ("gaisser", 75.0, 1000.0, False),
        ("bugaev", 5.0, 50.0, True),
        ("bugaev", 30.0, 50.0, False),
        ("reyna-bugaev", 60.0, 3900.0, True),  # 2000/cos 60°
        ("reyna-bugaev", 60.0, 4100.0, False),
        ("guan", 85.0, 50.0, True),
        ("guan", 95.0, 50.0, False),
    ],
)
def test_a_model_holds_in_its_own_range(model, zenith_deg, energy_gev, holds):
    cosine = np.cos(np.radians(np.array([zenith_deg])))
    assert model_holds(Physics(flux_model=model), cosine, np.array([energy_gev]))[0] == holds


def test_slack_lets_a_spectrum_start_below_its_range():
    physics, cosine = Physics(flux_model="reyna-hebbeker"), np.array([1.0])
    assert not model_holds(physics, cosine, np.array([4.0]))[0]
    assert model_holds(physics, cosine, np.array([4.0]), 4.0)[0]


def test_no_model_has_an_answer_for_the_unknown_or_below_the_horizon():
    spread = model_envelope(np.array([np.nan, 1e4]), np.array([20.0, -1.0]), FORMULA)
    assert np.isnan(spread.minimum).all()
    assert np.isnan(spread.maximum).all()
    assert set(spread.rays.values()) == {0}
