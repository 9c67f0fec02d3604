"""Progress and cancelling, as the library knows them."""

from __future__ import annotations

from collections.abc import Callable

from .errors import Cancelled

#: Called with the share done, 0 to 1; returns False to ask for a stop.
Progress = Callable[[float], bool]


def silent(fraction: float) -> bool:
    """Take note of nothing and never stop."""
    return True


def report(progress: Progress, fraction: float) -> None:
    """Pass on the share done.

    Raises
    ------
    Cancelled
        If the receiver asks for a stop.
    """
    if not progress(fraction):
        raise Cancelled("stopped on request")


def part(progress: Progress, start: float, end: float) -> Progress:
    """Return a progress whose 0 to 1 is the stretch `start` to `end` of another."""
    return lambda fraction: progress(start + (end - start) * fraction)
