"""A quantity in voxels on the map, and its GeoTIFF form: one band for each elevation slice."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from . import __version__
from .errors import MuyscError, detail_of
from .geotiff import as_float32, metadata_of, raster_reader, raster_writer
from .muogram import DOMAIN, as_text
from .quantities import Quantity
from .tomography.voxels import VoxelGrid

#: What voxels can hold.
VOLUME_QUANTITIES = {
    quantity.name: quantity
    for quantity in (
        Quantity("density", "Density", "g/cm³", "cividis", False),
        Quantity("density_error", "Error of the density", "g/cm³", "plasma", False),
        Quantity("coverage", "Rays per voxel", "1", "viridis", True),
    )
}

#: What the QUANTITY of the file starts with, so that no slice is taken for a muogram.
_PREFIX = "voxel "

#: Metadata of the file that the grid itself tells.
_GRID_KEYS = ("QUANTITY", "UNIT", "VERSION", "BASE", "VOXEL_HEIGHT")


@dataclass(frozen=True)
class Volume:
    """Values of one quantity in voxels on the map, the 3-D counterpart of a muogram.

    Parameters
    ----------
    quantity
        Key of `VOLUME_QUANTITIES`.
    grid
        East, north and up along the axes of `crs` in its metres; heights as in the terrain model.
    values
        (east, north, up) in the quantity's unit; NaN in air and where nothing is known.
    crs
        Projected coordinate reference system, as WKT.
    metadata
        What a later step needs, by the key it has in the raster.

    Raises
    ------
    MuyscError
        If the quantity is unknown or the values do not fit the grid.
    """

    quantity: str
    grid: VoxelGrid
    values: np.ndarray
    crs: str
    metadata: Mapping[str, str | float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.quantity not in VOLUME_QUANTITIES:
            raise MuyscError(
                f"“{self.quantity}” is not a quantity of voxels; use one of "
                f"{', '.join(VOLUME_QUANTITIES)}."
            )
        self.grid.check(self.values)

    @property
    def kind(self) -> Quantity:
        """Title, unit and colours of the quantity."""
        return VOLUME_QUANTITIES[self.quantity]

    @property
    def known(self) -> np.ndarray:
        """Which voxels have a value, (east, north, up)."""
        return np.isfinite(self.values)

    def with_values(self, quantity: str, values: np.ndarray) -> Volume:
        """Return another quantity in the same voxels."""
        return replace(self, quantity=quantity, values=values)


def band_name(height_m: float) -> str:
    """Return the description of the band whose voxels are centred on a height."""
    return f"z = {height_m:.10g} m"


@raster_writer
def write_volume(volume: Volume, path: str | Path) -> None:
    """Write a volume as a self-describing GeoTIFF, one band for each elevation slice.

    Lowest slice first, each named after the height of its centre; Float32, DEFLATE, no-data
    NaN, and written slice by slice.

    Raises
    ------
    MuyscError
        If the file cannot be written.
    """
    from osgeo import gdal

    grid = volume.grid
    columns, rows, slices = grid.shape
    dataset = gdal.GetDriverByName("GTiff").Create(
        str(path), columns, rows, slices, gdal.GDT_Float32,
        ["COMPRESS=DEFLATE", "PREDICTOR=3", "INTERLEAVE=BAND", "BIGTIFF=IF_SAFER"],
    )  # fmt: skip
    dataset.SetGeoTransform((
        grid.origin_m[0], grid.size_m[0], 0.0, grid.end_m[1], 0.0, -grid.size_m[1],
    ))  # fmt: skip
    dataset.SetProjection(volume.crs)
    entries = {
        **{key: as_text(value) for key, value in volume.metadata.items()},
        "QUANTITY": _PREFIX + volume.quantity,
        "UNIT": volume.kind.unit,
        "VERSION": __version__,
        "BASE": as_text(grid.origin_m[2]),
        "VOXEL_HEIGHT": as_text(grid.size_m[2]),
    }
    dataset.SetMetadata(entries, DOMAIN)
    for level, height in enumerate(grid.centres_m(2)):
        band = dataset.GetRasterBand(level + 1)
        band.SetNoDataValue(float("nan"))
        band.SetDescription(band_name(height))
        band.SetUnitType(volume.kind.unit)
        values = volume.values[:, ::-1, level].T
        band.WriteArray(as_float32(values, volume.kind.title.lower()))
        band.FlushCache()
        del band
    dataset.FlushCache()
    del dataset


@raster_reader
def read_volume(path: str | Path) -> Volume:
    """Read a volume.

    Raises
    ------
    MuyscError
        If the file is not a raster, no volume, or rotated.
    """
    from osgeo import gdal

    try:
        dataset = gdal.Open(str(path))
    except RuntimeError as error:
        raise MuyscError(f"The volume {path} cannot be opened: {detail_of(error)}.") from error
    metadata = metadata_of(dataset, DOMAIN)
    quantity = metadata.get("QUANTITY", "")
    try:
        base, height = float(metadata["BASE"]), float(metadata["VOXEL_HEIGHT"])
    except (KeyError, ValueError):
        quantity = ""
    if not quantity.startswith(_PREFIX):
        raise MuyscError(
            f"{path} is no volume of voxels: its metadata (domain {DOMAIN}) lack QUANTITY, BASE "
            "or VOXEL_HEIGHT; choose a raster made by Muon tomography."
        )
    left, step_x, skew_x, top, skew_y, step_y = dataset.GetGeoTransform()
    if skew_x or skew_y or step_x <= 0 or step_y >= 0:
        raise MuyscError(
            f"{path} is rotated or upside down (geotransform {dataset.GetGeoTransform()}); a "
            "volume has east to the right and north upwards."
        )
    columns, rows, slices = dataset.RasterXSize, dataset.RasterYSize, dataset.RasterCount
    values = np.empty((columns, rows, slices))
    for level in range(slices):
        values[:, :, level] = dataset.GetRasterBand(level + 1).ReadAsArray()[::-1].T
    grid = VoxelGrid(
        (left, top + rows * step_y, base), (step_x, -step_y, height), (columns, rows, slices)
    )
    kept = {key: value for key, value in metadata.items() if key not in _GRID_KEYS}
    return Volume(quantity[len(_PREFIX) :], grid, values, dataset.GetProjection(), kept)
