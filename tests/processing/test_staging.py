"""Files that are moved to their destinations all or none, and what killed runs left."""

import errno
import os
import time

import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.staging import Staging

DAY_S = 86_400


@pytest.fixture(params=["hard links", "no hard links"])
def disk(request, monkeypatch):
    """A disk on which a file may have two names, and one on which it may not."""
    if request.param == "no hard links":

        def refuse(*arguments, **options):
            raise OSError(errno.EPERM, os.strerror(errno.EPERM))

        monkeypatch.setattr(os, "link", refuse)


def contents(folder):
    """Return what every file of a folder holds, by its name; None for a folder."""
    return {
        path.relative_to(folder).as_posix(): path.read_text() if path.is_file() else None
        for path in folder.rglob("*")
    }


def stage(staging, *destinations):
    for destination in destinations:
        staging.add(destination).write_text("new")


@pytest.mark.usefixtures("disk")
def test_all_are_replaced_and_nothing_else_is_left(tmp_path):
    for name in ("a.tif", "b.gpkg", "b.gpkg-wal"):
        (tmp_path / name).write_text("old")
    with Staging() as staging:
        stage(staging, tmp_path / "a.tif", tmp_path / "made" / "c.csv")
        staging.add_layer(tmp_path / "b.gpkg").write_text("new")
        staging.commit()
    assert contents(tmp_path) == {
        "a.tif": "new",
        "b.gpkg": "new",
        "made": None,
        "made/c.csv": "new",
    }


@pytest.mark.usefixtures("disk")
def test_one_that_cannot_be_moved_leaves_all_as_they_were(tmp_path):
    """A folder has taken the place of the last file, so that no file can be moved there."""
    for name in ("a.tif", "b.gpkg", "b.gpkg-wal"):
        (tmp_path / name).write_text("old")
    earlier = contents(tmp_path)
    last = tmp_path / "last.png"
    with Staging() as staging:
        stage(staging, tmp_path / "a.tif", tmp_path / "new.csv")
        stage(staging, tmp_path / "made" / "too" / "c.csv")
        staging.add_layer(tmp_path / "b.gpkg").write_text("new")
        stage(staging, last)
        last.mkdir()
        with pytest.raises(MuyscError) as failure:
            staging.commit()
    assert str(last) in str(failure.value)
    assert str(failure.value).endswith("close whatever holds it open or choose another place.")
    assert contents(tmp_path) == {**earlier, "last.png": None}


def test_a_link_is_put_back_as_a_link(tmp_path):
    elsewhere = tmp_path / "elsewhere.tif"
    link = tmp_path / "a.tif"
    link.symlink_to(elsewhere)
    last = tmp_path / "last.png"
    with Staging() as staging:
        stage(staging, link, last)
        last.mkdir()
        with pytest.raises(MuyscError):
            staging.commit()
    assert os.readlink(link) == str(elsewhere)
    assert not elsewhere.exists()


@pytest.fixture
def killed(tmp_path):
    """Leave what a run that is killed leaves, so many seconds old; return the folder."""

    def run(age_s):
        staging = Staging()
        stage(staging, tmp_path / "a [1].tif", tmp_path / "other.tif")
        staging.add_layer(tmp_path / "a [1].shp").write_text("new")
        then = time.time() - age_s
        for path in tmp_path.iterdir():
            os.utime(path, (then, then))
        return tmp_path

    return run


def test_what_a_killed_run_left_is_cleared_after_a_day(killed):
    folder = killed(age_s=DAY_S + 60)
    assert len(list(folder.iterdir())) == 3
    with Staging() as staging:
        stage(staging, folder / "a [1].tif")
        staging.commit()
    left = sorted(path.name for path in folder.iterdir())
    assert left[1:] == ["a [1].tif"]
    assert left[0].startswith(".other.")


def test_what_is_younger_may_be_in_use(killed):
    folder = killed(age_s=DAY_S - 600)
    before = set(folder.iterdir())
    with Staging() as staging:
        stage(staging, folder / "a [1].tif")
        staging.commit()
    assert set(folder.iterdir()) == before | {folder / "a [1].tif"}
