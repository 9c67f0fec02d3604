"""The zip that QGIS installs: everything it needs, nothing of the workshop."""

import io
import subprocess
import tarfile

import pytest

#: What may stand at the top of a release.
TOP = {
    "__init__.py", "metadata.txt", "icon.svg", "LICENSE", "README.md", "CHANGELOG.md",
    "docs", "i18n", "icons", "muysc_qgis", "processing_algorithms",
}  # fmt: skip
#: Kinds of files that the plugin site turns away.
REFUSED = {".so", ".dll", ".pyd", ".exe", ".sh", ".bat", ".pyc"}
LARGEST_MIB = 25


@pytest.fixture(scope="module")
def release(root, tmp_path_factory):
    done = subprocess.run(["git", "archive", "HEAD"], cwd=root, capture_output=True, check=False)
    if done.returncode != 0:
        pytest.skip("not a git checkout with a commit")
    folder = tmp_path_factory.mktemp("plugins") / "release"
    with tarfile.open(fileobj=io.BytesIO(done.stdout)) as archive:
        archive.extractall(folder)  # noqa: S202 - made here
    return folder


def test_the_workshop_is_left_out(release):
    assert {path.name for path in release.iterdir()} <= TOP
    assert not (release / "docs" / "development.md").exists()


def test_the_plugin_site_accepts_its_files(release):
    files = [path for path in release.rglob("*") if path.is_file()]
    assert not [path for path in files if path.suffix in REFUSED]
    assert sum(path.stat().st_size for path in files) < LARGEST_MIB * 2**20


def test_nothing_that_runs_is_missing(release, root, declared_by):
    listing = ["git", "ls-tree", "-r", "--name-only", "-z", "HEAD"]
    committed = subprocess.run(
        [*listing, "muysc_qgis", "processing_algorithms"],
        cwd=root,
        capture_output=True,
        text=True,
        check=True,
    ).stdout.split("\0")
    for name in filter(None, committed):
        assert (release / name).is_file(), name
    for name in ("__init__.py", "metadata.txt", "icon.svg", "icons/dock.svg", "LICENSE"):
        assert (release / name).is_file(), name
    assert "muysc:radiography" in declared_by(release)
