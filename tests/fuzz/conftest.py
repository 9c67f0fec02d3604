"""A process that runs hostile cases, and the files they are made of."""

import itertools
import os
import re
import shutil
import time
from pathlib import Path

import pytest

from tools.fuzzing.client import Client
from tools.fuzzing.scene import make_scene
from tools.fuzzing.verdict import OLDER, faults

try:
    from hypothesis import HealthCheck, Phase, given, seed, settings
except ImportError:
    # Only `make` brings it along.
    collect_ignore_glob = ["test_*.py"]

#: 0 runs the few examples of `make test`.
SECONDS = float(os.environ.get("FUZZ_SECONDS", "0"))
SEED = int(os.environ.get("FUZZ_SEED", "1"))
#: Examples at a time; a new seed follows until the time is over.
_ROUND = 25
_QUICK = 3
#: What differs between faults of one kind: numbers, paths, what is quoted.
_VARIES = re.compile(r"“[^”]*”|/\S+|[-+.\d]+")


@pytest.fixture(scope="session")
def fuzz_client(tmp_path_factory):
    client = Client(tmp_path_factory.mktemp("fuzz"))
    yield client
    client.stop()


@pytest.fixture(scope="session")
def scene(fuzz_client, tmp_path_factory):
    return make_scene(tmp_path_factory.mktemp("scene") / "inputs", fuzz_client)


@pytest.fixture(scope="session")
def changed_inputs(scene, tmp_path_factory):
    """Return which files of the scene are not as they were, and put them right again."""
    kept = shutil.copytree(scene.folder, tmp_path_factory.mktemp("kept") / "inputs")

    def states(folder):
        # QGIS keeps statistics of rasters beside them.
        found = [path for path in folder.rglob("*") if path.is_file() and path.suffix != ".xml"]
        return {
            str(path.relative_to(folder)): (path.stat().st_size, path.stat().st_mtime_ns)
            for path in found
        }

    before = states(kept)

    def changed():
        now = states(scene.folder)
        names = sorted({name for name, _ in now.items() ^ before.items()})
        for name in names:
            (scene.folder / name).unlink(missing_ok=True)
            if name in before:
                shutil.copy2(kept / name, scene.folder / name)
        return names

    return changed


@pytest.fixture(scope="session")
def cases_run():
    """The number of cases by test, told at the end of a long run."""
    counts = {}
    yield counts
    if SECONDS:
        print(f"\n{sum(counts.values())} cases: {counts}")


@pytest.fixture
def attempt(fuzz_client, tmp_path, cases_run, changed_inputs, request):
    """Run one case and fail if it ends in anything but results or a sentence."""
    numbers = itertools.count()

    def run(algorithm, parameters, older=False):
        folder = tmp_path / f"case_{next(numbers)}"
        folder.mkdir()
        placed = {
            name: str(folder / value[1:])
            if isinstance(value, str) and value.startswith("*")
            else value
            for name, value in parameters.items()
        }
        for value in placed.values() if older else ():
            if isinstance(value, str) and Path(value).parent == folder and Path(value).suffix:
                Path(value).write_bytes(OLDER)
        told = fuzz_client.run(algorithm, placed)
        cases_run[request.node.name] = cases_run.get(request.node.name, 0) + 1
        found = faults(placed, told, folder)
        found += [f"changed its input {name}" for name in changed_inputs()]
        shutil.rmtree(folder)
        assert not found, f"{algorithm} {placed} FAULTS: {'; '.join(found)}"
        return told

    return run


@pytest.fixture
def explore(request):
    """Draw examples of a strategy: a few, or as many as this test's share of the time holds."""

    def draw(strategy, case):
        share = SECONDS / max(1, sum("fuzz" in str(one.path) for one in request.session.items))
        end = time.monotonic() + share
        found = {}
        for number in itertools.count(SEED):
            _round(number, strategy, case, found)
            if time.monotonic() >= end:
                break
        assert not found, "\n\n".join([f"{len(found)} kinds of faults:", *found.values()])

    return draw


def _round(number, strategy, case, found):
    """Run some cases, and keep the shortest of each kind that fails."""

    @seed(number)
    @settings(
        max_examples=_ROUND if SECONDS else _QUICK,
        deadline=None,
        database=None,
        suppress_health_check=list(HealthCheck),
        # Cases are small; making them smaller takes longer than finding them.
        phases=[Phase.generate],
    )
    @given(strategy)
    def run(drawn):
        try:
            case(drawn)
        except AssertionError as error:
            said = str(error)
            kind = _VARIES.sub("", said.partition("FAULTS: ")[2])[-300:]
            found[kind] = min(found.get(kind, said), said, key=len)

    run()
