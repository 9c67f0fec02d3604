"""Run the test suite on every supported QGIS, and write a table of the results.

Each QGIS is that of a Debian system in a folder of its own below build/matrix, which is
made once and kept. Tested is the last commit; what is left on the line goes to pytest::

    /usr/bin/python3 tools/matrix.py [--only SYSTEM] [tests/processing -k drape]

Needs root, debootstrap and git.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "build" / "matrix"
TABLE = FOLDER / "table.md"
#: Within a system: the checkout, a Python with the development tools, and what a run writes.
CHECKOUT = Path("/root/muysc")
VENV = Path("/root/venv")
PYTHON = VENV / "bin" / "python"
VERSIONS = Path("/root/versions.json")
REPORT = Path("/root/report.xml")
#: How this machine reaches a network, wanted in the systems too.
NETWORK_FILES = (Path("/etc/hosts"), Path("/etc/resolv.conf"))
NETWORK_VARIABLES = ("http_proxy", "https_proxy", "no_proxy", "PIP_INDEX_URL")
AUTHORITIES = Path("/etc/ssl/certs/ca-certificates.crt")
#: A mirror may lag behind by more than an archive is valid for.
APT = 'Acquire::Check-Valid-Until "false";\nAPT::Keep-Downloaded-Packages "false";\n'

_WRITE_VERSIONS = """
import json, platform, sys
import matplotlib, numpy, scipy
from osgeo import gdal
from qgis.core import Qgis
from qgis.PyQt.QtCore import QT_VERSION_STR
json.dump({
    "QGIS": Qgis.QGIS_VERSION.partition("-")[0],
    "Qt": QT_VERSION_STR,
    "Python": platform.python_version(),
    "numpy": numpy.__version__,
    "scipy": scipy.__version__,
    "matplotlib": matplotlib.__version__,
    "GDAL": gdal.__version__,
}, open(sys.argv[1], "w"))
"""


class MatrixError(Exception):
    """Something kept the tests from running; the message says what."""


@dataclass(frozen=True)
class System:
    """A Debian, with the QGIS of its own or of a suite that it may add."""

    name: str
    suite: str
    newer_qgis: str | None = None

    @property
    def folder(self) -> Path:
        """Where the system's root is."""
        return FOLDER / self.name

    def outside(self, path: Path) -> Path:
        """Return where a path within the system is for this machine."""
        return self.folder / path.relative_to("/")

    @property
    def log(self) -> Path:
        """What was printed while it was set up and tested."""
        return FOLDER / f"{self.name}.log"


#: QGIS 3.22, 3.40 and 3.44.
SYSTEMS = (
    System("bookworm", "bookworm"),
    System("bookworm-backports", "bookworm", newer_qgis="bookworm-backports"),
    System("sid", "sid"),
)


@dataclass(frozen=True)
class Result:
    """One line of the table, and the remarks for below it."""

    system: str
    columns: dict[str, str | int]
    remarks: list[str]


def check_machine() -> None:
    """Refuse a machine that cannot make systems."""
    if os.geteuid() != 0:
        raise MatrixError("Only root can make Debian systems in folders; run this with sudo.")
    missing = [name for name in ("debootstrap", "git", "unshare") if shutil.which(name) is None]
    if missing:
        raise MatrixError(f"Missing is {', '.join(missing)}; install it with apt-get.")


def mirror() -> str:
    """Return where this machine gets Debian's packages from."""
    done = subprocess.run(
        ["/usr/bin/apt-get", "indextargets", "--format", "$(REPO_URI)", "Label: Debian"],
        capture_output=True,
        text=True,
        check=False,
    )
    if not done.stdout.split():
        raise MatrixError("The settings of apt name no archive of Debian to install from.")
    return done.stdout.split()[0]


def execute(command: list[str], log: Path, environment: dict[str, str] | None = None) -> int:
    """Run a command whose output is added to a log."""
    with log.open("a", encoding="utf-8") as lines:
        lines.write(f"\n$ {' '.join(command)}\n")
        lines.flush()
        done = subprocess.run(  # noqa: S603
            command,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=lines,
            stderr=subprocess.STDOUT,
            check=False,
        )
    return done.returncode


def need(code: int, what: str, log: Path) -> None:
    """Refuse to go on after a command that failed."""
    if code != 0:
        raise MatrixError(f"{what} failed with {code}; see {log.relative_to(ROOT)}.")


def inside(system: System, *command: str | Path) -> int:
    """Run a command in a system; its processes and mounts end with it."""
    enter = [
        *("unshare", "--fork", "--pid", "--kill-child"),
        *("--mount", f"--mount-proc={system.folder / 'proc'}"),
        *("chroot", str(system.folder), "env", f"--chdir={CHECKOUT}"),
    ]
    environment = {
        **{name: os.environ[name] for name in NETWORK_VARIABLES if name in os.environ},
        "PATH": "/usr/sbin:/usr/bin:/sbin:/bin",
        "HOME": "/root",
        "LC_ALL": "C.UTF-8",
        "QT_QPA_PLATFORM": "offscreen",
        "PIP_CERT": str(AUTHORITIES),
        "PIP_ROOT_USER_ACTION": "ignore",
    }
    return execute([*enter, *map(str, command)], system.log, environment)


def make_system(system: System) -> None:
    """Make the folder of a system, unless an earlier run did."""
    unfinished = system.folder / "debootstrap"
    if system.folder.is_dir() and not unfinished.exists():
        return
    shutil.rmtree(system.folder, ignore_errors=True)
    print("  making the system, which takes some minutes …", flush=True)
    command = ["debootstrap", "--variant=minbase", system.suite, str(system.folder), mirror()]
    need(execute(command, system.log), "debootstrap", system.log)


def configure(system: System) -> None:
    """Tell a system where packages come from, and give it this machine's network."""
    for file in NETWORK_FILES:
        shutil.copy(file, system.outside(file))
    apt = system.folder / "etc" / "apt"
    (apt / "apt.conf.d" / "matrix").write_text(APT, encoding="utf-8")
    suites = [system.suite, *filter(None, [system.newer_qgis])]
    lines = [f"deb {mirror()} {suite} main\n" for suite in suites]
    (apt / "sources.list").write_text("".join(lines), encoding="utf-8")
    if system.newer_qgis:
        pin = f"Package: src:qgis\nPin: release n={system.newer_qgis}\nPin-Priority: 990\n"
        (apt / "preferences.d" / "qgis").write_text(pin, encoding="utf-8")


def check_out(system: System) -> None:
    """Put the last commit into a system."""
    checkout = system.outside(CHECKOUT)
    shutil.rmtree(checkout, ignore_errors=True)
    command = ["git", "clone", "--quiet", str(ROOT), str(checkout)]
    need(execute(command, system.log), "git clone", system.log)


def install(system: System) -> list[str]:
    """Install what the tests need, and return the development tools that cannot be had."""
    need(inside(system, "tools/debian_packages", "develop"), "Installing packages", system.log)
    # The system's own authorities may not know those of a local network.
    if AUTHORITIES.exists():
        shutil.copy(AUTHORITIES, system.outside(AUTHORITIES))
    make = ("/usr/bin/python3", "-m", "venv", "--system-site-packages", VENV)
    need(inside(system, *make), "Making a virtual environment", system.log)
    lines = (ROOT / "tools" / "requirements.txt").read_text(encoding="utf-8").splitlines()
    tools = [line for line in lines if line and not line.startswith("#")]
    pip = (PYTHON, "-m", "pip", "install", "--quiet", "--only-binary", ":all:")
    return [tool for tool in tools if inside(system, *pip, tool) != 0]


def results_of(report: Path) -> tuple[dict[str, int], list[str]]:
    """Return the counts in pytest's report, and the names of the tests that failed."""
    cases = list(ElementTree.parse(report).iter("testcase"))  # noqa: S314 - written by pytest
    failed = [
        f"{case.get('classname')}::{case.get('name')}"
        for case in cases
        if case.find("failure") is not None or case.find("error") is not None
    ]
    skipped = sum(case.find("skipped") is not None for case in cases)
    counts = {
        "passed": len(cases) - len(failed) - skipped,
        "failed": len(failed),
        "skipped": skipped,
    }
    return counts, failed


def test(system: System, pytest_arguments: list[str]) -> Result:
    """Run the tests of the last commit in a system, and read what came out."""
    print(f"{system.name}:", flush=True)
    system.log.unlink(missing_ok=True)
    make_system(system)
    configure(system)
    check_out(system)
    print("  installing what is missing …", flush=True)
    remarks = [f"{tool} cannot be installed here." for tool in install(system)]
    ask = inside(system, PYTHON, "-c", _WRITE_VERSIONS, VERSIONS)
    need(ask, "Asking for versions", system.log)
    versions = json.loads(system.outside(VERSIONS).read_text(encoding="utf-8"))
    print(f"  running the tests, told in {system.log.relative_to(ROOT)} …", flush=True)
    report = system.outside(REPORT)
    report.unlink(missing_ok=True)
    code = inside(system, PYTHON, "-m", "pytest", f"--junit-xml={REPORT}", *pytest_arguments)
    if not report.exists():
        raise MatrixError(f"pytest ended with {code} and no report; see {system.log}.")
    counts, failed = results_of(report)
    print("  " + ", ".join(f"{count} {what}" for what, count in counts.items()), flush=True)
    return Result(
        system.name,
        {**versions, **counts},
        [*remarks, *(f"{name} failed." for name in failed)],
    )


def table_of(results: list[Result]) -> str:
    """Return the results as a table with remarks below, in Markdown."""
    columns = list(results[0].columns)
    rows = [
        ["System", *columns],
        ["---"] * (len(columns) + 1),
        *([result.system, *map(str, result.columns.values())] for result in results),
    ]
    lines = [f"| {' | '.join(row)} |" for row in rows]
    remarks = [f"- {one.system}: {remark}" for one in results for remark in one.remarks]
    return "\n".join([*lines, "", *remarks]).rstrip() + "\n"


def main(arguments: list[str]) -> int:
    """Test the systems asked for, one after the other, and show the table."""
    names = [system.name for system in SYSTEMS]
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--only", action="append", choices=names, help="run on this system alone")
    chosen, pytest_arguments = parser.parse_known_args(arguments)
    check_machine()
    FOLDER.mkdir(parents=True, exist_ok=True)
    results, complete = [], True
    for system in SYSTEMS:
        if system.name in (chosen.only or names):
            try:
                results.append(test(system, pytest_arguments))
            except MatrixError as error:
                # The other systems have their say all the same.
                print(f"  {error}", flush=True)
                complete = False
    if not results:
        return 1
    table = table_of(results)
    TABLE.write_text(table, encoding="utf-8")
    print(f"\n{table}\nWritten to {TABLE.relative_to(ROOT)}.")
    return 0 if complete and not any(result.columns["failed"] for result in results) else 1


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except MatrixError as error:
        sys.exit(str(error))
