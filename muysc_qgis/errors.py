"""The two ways a computation ends early."""

from __future__ import annotations


class MuyscError(ValueError):
    """Input that cannot be used.

    The message is one sentence for the user: it names the value, the limit and
    the remedy, and every way in (dialog, model, command line) shows it as it is.
    """


class Cancelled(Exception):  # noqa: N818 - a request, not a fault
    """The user stopped the computation; nothing was written."""
