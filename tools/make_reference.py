"""Write docs/algorithms.md from what the algorithms declare about themselves.

Needs QGIS; run as ``make reference`` after any change of parameters or outputs.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Iterator

from qgis.core import QgsProcessingAlgorithm, QgsProcessingParameterDefinition

from .declared import (
    ROOT,
    declared_by,
    default,
    in_order,
    is_advanced,
    load_provider,
    options,
    start_qgis,
)

TARGET = ROOT / "docs" / "algorithms.md"

HEAD = """\
# Algorithms

Every parameter and output, as the algorithms declare them; made by `make reference`, not by hand.
Parameters marked † stand under *Advanced* in the dialog; those without a default must be given.
The [README](../README.md) says how to run them.
"""


def cell(text: object) -> str:
    """Return text that stays in one cell of a table."""
    return " ".join(str(text).replace("|", "\\|").split())


def table(head: str, rows: Iterable[tuple[str, ...]]) -> Iterator[str]:
    """Yield the lines of a table, none where it has no rows."""
    lines = [f"| {' | '.join(row)} |" for row in rows]
    if lines:
        yield from ("", head, "|---" * (head.count("|") - 1) + "|", *lines)


def meaning(one: QgsProcessingParameterDefinition) -> str:
    """Return what is said of a parameter."""
    said = f"**{cell(one.description())}.** {cell(one.help())}"
    words = ", ".join(f"`{word}`" for word in options(one))
    return f"{said} One of {words}." if words else said


def describe(algorithm: QgsProcessingAlgorithm) -> Iterator[str]:
    """Yield the lines about one algorithm."""
    yield from ("", f"## {algorithm.displayName()}", "", f"`{algorithm.id()}`")
    declared = declared_by(algorithm)
    inputs = [
        (
            f"`{one.name()}`{' †' if is_advanced(one) else ''}",
            meaning(one),
            cell(default(one, "*optional*")),
        )
        for one in declared.inputs
    ]
    files = [(f"`{one.name()}`", meaning(one)) for one in declared.files]
    numbers = [(f"`{one.name()}`", f"**{cell(one.description())}**") for one in declared.numbers]
    yield from table("| Parameter | Meaning | Default |", inputs)
    yield from table("| Output | Meaning |", files + numbers)


def main() -> None:
    """Write the reference."""
    with tempfile.TemporaryDirectory() as profile:
        application = start_qgis(profile)
        provider = load_provider()  # its algorithms live as long as it does
        lines = [line for algorithm in in_order(provider) for line in describe(algorithm)]
        TARGET.write_text(HEAD + "\n".join(lines) + "\n", encoding="utf-8")
        del application
    print(f"Wrote {TARGET.relative_to(ROOT)}.")


if __name__ == "__main__":
    main()
