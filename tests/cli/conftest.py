"""The command line as users have it: qgis_process in a throw-away profile."""

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
#: Debian 12's wrapper adds an option that qgis_process does not know.
COMMAND = shutil.which("qgis_process.bin") or shutil.which("qgis_process")


@dataclass
class QgisProcess:
    """Runs qgis_process with the plugin enabled."""

    environment: dict
    command: str = COMMAND

    def __call__(self, *arguments):
        return subprocess.run(
            [self.command, *map(str, arguments)],
            env=self.environment,
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
        )

    def run(self, algorithm, parameters):
        return self(
            "run",
            f"muysc:{algorithm}",
            *(f"--{name}={value}" for name, value in parameters.items()),
        )


@pytest.fixture(scope="session")
def qgis_process(tmp_path_factory):
    if COMMAND is None:
        pytest.fail("qgis_process is missing; install QGIS")
    home = tmp_path_factory.mktemp("home")
    plugins = tmp_path_factory.mktemp("plugins")
    # Any identifier will do as the folder's name.
    (plugins / "any_folder_name").symlink_to(ROOT)
    environment = {
        **os.environ,
        "HOME": str(home),
        "XDG_RUNTIME_DIR": str(home),
        "QGIS_CUSTOM_CONFIG_PATH": str(home / "profile"),
        "QGIS_PLUGINPATH": str(plugins),
        "QT_QPA_PLATFORM": "offscreen",
        "LC_ALL": "C.UTF-8",
    }
    process = QgisProcess(environment)
    enabled = process("plugins", "enable", "any_folder_name")
    assert enabled.returncode == 0, enabled.stdout + enabled.stderr
    return process
