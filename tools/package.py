"""Pack the last commit as the zip that QGIS installs, and check it as the plugin site does.

Writes build/muysc-<version>.zip::

    /usr/bin/python3 tools/package.py
"""

from __future__ import annotations

import configparser
import hashlib
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path, PurePosixPath

ROOT = Path(__file__).resolve().parent.parent
#: The folder in the zip is the plugin's package name, so it is an identifier.
PLUGIN = "muysc"

#: What the plugin site demands of an upload.
LARGEST_BYTES = 25_000_000
REQUIRED_FILES = ("__init__.py", "metadata.txt", "LICENSE")
REQUIRED_ENTRIES = (
    "name", "description", "about", "version", "qgisMinimumVersion", "author", "email",
    "tracker", "repository", "homepage",
)  # fmt: skip
BOOLEAN_ENTRIES = ("experimental", "deprecated", "server")
REFUSED_FOLDERS = {"__MACOSX", "__pycache__"}
REFUSED_SUFFIXES = {
    ".so", ".dll", ".dylib", ".pyd", ".exe", ".sh", ".bat", ".cmd", ".ps1", ".pyc", ".pyo",
}  # fmt: skip
#: How programs for Linux, Windows and macOS begin.
PROGRAMS = (b"\x7fELF", b"MZ", b"\xcf\xfa\xed\xfe", b"\xce\xfa\xed\xfe", b"\xca\xfe\xba\xbe")

#: What a user's own settings could change in the files; a zip holds local times, too.
_GIT_SETTINGS = ("core.autocrlf=false", "core.eol=lf", f"core.attributesFile={os.devnull}")
_EXECUTABLE = 0o111


def git(*arguments: str) -> str:
    """Run git on this checkout, whatever the user's settings and time zone; return its words."""
    settings = [word for setting in _GIT_SETTINGS for word in ("-c", setting)]
    done = subprocess.run(  # noqa: S603
        ["git", *settings, *arguments],  # noqa: S607
        cwd=ROOT,
        env={**os.environ, "TZ": "UTC"},
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    )
    return done.stdout


def pack(archive: Path, commit: str = "HEAD") -> None:
    """Write a commit as a zip whose bytes depend on the commit alone."""
    git("archive", "--format=zip", "-9", f"--prefix={PLUGIN}/", f"--output={archive}", commit)


def faults(archive: Path) -> list[str]:
    """Return what the plugin site, or an unpacking on any system, would take offence at."""
    size = archive.stat().st_size
    found = []
    if size > LARGEST_BYTES:
        found.append(f"The zip has {size} bytes; at most {LARGEST_BYTES} are accepted.")
    with zipfile.ZipFile(archive) as content:
        broken = content.testzip()
        if broken:
            return [*found, f"{broken} is broken."]
        files = [entry for entry in content.infolist() if not entry.is_dir()]
        names = [entry.filename for entry in files]
        found += faults_of_names(names)
        for entry in files:
            if entry.external_attr >> 16 & _EXECUTABLE:
                found.append(f"{entry.filename} is marked as a program.")
            if content.read(entry).startswith(PROGRAMS):
                found.append(f"{entry.filename} is a program.")
        top = PurePosixPath(names[0]).parts[0]
        missing = [name for name in REQUIRED_FILES if f"{top}/{name}" not in names]
        found += [f"{name} is missing." for name in missing]
        if "metadata.txt" not in missing:
            text = content.read(f"{top}/metadata.txt").decode("utf-8")
            found += faults_of_metadata(text)
    return found


def faults_of_names(names: list[str]) -> list[str]:
    """Return what is wrong with the paths in a zip."""
    found = []
    tops = {PurePosixPath(name).parts[0] for name in names}
    if len(tops) > 1:
        found.append(f"There is more than one folder at the top: {', '.join(sorted(tops))}.")
    found += [
        f"The folder {top} is no name of a Python package."
        for top in sorted(tops)
        if not (top.isidentifier() and re.fullmatch(r"[A-Za-z]\w+", top, re.ASCII))
    ]
    for name in names:
        path = PurePosixPath(name)
        if path.is_absolute() or ".." in name or "\\" in name:
            found.append(f"{name} leads out of the folder.")
        elif not REFUSED_FOLDERS.isdisjoint(path.parts) or any(
            part.startswith(".") for part in path.parts
        ):
            found.append(f"{name} is in a folder that is not accepted, or hidden.")
        if path.suffix.lower() in REFUSED_SUFFIXES:
            found.append(f"{name} is of a kind that is not accepted.")
        if not name.isascii():
            found.append(f"{name} has letters that some systems unpack as others.")
    if len({name.casefold() for name in names}) < len(names):
        found.append("Two files have one name where capitals do not count.")
    return found


def faults_of_metadata(text: str) -> list[str]:
    """Return what is wrong with metadata.txt, read as QGIS and the plugin site read it."""
    parser = configparser.ConfigParser()
    parser.optionxform = str  # type: ignore[assignment,method-assign]
    try:
        parser.read_string(text)
        entries = dict(parser.items("general"))
    except configparser.Error as error:
        return [f"metadata.txt cannot be read: {error}"]
    found = [
        f"metadata.txt has no {name}." for name in REQUIRED_ENTRIES if not entries.get(name, "")
    ]
    found += [
        f"{name} in metadata.txt is neither True nor False."
        for name in BOOLEAN_ENTRIES
        if entries.get(name, "False") not in ("True", "False")
    ]
    patterns = {
        "name": r"[A-Za-z0-9 _-]+",
        "author": "[^/]+",
        "email": r"[^@\s]+@[^@\s]+\.[a-z]+",
        "version": r"\d+\.\d+\.\d+",
        **dict.fromkeys(("qgisMinimumVersion", "qgisMaximumVersion"), r"\d+\.\d+"),
        **dict.fromkeys(("homepage", "tracker", "repository"), r"https://[^\s/]+/\S*"),
    }
    found += [
        f"{name} in metadata.txt cannot be {entries[name]!r}."
        for name, pattern in patterns.items()
        if entries.get(name) and not re.fullmatch(pattern, entries[name])
    ]
    # The site searches them, in English.
    found += [
        f"{name} in metadata.txt is not in plain letters."
        for name in ("name", "description", "about", "tags")
        if not entries.get(name, "").isascii()
    ]
    return found


def main() -> int:
    """Pack, check, and say what came out; 1 where the plugin site would refuse it."""
    version = re.search(r"^version=(.+)$", git("show", "HEAD:metadata.txt"), re.MULTILINE)[1]
    archive = ROOT / "build" / f"muysc-{version}.zip"
    archive.parent.mkdir(exist_ok=True)
    pack(archive)
    if git("status", "--porcelain"):
        print("What is not committed was left out.")
    found = faults(archive)
    for fault in found:
        print(fault, file=sys.stderr)
    content = archive.read_bytes()
    print(f"{archive.relative_to(ROOT)} ({len(content) / 1e6:.1f} MB)")
    print(f"sha256 {hashlib.sha256(content).hexdigest()}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
