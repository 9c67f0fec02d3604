"""Terrain for other processes: held in memory, which they share, or opened again."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from ..errors import MuyscError, detail_of
from ..topography.datum import Transformation
from ..topography.dem import Dem

#: Largest piece of terrain that is held, bytes.
LARGEST_BYTES = 2 << 30

_HEIGHTS = "heights"


@dataclass(frozen=True)
class HeldDem(Dem):
    """A DEM of which the heights of a window are in memory.

    Its grid, and so every number that follows from it, is that of the file.
    """

    first_column: int
    first_row: int
    #: (n_row, n_column) heights of the window in m, NaN where unknown.
    heights: np.ndarray

    def read(self, column: int, row: int, columns: int, rows: int) -> np.ndarray:
        """Return the heights of a window of cells without a copy, see `Dem.read`."""
        if self.wraps:
            return super().read(column, row, columns, rows)
        return self._held(column, row, columns, rows)

    def read_stored(
        self, column: int, row: int, columns: int, rows: int
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the heights of a window, which count as stored and known."""
        heights = self._held(column, row, columns, rows)
        return heights, np.zeros(heights.shape, bool)

    def _held(self, column: int, row: int, columns: int, rows: int) -> np.ndarray:
        column, row = column - self.first_column, row - self.first_row
        heights = self.heights[row : row + rows, column : column + columns]
        if min(column, row) < 0 or heights.shape != (rows, columns):
            raise MuyscError(
                f"Terrain of {self.name} beyond the part in memory is needed; give a longer "
                "maximum range."
            )
        return heights


def hold(dem: Dem, window: tuple[int, int, int, int]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return what makes a `HeldDem` of a window: plain settings, and arrays by name.

    Parameters
    ----------
    dem
        Terrain of a file.
    window
        First column and row, number of columns and rows.

    Raises
    ------
    MuyscError
        If the window is too large for memory or the DEM cannot be read.
    """
    column, row, columns, rows = window
    size = columns * rows * np.dtype(float).itemsize
    if size > LARGEST_BYTES:
        raise MuyscError(
            f"The {columns} × {rows} cells of the DEM that rays may reach take "
            f"{size / 2**30:.1f} GiB of memory and the limit is {LARGEST_BYTES / 2**30:.0f} GiB; "
            "give a maximum range, candidates closer together or a coarser DEM."
        )
    settings = {**plain_dem(dem), "first_column": column, "first_row": row}
    return settings, {_HEIGHTS: dem.read(column, row, columns, rows)}


def held_dem(settings: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> HeldDem:
    """Return the terrain that `hold` gave away."""
    # Heights in memory are in metres, and unknown ones are NaN.
    in_metres = {"scale": 1.0, "offset": 0.0, "no_data": None}
    own = _fields({**settings, **in_metres})
    return HeldDem(**own, _dataset=None, heights=arrays[_HEIGHTS])


def plain_dem(dem: Dem) -> dict[str, Any]:
    """Return plain settings from which `reopened_dem` makes the same DEM in another process."""
    plain = {
        field.name: getattr(dem, field.name) for field in fields(Dem) if field.name != "_dataset"
    }
    by = dem.transformation
    return {**plain, "crs": dem.crs.to_json(), "transformation": by and by.plain()}


def reopened_dem(settings: Mapping[str, Any]) -> Dem:
    """Return the DEM of a file that was open in another process of this machine.

    Raises
    ------
    MuyscError
        If the file is gone.
    """
    from osgeo import gdal

    gdal.UseExceptions()
    try:
        return Dem(**_fields(settings), _dataset=gdal.Open(settings["path"]))
    except RuntimeError as error:
        raise MuyscError(
            f"The DEM {settings['path']} cannot be opened again: {detail_of(error)}."
        ) from error


def _fields(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Return fields of a DEM from plain settings, which may have been text in between."""
    from pyproj import CRS

    by = settings["transformation"]
    return {
        **settings,
        "transformation": by and Transformation.of(by),
        "crs": CRS.from_json(settings["crs"]),
        "geotransform": tuple(settings["geotransform"]),
        "assumptions": tuple(settings["assumptions"]),
    }
