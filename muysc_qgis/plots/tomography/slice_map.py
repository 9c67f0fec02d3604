"""A level slice of a volume on the map, with the terrain, the stations and where sections run."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...topography.relief import Relief
from ...workflows.tomography_result import Place, Tomography
from .. import style, ticks
from ..frames import Box, new_axes
from ..map_marks import draw_surroundings
from ..overview_map import CONTOUR, shaded
from .cut_axes import cell_colours
from .cuts import EASTING, NORTHING, slice_at

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.figure import Figure

#: Share of its size by which the map reaches beyond what it shows.
_MARGIN = 0.06

#: How far beyond the volume, in its own widths, a station still widens the map.
_FAR = 1.0

#: How much of the relief shows through white, so that colours on it stand out.
_RELIEF = 0.55

_STATION = {**style.DETECTOR_MARK, "markersize": 7, "zorder": 7}
_SECTION = {"color": style.RAY, "linewidth": 1.0, "linestyle": (0, (5, 2)), "zorder": 6}
_VOLUME = {"edgecolor": style.INK, "linewidth": 0.9, "facecolor": "none", "zorder": 5}

Bounds = tuple[float, float, float, float]


def map_bounds(tomography: Tomography) -> Bounds:
    """Return west, east, south and north of the map (m), around the volume and its stations."""
    grid = tomography.grid
    low, high = np.array(grid.origin_m[:2]), np.array(grid.end_m[:2])
    reach = _FAR * (high - low)
    points = np.array([(one.x, one.y) for one in tomography.stations]).reshape(-1, 2)
    near = points[np.all((points >= low - reach) & (points <= high + reach), axis=1)]
    west, south = np.minimum(low, near.min(axis=0)) if len(near) else low
    east, north = np.maximum(high, near.max(axis=0)) if len(near) else high
    margin = _MARGIN * max(east - west, north - south)
    return (
        float(west - margin), float(east + margin), float(south - margin), float(north + margin)
    )  # fmt: skip


def draw_slice_map(
    figure: Figure,
    box: Box,
    tomography: Tomography,
    place: Place,
    scale: ScalarMappable,
    relief: Relief | None,
) -> list[tuple[str, Artist]]:
    """Draw the slice at a place; return legend entries.

    Parameters
    ----------
    figure, box
        Where: left, bottom, width and height (inches), of the shape of `map_bounds`.
    tomography
        What is drawn.
    place
        Where slice and sections run.
    scale
        Colours of densities.
    relief
        Terrain in the CRS of the volume, if it is known.
    """
    axes = new_axes(figure, box)
    west, east, south, north = (value / 1e3 for value in map_bounds(tomography))
    # What is drawn must not change the limits.
    axes.set(xlim=(west, east), ylim=(south, north), autoscale_on=False)
    legend = [] if relief is None else _draw_relief(axes, relief, place.z)
    cut = slice_at(tomography.density, 2, place.z)
    rock = np.isfinite(slice_at(tomography.coverage, 2, place.z).values)
    axes.imshow(
        cell_colours(cut, scale, rock), extent=[edge / 1e3 for edge in cut.limits_m],
        interpolation="nearest", aspect="auto", zorder=2,
    )  # fmt: skip
    legend = [*_draw_marks(axes, tomography, place), *legend]
    draw_surroundings(axes, box[2:], EASTING, NORTHING)
    return legend


def _draw_relief(axes: Axes, relief: Relief, height_m: float) -> list[tuple[str, Artist]]:
    """Draw the relief in greys, with contours, the one at a height in bold."""
    from matplotlib.lines import Line2D

    east, north = relief.east_m / 1e3, relief.north_m / 1e3
    half = (east[1] - east[0]) / 2
    picture = shaded(relief)
    grey = picture[..., :3].mean(axis=-1)
    picture[..., :3] = (255 - _RELIEF * (255 - grey))[..., None]
    axes.imshow(
        picture, extent=(east[0] - half, east[-1] + half, north[0] - half, north[-1] + half),
        interpolation="nearest", aspect="auto", zorder=1,
    )  # fmt: skip
    known = relief.elevation_m[np.isfinite(relief.elevation_m)]
    if known.size == 0 or np.ptp(known) == 0:
        return []
    heights = np.ma.masked_invalid(relief.elevation_m)
    step = ticks.round_step(float(np.ptp(known)), 12)
    levels = ticks.multiples(float(known.min()), float(known.max()), step)
    axes.contour(
        east, north, heights, levels=levels, colors=[CONTOUR], linewidths=0.4, alpha=0.6, zorder=3
    )
    legend: list[tuple[str, Artist]] = [
        (f"Elevation, every {ticks.number_label(step)} m",
         Line2D([], [], color=CONTOUR, linewidth=0.6)),
    ]  # fmt: skip
    if known.min() < height_m < known.max():
        axes.contour(
            east, north, heights, levels=[height_m], colors=[style.INK], linewidths=1.4, zorder=4
        )
        legend.insert(0, ("Ground at the slice", Line2D([], [], color=style.INK, linewidth=1.4)))
    return legend


def _draw_marks(axes: Axes, tomography: Tomography, place: Place) -> list[tuple[str, Artist]]:
    """Draw volume, sections, stations and target; return their legend entries."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Rectangle

    grid = tomography.grid
    west, south = (value / 1e3 for value in grid.origin_m[:2])
    east, north = (value / 1e3 for value in grid.end_m[:2])
    axes.add_patch(Rectangle((west, south), east - west, north - south, **_VOLUME))
    x, y = place.x / 1e3, place.y / 1e3
    axes.add_line(Line2D([west, east], [y, y], **_SECTION))
    axes.add_line(Line2D([x, x], [south, north], **_SECTION))
    points = np.array([(one.x, one.y) for one in tomography.stations]).reshape(-1, 2) / 1e3
    left, right = axes.get_xlim()
    bottom, top = axes.get_ylim()
    inside = (
        (points[:, 0] >= left) & (points[:, 0] <= right)
        & (points[:, 1] >= bottom) & (points[:, 1] <= top)
    )  # fmt: skip
    (stations,) = axes.plot(points[inside, 0], points[inside, 1], **_STATION)
    beyond = len(points) - int(np.count_nonzero(inside))
    label = "Stations" if not beyond else f"Stations ({beyond} more outside the map)"
    legend: list[tuple[str, Artist]] = [
        (label, stations),
        ("Sections", Line2D([], [], **_SECTION)),
        ("Volume", Rectangle((0, 0), 1, 1, **_VOLUME)),
    ]
    if tomography.target is not None:
        (target,) = axes.plot(
            [tomography.target.x / 1e3], [tomography.target.y / 1e3], zorder=8, **style.TARGET_MARK
        )
        legend.insert(1, ("Target", target))
    return legend
