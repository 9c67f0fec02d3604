"""Curves and tables of a comparison are what the library gives for each point."""

import csv

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.radiography.altitude import altitude_factor
from muysc_qgis.radiography.comparison import (
    MAXIMUM_THICKNESS_M,
    compare,
    grid,
    zenith_angles,
)
from muysc_qgis.radiography.comparison_tables import COLUMNS, rows
from muysc_qgis.radiography.constants import MUON_MASS_GEV
from muysc_qgis.radiography.energy_loss import csda_range, minimum_energy, stopping_power
from muysc_qgis.radiography.gaisser import GAISSER_PARAMETERS
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.spectra import MODELS, differential_flux, momentum_from_kinetic
from muysc_qgis.radiography.transmission import attenuate
from muysc_qgis.tables import write_table

ANGLES = (0.0, 75.0)


@pytest.fixture(scope="module")
def comparison():
    physics = Physics(density_g_cm3=2.4, material="granite")
    return compare(list(MODELS), ANGLES, 300.0, physics, 800.0, ["granite", "water"])


def test_every_model_and_angle_has_its_curves(comparison):
    expected = [(name, angle) for angle in ANGLES for name in MODELS]
    for curves in (comparison.spectra, comparison.attenuations, comparison.behind):
        assert [(one.model, one.zenith_deg) for one in curves] == expected


def test_spectra_are_the_models_own_with_the_altitude_in(comparison):
    for one in comparison.spectra:
        cosine = np.cos(np.radians(one.zenith_deg))
        if MODELS[one.model].tabulated:
            here = differential_flux(one.kinetic_energy_gev, cosine, one.model, altitude_m=800.0)
            np.testing.assert_array_equal(one.flux, here)
            assert np.all(one.error > 0.03)
            continue
        assert np.all(np.isnan(one.error))
        sea = differential_flux(one.kinetic_energy_gev, cosine, one.model)
        factor = altitude_factor(momentum_from_kinetic(one.kinetic_energy_gev), 800.0)
        np.testing.assert_allclose(one.flux, sea * factor, rtol=1e-12)


def test_a_spectrum_holds_between_the_limits_of_its_model(comparison):
    parameters = GAISSER_PARAMETERS["gaisser"]
    for one in comparison.spectra:
        model = MODELS[one.model]
        low, high = model.energy_range_gev(np.cos(np.radians(one.zenith_deg)), parameters)
        total = one.kinetic_energy_gev + MUON_MASS_GEV
        inside = (total >= low) & (total <= high) & (one.zenith_deg <= model.maximum_zenith_deg)
        np.testing.assert_array_equal(one.holds, inside)
    held = {(one.model, one.zenith_deg) for one in comparison.spectra if one.holds.any()}
    assert ("bugaev", 0.0) in held
    assert ("bugaev", 75.0) not in held
    assert ("gaisser", 75.0) not in held


def test_attenuation_is_that_of_a_simulation(comparison):
    for one in (*comparison.attenuations, *comparison.behind):
        # One cut for all, because the muon sky has one.
        physics = Physics(
            density_g_cm3=2.4,
            material="granite",
            flux_model=one.model,
            detection_threshold_gev=Physics().threshold_gev,
        )
        muons = attenuate(one.opacity_g_cm2, 90.0 - one.zenith_deg, physics, 800.0)
        np.testing.assert_array_equal(one.flux, muons.flux)
        np.testing.assert_array_equal(one.open_sky, muons.open_sky)
        np.testing.assert_array_equal(one.transmission, muons.transmission)
        np.testing.assert_array_equal(one.minimum_energy_gev, muons.minimum_energy_gev)


def test_the_thickness_asked_for_is_marked(comparison):
    assert comparison.opacity_g_cm2 == pytest.approx(300 * 100 * 2.4)
    assert {one.opacity_g_cm2[0] for one in comparison.behind} == {comparison.opacity_g_cm2}
    expected = minimum_energy(np.array(comparison.opacity_g_cm2), comparison.physics)
    assert comparison.minimum_energy_gev == expected


def test_the_ratio_is_that_of_models_that_hold_at_one_angle(comparison):
    ratios = []
    for angle in ANGLES:
        fluxes = [
            one.flux[0] for one in comparison.behind if one.zenith_deg == angle and one.holds[0]
        ]
        ratios.append(max(fluxes) / min(fluxes))
    assert comparison.largest_ratio == pytest.approx(max(ratios))
    alone = compare(["guan"], ANGLES, 300.0, Physics())
    assert np.isnan(alone.largest_ratio)


def test_losses_stand_beside_the_polynomial(comparison):
    assert [one.material for one in comparison.losses] == ["granite", "water"]
    for one in comparison.losses:
        table = 1e3 * stopping_power(one.kinetic_energy_gev, one.material)
        np.testing.assert_allclose(one.stopping_power, table)
        np.testing.assert_allclose(one.csda_range, csda_range(one.kinetic_energy_gev, one.material))
    water = comparison.losses[1]
    at_100_gev = np.argmin(np.abs(np.log(water.kinetic_energy_gev / 100)))
    # 2.7536 MeV cm²/g: the published polynomial at 100 GeV.
    assert water.polynomial[at_100_gev] == pytest.approx(2.7536, rel=1e-4)


def test_range_laws_end_where_they_have_no_answer(comparison):
    curves = {one.energy_loss: one for one in comparison.minimum_energies}
    np.testing.assert_allclose(curves["csda"].thickness_m * 240, curves["csda"].opacity_g_cm2)
    answered = curves["paper"].opacity_g_cm2[np.isfinite(curves["paper"].minimum_energy_gev)]
    # E/S of the polynomial has its maximum at 613 m of standard rock.
    assert answered.max() <= 613.5 * 265 < answered.max() * 10 ** (1 / 20)
    assert np.all(np.isfinite(curves["csda"].minimum_energy_gev))


def test_without_an_answer_the_minimum_energy_is_unknown_and_said():
    thick = compare(["guan", "bugaev"], [60.0], 700.0, Physics(energy_loss="paper"))
    assert np.isnan(thick.minimum_energy_gev)
    assert np.isnan(thick.largest_ratio)
    assert all(np.isnan(one.flux[0]) and not one.holds[0] for one in thick.behind)
    assert any("“paper” has no answer" in text for text in thick.warnings)


def test_equal_warnings_are_one_sentence_that_names_the_angles(comparison):
    texts = [text for text in comparison.warnings if "than the 10° up to" in text]
    assert len(texts) == 1
    assert texts[0].startswith("Bugaev at 75°: ")
    quiet = compare(["guan"], [0.0, 60.0], 100.0, Physics())
    assert quiet.warnings == ()


def test_curves_reach_the_thickness_asked_for():
    thick = compare(["guan"], [60.0], 6000.0, Physics())
    assert thick.spectra[0].kinetic_energy_gev[-1] > 2 * thick.minimum_energy_gev
    assert thick.attenuations[0].opacity_g_cm2[-1] >= thick.opacity_g_cm2
    np.testing.assert_allclose(np.diff(np.log10(grid(0, 2, 5000.0))), 1 / 20)


def test_a_model_named_twice_counts_once():
    twice = compare(["guan", "guan"], [0.0], 100.0, Physics())
    assert twice.models == ("guan",)
    assert len(twice.spectra) == 1


@pytest.mark.parametrize("table", COLUMNS)
def test_tables_hold_the_curves(comparison, tmp_path, table):
    lines = rows(comparison, table)
    path = tmp_path / "table.csv"
    write_table(path, COLUMNS[table], lines)
    with path.open(encoding="utf-8", newline="") as file:
        read = list(csv.reader(file))
    assert tuple(read[0]) == COLUMNS[table]
    assert len(read) == 1 + len(lines)
    assert {len(line) for line in read} == {len(COLUMNS[table])}


def test_spectrum_and_flux_rows_are_the_librarys(comparison):
    model, zenith, energy, flux, holds, error = rows(comparison, "spectra")[-1]
    last = comparison.spectra[-1]
    assert (model, zenith) == (last.model, last.zenith_deg)
    assert (energy, flux, holds) == (
        last.kinetic_energy_gev[-1], last.flux[-1], int(last.holds[-1]),
    )  # fmt: skip
    assert error == last.error[-1] > 0.1
    fluxes = rows(comparison, "fluxes")
    marked = [row for row in fluxes if row[3] == comparison.opacity_g_cm2]
    assert [row[0] for row in marked] == [one.model for one in comparison.behind]
    assert [row[5] for row in marked] == [one.flux[0] for one in comparison.behind]
    assert {round(row[2], 9) for row in marked} == {300.0}
    # In the order of the opacity, each curve for itself.
    curve = [row[3] for row in fluxes if row[:2] == ("guan", 75.0)]
    assert curve == sorted(curve)
    assert len(curve) == 1 + len(comparison.attenuations[0].opacity_g_cm2)


def test_a_thickness_on_the_grid_stands_there_once():
    on_grid = compare(["guan"], [0.0], 100.0, Physics(density_g_cm3=1.0))
    opacities = [row[3] for row in rows(on_grid, "fluxes")]
    assert opacities.count(1e4) == 1


def test_what_is_unknown_stays_empty(tmp_path):
    thick = compare(["guan"], [60.0], 700.0, Physics(energy_loss="paper"))
    write_table(tmp_path / "t.csv", COLUMNS["fluxes"], rows(thick, "fluxes"))
    last = (tmp_path / "t.csv").read_text(encoding="utf-8").splitlines()[-1].split(",")
    assert last[4] == last[5] == ""
    assert float(last[6]) > 0


def test_a_table_that_cannot_be_written_is_named(tmp_path):
    with pytest.raises(MuyscError, match="cannot be written"):
        write_table(tmp_path, ("a",), [])


@pytest.mark.parametrize(
    ("text", "angles"),
    [
        ("0, 30, 60", (0.0, 30.0, 60.0)),
        ("89.9", (89.9,)),
        ("85; 0 ;85", (85.0, 0.0)),
        ("10° 20°", (10.0, 20.0)),
    ],
)
def test_zenith_angles_are_read(text, angles):
    assert zenith_angles(text) == angles


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "empty"),
        (" , ", "empty"),
        ("0, 90", "angle of 90° is not above the horizon"),
        ("-1", "angle of -1°"),
        ("10, ten", "“ten” is no number"),
        ("nan", "“nan” is no number"),
        ("inf", "“inf” is no number"),
        (",".join(map(str, range(13))), "at most 12"),
    ],
)
def test_zenith_angles_without_an_answer_are_refused(text, words):
    with pytest.raises(MuyscError, match=words):
        zenith_angles(text)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"models": []}, "No flux model is chosen"),
        ({"models": ["hebbeker"]}, "no flux model “hebbeker”; use one of gaisser"),
        ({"zenith_deg": []}, "empty"),
        ({"zenith_deg": [90.0]}, "90°"),
        ({"thickness_m": 0.0}, "thickness of 0 m"),
        ({"thickness_m": -5.0}, "thickness of -5 m"),
        ({"thickness_m": float("nan")}, "thickness of nan m"),
        ({"thickness_m": MAXIMUM_THICKNESS_M + 1}, "up to 20000 m"),
        ({"altitude_m": 2e4}, "20000 m"),
    ],
)
def test_useless_input_is_refused_in_one_sentence(change, words):
    arguments = {
        "models": ["guan"], "zenith_deg": [0.0], "thickness_m": 100.0, "physics": Physics(),
    }  # fmt: skip
    with pytest.raises(MuyscError, match=words):
        compare(**{**arguments, **change})
