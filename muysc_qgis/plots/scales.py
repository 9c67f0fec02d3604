"""Ticks with labels along the sides of frames, and colour bars below them.

A second scale or a colour bar takes matplotlib another set of axes. Round
numbers at known places need none: a line of tick marks and plain texts do.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from . import style, ticks
from .frames import Box, Frame, draw_image, place

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.transforms import Transform

#: Length of a tick, its distance from the label, and that from the labels to
#: the name of the scale (points).
_TICK, _PAD, _GAP = 3.0, 2.5, 2.0

#: Height of a line of text, and width of a character, as shares of its size:
#: those of the digits in the font that matplotlib ships.
_LINE, _CHARACTER = 1.2, 0.64

#: Where each side lies as a share, the marker of its ticks, the way outwards,
#: and which part of a label or of the name stands there.
_SIDES = {
    "left": (0.0, 0, -1, ("right", "center_baseline"), "bottom"),
    "right": (1.0, 1, 1, ("left", "center_baseline"), "top"),
    "top": (1.0, 2, 1, ("center", "bottom"), "bottom"),
    "bottom": (0.0, 3, -1, ("center", "top"), "top"),
}

#: Length of a colour bar's arrow, and the room that one of its labels takes (inches).
_ARROW_IN = 0.16
_LABEL_IN = 0.45
#: Steps of an even scale at most.
_MOST_STEPS = 5


def draw_scale(
    frame: Frame,
    side: str,
    positions: np.ndarray,
    labels: Sequence[str] | None = None,
    name: str = "",
    name_at_end: bool = False,
    gap: float = _GAP,
    gid: str = "",
) -> None:
    """Draw ticks with labels along one side of a frame.

    Parameters
    ----------
    frame
        Where to draw.
    side
        “left”, “right”, “top” or “bottom”.
    positions
        Values of the frame at which the ticks stand.
    labels
        What is written there; by default the values.
    name
        What the scale shows.
    name_at_end
        Whether the name ends at the right corner rather than in the middle.
    gap
        Points between labels and name.
    gid
        What the scale is, by default its side.
    """
    from matplotlib.lines import Line2D
    from matplotlib.transforms import blended_transform_factory

    gid = gid or side
    if labels is None:
        labels = [ticks.number_label(position) for position in positions]
    upright = side in ("left", "right")
    share, marker, outwards, (across, down), name_down = _SIDES[side]
    order = (frame.shares, frame.values) if upright else (frame.values, frame.shares)
    along = blended_transform_factory(*order)

    def point(position: object, at: object = share) -> tuple[object, object]:
        return (at, position) if upright else (position, at)

    figure = frame.axes.figure
    figure.add_artist(
        Line2D(
            *point(np.asarray(positions), np.full(len(positions), share)), transform=along,
            linestyle="none", marker=marker, markersize=_TICK, markeredgecolor=style.MUTED,
            markeredgewidth=style.THIN_LINE_WIDTH, gid=f"{gid} ticks",
        )
    )  # fmt: skip
    moved = _moved(frame, along, upright, outwards * (_TICK + _PAD))
    for position, label in zip(np.asarray(positions).tolist(), labels):
        figure.text(
            *point(position), label, transform=moved, fontsize=style.TICK_SIZE, color=style.INK,
            ha=across, va=down, gid=f"{gid} labels",
        )  # fmt: skip
    if name:
        room = max(map(len, labels), default=0) * _CHARACTER if upright else _LINE
        reach = _TICK + _PAD + room * style.TICK_SIZE + gap
        figure.text(
            *point(1.0 if name_at_end else 0.5), name,
            transform=_moved(frame, frame.shares, upright, outwards * reach),
            fontsize=style.TEXT_SIZE, color=style.INK, rotation=90 if upright else 0,
            rotation_mode="anchor", ha="right" if name_at_end else "center", va=name_down,
            gid=f"{gid} name",
        )  # fmt: skip


def _moved(frame: Frame, transform: Transform, sideways: bool, points: float) -> Transform:
    """Return a transform followed by a way on the page, to the right or upwards."""
    from matplotlib.transforms import ScaledTranslation

    way = (points / 72, 0.0) if sideways else (0.0, points / 72)
    return transform + ScaledTranslation(*way, frame.axes.figure.dpi_scale_trans)


def draw_colour_bar_below(
    frame: Frame, values: np.ndarray, scale: ScalarMappable, name: str,
    below_in: float, height_in: float,
) -> None:  # fmt: skip
    """Draw a colour scale as wide as a frame below it; see `draw_colour_bar`.

    Parameters
    ----------
    frame
        From `place`.
    values, scale, name
        As for `draw_colour_bar`.
    below_in, height_in
        Distance of the bar from the frame, and its height (inches).
    """
    left, bottom, width, _ = frame.box
    box = (left, bottom - below_in - height_in, width, height_in)
    draw_colour_bar(frame.axes, box, values, scale, name)


def draw_colour_bar(
    axes: Axes, box: Box, values: np.ndarray, scale: ScalarMappable, name: str
) -> None:
    """Draw a colour scale, arrows where values lie beyond its ends.

    Parameters
    ----------
    axes
        From `page_axes`.
    box
        Of the bar, arrows included.
    values
        What the scale shows, any shape.
    scale
        Colours and limits.
    name
        Name of the scale, with the unit.
    """
    from matplotlib.colors import LogNorm
    from matplotlib.patches import Polygon

    left, bottom, width, height = box
    low, high = scale.get_clim()
    known = values[np.isfinite(values)]
    if isinstance(scale.norm, LogNorm):
        known = known[known > 0]
        positions = ticks.logarithmic_ticks(low, high)
        positions = positions[:: int(np.ceil(len(positions) * _LABEL_IN / width))]
    else:
        steps = min(_MOST_STEPS, int(width / _LABEL_IN))
        positions = ticks.multiples(low, high, ticks.round_step(high - low, max(2, steps)))
    sides = [left, left + width]
    for side, inwards, shade, beyond in (
        (0, 1, 0.0, np.any(known < low)), (1, -1, 1.0, np.any(known > high)),
    ):  # fmt: skip
        if beyond:
            tip = sides[side]
            sides[side] += inwards * _ARROW_IN
            corners = [
                (sides[side], bottom + height), (tip, bottom + height / 2), (sides[side], bottom),
            ]  # fmt: skip
            axes.add_artist(
                Polygon(
                    corners, facecolor=scale.cmap(shade), edgecolor=style.MUTED,
                    linewidth=style.THIN_LINE_WIDTH, zorder=1, gid="beyond",
                )
            )  # fmt: skip
    # Along the bar colours run evenly, and the scale as its norm says.
    bar = place(axes, (sides[0], bottom, sides[1] - sides[0], height), (0, 1, 0, 1))
    shades = scale.cmap(np.linspace(0.0, 1.0, scale.cmap.N), bytes=True)[None]
    draw_image(bar, shades, (0, 1, 0, 1), "colour bar")
    draw_scale(
        bar, "bottom", np.asarray(scale.norm(positions)),
        [ticks.number_label(position) for position in positions], name, gid="colour",
    )  # fmt: skip
