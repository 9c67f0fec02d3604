"""Small pictures of the terrain, for maps in reports."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import MuyscError, detail_of
from .dem import Dem
from .frame import LocalFrame, transformed

if TYPE_CHECKING:
    from pyproj import CRS


@dataclass(frozen=True)
class Relief:
    """Terrain heights on a regular grid around a detector, or on a map.

    Parameters
    ----------
    east_m
        (n_east,) increasing, evenly spaced, metres east of the detector or on the map.
    north_m
        (n_north,) increasing, evenly spaced, metres north of the detector or on the map.
    elevation_m
        (n_north, n_east), NaN where unknown; the first row is the southernmost.

    Raises
    ------
    MuyscError
        If the shapes do not fit or a side has fewer than two points.
    """

    east_m: np.ndarray
    north_m: np.ndarray
    elevation_m: np.ndarray

    def __post_init__(self) -> None:
        shape = (len(self.north_m), len(self.east_m))
        if self.elevation_m.shape != shape or min(shape) < 2:
            raise MuyscError(
                f"A relief of {self.elevation_m.shape} heights does not fit {shape} points "
                "(north, east); give one height for each point, two points a side or more."
            )


def relief_around(
    frame: LocalFrame,
    east_m: tuple[float, float],
    north_m: tuple[float, float],
    pixels: int = 320,
) -> Relief:
    """Return the terrain in a rectangle around a detector.

    Parameters
    ----------
    frame
        Frame of the detector.
    east_m, north_m
        Limits of the rectangle in m from the detector.
    pixels
        Pixels along the longer side.

    Raises
    ------
    MuyscError
        If the DEM cannot be read.
    """
    step = max(east_m[1] - east_m[0], north_m[1] - north_m[0]) / pixels
    # Averaging keeps a coarse picture of a fine DEM free of moiré.
    coarse = step > dem_cell_m(frame)
    return _warped(frame.dem, frame.equidistant_wkt(), east_m, north_m, step, coarse)


def relief_on_map(
    dem: Dem, crs: CRS, x: tuple[float, float], y: tuple[float, float], pixels: int = 320
) -> Relief:
    """Return the terrain in a rectangle of a projection in metres.

    Parameters
    ----------
    dem
        Terrain.
    crs
        Projected, in metres.
    x, y
        Limits of the rectangle in it; heights beyond the DEM are unknown.
    pixels
        Pixels along the longer side.

    Raises
    ------
    MuyscError
        If the DEM cannot be read.
    """
    step = max(x[1] - x[0], y[1] - y[0]) / pixels
    east, north = np.mean(x) + step * np.array([0, 1, 0]), np.mean(y) + step * np.array([0, 0, 1])
    column, row = dem.grid_position(*transformed(crs, dem.crs, east, north, by=dem.transformation))
    coarse = bool(max(np.ptp(column), np.ptp(row)) > 1)
    return _warped(dem, crs.to_wkt(), x, y, step, coarse)


def _warped(
    dem: Dem,
    wkt: str,
    east_m: tuple[float, float],
    north_m: tuple[float, float],
    step: float,
    coarse: bool,
) -> Relief:
    """Return the heights of a rectangle in a projection."""
    from osgeo import gdal

    gdal.UseExceptions()
    try:
        band = gdal.Translate("", dem.path, format="VRT", bandList=[dem.band])
        # The warper reads overviews and only what the rectangle needs.
        warped = gdal.Warp(
            "", band, format="MEM", dstSRS=wkt, srcSRS=dem.crs.to_wkt(),
            outputBounds=(east_m[0], north_m[0], east_m[1], north_m[1]), xRes=step, yRes=step,
            outputType=gdal.GDT_Float32, dstNodata=float("nan"),
            resampleAlg="average" if coarse else "bilinear",
        )  # fmt: skip
    except RuntimeError as error:
        raise MuyscError(f"The DEM {dem.name} cannot be drawn: {detail_of(error)}.") from error
    heights = warped.GetRasterBand(1).ReadAsArray().astype(float)[::-1]
    rows, columns = heights.shape
    return Relief(
        east_m[0] + step * (np.arange(columns) + 0.5),
        north_m[1] - step * (np.arange(rows)[::-1] + 0.5),
        heights * dem.scale + dem.offset,
    )


def dem_cell_m(frame: LocalFrame) -> float:
    """Return the size (m) of a DEM cell at the detector: the geometric mean of its sides."""
    column, row = frame.ground_positions(np.zeros(1), np.zeros(1))
    _, side = frame.polar(np.array([column[0] + 1, column[0]]), np.array([row[0], row[0] + 1]))
    return float(np.sqrt(side[0] * side[1]))
