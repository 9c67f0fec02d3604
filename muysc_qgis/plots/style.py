"""The house look of every figure, and how a figure becomes a PNG.

matplotlib is imported inside the functions: QGIS may lack it, and loading it
takes longer than loading the plugin. Colours are told apart by readers with
any colour vision (Okabe & Ito 2008, Color Universal Design, jfly.uni-koeln.de).
"""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import MuyscError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Width of every figure (inches).
WIDTH_IN = 10.0
#: Left margin of headings (inches).
MARGIN_IN = 0.22
#: Dots per inch of a PNG unless the caller says otherwise.
DPI = 130
#: And of further pictures in reports, which are read on screens.
REPORT_DPI = 110

#: Text sizes (points).
TITLE_SIZE = 12.0
HEADING_SIZE = 10.0
TEXT_SIZE = 9.0
TICK_SIZE = 8.0
CONTOUR_SIZE = 7.0

INK = "#1a1a1a"
MUTED = "#555555"
SKY = "#dcebf5"
RAY = "#d55e00"
DETECTOR = "#0072b2"
GROUND_SEEN = "#cc79a7"
ROCK = "#d9cdb8"

#: How whatever is unknown is filled.
UNKNOWN_LOOK = {
    "facecolor": "#c9c9c9", "edgecolor": "#8c8c8c", "hatch": "////", "linewidth": 0.0,
}  # fmt: skip

#: How the target and the detector are marked.
TARGET_MARK = {
    "linestyle": "none", "marker": "*", "markersize": 13, "markerfacecolor": "white",
    "markeredgecolor": "black", "markeredgewidth": 0.9,
}  # fmt: skip
DETECTOR_MARK = {
    "linestyle": "none", "marker": "^", "markersize": 10, "markerfacecolor": DETECTOR,
    "markeredgecolor": "white", "markeredgewidth": 0.9,
}  # fmt: skip

LINE_WIDTH = 1.2
THIN_LINE_WIDTH = 0.6


def new_figure(width_in: float, height_in: float) -> Figure:
    """Return an empty white figure that draws without a display.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError as error:
        raise MuyscError(
            "Figures need the Python package matplotlib, which this QGIS lacks; install "
            "it with the OSGeo4W setup, the system's package manager or pip and run again."
        ) from error
    figure = Figure(figsize=(width_in, height_in), dpi=DPI, facecolor="white")
    FigureCanvasAgg(figure)
    return figure


def plain(text: str) -> str:
    """Return text that matplotlib shows as it is, dollar signs included."""
    return text.replace("$", r"\$")


def rgb(colour: str) -> tuple[int, int, int]:
    """Return the components, 0 to 255, of a colour written as #rrggbb."""
    red, green, blue = (int(colour[i : i + 2], 16) for i in (1, 3, 5))
    return red, green, blue


def style_axes(axes: Axes) -> None:
    """Give the ticks, tick labels and frame of axes the house look."""
    axes.tick_params(
        labelsize=TICK_SIZE, labelcolor=INK, color=MUTED, width=THIN_LINE_WIDTH, length=3.0, pad=2.5
    )
    for spine in axes.spines.values():
        spine.set_color(MUTED)
        spine.set_linewidth(THIN_LINE_WIDTH)


def add_grid(axes: Axes) -> None:
    """Draw a light grid below everything else in axes."""
    axes.grid(color="#e4e4e4", linewidth=0.5)
    axes.set_axisbelow(True)


def add_title(axes: Axes, title: str, pad_points: float | None = None) -> None:
    """Write a title above the left end of axes."""
    axes.set_title(
        title, fontsize=HEADING_SIZE, fontweight="bold", loc="left", color=INK, pad=pad_points
    )


def add_heading(
    figure: Figure,
    title: str,
    lines: Sequence[str],
    margin_in: float = MARGIN_IN,
    top_in: float = 0.0,
) -> None:
    """Write a title and the lines below it at the left of a figure.

    Parameters
    ----------
    figure
        Where to write.
    title, lines
        What to write.
    margin_in
        From the left side of the figure (inches).
    top_in
        From the top of the figure to that of the heading's room (inches).
    """
    width, height = figure.get_size_inches()
    x, y = margin_in / width, 1 - (top_in + 0.12) / height
    figure.text(
        x, y, plain(title), fontsize=TITLE_SIZE, fontweight="bold", color=INK, va="top", ha="left"
    )
    rows = title.count("\n") + 1
    figure.text(
        x,
        y - (0.21 * rows + 0.04) / height,
        plain("\n".join(lines)),
        fontsize=TEXT_SIZE,
        color=MUTED,
        va="top",
        ha="left",
        linespacing=1.25,
    )


def heading_height_in(title: str, lines: Sequence[str]) -> float:
    """Return the height that `add_heading` takes (inches)."""
    rows = title.count("\n") + 1
    return 0.12 + 0.21 * rows + 0.04 + 0.17 * len(lines)


def png_bytes(figure: Figure, dpi: float = DPI) -> bytes:
    """Draw a figure and return it as a PNG file's content."""
    stream = BytesIO()
    # Level 2 takes half the time of the default for a tenth more of size.
    figure.savefig(
        stream, format="png", dpi=dpi, facecolor="white", pil_kwargs={"compress_level": 2}
    )
    return stream.getvalue()


def save_png(figure: Figure, path: str | Path, dpi: float = DPI) -> None:
    """Draw a figure and write it as a PNG file.

    Raises
    ------
    MuyscError
        If the file cannot be written.
    """
    try:
        Path(path).write_bytes(png_bytes(figure, dpi))
    except OSError as error:
        raise MuyscError(
            f"The figure {path} cannot be written ({error.strerror}); choose another "
            "folder or close the program that holds the file."
        ) from error
