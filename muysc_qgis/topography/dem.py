"""Elevation rasters: what they hold, where it lies, and windows of it in metres."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import MuyscError
from .heights import LOWEST_M, PEAK_M, metres_per_unit

if TYPE_CHECKING:
    from pyproj import CRS


@dataclass(frozen=True)
class Dem:
    """One band of an elevation raster; heights are read window by window.

    The terrain is the bilinear surface through the cell centres. Grid
    coordinates (column, row) are 0 at the centre of the first cell, so that the
    surface spans 0 … columns − 1 and 0 … rows − 1.
    """

    path: str
    band: int
    columns: int
    rows: int
    #: Affine map from cell corners to `crs`, in GDAL's order.
    geotransform: tuple[float, ...]
    crs: CRS
    #: Factor and shift from stored values to metres.
    scale: float
    offset: float
    no_data: float | None
    #: What was assumed about the heights, where the file does not say.
    assumptions: tuple[str, ...]
    _dataset: Any

    @property
    def name(self) -> str:
        """File name, for messages."""
        return Path(self.path).name

    @property
    def wraps(self) -> bool:
        """Whether the columns run once around the globe."""
        width = self.columns * self.geotransform[1]
        return bool(self.crs.is_geographic) and abs(abs(width) - 360.0) < 1e-6

    def grid_position(
        self, x: np.ndarray | float, y: np.ndarray | float
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return (column, row) of points given in the raster's CRS, any shape."""
        origin_x, step_x, skew_x, origin_y, skew_y, step_y = self.geotransform
        determinant = step_x * step_y - skew_x * skew_y
        dx = np.asarray(x, float) - origin_x
        dy = np.asarray(y, float) - origin_y
        if self.crs.is_geographic:
            # Longitudes count from the raster's middle, so that neither the
            # antimeridian nor 0…360 longitudes break a path.
            middle = (step_x * self.columns + skew_x * self.rows) / 2
            dx = middle + (dx - middle + 180.0) % 360.0 - 180.0
        column = (step_y * dx - skew_x * dy) / determinant - 0.5
        row = (step_x * dy - skew_y * dx) / determinant - 0.5
        return column, row

    def crs_position(
        self, column: np.ndarray | float, row: np.ndarray | float
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return (x, y) in the raster's CRS of grid positions, any shape."""
        origin_x, step_x, skew_x, origin_y, skew_y, step_y = self.geotransform
        u = np.asarray(column, float) + 0.5
        v = np.asarray(row, float) + 0.5
        return origin_x + step_x * u + skew_x * v, origin_y + skew_y * u + step_y * v

    def contains(self, column: np.ndarray, row: np.ndarray) -> np.ndarray:
        """Return whether grid positions lie on the bilinear surface."""
        inside_columns = (column >= 0) & (column <= self.columns - 1) | self.wraps
        return inside_columns & (row >= 0) & (row <= self.rows - 1)

    def read(self, column: int, row: int, columns: int, rows: int) -> np.ndarray:
        """Return the heights of a window of cells.

        Parameters
        ----------
        column, row
            First cell; the column may lie beyond the raster where it `wraps`.
        columns, rows
            Size of the window.

        Returns
        -------
        ndarray
            (rows, columns) heights in m, NaN where there is no data.

        Raises
        ------
        MuyscError
            If the file cannot be read or its values cannot be elevations.
        """
        if self.wraps:
            column %= self.columns
            beyond = column + columns - self.columns
            if beyond > 0:
                parts = (
                    self.read(column, row, columns - beyond, rows),
                    self.read(0, row, beyond, rows),
                )
                return np.concatenate(parts, axis=1)
        band = self._dataset.GetRasterBand(self.band)
        try:
            values = band.ReadAsArray(column, row, columns, rows)
        except RuntimeError as error:
            raise MuyscError(f"The DEM {self.name} cannot be read: {error}.") from error
        if values is None:
            raise MuyscError(f"The DEM {self.name} cannot be read; check that it is complete.")
        heights = values.astype(float)
        unknown = ~np.isfinite(heights)
        if self.no_data is not None:
            # Compared in the file's own type: a no-data value such as
            # −3.4028235e38 need not survive the way through float64.
            unknown |= values == np.asarray(self.no_data).astype(values.dtype)
        heights *= self.scale
        heights += self.offset
        heights[unknown] = np.nan
        if not unknown.all():
            self._refuse_non_elevation(np.nanmin(heights), np.nanmax(heights))
        return heights

    def _refuse_non_elevation(self, lowest: float, highest: float) -> None:
        if lowest < LOWEST_M or highest > PEAK_M:
            value = lowest if lowest < LOWEST_M else highest
            raise MuyscError(
                f"The raster {self.name} holds {value:g} m, beyond the {LOWEST_M:g} to "
                f"{PEAK_M:g} m that elevations on Earth reach; choose an elevation raster, "
                "or set its no-data value or unit."
            )

    def heights_at(self, column: float, row: float) -> float:
        """Return the bilinear height (m) at one grid position, NaN if unknown there."""
        if not bool(self.contains(np.asarray(column), np.asarray(row))):
            return float("nan")
        first_column = min(int(np.floor(column)), self.columns - 2)
        if self.wraps:
            first_column = int(np.floor(column))
        first_row = min(int(np.floor(row)), self.rows - 2)
        corners = self.read(first_column, first_row, 2, 2)
        u, v = column - first_column, row - first_row
        weights = np.outer((1 - v, v), (1 - u, u))
        # A corner of weight 0 has no say, not even when it is unknown.
        return float(np.sum(weights[weights > 0] * corners[weights > 0]))


def open_dem(path: str | Path, band: int = 1, crs: str | None = None, unit: str = "auto") -> Dem:
    """Open an elevation raster.

    Parameters
    ----------
    path
        Anything GDAL opens.
    band
        Number of the elevation band, from 1.
    crs
        Coordinate reference system to use instead of the file's own, in any form
        that `pyproj.CRS` takes.
    unit
        Unit of the heights, a key of `heights.UNITS`; ``auto`` takes what the
        file says and metres where it says nothing.

    Raises
    ------
    MuyscError
        If the file is missing, no raster, or cannot be an elevation model.
    """
    from osgeo import gdal

    gdal.UseExceptions()
    name = Path(path).name
    try:
        dataset = gdal.Open(str(path))
    except RuntimeError as error:
        detail = str(error).strip().rstrip(".")
        raise MuyscError(f"The DEM {path} cannot be opened as a raster: {detail}.") from error
    if not 1 <= band <= dataset.RasterCount:
        raise MuyscError(
            f"Band {band} does not exist in the DEM {name}; choose 1 to {dataset.RasterCount}."
        )
    raster_band = dataset.GetRasterBand(band)
    _refuse_pictures(dataset, raster_band, name)
    if dataset.RasterXSize < 2 or dataset.RasterYSize < 2:
        raise MuyscError(
            f"The DEM {name} has {dataset.RasterXSize} × {dataset.RasterYSize} cells; "
            "a surface needs at least 2 × 2."
        )
    geotransform = dataset.GetGeoTransform(can_return_null=True)
    if geotransform is None or geotransform[1] * geotransform[5] == (
        geotransform[2] * geotransform[4]
    ):
        raise MuyscError(f"The DEM {name} is not georeferenced; georeference it first.")
    full_crs = _crs_of(dataset, crs, name)
    factor, assumption = metres_per_unit(unit, raster_band.GetUnitType(), full_crs, name)
    scale = raster_band.GetScale()
    offset = raster_band.GetOffset()
    return Dem(
        str(path),
        band,
        dataset.RasterXSize,
        dataset.RasterYSize,
        tuple(geotransform),
        _horizontal(full_crs),
        (1.0 if scale is None else scale) * factor,
        (0.0 if offset is None else offset) * factor,
        raster_band.GetNoDataValue(),
        (assumption,) if assumption else (),
        dataset,
    )


def _refuse_pictures(dataset: Any, band: Any, name: str) -> None:
    from osgeo import gdal

    colour = band.GetColorInterpretation()
    if gdal.DataTypeIsComplex(band.DataType) or colour in (
        gdal.GCI_PaletteIndex, gdal.GCI_RedBand, gdal.GCI_GreenBand,
        gdal.GCI_BlueBand, gdal.GCI_AlphaBand,
    ):  # fmt: skip
        kind = gdal.GetColorInterpretationName(colour)
        raise MuyscError(
            f"Band {band.GetBand()} of {name} is a picture or complex band ({kind}), not "
            "elevation; choose an elevation raster."
        )
    if dataset.GetMetadata("MUYSC"):
        raise MuyscError(
            f"{name} is a muogram (azimuth against elevation angle), not elevation; "
            "choose the elevation raster it was made from."
        )


def _crs_of(dataset: Any, override: str | None, name: str) -> CRS:
    import pyproj

    definition = override or dataset.GetProjection()
    if not definition:
        raise MuyscError(
            f"The DEM {name} has no coordinate reference system; assign one "
            "(Raster ▸ Projections ▸ Assign Projection)."
        )
    try:
        crs = pyproj.CRS.from_user_input(definition)
    except pyproj.exceptions.CRSError as error:
        raise MuyscError(
            f"The coordinate reference system of the DEM {name} is not understood: {error}."
        ) from error
    if crs.geodetic_crs is None:
        raise MuyscError(
            f"The coordinate reference system of the DEM {name} ({crs.name}) is not tied to "
            "the Earth; assign a geographic or projected one."
        )
    return crs


def _horizontal(crs: CRS) -> CRS:
    """Return the horizontal part of a compound or bound CRS."""
    if crs.is_compound:
        crs = crs.sub_crs_list[0]
    return crs.source_crs if crs.is_bound and crs.source_crs else crs
