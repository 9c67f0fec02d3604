"""Tiles put together, cropped, and written as one elevation raster."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from .. import __version__
from ..errors import Cancelled, MuyscError
from ..geotiff import raster_writer
from ..progress import Progress, report, silent
from .srtm import Extent, Source, Tile, public_part
from .srtm_tiles import VOID, TileHeights

#: Cell centres this near (in cells) to an edge of the extent lie on it: rounding of degrees.
_ROUNDING_CELLS = 1e-6

#: Rows written at a time, so that a cancel is noticed.
_ROWS_AT_ONCE = 512


@dataclass(frozen=True)
class Grid:
    """Cells whose centres divide the degree evenly, by their place on the globe.

    Columns count from longitude 0 eastwards, rows from the equator northwards; both
    ends belong to the grid.
    """

    rows_per_degree: int
    columns_per_degree: int
    left: int
    right: int
    bottom: int
    top: int

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return self.top - self.bottom + 1, self.right - self.left + 1

    @property
    def geotransform(self) -> tuple[float, ...]:
        """Affine map from cell corners to degrees, in GDAL's order."""
        step_x, step_y = 1 / self.columns_per_degree, 1 / self.rows_per_degree
        left, top = (self.left - 0.5) * step_x, (self.top + 0.5) * step_y
        return left, step_x, 0.0, top, 0.0, -step_y


@dataclass(frozen=True)
class Mosaic:
    """Heights of an extent, and what is to be told about them."""

    grid: Grid
    #: (rows, columns), m, the northernmost row first; `VOID` where there is none.
    heights: np.ndarray
    tiles: int
    cached_tiles: int
    #: Names of the tiles that the source does not have; their cells are at sea level.
    sea_tiles: tuple[str, ...]
    filled_cells: int = 0

    @property
    def void_cells(self) -> int:
        """Cells without a height."""
        return int(np.count_nonzero(self.heights == VOID))

    @property
    def range_m(self) -> tuple[float, float]:
        """Lowest and highest height (m), NaN where there is none at all."""
        known = self.heights[self.heights != VOID]
        return (float(known.min()), float(known.max())) if known.size else (math.nan, math.nan)


class Canvas:
    """Heights of an extent while tiles are put on it; sea level where none is.

    `grid` and `heights` are there once a tile is.
    """

    grid: Grid
    heights: np.ndarray
    _covered: np.ndarray

    def __init__(self, extent: Extent, places: list[tuple[Tile, int]]) -> None:
        self._extent = extent
        self._south = min(tile.latitude_deg for tile, _ in places)
        self._north = max(tile.latitude_deg for tile, _ in places) + 1
        self._west = min(west for _, west in places)
        self._east = max(west for _, west in places) + 1
        self._first: Tile | None = None

    def put(self, tile: Tile, west_deg: int, tile_heights: TileHeights) -> None:
        """Put the part of a tile on the canvas that lies in the extent.

        Neighbours may share an edge; a void there is no reason to forget a height.

        Raises
        ------
        MuyscError
            If its cells are not those of the tiles before.
        """
        if self._first is None:
            self._first = tile
            self._start(tile_heights)
        grid, values = self.grid, tile_heights.values
        per_degree = tile_heights.rows_per_degree, tile_heights.columns_per_degree
        if per_degree != (grid.rows_per_degree, grid.columns_per_degree):
            raise MuyscError(
                f"{self._first.name} has {grid.rows_per_degree} × {grid.columns_per_degree} cells "
                f"to a degree and {tile.name} {per_degree[0]} × {per_degree[1]}; choose an extent "
                "or a source where they are the same."
            )
        if values.dtype != self.heights.dtype:
            self.heights = self.heights.astype(np.float32)
        # Where the tile's first cell lies on the canvas, perhaps outside.
        row = grid.top - (tile.latitude_deg + 1) * grid.rows_per_degree
        column = west_deg * grid.columns_per_degree - grid.left
        rows = slice(max(row, 0), min(row + values.shape[0], grid.shape[0]))
        columns = slice(max(column, 0), min(column + values.shape[1], grid.shape[1]))
        part = values[
            rows.start - row : rows.stop - row, columns.start - column : columns.stop - column
        ]
        target, covered = self.heights[rows, columns], self._covered[rows, columns]
        target[...] = np.where((part == VOID) & covered, target, part)
        covered[...] = True

    def _start(self, heights: TileHeights) -> None:
        """Lay out the grid once the first tile tells its cells."""
        rows, columns = heights.rows_per_degree, heights.columns_per_degree
        # Tiles without their southern and eastern edge end one cell earlier.
        shared_row = heights.values.shape[0] - rows
        shared_column = heights.values.shape[1] - columns
        lowest, highest = self._south * rows + 1 - shared_row, self._north * rows
        first, last = self._west * columns, self._east * columns - 1 + shared_column
        extent = self._extent
        left = max(math.floor(extent.west_deg * columns + _ROUNDING_CELLS), first)
        right = min(math.ceil(extent.east_deg * columns - _ROUNDING_CELLS), last)
        bottom = max(math.floor(extent.south_deg * rows + _ROUNDING_CELLS), lowest)
        top = min(math.ceil(extent.north_deg * rows - _ROUNDING_CELLS), highest)
        # A surface needs two cells each way.
        left, bottom = min(left, last - 1), min(bottom, highest - 1)
        self.grid = Grid(rows, columns, left, max(right, left + 1), bottom, max(top, bottom + 1))
        self.heights = np.zeros(self.grid.shape, heights.values.dtype)
        self._covered = np.zeros(self.grid.shape, bool)


def fill_voids(mosaic: Mosaic, distance_cells: int, progress: Progress = silent) -> Mosaic:
    """Fill voids from the heights around them, weighted by the inverse of their distance.

    Parameters
    ----------
    mosaic
        What to fill.
    distance_cells
        How far heights are looked for; what has none so near stays void.
    progress
        Told the share done.

    Raises
    ------
    Cancelled
        If `progress` asks for a stop.
    """
    from osgeo import gdal

    gdal.UseExceptions()
    before = mosaic.void_cells
    if not before:
        return mosaic
    rows, columns = mosaic.heights.shape
    dataset = gdal.GetDriverByName("MEM").Create("", columns, rows, 1, _gdal_type(mosaic))
    band = dataset.GetRasterBand(1)
    band.SetNoDataValue(VOID)
    band.WriteArray(mosaic.heights)
    stopped = []

    def callback(fraction: float, _message: str, _data: object) -> int:
        if not progress(fraction):
            stopped.append(fraction)
        return 0 if stopped else 1

    try:
        gdal.FillNodata(band, band.GetMaskBand(), distance_cells, 0, callback=callback)
    except RuntimeError:
        if not stopped:
            raise
    if stopped:
        raise Cancelled("stopped on request")
    filled = replace(mosaic, heights=band.ReadAsArray())
    del band, dataset
    return replace(filled, filled_cells=before - filled.void_cells)


@raster_writer
def write_dem(
    path: str | Path, mosaic: Mosaic, source: Source, progress: Progress = silent
) -> None:
    """Write heights as a GeoTIFF in longitude and latitude (EPSG:4326).

    Raises
    ------
    MuyscError
        If the file cannot be written.
    Cancelled
        If `progress` asks for a stop.
    """
    from osgeo import gdal, osr

    rows, columns = mosaic.heights.shape
    predictor = 2 if mosaic.heights.dtype == np.int16 else 3
    crs = osr.SpatialReference()
    crs.ImportFromEPSG(4326)
    dataset = gdal.GetDriverByName("GTiff").Create(
        str(path), columns, rows, 1, _gdal_type(mosaic),
        ["COMPRESS=DEFLATE", f"PREDICTOR={predictor}", "TILED=YES", "BIGTIFF=IF_SAFER",
         "NUM_THREADS=ALL_CPUS"],
    )  # fmt: skip
    dataset.SetGeoTransform(mosaic.grid.geotransform)
    dataset.SetProjection(crs.ExportToWkt())
    dataset.SetMetadata(
        {
            "SOURCE": public_part(source.template),
            "HEIGHT_DATUM": source.height_datum,
            "ATTRIBUTION": source.attribution,
            "SOFTWARE": f"MUYSC {__version__}",
        }
    )
    band = dataset.GetRasterBand(1)
    band.SetNoDataValue(VOID)
    band.SetDescription("Elevation (m)")
    band.SetUnitType("m")
    for row in range(0, rows, _ROWS_AT_ONCE):
        report(progress, row / rows)
        band.WriteArray(mosaic.heights[row : row + _ROWS_AT_ONCE], 0, row)
    dataset.FlushCache()
    del band, dataset


def _gdal_type(mosaic: Mosaic) -> int:
    from osgeo import gdal

    return int(gdal.GDT_Int16 if mosaic.heights.dtype == np.int16 else gdal.GDT_Float32)
