"""Timing and memory, shared by the benchmarks."""

from __future__ import annotations

import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DEM = ROOT / "tests" / "data" / "vesuvius_srtmgl1.tif"
#: Casina Amelia and the point on Gran Cono that it looks at (longitude, latitude).
DETECTOR = (14.410686, 40.810561)
TARGET = (14.424745, 40.823729)


@dataclass(frozen=True)
class Row:
    """One line of the table."""

    what: str
    seconds: float
    note: str = ""
    peak_mib: float | None = None


def seconds_of(function: Callable[[], object], repeats: int) -> float:
    """Return the median time of a function, once warm."""
    function()
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        function()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def peak_mib() -> float:
    """Return the largest resident memory of this process so far."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def in_fresh_process(code: str) -> list[str]:
    """Run Python code with the library importable; return the words it prints."""
    prelude = f"import sys; sys.path[:0] = [{str(ROOT)!r}, {str(ROOT / 'benchmarks')!r}]\n"
    result = subprocess.run(
        [sys.executable, "-c", prelude + code], check=True, capture_output=True, text=True
    )
    return result.stdout.split()


def print_table(title: str, rows: list[Row]) -> None:
    """Print rows with aligned columns."""
    print(f"\n{title}")
    width = max(len(row.what) for row in rows)
    for row in rows:
        memory = "" if row.peak_mib is None else f"{row.peak_mib:8.0f} MiB"
        print(f"  {row.what:<{width}}  {row.seconds:10.4f} s {memory:>12}  {row.note}")
