"""Flux and transmission behind rock against references, limits and identities."""

import numpy as np
import pytest
from scipy.integrate import quad

from muysc_qgis.errors import MuyscError
from muysc_qgis.radiography.altitude import altitude_factor
from muysc_qgis.radiography.constants import SECONDS_PER_DAY
from muysc_qgis.radiography.energy_loss import ENERGY_LOSSES, minimum_energy
from muysc_qgis.radiography.integral import integral_spectrum
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.spectra import MODELS, differential_flux, momentum_from_kinetic
from muysc_qgis.radiography.transmission import attenuate

#: g/cm² of a length in metres of standard rock.
ROCK = 265.0

#: The choices of the published work, for its numbers.
PAPER = Physics(flux_model="reyna-bugaev", straggling=False)


def by_quadrature(start_gev, cosine, model, altitude_m=None):
    """I(>E) in cm⁻² s⁻¹ sr⁻¹ by adaptive quadrature, decade by decade."""

    def density(u):
        energy = np.exp(u)
        factor = 1.0
        if altitude_m is not None:
            factor = altitude_factor(momentum_from_kinetic(energy), altitude_m)
        if MODELS[model].tabulated:
            return energy * float(
                differential_flux(energy, cosine, model, altitude_m=altitude_m or 0.0)
            )
        return energy * float(differential_flux(energy, cosine, model)) * factor

    # Bugaev's spectrum has corners, which quadrature must not straddle.
    corners = np.log([929.894, 1589.894, 4.2e5])
    first = np.log(start_gev)
    ends = np.unique([first, *corners[corners > first], *(first + np.arange(1, 25))])
    return sum(quad(density, a, b, epsrel=1e-8, epsabs=0)[0] for a, b in zip(ends, ends[1:]))


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("zenith_deg", [0.0, 60.0, 80.0, 89.0])
@pytest.mark.parametrize("altitude_m", [None, 2500.0])
def test_integral_spectrum_against_quadrature(model, zenith_deg, altitude_m):
    cosine = np.cos(np.radians(zenith_deg))
    energy = np.array([0.9, 1.37, 4.4, 17.0, 111.0, 801.0, 1230.0, 1.5e4])
    table = integral_spectrum(np.array([cosine]), model, "gaisser", 0.9, 1.5e4, altitude_m)
    intensity, index = table(np.zeros(8, dtype=int), energy)
    expected = [by_quadrature(e, cosine, model, altitude_m) for e in energy]
    np.testing.assert_allclose(intensity, expected, rtol=1e-4)
    # dlnI/dlnE = −E Φ/I; linear interpolation is good enough for the straggling factor.
    factor = 1.0 if altitude_m is None else altitude_factor(momentum_from_kinetic(energy), 2500.0)
    if MODELS[model].tabulated:
        factor = differential_flux(energy, cosine, model, altitude_m=altitude_m or 0.0)
        factor /= differential_flux(energy, cosine, model)
    slope = energy * differential_flux(energy, cosine, model) * factor / expected
    np.testing.assert_allclose(index, slope, atol=0.02)


def test_power_law_tail_above_the_highest_energy():
    # 1e9 GeV asked for: the table reaches further and keeps the power of the spectrum.
    energy = np.array([1e6, 1e9])
    table = integral_spectrum(np.array([0.3]), "guan", "gaisser", 1.0, 1e9)
    intensity, _ = table(np.zeros(2, dtype=int), energy)
    # Guan's spectrum is E^-3.7 by then, its integral E^-2.7.
    assert intensity[1] / intensity[0] == pytest.approx(1e3**-2.7, rel=0.01)


def test_transmission_of_the_published_choices_at_80_degrees():
    lengths = np.array([50.0, 100.0, 500.0, 1000.0])
    transmission = attenuate(ROCK * lengths, 10.0, PAPER).transmission
    np.testing.assert_allclose(transmission, [0.241, 9.1e-2, 3.23e-3, 3.74e-4], rtol=3e-3)


def test_slopes_of_the_flux_with_opacity_at_75_degrees():
    opacity = ROCK * np.array([100.0, 500.0, 1000.0])
    step = 1.0005
    higher = attenuate(opacity * step, 15.0, PAPER).flux
    lower = attenuate(opacity / step, 15.0, PAPER).flux
    slope = np.log(higher / lower) / np.log(step**2)
    np.testing.assert_allclose(slope, [-1.76, -2.75, -3.78], rtol=7e-3)


@pytest.mark.parametrize("model", ["gaisser-tang", "guan"])
@pytest.mark.parametrize(
    ("opacity_km_we", "zenith_deg", "intensity"),
    [(0.5, 0.0, 6.949e-6), (2.0, 75.5, 3.321e-7), (5.0, 84.3, 9.516e-9)],
)
def test_intensity_against_full_transport(model, opacity_km_we, zenith_deg, intensity):
    # Published transport of muons through rock, slant depths; target of ±15 %.
    flux = attenuate(opacity_km_we * 1e5, 90.0 - zenith_deg, Physics(flux_model=model)).flux
    assert flux / SECONDS_PER_DAY == pytest.approx(intensity, rel=0.15)


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("energy_loss", ENERGY_LOSSES)
@pytest.mark.parametrize("straggling", [True, False])
def test_more_rock_lets_fewer_muons_through(model, energy_loss, straggling):
    physics = Physics(flux_model=model, energy_loss=energy_loss, straggling=straggling)
    opacity = np.concatenate(([0.0], np.geomspace(1.0, 1.6e5, 400)))
    for elevation in (90.0, 40.0, 3.0):
        result = attenuate(opacity, elevation, physics)
        assert np.all(result.transmission <= 1)
        assert np.all(np.diff(result.flux) <= 0)
        thick = opacity[:-1] > 1e3
        assert np.all(np.diff(result.flux)[thick] < 0)
        assert np.all(np.diff(result.minimum_energy_gev) >= 0)


def test_sky():
    physics = Physics(flux_model="gaisser-tang", detection_threshold_gev=0.0)
    result = attenuate(np.zeros(3), np.array([5.0, 45.0, 90.0]), physics)
    np.testing.assert_array_equal(result.flux, result.open_sky)
    np.testing.assert_array_equal(result.transmission, 1.0)
    np.testing.assert_array_equal(result.minimum_energy_gev, 0.0)
    # Open sky starts at 1 GeV/c.
    expected = by_quadrature(0.899908, 1.0, "gaisser-tang") * SECONDS_PER_DAY
    assert result.open_sky[2] == pytest.approx(expected, rel=1e-4)


def test_open_sky_starts_at_the_threshold_if_there_is_one():
    assert Physics(flux_model="guan").open_sky_start_gev == pytest.approx(0.899908, rel=1e-5)
    for threshold in (0.05, 20.0):
        physics = Physics(flux_model="guan", detection_threshold_gev=threshold)
        result = attenuate(np.zeros(1), 30.0, physics)
        assert result.minimum_energy_gev[0] == threshold
        expected = by_quadrature(threshold, 0.5, "guan") * SECONDS_PER_DAY
        assert result.open_sky[0] == pytest.approx(expected, rel=1e-4)


def test_flux_is_the_integral_from_the_minimum_energy():
    physics = Physics(flux_model="guan", straggling=False)
    opacity = ROCK * np.array([100.0, 700.0])
    result = attenuate(opacity, 20.0, physics)
    cosine = np.sin(np.radians(20.0))
    expected = [by_quadrature(float(e), cosine, "guan") for e in minimum_energy(opacity, physics)]
    np.testing.assert_allclose(result.flux / SECONDS_PER_DAY, expected, rtol=1e-4)


def test_altitude_raises_flux_by_less_the_thicker_the_rock():
    opacity = ROCK * np.array([0.0, 10.0, 100.0, 1000.0])
    guan = Physics(flux_model="guan")
    sea = attenuate(opacity, 20.0, guan, altitude_m=0.0).flux
    high = attenuate(opacity, 20.0, guan, altitude_m=1500.0).flux
    gain = high / sea
    assert np.all(np.diff(gain) < 0)
    assert 1.0 < gain[-1] < 1.01
    # Between the factors at 1 GeV/c and at infinity.
    assert gain[0] < altitude_factor(np.array(1.0), 1500.0)
    off = Physics(flux_model="guan", altitude_correction=False)
    off = attenuate(opacity, 20.0, off, altitude_m=1500.0).flux
    np.testing.assert_array_equal(off, sea)


def test_altitude_factors():
    factor = altitude_factor(np.array([1.0, 10.0, 100.0]), 2500.0)
    np.testing.assert_allclose(factor, [1.557, 1.223, 1.032], rtol=5e-4)
    assert altitude_factor(np.array(5.0), 0.0) == 1.0


def test_unknown_opacity_leaves_only_the_open_sky():
    result = attenuate(np.array([np.nan, 1e4]), 20.0, Physics())
    assert np.isnan(result.minimum_energy_gev[0])
    assert np.isnan(result.flux[0])
    assert np.isnan(result.transmission[0])
    assert result.open_sky[0] == result.open_sky[1]
    assert result.unanswered == {"opacity": 1, "horizon": 0, "energy loss": 0}
    assert any(text.startswith("1 ray: the opacity is unknown") for text in result.warnings)


def test_below_the_horizon_only_the_minimum_energy_is_known():
    result = attenuate(np.array([1e4, 1e4, 0.0, 1e4]), np.array([0.0, -5.0, -90.0, 5.0]), Physics())
    for values in (result.flux, result.open_sky, result.transmission):
        np.testing.assert_array_equal(np.isnan(values), [True, True, True, False])
    np.testing.assert_allclose(result.minimum_energy_gev[[0, 1, 3]], result.minimum_energy_gev[3])
    assert result.minimum_energy_gev[2] == Physics().threshold_gev
    assert result.unanswered["horizon"] == 3
    assert any("3 rays: at or below the horizon" in text for text in result.warnings)


def test_rays_without_a_minimum_energy_are_no_data_and_counted():
    opacity = ROCK * np.array([[100.0, 614.0], [700.0, 600.0]])
    result = attenuate(opacity, np.array([[20.0], [10.0]]), Physics(energy_loss="paper"))
    np.testing.assert_array_equal(np.isnan(result.flux), [[False, True], [True, False]])
    assert np.all(np.isfinite(result.open_sky))
    assert result.unanswered["energy loss"] == 2
    assert any("2 rays: the energy loss “paper” has no answer" in text for text in result.warnings)


def test_rows_of_a_muogram_and_single_rays_agree():
    random = np.random.default_rng(3)
    elevation = np.linspace(40, 1, 23)
    opacity = random.uniform(0, 3e5, (23, 31))
    grid = attenuate(opacity, elevation[:, None], Physics(), 800.0)
    rays = attenuate(opacity.ravel(), np.repeat(elevation, 31), Physics(), 800.0)
    for name in ("minimum_energy_gev", "flux", "open_sky", "transmission"):
        assert getattr(grid, name).shape == (23, 31)
        np.testing.assert_allclose(getattr(grid, name).ravel(), getattr(rays, name), rtol=1e-9)
    assert grid.warnings == rays.warnings


def test_blocks_do_not_show():
    # More rays than one block of each kind holds.
    opacity = np.tile(np.linspace(0, 2e5, 500), 300)
    elevation = np.tile(np.linspace(1, 80, 1000), 150)
    whole = attenuate(opacity, elevation, Physics())
    picked = slice(70_000, 70_050)
    part = attenuate(opacity[picked], elevation[picked], Physics())
    np.testing.assert_allclose(whole.flux[picked], part.flux, rtol=1e-4)
    assert attenuate(np.zeros((0, 4)), np.zeros((0, 1)), Physics()).flux.shape == (0, 4)
    assert attenuate(1e4, 30.0, Physics()).flux.shape == ()


def test_density_matters_only_through_opacity():
    light = attenuate(1e4, 30.0, Physics(density_g_cm3=1.5))
    assert light.flux == attenuate(1e4, 30.0, Physics()).flux


@pytest.mark.parametrize(
    ("opacity", "elevation", "altitude", "words"),
    [
        ([-1.0], 10.0, 0.0, "-1 g/cm²"),
        ([np.inf], 10.0, 0.0, "infinite"),
        ([1.0], 91.0, 0.0, "91°"),
        ([1.0], np.nan, 0.0, "nan°"),
        ([1.0, 2.0], [1.0, 2.0, 3.0], 0.0, "shape"),
        ([1.0], 10.0, np.nan, "altitude"),
        ([1.0], 10.0, 2e4, "20000 m"),
    ],
)
def test_useless_input_is_refused(opacity, elevation, altitude, words):
    with pytest.raises(MuyscError, match=words):
        attenuate(np.array(opacity), np.array(elevation), Physics(), altitude)


#: A detector that counts no muons below 20 GeV.
THRESHOLD = {"detection_threshold_gev": 20.0}


def warned(opacity, elevation, physics, altitude=0.0):
    return " ".join(attenuate(np.array(opacity), np.array(elevation), physics, altitude).warnings)


def test_good_settings_warn_of_nothing():
    assert warned([0.0, 1e4, 2e5], 20.0, Physics(flux_model="guan")) == ""
    assert warned([3e4, 2e5], 40.0, Physics(flux_model="gaisser-tang", **THRESHOLD)) == ""


def test_rays_outside_a_spectrum_are_counted():
    gaisser = Physics(flux_model="gaisser")
    text = warned([0.0, 1e4, 2e4, 3e5], 30.0, gaisser)
    assert "2 rays: the minimum energy is below the 150 GeV (up to 30°; 350 GeV at 70°)" in text
    assert "stays within 15 % of measurements" in text
    assert "4 rays: the open sky starts far below" in text
    assert "1 ray: farther from the zenith than the 70°" in warned([3e5], 15.0, gaisser)
    bugaev = Physics(flux_model="bugaev")
    assert "farther from the zenith than the 10°" in warned([1e5], 45.0, bugaev)
    assert warned([1e5], 85.0, Physics(flux_model="bugaev", **THRESHOLD)) == ""
    reyna = Physics(flux_model="reyna-bugaev")
    text = warned([1e4, 5e4], 80.0, reyna)
    assert "1 ray: the minimum energy is above the 100 GeV (up to 30°; 25 GeV at 85°)" in text
    klimushin = Physics(flux_model="gaisser-tang", gaisser_parameters="klimushin")
    assert "1 ray: the minimum energy is below the 300 GeV" in warned([1e4, 3e5], 45.0, klimushin)
    guan = Physics(flux_model="guan")
    assert "farther from the zenith than the 85°" in warned([1e5], 4.0, guan)
    assert "below the 1 GeV (up to 80°; 70 GeV at 85°)" in warned([1e4], 7.0, guan)


def test_rough_open_sky_near_the_horizon_is_named():
    guan = Physics(flux_model="guan")
    assert "open sky and transmission are rough" in warned([1e5], 6.0, guan)
    assert warned([1e5], 6.0, Physics(flux_model="guan", **THRESHOLD)) == ""


def test_altitude_outside_its_range_is_named():
    guan = Physics(flux_model="guan")
    assert "below the 10 GeV/c" in warned([1e3], 30.0, guan, 500.0)
    assert "up to 1000 m" not in warned([1e3], 30.0, guan, 500.0)
    assert "up to 1000 m and the detector is at 2500 m" in warned([3e5], 30.0, guan, 2500.0)
    text = warned([3e5, 3e5], [30.0, 29.0], guan, 2500.0)
    assert "1 ray: farther from the zenith than the 60° up to which the altitude" in text
    assert "altitude" not in warned([3e5], 20.0, guan)
    off = Physics(flux_model="guan", altitude_correction=False)
    assert warned([1e3], 30.0, off, 2500.0) == ""


def test_energy_loss_outside_its_range_is_named():
    lesparre = Physics(flux_model="guan", energy_loss="lesparre")
    assert "1 ray: the minimum energy is above the 1000 GeV" in warned([1e4, 3e5], 30.0, lesparre)
    granite = Physics(flux_model="guan", energy_loss="lesparre", material="granite")
    assert "1 ray: the rock is granite" in warned([0.0, 1e4], 30.0, granite)


def test_straggling_outside_its_range_is_named():
    guan = Physics(flux_model="guan")
    assert "1 ray: the opacity is above the 1.5e+06 g/cm²" in warned([1e6, 1.6e6], 80.0, guan)
    off = Physics(flux_model="guan", straggling=False)
    assert "straggling" not in warned([1.6e6], 80.0, off)


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("threshold", [0.0, 1e-3, 9e4])
def test_extremes_give_numbers_or_nan_and_fall_with_opacity(model, threshold):
    elevation = np.array([90.0, 1.0, 1e-3, 1e-7, 1e-12, 0.0, -90.0])[:, None]
    opacity = np.array([0.0, 1e-12, 1.0, 478.0, 1e4, 2.9e6, 3.1e6, 1e9, np.nan])
    physics = Physics(flux_model=model, detection_threshold_gev=threshold)
    result = attenuate(opacity, elevation, physics, 3000.0)
    known = np.isfinite(result.minimum_energy_gev) & (elevation > 0)
    np.testing.assert_array_equal(np.isfinite(result.flux), known)
    np.testing.assert_array_equal(np.isfinite(result.transmission), known)
    assert np.all(result.flux[known] >= 0)
    assert not np.any(np.diff(result.flux, axis=1) > 0)
    assert sum(result.unanswered.values()) == np.count_nonzero(~known)
