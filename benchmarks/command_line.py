"""What a run from the shell costs above starting QGIS, and what loading the provider costs."""

from __future__ import annotations

import os
import statistics
import tempfile
import time
from pathlib import Path

from measure import Row, in_fresh_process, print_table

from tools.demo import FILES, VIEW, QgisProcess

#: Runs of each kind; the medians are compared.
_RUNS = 5

_LOAD = """
import importlib.util, os, sys, time
from qgis.core import QgsApplication
application = QgsApplication([], False)
application.initQgis()
sys.path.append(os.path.join(application.pkgDataPath(), "python", "plugins"))
from processing.core.Processing import Processing
Processing.initialize()
start = time.perf_counter()
spec = importlib.util.spec_from_file_location(
    "muysc", ROOT + "/__init__.py", submodule_search_locations=[ROOT]
)
package = sys.modules["muysc"] = importlib.util.module_from_spec(spec)
spec.loader.exec_module(package)
package.classFactory(None).initProcessing()
print(time.perf_counter() - start, flush=True)
os._exit(0)
"""


def main() -> None:
    # Users' machines keep the compiled modules; some development machines are told not to.
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    with tempfile.TemporaryDirectory() as folder:
        profile = Path(folder)
        (profile / "out").mkdir()
        process = QgisProcess(profile)
        process("plugins", "enable", "muysc")
        outputs = {name: profile / "out" / file for name, file in FILES.items()}
        rasters = {name: outputs[name] for name in ("THICKNESS", "FLUX")}
        commands = {
            "starting QGIS (help of the algorithm)": ("help", "muysc:radiography"),
            "radiography, thickness and flux": ("run", "muysc:radiography", *_words(rasters)),
            "radiography, every raster, panel, report, field of view": (
                "run", "muysc:radiography", *_words(outputs),
            ),
        }  # fmt: skip
        times: dict[str, list[float]] = {name: [] for name in commands}
        # In turn, so that a machine that slows down slows all of them.
        for _ in range(_RUNS):
            for name, words in commands.items():
                start = time.perf_counter()
                process(*words)
                times[name].append(time.perf_counter() - start)
    medians = {name: statistics.median(values) for name, values in times.items()}
    base = medians["starting QGIS (help of the algorithm)"]
    rows = [Row(name, value, f"{value - base:+.2f} s") for name, value in medians.items()]
    print_table("qgis_process, 100 × 100 pixels (limit +1.5 s)", rows)

    root = repr(str(Path(__file__).resolve().parent.parent))
    loads = [float(in_fresh_process(f"ROOT = {root}\n{_LOAD}")[-1]) for _ in range(_RUNS)]
    print_table("Loading the provider", [Row("all algorithms", statistics.median(loads),
                "limit 0.2 s")])  # fmt: skip


def _words(outputs: dict[str, Path]) -> list[str]:
    return [f"--{name}={value}" for name, value in {**VIEW, **outputs}.items()]


if __name__ == "__main__":
    main()
