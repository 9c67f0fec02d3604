"""The formulas of the first MUYSC, as the validation holds ours against them."""

import numpy as np
import pytest

from muysc_qgis.radiography.energy_loss import csda_range
from muysc_qgis.radiography.reyna import reyna_bugaev
from tools.validation.first_muysc import first_muons


def test_without_rock_all_of_the_open_sky_arrives():
    assert first_muons(0.0, 60.0).transmission == pytest.approx(1.0)


@pytest.mark.parametrize("zenith_deg", [0.0, 60.0, 84.0])
def test_flux_is_that_of_the_formula_of_reyna_but_for_the_base(zenith_deg):
    """Reyna's base is p cosθ; without the cosine the flux is cosθ to the same power of it."""
    found = first_muons(300.0, zenith_deg)
    energies = np.geomspace(found.minimum_energy_gev, 1e4, 2000)
    cosine = np.cos(np.radians(zenith_deg))
    power = np.polyval([0.0209, -0.2555, 1.288, 0.2455], np.log10(energies * cosine))
    spectrum = reyna_bugaev(energies, cosine) * cosine**power
    exact = 86400.0 * np.sum((spectrum[1:] + spectrum[:-1]) / 2 * np.diff(energies))
    # Steps of 1 GeV, the first of them whole.
    assert found.flux == pytest.approx(exact, rel=0.01)


def test_minimum_energy_is_close_to_the_range_in_thin_rock_and_far_below_it_in_thick():
    thin, thick = first_muons(50.0, 0.0), first_muons(1300.0, 0.0)
    ranges = csda_range(
        np.array([thin.minimum_energy_gev, thick.minimum_energy_gev]), "standard_rock", "csda"
    )
    assert ranges[0] == pytest.approx(50.0 * 265, rel=0.1)
    assert ranges[1] < 0.75 * 1300.0 * 265
