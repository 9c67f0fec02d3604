"""Results block by block, kept in a folder so that a survey goes on where it ended."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

from ..errors import MuyscError
from .job import Job

_FINGERPRINT = "fingerprint.txt"
_NOTE = "about.txt"
_ABOUT = (
    "Finished parts of a MUYSC survey that has not come to its end. The same run with the same\n"
    "destination goes on from here and removes this folder at its end; it may be deleted.\n"
)


class BlockFolder:
    """The finished blocks of one job.

    Parameters
    ----------
    folder
        Where they are kept; emptied if it holds those of another job.
    job
        The job.

    Raises
    ------
    MuyscError
        If the folder is something else or cannot be written.
    """

    def __init__(self, folder: Path, job: Job) -> None:
        self.folder = folder
        self._items, self._size = job.items, job.block_items
        fingerprint = job.fingerprint
        try:
            if folder.exists() and not self._holds(fingerprint):
                self._clear()
            folder.mkdir(parents=True, exist_ok=True)
            if not self._holds(fingerprint):
                (folder / _NOTE).write_text(_ABOUT, encoding="utf-8")
                job.save(folder)
                # Written last, so that a half-written folder is none.
                (folder / _FINGERPRINT).write_text(fingerprint, encoding="utf-8")
        except OSError as error:
            raise MuyscError(
                f"The finished parts cannot be kept in {folder} ({error.strerror}); choose "
                "another destination."
            ) from error

    def _holds(self, fingerprint: str) -> bool:
        path = self.folder / _FINGERPRINT
        return path.is_file() and path.read_bytes() == fingerprint.encode()

    def _clear(self) -> None:
        ours = self.folder.is_dir() and (self.folder / _NOTE).is_file()
        if not ours and not (self.folder.is_dir() and not any(self.folder.iterdir())):
            raise MuyscError(
                f"{self.folder} is in the way of the survey's finished parts; move it or choose "
                "another destination."
            )
        shutil.rmtree(self.folder)

    def items(self, block: int) -> range:
        """Return the items of a block."""
        return range(block * self._size, min((block + 1) * self._size, self._items))

    def _path(self, block: int) -> Path:
        return self.folder / f"block_{block:06d}.json"

    def pending(self) -> list[int]:
        """Return the blocks that are not finished, or whose file is damaged."""
        return [block for block in self._blocks() if self._read(block) is None]

    def _read(self, block: int) -> list[Any] | None:
        try:
            results = json.loads(self._path(block).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return None
        return results if isinstance(results, list) else None

    def _blocks(self) -> range:
        return range(-(-self._items // self._size))

    def keep(self, block: int, results: list[Any]) -> None:
        """Keep a finished block.

        Raises
        ------
        MuyscError
            If it cannot be written.
        """
        path = self._path(block)
        partial = path.with_suffix(".partial")
        try:
            partial.write_text(json.dumps(results), encoding="utf-8")
            partial.replace(path)
        except OSError as error:
            raise MuyscError(
                f"The finished parts cannot be kept in {self.folder} ({error.strerror}); make "
                "room or choose another destination, and run again to go on."
            ) from error

    def results(self) -> list[Any]:
        """Return the results of all items in their order, once no block is pending.

        Raises
        ------
        MuyscError
            If a block cannot be read.
        """
        found = []
        for block in self._blocks():
            results = self._read(block)
            if results is None:
                raise MuyscError(
                    f"{self._path(block)} cannot be read any more; run again to compute it anew."
                )
            found += results
        return found


def remove_finished(folder: Path) -> None:
    """Remove the finished parts of a job whose results are used."""
    shutil.rmtree(folder, ignore_errors=True)
