"""A telescope as it stands: planes of crossed bars, pixels that a muon meets, aperture."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..telescope.geometry import TelescopeGeometry
from . import style, ticks

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Directions of the picture in which the telescope's right, up and forward are seen.
_RIGHT = np.array([0.62, -0.24])
_UP = np.array([0.0, 1.0])
_FORWARD = np.array([0.93, 0.30])

#: Bars drawn on a plane at most: thinner ones would run together.
_BARS_DRAWN = 32


def draw_telescope(axes: Axes, geometry: TelescopeGeometry) -> None:
    """Draw the planes in parallel projection with a muon and the sizes.

    The muon flies from the front plane, which looks at the mountain, to the back plane.
    """
    # Off the axis, so that the bars crossed can be told.
    back = _pixel_middle(geometry, 0.3, 0.35)
    front = _pixel_middle(geometry, 0.75, 0.7)
    for number in reversed(range(geometry.planes)):
        outer = number in (0, geometry.planes - 1)
        share = number / (geometry.planes - 1)
        # Nearer ones hide those behind.
        distance, order = share * geometry.separation_cm, 2 - share
        _draw_plane(axes, geometry, distance, 0.92 if outer else 0.6, order)
        if outer:
            _draw_pixel(axes, back if number == 0 else front, distance, geometry, order + 0.02)
    _draw_muon(axes, back, front, geometry.separation_cm)
    _write_sizes(axes, geometry)
    axes.set_aspect("equal")
    axes.axis("off")
    axes.margins(0.04)


def _seen(right: float, up: float, forward: float) -> np.ndarray:
    """Return where on the page a point of the telescope is seen, (2,)."""
    return np.asarray(right * _RIGHT + up * _UP + forward * _FORWARD)


def _rectangle(
    middle: tuple[float, float], width: float, height: float, forward: float
) -> np.ndarray:
    """Return the corners of a rectangle across the telescope as they are seen, (2, 4)."""
    across, up = middle
    return np.array(
        [
            _seen(across + a * width / 2, up + b * height / 2, forward)
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
        ]
    ).T


def _draw_plane(
    axes: Axes, geometry: TelescopeGeometry, distance: float, opacity: float, order: float
) -> None:
    """Draw a plane with its bars."""
    width = geometry.bars_x * geometry.pixel_size_cm
    height = geometry.bars_y * geometry.pixel_size_cm
    axes.fill(*_rectangle((0, 0), width, height, distance), facecolor="#eef3f7",
              edgecolor=style.INK, linewidth=0.9, alpha=opacity, zorder=order)  # fmt: skip
    bars = [
        [_seen(x, -height / 2, distance), _seen(x, height / 2, distance)]
        for x in _between_bars(geometry.bars_x, width)
    ] + [
        [_seen(-width / 2, y, distance), _seen(width / 2, y, distance)]
        for y in _between_bars(geometry.bars_y, height)
    ]
    for ends in bars:
        axes.plot(*np.array(ends).T, color=style.MUTED, linewidth=0.25, alpha=0.5,
                  zorder=order + 0.01)  # fmt: skip


def _between_bars(count: int, size: float) -> np.ndarray:
    return np.linspace(-size / 2, size / 2, min(count, _BARS_DRAWN) + 1)[1:-1]


def _draw_pixel(
    axes: Axes,
    middle: tuple[float, float],
    distance: float,
    geometry: TelescopeGeometry,
    order: float,
) -> None:
    """Draw a pixel that the muon meets."""
    pixel = geometry.pixel_size_cm
    axes.plot(*_seen(*middle, distance), marker="o", markersize=4.5, color=style.RAY, zorder=6)
    axes.fill(*_rectangle(middle, pixel, pixel, distance), facecolor=style.RAY, edgecolor="none",
              zorder=order)  # fmt: skip


def _pixel_middle(geometry: TelescopeGeometry, across: float, up: float) -> tuple[float, float]:
    """Return the middle of the pixel at a share of the plane, from the plane's middle."""

    def one(bars: int, share: float) -> float:
        bar = min(int(bars * share), bars - 1)
        return (bar + 0.5 - bars / 2) * geometry.pixel_size_cm

    return one(geometry.bars_x, across), one(geometry.bars_y, up)


def _draw_muon(
    axes: Axes, back: tuple[float, float], front: tuple[float, float], depth: float
) -> None:
    def point(share: float) -> np.ndarray:
        return _seen(
            back[0] + share * (front[0] - back[0]),
            back[1] + share * (front[1] - back[1]),
            share * depth,
        )

    start, end = point(1.28), point(-0.22)
    axes.annotate(
        "", end, start, zorder=5,
        arrowprops={"arrowstyle": "-|>", "color": style.RAY, "linewidth": 1.4, "shrinkA": 0,
                    "shrinkB": 0},
    )  # fmt: skip
    axes.plot(*np.array([start, end]).T, alpha=0)
    axes.annotate(
        "muon", start, xytext=(3, 3), textcoords="offset points",
        fontsize=style.TEXT_SIZE, color=style.RAY, va="bottom",
    )  # fmt: skip


def _write_sizes(axes: Axes, geometry: TelescopeGeometry) -> None:
    width = geometry.bars_x * geometry.pixel_size_cm
    height = geometry.bars_y * geometry.pixel_size_cm
    gap = 0.07 * max(width, height)
    down = -height / 2 - gap
    for ends, text, place in (
        (
            [_seen(width / 2, down, 0), _seen(width / 2, down, geometry.separation_cm)],
            f"{ticks.number_label(geometry.separation_cm)} cm", (6, -9),
        ),
        (
            [_seen(-width / 2, down, 0), _seen(width / 2, down, 0)],
            f"{ticks.number_label(round(width, 6))} cm", (-10, -12),
        ),
        (
            [_seen(-width / 2 - gap, -height / 2, 0), _seen(-width / 2 - gap, height / 2, 0)],
            f"{ticks.number_label(round(height, 6))} cm", (-4, 0),
        ),
    ):  # fmt: skip
        axes.annotate(
            "", ends[1], ends[0],
            arrowprops={"arrowstyle": "<->", "color": style.MUTED, "linewidth": 0.8,
                        "shrinkA": 0, "shrinkB": 0},
        )  # fmt: skip
        axes.plot(*np.array(ends).T, alpha=0)
        axes.annotate(
            text, (np.array(ends[0]) + ends[1]) / 2, xytext=place, textcoords="offset points",
            fontsize=style.TICK_SIZE, color=style.INK, ha="right" if place[0] == -4 else "center",
            va="center",
        )  # fmt: skip


def draw_aperture(axes: Axes, geometry: TelescopeGeometry) -> None:
    """Draw the telescope from the side in its true shape with the angles that it sees."""
    half = geometry.bars_y * geometry.pixel_size_cm / 2
    depth = geometry.separation_cm
    reach = 1.9 * max(depth, half)
    angle = np.radians(geometry.half_aperture_deg[1])
    # All that crosses both planes lies between the outermost diagonals.
    for sign in (-1, 1):
        ends = np.array([[0, -sign * half], [reach, -sign * half + sign * reach * np.tan(angle)]])
        axes.plot(*ends.T, color=style.RAY, linewidth=style.LINE_WIDTH, zorder=3)
    beyond = np.array(
        [
            [depth, half], [reach, reach * np.tan(angle) - half],
            [reach, half - reach * np.tan(angle)], [depth, -half],
        ]
    )  # fmt: skip
    axes.fill(*beyond.T, facecolor="#fbe3d3", edgecolor="none", zorder=0)
    axes.fill([0, depth, depth, 0], [half, half, -half, -half], facecolor="#fbe3d3",
              edgecolor="none", zorder=0)  # fmt: skip
    for distance in np.linspace(0, depth, geometry.planes):
        axes.plot([distance] * 2, [-half, half], color=style.DETECTOR, linewidth=3.0, zorder=4,
                  solid_capstyle="butt")  # fmt: skip
    axes.plot([0, reach], [0, 0], color=style.MUTED, linewidth=style.THIN_LINE_WIDTH,
              linestyle=(0, (6, 3)), zorder=2)  # fmt: skip
    across, up = geometry.half_aperture_deg
    text = f"±{across:.1f}°" if across == up else f"±{up:.1f}° up\n±{across:.1f}° across"
    axes.annotate(
        text, (reach, 0), xytext=(-4, 3), textcoords="offset points", ha="right", va="bottom",
        fontsize=style.TEXT_SIZE, color=style.INK,
    )  # fmt: skip
    limit = 1.08 * max(half, reach * np.tan(angle) - half)
    axes.set_xlim(-0.05 * reach, 1.02 * reach)
    axes.set_ylim(-limit, limit)
    axes.set_aspect("equal", adjustable="datalim")
    axes.axis("off")
