"""Files that appear together when all is done, or not at all."""

from __future__ import annotations

import os
from pathlib import Path
from types import TracebackType

from .errors import MuyscError

#: Permission bits that let anyone write. Checked themselves, because the
#: superuser may write everywhere and read-only is still meant.
_WRITE_BITS = 0o222


class Staging:
    """Collects files under temporary names beside their destinations.

    Leaving the ``with`` block without `commit` removes whatever was written, and
    files that stood at the destinations are as they were.
    """

    def __init__(self) -> None:
        self._moves: list[tuple[Path, Path]] = []
        self._taken: set[Path] = set()

    def __enter__(self) -> Staging:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        for temporary, _ in self._moves:
            temporary.unlink(missing_ok=True)

    def add(self, destination: str | Path, inputs: tuple[str, ...] = ()) -> Path:
        """Return the temporary path for a file that will stand at `destination`.

        Parameters
        ----------
        destination
            Where the file goes; missing folders are made on `commit`.
        inputs
            Files that are read and so must not be written.

        Raises
        ------
        MuyscError
            If the destination is an input, taken by another output, or cannot be
            written.
        """
        target = Path(destination).absolute()
        check_destination(target, inputs)
        if target in self._taken:
            raise MuyscError(
                f"Two outputs go to {target}; give each output a file name of its own."
            )
        self._taken.add(target)
        folder = target.parent
        while not folder.is_dir():
            folder = folder.parent
        temporary = folder / f".{target.stem}.{os.getpid()}-partial{target.suffix}"
        self._moves.append((temporary, target))
        return temporary

    def commit(self) -> None:
        """Move every file that was written to its destination.

        Raises
        ------
        MuyscError
            If a file cannot be moved; those not moved yet are removed.
        """
        for temporary, target in self._moves:
            if not temporary.exists():
                continue
            try:
                target.parent.mkdir(parents=True, exist_ok=True)
                temporary.replace(target)
            except OSError as error:
                raise MuyscError(
                    f"{target} cannot be written ({error.strerror}); close whatever holds it "
                    "open or choose another place."
                ) from error


def check_destination(target: Path, inputs: tuple[str, ...] = ()) -> None:
    """Refuse a destination that cannot be written or is being read.

    Raises
    ------
    MuyscError
        With the reason.
    """
    for name in inputs:
        source = Path(name)
        if source.exists() and target.exists() and source.samefile(target):
            raise MuyscError(f"The output {target} is the input itself; choose another file name.")
    if target.is_dir():
        raise MuyscError(f"The output {target} is a folder; give a file name in it.")
    folder = target.parent
    while not folder.exists():
        folder = folder.parent
    for place in (target, folder) if target.exists() else (folder,):
        if place == folder and not folder.is_dir():
            raise MuyscError(
                f"{target} cannot be written because {folder} is no folder; choose another place."
            )
        if not (place.stat().st_mode & _WRITE_BITS and os.access(place, os.W_OK)):
            raise MuyscError(
                f"{target} cannot be written because {place} is read-only; choose another place "
                "or make it writable."
            )
