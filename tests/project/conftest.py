"""What the checks of the project share: where it is, and what QGIS sees of it."""

import functools
import json
import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent

#: Loads the plugin as QGIS does, in a process of its own because an application
#: cannot be started twice, and prints what it declares.
_DECLARE = """
import importlib.util, json, sys
from qgis.core import QgsApplication
root, profile = sys.argv[1:]
application = QgsApplication([], False, profile)
application.initQgis()
spec = importlib.util.spec_from_file_location(
    "any_name", root + "/__init__.py", submodule_search_locations=[root]
)
package = sys.modules["any_name"] = importlib.util.module_from_spec(spec)
spec.loader.exec_module(package)
plugin = package.classFactory(None)
plugin.initProcessing()
print(json.dumps({
    algorithm.id(): {
        "parameters": [
            one.name() for one in algorithm.parameterDefinitions() if not one.isDestination()
        ],
        "files": [one.name() for one in algorithm.destinationParameterDefinitions()],
        "outputs": [one.name() for one in algorithm.outputDefinitions()],
        "words": {
            one.name(): one.options()
            for one in algorithm.parameterDefinitions()
            if hasattr(one, "options")
        },
    }
    for algorithm in plugin.provider.algorithms()
}))
plugin.unload()
"""


@pytest.fixture(scope="session")
def root():
    return ROOT


@pytest.fixture(scope="session")
def declared_by(tmp_path_factory):
    """Return what the plugin in a folder declares, by algorithm."""

    @functools.lru_cache
    def declare(folder):
        profile = tmp_path_factory.mktemp("profile")
        done = subprocess.run(
            ["/usr/bin/python3", "-c", _DECLARE, str(folder), str(profile)],
            env={
                **os.environ,
                "HOME": str(profile),
                "QGIS_CUSTOM_CONFIG_PATH": str(profile),
                "QT_QPA_PLATFORM": "offscreen",
            },
            capture_output=True,
            text=True,
            check=False,
        )
        lines = done.stdout.splitlines()
        assert lines, done.stderr
        return json.loads(lines[-1])

    return declare


@pytest.fixture(scope="session")
def tracked(root):
    """Return the files under version control, relative to the root."""
    done = subprocess.run(
        ["git", "ls-files", "-z"], cwd=root, capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        pytest.skip("not a git checkout")
    return [Path(name) for name in done.stdout.split("\0") if name and (root / name).is_file()]
