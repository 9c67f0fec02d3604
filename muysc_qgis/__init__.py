"""Simulation of muon radiography and tomography of large structures."""

from pathlib import Path


def _stated_version() -> str:
    """Return the version from metadata.txt, the one place where it stands."""
    metadata = Path(__file__).resolve().parent.parent / "metadata.txt"
    for line in metadata.read_text(encoding="utf-8").splitlines():
        key, _, value = line.partition("=")
        if key == "version":
            return value.strip()
    raise ValueError(f"{metadata} states no version.")


__version__ = _stated_version()
