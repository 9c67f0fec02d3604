"""One muogram in its frame: pixels, target, angles."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..muogram import Muogram
from . import style, ticks
from .colours import colour_scale, has_colour, pixel_colours
from .directions import Directions, even_picture
from .frames import Frame, draw_image
from .scales import draw_scale

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.cm import ScalarMappable

#: Room for a tick with its label along and up a scale (inches).
_TICK_ROOM_IN = 0.5
_TICK_ROW_IN = 0.25

#: Compass letters above the axes, and the name of the scale above them (points).
_LETTERS = 15.0
_ABOVE_LETTERS = 12.0


def draw_pixels(
    frame: Frame, muogram: Muogram, directions: Directions, sky: np.ndarray | None
) -> tuple[ScalarMappable, dict[str, Artist]]:
    """Draw the pixels.

    Returns
    -------
    scale, legend
        The colour scale, and the legend entries by their label.
    """
    from matplotlib.patches import Patch, Rectangle

    scale = colour_scale(muogram.values, muogram.kind)
    picture = pixel_colours(muogram.values, muogram.kind, sky, scale)
    legend: dict[str, Artist] = {}
    opaque = picture[..., 3] == 255
    if not opaque.all():
        frame.axes.add_artist(
            Rectangle((0, 0), 1, 1, transform=frame.shares, zorder=0, **style.UNKNOWN_LOOK)
        )
        legend["Unknown"] = Patch(**style.UNKNOWN_LOOK)
    if np.any(opaque & ~has_colour(muogram.values, muogram.kind, sky)):
        legend["Open sky"] = Patch(facecolor=style.SKY, edgecolor=style.MUTED, linewidth=0.5)
    draw_image(frame, even_picture(picture, directions), directions.extent_deg, "pixels")
    return scale, legend


def draw_target(frame: Frame, directions: Directions) -> Artist | None:
    """Mark the target; None if it is not known or outside the picture."""
    if directions.target_deg is None:
        return None
    from matplotlib.lines import Line2D

    azimuth, zenith = directions.target_deg
    left, right, bottom, top = directions.extent_deg
    if not (left <= azimuth <= right and top <= zenith <= bottom):
        return None
    marker = Line2D(
        [azimuth], [zenith], transform=frame.values, zorder=5, gid="target", **style.TARGET_MARK
    )
    frame.axes.add_artist(marker)
    return marker


def draw_note(frame: Frame, text: str) -> None:
    """Say in the upper half of the frame, off the target, why there is nothing else to see."""
    frame.axes.text(
        0.5,
        0.75,
        text,
        transform=frame.shares,
        ha="center",
        va="center",
        fontsize=style.TEXT_SIZE,
        color=style.INK,
        bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 4},
        zorder=6,
    )


def draw_angles(
    frame: Frame, directions: Directions, below: bool = True, beside: bool = True
) -> None:
    """Give the frame azimuths at the bottom and zenith angles at the left.

    Parameters
    ----------
    frame, directions
        Where, and which.
    below, beside
        Whether ticks at the bottom and at the left are labelled; not where another
        picture says the same.
    """
    left, right, bottom, top = directions.extent_deg
    *_, width_in, height_in = frame.box
    relative = directions.target_deg is not None or directions.origin_deg != 0.0
    azimuth = "Azimuth from the boresight (°)" if relative else "Azimuth (°)"
    across = ticks.angle_ticks(left, right, max(2, int(width_in / _TICK_ROOM_IN)))
    down = ticks.angle_ticks(top, bottom, max(2, int(height_in / _TICK_ROW_IN)))
    for side, positions, name, labelled in (
        ("bottom", across, azimuth, below), ("left", down, "Zenith angle (°)", beside)
    ):  # fmt: skip
        draw_scale(frame, side, positions, None if labelled else (), name if labelled else "")


def add_compass(frame: Frame, directions: Directions) -> None:
    """Add the azimuth from north with compass letters along the top."""
    from matplotlib.transforms import ScaledTranslation, blended_transform_factory

    left, right, *_ = directions.extent_deg
    first, last = left + directions.origin_deg, right + directions.origin_deg
    *_, width_in, _ = frame.box
    azimuths = ticks.angle_ticks(first, last, max(2, int(width_in / _TICK_ROOM_IN)))
    draw_scale(
        frame,
        "top",
        azimuths - directions.origin_deg,
        [ticks.azimuth_label(azimuth) for azimuth in azimuths],
        "Azimuth from north (°)",
        name_at_end=True,
        gap=_ABOVE_LETTERS,
    )
    above = blended_transform_factory(frame.values, frame.shares) + ScaledTranslation(
        0, _LETTERS / 72, frame.axes.figure.dpi_scale_trans
    )
    for azimuth, letter in ticks.compass_points(first, last):
        frame.axes.figure.text(
            azimuth - directions.origin_deg, 1.0, letter, transform=above, ha="center",
            va="bottom", fontsize=style.TICK_SIZE, fontweight="bold", color=style.INK,
            gid="compass",
        )  # fmt: skip


def add_elevation(frame: Frame, directions: Directions) -> None:
    """Add the elevation above the horizon along the right."""
    *_, bottom, top = directions.extent_deg
    *_, height_in = frame.box
    elevations = ticks.angle_ticks(90.0 - bottom, 90.0 - top, max(2, int(height_in / _TICK_ROW_IN)))
    draw_scale(
        frame,
        "right",
        90.0 - elevations,
        [ticks.number_label(elevation) for elevation in elevations],
        "Elevation (°)",
    )
