"""Matrices with given axes, and the text muograms of the first MUYSC."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.measurement.importing import import_muogram
from muysc_qgis.measurement.layout import TextLayout
from muysc_qgis.muogram import Muogram

MATRIX = "1 2 3\n4 5 6\n"
ENDS = {"azimuth_first": 30.0, "azimuth_last": 34.0}


@pytest.fixture
def load(tmp_path):
    def load_text(text, metadata=None, errors=None, axes=None, quantity="flux", **layout):
        path = tmp_path / "matrix.txt"
        path.write_text(text)
        error_path = None
        if errors is not None:
            error_path = tmp_path / "errors.txt"
            error_path.write_text(errors)
        return import_muogram(
            path, quantity, TextLayout(**layout), metadata or {}, error_path, axes
        )

    return load_text


@pytest.mark.parametrize(
    ("ends", "values"),
    [
        ({"vertical_first": 9.0, "vertical_last": 7.0}, [[1, 2, 3], [4, 5, 6]]),
        ({"vertical_first": 7.0, "vertical_last": 9.0}, [[4, 5, 6], [1, 2, 3]]),
    ],
)
def test_the_angles_of_the_ends_say_where_the_pixels_are(load, ends, values):
    muogram = load(MATRIX, vertical_angle="elevation", **ENDS, **ends).muogram
    np.testing.assert_array_equal(muogram.azimuth_deg, [30, 32, 34])
    np.testing.assert_array_equal(muogram.elevation_deg, [9, 7])
    np.testing.assert_array_equal(muogram.values, values)


def test_zenith_angles_radians_and_columns_from_right_to_left(load):
    muogram = load(
        MATRIX, vertical_angle="zenith", angle_unit="radians",
        azimuth_first=np.radians(34), azimuth_last=np.radians(30),
        vertical_first=np.radians(81), vertical_last=np.radians(83),
    ).muogram  # fmt: skip
    np.testing.assert_allclose(muogram.azimuth_deg, [30, 32, 34])
    np.testing.assert_allclose(muogram.elevation_deg, [9, 7])
    np.testing.assert_array_equal(muogram.values, [[3, 2, 1], [6, 5, 4]])


def test_a_reference_muogram_lends_its_directions(load):
    axes = Muogram("thickness", np.ones((2, 3)), np.array([1.0, 2, 3]), np.array([5.0, 4.0]))
    muogram = load(MATRIX, axes=axes).muogram
    np.testing.assert_array_equal(muogram.elevation_deg, [5, 4])
    np.testing.assert_array_equal(muogram.values, [[1, 2, 3], [4, 5, 6]])


def test_errors_come_from_a_second_matrix(load):
    imported = load(
        MATRIX, errors=".1 .2 .3\n.4 .5 .6\n", vertical_angle="elevation",
        vertical_first=7.0, vertical_last=9.0, **ENDS,
    )  # fmt: skip
    np.testing.assert_allclose(imported.error.values, [[0.4, 0.5, 0.6], [0.1, 0.2, 0.3]])


@pytest.mark.parametrize(
    ("text", "layout", "words"),
    [
        (MATRIX, {"layout": "matrix"}, ("3 × 2 values", "angles of the first and last")),
        (MATRIX, ENDS, ("3 × 2 values", "angles of the first and last")),
        (
            MATRIX,
            {**ENDS, "vertical_first": 9.0, "vertical_last": 7.0},
            ("elevation or zenith angles",),
        ),
        (
            MATRIX,
            {**ENDS, "vertical_first": 7.0, "vertical_last": 7.0, "vertical_angle": "zenith"},
            ("2 rows", "both at 7°"),
        ),
        (
            MATRIX,
            {**ENDS, "vertical_first": 95.0, "vertical_last": 7.0, "vertical_angle": "elevation"},
            ("elevation of 95°",),
        ),
        ("1 2 3\n4 5\n", {"layout": "matrix"}, ("Line 2", "2 values", "line 1 has 3")),
        ("1 2 3\n4 x 6\n", {"layout": "matrix"}, ("Line 2", "“x”")),
    ],
)
def test_what_is_no_matrix_is_refused(load, text, layout, words):
    with pytest.raises(MuyscError) as caught:
        load(text, **layout)
    for word in words:
        assert word in str(caught.value)


def test_sizes_that_do_not_match_are_both_told(load):
    axes = Muogram("thickness", np.ones((3, 3)), np.arange(3.0), -np.arange(3.0))
    with pytest.raises(MuyscError, match=r"3 × 2 values .* 3 × 3 pixels"):
        load(MATRIX, axes=axes, layout="matrix")
    with pytest.raises(MuyscError, match=r"2 × 1 errors for the 3 × 2 values"):
        load(MATRIX, errors="1 2\n", layout="matrix")


#: As the first MUYSC's `save_data` writes it: radians from the line of sight, the one called
#: cenith growing upwards and the azimuth counterclockwise, lengths in metres.
ORIGINAL_HEADER = (
    "# Op 14.410686 40.810561 604\n"
    "# Pp {target} 1100\n"
    "# A 40.775 40.85 14.4 14.5\n"
    "# cenith[rad] azimuth[rad] distance[km]\n"
)


@pytest.mark.parametrize("target", ["14.424745 40.823729", "[14.424745] [40.823729]"])
def test_a_file_of_the_first_muysc_brings_its_geometry(load, target):
    up, left = np.linspace(-0.1, 0.1, 3), np.linspace(-0.2, 0.2, 5)
    lines = [f"{u:.18e} {a:.18e} {1000 + 1000 * u + a:.18e}" for u in up for a in left]
    imported = load(ORIGINAL_HEADER.format(target=target) + "\n".join(lines), quantity="thickness")
    muogram = imported.muogram
    # Azimuth and distance by pyproj's geodesic; the elevation from 496 m over 1882.88 m.
    assert muogram.number("BORESIGHT_AZIMUTH") == pytest.approx(39.05, abs=0.02)
    assert muogram.number("TARGET_DISTANCE") == pytest.approx(1882.88, abs=0.2)
    assert muogram.number("BORESIGHT_ELEVATION") == pytest.approx(14.758, abs=0.002)
    assert muogram.number("DETECTOR_LON") == 14.410686
    assert muogram.number("DETECTOR_ELEVATION") == 604
    middle = muogram.number("BORESIGHT_ELEVATION")
    np.testing.assert_allclose(muogram.elevation_deg, middle + np.degrees(up[::-1]), atol=1e-9)
    np.testing.assert_allclose(
        muogram.azimuth_deg,
        muogram.number("BORESIGHT_AZIMUTH") + np.degrees(left),
        atol=1e-9,
    )
    # Highest row first, and the leftmost column is the largest counterclockwise angle.
    assert muogram.values[0, 0] == pytest.approx(1100.2)
    assert muogram.values[2, 4] == pytest.approx(899.8)
    assert "approximate" in imported.warnings[0]
