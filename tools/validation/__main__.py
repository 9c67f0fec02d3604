"""Make the validation table and its pictures; run from the root as ``-m tools.validation``."""

from __future__ import annotations

import math
import sys
from pathlib import Path

from . import mulder_rows, plots, table

ROOT = Path(__file__).resolve().parents[2]
OUTPUT = ROOT / "build" / "validation"
IMAGES = ROOT / "docs" / "images"


def main() -> int:
    """Write everything; return how many rows disagree."""
    rows = table.all_rows()
    OUTPUT.mkdir(parents=True, exist_ok=True)
    (OUTPUT / "validation.md").write_text(table.markdown(rows), encoding="utf-8")
    (OUTPUT / "validation.csv").write_text(table.comma_separated(rows), encoding="utf-8")
    files = plots.save_all(OUTPUT, rows)
    if mulder_rows.load() is None:
        print("mulder is not installed: its rows are left out, and docs stay as they are.")
    else:
        document = table.DOCUMENT.read_text(encoding="utf-8")
        table.DOCUMENT.write_text(table.with_table(document, table.markdown(rows)), "utf-8")
        IMAGES.mkdir(exist_ok=True)
        for file in files:
            (IMAGES / file.name).write_bytes(file.read_bytes())
    apart = [row for row in rows if not row.agrees]
    for row in apart:
        print(f"{row.what}: {row.difference:+.1%} is more than {row.tolerance:.1%}.")
    compared = sum(not math.isnan(row.difference) for row in rows)
    print(f"{len(rows)} rows, {compared} with a reference, {len(apart)} of them apart.")
    print(f"Written to {OUTPUT.relative_to(ROOT)}.")
    return len(apart)


if __name__ == "__main__":
    sys.exit(1 if main() else 0)
