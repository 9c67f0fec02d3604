"""Names of files and gathered warnings of many sites."""

import pytest

from muysc_qgis.workflows.sites import file_stems, gathered


@pytest.mark.parametrize(
    ("names", "stems"),
    [
        ([None, None], ["site_01", "site_02"]),
        ([None] * 100, [f"site_{number:03d}" for number in range(1, 101)]),
        (["Cerro Machín", "P 1/2"], ["Cerro_Machin", "P_1_2"]),
        (["../../etc", ".hidden"], ["etc", "hidden"]),
        (["桜島", "桜島"], ["site_01", "site_02"]),
        (["A", "a", "A"], ["A", "a_2", "A_3"]),
        (["site_02", None], ["site_02", "site_02_2"]),
        (["a", "a", "a_2"], ["a", "a_2", "a_2_2"]),
    ],
)
def test_file_stems_are_safe_and_all_different(names, stems):
    assert file_stems(names) == stems


def test_warnings_that_differ_in_numbers_alone_are_one():
    said = [
        ("a", "12 of 100 rays end."),
        ("b", "3 of 100 rays end."),
        ("b", "The model ends at 70°."),
        *((f"c{number}", f"{number} of 100 rays end.") for number in range(6)),
    ]
    assert gathered(said) == [
        "Site a (and likewise b, c0, c1, c2 and 3 more): 12 of 100 rays end.",
        "Site b: The model ends at 70°.",
    ]
