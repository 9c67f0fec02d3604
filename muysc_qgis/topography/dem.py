"""Elevation rasters: what they hold, where it lies, and windows of it in metres."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import MuyscError, detail_of
from ..geotiff import FARTHEST, raster_reader, reach_of
from .datum import Transformation, own_transformation
from .heights import LOWEST_M, PEAK_M, UNFLAGGED_NO_DATA_M, metres_per_unit

if TYPE_CHECKING:
    from pyproj import CRS

#: A point this little (in cells) outside the outermost cell centres is on them:
#: 1 mm on a 1 km grid, far above the rounding of coordinates.
EDGE_CELLS = 1e-6


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
    #: To WGS 84 and back, None where `crs` is on it.
    transformation: Transformation | None
    _dataset: Any

    @property
    def name(self) -> str:
        """File name, for messages."""
        return Path(self.path).name

    @property
    def doubts(self) -> tuple[str, ...]:
        """What must be known of heights and positions before they are trusted, a sentence each."""
        return (*self.assumptions, *(self.transformation.doubts if self.transformation else ()))

    @property
    def _turn(self) -> float:
        """Full turn of longitude in the units of a geographic CRS: 360°, or 400 grads."""
        return round(2 * np.pi / float(self.crs.axis_info[0].unit_conversion_factor), 9)

    @property
    def turn_columns(self) -> int:
        """Columns after which the raster repeats itself, 0 where it does not.

        That is, where they run once around the globe; the last may be the first
        again, as in rasters with cell centres from −180 to 180.
        """
        _, step_x, skew_x, _, skew_y, _ = self.geotransform
        if not self.crs.is_geographic or skew_x or skew_y:
            return 0
        columns = round(self._turn / abs(step_x))
        whole = abs(columns * abs(step_x) - self._turn) < 1e-6
        return columns if whole and self.columns >= columns else 0

    @property
    def wraps(self) -> bool:
        """Whether the columns run around the globe."""
        return self.turn_columns > 0

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
            with np.errstate(invalid="ignore", over="ignore"):
                dx = middle + (dx - middle + self._turn / 2) % self._turn - self._turn / 2
        # What has no place in the CRS comes as infinity and has none here, NaN.
        with np.errstate(invalid="ignore", over="ignore"):
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
        right, bottom = self.columns - 1 + EDGE_CELLS, self.rows - 1 + EDGE_CELLS
        inside_columns = (column >= -EDGE_CELLS) & (column <= right) | self.wraps
        return inside_columns & (row >= -EDGE_CELLS) & (row <= bottom)

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
        turn = self.turn_columns
        if turn:
            column %= turn
            beyond = column + columns - turn
            if beyond > 0:
                parts = (
                    self.read(column, row, columns - beyond, rows),
                    self.read(0, row, beyond, rows),
                )
                return np.concatenate(parts, axis=1)
        values, unknown = self.read_stored(column, row, columns, rows)
        heights = values.astype(float)
        unknown |= ~np.isfinite(heights)
        # What is no data may be beyond all bounds: it takes no part.
        heights[unknown] = np.nan
        heights *= self.scale
        heights += self.offset
        if not unknown.all():
            self._refuse_non_elevation(np.nanmin(heights), np.nanmax(heights))
        return heights

    def read_stored(
        self, column: int, row: int, columns: int, rows: int
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return a window as stored, and where the file says that there is no data."""
        from osgeo import gdal

        band = self._dataset.GetRasterBand(self.band)
        try:
            values = band.ReadAsArray(column, row, columns, rows)
            mask = None
            if not band.GetMaskFlags() & (gdal.GMF_ALL_VALID | gdal.GMF_NODATA):
                mask = band.GetMaskBand().ReadAsArray(column, row, columns, rows)
        except RuntimeError as error:
            raise MuyscError(
                f"The DEM {self.name} cannot be read ({detail_of(error)}); "
                "check that it is complete."
            ) from error
        if values is None:
            raise MuyscError(f"The DEM {self.name} cannot be read; check that it is complete.")
        unknown = np.zeros(values.shape, bool) if mask is None else mask == 0
        if self.no_data is not None:
            # A band of float32 holds its no-data value rounded, one of whole
            # numbers holds none that is a fraction or out of its bounds.
            with np.errstate(over="ignore"):
                single = values.dtype == np.float32
                unknown |= values == (np.float32(self.no_data) if single else self.no_data)
        return values, unknown

    def _refuse_non_elevation(self, lowest: float, highest: float) -> None:
        if lowest < LOWEST_M or highest > PEAK_M:
            value = lowest if lowest < LOWEST_M else highest
            raise MuyscError(
                f"The raster {self.name} holds {value:g} m, beyond the {LOWEST_M:g} to "
                f"{PEAK_M:g} m that elevations on Earth reach; choose an elevation raster, "
                "or set its no-data value or unit."
            )
        if lowest == UNFLAGGED_NO_DATA_M:
            raise MuyscError(
                f"The DEM {self.name} holds {lowest:g} m, the usual code for missing heights, but "
                "does not say that it means no data; set the raster's no-data value to it."
            )


@raster_reader
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

    name = Path(path).name
    try:
        dataset = gdal.Open(str(path))
    except RuntimeError as error:
        raise MuyscError(
            f"The DEM {path} cannot be opened as a raster: {detail_of(error)}."
        ) from error
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
    if not reach_of(dataset) <= FARTHEST:
        raise MuyscError(
            f"The DEM {name} has the geotransform {geotransform}, and no map reaches beyond "
            f"{FARTHEST:g}; georeference it first."
        )
    full_crs = _crs_of(dataset, crs, name)
    factor, assumption = metres_per_unit(unit, raster_band.GetUnitType(), full_crs, name)
    scale = raster_band.GetScale()
    offset = raster_band.GetOffset()
    crs_on_map = _horizontal(full_crs)
    middle = gdal.ApplyGeoTransform(geotransform, dataset.RasterXSize / 2, dataset.RasterYSize / 2)
    return Dem(
        str(path),
        band,
        dataset.RasterXSize,
        dataset.RasterYSize,
        tuple(geotransform),
        crs_on_map,
        (1.0 if scale is None else scale) * factor,
        (0.0 if offset is None else offset) * factor,
        raster_band.GetNoDataValue(),
        (assumption,) if assumption else (),
        own_transformation(crs_on_map, *middle),
        dataset,
    )


def _refuse_pictures(dataset: Any, band: Any, name: str) -> None:
    from osgeo import gdal

    if gdal.DataTypeIsComplex(band.DataType):
        raise MuyscError(
            f"Band {band.GetBand()} of {name} holds complex numbers "
            f"({gdal.GetDataTypeName(band.DataType)}), not elevation; choose an elevation raster."
        )
    colour = band.GetColorInterpretation()
    if colour in (
        gdal.GCI_PaletteIndex, gdal.GCI_RedBand, gdal.GCI_GreenBand,
        gdal.GCI_BlueBand, gdal.GCI_AlphaBand,
    ):  # fmt: skip
        raise MuyscError(
            f"Band {band.GetBand()} of {name} is a picture "
            f"({gdal.GetColorInterpretationName(colour)}), not elevation; choose an elevation "
            "raster."
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
    horizontal = _horizontal(crs)
    if crs.geodetic_crs is None or not (horizontal.is_geographic or horizontal.is_projected):
        raise MuyscError(
            f"The coordinate reference system of the DEM {name} ({crs.name}) does not map the "
            "Earth's surface; assign a geographic or projected one."
        )
    return crs


def _horizontal(crs: CRS) -> CRS:
    """Return the horizontal part of a compound or bound CRS."""
    if crs.is_compound:
        crs = crs.sub_crs_list[0]
    return crs.source_crs if crs.is_bound and crs.source_crs else crs
