"""Contour lines of a muogram, with labels where there is room for them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..muogram import Muogram
from ..quantities import Quantity
from . import style, ticks
from .colours import ink_on
from .directions import Directions
from .frames import Frame

if TYPE_CHECKING:
    from matplotlib.cm import ScalarMappable
    from matplotlib.contour import ContourSet

#: Directions along each side that lines are traced through at most; more cost
#: time and cannot be told apart in print.
_TRACED = 250

#: Units short enough to stand in a label.
_SHORT_UNITS = ("m", "GeV", "days")

#: Points looked at along one line, and along one obstacle.
_CANDIDATES = 60
_OBSTACLES = 150

#: Room that a label needs around its middle (inches), and the length a line
#: needs to carry one.
_ROOM_IN = 0.12
_SHORTEST_IN = 0.8

#: Width (points) of white lines and letters with their dark edge.
_EDGE_POINTS = 2.0

#: By how much distances between labels count less along x and y: labels are
#: longer than high, and slanted ones higher than a line of text.
_FLAT = np.array([0.28, 0.35])


def draw_skyline(
    frame: Frame, directions: Directions, sky: np.ndarray, known: np.ndarray
) -> ContourSet | None:
    """Draw the line between rock and open sky; None if it is not in the picture.

    Parameters
    ----------
    frame
        Where to draw.
    directions
        The pixel grid.
    sky
        (n_elevation, n_azimuth), true where the ray meets no rock.
    known
        (n_elevation, n_azimuth), true where that is known.
    """
    if not np.any(sky & known) or not np.any(~sky & known):
        return None
    azimuth, zenith, rock = traced(
        directions, np.where(known, np.where(sky, 0.0, 1.0), np.nan), 2 * _TRACED
    )
    return frame.axes.contour(
        azimuth,
        zenith,
        np.ma.masked_invalid(rock),
        levels=[0.5],
        transform=frame.values,
        colors=[style.INK],
        linewidths=style.LINE_WIDTH,
        zorder=3,
    )


def draw_contours(
    frame: Frame,
    muogram: Muogram,
    directions: Directions,
    sky: np.ndarray | None,
    scale: ScalarMappable | None,
    skyline: ContourSet | None,
) -> None:
    """Draw labelled contour lines at round values in the rock.

    The open sky is left out, or all lines would crowd along the skyline. A
    single row or column of directions has none.

    Parameters
    ----------
    frame, muogram, directions
        Where and what to draw.
    sky
        (n_elevation, n_azimuth), true where the ray meets no rock; None where
        that is not known.
    scale
        Colours of the pixels; lines are black or white, whichever stands out. None for
        lines over the pixels of another quantity, white with a dark edge.
    skyline
        From `draw_skyline`; labels keep away from it.
    """
    values = muogram.values if sky is None else np.where(sky, np.nan, muogram.values)
    levels = ticks.contour_levels(values, muogram.kind)
    if levels.size == 0 or min(values.shape) < 2:
        return
    azimuth, zenith, values = traced(directions, values, _TRACED)
    # In the coordinates of the axes, where labels are placed and lines are cut for them.
    across = frame.on_page(np.column_stack([azimuth, np.full_like(azimuth, zenith[0])]))[:, 0]
    down = frame.on_page(np.column_stack([np.full_like(zenith, azimuth[0]), zenith]))[:, 1]
    lines = frame.axes.contour(
        across,
        down,
        np.ma.masked_invalid(values),
        levels=levels,
        colors=["white" if scale is None else ink_on(scale.to_rgba(level)) for level in levels],
        linewidths=style.THIN_LINE_WIDTH,
        zorder=2,
    )
    if scale is None:
        _add_edge(lines)
    obstacles = [directions.frame_deg, *(skyline.allsegs[0] if skyline else [])]
    target = np.reshape(directions.target_deg or [], (-1, 2))
    places = label_places(lines.allsegs, [*map(frame.on_page, obstacles)], frame.on_page(target))
    if places:
        labels = frame.axes.clabel(
            lines,
            fontsize=style.CONTOUR_SIZE,
            fmt=lambda level: contour_label(level, muogram.kind),
            inline_spacing=2,
            manual=places,
        )
        if scale is None:
            for label in labels:
                _add_edge(label)


def _add_edge(drawn: Any) -> None:
    """Give lines or text a dark edge, so that white stands out from any colour."""
    from matplotlib.patheffects import withStroke

    # Contour lines are one artist from matplotlib 3.8 on, and one a level before.
    for artist in [drawn] if hasattr(drawn, "set_path_effects") else drawn.collections:
        artist.set_path_effects([withStroke(linewidth=_EDGE_POINTS, foreground=style.INK)])


def traced(
    directions: Directions, values: np.ndarray, most: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return azimuths, zeniths and values to trace lines through.

    The grid is thinned out to at most `most` values a side, and the outermost
    pixels are carried on to their outer edges, so that lines reach the frame.
    """
    rows, columns = (slice(None, None, -(-length // most)) for length in values.shape)
    azimuth, zenith = directions.azimuth_edges_deg, directions.zenith_edges_deg
    return (
        np.concatenate([azimuth[:1], directions.azimuth_deg[columns], azimuth[-1:]]),
        np.concatenate([zenith[:1], directions.zenith_deg[rows], zenith[-1:]]),
        np.pad(values[rows, columns], 1, mode="edge"),
    )


def contour_label(value: float, quantity: Quantity) -> str:
    """Return the label of a contour line, with the unit if it is short."""
    unit = f" {quantity.unit}" if quantity.unit in _SHORT_UNITS else ""
    return ticks.number_label(value) + unit


def label_places(
    levels: list[list[np.ndarray]],
    obstacles: list[np.ndarray],
    marks: np.ndarray,
) -> list[tuple[float, float]]:
    """Return where to label contour lines: where they are farthest from all else.

    Each level is labelled once, on its longest line, at the point whose nearest
    obstacle, other line or label is the farthest away; not at all where that
    is too near or the line too short.

    Parameters
    ----------
    levels
        For each level its lines, (n, 2) inches each, as all that follows.
    obstacles
        (n, 2) points of lines that must stay readable.
    marks
        (n, 2) points that need as much room as a label.

    Returns
    -------
    A point on a line for each level that is labelled.
    """
    longest = [max(lines, key=_length, default=None) for lines in levels]
    fixed = [_thinned(points, _OBSTACLES) for points in obstacles]
    taken = [*marks]
    places: list[np.ndarray] = []
    for level, line in enumerate(longest):
        if line is None or _length(line) < _SHORTEST_IN:
            continue
        candidates = _thinned(line, _CANDIDATES)
        # The ends lie on the frame or on the skyline.
        candidates = candidates[len(candidates) // 8 : -(len(candidates) // 8) or None]
        others = [
            _thinned(other, _OBSTACLES)
            for number, lines in enumerate(levels)
            if number != level
            for other in lines
        ]
        clear = np.minimum(
            _clearance(candidates, np.concatenate([*fixed, *others, np.empty((0, 2))])),
            # Two labels side by side need room for half their lengths.
            _clearance(candidates * _FLAT, np.reshape(taken, (-1, 2)) * _FLAT),
        )
        best = int(clear.argmax())
        if clear[best] >= _ROOM_IN:
            places.append(candidates[best])
            taken.append(candidates[best])
    return [(float(x), float(y)) for x, y in places]


def _clearance(candidates: np.ndarray, obstacles: np.ndarray) -> np.ndarray:
    """Return the distance of each candidate from the nearest obstacle."""
    if len(obstacles) == 0:
        return np.full(len(candidates), np.inf)
    return np.asarray(np.hypot(*(candidates[:, None] - obstacles).T).min(axis=0))


def _length(line: np.ndarray) -> float:
    """Return the length of a line through (n, 2) points."""
    return float(np.hypot(*np.diff(line, axis=0).T).sum())


def _thinned(points: np.ndarray, most: int) -> np.ndarray:
    """Return every n-th of the points, at most `most` of them."""
    return points[:: -(-len(points) // most)] if len(points) else points.reshape(0, 2)
