"""One raster in telescope angles in one set of axes.

Pixels stand at the tangents of the angles from the boresight, so that they are squares;
the ticks name the angles.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import MuyscError
from ..telescope.directions import Pointing
from ..telescope.planning import HALF
from ..trajectories import TrajectoryMap
from . import style, ticks
from .colours import colour_scale, has_colour, pixel_colours

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable

#: Points along each line of the net of azimuths and elevations.
_NET_POINTS = 400


def edges(one: TrajectoryMap) -> tuple[float, float, float, float]:
    """Return left, right, bottom and top edge of the pixels, as tangents."""
    step_x, step_y = one.pixel_size
    return (
        float(one.x[0] - step_x / 2),
        float(one.x[-1] + step_x / 2),
        float(one.y[-1] - step_y / 2),
        float(one.y[0] + step_y / 2),
    )


def angle_ticks(low: float, high: float, count: int) -> tuple[np.ndarray, list[str]]:
    """Return tangents and labels of round angles between two tangents."""
    angles = ticks.angle_ticks(np.degrees(np.arctan(low)), np.degrees(np.arctan(high)), count)
    return np.tan(np.radians(angles)), [ticks.number_label(float(angle)) for angle in angles]


def draw_map(
    axes: Axes, one: TrajectoryMap, sky: np.ndarray | None = None
) -> tuple[ScalarMappable, dict[str, Artist]]:
    """Draw the pixels and angles; return the colour scale and legend entries."""
    from matplotlib.patches import Patch, Rectangle

    scale = colour_scale(one.values, one.kind)
    picture = pixel_colours(one.values, one.kind, sky, scale)
    left, right, bottom, top = edges(one)
    legend: dict[str, Artist] = {}
    opaque = picture[..., 3] == 255
    if not opaque.all():
        axes.add_patch(
            Rectangle((left, bottom), right - left, top - bottom, zorder=0, **style.UNKNOWN_LOOK)
        )
        legend["Unknown"] = Patch(**style.UNKNOWN_LOOK)
    if np.any(opaque & ~has_colour(one.values, one.kind, sky)):
        legend["Open sky"] = Patch(facecolor=style.SKY, edgecolor=style.MUTED, linewidth=0.5)
    axes.imshow(
        picture, extent=(left, right, bottom, top), aspect="auto", zorder=1,
        interpolation="nearest",
    )  # fmt: skip
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)
    return scale, legend


def label_angles(axes: Axes, across: int = 6, up: int = 6, names: bool = True) -> None:
    """Give axes in tangents round angles as ticks."""
    left, right = axes.get_xlim()
    bottom, top = axes.get_ylim()
    axes.set_xticks(*angle_ticks(left, right, across))
    axes.set_yticks(*angle_ticks(bottom, top, up))
    if names:
        axes.set_xlabel("Angle to the right (°)", fontsize=style.TEXT_SIZE, labelpad=2)
        axes.set_ylabel("Angle upwards (°)", fontsize=style.TEXT_SIZE, labelpad=2)
    style.style_axes(axes)


def draw_net(axes: Axes, pointing: Pointing) -> None:
    """Draw lines of equal azimuth and elevation with labels, the horizon heavier."""
    left, right = axes.get_xlim()
    bottom, top = axes.get_ylim()
    x, y = np.meshgrid(np.linspace(left, right, 60), np.linspace(bottom, top, 60))
    azimuth, elevation = pointing.sky(x, y)
    inside = (left, right, bottom, top)
    for value in ticks.angle_ticks(float(elevation.min()), float(elevation.max()), 6):
        if abs(value) < 90:
            along = np.linspace(azimuth.min(), azimuth.max(), _NET_POINTS)
            line = pointing.plane(along, np.full(_NET_POINTS, value))
            name = "horizon" if value == 0 else f"{ticks.number_label(float(value))}°"
            _net_line(axes, line, inside, name, heavy=value == 0, at_right=True)
    for value in ticks.angle_ticks(float(azimuth.min()), float(azimuth.max()), 7):
        along = np.linspace(max(elevation.min(), -89.0), min(elevation.max(), 89.0), _NET_POINTS)
        line = pointing.plane(np.full(_NET_POINTS, value), along)
        _net_line(axes, line, inside, ticks.azimuth_label(float(value)), False, at_right=False)


def _net_line(
    axes: Axes,
    line: tuple[np.ndarray, np.ndarray],
    inside: tuple[float, float, float, float],
    name: str,
    heavy: bool,
    at_right: bool,
) -> None:
    left, right, bottom, top = inside
    x, y = line
    with np.errstate(invalid="ignore"):
        shown = (x >= left) & (x <= right) & (y >= bottom) & (y <= top)
    if np.count_nonzero(shown) < 2:
        return
    colour = style.INK if heavy else "#9a9a9a"
    axes.plot(
        np.where(shown, x, np.nan), np.where(shown, y, np.nan),
        color=colour, alpha=0.9 if heavy else 0.6,
        linewidth=style.LINE_WIDTH if heavy else style.THIN_LINE_WIDTH,
        linestyle=(0, (5, 2)) if heavy else "-", zorder=2.5,
    )  # fmt: skip
    # Outside the picture, where the line leaves it at the right or at the top.
    end = int(np.nanargmax(np.where(shown, x if at_right else y, -np.inf)))
    reaches = (
        x[end] > right - 0.03 * (right - left) if at_right else y[end] > top - 0.03 * (top - bottom)
    )
    if reaches:
        axes.annotate(
            name,
            (right, y[end]) if at_right else (x[end], top),
            xytext=(3, 0) if at_right else (0, 2),
            textcoords="offset points",
            ha="left" if at_right else "center",
            va="center" if at_right else "bottom",
            fontsize=style.TICK_SIZE,
            color=style.INK if heavy else style.MUTED,
            annotation_clip=False,
        )


def draw_skyline(axes: Axes, one: TrajectoryMap, rock_share: np.ndarray) -> bool:
    """Draw the line between rock and sky; return whether it is in the picture."""
    if min(rock_share.shape) < 2 or not (np.any(rock_share > HALF) and np.any(rock_share < HALF)):
        return False
    axes.contour(
        one.x, one.y, np.ma.masked_invalid(rock_share), levels=[HALF],
        colors=[style.INK], linewidths=style.LINE_WIDTH, zorder=3,
    )  # fmt: skip
    return True


def draw_target(axes: Axes, one: TrajectoryMap) -> Artist | None:
    """Mark the target; None if it is not known or outside the picture."""
    try:
        x, y = one.pointing.plane(
            np.array(float(one.metadata["TARGET_AZIMUTH"])),
            np.array(float(one.metadata["TARGET_ELEVATION_ANGLE"])),
        )
    except (KeyError, MuyscError):
        return None
    left, right, bottom, top = edges(one)
    if not (left <= x <= right and bottom <= y <= top):
        return None
    (marker,) = axes.plot([float(x)], [float(y)], zorder=5, **style.TARGET_MARK)
    return marker
