"""From the plan to Processing: the prefilled dialog, and the line for a terminal."""

from __future__ import annotations

import shlex
import subprocess  # nosec B404
import sys
from collections.abc import Mapping
from typing import Any

#: The algorithms that a plan is for.
RADIOGRAPHY, EXPECTED_COUNTS = "muysc:radiography", "muysc:expectedcounts"

#: Outputs that a line must name, by algorithm; files appear where it is run.
_OUTPUTS = {
    RADIOGRAPHY: {"THICKNESS": "thickness.tif", "FLUX": "flux.tif"},
    EXPECTED_COUNTS: {"COUNTS": "counts.tif"},
}


def open_dialog(algorithm: str, parameters: Mapping[str, Any]) -> None:
    """Open the Processing dialog of an algorithm with its values filled in."""
    # The Processing plugin is there in the desktop only.
    import processing

    known = {name: value for name, value in parameters.items() if value not in (None, "")}
    processing.createAlgorithmDialog(algorithm, known).show()


def command_line(algorithm: str, parameters: Mapping[str, Any]) -> str:
    """Return what runs an algorithm in a terminal.

    Parameters
    ----------
    algorithm
        `RADIOGRAPHY` or `EXPECTED_COUNTS`.
    parameters
        Values by name; None is left out.
    """
    values = {**parameters, **_OUTPUTS[algorithm]}
    options = [f"--{name}={value}" for name, value in values.items() if value is not None]
    line = ["qgis_process", "run", algorithm, *options]
    # Nothing is run: only the quoting of Windows is taken from there.
    return subprocess.list2cmdline(line) if sys.platform == "win32" else shlex.join(line)
