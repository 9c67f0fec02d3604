"""Charts on a page: axes at a place in inches, their legends and round scales."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from . import style, ticks
from .frames import new_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Scales of more decades than this are labelled in powers of ten.
_PLAIN_DECADES = 6
#: Left and right margins of the page (inches).
LEFT_IN, RIGHT_IN = 0.75, 0.2


def place(figure: Figure, left_in: float, top_in: float, width_in: float, height_in: float) -> Axes:
    """Add axes at a distance from the top left corner of a figure (inches)."""
    bottom_in = figure.get_size_inches()[1] - top_in - height_in
    axes = new_axes(figure, (left_in, bottom_in, width_in, height_in))
    style.style_axes(axes)
    style.add_grid(axes)
    return axes


def legend(
    figure: Figure, top_in: float, artists: Sequence[object], labels: Sequence[str], columns: int
) -> None:
    """Put a legend without a frame at a distance below the top of a figure (inches)."""
    width, height = figure.get_size_inches()
    figure.legend(
        artists, [style.plain(label) for label in labels], loc="upper left",
        bbox_to_anchor=(LEFT_IN / width, 1 - top_in / height), ncol=columns, frameon=False,
        fontsize=style.TEXT_SIZE, borderaxespad=0.0, borderpad=0.0, handlelength=2.6,
        columnspacing=1.6,
    )  # fmt: skip


def log_axis(axes: Axes, which: str, low: float, high: float, count: int = 6) -> None:
    """Give one axis a logarithmic scale with ticks at the decades, every n-th one labelled.

    Parameters
    ----------
    axes
        Axes to change.
    which
        “x” or “y”.
    low, high
        Limits, above 0.
    count
        Largest number of steps between labels.
    """
    first, last = int(np.ceil(np.log10(low) - 1e-9)), int(np.floor(np.log10(high) + 1e-9))
    exponents = range(first, last + 1)
    step = max(1, -(-(last - first) // count))
    # Many decades read best as powers throughout.
    name = _power if last - first > _PLAIN_DECADES else lambda n: ticks.number_label(10.0**n)
    labels = [name(n) if (n - first) % step == 0 else "" for n in exponents]
    _set_logarithmic(axes, which, (low, high), [10.0**n for n in exponents], labels)


def short_log_axis(axes: Axes, which: str, low: float, high: float) -> None:
    """Give one axis a logarithmic scale of few decades, with round ticks between these too.

    Parameters
    ----------
    axes, which, low, high
        As for `log_axis`.
    """
    positions = ticks.logarithmic_ticks(low, high).tolist()
    labels = [ticks.number_label(position) for position in positions]
    _set_logarithmic(axes, which, (low, high), positions, labels)


def _set_logarithmic(
    axes: Axes, which: str, limits: tuple[float, float], positions: list[float], labels: list[str]
) -> None:
    from matplotlib.ticker import NullLocator

    getattr(axes, f"set_{which}scale")("log")
    getattr(axes, f"set_{which}lim")(limits)
    getattr(axes, f"set_{which}ticks")(positions, labels)
    # Minor ticks would take longer to draw than everything else together.
    getattr(axes, f"{which}axis").set_minor_locator(NullLocator())


def _power(exponent: int) -> str:
    return ("1", "10")[exponent] if exponent in (0, 1) else ticks.power_of_ten(exponent)


def label(axes: Axes, x: str = "", y: str = "") -> None:
    """Label the axes in the house look."""
    if x:
        axes.set_xlabel(x, fontsize=style.TEXT_SIZE, labelpad=2)
    if y:
        axes.set_ylabel(y, fontsize=style.TEXT_SIZE, labelpad=2)
