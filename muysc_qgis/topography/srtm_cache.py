"""Tiles kept on disk, so that none is fetched twice."""

from __future__ import annotations

import hashlib
import os
import uuid
from dataclasses import dataclass
from pathlib import Path

from ..errors import MuyscError
from .srtm import Source, Tile

#: Characters of the folder's name: enough to keep sources apart.
_NAME_CHARACTERS = 16


@dataclass(frozen=True)
class TileCache:
    """A folder with a folder for each source: tiles as they came, with their checksums.

    A tile ``N40E014.tile`` is only used if it has the checksum in ``N40E014.sha256``, a
    file as `sha256sum` writes and checks it. Both get their names when they are complete,
    so that several runs may share a folder and one that is stopped does no harm.
    """

    folder: Path
    source: Source

    def read(self, tile: Tile) -> bytes | None:
        """Return a tile as it came, None if there is none that is whole."""
        data, checksum = self._paths(tile)
        try:
            if data.stat().st_size > self.source.largest_bytes:
                return None
            payload = data.read_bytes()
            wanted = checksum.read_text(encoding="ascii").split()
        except (OSError, UnicodeDecodeError):
            return None
        return payload if wanted[:1] == [hashlib.sha256(payload).hexdigest()] else None

    def write(self, tile: Tile, payload: bytes) -> None:
        """Keep a tile.

        Raises
        ------
        MuyscError
            If the folder cannot be written.
        """
        data, checksum = self._paths(tile)
        line = f"{hashlib.sha256(payload).hexdigest()}  {data.name}\n"
        try:
            data.parent.mkdir(parents=True, exist_ok=True)
            _write_at_once(data, payload)
            _write_at_once(checksum, line.encode("ascii"))
        except OSError as error:
            raise MuyscError(
                f"The tile {tile.name} cannot be kept in {data.parent} ({error.strerror}); make "
                "room there or choose another CACHE folder."
            ) from error

    def _paths(self, tile: Tile) -> tuple[Path, Path]:
        # By the template's checksum: it may hold a key, and characters no name can have.
        name = hashlib.sha256(self.source.template.encode()).hexdigest()[:_NAME_CHARACTERS]
        folder = self.folder / name
        return folder / f"{tile.name}.tile", folder / f"{tile.name}.sha256"


def _write_at_once(path: Path, content: bytes) -> None:
    """Write a file under another name and rename it."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}-{uuid.uuid4().hex}")
    try:
        temporary.write_bytes(content)
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)
