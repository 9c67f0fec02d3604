"""The zip that QGIS installs: everything it needs, nothing of the workshop, always the same."""

import os
import re
import subprocess
import sys
import zipfile

import pytest

from tools import package

#: What may stand at the top of a release.
TOP = {
    "__init__.py", "metadata.txt", "icon.svg", "LICENSE", "README.md", "CHANGELOG.md",
    "CITATION.cff", "docs", "i18n", "icons", "muysc_qgis", "processing_algorithms",
}  # fmt: skip


@pytest.fixture(scope="module")
def commit(tracked):
    assert tracked
    return package.git("rev-parse", "HEAD").strip()


@pytest.fixture(scope="module")
def archive(commit, tmp_path_factory):
    path = tmp_path_factory.mktemp("release") / "muysc.zip"
    package.pack(path, commit)
    return path


@pytest.fixture(scope="module")
def release(archive, tmp_path_factory):
    folder = tmp_path_factory.mktemp("plugins")
    with zipfile.ZipFile(archive) as content:
        content.extractall(folder)
    return folder / "muysc"


def test_the_workshop_is_left_out(release):
    assert {path.name for path in release.iterdir()} <= TOP
    assert not (release / "docs" / "development.md").exists()


def test_the_plugin_site_accepts_it(archive):
    assert package.faults(archive) == []


def test_nothing_that_runs_is_missing(release, commit, declared_by):
    rooms = ("muysc_qgis", "processing_algorithms", "icons", "i18n", "docs/reference")
    committed = package.git("ls-tree", "-r", "--name-only", "-z", commit, *rooms)
    for name in filter(None, committed.split("\0")):
        assert (release / name).is_file(), name
    for name in ("__init__.py", "metadata.txt", "icon.svg", "i18n/muysc_es.qm", "LICENSE"):
        assert (release / name).is_file(), name
    assert "muysc:radiography" in declared_by(release)


def test_its_documents_point_at_nothing_that_was_left_out(release):
    for document in (release / "README.md", *release.glob("docs/*.md")):
        text = document.read_text(encoding="utf-8")
        for target in re.findall(r"\]\((?!https?:|#)([^)#]+)", text):
            assert (document.parent / target).exists(), f"{target} in {document.name}"


@pytest.mark.parametrize(
    ("umask", "changes"),
    [
        (0o022, {"TZ": "Asia/Tokyo"}),
        (0o077, {"TZ": "America/Bogota"}),
        (0o002, {"GIT_CONFIG_COUNT": "1", "GIT_CONFIG_KEY_0": "core.autocrlf",
                 "GIT_CONFIG_VALUE_0": "true"}),
    ],
)  # fmt: skip
def test_a_commit_gives_the_same_bytes_everywhere(commit, archive, tmp_path, umask, changes):
    code = "import os, runpy, sys, pathlib; os.umask(int(sys.argv[1]))\n"
    code += "runpy.run_path(sys.argv[2])['pack'](pathlib.Path(sys.argv[3]), sys.argv[4])"
    again = tmp_path / "again.zip"
    subprocess.run(
        [sys.executable, "-c", code, str(umask), package.__file__, str(again), commit],
        env={**os.environ, **changes},
        check=True,
    )
    assert again.read_bytes() == archive.read_bytes()


def test_its_times_are_the_commit_s_so_that_the_day_does_not_count(archive, commit):
    form = ("--no-patch", "--format=%cd", "--date=format-local:%Y %m %d %H %M")
    stated = package.git("show", *form, commit)
    with zipfile.ZipFile(archive) as content:
        times = {entry.date_time[:5] for entry in content.infolist()}
    assert times == {tuple(map(int, stated.split()))}


METADATA = """[general]
name=Some plugin
description=One
about=Two
version=1.2.3
qgisMinimumVersion=3.22
author=Somebody
email=somebody@example.org
tracker=https://example.org/issues
repository=https://example.org/code
homepage=https://example.org/
"""


def zip_of(path, changes=()):
    """Write a small plugin, with some files changed, added or (None) left out."""
    files = {
        "some/__init__.py": b"", "some/metadata.txt": METADATA.encode(), "some/LICENSE": b"GPL",
        **dict(changes),
    }  # fmt: skip
    with zipfile.ZipFile(path, "w") as content:
        for name, data in files.items():
            if data is not None:
                content.writestr(name, data)
    return path


def test_a_small_plugin_has_no_fault(tmp_path):
    assert package.faults(zip_of(tmp_path / "some.zip")) == []


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"some/LICENSE": None}, "LICENSE is missing"),
        ({"some/__init__.py": None}, "__init__.py is missing"),
        ({"other/file.txt": b""}, "more than one folder"),
        ({"some/run.sh": b""}, "run.sh is of a kind"),
        ({"some/library.so": b""}, "library.so is of a kind"),
        ({"some/tool": b"\x7fELF\x02"}, "tool is a program"),
        ({"some/__pycache__/a.txt": b""}, "not accepted, or hidden"),
        ({"some/.hidden": b""}, "not accepted, or hidden"),
        ({"some/../outside.txt": b""}, "leads out"),
        ({"some/volcán.txt": b""}, "letters"),
        ({"some/license": b""}, "capitals"),
        ({"some/metadata.txt": b"no section"}, "cannot be read"),
        ({"some/metadata.txt": METADATA.replace("tracker=", "x=").encode()}, "has no tracker"),
        ({"some/metadata.txt": (METADATA + "server=no").encode()}, "neither True nor False"),
        ({"some/metadata.txt": METADATA.replace("3.22", "3").encode()}, "qgisMinimumVersion"),
        ({"some/metadata.txt": METADATA.replace("Two", "50 %").encode()}, "cannot be read"),
    ],
)
def test_what_the_plugin_site_refuses_is_found(tmp_path, changes, words):
    found = package.faults(zip_of(tmp_path / "some.zip", changes))
    assert len(found) == 1
    assert words in found[0]


def test_a_package_name_is_an_identifier():
    assert package.faults_of_names(["some-name/__init__.py"])
    assert package.faults_of_names(["1name/__init__.py"])
    assert package.faults_of_names(["muysc/__init__.py"]) == []


def test_a_zip_that_is_too_large_is_found(tmp_path, monkeypatch):
    monkeypatch.setattr(package, "LARGEST_BYTES", 100)
    assert "at most 100" in package.faults(zip_of(tmp_path / "some.zip"))[0]
