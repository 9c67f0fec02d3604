"""Reconstructions of the Shepp–Logan head side by side, and what each error cost."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...tomography.method_comparison import Comparison, MethodResult
from .. import charts, style
from ..frames import Frame, draw_image, page_axes, place
from ..scales import draw_colour_bar_below

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.figure import Figure

TITLE = "Reconstruction methods compared"

#: Colour of each family of methods (Okabe & Ito 2008), marker and line of its members.
_FAMILIES = (
    ("#0072b2", ("art", "bart", "sart", "sirt")),
    ("#e69f00", ("mlem", "osem")),
    ("#d55e00", ("pml-quad", "pml-hybrid", "ospml-quad", "ospml-hybrid")),
    ("#1a1a1a", ("tv",)),
    ("#009e73", ("grad", "tikhonov", "lsmr", "bayes")),
    ("#cc79a7", ("fbp", "gridrec")),
)
_MEMBERS = (("o", "-"), ("s", (0, (6, 1.5))), ("^", (0, (4, 1.2, 1, 1.2))), ("D", (0, (1.5, 1.2))))
#: Colour, marker and line by method.
LOOKS = {
    method: (colour, *member)
    for colour, methods in _FAMILIES
    for method, member in zip(methods, _MEMBERS)
}

#: Grey levels that are shown: the skull is 1, all that lies in it 0 to 0.4.
_DARKEST, _BRIGHTEST = 0.0, 0.5

#: Pictures of a row, their edge, what stands above each, and the space around them (inches).
_COLUMNS, _EDGE, _TITLE, _SPACE = 6, 1.46, 0.43, 0.14
_MARGIN, _HEAD = 0.28, 0.62
#: Height of the colour bar with its labels, of the charts and what surrounds them (inches).
_BAR, _CHART, _ABOVE, _BELOW, _BETWEEN = 0.62, 2.7, 0.35, 0.5, 0.75
#: Entries in a row of the legend, and its height (inches).
_LEGEND_COLUMNS, _LEGEND_ROW = 6, 0.19


def method_panel(comparison: Comparison) -> Figure:
    """Draw the head, every reconstruction, error against time, and misfit against iterations.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    picture_rows = -(-(1 + len(comparison.results)) // _COLUMNS)
    pictures = picture_rows * (_TITLE + _EDGE)
    legend = -(-len(comparison.results) // _LEGEND_COLUMNS) * _LEGEND_ROW
    height = _HEAD + pictures + _BAR + _ABOVE + _CHART + _BELOW + legend + 0.1
    figure = style.new_figure(style.WIDTH_IN, height)
    style.add_heading(figure, TITLE, [_described(comparison)], _MARGIN)
    _draw_pictures(figure, comparison, height - _HEAD)
    top = _HEAD + pictures + _BAR + _ABOVE
    width = (style.WIDTH_IN - charts.LEFT_IN - charts.RIGHT_IN - _BETWEEN) / 2
    _draw_errors(charts.place(figure, charts.LEFT_IN, top, width, _CHART), comparison)
    right = charts.LEFT_IN + width + _BETWEEN
    _draw_misfits(charts.place(figure, right, top, width, _CHART), comparison)
    _draw_legend(figure, top + _CHART + _BELOW, comparison)
    return figure


def _described(comparison: Comparison) -> str:
    size = len(comparison.truth)
    noise = f"noise of {comparison.noise_percent:g} % of the largest projection"
    parts = [
        f"Shepp–Logan head, {size} × {size} pixels, {comparison.angles} parallel projections",
        noise if comparison.noise_percent else "no noise",
    ]
    if comparison.matrix_seconds:
        parts.append(f"ray paths, once for all: {_seconds(comparison.matrix_seconds)}")
    return "  ·  ".join(parts)


def _draw_pictures(figure: Figure, comparison: Comparison, top_in: float) -> None:
    """Draw the head and all reconstructions on one scale of greys, which stands below."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    scale = ScalarMappable(Normalize(_DARKEST, _BRIGHTEST), "gray")
    axes = page_axes(figure)
    best = comparison.best
    entries: list[tuple[np.ndarray, str, str, bool]] = [
        (comparison.truth, "the head itself", "", False)
    ]
    entries += [(one.image, one.method, _figures(one), one is best) for one in comparison.results]
    for number, (image, name, told, framed) in enumerate(entries):
        row, column = divmod(number, _COLUMNS)
        box = (
            _MARGIN + column * (_EDGE + _SPACE),
            top_in - (row + 1) * (_TITLE + _EDGE),
            _EDGE,
            _EDGE,
        )
        frame = _draw_picture(axes, box, image, scale, framed)
        if column == 0:
            below = frame
        for text, up, size, weight in (
            (name, 0.2, style.HEADING_SIZE, "bold"), (told, 0.055, style.TICK_SIZE, "normal"),
        ):  # fmt: skip
            axes.text(
                box[0], box[1] + _EDGE + up, text, fontsize=size, fontweight=weight,
                color=style.INK if weight == "bold" else style.MUTED, va="baseline",
            )  # fmt: skip
    values = np.concatenate([image.ravel() for image, *_ in entries])
    draw_colour_bar_below(below, values, scale, "Grey level", 0.14, 0.11)
    axes.text(
        _MARGIN + _EDGE + _SPACE, below.box[1] - 0.2,
        "ε = ‖R − T‖₂ / ‖T‖₂ of reconstruction R and head T; the smallest one is framed.",
        fontsize=style.TEXT_SIZE, color=style.MUTED, va="center",
    )  # fmt: skip


def _draw_picture(
    axes: Axes,
    box: tuple[float, float, float, float],
    image: np.ndarray,
    scale: ScalarMappable,
    framed: bool,
) -> Frame:
    from matplotlib.patches import Rectangle

    frame = place(axes, box, (0, 1, 0, 1))
    draw_image(frame, scale.to_rgba(image.T[::-1], bytes=True), (0, 1, 0, 1), "reconstruction")
    if framed:
        axes.add_artist(
            Rectangle(
                box[:2], *box[2:], fill=False, edgecolor=style.RAY, linewidth=2.2, zorder=3,
                gid="best",
            )
        )  # fmt: skip
    return frame


def _figures(result: MethodResult) -> str:
    steps = f"{result.iterations} it." if result.iterations > 1 else "direct"
    return f"ε {result.relative_error:.3g}  ·  {_seconds(result.seconds)}  ·  {steps}"


def _seconds(seconds: float) -> str:
    return f"{seconds:.2g} s" if seconds < 10 else f"{seconds:.0f} s"


def _draw_errors(axes: Axes, comparison: Comparison) -> None:
    """Draw the error against the time of every method."""
    results = comparison.results
    for one in results:
        colour, marker, _ = LOOKS[one.method]
        axes.plot(
            [one.seconds], [one.relative_error], linestyle="none", marker=marker, markersize=6.5,
            color=colour, markeredgecolor="white", markeredgewidth=0.6, zorder=3,
        )  # fmt: skip
    axes.axhline(comparison.grey_error, color=style.MUTED, linestyle=":", linewidth=1.0)
    axes.annotate(
        "one grey level", (1.0, comparison.grey_error), xycoords=("axes fraction", "data"),
        xytext=(-3, 2), textcoords="offset points", ha="right", fontsize=style.TICK_SIZE,
        color=style.MUTED,
    )  # fmt: skip
    errors = [one.relative_error for one in results]
    _log_axis(axes, "x", [one.seconds for one in results])
    _log_axis(axes, "y", [*errors, comparison.grey_error])
    charts.label(axes, "Time without that of the ray paths (s)", "Relative error ε")
    style.add_title(axes, "Error against time")


def _draw_misfits(axes: Axes, comparison: Comparison) -> None:
    """Draw the misfit against the iterations of every method that knows it."""
    shown = [one for one in comparison.results if len(one.misfit)]
    if not shown:
        axes.set_axis_off()
        return
    for one in shown:
        colour, marker, line = LOOKS[one.method]
        if len(one.misfit) == one.iterations + 1:
            axes.plot(
                np.arange(1, one.iterations + 1), one.misfit[1:], color=colour, linestyle=line,
                linewidth=style.LINE_WIDTH,
            )  # fmt: skip
        axes.plot(
            [one.iterations], [one.misfit[-1]], linestyle="none", marker=marker, markersize=5,
            color=colour, markeredgecolor="white", markeredgewidth=0.5, zorder=3, clip_on=False,
        )  # fmt: skip
    most = max(one.iterations for one in shown)
    misfits = np.concatenate([one.misfit[1:] for one in shown])
    charts.log_axis(axes, "x", 1.0, 1.25 * max(most, 2))
    _log_axis(axes, "y", misfits[misfits > 0])
    charts.label(axes, "Iterations", "RMS residual / RMS projection")
    style.add_title(axes, "Misfit of the projections")


def _log_axis(axes: Axes, which: str, values: list[float] | np.ndarray) -> None:
    """Give an axis a logarithmic scale around values."""
    charts.short_log_axis(axes, which, min(values) / 1.3, max(values) * 1.3)


def _draw_legend(figure: Figure, top_in: float, comparison: Comparison) -> None:
    from matplotlib.lines import Line2D

    samples = []
    for one in comparison.results:
        colour, marker, line = LOOKS[one.method]
        samples.append(
            Line2D(
                [], [], color=colour, linestyle=line, linewidth=style.LINE_WIDTH, marker=marker,
                markersize=5.5, markeredgecolor="white", markeredgewidth=0.5,
            )
        )  # fmt: skip
    names = [one.method for one in comparison.results]
    charts.legend(figure, top_in, samples, names, min(_LEGEND_COLUMNS, len(names)))
