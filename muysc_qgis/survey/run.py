"""Running a job: here, in worker processes, or on a Dask cluster."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from ..progress import Progress, report, silent
from .blocks import BlockFolder
from .cluster import compute_on_cluster
from .job import Job
from .local import WorkersFailed, compute_locally

#: Told what happens, one sentence at a time.
Say = Callable[[str], None]

#: How often (s) the remaining time is told, and after how many blocks first.
_TELL_S = 5.0
_LEAST_BLOCKS = 3


def unheard(text: str) -> None:
    """Tell nobody."""


def default_workers() -> int:
    """Return the number of processors that this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not on Windows and macOS
        return os.cpu_count() or 1


def run_job(
    job: Job,
    folder: Path,
    workers: int | None = None,
    scheduler: str = "",
    progress: Progress = silent,
    say: Say = unheard,
    warn: Say = unheard,
) -> list[Any]:
    """Compute all items of a job, going on from blocks that are finished.

    Results do not depend on where and in how many processes they are computed.

    Parameters
    ----------
    job
        What to compute.
    folder
        Where finished blocks are kept until `remove_finished`.
    workers
        Number of worker processes, 0 or 1 for none but this one, None for one for each
        processor.
    scheduler
        Address of a Dask scheduler, empty for this machine.
    progress
        Told the share done.
    say, warn
        Told how far it is and how long it will take; told what went wrong.

    Returns
    -------
    list
        Result of each item.

    Raises
    ------
    MuyscError
        If an item cannot be computed, workers fail or the cluster cannot be used.
    Cancelled
        If `progress` asks for a stop; finished blocks are kept.
    """
    kept = BlockFolder(folder, job)
    blocks = {block: kept.items(block) for block in kept.pending()}
    pace = _Pace(job, sum(map(len, blocks.values())), progress, say)
    workers = default_workers() if workers is None else workers
    done: Iterator[tuple[int, list[Any]]]
    if scheduler:
        done = compute_on_cluster(job, blocks, scheduler, pace.pulse)
    elif workers > 1 and len(blocks) > 1:
        done = _with_workers(folder, blocks, workers, pace, warn)
    else:
        done = _compute_here(folder, blocks, pace)
    for block, results in done:
        kept.keep(block, results)
        pace.count(len(results))
    return kept.results()


def _with_workers(
    folder: Path, blocks: dict[int, range], workers: int, pace: _Pace, warn: Say
) -> Iterator[tuple[int, list[Any]]]:
    """Compute in worker processes, or here if not one of them can work."""
    left = dict(blocks)
    try:
        for block, results in compute_locally(folder, blocks, workers, pace.pulse):
            del left[block]
            yield block, results
    except WorkersFailed as error:
        if len(left) < len(blocks):
            raise
        warn(f"{error} The survey runs in one process instead.")
        yield from _compute_here(folder, left, pace)


def _compute_here(
    folder: Path, blocks: dict[int, range], pace: _Pace
) -> Iterator[tuple[int, list[Any]]]:
    if not blocks:
        return
    compute = Job.load(folder).prepared()
    for block, items in blocks.items():
        results: list[Any] = []
        for item in items:
            results.append(compute(item, pace.within(len(results))))
        yield block, results


class _Pace:
    """How much is done, and how long the rest will take at the pace so far."""

    def __init__(self, job: Job, left: int, progress: Progress, say: Say) -> None:
        self._items, self._called = job.items, job.called
        self._least = _LEAST_BLOCKS * job.block_items
        self._left, self._progress, self._say = left, progress, say
        self._begun = self._told = time.monotonic()
        self._done_before = job.items - left
        if self._done_before > 0:
            say(f"{self._done_before} of {job.items} {job.called} were finished by an earlier run.")

    def pulse(self) -> None:
        """Tell the share done, and heed a stop."""
        report(self._progress, self._share(0.0))

    def within(self, beyond: int) -> Progress:
        """Return the progress of an item, `beyond` items after those that are counted."""
        report(self._progress, self._share(beyond))
        return lambda fraction: self._progress(self._share(beyond + fraction))

    def _share(self, beyond: float) -> float:
        return min((self._items - self._left + beyond) / self._items, 1.0)

    def count(self, items: int) -> None:
        """Count items as done."""
        self._left -= items
        now, done = time.monotonic(), self._items - self._left
        lately = done - self._done_before
        # The first blocks say little, because others are half done beside them.
        if self._left and now - self._told > _TELL_S and lately >= self._least:
            seconds = self._left * (now - self._begun) / lately
            self._told = now
            self._say(
                f"{done} of {self._items} {self._called} are done, about {_spoken(seconds)} left."
            )
        self.pulse()


def _spoken(seconds: float) -> str:
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"
