"""The validation table as Markdown and CSV, and its place in the documentation."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from pathlib import Path

from . import (
    formula_ranges,
    mulder_rows,
    paper_rows,
    physics_rows,
    shape_rows,
    sky_rows,
    terrain_rows,
)
from .row import Row

DOCUMENT = Path(__file__).resolve().parents[2] / "docs" / "physics.md"
BEGIN = "<!-- made by make validation: begin -->"
END = "<!-- made by make validation: end -->"
HEADER = ("Quantity", "Ours", "Reference", "Difference", "Source of the reference")


def all_rows() -> list[Row]:
    """Compute every row; those against mulder only where it is installed."""
    return [*own_rows(), *mulder_rows.rows()]


def own_rows() -> list[Row]:
    """Compute every row that needs no other code."""
    modules = (shape_rows, terrain_rows, paper_rows, sky_rows, formula_ranges, physics_rows)
    return [row for module in modules for row in module.rows()]


def line(row: Row) -> str:
    """Return a row as one line of a Markdown table."""
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in row.cells()) + " |"


def markdown(rows: Iterable[Row]) -> str:
    """Return one Markdown table for each section."""
    sections: dict[str, list[Row]] = {}
    for row in rows:
        sections.setdefault(row.section, []).append(row)
    parts = []
    for title, members in sections.items():
        head = ["| " + " | ".join(HEADER) + " |", "|---|---|---|---|---|"]
        parts.append("\n".join([f"### {title}", "", *head, *map(line, members)]))
    return "\n\n".join(parts) + "\n"


def comma_separated(rows: Iterable[Row]) -> str:
    """Return the rows as CSV, numbers in full."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(
        ("section", "quantity", "unit", "ours", "ours_to", "reference", "reference_to",
         "relative_difference", "tolerance", "source")
    )  # fmt: skip
    for row in rows:
        numbers = (row.ours, row.ours_to, row.reference, row.reference_to, row.difference)
        writer.writerow(
            (row.section, row.what, row.unit, *map(_cell, numbers), row.tolerance, row.source)
        )
    return text.getvalue()


def _cell(value: float | None) -> str:
    return "" if value is None or value != value else f"{value:.8g}"


def with_table(document: str, table: str) -> str:
    """Return the document with the table between its two marks."""
    before, _, rest = document.partition(BEGIN)
    _, _, after = rest.partition(END)
    return f"{before}{BEGIN}\n\n{table}\n{END}{after}"


def lines_between_marks(document: str) -> list[str]:
    """Return the rows of the tables that a document holds."""
    inside = document.partition(BEGIN)[2].partition(END)[0]
    return [text for text in inside.splitlines() if text.startswith("| ")]
