"""A number of every candidate on the shaded terrain around a target."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..quantities import QUANTITIES
from ..topography.frame import local_frame, transformed
from ..topography.relief import Relief, relief_around
from ..workflows.site_assessment import SurveyPlan
from ..workflows.site_selection import Selection
from . import style
from .colours import colour_scale
from .overview_map import shaded

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable

#: How far the map reaches beyond the farthest candidate.
_BEYOND = 1.04
#: Cells along a side that are drawn at most.
_CELLS = 400
#: Pixels of the terrain along a side.
_RELIEF_PIXELS = 420
#: How much of the terrain shows through the cells.
_TERRAIN_SHARE = 0.15

#: Best sites that get a number on the map.
_NUMBERED = 10


@dataclass(frozen=True)
class SurveyMap:
    """What all maps of one survey share, metres east and north of the target."""

    selection: Selection
    relief: Relief
    #: Half the side of the square map (m).
    half_m: float
    #: (rows + 1, columns + 1) corners of the grid's cells.
    corner_east_m: np.ndarray
    corner_north_m: np.ndarray
    #: (n_candidate,).
    east_m: np.ndarray
    north_m: np.ndarray
    radius_m: float

    @classmethod
    def of(cls, selection: Selection, plan: SurveyPlan) -> SurveyMap:
        """Lay out the maps of a survey.

        Raises
        ------
        MuyscError
            If the DEM cannot be drawn.
        """
        grid, candidates = selection.candidates.grid, selection.candidates
        frame = local_frame(plan.dem, *plan.target, "target")
        row, column = np.mgrid[0 : grid.rows + 1, 0 : grid.columns + 1]
        x, y = transformed(
            grid.crs,
            plan.dem.crs,
            grid.left + grid.spacing_m * column,
            grid.top - grid.spacing_m * row,
            by=plan.dem.transformation,
        )
        azimuth, distance = frame.polar(*plan.dem.grid_position(x, y))
        turn = np.radians(azimuth)
        own = np.radians(candidates.azimuth_deg)
        half = _BEYOND * max(float(candidates.distance_m.max()), plan.radius_m)
        return cls(
            selection,
            relief_around(frame, (-half, half), (-half, half), _RELIEF_PIXELS),
            half,
            distance * np.sin(turn),
            distance * np.cos(turn),
            candidates.distance_m * np.sin(own),
            candidates.distance_m * np.cos(own),
            plan.radius_m,
        )

    def draw(self, axes: Axes, quantity: str, number: str) -> ScalarMappable:
        """Draw terrain and candidates in the colours of a quantity; return its scale.

        Parameters
        ----------
        axes
            Empty; its sides are km east and north of the target.
        quantity
            Key of `QUANTITIES`.
        number
            Key of the selection's numbers.
        """
        half = self.half_m / 1e3
        terrain, extent = shaded(self.relief), (-half, half, -half, half)
        axes.imshow(terrain, extent=extent, zorder=1)
        values = self.selection.map_of(number)
        scale = colour_scale(values, QUANTITIES[quantity])
        step = -(-max(values.shape) // _CELLS)
        thin = slice(None, None, step)
        drawn = values[: values.shape[0] // step * step, : values.shape[1] // step * step]
        corners = [one[thin, thin] / 1e3 for one in (self.corner_east_m, self.corner_north_m)]
        cells = drawn[thin, thin]
        rows, columns = cells.shape
        axes.pcolormesh(
            corners[0][: rows + 1, : columns + 1], corners[1][: rows + 1, : columns + 1],
            np.ma.masked_invalid(cells), norm=scale.norm, cmap=scale.cmap,
            antialiased=False, zorder=2, rasterized=True,
        )  # fmt: skip
        # Over opaque cells: edges of cells that are not opaque would be seen twice.
        axes.imshow(terrain, extent=extent, alpha=_TERRAIN_SHARE, zorder=3)
        axes.set(xlim=(-half, half), ylim=(-half, half), aspect="equal")
        style.style_axes(axes)
        return scale

    def mark(self, axes: Axes) -> list[tuple[str, Artist]]:
        """Mark target, best sites and telescopes; return the legend entries."""
        from matplotlib.patches import Circle

        body = Circle(
            (0, 0), self.radius_m / 1e3, fill=False, edgecolor=style.INK, linestyle="--",
            linewidth=style.LINE_WIDTH, zorder=5,
        )  # fmt: skip
        axes.add_patch(body)
        (target,) = axes.plot([0], [0], zorder=6, **style.TARGET_MARK)
        legend: list[tuple[str, Artist]] = [("Target", target), ("Target body", body)]
        best, together = self.selection.best, self.selection.telescopes
        (sites,) = axes.plot(
            self.east_m[best] / 1e3, self.north_m[best] / 1e3, linestyle="none", marker="o",
            markersize=5.5, markerfacecolor="white", markeredgecolor=style.INK, zorder=6,
        )  # fmt: skip
        for rank, index in enumerate(best[:_NUMBERED], 1):
            axes.annotate(
                str(rank), (self.east_m[index] / 1e3, self.north_m[index] / 1e3),
                xytext=(5, 3), textcoords="offset points", fontsize=style.TICK_SIZE,
                fontweight="bold", color=style.INK, zorder=8,
                bbox={"facecolor": "white", "alpha": 0.75, "edgecolor": "none", "pad": 0.8},
            )  # fmt: skip
        legend.append(("Best sites, by rank", sites))
        (telescopes,) = axes.plot(
            self.east_m[together] / 1e3, self.north_m[together] / 1e3, zorder=7,
            **style.DETECTOR_MARK,
        )  # fmt: skip
        legend.append(("Telescopes that go together", telescopes))
        return legend
