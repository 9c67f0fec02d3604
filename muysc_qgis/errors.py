"""The two ways a computation ends early, and what a library says of its own."""

from __future__ import annotations


class MuyscError(ValueError):
    """Input that cannot be used.

    The message is one sentence for the user: it names the value, the limit and
    the remedy, and every way in (dialog, model, command line) shows it as it is.
    """


class Cancelled(Exception):  # noqa: N818 - a request, not a fault
    """The user stopped the computation; nothing was written."""


def detail_of(error: Exception) -> str:
    """Return what a library says went wrong, as a part of a sentence.

    GDAL may add lines on what is behind it, which are left out.
    """
    return (str(error).strip().splitlines() or [""])[0].strip().rstrip(".")
