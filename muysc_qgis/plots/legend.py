"""Legends at places that are known beforehand, so that nothing has to be laid out."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from . import style

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.figure import Figure

#: Width and height of a sample, from its middle to the label, and the height of
#: a line of text (inches).
_SAMPLE_IN = (0.26, 0.09)
_TO_LABEL_IN = 0.25
_LINE_IN = 0.16
#: From the middle of a sample to the top of its label (inches).
_ABOVE_IN = 0.072


def draw_legend(
    figure: Figure,
    entries: Sequence[tuple[str, Artist]],
    left_in: float,
    top_in: float,
    rows: int,
    row_in: float,
    column_in: float = 0.0,
) -> None:
    """Draw samples with labels, column by column.

    Parameters
    ----------
    figure
        Where to draw.
    entries
        Label and a line, marker or patch whose look the sample takes.
    left_in, top_in
        Upper left corner from the lower left corner of the figure (inches).
    rows
        Entries of a column.
    row_in, column_in
        From row to row and from column to column (inches); further lines of a
        label take their height on top.
    """
    from matplotlib.lines import Line2D
    from matplotlib.patches import Rectangle

    width, height = _SAMPLE_IN
    x, y = left_in + width / 2, top_in - row_in / 2
    for number, (label, artist) in enumerate(entries):
        if number and number % rows == 0:
            x, y = x + column_in, top_in - row_in / 2
        sample: Artist
        if isinstance(artist, Line2D):
            # A marker stands in the middle, a line runs from end to end.
            across = [x] if artist.get_marker() != "None" else [x - width / 2, x + width / 2]
            sample = Line2D(across, [y] * len(across))
        else:
            sample = Rectangle((x - width / 2, y - height / 2), width, height)
        sample.update_from(artist)
        sample.set(transform=figure.dpi_scale_trans, clip_box=None, gid="legend", zorder=3)
        sample.set_clip_path(None)
        figure.add_artist(sample, clip=False)
        figure.text(
            x + _TO_LABEL_IN, y + _ABOVE_IN, style.plain(label),
            transform=figure.dpi_scale_trans, fontsize=style.TEXT_SIZE, color=style.INK,
            ha="left", va="top", gid="legend",
        )  # fmt: skip
        y -= row_in + _LINE_IN * label.count("\n")
