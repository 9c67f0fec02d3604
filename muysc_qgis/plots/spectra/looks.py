"""What the figures of a comparison share: colours and lines."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...quantities import COLOUR_STOPS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Colour and line of each flux model (Okabe & Ito 2008); the lines differ as well, for
#: print without colours.
MODEL_LOOKS = {
    "gsf-sibyll": ("#d81b60", "-"),
    "gaisser": ("#e69f00", "-"),
    "gaisser-tang": ("#0072b2", "-"),
    "bugaev": ("#009e73", (0, (6, 1.5))),
    "reyna-bugaev": ("#d55e00", (0, (6, 1.5))),
    "reyna-hebbeker": ("#cc79a7", (0, (4, 1.2, 1, 1.2))),
    "guan": ("#1a1a1a", (0, (4, 1.2, 1, 1.2))),
}
#: Colour and line of each range law.
LAW_LOOKS = {
    "csda": ("#0072b2", "-"),
    "lesparre": ("#d55e00", (0, (6, 1.5))),
    "paper": ("#1a1a1a", (0, (4, 1.2, 1, 1.2))),
}
#: Colours of materials in their order, and lines once the colours are used up.
_MATERIAL_COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f")
_MATERIAL_LINES = ("-", (0, (6, 1.5)))

#: How much of a line shows outside the range that a model was made for.
FADED = 0.25
#: How much of a model's error shows, and the colour and markers of measurements.
BAND = 0.18
POINTS = "#666666"
MEASURED = {"BESS-TeV": "o", "L3+C": "s"}
#: The area that counts.
COUNTED = "#f0e442"


def material_look(index: int) -> tuple[str, object]:
    """Return colour and line of the material at a place in the list."""
    count = len(_MATERIAL_COLOURS)
    return _MATERIAL_COLOURS[index % count], _MATERIAL_LINES[index // count % 2]


def zenith_colours(count: int) -> list[str]:
    """Return colours from dark to light for increasing zenith angles."""
    # The last stops are too light for a line on white.
    stops = COLOUR_STOPS["viridis"][:-1]
    return [stops[round(i)] for i in np.linspace(0, len(stops) - 1, max(count, 2))][:count]


def faded_line(
    axes: Axes, x: np.ndarray, y: np.ndarray, holds: np.ndarray, colour: str, line: object
) -> None:
    """Draw a curve, faded where it does not hold."""
    # One point more on each side, so that both parts meet.
    outside = ~holds
    outside[1:] |= ~holds[:-1]
    outside[:-1] |= ~holds[1:]
    look = {"color": colour, "linestyle": line, "solid_capstyle": "butt"}
    axes.plot(x, np.where(outside, y, np.nan), alpha=FADED, linewidth=0.9, **look)
    axes.plot(x, np.where(holds, y, np.nan), linewidth=1.3, **look)
