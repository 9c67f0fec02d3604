"""From scattered rows to a regular grid of directions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError

#: Directions closer than this (degrees) are the same one, written differently.
_SAME_DEG = 1e-6

#: How far a direction may be off its place on the grid, as a share of the step, for
#: angles that were rounded when they were written.
_ROUNDING = 0.1


@dataclass(frozen=True)
class Rows:
    """Directions and values line by line, all (n_row,)."""

    #: File name, for messages.
    name: str
    #: Line of each row in the file.
    lines: np.ndarray
    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    #: (n_row, n_value) whatever belongs to the directions, NaN where missing.
    values: np.ndarray


@dataclass(frozen=True)
class Grid:
    """Values on a regular grid, in the order of a muogram."""

    #: (n_azimuth,) increasing.
    azimuth_deg: np.ndarray
    #: (n_elevation,) decreasing.
    elevation_deg: np.ndarray
    #: (n_value, n_elevation, n_azimuth).
    values: np.ndarray


def to_grid(rows: Rows) -> Grid:
    """Sort rows in any order into a regular and complete grid.

    Parameters
    ----------
    rows
        Directions with values.

    Raises
    ------
    MuyscError
        If a direction is no direction, off the grid, missing or there twice; the message
        names the first such line.
    """
    _check_directions(rows)
    azimuth_axis, column = _axis(rows, _continuous(rows.azimuth_deg), "azimuth")
    elevation_axis, row = _axis(rows, rows.elevation_deg, "elevation")
    place = row * len(azimuth_axis) + column
    holder = np.full(len(azimuth_axis) * len(elevation_axis), -1)
    for index, here in enumerate(place):
        if holder[here] >= 0:
            raise MuyscError(
                f"Line {rows.lines[index]} of {rows.name} gives the direction "
                f"{_direction(rows, index)} for a second time, after line "
                f"{rows.lines[holder[here]]}; give each direction once."
            )
        holder[here] = index
    missing = np.flatnonzero(holder < 0)
    if missing.size:
        raise MuyscError(_gap(rows, holder, missing, azimuth_axis, elevation_axis))
    values = rows.values[holder].T
    shape = (len(values), len(elevation_axis), len(azimuth_axis))
    return Grid(azimuth_axis, elevation_axis[::-1], values.reshape(shape)[:, ::-1])


def matrix_axis(first_deg: float, last_deg: float, count: int, name: str) -> np.ndarray:
    """Return the directions of the rows or columns of a matrix.

    Raises
    ------
    MuyscError
        If several rows or columns have one direction.
    """
    if count > 1 and abs(last_deg - first_deg) < _SAME_DEG * count:
        raise MuyscError(
            f"The matrix has {count} {name}s and the first and the last are both at "
            f"{first_deg:g}°; give the angles of the two outermost pixel centres."
        )
    return np.linspace(first_deg, last_deg, count)


def matrix_grid(values: np.ndarray, azimuth_deg: np.ndarray, elevation_deg: np.ndarray) -> Grid:
    """Return a matrix with its axes in the order of a muogram.

    Parameters
    ----------
    values
        (n_value, n_row, n_column).
    azimuth_deg, elevation_deg
        Of the columns and rows, increasing or decreasing.
    """
    if azimuth_deg[-1] < azimuth_deg[0]:
        azimuth_deg, values = azimuth_deg[::-1], values[:, :, ::-1]
    if elevation_deg[-1] > elevation_deg[0]:
        elevation_deg, values = elevation_deg[::-1], values[:, ::-1]
    return Grid(azimuth_deg, elevation_deg, values)


def _check_directions(rows: Rows) -> None:
    for angle, low, high, name in (
        (rows.azimuth_deg, -720.0, 720.0, "azimuth"),
        (rows.elevation_deg, -90.0, 90.0, "elevation"),
    ):
        bad = np.flatnonzero(~((angle >= low) & (angle <= high)))
        if bad.size:
            raise MuyscError(
                f"Line {rows.lines[bad[0]]} of {rows.name} gives an {name} of "
                f"{angle[bad[0]]:g}°, which is no direction; check the columns, the unit of the "
                "angles, and whether they are elevations or zenith angles."
            )


def _continuous(azimuth_deg: np.ndarray) -> np.ndarray:
    """Return azimuths without a jump at north: 350…370 for 350…359 and 0…10."""
    turned = np.sort(azimuth_deg % 360.0)
    gaps = np.diff(np.append(turned, turned[0] + 360.0))
    widest = int(np.argmax(gaps))
    span = float(np.ptp(azimuth_deg))
    # As written, unless going round north makes the picture narrower.
    if 360.0 - gaps[widest] > span - _SAME_DEG:
        return azimuth_deg
    start = turned[(widest + 1) % len(turned)]
    return start + (azimuth_deg - start + _SAME_DEG) % 360.0 - _SAME_DEG


def _axis(rows: Rows, angle: np.ndarray, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Return the evenly spaced directions of an axis and each row's place on it."""
    ordered = np.sort(angle)
    starts = np.flatnonzero(np.diff(ordered, prepend=-np.inf) > _SAME_DEG)
    distinct = ordered[starts]
    if len(distinct) == 1:
        return distinct, np.zeros(len(angle), dtype=int)
    # A direction off the grid is rare; those that come often make the grid.
    often = np.diff(np.append(starts, len(ordered)))
    regular = distinct[often > often.max() / 2]
    if len(regular) == 1:
        regular = distinct
    first, last = float(regular[0]), float(regular[-1])
    # The median is the step even if whole rows are missing; rounding is taken out after.
    intervals = max(1, round((last - first) / float(np.median(np.diff(regular)))))
    step = (last - first) / intervals
    place = np.rint((angle - first) / step).astype(int)
    off = np.abs(angle - first - place * step) > _ROUNDING * step
    if off.any():
        bad = int(np.argmax(off))
        raise MuyscError(
            f"Line {rows.lines[bad]} of {rows.name} gives an {name} of {angle[bad]:g}°, which is "
            f"off the regular grid from {first:g}° in steps of {step:.4g}°; resample the "
            "measurement to a regular grid."
        )
    # Rare directions may lie beyond the others and still be on the grid.
    low, high = int(place.min()), int(place.max())
    return first + step * np.arange(low, high + 1), place - low


def _gap(
    rows: Rows,
    holder: np.ndarray,
    missing: np.ndarray,
    azimuth_deg: np.ndarray,
    elevation_deg: np.ndarray,
) -> str:
    """Say which direction is missing, and after which line it was to be expected."""
    columns = len(azimuth_deg)
    first, where = None, ""
    if len(rows.lines) > 1:
        # The direction that changes from line to line, and which way it runs.
        places = [int(np.flatnonzero(holder == index)[0]) for index in (0, 1)]
        order = np.arange(len(holder)).reshape(-1, columns)
        if places[0] // columns != places[1] // columns:
            order = order.T
        if places[1] < places[0]:
            order = order[:, ::-1]
        if np.argwhere(order == places[0])[0][0] > 0:
            order = order[::-1]
        ahead = -1
        for here in order.ravel():
            if holder[here] < 0:
                first = here
                break
            ahead = holder[here]
        where = f" after line {rows.lines[ahead]}" if ahead >= 0 else " before the first line"
    first = int(missing[0]) if first is None else int(first)
    return (
        f"{rows.name} lacks {missing.size} of {holder.size} directions of a regular grid; the "
        f"first is azimuth {azimuth_deg[first % columns]:g}°, elevation "
        f"{elevation_deg[first // columns]:g}°{where}; give every direction, with nan as the "
        "value where nothing was measured."
    )


def _direction(rows: Rows, index: int) -> str:
    return f"azimuth {rows.azimuth_deg[index]:g}°, elevation {rows.elevation_deg[index]:g}°"
