"""Worker processes on this machine, which read the terrain from one file."""

from __future__ import annotations

import json
import os
import queue
import subprocess  # nosec B404
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from threading import Thread
from typing import Any

import numpy as np

from ..errors import MuyscError

#: The folder that holds this library.
_ROOT = Path(__file__).resolve().parents[2]
_MODULE = ".".join([*Path(__file__).resolve().parent.relative_to(_ROOT).parts, "worker"])

#: How often (s) the caller may stop the work.
_PULSE_S = 0.2

#: Libraries that would start threads of their own in every worker.
_ONE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


class WorkersFailed(MuyscError):  # noqa: N818 - a fault of the workers, told as one sentence
    """No worker process is left."""


def python_program() -> str | None:
    """Return the Python that goes with this process, None where there is none.

    Within QGIS on Windows and macOS `sys.executable` is QGIS itself, and its Python
    lies near.
    """
    own = Path(sys.executable or "python")
    if own.stem.lower().startswith("python"):
        return str(own)
    names = [f"python{sys.version_info.major}.{sys.version_info.minor}", "python3", "python"]
    folders = [Path(sys.exec_prefix), Path(sys.exec_prefix) / "bin", own.parent, own.parent / "bin"]
    for folder in folders:
        for name in names:
            for suffix in ("", ".exe"):
                program = folder / f"{name}{suffix}"
                if program.is_file() and os.access(program, os.X_OK):
                    return str(program)
    return None


def compute_locally(
    folder: Path,
    blocks: Mapping[int, Sequence[int]],
    workers: int,
    pulse: Callable[[], None],
) -> Iterator[tuple[int, list[Any]]]:
    """Compute blocks of a job in worker processes, in any order.

    A block whose worker dies is given to another. Workers end with this process,
    with the iterator and with an exception.

    Parameters
    ----------
    folder
        Where the job is saved.
    blocks
        Items by block.
    workers
        Number of processes.
    pulse
        Called several times a second; stops the work by an exception.

    Yields
    ------
    tuple
        Block and the results of its items.

    Raises
    ------
    WorkersFailed
        If no process can be started or all have died.
    MuyscError
        If an item cannot be computed.
    """
    crew = _Crew(folder, blocks, min(workers, len(blocks)))
    try:
        left = len(blocks)
        while left:
            pulse()
            answer = crew.answer(_PULSE_S)
            if answer is not None:
                yield answer
                left -= 1
    finally:
        crew.dismiss()


class _Crew:
    """Processes, and a thread for each that feeds it."""

    def __init__(self, folder: Path, blocks: Mapping[int, Sequence[int]], workers: int) -> None:
        self._folder, self._blocks = folder, blocks
        self._todo: queue.SimpleQueue[int | None] = queue.SimpleQueue()
        self._answers: queue.SimpleQueue[tuple[int, dict[str, Any] | None]] = queue.SimpleQueue()
        for block in blocks:
            self._todo.put(block)
        self._processes: list[subprocess.Popen[str]] = []
        self._threads: list[Thread] = []
        try:
            for number in range(workers):
                self._processes.append(_start(folder, number))
        except OSError as error:
            self.dismiss()
            raise WorkersFailed(f"No worker process can be started ({error.strerror}).") from error
        self._alive = workers
        for process in self._processes:
            thread = Thread(target=self._feed, args=(process,), daemon=True)
            thread.start()
            self._threads.append(thread)

    def _feed(self, process: subprocess.Popen[str]) -> None:
        """Hand blocks to a process until it dies or nothing is left to do."""
        if _ask(process) is None:  # it says that it is ready
            self._answers.put((-1, None))
            return
        while (block := self._todo.get()) is not None:
            answer = _ask(process, list(self._blocks[block]))
            self._answers.put((block, answer))
            if answer is None:
                return

    def answer(self, timeout_s: float) -> tuple[int, list[Any]] | None:
        """Return a block with its results, None where there is none in time."""
        try:
            block, answer = self._answers.get(timeout=timeout_s)
        except queue.Empty:
            return None
        if answer is None:
            self._alive -= 1
            if block >= 0:
                self._todo.put(block)
            if not self._alive:
                raise WorkersFailed(
                    "All worker processes have ended before their work was done"
                    f"{self._last_words()}; use fewer WORKERS, and run again to go on from the "
                    "finished parts."
                )
            return None
        if "error" in answer:
            raise MuyscError(answer["error"])
        return block, answer["results"]

    def _last_words(self) -> str:
        """Return the last line that a worker has left in its log."""
        for log in sorted(self._folder.glob("worker_*.log")):
            lines = log.read_text(encoding="utf-8", errors="replace").split("\n")
            said = [line.strip() for line in lines if line.strip()]
            if said:
                return f" ({said[-1]})"
        return ""

    def dismiss(self) -> None:
        """End all processes and threads."""
        for process in self._processes:
            process.kill()
        for _ in self._threads:
            self._todo.put(None)
        for thread in self._threads:
            thread.join()
        for process in self._processes:
            process.wait()
            for pipe in (process.stdin, process.stdout):
                if pipe is not None:
                    # What was to be written may have no reader left.
                    with suppress(OSError):
                        pipe.close()


def _start(folder: Path, number: int) -> subprocess.Popen[str]:
    program = python_program()
    if program is None:
        raise FileNotFoundError(2, "no Python is found beside QGIS")
    import osgeo
    import pyproj

    # Where QGIS has libraries that its Python alone would not find.
    libraries = {str(Path(one.__file__ or "").resolve().parents[1]) for one in (np, osgeo, pyproj)}
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONSAFEPATH"}
    paths = [environment.get("PYTHONPATH", ""), *sorted(libraries)]
    environment["PYTHONPATH"] = os.pathsep.join(path for path in paths if path)
    environment["PYTHONIOENCODING"] = "utf-8"
    environment.update(dict.fromkeys(_ONE_THREAD, "1"))
    with (folder / f"worker_{number}.log").open("w", encoding="utf-8") as log:
        # No word of it comes from a user.
        return subprocess.Popen(  # noqa: S603  # nosec B603
            [program, "-m", _MODULE, str(folder)],
            cwd=_ROOT,
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=log,
            text=True,
            encoding="utf-8",
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )


def _ask(process: subprocess.Popen[str], items: list[int] | None = None) -> dict[str, Any] | None:
    """Return what a process answers, None if it has died."""
    try:
        if process.stdin is None or process.stdout is None:
            return None
        if items is not None:
            process.stdin.write(json.dumps(items) + "\n")
            process.stdin.flush()
        answer: dict[str, Any] = json.loads(process.stdout.readline())
        return answer
    except (OSError, ValueError):  # a closed pipe, or half a line
        return None
