"""The regular grid on the map on which a survey is drawn."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import MuyscError
from ..topography.dem import Dem
from ..topography.frame import local_frame, to_wgs84, transformed

if TYPE_CHECKING:
    from pyproj import CRS

#: Largest error of lengths in the DEM's own projection that is accepted: UTM has up to 0.1 %,
#: web Mercator 32 % at Vesuvius.
_SCALE_ERROR = 0.01

#: Most cells of a grid.
_MOST_CELLS = 1_000_000


@dataclass(frozen=True)
class MapGrid:
    """Square cells in a projected CRS in metres."""

    crs: CRS
    #: Corner of the first cell, north-west.
    left: float
    top: float
    spacing_m: float
    columns: int
    rows: int

    @property
    def geotransform(self) -> tuple[float, ...]:
        """Affine map from cell corners to `crs`, in GDAL's order."""
        return (self.left, self.spacing_m, 0.0, self.top, 0.0, -self.spacing_m)

    def centres(self) -> tuple[np.ndarray, np.ndarray]:
        """Return x and y of all cell centres, row by row."""
        row, column = np.mgrid[0 : self.rows, 0 : self.columns]
        x = self.left + self.spacing_m * (column.ravel() + 0.5)
        return x, self.top - self.spacing_m * (row.ravel() + 0.5)

    def cell_of(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Return the number of the cell that holds a point, counted row by row."""
        column = np.clip(np.floor((x - self.left) / self.spacing_m), 0, self.columns - 1)
        row = np.clip(np.floor((self.top - y) / self.spacing_m), 0, self.rows - 1)
        return (row * self.columns + column).astype(np.int64)


def survey_crs(dem: Dem, target: tuple[float, float]) -> CRS:
    """Return the DEM's CRS if its lengths are metres on the ground, else the target's UTM zone.

    Parameters
    ----------
    dem
        Terrain.
    target
        (x, y) in the DEM's CRS.
    """
    from pyproj import CRS, Proj

    longitude, latitude = to_wgs84(dem.crs, *target, dem.transformation)
    crs = dem.crs
    if crs.is_projected and {axis.unit_name for axis in crs.axis_info} == {"metre"}:
        frame = local_frame(dem, *target, "target")
        factors = Proj(crs).get_factors(frame.longitude, frame.latitude)
        scales = (factors.meridional_scale, factors.parallel_scale)
        if all(abs(scale - 1) < _SCALE_ERROR for scale in scales):
            return crs
    zone = min(int((longitude + 180) // 6) + 1, 60)
    return CRS.from_epsg((32600 if latitude >= 0 else 32700) + zone)


def grid_over(crs: CRS, x: np.ndarray, y: np.ndarray, spacing_m: float) -> MapGrid:
    """Return the smallest grid over points, its lines at whole multiples of the spacing.

    Raises
    ------
    MuyscError
        If the spacing is not above 0 or makes too many cells.
    """
    if not 0 < spacing_m < math.inf:
        raise MuyscError(f"A spacing of {spacing_m:g} m is impossible; give a length above 0 m.")
    widest = float(max(np.ptp(x), np.ptp(y)))
    if widest > spacing_m * _MOST_CELLS:
        raise MuyscError(
            f"A spacing of {spacing_m:g} m makes more cells in one row than the {_MOST_CELLS:,} of "
            f"the limit; give at least {math.ceil(widest / math.sqrt(_MOST_CELLS))} m."
        )
    left, right = math.floor(x.min() / spacing_m), math.floor(x.max() / spacing_m) + 1
    bottom, top = math.floor(y.min() / spacing_m), math.floor(y.max() / spacing_m) + 1
    columns, rows = right - left, top - bottom
    if columns * rows > _MOST_CELLS:
        least = spacing_m * math.sqrt(columns * rows / _MOST_CELLS)
        raise MuyscError(
            f"A spacing of {spacing_m:g} m makes {columns * rows:,} cells and the limit is "
            f"{_MOST_CELLS:,}; give at least {math.ceil(least)} m or a smaller distance."
        )
    return MapGrid(crs, left * spacing_m, top * spacing_m, spacing_m, columns, rows)


def grid_around(
    dem: Dem, target: tuple[float, float], radius_m: float, spacing_m: float
) -> MapGrid:
    """Return a grid over a circle around a target given in the DEM's CRS.

    Raises
    ------
    MuyscError
        If a length is not above 0 or there are too many cells.
    """
    if not 0 < radius_m < math.inf:
        raise MuyscError(
            f"A largest distance of {radius_m:g} m leaves no place; give one above 0 m."
        )
    crs = survey_crs(dem, target)
    x, y = transformed(
        dem.crs, crs, np.array([target[0]]), np.array([target[1]]), by=dem.transformation
    )
    # A little wider than the circle, whose scale on the map is not exactly 1.
    reach = radius_m * (1 + _SCALE_ERROR)
    ends = np.array([-reach, reach])
    return grid_over(crs, x + ends, y + ends, spacing_m)
