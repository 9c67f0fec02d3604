"""One line of the validation table."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Row:
    """One number of ours beside the one it is checked against."""

    section: str
    what: str
    #: None where it cannot be computed, as on terrain that does not come with the project.
    ours: float | None
    unit: str
    #: None where nothing is printed to compare with.
    reference: float | None
    source: str
    #: Largest difference that counts as agreement, relative to the reference; None where
    #: the difference is shown and not required to be small.
    tolerance: float | None = 0.0
    #: Ends of an interval that ours must lie in, or (as `ours_to`) that ours spans.
    reference_to: float | None = None
    ours_to: float | None = None
    #: Whether the row needs the optional code mulder.
    mulder: bool = False

    @property
    def difference(self) -> float:
        """Relative difference, 0 inside an interval, NaN with only one of the two numbers."""
        if self.reference is None or self.ours is None:
            return math.nan
        low, high = sorted((self.reference, self.reference_to or self.reference))
        first, last = sorted((self.ours, self.ours if self.ours_to is None else self.ours_to))
        if last < low:
            return last / low - 1
        if first > high:
            return first / high - 1
        if self.ours_to is None and self.reference_to is None:
            return self.ours / self.reference - 1
        return 0.0

    @property
    def agrees(self) -> bool:
        """Whether the difference is within the tolerance, or need not be."""
        if self.tolerance is None or math.isnan(self.difference):
            return True
        return abs(self.difference) <= self.tolerance * (1 + 1e-9)

    def cells(self) -> tuple[str, str, str, str, str]:
        """Return what, ours, reference, difference and source as text."""
        unit = "" if self.unit == "1" else f" {self.unit}"
        return (
            self.what,
            _span(self.ours, self.ours_to, unit),
            _span(self.reference, self.reference_to, unit),
            self._difference_text(),
            self.source,
        )

    def _difference_text(self) -> str:
        if math.isnan(self.difference):
            return "–"
        if self.difference == 0 and (self.ours_to is not None or self.reference_to is not None):
            return "within"
        if not 0.5 <= 1 + self.difference <= 2:
            return f"{number(1 + self.difference)} times"
        # Adding 0 turns −0.0 into 0.0.
        return f"{round(100 * self.difference, 1) + 0.0:+.1f} %".replace("-", "−")


def _span(first: float | None, last: float | None, unit: str) -> str:
    if first is None:
        return "–"
    return (number(first) if last is None else f"{number(first)} to {number(last)}") + unit


def number(value: float) -> str:
    """Return four digits, with a power of ten where a plain number would be long."""
    if value != 0 and not 1e-3 <= abs(value) < 1e5:
        mantissa, exponent = f"{value:.3e}".split("e")
        return f"{mantissa.rstrip('0').rstrip('.')}e{int(exponent)}"
    return f"{value:.4g}" if abs(value) < 1e4 else f"{value:.0f}"
