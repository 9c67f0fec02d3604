"""Cuts with titles, arranged on a page: side by side, or one below the other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...volume import Volume
from ...workflows.tomography_result import Place, Tomography
from .. import style, ticks
from ..frames import Frame
from .cut_axes import draw_cut, fitted, write_title
from .cuts import Cut, mean_view, slice_at

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable

#: Room that a picture takes for the scale at its left (inches).
LEFT = 0.86
#: Room above a picture for its title, with and without a remark; below it for its scale, and
#: below that for a colour bar (inches).
ABOVE, ABOVE_PLAIN, BELOW, BAR = 0.42, 0.28, 0.48, 0.62
#: Height of a heading over several pictures, and of a colour bar (inches).
HEADING, BAR_HEIGHT = 0.34, 0.12

#: Title of each view, and what is averaged or summed in it.
VIEWS = {
    "top": ("Top view", "along the vertical"),
    "front": ("Front view", "from south to north"),
    "side": ("Side view", "from east to west"),
}


@dataclass(frozen=True)
class Picture:
    """A cut, its title, and where it holds rock."""

    title: str
    cut: Cut
    #: (n_across, n_up) of bool.
    rock: np.ndarray
    remark: str = ""


def views(volume: Volume, coverage: Volume) -> list[Picture]:
    """Return the means along the three axes: from the top, the front and the side."""
    return [
        Picture(
            title, mean_view(volume, name), np.isfinite(mean_view(coverage, name).values),
            f"mean {along}",
        )
        for name, (title, along) in VIEWS.items()
    ]  # fmt: skip


def slices(volume: Volume, coverage: Volume, place: Place) -> list[Picture]:
    """Return the level slice at a place, and the sections from west to east and south to north."""
    return [
        Picture(title, slice_at(volume, axis, at), np.isfinite(slice_at(coverage, axis, at).values))
        for axis, at, title in (
            (2, place.z, slice_title(place)),
            (1, place.y, f"West to east, at northing {_km(place.y)} km"),
            (0, place.x, f"South to north, at easting {_km(place.x)} km"),
        )
    ]


def slice_title(place: Place) -> str:
    """Return the title of the level slice at a place."""
    return f"Slice at {ticks.number_label(round(place.z))} m"


def _km(metres: float) -> str:
    return ticks.number_label(round(metres / 1e3, 2))


def middle_place(tomography: Tomography) -> Place:
    """Return where slices run: through the target, or the middle of the volume without one.

    The level slice is the one that the raster shows first, as a target may be where no ray is.
    """
    grid, target = tomography.grid, tomography.target
    middle = [0.5 * (low + high) for low, high in zip(grid.origin_m, grid.end_m)]
    wanted = middle[:2] if target is None else [target.x, target.y]
    # Of a target beyond the volume, the outermost slices are the nearest.
    x, y = (
        float(np.clip(value, low + size / 2, high - size / 2))
        for value, low, high, size in zip(wanted, grid.origin_m, grid.end_m, grid.size_m)
    )
    level = tomography.shown_level
    z = float(grid.centres_m(2)[level])
    if target is not None and abs(target.z - z) <= grid.size_m[2] / 2:
        z = target.z
    return Place("middle" if target is None else target.name, x, y, z)


def write_heading(axes: Axes, top: float, text: str) -> None:
    """Write a heading over several pictures, `HEADING` high, below a height on the page."""
    axes.text(
        style.MARGIN_IN, top - 0.22, style.plain(text), fontsize=style.HEADING_SIZE + 1,
        fontweight="bold", color=style.INK, va="baseline",
    )  # fmt: skip


def draw_picture(
    axes: Axes,
    left: float,
    top: float,
    picture: Picture,
    room_in: tuple[float, float],
    scale: ScalarMappable,
    upright_scale: bool = True,
) -> Frame:
    """Draw one picture below a height on the page, as large as fits a room, with its title."""
    size = fitted(picture.cut.size_m, room_in)
    corner = (left, top - size[1])
    frame = draw_cut(axes, corner, size, picture.cut, scale, picture.rock, upright_scale)
    write_title(frame, picture.title, picture.remark)
    return frame


def draw_below_each_other(
    axes: Axes,
    left: float,
    top: float,
    pictures: Sequence[Picture],
    room_in: tuple[float, float],
    scale: ScalarMappable,
) -> list[Frame]:
    """Draw pictures one below the other, the first below a height on the page."""
    frames = []
    for one in pictures:
        frames.append(draw_picture(axes, left, top, one, room_in, scale))
        top = frames[-1].box[1] - BELOW - above(one)
    return frames


def height_of(pictures: Sequence[Picture], room_in: tuple[float, float]) -> float:
    """Return the height (inches) of pictures one below the other, the last one's scale in it."""
    heights = [fitted(one.cut.size_m, room_in)[1] + BELOW for one in pictures]
    return sum(heights) + sum(above(one) for one in pictures[1:])


def above(picture: Picture) -> float:
    """Return the room (inches) above a picture."""
    return ABOVE if picture.remark else ABOVE_PLAIN
