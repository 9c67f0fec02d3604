"""Reading the three kinds of text file into a grid."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from ..errors import MuyscError
from ..muogram import Muogram
from .columns import choose_columns
from .grid import Grid, Rows, matrix_axis, matrix_grid, to_grid
from .layout import TextLayout, directions_of
from .original import OriginalHeader, line_of_sight
from .text import TextTable

#: Angles that all stay below this (a little over 2π) could be radians.
_COULD_BE_RADIANS = 6.4


@dataclass(frozen=True)
class Found:
    """A grid and what was learnt on the way."""

    grid: Grid
    notes: list[str]
    warnings: list[str] = field(default_factory=list)
    metadata: dict[str, str | float] = field(default_factory=dict)


def is_table(table: TextTable) -> bool:
    """Return whether a file is rows of directions and values rather than a picture."""
    if table.names:
        return True
    if not 3 <= table.values.shape[1] <= 5:
        return False
    # The directions of a table come again and again, even if some are missing; the values
    # of a picture do not.
    rows = len(table.values)
    first, second = (len(np.unique(table.values[:, n])) for n in (0, 1))
    return rows > 1 and first * second <= 2 * rows


def read_table(
    table: TextTable, quantity: str, layout: TextLayout, metadata: Mapping[str, str | float]
) -> Found:
    """Return rows of directions and values as a grid.

    Raises
    ------
    MuyscError
        If columns cannot be told apart, or the directions are no regular, complete grid.
    """
    columns = choose_columns(
        table, quantity, layout.azimuth_column, layout.vertical_column, layout.value_column,
        layout.error_column, layout.vertical_angle,
    )  # fmt: skip
    angles = table.values[:, [columns.azimuth, columns.vertical]]
    unit = columns.angle_unit if layout.angle_unit == "auto" else layout.angle_unit
    notes, warnings = [], []
    if unit is None:
        unit = "degrees"
        known = angles[np.isfinite(angles)]
        if known.size and np.abs(known).max() < _COULD_BE_RADIANS:
            warnings.append(
                f"{table.name} does not say the unit of its angles, which all lie within "
                f"±{np.abs(known).max():.3g}; degrees were assumed, set radians if they are."
            )
    names = table.names or tuple(f"column {n + 1}" for n in range(table.values.shape[1]))
    picked = [columns.value] + ([] if columns.error is None else [columns.error])
    notes.append(
        f"Azimuth from {names[columns.azimuth]}, {columns.vertical_angle} angle from "
        f"{names[columns.vertical]} ({unit}), value from {names[columns.value]}"
        + ("." if columns.error is None else f", error from {names[columns.error]}.")
    )
    if unit == "radians":
        angles = np.degrees(angles)
    azimuth, elevation = directions_of(
        angles[:, 0], angles[:, 1], columns.vertical_angle, layout, metadata
    )
    rows = Rows(table.name, table.lines, azimuth, elevation, table.values[:, picked])
    return Found(to_grid(rows), notes, warnings)


def read_matrix(
    table: TextTable,
    errors: TextTable | None,
    layout: TextLayout,
    metadata: Mapping[str, str | float],
    axes: Muogram | None,
) -> Found:
    """Return a picture of values, and one of their errors, as a grid.

    Raises
    ------
    MuyscError
        If its directions are not known or impossible, or the errors are not as many.
    """
    layers = [table.values]
    if errors is not None:
        if errors.values.shape != table.values.shape:
            raise MuyscError(
                f"{errors.name} has {_size(errors.values)} errors for the {_size(table.values)} "
                f"values of {table.name} (columns × rows); give one error for each value."
            )
        layers.append(errors.values)
    values = np.stack(layers)
    ends = (
        layout.azimuth_first, layout.azimuth_last, layout.vertical_first, layout.vertical_last,
    )  # fmt: skip
    rows, columns = table.values.shape
    note = f"A matrix of {_size(table.values)} values (columns × rows)"
    if not layout.has_ends and axes is not None:
        if axes.values.shape != table.values.shape:
            raise MuyscError(
                f"{table.name} has {_size(table.values)} values and the reference muogram "
                f"{_size(axes.values)} pixels (columns × rows); give the angles of the first and "
                "last column and row."
            )
        grid = Grid(axes.azimuth_deg, axes.elevation_deg, values)
        return Found(grid, [f"{note} on the directions of the reference muogram."])
    if any(end is None for end in ends):
        raise MuyscError(
            f"{table.name} is a matrix of {_size(table.values)} values (columns × rows), which "
            "does not say its directions; give the angles of the first and last column and row, "
            "or a reference muogram."
        )
    if layout.vertical_angle == "auto":
        raise MuyscError(
            f"The rows of {table.name} could be elevation or zenith angles; set the vertical "
            "angle to one of the two."
        )
    angles = np.array(ends, dtype=float)
    if layout.angle_unit == "radians":
        angles = np.degrees(angles)
    across = matrix_axis(angles[0], angles[1], columns, "column")
    down = matrix_axis(angles[2], angles[3], rows, "row")
    azimuth, elevation = directions_of(across, down, layout.vertical_angle, layout, metadata)
    if np.abs(elevation).max() > 90:
        raise MuyscError(
            f"The rows of {table.name} reach an elevation of "
            f"{elevation[np.argmax(np.abs(elevation))]:g}°, which is no direction; check their "
            "angles and whether they are elevations or zenith angles."
        )
    return Found(matrix_grid(values, azimuth, elevation), [note + "."])


def read_original(table: TextTable, header: OriginalHeader, layout: TextLayout) -> Found:
    """Return a text muogram of the first MUYSC as a grid.

    Raises
    ------
    MuyscError
        If the directions are no regular, complete grid.
    """
    azimuth, elevation, distance = line_of_sight(header)
    turned = replace(layout, relative=True, azimuth_sense="counterclockwise")
    sight: dict[str, str | float] = {
        "DETECTOR_LON": header.detector[0],
        "DETECTOR_LAT": header.detector[1],
        "DETECTOR_ELEVATION": header.detector[2],
        "TARGET_LON": header.target[0],
        "TARGET_LAT": header.target[1],
        "TARGET_ELEVATION": header.target[2],
        "TARGET_DISTANCE": distance,
        "BORESIGHT_AZIMUTH": azimuth,
        "BORESIGHT_ELEVATION": elevation,
    }
    angles = np.degrees(table.values)
    directions = directions_of(angles[:, 1], angles[:, 0], "elevation", turned, sight)
    rows = Rows(table.name, table.lines, *directions, table.values[:, 2:])
    return Found(
        to_grid(rows),
        [f"{table.name} is a text muogram of the first MUYSC: radians from the line of sight."],
        [
            "The first MUYSC turned its rays in a frame of longitude and latitude and wrote "
            "horizontal lengths in metres, so directions and thickness are approximate."
        ],
        sight,
    )


def _size(values: np.ndarray) -> str:
    return f"{values.shape[1]} × {values.shape[0]}"
