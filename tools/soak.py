"""Run many radiographies in one process, and see whether it keeps its memory.

Needs QGIS; run as ``make soak``. The number of runs may be given.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from .declared import ROOT, load_provider
from .fuzzing.worker import Runner, offline_qgis

RUNS = 1000
#: Share of the runs until everything that is loaded once is loaded.
WARM = 0.1
#: What the later half of the others may hold more than the earlier (MiB), by fragments of
#: memory for one. Medians: what a single run holds goes up and down by twice as much.
ALLOWED_MIB = 10


def resident_mib() -> float:
    """Return the memory of this process."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def main() -> int:
    """Return 1 if memory grows."""
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else RUNS
    with tempfile.TemporaryDirectory() as folder:
        application = offline_qgis(Path(folder))
        runner = Runner(load_provider())
        case = {
            "algorithm": "radiography",
            "patience_s": 600,
            "parameters": {
                "DEM": str(ROOT / "tests" / "data" / "vesuvius_srtmgl1.tif"),
                "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
                "TARGET": "14.424745,40.823729 [EPSG:4326]",
                "AZIMUTH_PIXELS": 20,
                "ELEVATION_PIXELS": 20,
                "THICKNESS": f"{folder}/thickness.tif",
                "FLUX": f"{folder}/flux.tif",
                "FIELD_OF_VIEW": f"{folder}/view.gpkg",
            },
        }
        start, held = time.monotonic(), []
        for number in range(1, runs + 1):
            # A report now and then: drawing is what leaks most easily.
            case["parameters"].pop("REPORT", None)
            if number % 20 == 0:
                case["parameters"]["REPORT"] = f"{folder}/report.html"
            told = runner.run(case)
            if told["end"] != "done":
                print(told["sentence"])
                return 1
            if number > WARM * runs:
                held.append(resident_mib())
            if number % 100 == 0:
                seconds = (time.monotonic() - start) / number
                print(f"{number:5} runs, {seconds:.3f} s each, {resident_mib():.0f} MiB")
        grown = median(held[len(held) // 2 :]) - median(held[: len(held) // 2])
        del application
    print(
        f"{grown:+.1f} MiB from the earlier to the later half of the runs; "
        f"{ALLOWED_MIB} MiB are allowed."
    )
    # What QGIS tears down at the end is no part of this.
    sys.stdout.flush()
    os._exit(int(grown > ALLOWED_MIB))


if __name__ == "__main__":
    sys.exit(main())
