"""Stopping power, range and minimum energy against tables, closed forms and mulder."""

import numpy as np
import pytest
from scipy.integrate import quad

from muysc_qgis.radiography.energy_loss import (
    ENERGY_LOSSES,
    csda_range,
    minimum_energy,
    range_law,
    stopping_power,
)
from muysc_qgis.radiography.materials import DATA_FOLDER, MATERIALS, energy_loss_table
from muysc_qgis.radiography.settings import Physics

#: g/cm² of a length in metres of standard rock.
ROCK = 265.0


def test_lesparre_polynomial_at_100_gev():
    # Exponents of 2 summed by hand: 0.2464 − 0.3688 + 0.1472 + 0.1602 + 0.2549.
    value = stopping_power(np.array(100.0), energy_loss="lesparre") * 1e3
    assert value == pytest.approx(2.7536, abs=5e-5)
    assert value == pytest.approx(10**0.4399, rel=1e-12)


def test_lesparre_follows_the_table_up_to_1_tev_only():
    energy = np.geomspace(1, 300, 40)
    ratio = stopping_power(energy, energy_loss="lesparre") / stopping_power(energy)
    assert np.max(np.abs(ratio - 1)) < 0.01
    high = np.array([1e3, 3e3, 1e4])
    ratio = stopping_power(high, energy_loss="lesparre") / stopping_power(high)
    np.testing.assert_allclose(ratio, [1.02, 1.28, 3.0], rtol=0.03)


def test_standard_rock_range():
    # Groom, Mokhov & Striganov (2001), table for standard rock, as in the physics reference.
    energy = np.array([10.0, 100.0, 1e3, 1e5])
    np.testing.assert_allclose(csda_range(energy), [4.92e3, 4.08e4, 2.45e5, 1.19e6], rtol=5e-3)


def test_minimum_energy_behind_standard_rock():
    lengths = np.array([100.0, 500.0, 1000.0, 2000.0])
    expected = [62.0, 410.0, 1138.0, 4737.0]
    np.testing.assert_allclose(
        minimum_energy(ROCK * lengths, Physics(flux_model="guan")), expected, rtol=5e-3
    )


def test_paper_option_gives_the_published_energies():
    energy = minimum_energy(
        ROCK * np.array([100.0, 300.0, 500.0]), Physics(flux_model="guan", energy_loss="paper")
    )
    np.testing.assert_allclose(energy, [68.98, 281.0, 721.0], rtol=1e-3)


def test_paper_option_has_no_answer_beyond_613_m():
    energy = minimum_energy(
        ROCK * np.array([612.9, 613.2, 2000.0]), Physics(flux_model="guan", energy_loss="paper")
    )
    assert energy[0] < 1878
    assert np.all(np.isnan(energy[1:]))
    law = range_law(energy_loss="paper")
    assert np.exp(law.range_of_energy.x[-1]) == pytest.approx(1878, abs=1)
    assert law.maximum_range_g_cm2 / ROCK == pytest.approx(613, abs=0.5)


@pytest.mark.parametrize("energy_loss", ["csda", "lesparre"])
def test_range_is_the_integral_of_the_inverse_stopping_power(energy_loss):
    for low, high in ((1.0, 1.1), (30.0, 37.0), (1000.0, 1070.0), (2.0, 900.0)):
        integral, _ = quad(
            lambda u: np.exp(u) / float(stopping_power(np.exp(u), energy_loss=energy_loss)),
            np.log(low),
            np.log(high),
            limit=200,
        )
        first, second = csda_range(np.array([low, high]), energy_loss=energy_loss)
        assert second - first == pytest.approx(integral, rel=3e-4)  # S has four digits


@pytest.mark.parametrize("energy_loss", ENERGY_LOSSES)
@pytest.mark.parametrize("material", ["standard_rock", "water"])
def test_energy_to_range_and_back(energy_loss, material):
    top = {"csda": 0.99e9, "lesparre": 9.9e3, "paper": 1.8e3}[energy_loss]
    energy = np.geomspace(0.1, top, 3001)
    length = csda_range(energy, material, energy_loss)
    assert np.all(np.diff(length) > 0)
    back = minimum_energy(
        length, Physics(flux_model="guan", material=material, energy_loss=energy_loss)
    )
    np.testing.assert_allclose(back, energy, rtol=1e-4)


@pytest.mark.parametrize("energy_loss", ENERGY_LOSSES)
def test_no_rock_costs_no_energy(energy_loss):
    assert minimum_energy(np.array(0.0), Physics(flux_model="guan", energy_loss=energy_loss)) == 0
    physics = Physics(flux_model="guan", energy_loss=energy_loss, detection_threshold_gev=3.0)
    assert minimum_energy(np.array(0.0), physics) == 3.0


@pytest.mark.parametrize("energy_loss", ENERGY_LOSSES)
def test_little_rock_costs_little_energy(energy_loss):
    opacity = np.array([1e-9, 1e-6, 1e-3, 1.0])
    energy = minimum_energy(opacity, Physics(flux_model="guan", energy_loss=energy_loss))
    assert np.all(energy >= 0)
    assert energy[-1] < 0.02


def test_detection_threshold_adds_its_range():
    physics = Physics(detection_threshold_gev=10.0)
    energy = minimum_energy(np.array(1e4), physics)
    assert csda_range(energy) == pytest.approx(1e4 + csda_range(np.array(10.0)), rel=1e-5)


def test_unknown_opacity_has_no_minimum_energy():
    assert np.isnan(minimum_energy(np.array(np.nan), Physics(flux_model="guan")))


def test_more_rock_than_the_table_has_no_minimum_energy():
    beyond = range_law().maximum_range_g_cm2 * 1.001
    assert np.isnan(minimum_energy(np.array(beyond), Physics(flux_model="guan")))


def test_density_does_not_change_the_energy_at_given_opacity():
    opacity = np.array([1e3, 1e5])
    np.testing.assert_array_equal(
        minimum_energy(opacity, Physics(flux_model="guan", density_g_cm3=2.0)),
        minimum_energy(opacity, Physics(flux_model="guan")),
    )


@pytest.mark.parametrize("material", MATERIALS)
def test_every_material_has_a_table_with_provenance(material):
    table = energy_loss_table(material)
    assert np.all(np.diff(table.kinetic_energy_gev) > 0)
    assert np.all(np.diff(table.csda_range) > 0)
    # Minimum ionisation: 1.6 to 2.1 MeV cm²/g for anything from iron to water.
    assert 1.6e-3 < table.stopping_power.min() < 2.1e-3
    header = (DATA_FOLDER / f"{material}.csv").read_text(encoding="ascii").split("\n")
    assert MATERIALS[material].source in header[1]
    assert "mulder" in "".join(header[:7])


def test_water_stops_by_the_share_of_its_electrons():
    # Ionisation follows Z/A: 10/18.015 for water, 11/22 for standard rock.
    ratio = stopping_power(np.array(1.0), "water") / stopping_power(np.array(1.0))
    assert ratio == pytest.approx((10 / 18.015) / (11 / 22), rel=0.06)


def test_radiative_losses_order_the_materials_by_z2_over_a():
    # Lechmann et al. (2018), doi:10.5194/se-9-1517-2018: above standard rock's Z²/A of
    # 5.5 limestone and basalt lose more, water much less.
    loss = {name: stopping_power(np.array(1e4), name) for name in MATERIALS}
    assert loss["water"] < loss["granite"] < loss["limestone"]
    assert loss["granite"] < loss["andesite"] < loss["basalt"]
    assert loss["standard_rock"] < loss["basalt"]


def test_tables_match_mulder():
    mulder = pytest.importorskip("mulder")
    rock = mulder.Physics().compile("Rock")
    energy = np.geomspace(0.05, 1e6, 500)
    # mulder interpolates its own tables to a few 10⁻⁴.
    np.testing.assert_allclose(csda_range(energy), rock.range(energy) * ROCK, rtol=1e-3)
    np.testing.assert_allclose(
        stopping_power(energy), rock.stopping_power(energy) / ROCK, rtol=1e-3
    )


def test_minimum_energy_matches_mulder():
    mulder = pytest.importorskip("mulder")
    rock = mulder.Physics().compile("Rock")
    length = np.geomspace(1, 4000, 50)
    expected = rock.inverse_range(length)
    np.testing.assert_allclose(
        minimum_energy(ROCK * length, Physics(flux_model="guan")), expected, rtol=5e-3
    )
