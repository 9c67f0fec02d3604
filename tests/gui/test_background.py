"""Computations in the background: one at a time, the newest wins, none outlives its owner."""

import threading

import pytest
from qgis.PyQt.QtTest import QTest


@pytest.fixture
def background(gui):
    background = gui("background").Background()
    background.told, background.problems = [], []
    background.computed.connect(background.told.append)
    background.failed.connect(background.problems.append)
    yield background
    background.close()


def wait(background):
    for _ in range(2000):
        if not background.busy:
            return
        QTest.qWait(1)
    pytest.fail("it never ended")


class Gate:
    """A computation that waits for a sign, and stops when it is asked to."""

    def __init__(self, result):
        self.result, self.open, self.started = result, threading.Event(), threading.Event()
        self.stopped = False

    def __call__(self, progress):
        self.started.set()
        while not self.open.wait(0.001):
            if not progress(0.5):
                self.stopped = True
                break
        return self.result


def test_a_newer_computation_stops_the_one_that_runs(background):
    first, second = Gate("first"), Gate("second")
    second.open.set()
    background.submit(lambda: first)
    first.started.wait(5)
    background.submit(lambda: second)
    wait(background)
    assert first.stopped
    assert background.told == ["second"]


def test_of_those_that_wait_only_the_newest_is_computed(background):
    first = Gate(0)
    computed = []

    def number(value):
        return lambda: lambda progress: computed.append(value) or value

    background.submit(lambda: first)
    first.started.wait(5)
    for value in (1, 2, 3):
        background.submit(number(value))
    first.open.set()
    wait(background)
    assert (computed, background.told) == ([3], [3])


def test_coarse_ones_are_let_finish_while_something_moves(background):
    first, second = Gate("first"), Gate("second")
    second.open.set()
    background.submit(lambda: first, coarse=True)
    first.started.wait(5)
    background.submit(lambda: second, coarse=True)
    assert not first.stopped
    first.open.set()
    wait(background)
    assert background.told == ["first", "second"]


def test_what_must_be_looked_at_in_the_window_is(background):
    threads = []

    def prepare():
        threads.append(threading.current_thread())
        return lambda progress: threads.append(threading.current_thread())

    background.submit(prepare)
    wait(background)
    assert threads[0] is threading.main_thread()
    assert threads[1] is not threading.main_thread()


@pytest.mark.parametrize("where", ["preparing", "computing"])
@pytest.mark.parametrize(
    ("error", "sentence"),
    [
        (ModuleNotFoundError("no", name="pyproj.crs"), "The Python library pyproj is missing"),
        (ZeroDivisionError("division by zero"), "division by zero"),
    ],
)
def test_errors_become_sentences(background, where, error, sentence):
    def fail(*_):
        raise error

    background.submit(fail if where == "preparing" else lambda: fail)
    wait(background)
    assert not background.told
    assert len(background.problems) == 1
    assert sentence in background.problems[0]


def test_what_is_cancelled_is_never_told(background):
    gate = Gate("late")
    background.submit(lambda: gate)
    gate.started.wait(5)
    background.cancel()
    gate.open.set()
    wait(background)
    assert background.told == background.problems == []


def test_closing_waits_for_the_thread_and_tells_nothing(gui):
    threads = {*threading.enumerate()}
    gate, told = Gate("late"), []
    background = gui("background").Background()
    background.computed.connect(told.append)
    background.submit(lambda: gate)
    gate.started.wait(5)
    background.close()
    QTest.qWait(10)
    assert gate.stopped
    assert told == []
    assert {*threading.enumerate()} <= threads
