"""Files that appear together when all is done, or not at all."""

from __future__ import annotations

import contextlib
import glob
import itertools
import os
import shutil
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from types import TracebackType

from .errors import MuyscError

#: Permission bits that let anyone write. Checked themselves, because the
#: superuser may write everywhere and read-only is still meant.
_WRITE_BITS = 0o222

#: Length to which a name is shortened, so that the temporary one is not too long.
_LONGEST_STEM = 40

#: What databases keep beside their file while it is open; out of date once it is replaced.
_COMPANIONS = ("-wal", "-shm", "-journal")

#: Several runs of one process may write to one folder.
_COUNTER = itertools.count(1)

#: Age (s) from which a temporary file is taken for what a killed run left: one day.
_LEFT_BEHIND_S = 86_400


class Staging:
    """Collects files under temporary names beside their destinations.

    Leaving the ``with`` block without `commit` removes whatever was written, and
    files that stood at the destinations are as they were.
    """

    def __init__(self) -> None:
        self._moves: list[tuple[Path, Path]] = []
        self._taken: set[Path] = set()
        #: Folders of the layers, which may be several files each.
        self._layers: list[Path] = []
        #: Folders of what stood at the destinations.
        self._earlier: list[Path] = []

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
        for folder in self._layers + self._earlier:
            shutil.rmtree(folder, ignore_errors=True)

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
        target = self._checked(destination, inputs)
        temporary = _temporary(target, target.suffix)
        self._moves.append((temporary, target))
        return temporary

    def add_layer(self, destination: str | Path) -> Path:
        """Return the temporary path for a vector layer that will stand at `destination`.

        It has the destination's own name, which some formats write into the file, and what
        is written beside it goes along.

        Raises
        ------
        MuyscError
            If the destination is taken by another output or cannot be written.
        """
        target = self._checked(destination)
        folder = _temporary(target, "")
        try:
            folder.mkdir()
        except OSError as error:
            raise MuyscError(
                f"{target} cannot be written ({error.strerror}); choose another place."
            ) from error
        self._layers.append(folder)
        temporary = folder / target.name
        self._moves.append((temporary, target))
        return temporary

    def _checked(self, destination: str | Path, inputs: tuple[str, ...] = ()) -> Path:
        """Return a destination that is free and can be written."""
        target = Path(destination).absolute()
        check_destination(target, inputs)
        if target in self._taken:
            raise MuyscError(
                f"Two outputs go to {target}; give each output a file name of its own."
            )
        self._taken.add(target)
        _clear_leftovers(target)
        return target

    def give_up(self, temporary: Path) -> None:
        """Leave a file out that could not be made."""
        temporary.unlink(missing_ok=True)
        self._moves = [move for move in self._moves if move[0] != temporary]

    def by_destination(self, text: str) -> str:
        """Return a text with destinations in place of their temporary names."""
        for temporary, target in self._moves:
            text = text.replace(str(temporary), str(target))
        return text

    def commit(self) -> None:
        """Move every file to its destination, or none.

        Raises
        ------
        MuyscError
            If a file has vanished or cannot be moved. The destinations are then as they were.
        """
        for temporary, target in self._moves:
            if not temporary.exists():
                raise MuyscError(
                    f"{target} vanished while it was written; see that nothing else clears "
                    f"{target.parent}."
                )
        undo: list[Callable[[], object]] = []
        try:
            for temporary, target in list(self._files()):
                self._place(temporary, target, undo)
        except BaseException:
            for step in reversed(undo):
                with contextlib.suppress(OSError):  # the others are still put back
                    step()
            raise

    def _place(self, temporary: Path, target: Path, undo: list[Callable[[], object]]) -> None:
        """Move one file to its destination; add to `undo` what takes each step back."""
        try:
            for folder in reversed(target.parents):
                if not folder.exists():
                    folder.mkdir(exist_ok=True)
                    undo.append(folder.rmdir)
            earlier = self._keep(target) if os.path.lexists(target) else None
            temporary.replace(target)
            undo.append(partial(earlier.replace, target) if earlier else target.unlink)
            for ending in _COMPANIONS:
                companion = target.with_name(target.name + ending)
                if companion.exists():
                    earlier = self._keep(companion)
                    companion.unlink()
                    undo.append(partial(earlier.replace, companion))
        except OSError as error:
            raise MuyscError(
                f"{target} cannot be written ({error.strerror}); close whatever holds it "
                "open or choose another place."
            ) from error

    def _keep(self, standing: Path) -> Path:
        """Return a second path of a file, so that it can be replaced and put back."""
        folder = _temporary(standing, "")
        folder.mkdir()
        self._earlier.append(folder)
        kept = folder / standing.name
        try:
            os.link(standing, kept)  # it never vanishes from its own place
        except OSError:
            # Disks without hard links (FAT, some network shares): slower, but it stays too.
            shutil.copy2(standing, kept)
        return kept

    def _files(self) -> Iterator[tuple[Path, Path]]:
        """Yield every temporary file and where it goes."""
        for temporary, target in self._moves:
            if temporary.parent not in self._layers:
                yield temporary, target
                continue
            for file in sorted(temporary.parent.iterdir()):
                yield file, target.parent / file.name


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


def _temporary(target: Path, suffix: str) -> Path:
    """Return a path that no other run has, on the same disk as the destination."""
    stem = target.stem[:_LONGEST_STEM]
    return _standing_folder(target) / f".{stem}.{os.getpid()}-{next(_COUNTER)}-partial{suffix}"


def _clear_leftovers(target: Path) -> None:
    """Remove what killed runs left of their way to this destination."""
    stem = glob.escape(target.stem[:_LONGEST_STEM])
    oldest = time.time() - _LEFT_BEHIND_S
    for path in _standing_folder(target).glob(f".{stem}.[0-9]*-[0-9]*-partial*"):
        with contextlib.suppress(OSError):  # another run may be clearing them too
            if path.lstat().st_mtime > oldest:
                continue
            if path.is_dir():
                shutil.rmtree(path)
            else:
                path.unlink()


def _standing_folder(target: Path) -> Path:
    """Return the nearest folder above a destination that exists."""
    return next(folder for folder in target.parents if folder.is_dir())
