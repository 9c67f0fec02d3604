"""From a text file to muograms: one entry for tables, matrices and the first MUYSC's files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from ..errors import MuyscError
from ..muogram import Muogram
from ..quantities import ERROR_SUFFIX, QUANTITIES
from .layout import TextLayout
from .observation import check_counts, pixels
from .original import original_header
from .readers import is_table, read_matrix, read_original, read_table
from .text import TextTable, read_text_table


@dataclass(frozen=True)
class Imported:
    """Muogram of values, muogram of their errors if there are any, and what to say."""

    muogram: Muogram
    error: Muogram | None
    #: What was found or assumed, one sentence each.
    notes: tuple[str, ...]
    warnings: tuple[str, ...] = ()


def import_muogram(
    path: str | Path,
    quantity: str,
    layout: TextLayout,
    metadata: Mapping[str, str | float],
    error_path: str | Path | None = None,
    axes: Muogram | None = None,
) -> Imported:
    """Read a text file as a muogram.

    Parameters
    ----------
    path
        Table or matrix.
    quantity
        Key of `QUANTITIES` that the values are, in its unit once multiplied by the factor.
    layout
        How to read it.
    metadata
        Of the muogram; ``BORESIGHT_AZIMUTH`` and ``BORESIGHT_ELEVATION`` are needed for
        angles that count from the boresight, and else default to the middle of the picture.
    error_path
        Matrix of standard errors, for a matrix.
    axes
        Muogram whose directions a matrix without angles has.

    Raises
    ------
    MuyscError
        If the file cannot be read, or is no regular and complete grid of valid values.
    """
    table = read_text_table(path, layout.no_data)
    header = original_header(table)
    if header is not None and layout.layout != "matrix":
        found = read_original(table, header, layout)
    elif layout.layout == "matrix" or (
        layout.layout == "auto" and (layout.has_ends or _fits(table, axes) or not is_table(table))
    ):
        errors = None if error_path is None else read_text_table(error_path, layout.no_data)
        found = read_matrix(table, errors, layout, metadata, axes)
    else:
        found = read_table(table, quantity, layout, metadata)
        if error_path is not None:
            raise MuyscError(
                f"{table.name} is a table, whose errors stand in a column of its own; name that "
                "column instead of a second file."
            )
    grid = replace(found.grid, values=found.grid.values * layout.factor)
    values = grid.values[0]
    _check_values(values, quantity, table.name)
    told = {**found.metadata, **metadata}
    middle = (grid.azimuth_deg[0] + grid.azimuth_deg[-1]) / 2
    told.setdefault("BORESIGHT_AZIMUTH", float(middle % 360.0))
    told.setdefault(
        "BORESIGHT_ELEVATION", float(grid.elevation_deg[0] + grid.elevation_deg[-1]) / 2
    )
    told["SOURCE"] = table.name
    muogram = Muogram(quantity, values, grid.azimuth_deg, grid.elevation_deg, told)
    error = None
    if len(grid.values) > 1:
        error = _error_muogram(muogram, grid.values[1], table.name)
    missing = int(np.count_nonzero(np.isnan(values)))
    if missing == values.size:
        raise MuyscError(f"{table.name} holds no value at all; choose the column of the values.")
    found.notes.append(
        f"{values.shape[1]} × {values.shape[0]} pixels, azimuth {grid.azimuth_deg[0]:g}° to "
        f"{grid.azimuth_deg[-1]:g}°, elevation {grid.elevation_deg[-1]:g}° to "
        f"{grid.elevation_deg[0]:g}°, {missing} without a value."
    )
    return Imported(muogram, error, tuple(found.notes), tuple(found.warnings))


def _fits(table: TextTable, axes: Muogram | None) -> bool:
    """Return whether a file without names has a value for each pixel of another muogram."""
    return axes is not None and not table.names and table.values.shape == axes.values.shape


def _check_values(values: np.ndarray, quantity: str, name: str) -> None:
    """Refuse what the quantity cannot be."""
    kind = QUANTITIES[quantity]
    if quantity == "counts":
        check_counts(values, f"counts in {name}")
    bad = values[(values < 0) | np.isinf(values)]
    if bad.size:
        raise MuyscError(
            f"{name} holds {bad[0]:g} (and so on, in {pixels(bad.size)}), and a "
            f"{kind.title.lower()} is 0 or more and finite; correct it, or name the number that "
            "stands for no data."
        )


def _error_muogram(muogram: Muogram, errors: np.ndarray, name: str) -> Muogram:
    quantity = muogram.quantity + ERROR_SUFFIX
    if quantity not in QUANTITIES:
        raise MuyscError(
            f"A {muogram.kind.title.lower()} has no error in MUYSC; name no column of errors."
        )
    bad = errors[(errors < 0) | np.isinf(errors)]
    if bad.size:
        raise MuyscError(
            f"The errors in {name} are negative or infinite in {pixels(bad.size)}, such as "
            f"{bad[0]:g}; give standard errors of 0 or more."
        )
    return muogram.with_values(quantity, errors)
