"""Rasters on the grid of a DEM."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np

from .. import __version__
from ..errors import MuyscError
from ..muogram import DOMAIN, as_text
from ..quantities import Quantity
from .dem import Dem
from .drape import DrapedBlock


def write_on_grid(
    path: str | Path,
    dem: Dem,
    quantity: Quantity,
    metadata: Mapping[str, str | float],
    blocks: Iterable[DrapedBlock],
) -> int:
    """Write values on the grid and in the CRS of a DEM; return how many are known.

    The GeoTIFF is sparse: tiles without a value take no room, however large the
    DEM is.

    Raises
    ------
    MuyscError
        If the file cannot be written.
    """
    from osgeo import gdal

    gdal.UseExceptions()
    known = 0
    try:
        dataset = gdal.GetDriverByName("GTiff").Create(
            str(path), dem.columns, dem.rows, 1, gdal.GDT_Float32,
            ["COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES", "SPARSE_OK=TRUE", "BIGTIFF=IF_SAFER"],
        )  # fmt: skip
        dataset.SetGeoTransform(dem.geotransform)
        dataset.SetProjection(dem.crs.to_wkt())
        entries = {"QUANTITY": f"draped {quantity.name}", "UNIT": quantity.unit}
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
            band.WriteArray(block.values.astype(np.float32), 0, block.first_row)
            known += int(np.count_nonzero(np.isfinite(block.values)))
        dataset.FlushCache()
        del band, dataset
    except RuntimeError as error:
        raise MuyscError(f"The raster {path} cannot be written: {error}.") from error
    return known
