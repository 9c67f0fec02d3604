"""Numbers in text files, with the lines that they stand on."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..errors import MuyscError

#: What a line starts with that is no data.
_COMMENT = re.compile(r"^\s*(#|%|!|//)+")

#: Words for a missing value.
_MISSING = ("", "nan", "na", "n/a", "null", "none", "-", "--", "*")

#: Bytes that no text holds, and the most that a table may have.
_BINARY = b"\x00"
_LARGEST_BYTES = 512 * 2**20


@dataclass(frozen=True)
class TextTable:
    """The numbers of a text file.

    Parameters
    ----------
    name
        File name, for messages.
    names
        Names of the columns, empty if the file gives none.
    values
        (n_row, n_column), NaN where missing.
    lines
        (n_row,) number of each row's line in the file, from 1.
    comments
        Comment lines without their sign.
    """

    name: str
    names: tuple[str, ...]
    values: np.ndarray
    lines: np.ndarray
    comments: tuple[str, ...]


def read_text_table(path: str | Path, no_data: float | None = None) -> TextTable:
    """Read rows of numbers separated by tabs, semicolons, commas or blanks.

    Numbers may have a decimal comma where commas do not separate them. Lines that begin
    with ``#``, ``%``, ``!`` or ``//`` are comments; the names of the columns stand in
    the last one before the numbers or in a line of their own.

    Parameters
    ----------
    path
        The file; text in UTF-8, UTF-16 with a byte-order mark, or Latin 1.
    no_data
        Number that stands for a missing value, besides words such as ``nan``.

    Raises
    ------
    MuyscError
        If the file cannot be read, holds no numbers, or a line does not fit.
    """
    path = Path(path)
    rows: list[tuple[int, list[str]]] = []
    comments: list[str] = []
    header: str | None = None
    separator: str | None = None
    for number, line in enumerate(_lines(path), start=1):
        if not line.strip():
            continue
        comment = _COMMENT.match(line)
        if comment:
            comments.append(line[comment.end() :].strip())
            if not rows:
                header = comments[-1]
            continue
        if not rows:
            separator = _separator(line)
            if not _is_row(_fields(line, separator), separator):
                header = line.strip()
                continue
        rows.append((number, _fields(line, separator)))
    if not rows:
        raise MuyscError(f"{path.name} holds no line of numbers; choose a text table or matrix.")
    if all(len(fields) > 1 and not fields[-1] for _, fields in rows):
        # A separator at the end of every line begins no column.
        rows = [(number, fields[:-1]) for number, fields in rows]
    width = len(rows[0][1])
    values = np.empty((len(rows), width))
    for index, (number, fields) in enumerate(rows):
        if len(fields) != width:
            raise MuyscError(
                f"Line {number} of {path.name} has {len(fields)} values where line {rows[0][0]} "
                f"has {width}; give every line the same number, nan where a value is missing."
            )
        values[index] = [_number(text, separator, path.name, number) for text in fields]
    if no_data is not None:
        values[values == no_data] = np.nan
    return TextTable(
        path.name,
        _names(header, separator, width),
        values,
        np.array([number for number, _ in rows]),
        tuple(comments),
    )


def _lines(path: Path) -> list[str]:
    try:
        if path.stat().st_size > _LARGEST_BYTES:
            raise MuyscError(
                f"{path.name} has {path.stat().st_size / 2**20:.0f} MiB, more than any muogram "
                f"(the limit is {_LARGEST_BYTES / 2**20:.0f} MiB); choose a text table or matrix."
            )
        content = path.read_bytes()
    except OSError as error:
        raise MuyscError(
            f"The file {path} cannot be read ({error.strerror}); choose a text file."
        ) from error
    except ValueError as error:
        raise MuyscError(f"“{path}” is no file name ({error}); choose a text file.") from error
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        return content.decode("utf-16", errors="replace").splitlines()
    if _BINARY in content:
        raise MuyscError(f"{path.name} is no text file; choose a text table or matrix.")
    try:
        return content.decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        return content.decode("latin-1").splitlines()


def _separator(line: str) -> str | None:
    """Return what separates the fields of a line, None for blanks."""
    for separator in ("\t", ";"):
        if separator in line.strip():
            return separator
    # “12,5 30,1” has decimal commas, “12,5,30” and “12, 5” have separating ones.
    blanks = line.split()
    if "," in line and not (
        len(blanks) > 1
        and all(text.count(",") <= 1 for text in blanks)
        and not any(text.endswith(",") for text in blanks)
        and not any(text.startswith(",") for text in blanks)
    ):
        return ","
    return None


def _fields(line: str, separator: str | None) -> list[str]:
    if separator is None:
        return line.split()
    return [text.strip().strip('"').strip() for text in line.strip("\r\n ").split(separator)]


def _is_row(fields: Sequence[str], separator: str | None) -> bool:
    """Return whether any field is a number, so that the line is no header."""
    return any(_as_number(text, separator) is not None for text in fields)


def _as_number(text: str, separator: str | None) -> float | None:
    if separator != ",":
        text = text.replace(",", ".")
    try:
        return float(text)
    except ValueError:
        return None


def _number(text: str, separator: str | None, name: str, line: int) -> float:
    if text.lower() in _MISSING:
        return float("nan")
    number = _as_number(text, separator)
    if number is None:
        raise MuyscError(
            f"Line {line} of {name} holds “{text}”, which is not a number; correct it, or write "
            "nan where a value is missing."
        )
    return number


def _names(header: str | None, separator: str | None, width: int) -> tuple[str, ...]:
    """Return the names in a header, empty if they are not as many as the columns."""
    if header is None:
        return ()
    candidates = [_fields(header, separator)]
    candidates += [_fields(header, other) for other in ("\t", ";", ",", None)]
    for fields in candidates:
        if len(fields) == width + 1 and not fields[-1]:
            fields = fields[:-1]
        if len(fields) == width and all(fields):
            return tuple(fields)
    return ()
