"""Tiles as they come over the wire: unpacked within limits, and checked."""

from __future__ import annotations

import io
import zipfile
import zlib
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import MuyscError, detail_of
from .heights import LOWEST_M, PEAK_M
from .srtm import Tile

#: No height, in SRTM's tiles and in every DEM written here (NASA SRTM user guide).
VOID = -32768

#: Heights along the sides of an .hgt tile: one or three arc seconds, both edges included.
_SIDES = (3601, 1201)
_SIZES = {2 * side**2: side for side in _SIDES}
_LARGEST = max(_SIZES)

#: How far (in cells) a GeoTIFF may lie from where its name says.
_OFF_CELLS = 0.01


@dataclass(frozen=True)
class TileHeights:
    """Heights of a tile, on cell centres that divide the degree evenly."""

    #: (rows, columns), m; the first row on the northern edge, the first column on the
    #: western one, the last perhaps on the opposite ones. `VOID` where there is none.
    values: np.ndarray
    rows_per_degree: int
    columns_per_degree: int


def decode(payload: bytes, tile: Tile, address: str) -> TileHeights:
    """Unpack a tile and check that it is one.

    What it is shows in its first bytes, whatever the address says: plain .hgt,
    gzip or zip of it, or GeoTIFF.

    Parameters
    ----------
    payload
        What came.
    tile
        What it should be.
    address
        Where it came from, for messages.

    Raises
    ------
    MuyscError
        If it is anything else, incomplete, or larger than a tile once unpacked.
    """
    if payload[:4] in (b"II*\0", b"MM\0*"):
        heights = _from_tiff(payload, tile, address)
    else:
        heights = _from_hgt(_unpacked(payload, address), address)
    known = heights.values[heights.values != VOID]
    if known.size and not LOWEST_M <= known.min() <= known.max() <= PEAK_M:
        raise _refusal(
            address,
            f"heights from {known.min():g} to {known.max():g} m, beyond the {LOWEST_M:g} to "
            f"{PEAK_M:g} m that there are",
        )
    return heights


def _refusal(address: str, what: str) -> MuyscError:
    return MuyscError(
        f"{address} sent {what}, which is no tile of heights; try again, check SOURCE, or choose "
        "an authentication (AUTHCFG) if the server asks for a login."
    )


def _unpacked(payload: bytes, address: str) -> bytes:
    if payload[:2] == b"\x1f\x8b":
        return _from_gzip(payload, address)
    if payload[:2] == b"PK":
        return _from_zip(payload, address)
    return payload


def _from_gzip(payload: bytes, address: str) -> bytes:
    # 16 more than the window's size asks for gzip's header and checksum.
    stream = zlib.decompressobj(16 + zlib.MAX_WBITS)
    try:
        data = stream.decompress(payload, _LARGEST + 1)
    except zlib.error as error:
        raise _refusal(address, f"a damaged gzip file ({error})") from error
    if len(data) > _LARGEST:
        raise _refusal(address, f"a gzip file that holds more than {_LARGEST} bytes")
    if not stream.eof:
        raise _refusal(address, f"a gzip file that breaks off after {len(payload)} bytes")
    return data


def _from_zip(payload: bytes, address: str) -> bytes:
    try:
        with zipfile.ZipFile(io.BytesIO(payload)) as archive:
            members = [one for one in archive.infolist() if one.filename.lower().endswith(".hgt")]
            if len(members) != 1:
                raise _refusal(address, f"a zip file with {len(members)} .hgt files, not one")
            with archive.open(members[0]) as file:
                data = file.read(_LARGEST + 1)
    except (zipfile.BadZipFile, zlib.error, EOFError, RuntimeError) as error:
        raise _refusal(address, f"a damaged zip file ({error})") from error
    if len(data) > _LARGEST:
        raise _refusal(address, f"a zip file that holds more than {_LARGEST} bytes")
    return data


def _from_hgt(data: bytes, address: str) -> TileHeights:
    side = _SIZES.get(len(data))
    if side is None:
        kind = " of a web page" if data.lstrip()[:1] == b"<" else ""
        wanted = " or ".join(str(size) for size in _SIZES)
        raise _refusal(address, f"{len(data)} bytes{kind} instead of {wanted}")
    # Row by row from the north, most significant byte first (NASA SRTM user guide).
    values = np.frombuffer(data, ">i2").reshape(side, side).astype(np.int16)
    return TileHeights(values, side - 1, side - 1)


def _from_tiff(payload: bytes, tile: Tile, address: str) -> TileHeights:
    from osgeo import gdal

    gdal.UseExceptions()
    path = f"/vsimem/muysc-{id(payload)}/tile.tif"
    gdal.FileFromMemBuffer(path, payload)
    try:
        dataset = gdal.OpenEx(path, gdal.OF_RASTER, allowed_drivers=["GTiff"])
        rows_per_degree, columns_per_degree = _grid_of_tiff(dataset, tile, address)
        band = dataset.GetRasterBand(1)
        values = band.ReadAsArray()
        no_data = band.GetNoDataValue()
        del band, dataset
    except RuntimeError as error:
        detail = detail_of(error).replace(path, "the file")
        raise _refusal(address, f"a damaged GeoTIFF ({detail})") from error
    finally:
        gdal.Unlink(path)
    values = values.astype(np.int16 if values.dtype == np.int16 else np.float32)
    if values.dtype == np.float32:
        values[~np.isfinite(values)] = VOID
    if no_data is not None and np.isfinite(no_data):
        values[values == no_data] = VOID
    return TileHeights(values, rows_per_degree, columns_per_degree)


def _grid_of_tiff(dataset: Any, tile: Tile, address: str) -> tuple[int, int]:
    """Return rows and columns in a degree of a GeoTIFF that lies where its name says."""
    columns, rows = dataset.RasterXSize, dataset.RasterYSize
    bands = dataset.RasterCount
    geotransform = dataset.GetGeoTransform(can_return_null=True)
    if bands != 1 or max(rows, columns) > max(_SIDES) or geotransform is None:
        raise _refusal(
            address, f"a GeoTIFF of {columns} × {rows} cells in {bands} bands, or without a place"
        )
    left, step_x, skew_x, top, skew_y, step_y = geotransform
    per_degree = [round(1 / abs(step)) if step else 0 for step in (step_y, step_x)]
    if 0 in per_degree or skew_x or skew_y:
        raise _refusal(address, "a GeoTIFF whose cells do not divide a degree")
    # Cell centres of the first row and column, counted from where they should be.
    off = (
        (left - tile.longitude_deg) * per_degree[1] + 0.5,
        (top - tile.latitude_deg - 1) * per_degree[0] - 0.5,
        abs(step_x) * columns * per_degree[1] - columns,
        abs(step_y) * rows * per_degree[0] - rows,
    )
    complete = rows - per_degree[0] in (0, 1) and columns - per_degree[1] in (0, 1)
    if not complete or step_x < 0 or step_y > 0 or max(map(abs, off)) > _OFF_CELLS:
        raise _refusal(
            address,
            f"a GeoTIFF of {columns} × {rows} cells from {left:.6g}° east and {top:.6g}° north, "
            f"which does not cover {tile.name}",
        )
    return per_degree[0], per_degree[1]
