"""Write docs/algorithms.md from what the algorithms declare about themselves.

Needs QGIS; run as ``make reference`` after any change of parameters or outputs.
"""

from __future__ import annotations

import importlib.util
import os
import sys
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path

from qgis.core import (
    QgsApplication,
    QgsProcessingAlgorithm,
    QgsProcessingParameterDefinition,
    QgsProcessingProvider,
)

ROOT = Path(__file__).resolve().parent.parent
TARGET = ROOT / "docs" / "algorithms.md"
#: The package name is the folder's name, whatever that is; here it gets one.
ALIAS = "muysc"

HEAD = """\
# Algorithms

Every parameter and output, as the algorithms declare them; made by `make reference`, not by hand.
Parameters marked † stand under *Advanced* in the dialog; those without a default must be given.
The [README](../README.md) says how to run them.
"""


def load_provider() -> QgsProcessingProvider:
    """Load the plugin as QGIS does and return its provider."""
    spec = importlib.util.spec_from_file_location(
        ALIAS, ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    package = sys.modules[ALIAS] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(package)
    plugin = package.classFactory(None)
    plugin.initProcessing()
    return plugin.provider


def in_order(provider: QgsProcessingProvider) -> list[QgsProcessingAlgorithm]:
    """Return the algorithms in the order of the toolbox."""
    order = [name for name, _ in sys.modules[f"{ALIAS}.processing_algorithms.provider"].ALGORITHMS]
    known = {one.name(): one for one in provider.algorithms()}
    return [known.pop(name) for name in order if name in known] + list(known.values())


def cell(text: object) -> str:
    """Return text that stays in one cell of a table."""
    return " ".join(str(text).replace("|", "\\|").split())


def default(parameter: QgsProcessingParameterDefinition) -> str:
    """Return the default as one would type it."""
    value = parameter.defaultValue()
    if value is None or value == "":
        optional = parameter.flags() & QgsProcessingParameterDefinition.Flag.FlagOptional
        return "*optional*" if optional else ""
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:g}" if isinstance(value, float) else cell(value)


def table(head: str, rows: Iterable[tuple[str, ...]]) -> Iterator[str]:
    """Yield the lines of a table, none where it has no rows."""
    lines = [f"| {' | '.join(row)} |" for row in rows]
    if lines:
        yield from ("", head, "|---" * (head.count("|") - 1) + "|", *lines)


def describe(algorithm: QgsProcessingAlgorithm) -> Iterator[str]:
    """Yield the lines about one algorithm."""
    yield from ("", f"## {algorithm.displayName()}", "", f"`{algorithm.id()}`")
    inputs, files = [], []
    for one in algorithm.parameterDefinitions():
        mark = "†" if one.flags() & QgsProcessingParameterDefinition.Flag.FlagAdvanced else ""
        said = f"**{cell(one.description())}.** {cell(one.help())}"
        if one.isDestination():
            files.append((f"`{one.name()}`", said))
        else:
            options = getattr(one, "options", list)()
            if options:
                said += f" One of {', '.join(f'`{word}`' for word in options)}."
            inputs.append((f"`{one.name()}` {mark}".strip(), said, default(one)))
    written = {name for name, _ in files}
    numbers = [
        (f"`{one.name()}`", f"**{cell(one.description())}**")
        for one in algorithm.outputDefinitions()
        if f"`{one.name()}`" not in written
    ]
    yield from table("| Parameter | Meaning | Default |", inputs)
    yield from table("| Output | Meaning |", files + numbers)


def main() -> None:
    """Write the reference."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    with tempfile.TemporaryDirectory() as profile:
        os.environ["QGIS_CUSTOM_CONFIG_PATH"] = os.environ["XDG_RUNTIME_DIR"] = profile
        application = QgsApplication([], False, profile)
        application.initQgis()
        provider = load_provider()
        lines = [line for algorithm in in_order(provider) for line in describe(algorithm)]
        TARGET.write_text(HEAD + "\n".join(lines) + "\n", encoding="utf-8")
    print(f"Wrote {TARGET.relative_to(ROOT)}.")


if __name__ == "__main__":
    main()
