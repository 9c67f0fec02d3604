"""Computations in a thread of their own, so that the map never waits for them."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from threading import Event
from typing import Any

from qgis.core import Qgis, QgsMessageLog
from qgis.PyQt.QtCore import QObject, Qt, pyqtSignal

from ...processing_algorithms.base import missing_library
from ..errors import Cancelled, MuyscError
from ..progress import Progress
from .texts import tr

#: What is done in the thread; its result is told.
Computation = Callable[[Progress], Any]


def sentence_for(error: Exception) -> str:
    """Return what to tell the user of an error; what should not happen is logged too."""
    if isinstance(error, MuyscError):
        return str(error)
    if isinstance(error, ImportError):
        return missing_library(error)
    QgsMessageLog.logMessage(repr(error), "MUYSC", Qgis.MessageLevel.Critical)
    return tr("The muogram cannot be computed ({error}); choose other values.").format(error=error)


class _Job:
    """One computation, which may be stopped from another thread."""

    def __init__(self, prepare: Callable[[], Computation], coarse: bool) -> None:
        self.prepare = prepare
        self.coarse = coarse
        self._stop = Event()
        self.result: Any = None
        self.problem = ""

    def cancel(self) -> None:
        self._stop.set()

    @property
    def cancelled(self) -> bool:
        return self._stop.is_set()

    def run(self, compute: Computation) -> None:
        if self.cancelled:
            return
        try:
            self.result = compute(lambda fraction: not self.cancelled)
        except Cancelled:
            self.cancel()
        except Exception as error:
            self.problem = sentence_for(error)


class Background(QObject):
    """Runs one computation at a time, and after it the newest of those that wait.

    A newer one stops the one that runs; but of coarse ones each is let finish, or
    nothing would be seen as long as the mouse moves.
    """

    #: The result of a computation that nothing newer has overtaken.
    computed = pyqtSignal(object)
    #: A sentence.
    failed = pyqtSignal(str)
    _ended = pyqtSignal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._thread = ThreadPoolExecutor(max_workers=1)
        self._running: _Job | None = None
        self._waiting: _Job | None = None
        self._ended.connect(self._take_up, Qt.ConnectionType.QueuedConnection)

    @property
    def busy(self) -> bool:
        """Whether something is being computed."""
        return self._running is not None

    def submit(self, prepare: Callable[[], Computation], coarse: bool = False) -> None:
        """Compute something when its turn comes.

        Parameters
        ----------
        prepare
            Called in the thread of the windows, where layers may be looked at; returns
            what is done in the background.
        coarse
            Whether the next one is near.
        """
        job = _Job(prepare, coarse)
        if self._running is None:
            self._start(job)
            return
        if not (coarse and self._running.coarse):
            self._running.cancel()
        self._waiting = job

    def cancel(self) -> None:
        """Stop what runs and forget what waits."""
        self._waiting = None
        if self._running is not None:
            self._running.cancel()

    def close(self) -> None:
        """Stop for good; nothing is told afterwards."""
        self.cancel()
        self._ended.disconnect(self._take_up)
        self._thread.shutdown(wait=True)

    def _start(self, job: _Job) -> None:
        self._running = job
        try:
            compute = job.prepare()
        except Exception as error:
            job.problem = sentence_for(error)
            self._ended.emit(job)
            return

        def run() -> None:
            job.run(compute)
            self._ended.emit(job)

        self._thread.submit(run)

    def _take_up(self, job: _Job) -> None:
        """Tell a result in the thread of the windows, and start what waits."""
        self._running = None
        overtaken = job.cancelled
        if self._waiting is not None:
            waiting, self._waiting = self._waiting, None
            overtaken |= not waiting.coarse
            self._start(waiting)
        if overtaken:
            return
        if job.problem:
            self.failed.emit(job.problem)
        else:
            self.computed.emit(job.result)
