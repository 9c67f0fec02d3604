"""What muograms and rasters in telescope angles have in common."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Union

import numpy as np

from .errors import MuyscError
from .muogram import Muogram
from .trajectories import TrajectoryMap

#: One quantity seen from one place, on directions of either kind.
View = Union[Muogram, TrajectoryMap]

#: Directions of two views may differ by this share of a pixel.
_SAME_PIXEL = 1e-3

#: π/180 of the mean radius of WGS 84, 6371 km, rounded.
_METRES_PER_DEGREE = 111_200.0


def elevation_of(view: View) -> np.ndarray:
    """Return the elevation of the rays in degrees, of a shape that broadcasts with the values.

    Raises
    ------
    MuyscError
        If a raster in telescope angles does not say where the telescope points.
    """
    if isinstance(view, Muogram):
        return view.elevation_deg[:, None]
    return view.directions_deg()[1]


def like(
    view: View, quantity: str, values: np.ndarray, metadata: Mapping[str, str | float]
) -> View:
    """Return another quantity on the directions of a view.

    Parameters
    ----------
    view
        Has the directions.
    quantity, values
        Key of `QUANTITIES`, and values of the view's shape in its unit.
    metadata
        All of them; those of the view do not stay.
    """
    return replace(view, quantity=quantity, values=values, metadata=metadata)


def require_quantity(view: View, quantities: tuple[str, ...], name: str) -> None:
    """Refuse a view of another quantity than those given; `name` begins the sentence.

    Raises
    ------
    MuyscError
        With the quantity that it holds.
    """
    if view.quantity not in quantities:
        raise MuyscError(
            f"{name} holds {view.quantity}; choose a muogram of the quantity "
            f"{' or '.join(quantities)}."
        )


def require_same_directions(one: View, name: str, other: View, other_name: str) -> None:
    """Refuse two views that are not on the same directions; the names are for the sentence.

    Raises
    ------
    MuyscError
        With the directions of both.
    """
    same = _same_axes(one, other)
    if same and isinstance(one, TrajectoryMap):
        keys = ("BORESIGHT_AZIMUTH", "BORESIGHT_ELEVATION", "ROLL")
        apart = np.array([one.number(key) - other.number(key) for key in keys])
        # A thousandth of a pixel again, roughly: tangents are near radians.
        step = np.degrees(min(one.pixel_size))
        same = bool(np.all(np.abs(_around(apart)) <= _SAME_PIXEL * step))
    if not same:
        raise MuyscError(
            f"The muogram of {name} has {describe_grid(one)} and that of {other_name} "
            f"{describe_grid(other)}; make both on the same directions."
        )


def require_same_pixels(one: View, name: str, other: View, other_name: str) -> None:
    """Refuse two views that are not of the same telescope pixels, wherever these point.

    The names, in the plural, are for the sentence.

    Raises
    ------
    MuyscError
        With the pixels of both.
    """
    tangents = isinstance(one, TrajectoryMap) and isinstance(other, TrajectoryMap)
    if one.values.shape != other.values.shape or (tangents and not _same_axes(one, other)):
        raise MuyscError(
            f"The {name} have {describe_grid(one)} and the {other_name} {describe_grid(other)}; "
            "give both of the same telescope pixels."
        )


def describe_grid(view: View) -> str:
    """Return size and limits of a view in words."""
    rows, columns = view.values.shape
    (x, y), (across, up), unit = _axes(view)
    return (
        f"{columns} × {rows} pixels, {across} {x[0]:g}{unit} to {x[-1]:g}{unit}, {up} "
        f"{y[-1]:g}{unit} to {y[0]:g}{unit}"
    )


def metres_apart(one: View, other: View) -> float:
    """Return the rough distance of two detectors (m), NaN where one is not known."""
    try:
        (lon, lat), (other_lon, other_lat) = (
            (view.number("DETECTOR_LON"), view.number("DETECTOR_LAT")) for view in (one, other)
        )
    except MuyscError:
        return float("nan")
    east = float(_around(np.array(lon - other_lon))) * np.cos(np.radians(lat))
    return float(_METRES_PER_DEGREE * np.hypot(east, lat - other_lat))


def _axes(view: View) -> tuple[tuple[np.ndarray, np.ndarray], tuple[str, str], str]:
    if isinstance(view, Muogram):
        return (view.azimuth_deg, view.elevation_deg), ("azimuth", "elevation"), "°"
    return (view.x, view.y), ("tangent to the right", "upwards"), ""


def _same_axes(one: View, other: View) -> bool:
    """Return whether two views have the same axes, of the same kind."""
    if type(one) is not type(other) or one.values.shape != other.values.shape:
        return False
    for first, second in zip(_axes(one)[0], _axes(other)[0]):
        step = abs(second[-1] - second[0]) / max(1, len(second) - 1) or 1.0
        apart = first - second
        if isinstance(one, Muogram):
            apart = _around(apart)  # 350° and −10° are one direction
        if np.any(np.abs(apart) > _SAME_PIXEL * step):
            return False
    return True


def _around(angle_deg: np.ndarray) -> np.ndarray:
    """Return angles between −180° and 180°."""
    return (angle_deg + 180.0) % 360.0 - 180.0
