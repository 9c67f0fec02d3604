"""Acceptances against published numbers, closed forms and brute force."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.telescope.acceptance import pair_acceptance, plane_etendue, trajectories
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.telescope.presets import PRESETS

#: The comparison of instruments in the MUYSC paper: acceptance on the axis by its formula
#: and by the full integral (cm² sr), 4 d²/D² (sr), aperture cut to whole degrees, and the
#: étendue by the full integral (cm² sr).
TABLE = {
    "gibert2010": (64.00, 63.89, 1.00e-2, 57, 27430),
    "carbone2014": (5.536, 5.533, 3.46e-3, 25, 1241),
    "lopresti2020": (1.0417, 1.0416, 4.25e-4, 45, 6319),
    "lesparre2012": (12.098, 12.083, 7.56e-3, 34, 2380),
    "lesparre2010": (25.00, 24.94, 1.5625e-2, 45, 4018),
    "uchida2009": (34.574, 34.46, 1.96e-2, 40, 3484),
    "mute": (3.686, 3.686, 1.024e-3, 25, 2890),
}


@pytest.mark.parametrize("name", TABLE)
def test_built_telescopes_have_their_published_numbers(name):
    paper_acceptance, exact_acceptance, solid_angle, aperture, etendue = TABLE[name]
    geometry = PRESETS[name].geometry
    paper, exact = trajectories(geometry, "paper"), trajectories(geometry)
    middle = geometry.bars_y - 1, geometry.bars_x - 1
    assert paper.acceptance_cm2_sr[middle] == pytest.approx(paper_acceptance, rel=2e-4)
    assert exact.acceptance_cm2_sr[middle] == pytest.approx(exact_acceptance, rel=2e-4)
    assert paper.solid_angle_sr[middle] == pytest.approx(solid_angle, rel=1e-3)
    assert int(geometry.half_aperture_deg[0] + 1e-9) == aperture
    assert exact.etendue_cm2_sr == pytest.approx(etendue, abs=0.6)
    assert exact.acceptance_cm2_sr.max() == exact.acceptance_cm2_sr[middle]


@pytest.mark.parametrize("name", PRESETS)
def test_all_trajectories_add_up_to_sullivans_closed_form(name):
    geometry = PRESETS[name].geometry
    total = trajectories(geometry).etendue_cm2_sr
    assert total == pytest.approx(plane_etendue(geometry), rel=1e-10)


def test_sullivans_formula_as_he_wrote_it():
    # Two equal rectangles 2 X by 2 Y at a distance Z, eq. 11 of Sullivan (1971) for X1 = X2.
    x, y, z = 60.0, 45.0, 100.0
    alpha, gamma = 2 * x, 2 * y
    logarithm = np.log(
        (z**2 + alpha**2) * (z**2 + gamma**2) / ((z**2 + alpha**2 + gamma**2) * z**2)
    )

    def side(a, b):
        root = np.sqrt(z**2 + b**2)
        return 2 * a * root * np.arctan(a / root) - 2 * a * z * np.arctan(a / z)

    expected = z**2 * logarithm + side(alpha, gamma) + side(gamma, alpha)
    assert plane_etendue(TelescopeGeometry(12, 9, 10.0, 100.0)) == pytest.approx(expected)


@pytest.mark.parametrize(("m", "n"), [(0, 0), (1, 0), (3, 2), (5, 5)])
@pytest.mark.parametrize("size_cm", [0.5, 9.9, 10.1, 80.0])
def test_a_pair_of_pixels_is_the_integral_over_both(m, n, size_cm):
    # ∫∫ D²/r⁴ dA dA' by Gauss–Legendre quadrature in all four coordinates.
    distance = 100.0
    node, weight = np.polynomial.legendre.leggauss(24)
    share, weight = (node + 1) / 2, weight / 2
    apart = share[:, None] - share[None, :]
    x, y = size_cm * (m + apart.ravel()), size_cm * (n + apart.ravel())
    product = np.outer(weight, weight).ravel()
    integrand = distance**2 / (distance**2 + x[:, None] ** 2 + y[None, :] ** 2) ** 2
    expected = size_cm**4 * product @ integrand @ product
    geometry = TelescopeGeometry(6, 6, size_cm, distance)
    assert float(pair_acceptance(geometry, m, n)) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("formula", ["exact", "paper"])
def test_acceptance_is_positive_and_symmetric(formula):
    result = trajectories(TelescopeGeometry(7, 4, 5.0, 60.0), formula)
    assert result.acceptance_cm2_sr.shape == (7, 13)
    for values in (
        result.acceptance_cm2_sr, result.solid_angle_sr, result.detection_area_cm2,
        result.path_length_cm,
    ):  # fmt: skip
        assert np.all(values > 0)
        np.testing.assert_array_equal(values, values[::-1])
        np.testing.assert_array_equal(values, values[:, ::-1])


def test_formulas_by_hand():
    result = trajectories(TelescopeGeometry(3, 2, 10.0, 100.0), "paper")
    # m = 2 to the right, n = 1 up: one pair, r² = 100² + 10² (4 + 1).
    assert result.detection_area_cm2[0, 4] == 100
    assert result.path_length_cm[0, 4] == pytest.approx(np.sqrt(10500))
    assert result.acceptance_cm2_sr[0, 4] == pytest.approx(1e4 / 10500)
    assert result.solid_angle_sr[0, 4] == pytest.approx(400 / 10500)
    # On the axis: all six pairs.
    assert result.detection_area_cm2[1, 2] == 600
    assert result.acceptance_cm2_sr[1, 2] == pytest.approx(6.0)


def test_leaving_out_the_obliquity_collects_too_much():
    # The paper's total is 7 to 47 % too high for the telescopes it compares.
    excess = {
        name: trajectories(PRESETS[name].geometry, "paper").etendue_cm2_sr
        / trajectories(PRESETS[name].geometry).etendue_cm2_sr
        - 1
        for name in TABLE
    }
    assert min(excess.values()) == pytest.approx(0.07, abs=0.005)
    assert max(excess.values()) == pytest.approx(0.47, abs=0.005)


def test_far_planes_approach_the_leading_order():
    # d⁴D²/r⁴ a pair; the difference falls with (d/D)².
    errors = []
    for separation in (100.0, 200.0, 400.0):
        geometry = TelescopeGeometry(3, 3, 10.0, separation)
        squared = separation**2 + 100.0 * (2**2 + 1**2)
        leading = 1e4 * separation**2 / squared**2
        errors.append(abs(float(pair_acceptance(geometry, 2, 1)) / leading - 1))
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.15)
    assert errors[1] / errors[2] == pytest.approx(4, rel=0.05)


def test_solid_angle_is_that_of_the_directions_shared():
    geometry = TelescopeGeometry(3, 3, 20.0, 100.0)
    node, weight = np.polynomial.legendre.leggauss(30)
    x, y = 0.2 * (2 + node), 0.2 * (1 + node)
    # dΩ = dx dy / (1 + x² + y²)^(3/2) in the plane of tangents.
    density = (1 + x[:, None] ** 2 + y[None, :] ** 2) ** -1.5
    expected = 0.2**2 * weight @ density @ weight
    exact = trajectories(geometry)
    assert exact.solid_angle_sr[1, 4] == pytest.approx(expected, rel=1e-12)
    assert exact.angular_resolution_mrad[1, 4] == pytest.approx(1e3 * np.sqrt(expected))


def test_mute_resolves_what_its_publication_says():
    # 32 mrad at a separation of 250 cm (Peña-Rodríguez et al. 2020).
    resolution = trajectories(PRESETS["mute"].geometry).angular_resolution_mrad
    assert resolution.max() == pytest.approx(32, rel=1e-3)


def test_one_bar_is_one_trajectory():
    geometry = TelescopeGeometry(1, 1, 30.0, 50.0)
    result = trajectories(geometry)
    assert result.acceptance_cm2_sr.shape == (1, 1)
    assert result.etendue_cm2_sr == pytest.approx(plane_etendue(geometry))


def test_planes_in_between_change_nothing():
    two, four = (TelescopeGeometry(5, 5, 4.0, 100.0, planes) for planes in (2, 4))
    np.testing.assert_array_equal(
        trajectories(two).acceptance_cm2_sr, trajectories(four).acceptance_cm2_sr
    )


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"bars_x": 0}, "0 bars across make no telescope"),
        ({"bars_y": -2}, "-2 bars up make no telescope"),
        ({"bars_x": 5000}, "from 1 to 1000"),
        ({"bars_x": 2.5}, "2.5 bars across"),
        ({"pixel_size_cm": 0.0}, "pixel size of 0 cm"),
        ({"pixel_size_cm": np.nan}, "pixel size of nan cm"),
        ({"separation_cm": 0.0}, "separation of the planes of 0 cm"),
        ({"separation_cm": -1.0}, "separation of the planes of -1 cm"),
        ({"planes": 1}, "1 planes give no direction"),
    ],
)
def test_impossible_telescopes_are_refused(change, words):
    numbers = {"bars_x": 3, "bars_y": 3, "pixel_size_cm": 5.0, "separation_cm": 100.0}
    with pytest.raises(MuyscError, match=words):
        TelescopeGeometry(**{**numbers, **change})


def test_unknown_formula_is_named():
    with pytest.raises(MuyscError, match="“rough”; use exact or paper"):
        trajectories(TelescopeGeometry(2, 2, 5.0, 50.0), "rough")
