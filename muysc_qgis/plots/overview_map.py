"""Overview map: shaded relief with the detector, the target and what is seen."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import fill
from typing import TYPE_CHECKING

import numpy as np

from ..topography.relief import Relief
from . import style, ticks
from .frames import new_axes
from .legend import draw_legend
from .map_marks import draw_surroundings

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Tint of the terrain from low to high: lightness rises with height, so that
#: it reads the same with any colour vision and in grey.
_TINT = ("#7f9e8d", "#b4bf9b", "#dccfa8", "#efe4cd", "#fbf8f2")

#: Of contour lines.
CONTOUR = "#4d4030"

#: Light from the north-west at half height, as on printed maps (degrees).
_LIGHT_AZIMUTH_DEG = 315.0
_LIGHT_ELEVATION_DEG = 45.0

#: Terrain heights along each side that are drawn at most.
_DRAWN = 600

#: And those that contours are traced through: a point every millimetre in print.
_CONTOURED = 180

#: Size of the map on the page (inches): its width, and the most of its height.
_MAP_WIDTH_IN = 6.3
_MAP_HEIGHT_IN = 6.0
_MAP_SMALLEST_IN = 2.4
_LEFT_IN = 0.72
_BELOW_IN = 0.55
_LEGEND_ROW_IN = 0.25


def overview_map(
    relief: Relief,
    target_east_north_m: tuple[float, float] | None = None,
    wedge: Sequence[np.ndarray] = (),
    ground: Sequence[np.ndarray] = (),
    detector_name: str = "Detector",
    target_name: str = "Target",
    title: str = "Where the detector stands and looks",
    subtitle: str = "",
) -> Figure:
    """Return a map of the terrain with what the detector sees.

    Parameters
    ----------
    relief
        Terrain; its extent is the map's.
    target_east_north_m
        Target, metres east and north of the detector.
    wedge
        Polygons of the field of view, (n, 2) metres east and north.
    ground
        Polygons of the ground seen, (n, 2) metres east and north.
    detector_name, target_name
        Names in the legend.
    title, subtitle
        Title, and a line below it.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    west, east, south, north = (value / 1e3 for value in _extent_m(relief))
    scale = min(_MAP_WIDTH_IN / (east - west), _MAP_HEIGHT_IN / (north - south))
    width, height = scale * (east - west), max(_MAP_SMALLEST_IN, scale * (north - south))
    title, lines = fill(title, 85), fill(subtitle, 135).splitlines()
    heading = style.heading_height_in(title, lines) + 0.1
    page = heading + height + _BELOW_IN
    figure = style.new_figure(style.WIDTH_IN, page)
    style.add_heading(figure, title, lines)
    axes = new_axes(figure, (_LEFT_IN, _BELOW_IN, width, height))
    legend = [
        *_draw_points(axes, target_east_north_m, detector_name, target_name),
        *_draw_areas(axes, wedge, ground),
        *_draw_terrain(axes, relief),
    ]
    axes.set_xlim(west, east)
    axes.set_ylim(south, north)
    axes.set_aspect("equal", anchor="NW")
    draw_surroundings(axes, (width, height), "East of the detector", "North of the detector")
    wrapped = [(fill(label, 34), artist) for label, artist in legend]
    draw_legend(
        figure, wrapped, _LEFT_IN + width + 0.15, _BELOW_IN + height, len(wrapped), _LEGEND_ROW_IN
    )
    return figure


def _extent_m(relief: Relief) -> tuple[float, float, float, float]:
    """Return the outer edges of the grid cells: west, east, south, north."""
    east, north = relief.east_m, relief.north_m
    half_east = (east[-1] - east[0]) / (len(east) - 1) / 2
    half_north = (north[-1] - north[0]) / (len(north) - 1) / 2
    return (
        float(east[0] - half_east),
        float(east[-1] + half_east),
        float(north[0] - half_north),
        float(north[-1] + half_north),
    )


def shaded(relief: Relief) -> np.ndarray:
    """Return the picture of the terrain, (n_north, n_east, 4) bytes, the northernmost row first.

    Tint by height, shade by the light from the north-west at the slopes' true
    steepness; transparent where the height is unknown.
    """
    from matplotlib.colors import LightSource, LinearSegmentedColormap, Normalize

    heights = relief.elevation_m[::-1]
    known = np.isfinite(heights)
    picture = np.zeros((*heights.shape, 4), dtype=np.uint8)
    if not known.any():
        return picture
    low, high = float(heights[known].min()), float(heights[known].max())
    filled = np.where(known, heights, low)
    tint = LinearSegmentedColormap.from_list("terrain tint", _TINT)
    colours = tint(Normalize(low, high if high > low else low + 1.0)(filled))[..., :3]
    step_east = (relief.east_m[-1] - relief.east_m[0]) / (len(relief.east_m) - 1)
    step_north = (relief.north_m[-1] - relief.north_m[0]) / (len(relief.north_m) - 1)
    light = LightSource(_LIGHT_AZIMUTH_DEG, _LIGHT_ELEVATION_DEG)
    # Level ground gets 0.71 of the light and so keeps 0.9 of its tint.
    shade = np.clip(light.hillshade(filled, dx=step_east, dy=step_north, fraction=1.0), 0.0, 1.0)
    picture[..., :3] = 255 * np.minimum(1.0, colours * (0.55 + 0.5 * shade[..., None]))
    picture[..., 3] = 255 * known
    return picture


def _draw_terrain(axes: Axes, relief: Relief) -> list[tuple[str, Artist]]:
    """Draw relief and elevation contours; return their legend entries."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch, Rectangle

    rows = -(-len(relief.north_m) // _DRAWN)
    columns = -(-len(relief.east_m) // _DRAWN)
    if min(len(relief.north_m[::rows]), len(relief.east_m[::columns])) >= 2:
        relief = Relief(
            relief.east_m[::columns], relief.north_m[::rows], relief.elevation_m[::rows, ::columns]
        )
    extent = [value / 1e3 for value in _extent_m(relief)]
    legend: list[tuple[str, Artist]] = []
    known = np.isfinite(relief.elevation_m)
    if not known.all():
        west, east, south, north = extent
        axes.add_patch(
            Rectangle((west, south), east - west, north - south, zorder=0, **style.UNKNOWN_LOOK)
        )
        legend.append(("No elevation known", Patch(**style.UNKNOWN_LOOK)))
    axes.imshow(shaded(relief), extent=extent, aspect="equal", interpolation="nearest", zorder=1)
    heights = relief.elevation_m[known]
    if heights.size == 0 or np.ptp(heights) == 0:
        return legend
    step = ticks.round_step(float(np.ptp(heights)), 15)
    levels = ticks.multiples(float(heights.min()), float(heights.max()), step)
    thinned = slice(None, None, -(-max(relief.elevation_m.shape) // _CONTOURED))
    lines = axes.contour(
        relief.east_m[thinned] / 1e3, relief.north_m[thinned] / 1e3,
        np.ma.masked_invalid(relief.elevation_m[thinned, thinned]), levels=levels,
        colors=[CONTOUR], linewidths=0.45, alpha=0.75, zorder=2,
    )  # fmt: skip
    axes.clabel(
        lines,
        [level for level in levels if round(level / step) % 2 == 0],
        fontsize=style.CONTOUR_SIZE - 1,
        fmt=ticks.number_label,
        inline_spacing=2,
    )
    example = Line2D([], [], color=CONTOUR, linewidth=0.6)
    return [(f"Elevation, every {ticks.number_label(step)} m", example), *legend]


def _draw_areas(
    axes: Axes, wedge: Sequence[np.ndarray], ground: Sequence[np.ndarray]
) -> list[tuple[str, Artist]]:
    """Draw the ground seen and the field of view; return their legend entries."""
    from matplotlib.collections import PolyCollection
    from matplotlib.colors import to_rgba
    from matplotlib.patches import Patch

    legend: list[tuple[str, Artist]] = []
    seen = {
        "facecolor": to_rgba(style.GROUND_SEEN, 0.45),
        "edgecolor": style.GROUND_SEEN,
        "linewidth": 0.5,
    }
    view = {
        "facecolor": "none",
        "edgecolor": style.INK,
        "linewidth": style.LINE_WIDTH,
        "linestyle": "--",
    }
    for polygons, look, label, order in (
        (wedge, view, "Field of view", 4), (ground, seen, "Ground seen", 3)
    ):  # fmt: skip
        if len(polygons):
            outlines = [np.asarray(polygon, dtype=float) / 1e3 for polygon in polygons]
            axes.add_collection(PolyCollection(outlines, zorder=order, **look), autolim=False)
            legend.append((label, Patch(**look)))
    return legend


def _draw_points(
    axes: Axes, target_m: tuple[float, float] | None, detector_name: str, target_name: str
) -> list[tuple[str, Artist]]:
    """Mark detector, target and the line between them; return the legend entries."""
    (detector,) = axes.plot([0.0], [0.0], zorder=7, **style.DETECTOR_MARK)
    if target_m is None:
        return [(detector_name, detector)]
    east, north = target_m[0] / 1e3, target_m[1] / 1e3
    (line,) = axes.plot([0.0, east], [0.0, north], color=style.INK, linewidth=0.9, zorder=5)
    (target,) = axes.plot([east], [north], zorder=7, **style.TARGET_MARK)
    length = float(np.hypot(east, north))
    text = f"{length * 1e3:.0f} m" if length < 10 else f"{length:.1f} km"
    return [(detector_name, detector), (target_name, target), (f"Line to the target, {text}", line)]
