"""Tables in every dress: separators, headers, orders, units; and what is no grid."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.measurement.importing import import_muogram
from muysc_qgis.measurement.layout import TextLayout

AZIMUTH = np.array([350.0, 352.5, 355.0, 357.5])
ELEVATION = np.array([12.0, 10.0, 8.0])
VALUES = np.arange(12.0).reshape(3, 4) + 1.0


@pytest.fixture
def load(tmp_path):
    def load_text(text, quantity="flux", metadata=None, encoding="utf-8", **layout):
        path = tmp_path / "muones ñ.txt"
        path.write_text(text, encoding=encoding)
        return import_muogram(path, quantity, TextLayout(**layout), metadata or {})

    return load_text


def rows(order=None, elevation=lambda e: e, azimuth=lambda a: a, line="{a},{e},{v}"):
    made = [
        line.format(a=azimuth(a), e=elevation(e), v=VALUES[i, j], s=VALUES[i, j] / 10)
        for i, e in enumerate(ELEVATION)
        for j, a in enumerate(AZIMUTH)
    ]
    return [made[n] for n in (range(12) if order is None else order)]


def text(header, lines):
    return "\n".join([*([header] if header else []), *lines]) + "\n"


def assert_grid(imported, azimuth=AZIMUTH):
    muogram = imported.muogram
    np.testing.assert_allclose(muogram.azimuth_deg, azimuth, atol=1e-4)
    np.testing.assert_allclose(muogram.elevation_deg, ELEVATION, atol=1e-4)
    np.testing.assert_array_equal(muogram.values, VALUES)


def test_rows_in_any_order_make_the_same_muogram(load):
    order = np.random.default_rng(1).permutation(12)
    assert_grid(load(text("azimuth,elevation,flux", rows(order))))


@pytest.mark.parametrize(
    ("header", "lines"),
    [
        ("Azimuth [deg]\tElevation [deg]\tFlux", rows(line="{a}\t{e}\t{v}")),
        ("# az el intensity", rows(line="{a}   {e}  {v}")),
        ("AZIMUTH; ELEVATION; FLUX", rows(line="{a}; {e}; {v}")),
        ("% measured in May\n% phi beta flux", rows(line="{a} {e} {v}")),
        ('"azimut","elevación","flujo"', rows()),
        ("flux,elevation_deg,azimuth_deg", rows(line="{v},{e},{a}")),
    ],
)
def test_headers_and_separators(load, header, lines):
    assert_grid(load(text(header, lines)))


def test_zenith_angles_and_radians_are_heeded(load):
    lines = rows(elevation=lambda e: np.radians(90 - e), azimuth=np.radians)
    assert_grid(load(text("azimuth_rad,zenith_rad,flux", lines)))
    assert_grid(load(text("azimuth,theta,flux", lines), angle_unit="radians"))


def test_decimal_commas_and_other_encodings(load):
    lines = [line.replace(".", ",") for line in rows(line="{a};{e};{v}")]
    assert_grid(load(text("azimut (°);elevación (°);flujo", lines), encoding="latin-1"))
    assert_grid(load(text("azimut;elevación;flujo", lines), encoding="utf-16"))
    lines = [line.replace(".", ",") for line in rows(line="{a} {e} {v}")]
    assert_grid(load(text("azimuth elevation flux", lines)))


def test_a_table_without_names_goes_by_place(load):
    lines = rows(line="{a} {e} {v} {s}")
    imported = load(text("", lines), vertical_angle="elevation")
    assert_grid(imported)
    assert imported.error.quantity == "flux_error"
    np.testing.assert_allclose(imported.error.values, VALUES / 10)


@pytest.mark.parametrize("name", ["error", "flux_error", "sigma", "dflux", "err", "flux std"])
def test_errors_are_found_by_their_names(load, name):
    imported = load(text(f"azimuth,elevation,flux,{name}", rows(line="{a},{e},{v},{s}")))
    assert_grid(imported)
    np.testing.assert_allclose(imported.error.values, VALUES / 10)


def test_columns_are_taken_by_name_or_number(load):
    lines = rows(line="0,{a},7,{e},{v}")
    header = "run,dir1,site,dir2,result"
    chosen = {"azimuth_column": "dir1", "vertical_column": "4", "value_column": "Result"}
    assert_grid(load(text(header, lines), vertical_angle="elevation", **chosen))
    chosen = {"azimuth_column": "2", "vertical_column": "4", "value_column": "5"}
    assert_grid(load(text("", lines), vertical_angle="elevation", layout="table", **chosen))


def test_azimuths_go_on_across_north(load):
    azimuth = [350.0, 355.0, 0.0, 5.0]
    lines = rows(azimuth=lambda a: azimuth[list(AZIMUTH).index(a)])
    assert_grid(load(text("azimuth,elevation,flux", lines)), [350.0, 355.0, 360.0, 365.0])
    assert_grid(
        load(text("azimuth,elevation,flux", rows(azimuth=lambda a: a - 355))), AZIMUTH - 355
    )


def test_angles_from_the_boresight_and_the_other_way_round(load):
    lines = rows(elevation=lambda e: e - 10, azimuth=lambda a: 355 - a)
    imported = load(
        text("azimuth,elevation,flux", lines),
        metadata={"BORESIGHT_AZIMUTH": 355.0, "BORESIGHT_ELEVATION": 10.0},
        relative=True, azimuth_sense="counterclockwise",
    )  # fmt: skip
    assert_grid(imported)
    # A zenith angle from the boresight grows downwards.
    lines = rows(elevation=lambda e: 10 - e, azimuth=lambda a: 355 - a)
    imported = load(
        text("azimuth,zenith,flux", lines),
        metadata={"BORESIGHT_AZIMUTH": 355.0, "BORESIGHT_ELEVATION": 10.0},
        relative=True, azimuth_sense="counterclockwise",
    )  # fmt: skip
    assert_grid(imported)


def test_missing_values_are_unknown(load):
    lines = rows()
    lines[5] = lines[5].rsplit(",", 1)[0] + ",nan"
    lines[6] = lines[6].rsplit(",", 1)[0] + ","
    lines[7] = lines[7].rsplit(",", 1)[0] + ",-999"
    values = load(text("azimuth,elevation,flux", lines), no_data=-999.0).muogram.values
    assert np.isnan(values).sum() == 3
    assert np.isnan(values[1, 1:]).all()


def test_rounded_angles_are_taken_to_the_grid(load):
    lines = [
        f"{a},{e:.2f},{v}"
        for e, row in zip(np.linspace(8, 12, 13), np.ones((13, 4)))
        for a, v in zip(AZIMUTH, row)
    ]
    muogram = load(text("azimuth,elevation,flux", lines)).muogram
    np.testing.assert_allclose(muogram.elevation_deg, np.linspace(12, 8, 13), atol=1e-9)


def test_the_factor_reaches_values_and_errors(load):
    header = "azimuth,elevation,flux,error"
    imported = load(text(header, rows(line="{a},{e},{v},{s}")), factor=86400.0)
    np.testing.assert_allclose(imported.muogram.values, VALUES * 86400)
    np.testing.assert_allclose(imported.error.values, VALUES * 8640)


def test_what_was_found_is_said(load):
    imported = load(text("az,zenith,flux", rows(elevation=lambda e: 90 - e)))
    assert "zenith angle from zenith (degrees), value from flux" in imported.notes[0]
    assert "4 × 3 pixels" in imported.notes[-1]
    small = [f"{a},{e},1" for a in (0.1, 0.2) for e in (1.1, 1.2)]
    assert "radians" in load(text("azimuth,elevation,flux", small)).warnings[0]


HEADER = "azimuth,elevation,flux"


@pytest.mark.parametrize(
    ("content", "layout", "words"),
    [
        # The first offending line.
        (text(HEADER, rows()[:7] + rows()[8:]), {}, ("lacks 1 of 12", "357.5°", "10°", "line 8")),
        (text(HEADER, [*rows(), rows()[3]]), {}, ("Line 14", "second time", "line 5")),
        (text(HEADER, [*rows()[:-1], "357.1,8,1"]), {}, ("Line 13", "357.1°", "off the regular")),
        (text(HEADER, [*rows()[:4], "350,ten,1", *rows()[5:]]), {}, ("Line 6", "“ten”")),
        (text(HEADER, [*rows()[:4], "350,10", *rows()[5:]]), {}, ("Line 6", "2 values", "3")),
        (text(HEADER, ["10,120,1"]), {}, ("Line 2", "elevation of 120°", "no direction")),
        (text(HEADER, ["10,12,-4"]), {}, ("-4", "0 or more")),
        (text(HEADER, ["10,12,nan"]), {}, ("no value at all",)),
        # Columns that cannot be told apart.
        (text("a,b,c", rows()), {}, ("No column", "azimuth", "a, b, c")),
        (text("azimuth,angle,flux", rows()), {}, ("elevation or zenith",)),
        (text("azimuth,elevation,x,y", rows(line="{a},{e},{v},1")), {}, ("value", "x, y")),
        (text("azimuth,elevation,zenith,flux", rows(line="{a},{e},{e},1")), {}, ("2 columns",)),
        (text("", rows()), {}, ("does not name its columns", "vertical angle")),
        (text(HEADER, rows()), {"value_column": "9"}, ("column “9”", "1 to 3")),
        (text(HEADER, rows()), {"value_column": "muons"}, ("“muons”", "azimuth, elevation")),
        (text("azimuth_deg,zenith_rad,flux", rows()), {}, ("degrees and in radians",)),
        (text(HEADER, rows()), {"relative": True}, ("BORESIGHT_AZIMUTH",)),
        ("# nothing here\n\n", {}, ("no line of numbers",)),
        ("1 2\n3 4\n", {"layout": "table"}, ("2 columns", "matrix")),
    ],
)
def test_what_is_no_table_of_a_grid_is_refused(load, content, layout, words):
    with pytest.raises(MuyscError) as caught:
        load(content, **layout)
    for word in words:
        assert word in str(caught.value)
    assert str(caught.value).endswith(".")


def test_counts_are_whole(load):
    header = "azimuth,elevation,counts"
    load(text(header, rows()), "counts")
    with pytest.raises(MuyscError, match=r"fractional in 11 pixels, such as 0\.1"):
        load(text(header, rows(line="{a},{e},{s}")), "counts")


def test_files_that_are_no_text(tmp_path):
    picture = tmp_path / "picture.png"
    picture.write_bytes(b"\x89PNG\r\n\x1a\n\x00\x00")
    with pytest.raises(MuyscError, match="no text file"):
        import_muogram(picture, "flux", TextLayout(), {})
    with pytest.raises(MuyscError, match="cannot be read"):
        import_muogram(tmp_path / "none.txt", "flux", TextLayout(), {})
