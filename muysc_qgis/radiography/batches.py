"""Checking rays that are given as arrays, and cutting them into blocks."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, report, silent

#: Rays computed at a time; bounds the memory and keeps it in the processor's cache.
_BLOCK = 1 << 16

#: Distinct zenith angles tabulated at a time.
_ZENITH_BLOCK = 1 << 12


def checked(
    values: np.ndarray, elevation_deg: np.ndarray, name: str, unit: str
) -> tuple[np.ndarray, np.ndarray, tuple[int, ...]]:
    """Return values of at least one dimension, elevations of as many, and the common shape.

    Parameters
    ----------
    values
        What the caller gave for each ray: 0 or more, NaN where unknown.
    elevation_deg
        Elevation above the horizon in degrees; broadcasts with the values.
    name, unit
        The values' name and unit, for messages.

    Raises
    ------
    MuyscError
        If a value is negative or infinite, an elevation is no angle, or shapes do not fit.
    """
    values = np.asarray(values, dtype=float)
    elevation = np.asarray(elevation_deg, dtype=float)
    try:
        shape = np.broadcast_shapes(values.shape, elevation.shape)
    except ValueError:
        raise MuyscError(
            f"The {name} has shape {values.shape} and the elevation {elevation.shape}; give one "
            "elevation for each row, or for each ray."
        ) from None
    bad = values[(values < 0) | np.isinf(values)]
    if bad.size:
        raise MuyscError(
            f"{bad.size} values of {name} are negative or infinite, such as {bad[0]:g} {unit}; "
            "give values of 0 or more, and no-data where unknown."
        )
    bad = elevation[~(np.abs(elevation) <= 90)]
    if bad.size:
        raise MuyscError(
            f"{bad.size} elevations are no angles above the horizon, such as {bad[0]:g}°; give "
            "degrees from −90 to 90."
        )
    full = shape or (1,)
    values = np.broadcast_to(values, full)
    return values, elevation.reshape((1,) * (len(full) - elevation.ndim) + elevation.shape), shape


def blocks(
    shape: tuple[int, ...], elevation: np.ndarray, progress: Progress = silent
) -> Iterator[tuple[tuple[slice, ...], np.ndarray]]:
    """Cut rays along the first axis, bounding the memory of what is computed for each part.

    Parameters
    ----------
    shape
        Shape of the rays.
    elevation
        Their elevations, with as many dimensions.
    progress
        Told the share done before each block.

    Yields
    ------
    tuple
        Index of the block in the rays, and its elevations.

    Raises
    ------
    Cancelled
        If `progress` asks for a stop.
    """
    row_size = max(1, int(np.prod(shape[1:])))
    step = max(1, _BLOCK // row_size)
    if elevation.shape[0] > 1:
        step = min(step, max(1, _ZENITH_BLOCK // max(1, elevation[0].size)))
    for first in range(0, shape[0], step):
        report(progress, first / shape[0])
        block = (slice(first, first + step),)
        yield block, elevation if elevation.shape[0] == 1 else elevation[block]
