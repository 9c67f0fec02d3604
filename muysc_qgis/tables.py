"""Tables as files."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterable, Sequence
from pathlib import Path

from .errors import MuyscError


def write_table(
    path: str | Path, columns: Sequence[str], lines: Iterable[Sequence[object]]
) -> None:
    """Write a table as comma-separated values; what is unknown (NaN) stays empty.

    Parameters
    ----------
    path
        The file.
    columns
        Names, with units.
    lines
        One cell for each column; numbers are written with nine digits.

    Raises
    ------
    MuyscError
        If the file cannot be written.
    """
    try:
        with Path(path).open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(columns)
            writer.writerows([_text(cell) for cell in line] for line in lines)
    except OSError as error:
        raise MuyscError(
            f"The table {path} cannot be written ({error.strerror}); choose another folder or "
            "close the program that holds the file."
        ) from error


def _text(cell: object) -> str:
    if isinstance(cell, float):
        return "" if math.isnan(cell) else f"{cell:.9g}"
    return str(cell)


def write_column_types(path: str | Path, line: Sequence[object]) -> None:
    """Write the types of a table's columns, as in one of its lines, for map software.

    The file that GDAL reads beside a table, of the same name but for a suffix ``.csvt``:
    without it every number of the table would be a text.

    Raises
    ------
    MuyscError
        If the file cannot be written.
    """
    kinds = {int: "Integer", float: "Real"}
    write_table(path, [kinds.get(type(cell), "String") for cell in line], [])
