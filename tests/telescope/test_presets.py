"""Choosing a telescope by name or by numbers."""

import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.telescope.presets import PRESETS, telescope_of


def test_every_preset_says_where_it_is_from():
    for name, preset in PRESETS.items():
        assert preset.name == name
        year = preset.title[preset.title.index("(") + 1 : -1].removesuffix(")")
        assert f"({year})" in preset.citation
        assert preset.geometry.planes >= 2


def test_a_preset_wins_and_says_what_it_did_not_use():
    geometry, notes = telescope_of("mute", 20, 30, None, 100.0)
    assert geometry == TelescopeGeometry(30, 30, 4.0, 250.0)
    assert len(notes) == 2
    assert "bars across 20 is not used" in notes[0]
    assert "separation (cm) 100 is not used, because the preset mute has 250" in notes[1]


def test_custom_numbers_make_a_telescope():
    assert telescope_of("custom", 10, None, 5.0, 80.0) == (TelescopeGeometry(10, 10, 5.0, 80.0), ())
    assert telescope_of("custom", 10, 4, 5.0, 80.0, 3)[0] == TelescopeGeometry(10, 4, 5.0, 80.0, 3)


@pytest.mark.parametrize(
    ("numbers", "words"),
    [
        ((None, 5, 5.0, 80.0), "bars across are missing"),
        ((5, None, None, 80.0), r"pixel size \(cm\) is missing"),
        ((5, None, 5.0, None), r"separation \(cm\) is missing"),
    ],
)
def test_a_custom_telescope_needs_its_numbers(numbers, words):
    with pytest.raises(MuyscError, match=words):
        telescope_of("custom", *numbers)


def test_unknown_presets_are_named():
    with pytest.raises(MuyscError, match="“hubble”; use one of custom, mute"):
        telescope_of("hubble")
