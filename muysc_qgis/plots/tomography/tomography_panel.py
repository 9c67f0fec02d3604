"""The panel of a tomography: slices through the target, views, coverage and errors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...topography.relief import Relief
from ...workflows.tomography_result import Place, Tomography
from .. import style, ticks
from ..frames import Frame, page_axes
from ..legend import draw_legend
from ..scales import draw_colour_bar_below
from . import volume_scales
from .cut_axes import GROUND_LINE, UNSEEN, draw_ground, draw_target, fitted
from .cuts import ground_between
from .pictures import (
    ABOVE,
    ABOVE_PLAIN,
    BAR,
    BAR_HEIGHT,
    BELOW,
    HEADING,
    LEFT,
    Picture,
    draw_below_each_other,
    draw_picture,
    height_of,
    middle_place,
    slice_title,
    slices,
    views,
    write_heading,
)
from .slice_map import draw_slice_map, map_bounds

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.figure import Figure

TITLE = "Muon tomography"

#: The map at most, a level picture, and the vertical ones beside them (inches).
_MAP, _LEVEL, _VERTICAL = (4.2, 4.9), (3.3, 3.3), (3.95, 2.2)
#: Left edges of the vertical pictures beside the map and beside a level one.
_BESIDE_MAP = style.WIDTH_IN - _VERTICAL[0] - 0.32
_BESIDE_LEVEL = LEFT + _LEVEL[0] + 1.0
_LEGEND_ROWS, _LEGEND_ROW, _LEGEND_COLUMN = 3, 0.2, 2.9

#: Why a reconstruction ended.
_ENDED = {
    "iterations": "the most allowed",
    "discrepancy": "the data are explained within their errors",
    "converged": "nothing changed any more",
}


@dataclass(frozen=True)
class _Block:
    """A level picture, and two vertical ones beside it."""

    name: str
    pictures: Sequence[Picture]
    scale: ScalarMappable

    @property
    def height(self) -> float:
        level = fitted(self.pictures[0].cut.size_m, _LEVEL)[1] + BELOW
        beside = height_of(self.pictures[1:], _VERTICAL) + BAR
        return HEADING + ABOVE + max(level, beside)

    @property
    def values(self) -> np.ndarray:
        return np.concatenate([one.cut.values.ravel() for one in self.pictures])


def tomography_panel(tomography: Tomography, relief: Relief | None = None) -> Figure:
    """Draw slices through the target, mean densities, rays per voxel, and errors where known.

    Parameters
    ----------
    tomography
        What is drawn.
    relief
        Terrain over `map_bounds` in the CRS of the volume, if it is known.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    lines = _described(tomography)
    head = style.heading_height_in(TITLE, lines) + 0.08
    map_in = fitted(_size(map_bounds(tomography)), _MAP)
    place = middle_place(tomography)
    sections = slices(tomography.density, tomography.coverage, place)[1:]
    first = max(map_in[1] + BELOW, height_of(sections, _VERTICAL) + BAR)
    legend_in = _LEGEND_ROWS * _LEGEND_ROW + 0.1
    densities = volume_scales.between(*tomography.density_limits)
    blocks = _blocks(tomography, place, densities)
    page_in = head + ABOVE_PLAIN + first + legend_in + sum(one.height for one in blocks) + 0.05
    figure = style.new_figure(style.WIDTH_IN, page_in)
    style.add_heading(figure, TITLE, lines)
    axes = page_axes(figure)
    top = page_in - head - ABOVE_PLAIN
    box = (LEFT, top - map_in[1], *map_in)
    legend = draw_slice_map(figure, box, tomography, place, densities, relief)
    axes.text(
        LEFT, top + 0.07, slice_title(place), fontsize=style.HEADING_SIZE,
        fontweight="bold", color=style.INK, va="baseline",
    )  # fmt: skip
    frames = draw_below_each_other(axes, _BESIDE_MAP, top, sections, _VERTICAL, densities)
    legend += _mark_sections(frames, sections, tomography, place, relief)
    draw_colour_bar_below(
        frames[-1], tomography.density.values, densities, "Density (g/cm³)", BELOW, BAR_HEIGHT
    )
    top -= first
    draw_legend(figure, legend, LEFT, top, _LEGEND_ROWS, _LEGEND_ROW, _LEGEND_COLUMN)
    top -= legend_in
    for block in blocks:
        _draw_block(axes, top, block)
        top -= block.height
    return figure


def _size(bounds: tuple[float, float, float, float]) -> tuple[float, float]:
    west, east, south, north = bounds
    return east - west, north - south


def _described(tomography: Tomography) -> list[str]:
    found, grid = tomography.reconstruction, tomography.grid
    edges = " × ".join(f"{size:g}" for size in grid.size_m)
    voxels = " × ".join(map(str, grid.shape))
    stations = len(tomography.stations)
    residual = ticks.number_label(float(f"{100 * tomography.relative_residual:.2g}"))
    return [
        f"{tomography.method_title}, {found.iterations_done} iterations: "
        f"{_ENDED[found.stopped_by]}  ·  {stations} station{'s' * (stations > 1)}, "
        f"{tomography.rays} rays",
        f"{voxels} voxels of {edges} m, {tomography.seen_voxels} of {tomography.rock_voxels} "
        f"sought are crossed by rays  ·  reference {tomography.reference_density:.3g} g/cm³, "
        f"relative residual {residual} %",
    ]


def _blocks(tomography: Tomography, place: Place, densities: ScalarMappable) -> list[_Block]:
    """Return mean densities, rays per voxel, and standard errors where they are known."""
    coverage, deviation = tomography.coverage, tomography.deviation
    # No ray is no number of rays: it is drawn as rock that no ray crosses.
    rays = coverage.with_values("coverage", np.where(coverage.values > 0, coverage.values, np.nan))
    counts = views(rays, coverage)
    shown = np.concatenate([one.cut.values.ravel() for one in counts])
    blocks = [
        _Block("Mean density (g/cm³)", views(tomography.density, coverage), densities),
        _Block("Mean rays per voxel crossed", counts, volume_scales.counted(shown)),
    ]
    if deviation is not None:
        errors = volume_scales.errors(deviation.values)
        name = "Standard error of the density (g/cm³)"
        blocks.append(_Block(name, slices(deviation, coverage, place), errors))
    return blocks


def _draw_block(axes: Axes, top: float, block: _Block) -> None:
    write_heading(axes, top, block.name)
    top -= HEADING + ABOVE
    draw_picture(axes, LEFT, top, block.pictures[0], _LEVEL, block.scale)
    frames = draw_below_each_other(
        axes, _BESIDE_LEVEL, top, block.pictures[1:], _VERTICAL, block.scale
    )
    draw_colour_bar_below(frames[-1], block.values, block.scale, block.name, BELOW, BAR_HEIGHT)


def _mark_sections(
    frames: Sequence[Frame],
    sections: Sequence[Picture],
    tomography: Tomography,
    place: Place,
    relief: Relief | None,
) -> list[tuple[str, Artist]]:
    """Draw ground and target into the sections; return legend entries."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    (west, south, _), (east, north, _) = tomography.grid.origin_m, tomography.grid.end_m
    ends = (((west, place.y), (east, place.y)), ((place.x, south), (place.x, north)))
    target = tomography.target
    for number, (frame, one, line) in enumerate(zip(frames, sections, ends)):
        if relief is not None:
            draw_ground(frame, one.cut, ground_between(relief, *line))
        if target is not None:
            draw_target(frame, one.cut, (target.x, target.y)[number], target.z)
    legend: list[tuple[str, Artist]] = [
        ("Crossed by no ray", Patch(facecolor=UNSEEN, edgecolor="none")),
        ("No rock", Patch(facecolor=style.SKY, edgecolor=style.MUTED, linewidth=0.4)),
    ]
    if relief is not None:
        legend.insert(0, ("Ground along a section", Line2D([], [], **GROUND_LINE)))
    return legend
