"""The muogram: one quantity seen from one place, and its GeoTIFF form."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from . import __version__
from .errors import MuyscError, detail_of
from .geotiff import as_float32, metadata_of, raster_reader, raster_writer, reach_of
from .quantities import QUANTITIES, Quantity

#: GDAL metadata domain of everything a later step needs to know.
DOMAIN = "MUYSC"

#: Bounds of directions, in degrees or as tangents: the tangent of 89.9999° is 6e5, and steps of
#: 1e-9 are still told apart there.
_FARTHEST = 1e6
_NARROWEST = 1e-9

#: Largest relative unevenness of the direction axes that a raster can carry.
_AXIS_TOLERANCE = 1e-6


def finite_number(entry: str | float) -> float:
    """Return an entry of metadata as a number.

    Raises
    ------
    ValueError
        If it is none, infinite or NaN.
    """
    value = float(entry)
    if not np.isfinite(value):
        raise ValueError(entry)
    return value


class Described:
    """What a raster of one quantity says about itself."""

    quantity: str
    metadata: Mapping[str, str | float]

    @property
    def kind(self) -> Quantity:
        """Title, unit and colours of the quantity."""
        return QUANTITIES[self.quantity]

    def number(self, key: str) -> float:
        """Return a metadata entry as a number.

        Raises
        ------
        MuyscError
            If the entry is missing or no finite number.
        """
        try:
            return finite_number(self.metadata[key])
        except KeyError:
            raise MuyscError(
                f"The {self.quantity} muogram lacks the metadata key {key} (domain "
                f"{DOMAIN}); make it with a MUYSC algorithm or set the key."
            ) from None
        except ValueError:
            raise MuyscError(
                f"The metadata key {key} of the {self.quantity} muogram is "
                f"“{self.metadata[key]}”, which is not a finite number; set it to one."
            ) from None


class View(Described):
    """One quantity seen from one place: a muogram, or a raster in telescope angles."""

    values: np.ndarray

    def pixel_of(self, azimuth_deg: np.ndarray, elevation_deg: np.ndarray) -> np.ndarray:
        """Return the flat index of the pixel in each direction, −1 outside."""
        raise NotImplementedError

    def _nearest(self, right: np.ndarray, down: np.ndarray) -> np.ndarray:
        """Return the flat index of the pixel at a distance from the first, in pixels."""
        rows, columns = self.values.shape
        with np.errstate(invalid="ignore"):
            column, row = np.floor(right + 0.5), np.floor(down + 0.5)
            inside = (column >= 0) & (column < columns) & (row >= 0) & (row < rows)
            return np.where(inside, row * columns + column, -1).astype(np.int64)


@dataclass(frozen=True)
class Muogram(View):
    """Values of one quantity on a regular grid of ray directions.

    Parameters
    ----------
    quantity
        Key of `QUANTITIES`.
    values
        (n_elevation, n_azimuth), in the quantity's unit; NaN where unknown.
    azimuth_deg
        (n_azimuth,) increasing, clockwise from true north, continuous across
        north (350…370 or −10…10).
    elevation_deg
        (n_elevation,) decreasing, above the horizontal.
    metadata
        Everything else a later step needs, by the key it has in the raster:
        ``DETECTOR_LON``, ``DETECTOR_LAT`` (WGS 84 degrees),
        ``DETECTOR_ELEVATION`` (m), ``BORESIGHT_AZIMUTH``,
        ``BORESIGHT_ELEVATION`` (degrees), ``DENSITY`` (g/cm³), ``FLUX_MODEL``,
        ``ENERGY_LOSS`` and more.

    Raises
    ------
    MuyscError
        If the quantity is unknown or the shapes do not fit.
    """

    quantity: str
    values: np.ndarray
    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    metadata: Mapping[str, str | float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        _check_quantity(self.quantity)
        shape = (len(self.elevation_deg), len(self.azimuth_deg))
        if self.values.shape != shape:
            raise MuyscError(
                f"The muogram has {self.values.shape} values for {shape} directions "
                "(elevations, azimuths); give one value for each direction."
            )

    def pixel_of(self, azimuth_deg: np.ndarray, elevation_deg: np.ndarray) -> np.ndarray:
        """Return the flat index of the pixel in each direction, −1 outside the muogram."""
        rows, columns = self.values.shape
        left, right = self.azimuth_deg[[0, -1]]
        top, bottom = self.elevation_deg[[0, -1]]
        step_x = (right - left) / (columns - 1) if columns > 1 else 1.0
        step_y = (top - bottom) / (rows - 1) if rows > 1 else 1.0
        # The turn that brings the azimuth into the muogram's own count, 350…370 say.
        turned = left - step_x / 2 + (azimuth_deg - left + step_x / 2) % 360.0
        return self._nearest((turned - left) / step_x, (top - elevation_deg) / step_y)

    def with_values(self, quantity: str, values: np.ndarray, **metadata: str | float) -> Muogram:
        """Return another quantity on the same directions, `metadata` added."""
        return replace(
            self, quantity=quantity, values=values, metadata={**self.metadata, **metadata}
        )


def _check_quantity(quantity: str) -> None:
    """Refuse what is no key of `QUANTITIES`."""
    if quantity not in QUANTITIES:
        raise MuyscError(
            f"“{quantity}” is not a quantity of a muogram; use one of {', '.join(QUANTITIES)}."
        )


def _step(axis: np.ndarray, name: str) -> float:
    """Return the spacing of an evenly spaced axis, which may hold one value."""
    if len(axis) == 1:
        return 1.0
    step = (axis[-1] - axis[0]) / (len(axis) - 1)
    if np.any(np.abs(np.diff(axis) - step) > _AXIS_TOLERANCE * abs(step) * len(axis)):
        raise MuyscError(
            f"The {name} axis of a muogram raster must be evenly spaced; "
            "resample the muogram to a regular grid."
        )
    return float(step)


@dataclass(frozen=True)
class Grid:
    """What a raster of directions holds, whatever its axes mean."""

    #: Key of `QUANTITIES`.
    quantity: str
    #: (n_y, n_x).
    values: np.ndarray
    #: (n_x,) increasing and (n_y,) decreasing pixel centres.
    x: np.ndarray
    y: np.ndarray
    metadata: Mapping[str, str | float]


def write_muogram(muogram: Muogram, path: str | Path) -> None:
    """Write a muogram as a self-describing single-band GeoTIFF.

    x is the azimuth and y the elevation in degrees, pixel centres on the ray
    directions, top row highest; Float32, DEFLATE, no-data NaN.

    Raises
    ------
    MuyscError
        If the directions are not evenly spaced or the file cannot be written.
    """
    axes = muogram.azimuth_deg, muogram.elevation_deg
    write_grid(
        Grid(muogram.quantity, muogram.values, *axes, muogram.metadata),
        path,
        ("azimuth", "elevation"),
    )


@raster_writer
def write_grid(
    grid: Grid, path: str | Path, names: tuple[str, str], lonely_step: float = 1.0
) -> None:
    """Write a grid as a self-describing single-band GeoTIFF.

    Parameters
    ----------
    grid
        What to write.
    path
        The file.
    names
        Names of the axes x and y, for messages.
    lonely_step
        Size of a pixel that is alone on its axis.

    Raises
    ------
    MuyscError
        If an axis is not evenly spaced or the file cannot be written.
    """
    from osgeo import gdal

    kind = QUANTITIES[grid.quantity]
    step_x = _step(grid.x, names[0]) if len(grid.x) > 1 else lonely_step
    step_y = _step(grid.y, names[1]) if len(grid.y) > 1 else -lonely_step
    rows, columns = grid.values.shape
    dataset = gdal.GetDriverByName("GTiff").Create(
        str(path), columns, rows, 1, gdal.GDT_Float32,
        ["COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES", "BIGTIFF=IF_SAFER"],
    )  # fmt: skip
    dataset.SetGeoTransform((
        grid.x[0] - step_x / 2, step_x, 0.0, grid.y[0] - step_y / 2, 0.0, step_y,
    ))  # fmt: skip
    entries = {
        "QUANTITY": grid.quantity,
        "UNIT": kind.unit,
        "VERSION": __version__,
        **{key: as_text(value) for key, value in grid.metadata.items()},
    }
    dataset.SetMetadata(entries, DOMAIN)
    band = dataset.GetRasterBand(1)
    band.SetNoDataValue(float("nan"))
    band.SetDescription(kind.label)
    band.SetUnitType(kind.unit)
    band.WriteArray(as_float32(grid.values, kind.title.lower()))
    band.FlushCache()
    dataset.FlushCache()
    del band, dataset


def as_text(value: str | float) -> str:
    """Return a metadata value as text that reads back to the same number."""
    return value if isinstance(value, str) else repr(float(value))


def read_muogram(path: str | Path) -> Muogram:
    """Read a muogram raster.

    Raises
    ------
    MuyscError
        If the file is not a raster, holds more than one band, is rotated, lacks
        the metadata that says what it holds, or is in telescope angles.
    """
    grid = read_grid(path)
    projection = str(grid.metadata.get("PROJECTION", "angles"))
    if projection != "angles":
        raise MuyscError(
            f"{path} is a raster in telescope angles (PROJECTION {projection}), where a muogram "
            "of azimuth and elevation is needed; choose one made by Muon radiography."
        )
    return Muogram(grid.quantity, grid.values, grid.x, grid.y, grid.metadata)


@raster_reader
def read_grid(path: str | Path) -> Grid:
    """Read a raster of directions, whatever its axes mean.

    Raises
    ------
    MuyscError
        If the file is not a raster, holds more than one band or another quantity, is
        rotated, lacks the metadata that says what it holds, or has pixels that are no
        directions.
    """
    from osgeo import gdal

    try:
        dataset = gdal.Open(str(path))
    except RuntimeError as error:
        raise MuyscError(f"The muogram {path} cannot be opened: {detail_of(error)}.") from error
    metadata = metadata_of(dataset, DOMAIN)
    quantity = metadata.pop("QUANTITY", None)
    metadata.pop("UNIT", None)
    metadata.pop("VERSION", None)
    if quantity is None:
        raise MuyscError(
            f"{path} lacks the metadata key QUANTITY (domain {DOMAIN}), so it is no "
            "muogram; choose a raster made by a MUYSC algorithm."
        )
    if dataset.RasterCount != 1:
        raise MuyscError(
            f"{path} has {dataset.RasterCount} bands where a muogram has 1; "
            "choose a raster made by a MUYSC algorithm."
        )
    # First what it holds: a volume of one slice has no directions either.
    _check_quantity(quantity)
    left, step_x, skew_x, top, skew_y, step_y = dataset.GetGeoTransform()
    if skew_x or skew_y or step_x <= 0 or step_y >= 0:
        raise MuyscError(
            f"{path} is rotated or upside down (geotransform {dataset.GetGeoTransform()}); "
            "a muogram has azimuth to the right and elevation upwards."
        )
    if not reach_of(dataset) <= _FARTHEST or min(step_x, -step_y) < _NARROWEST:
        raise MuyscError(
            f"The pixels of {path} are no directions (geotransform {dataset.GetGeoTransform()}): "
            f"angles or tangents reach ±{_FARTHEST:g} at most and are {_NARROWEST:g} or more "
            "apart; choose a raster made by a MUYSC algorithm."
        )
    band = dataset.GetRasterBand(1)
    values = band.ReadAsArray().astype(float)
    no_data = band.GetNoDataValue()
    if no_data is not None and not np.isnan(no_data):
        values[values == no_data] = np.nan
    return Grid(
        quantity,
        values,
        left + step_x * (np.arange(dataset.RasterXSize) + 0.5),
        top + step_y * (np.arange(dataset.RasterYSize) + 0.5),
        metadata,
    )
