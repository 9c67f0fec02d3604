"""Rasters on the grid of a DEM."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

import numpy as np

from .. import __version__
from ..geotiff import as_float32, raster_writer
from ..muogram import DOMAIN, as_text
from ..quantities import Quantity
from .drape import DrapedBlock

if TYPE_CHECKING:
    from pyproj import CRS


class OnMap(Protocol):
    """A raster's place on the map: a `Dem`'s, for one."""

    @property
    def columns(self) -> int:
        """Number of columns."""

    @property
    def rows(self) -> int:
        """Number of rows."""

    @property
    def geotransform(self) -> tuple[float, ...]:
        """Affine map from cell corners to `crs`, in GDAL's order."""

    @property
    def crs(self) -> CRS:
        """Coordinate reference system."""


@raster_writer
def write_on_grid(
    path: str | Path,
    grid: OnMap,
    quantity: Quantity,
    metadata: Mapping[str, str | float],
    blocks: Iterable[DrapedBlock],
    name: str,
) -> int:
    """Write values on a grid of the map; return how many are known.

    The GeoTIFF is sparse: tiles without a value take no room, however large the
    grid is.

    Parameters
    ----------
    path
        The file.
    grid
        Its place on the map, such as a `Dem`.
    quantity
        What the values are.
    metadata
        What else the file says.
    blocks
        Values of runs of whole rows.
    name
        What the file says that it holds.

    Raises
    ------
    MuyscError
        If the file cannot be written.
    """
    from osgeo import gdal

    known = 0
    dataset = gdal.GetDriverByName("GTiff").Create(
        str(path), grid.columns, grid.rows, 1, gdal.GDT_Float32,
        ["COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES", "SPARSE_OK=TRUE", "BIGTIFF=IF_SAFER"],
    )  # fmt: skip
    dataset.SetGeoTransform(grid.geotransform)
    dataset.SetProjection(grid.crs.to_wkt())
    entries = {"QUANTITY": name, "UNIT": quantity.unit}
    dataset.SetMetadata(
        {**{key: as_text(value) for key, value in metadata.items()}, **entries,
         "VERSION": __version__},
        DOMAIN,
    )  # fmt: skip
    band = dataset.GetRasterBand(1)
    band.SetNoDataValue(float("nan"))
    band.SetDescription(quantity.label)
    band.SetUnitType(quantity.unit)
    for block in blocks:
        band.WriteArray(as_float32(block.values, name), 0, block.first_row)
        known += int(np.count_nonzero(np.isfinite(block.values)))
    dataset.FlushCache()
    del band, dataset
    return known
