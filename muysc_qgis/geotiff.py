"""Rasters that are written whole, or refused in one sentence."""

from __future__ import annotations

import functools
import inspect
import traceback
from collections.abc import Callable
from typing import Any, TypeVar, cast

from .errors import MuyscError, detail_of

Writer = TypeVar("Writer", bound=Callable[..., Any])


def raster_writer(function: Writer) -> Writer:
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

    return cast(Writer, write)


def _let_go(error: BaseException) -> None:
    """Close the dataset that an error has left open.

    Closing tries to write once more, and Python prints what goes wrong then.
    """
    from osgeo import gdal

    gdal.DontUseExceptions()
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    try:
        traceback.clear_frames(error.__traceback__)
    finally:
        gdal.PopErrorHandler()
        gdal.UseExceptions()
