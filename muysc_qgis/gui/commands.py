"""From the plan to Processing: the prefilled dialog, and the line for a terminal."""

from __future__ import annotations

import shlex
import subprocess  # nosec B404
import sys
from collections.abc import Mapping
from typing import Any

#: Outputs that a line must name, by algorithm; files appear where it is run.
_OUTPUTS = {
    "muysc:radiography": {"THICKNESS": "thickness.tif", "FLUX": "flux.tif"},
    "muysc:expectedcounts": {"COUNTS": "counts.tif"},
}


def open_dialog(algorithm: str, parameters: Mapping[str, Any]) -> Any:
    """Open the Processing dialog of an algorithm with its values filled in."""
    # The Processing plugin is there in the desktop only.
    import processing

    known = {name: value for name, value in parameters.items() if value not in (None, "")}
    dialog = processing.createAlgorithmDialog(algorithm, known)
    dialog.show()
    return dialog


def command_line(algorithm: str, parameters: Mapping[str, Any]) -> str:
    """Return what runs an algorithm in a terminal.

    Parameters
    ----------
    algorithm
        Its id, “muysc:radiography”.
    parameters
        Values by name; None is left out.
    """
    values = {**parameters, **_OUTPUTS[algorithm]}
    options = [f"--{name}={value}" for name, value in values.items() if value is not None]
    line = ["qgis_process", "run", algorithm, *options]
    # Nothing is run: only the quoting of Windows is taken from there.
    return subprocess.list2cmdline(line) if sys.platform == "win32" else shlex.join(line)
