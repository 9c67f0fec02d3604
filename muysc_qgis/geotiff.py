"""Rasters that are read or written whole, or refused in one sentence."""

from __future__ import annotations

import contextlib
import functools
import inspect
import os
import traceback
from collections.abc import Callable
from typing import Any, TypeVar, cast

import numpy as np

from .errors import MuyscError, detail_of

#: No map reaches further, whatever its unit: the Earth's girth is 4e7 m.
FARTHEST = 1e9

Function = TypeVar("Function", bound=Callable[..., Any])


def raster_reader(function: Function) -> Function:
    """Let a function that reads the raster `path` refuse in one sentence.

    A damaged file may fail wherever GDAL first needs a part of it.

    Raises
    ------
    MuyscError
        If GDAL cannot read the file.
    """
    signature = inspect.signature(function)

    @functools.wraps(function)
    def read(*arguments: Any, **options: Any) -> Any:
        from osgeo import gdal

        gdal.UseExceptions()
        try:
            return function(*arguments, **options)
        except RuntimeError as error:
            path = signature.bind(*arguments, **options).arguments["path"]
            raise MuyscError(
                f"The raster {path} cannot be read ({detail_of(error)}); check that the file is "
                "complete."
            ) from error

    return cast(Function, read)


def raster_writer(function: Function) -> Function:
    """Let a function that writes the raster `path` refuse in one sentence.

    Raises
    ------
    MuyscError
        If GDAL cannot write the file.
    """
    signature = inspect.signature(function)

    @functools.wraps(function)
    def write(*arguments: Any, **options: Any) -> Any:
        from osgeo import gdal

        gdal.UseExceptions()
        try:
            return function(*arguments, **options)
        except RuntimeError as error:
            _let_go(error)
            path = signature.bind(*arguments, **options).arguments["path"]
            detail = detail_of(error)
            raise MuyscError(
                f"The raster {path} cannot be written ({detail}); make room on the disk or choose "
                "another place."
            ) from None

    return cast(Function, write)


def as_float32(values: np.ndarray, what: str) -> np.ndarray:
    """Return values as a raster holds them.

    Raises
    ------
    MuyscError
        If a value is too large for that.
    """
    largest = np.finfo(np.float32).max
    beyond = np.abs(values) > largest
    if beyond.any():
        raise MuyscError(
            f"The {what} reaches {values[beyond][0]:g}, beyond the ±{largest:.3g} that a raster "
            "holds; check the numbers that it comes from."
        )
    return values.astype(np.float32)


def reach_of(dataset: Any) -> float:
    """Return a bound of the coordinates of a raster, in its own unit; NaN if it has none."""
    left, step_x, skew_x, top, skew_y, step_y = map(abs, dataset.GetGeoTransform())
    columns, rows = dataset.RasterXSize, dataset.RasterYSize
    x, y = left + step_x * columns + skew_x * rows, top + skew_y * columns + step_y * rows
    return float(np.maximum(x, y))


def is_endless(path: str) -> bool:
    """Return whether QGIS would open a raster for ever.

    It lets GDAL turn rotated rasters to the north, which does not end with coordinates like 1e200.
    """
    from osgeo import gdal

    gdal.UseExceptions()
    if not os.path.isfile(path):
        return False
    try:
        return not reach_of(gdal.Open(path)) <= FARTHEST
    except RuntimeError:
        return False


def metadata_of(dataset: Any, domain: str) -> dict[str, str]:
    """Return what a raster says of itself, with signs that are no text replaced."""
    return {_text(key): _text(value) for key, value in dataset.GetMetadata(domain).items()}


def _text(value: str | bytes) -> str:
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else value


def _let_go(error: BaseException) -> None:
    """Close the dataset that an error has left open.

    Closing tries to write once more, and Python prints what goes wrong then.
    """
    from osgeo import gdal

    # GDAL 3.6 refuses where other code has switched on those of its sister libraries since.
    with contextlib.suppress(RuntimeError):
        gdal.DontUseExceptions()
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    try:
        traceback.clear_frames(error.__traceback__)
    finally:
        gdal.PopErrorHandler()
        gdal.UseExceptions()
