"""What every case must come to: sane results, or one sentence and nothing left behind."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

#: What must not reach a user.
_LEAKS = (
    "Traceback", "Error:", "Error(", "NoneType", "could not be wrapped", "object at 0x",
    "<class ", "numpy", "unexpected type", "without a word",
)  # fmt: skip
#: QGIS refuses some values by itself, in its own words.
_OWN_WORDS = ("Incorrect parameter value for ", "Could not load source layer for ", "Wrong or ")
OLDER = b"older result"


def faults(case: dict[str, Any], told: dict[str, Any], folder: Path) -> list[str]:
    """Return what is wrong with the end of a case, whose outputs went to `folder`."""
    if told["end"] == "broken":
        return [told["sentence"]]
    found = list(told["complaints"])
    found += [leak for said in told["warnings"] for leak in _leaks(said)]
    found += [f"left {path.name}" for path in folder.rglob("*-partial*")]
    if told["end"] == "refused":
        found += about_sentence(told["sentence"])
        # A model leaves what its earlier steps have finished.
        if not any(":" in name for name in case):
            found += _about_remains(folder)
    else:
        found += _about_results(told, folder)
    return found


def about_sentence(said: str) -> list[str]:
    """Return what is wrong with the sentence that a user reads."""
    if said.startswith(_OWN_WORDS):
        return []
    found = _leaks(said)
    if "\n" in said.strip() or not said.rstrip().endswith((".", ".)", ".”")):
        found.append(f"“{said}” is not one sentence")
    return found


def _leaks(said: str) -> list[str]:
    return [f"“{said}” leaks {leak}" for leak in _LEAKS if leak in said]


def _about_remains(folder: Path) -> list[str]:
    """Return files that a refused case has changed or left, but for what is kept to go on."""
    return [
        f"left {path.relative_to(folder)}"
        for path in folder.rglob("*")
        if path.is_file()
        and not any(part.endswith(("cache", ".partial")) for part in path.parts)
        and path.read_bytes() != OLDER
    ]


def _about_results(told: dict[str, Any], folder: Path) -> list[str]:
    found = [f"left {path.name}" for path in folder.rglob("*.partial")]
    for name, value in told["results"].items():
        if isinstance(value, float) and math.isinf(value):
            found.append(f"{name} is {value}")
        elif isinstance(value, str) and value.startswith(str(folder)):
            path = Path(value)
            if not path.exists():
                found.append(f"{name} is not there")
            elif path.is_file() and path.read_bytes() in (OLDER, b""):
                found.append(f"{name} was not written")
    for path in folder.rglob("*.tif"):
        if path.read_bytes() == OLDER:
            continue
        found += _about_raster(path, bool(told["warnings"]))
    return found


def _about_raster(path: Path, warned: bool) -> list[str]:
    import numpy as np
    from osgeo import gdal

    gdal.UseExceptions()
    dataset = gdal.Open(str(path))
    values = dataset.ReadAsArray()
    del dataset
    if np.isinf(values).any():
        return [f"{path.name} holds infinity"]
    if not np.nan_to_num(values).any() and not warned:
        return [f"{path.name} is all zero or unknown, without a warning"]
    return []
