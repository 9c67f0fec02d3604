"""Time and memory of a survey of many candidates on Vesuvius, with local workers.

Run with ``make bench``, or with numbers of candidates: ``python benchmarks/siteselection.py 1000``.
"""

from __future__ import annotations

import os
import resource
import sys
import tempfile
import threading
import time
from pathlib import Path

import numpy as np

from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.survey.candidates import Limits, find_candidates
from muysc_qgis.survey.map_grid import grid_around
from muysc_qgis.survey.run import default_workers
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.workflows.simulation import Telescope
from muysc_qgis.workflows.site_assessment import SurveyPlan
from muysc_qgis.workflows.site_selection import Wanted, select_sites
from muysc_qgis.workflows.view_settings import ViewSettings

ROOT = Path(__file__).resolve().parent.parent
DEM = ROOT / "tests" / "data" / "vesuvius_srtmgl1.tif"
TARGET = (14.424745, 40.823729)
RADIUS_M = 4000.0
#: Time grows in proportion, so that these tell that of 10 000.
COUNTS = (250, 1000)


class Memory:
    """Largest sum of the private and shared memory of this process and its workers."""

    def __init__(self) -> None:
        self.peak = 0
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._watch, daemon=True)

    def __enter__(self) -> Memory:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._stop.set()
        self._thread.join()

    def _watch(self) -> None:
        while not self._stop.wait(0.2):
            total = 0
            for process in [os.getpid(), *_children(os.getpid())]:
                try:
                    lines = Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
                except OSError:
                    continue
                # Proportional: shared pages count once in all.
                total += sum(int(line.split()[1]) for line in lines if line.startswith("Pss:"))
            self.peak = max(self.peak, total * 1024)


def _children(parent: int) -> list[int]:
    found = []
    for task in Path(f"/proc/{parent}/task").iterdir():
        try:
            found += [int(one) for one in (task / "children").read_text().split()]
        except OSError:
            continue
    return found


def main(counts: tuple[int, ...]) -> None:
    dem = open_dem(DEM)
    plan = SurveyPlan(
        dem, TARGET, 0.0, 1.0, ViewSettings(Aperture(60, 30, 64, 64), Physics(), Telescope())
    )
    print(f"Survey of Vesuvius, 64 × 64 rays, {default_workers()} worker processes")
    for count in counts:
        spacing = RADIUS_M * np.sqrt(np.pi / count)
        candidates = find_candidates(
            dem, TARGET, grid_around(dem, TARGET, RADIUS_M, spacing), Limits(farthest_m=RADIUS_M)
        )
        with tempfile.TemporaryDirectory() as folder, Memory() as memory:
            begun = time.perf_counter()
            select_sites(plan, candidates, Wanted(), Path(folder) / "survey.partial")
            seconds = time.perf_counter() - begun
        spent = resource.getrusage(resource.RUSAGE_CHILDREN)
        print(
            f"  {len(candidates):6d} candidates: {seconds:6.1f} s, "
            f"{1e3 * seconds / len(candidates):5.1f} ms each, "
            f"{memory.peak / 2**20:5.0f} MiB in all processes"
        )
    print(f"  processor time of all workers: {spent.ru_utime + spent.ru_stime:.0f} s")


if __name__ == "__main__":
    main(tuple(map(int, sys.argv[1:])) or COUNTS)
