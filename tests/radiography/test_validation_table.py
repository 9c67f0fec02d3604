"""The validation table: its rows hold, and the documentation shows them as they are."""

import csv
import io
import math
import re

import pytest

from tools.validation import mulder_rows, table
from tools.validation.row import Row, number


@pytest.fixture(scope="module")
def rows():
    return table.own_rows()


@pytest.fixture(scope="module")
def document():
    return table.DOCUMENT.read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def documented(document):
    return table.lines_between_marks(document)


def test_every_row_keeps_its_tolerance(rows):
    apart = [f"{row.what}: {row.difference:+.2%}" for row in rows if not row.agrees]
    assert apart == []


def test_every_section_compares_something(rows):
    compared = {row.section for row in rows if row.reference is not None}
    assert compared == {row.section for row in rows}
    assert sum(row.reference is not None for row in rows) > 70
    assert all(row.source for row in rows)


def test_the_documentation_shows_these_rows(rows, documented):
    """Whoever changes a number runs `make validation`."""
    shown = [
        text
        for text in documented
        if "| mulder " not in text and not text.startswith(f"| {table.HEADER[0]} |")
    ]
    assert shown == [table.line(row) for row in rows]


def test_rows_against_mulder_hold_and_are_shown(documented):
    pytest.importorskip("mulder")
    found = list(mulder_rows.rows(monte_carlo=False))
    assert len(found) > 10
    assert [row.what for row in found if not row.agrees] == []
    shown = {text.split(" | ")[0].removeprefix("| ") for text in documented}
    assert {row.what for row in found} <= shown


def test_documented_intensities_are_within_their_noise_of_mulder(documented):
    lines = [text for text in documented if text.endswith("backward transport through a slab |")]
    assert len(lines) == 10
    for text in lines:
        percent = float(re.search(r"([+−][\d.]+) %", text).group(1).replace("−", "-"))
        assert abs(percent) <= (4.0 if "all losses" in text else 0.4), text


def test_pictures_and_links_of_the_documentation_lead_somewhere(document):
    targets = re.findall(r"\]\((?!https?:|#)([^)#]+)", document)
    assert len([target for target in targets if target.endswith(".png")]) == 9
    for target in targets:
        assert (table.DOCUMENT.parent / target).exists(), target
    anchors = {
        re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
        for title in re.findall(r"^## (.+)$", document, re.MULTILINE)
    }
    for anchor in re.findall(r"\]\(#([^)]+)\)", document):
        assert anchor in anchors, anchor


def row(ours=1.0, reference=2.0, **more):
    return Row("section", "what", ours, "m", reference, "source", **more)


@pytest.mark.parametrize(
    ("one", "difference", "text"),
    [
        (row(2.1), 0.05, "+5.0 %"),
        (row(1.9), -0.05, "−5.0 %"),
        (row(-2.1, -2.0), 0.05, "+5.0 %"),
        (row(2.5, 2.0, reference_to=3.0), 0.0, "within"),
        (row(3.3, 2.0, reference_to=3.0), 0.1, "+10.0 %"),
        (row(1.0, 2.0, ours_to=3.0), 0.0, "within"),
        (row(1.0, 2.0, ours_to=1.8), -0.1, "−10.0 %"),
        (row(3.0, 2.0, reference_to=2.5, ours_to=3.5), 0.2, "+20.0 %"),
        (row(4.1), 1.05, "2.05 times"),
        (row(0.5), -0.75, "0.25 times"),
        (row(1.0, None), math.nan, "–"),
        (row(None), math.nan, "–"),
    ],
)
def test_differences(one, difference, text):
    assert one.difference == pytest.approx(difference, nan_ok=True)
    assert one.cells()[3] == text


def test_agreement_needs_the_tolerance():
    assert not row(2.1, tolerance=0.04).agrees
    assert row(2.1, tolerance=0.051).agrees
    # Shown, not required; nothing to compare with.
    assert row(9.0, tolerance=None).agrees
    assert row(9.0, None).agrees
    assert not row(2.1).agrees


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"), (1.0, "1"), (1234.5, "1234"), (40762.3, "40762"), (2.45e5, "2.45e5"),
        (3.321e-7, "3.321e-7"), (0.00323, "0.00323"), (-2.75, "-2.75"),
    ],
)  # fmt: skip
def test_numbers_have_four_digits(value, text):
    assert number(value) == text


def test_the_table_goes_between_its_marks_and_stays_there():
    document = f"before\n{table.BEGIN}\nold\n{table.END}\nafter\n"
    once = table.with_table(document, table.markdown([row()]))
    assert once.startswith("before\n")
    assert once.endswith("\nafter\n")
    assert "old" not in once
    assert table.with_table(once, table.markdown([row()])) == once
    assert table.line(row()) in table.lines_between_marks(once)


def test_the_figures_of_the_paper_are_shown_and_not_required(rows):
    stated = [row for row in rows if row.source.startswith("MUYSC paper (arXiv:2303.02627), text")]
    assert len(stated) > 40
    assert all(row.tolerance is None for row in stated)
    elsewhere = [row for row in stated if row.ours is None]
    assert {row.what.split(",")[0] for row in elsewhere} == {"Mount Etna", "Puy de Dôme"}
    assert all(row.cells()[1] == "–" and row.agrees for row in elsewhere)


def test_numbers_stand_in_full_in_the_csv():
    text = table.comma_separated([row(1 / 3, 2.0, tolerance=0.1), row(1.0, None)])
    first, second = csv.DictReader(io.StringIO(text))
    assert float(first["ours"]) == pytest.approx(1 / 3, rel=1e-7)
    assert float(first["relative_difference"]) == pytest.approx(1 / 6 - 1, rel=1e-7)
    assert second["reference"] == second["relative_difference"] == ""
