"""A raster that says where candidates may lie."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..errors import MuyscError, detail_of
from ..topography.datum import Transformation
from ..topography.frame import transformed

if TYPE_CHECKING:
    from pyproj import CRS


@dataclass(frozen=True)
class Mask:
    """Band 1 of a raster: places are allowed where it is neither 0 nor no data."""

    path: str
    crs: CRS

    def holds(
        self, crs: CRS, x: np.ndarray, y: np.ndarray, by: Transformation | None = None
    ) -> np.ndarray:
        """Return whether points of a CRS lie on cells that allow them, (n,).

        `by` is the transformation of the terrain, see `transformed`.

        Raises
        ------
        MuyscError
            If the raster cannot be read.
        """
        from osgeo import gdal

        gdal.UseExceptions()
        try:
            dataset = gdal.Open(self.path)
            left, step_x, skew_x, top, skew_y, step_y = dataset.GetGeoTransform()
            own_x, own_y = transformed(crs, self.crs, x, y, by=by)
            determinant = step_x * step_y - skew_x * skew_y
            dx, dy = own_x - left, own_y - top
            column = np.floor((step_y * dx - skew_x * dy) / determinant)
            row = np.floor((step_x * dy - skew_y * dx) / determinant)
            inside = (column >= 0) & (column < dataset.RasterXSize)
            inside &= (row >= 0) & (row < dataset.RasterYSize)
            result = np.zeros(len(x), bool)
            if not inside.any():
                return result
            i, j = column[inside].astype(int), row[inside].astype(int)
            window = (
                int(i.min()), int(j.min()), int(np.ptp(i)) + 1, int(np.ptp(j)) + 1,
            )  # fmt: skip
            band = dataset.GetRasterBand(1)
            values = band.ReadAsArray(*window)
            valid = band.GetMaskBand().ReadAsArray(*window) > 0
        except RuntimeError as error:
            raise MuyscError(
                f"The mask {Path(self.path).name} cannot be read ({detail_of(error)}); "
                "choose another raster."
            ) from error
        allowed = valid & (values != 0) & np.isfinite(values)
        result[inside] = allowed[j - window[1], i - window[0]]
        return result


def mask_of(path: str, crs: str) -> Mask:
    """Return the mask of a file, given its CRS in any form that `pyproj.CRS` takes.

    Raises
    ------
    MuyscError
        If there is no such CRS.
    """
    from pyproj import CRS
    from pyproj.exceptions import CRSError

    try:
        return Mask(path, CRS.from_user_input(crs))
    except CRSError as error:
        raise MuyscError(
            f"The mask {Path(path).name} has no coordinate reference system; assign one."
        ) from error
