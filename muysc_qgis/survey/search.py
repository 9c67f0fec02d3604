"""Where candidates are looked for."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..topography.dem import Dem
from ..topography.frame import transformed
from .candidates import Candidates, Limits, find_candidates
from .map_grid import grid_around, grid_over, survey_crs
from .masks import mask_of


@dataclass(frozen=True)
class Search:
    """Where candidates are looked for; layers are read, limits are not applied yet."""

    dem: Dem
    #: (x, y) in the DEM's CRS.
    target: tuple[float, float]
    limits: Limits
    #: Between candidates, and cell size of the maps.
    spacing_m: float
    #: (n, 2) points and (m, 4) segments in the DEM's CRS, None for none.
    points: np.ndarray | None
    roads: np.ndarray | None
    #: File and CRS of the mask.
    mask: tuple[str, str] | None

    def candidates(self) -> Candidates:
        """Return the places that keep to all limits.

        Raises
        ------
        MuyscError
            If there is none, or the spacing makes too many.
        """
        dem, crs, by = self.dem, survey_crs(self.dem, self.target), self.dem.transformation
        roads = self.roads
        if roads is not None:
            ends = [transformed(dem.crs, crs, *roads[:, i : i + 2].T, by=by) for i in (0, 2)]
            roads = np.column_stack([*ends[0], *ends[1]])
        mask = None if self.mask is None else mask_of(*self.mask)
        if self.points is None:
            grid = grid_around(dem, self.target, self.limits.farthest_m, self.spacing_m)
            return find_candidates(dem, self.target, grid, self.limits, None, mask, roads)
        x, y = transformed(dem.crs, crs, *self.points.T, by=by)
        grid = grid_over(crs, x, y, self.spacing_m)
        return find_candidates(dem, self.target, grid, self.limits, (x, y), mask, roads)
