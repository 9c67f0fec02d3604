"""The scripts behind make: what they refuse, and that the demo shows everything."""

import os
import re
import shutil
import subprocess

import pytest

from tools import demo


@pytest.fixture
def machine(tmp_path, root):
    """Run the set-up of packages on a pretended machine."""

    def command(name, script):
        path = tmp_path / name
        path.write_text(f"#!/bin/bash\n{script}\n", encoding="utf-8")
        path.chmod(0o755)

    def set_up(kind, installed, user):
        command("dpkg-query", "\n".join(f"echo installed {name}" for name in installed))
        command("id", f"echo {user}")
        command("env", 'echo "$@" >>' + str(tmp_path / "called"))
        if not (tmp_path / "grep").exists():
            (tmp_path / "grep").symlink_to(shutil.which("grep"))
        done = subprocess.run(
            ["/bin/bash", root / "tools" / "debian_packages", kind],
            env={**os.environ, "PATH": str(tmp_path)},
            stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False,
        )  # fmt: skip
        called = tmp_path / "called"
        return done, called.read_text(encoding="utf-8") if called.exists() else ""

    return set_up


def test_without_root_one_sentence_names_what_is_missing(machine):
    done, called = machine("run", ["qgis", "python3-scipy"], user=1000)
    assert done.returncode != 0
    assert called == ""
    assert len(done.stderr.splitlines()) == 1
    assert "python3-matplotlib" in done.stderr
    assert "python3-scipy" not in done.stderr


def test_root_installs_what_is_missing_and_nothing_else(machine):
    done, called = machine("run", ["qgis", "python3-scipy"], user=0)
    assert done.returncode == 0, done.stderr
    update, install = called.splitlines()
    assert update.endswith(" update")
    assert "--no-install-recommends" in install
    assert " python3-matplotlib" in install
    assert " python3-scipy" not in install


def test_nothing_is_installed_where_nothing_is_missing(machine):
    told = machine("develop", [], user=1000)[0].stderr
    every = re.search(r"--no-install-recommends (.*);", told).group(1).split()
    assert "python3-pytest" in every
    done, called = machine("develop", every, user=0)
    assert (done.returncode, done.stdout, done.stderr, called) == (0, "", "", "")


def test_the_demo_shows_every_output_of_the_main_job(declared_by, root):
    radiography = declared_by(root)["muysc:radiography"]
    assert set(demo.FILES) == set(radiography["files"])
    numbers = {name for name, _, _ in demo.NUMBERS}
    assert numbers == set(radiography["outputs"]) - set(radiography["files"])
    assert set(demo.VIEW) <= set(radiography["parameters"])


def test_the_demo_fails_loudly_where_something_is_missing(tmp_path):
    (tmp_path / "empty.tif").touch()
    for name in ("missing.tif", "empty.tif"):
        with pytest.raises(demo.DemoError, match=name):
            demo.check_file(tmp_path / name)
    with pytest.raises(demo.DemoError, match="MAX_THICKNESS"):
        demo.print_numbers({"MAX_THICKNESS": None})
