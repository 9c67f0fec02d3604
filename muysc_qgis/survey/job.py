"""A survey as work that can be handed out: one item for each place, all on the same data."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from .. import __version__
from ..errors import MuyscError
from ..progress import Progress, silent

#: What is computed for one item: anything that JSON can hold. It is told whom to tell the
#: share of the item done.
Compute = Callable[[int, Progress], Any]

#: Name of the library, from which functions are found by name.
_LIBRARY = __name__.rsplit(".", 2)[0]

_DESCRIPTION = "job.json"


@dataclass(frozen=True, eq=False)
class Job:
    """Plain data and the name of a function, from which every process makes the same results.

    Parameters
    ----------
    function
        ``module:name`` below the library, such as ``workflows.site_selection:prepare``.
        Called with settings and arrays, it returns a `Compute`.
    settings
        What JSON can hold.
    arrays
        Data by name.
    items
        Number of items.
    called
        What they are, for messages.
    block_items
        Items computed and kept together: a second or two of work.
    """

    function: str
    settings: Mapping[str, Any]
    arrays: Mapping[str, np.ndarray]
    items: int
    called: str = "candidates"
    block_items: int = 32

    @property
    def fingerprint(self) -> str:
        """A text that differs whenever results may differ."""
        digest = hashlib.sha256(self._description().encode())
        for name in sorted(self.arrays):
            array = np.ascontiguousarray(self.arrays[name])
            digest.update(f"{name}{array.dtype.str}{array.shape}".encode())
            digest.update(array.data)
        return digest.hexdigest()

    def _description(self) -> str:
        return json.dumps(
            {
                "version": __version__,
                "function": self.function,
                "items": self.items,
                "called": self.called,
                "block_items": self.block_items,
                "settings": self.settings,
                "arrays": sorted(self.arrays),
            },
            sort_keys=True,
        )

    def save(self, folder: Path) -> None:
        """Write everything into a folder, from which other processes take it."""
        for name, array in self.arrays.items():
            np.save(folder / f"{name}.npy", array, allow_pickle=False)
        (folder / _DESCRIPTION).write_text(self._description(), encoding="utf-8")

    @classmethod
    def load(cls, folder: Path) -> Job:
        """Return the job of a folder; arrays stay in the files, in memory once for all."""
        plain = json.loads((folder / _DESCRIPTION).read_text(encoding="utf-8"))
        arrays = {
            name: np.load(folder / f"{name}.npy", mmap_mode="r", allow_pickle=False)
            for name in plain["arrays"]
        }
        return cls(
            plain["function"], plain["settings"], arrays, plain["items"], plain["called"],
            plain["block_items"],
        )  # fmt: skip

    def prepared(self) -> Compute:
        """Return what computes an item."""
        module, name = self.function.split(":")
        prepare = getattr(import_module(f"{_LIBRARY}.{module}"), name)
        return prepare(self.settings, self.arrays)


def answer(compute: Compute, items: Sequence[int]) -> dict[str, Any]:
    """Return the results of items, or the sentence that says why there are none."""
    try:
        return {"results": [compute(item, silent) for item in items]}
    except MuyscError as error:
        return {"error": str(error)}


def answer_elsewhere(plain: Mapping[str, Any], items: Sequence[int]) -> dict[str, Any]:
    """Return the same for a job that arrived as plain data on another machine."""
    return answer(_prepared_once(_Plain(plain)), items)


class _Plain:
    """Plain data of a job, told apart by the fingerprint alone."""

    def __init__(self, plain: Mapping[str, Any]) -> None:
        self.plain = plain

    def __hash__(self) -> int:
        return hash(self.plain["fingerprint"])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Plain) and other.plain["fingerprint"] == self.plain["fingerprint"]


@lru_cache(maxsize=1)
def _prepared_once(data: _Plain) -> Compute:
    plain = data.plain
    return Job(plain["function"], plain["settings"], plain["arrays"], plain["items"]).prepared()
