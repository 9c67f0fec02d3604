"""Simulate a muogram of Vesuvius as a user would from a shell, and check what comes out.

Needs QGIS and nothing else; writes to build/demo::

    /usr/bin/python3 tools/demo.py
"""

from __future__ import annotations

import json
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OUTPUT = ROOT / "build" / "demo"
DEM = ROOT / "tests" / "data" / "vesuvius_srtmgl1.tif"
#: The package name of the plugin is its folder's name, which must be an identifier.
PLUGIN = "muysc"
#: Matplotlib's list of fonts, which takes seconds to make, outlives the profile.
FONT_CACHE = ROOT / "build" / "matplotlib"

#: Casina Amelia, 1.9 km south-west of the rim of the Gran Cono that it looks at.
VIEW = {
    "DEM": DEM,
    "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
    "TARGET": "14.424745,40.823729 [EPSG:4326]",
    "AZIMUTH_APERTURE": 42,
    "ELEVATION_APERTURE": 22,
    "AZIMUTH_PIXELS": 100,
    "ELEVATION_PIXELS": 100,
}
FILES = {
    "THICKNESS": "thickness.tif",
    "THICKNESS_ERROR": "thickness_error.tif",
    "OPACITY": "opacity.tif",
    "MINIMUM_ENERGY": "minimum_energy.tif",
    "FLUX": "flux.tif",
    "FLUX_MINIMUM": "flux_minimum.tif",
    "FLUX_MAXIMUM": "flux_maximum.tif",
    "OPEN_SKY": "open_sky.tif",
    "TRANSMISSION": "transmission.tif",
    "EXPOSURE": "exposure.tif",
    "DISTANCE": "distance.tif",
    "FIELD_OF_VIEW": "field_of_view.gpkg",
    "PANEL": "panel.png",
    "REPORT": "report.html",
}
#: Name in the results, what it is, format with unit.
NUMBERS = (
    ("MAX_THICKNESS", "Largest rock thickness", "{:.0f} m"),
    ("DETECTOR_ELEVATION", "Detector elevation", "{:.0f} m"),
    ("BORESIGHT_AZIMUTH", "Boresight azimuth", "{:.2f} °"),
    ("BORESIGHT_ELEVATION", "Boresight elevation", "{:.2f} °"),
    ("TARGET_DISTANCE", "Distance to the target", "{:.0f} m"),
    ("ROCK_PIXELS", "Pixels with rock", "{:.0f}"),
    ("UNKNOWN_PIXELS", "Pixels without a flux", "{:.0f}"),
    ("MEDIAN_EXPOSURE", "Median exposure behind rock", "{:.1f} days"),
)
#: Variables that would give QGIS the libraries of another Python.
_FOREIGN = ("PYTHONHOME", "PYTHONPATH")


class DemoError(Exception):
    """Something did not come out as it must; the message says what."""


class QgisProcess:
    """Runs QGIS's command line in a throw-away profile that sees this checkout."""

    def __init__(self, profile: Path) -> None:
        # The wrapper of Debian 12 adds an option that its own program refuses.
        program = shutil.which("qgis_process.bin") or shutil.which("qgis_process")
        if program is None:
            raise DemoError("qgis_process is not on PATH; install QGIS 3.22 or later.")
        self.program = program
        plugins = profile / "plugins"
        plugins.mkdir()
        (plugins / PLUGIN).symlink_to(ROOT)
        FONT_CACHE.mkdir(parents=True, exist_ok=True)
        self.environment = {
            **{name: value for name, value in os.environ.items() if name not in _FOREIGN},
            # QGIS looks for the home of its Python along PATH, where another may come first.
            "PATH": f"/usr/bin:/bin:{os.environ.get('PATH', '')}",
            "HOME": str(profile),
            "XDG_RUNTIME_DIR": str(profile),
            "QGIS_CUSTOM_CONFIG_PATH": str(profile),
            "QGIS_PLUGINPATH": str(plugins),
            "MPLCONFIGDIR": str(FONT_CACHE),
            "QT_QPA_PLATFORM": "offscreen",
            "LC_ALL": "C.UTF-8",
            # What QGIS itself warns about says nothing about the demo.
            "PYTHONWARNINGS": "ignore",
        }

    def __call__(self, *arguments: str) -> str:
        """Return what the command prints; a failure is shown in full."""
        done = subprocess.run(  # noqa: S603
            [self.program, *arguments],
            env=self.environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )
        if done.returncode != 0:
            raise DemoError(
                f"{done.stdout}{done.stderr}\n{Path(self.program).name} "
                f"{' '.join(arguments[:3])} … ended with {done.returncode}."
            )
        return done.stdout

    def run(self, algorithm: str, parameters: dict[str, object]) -> dict[str, object]:
        """Run an algorithm, show the command as one would type it, return its results."""
        words = [f"--{name}={value}" for name, value in parameters.items()]
        print(f"\nqgis_process run {algorithm}")
        for word in words:
            print("   ", shlex.quote(word.replace(f"{ROOT}/", "")))
        start = time.monotonic()
        answer = json.loads(self("--json", "run", algorithm, *words))
        print(f"  … {time.monotonic() - start:.1f} s")
        for warning in answer.get("log", {}).get("warnings", []):
            print(f"  warning: {warning}")
        return answer["results"]


def check_file(path: Path) -> None:
    """Refuse an output that is missing or empty."""
    if not path.is_file() or path.stat().st_size == 0:
        raise DemoError(f"The output {path} was not written.")


def print_numbers(results: dict[str, object]) -> None:
    """Print the main numbers with their units."""
    print()
    for name, title, form in NUMBERS:
        if not isinstance(results.get(name), (int, float)):
            raise DemoError(f"The number {name} is missing in the results: {results}.")
        print(f"  {title:<28} {form.format(results[name]):>12}")


def demo() -> None:
    """Radiograph Vesuvius, drape the flux on it, say what came out."""
    shutil.rmtree(OUTPUT, ignore_errors=True)
    OUTPUT.mkdir(parents=True)
    with tempfile.TemporaryDirectory(prefix="muysc-demo-") as profile:
        qgis_process = QgisProcess(Path(profile))
        qgis_process("plugins", "enable", PLUGIN)
        files = {name: OUTPUT / file for name, file in FILES.items()}
        results = qgis_process.run("muysc:radiography", {**VIEW, **files})
        draped = OUTPUT / "draped_flux.tif"
        qgis_process.run("muysc:drape", {"MUOGRAM": files["FLUX"], "DEM": DEM, "OUTPUT": draped})
    print_numbers(results)
    print(f"\nWritten to {OUTPUT.relative_to(ROOT)}:")
    for path in (*files.values(), draped):
        check_file(path)
        print(f"  {path.name:<20} {path.stat().st_size / 1024:8.0f} KiB")


if __name__ == "__main__":
    try:
        demo()
    except DemoError as error:
        sys.exit(f"{error}")
