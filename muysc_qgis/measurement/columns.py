"""Which column of a table is what, by its name or by what the user says."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from ..errors import MuyscError
from .text import TextTable

#: What the names of columns begin with, in the languages of the field.
_AZIMUTH = ("azimuth", "azimut", "azimu", "acimut", "azi", "az", "phi", "φ", "bearing")
_ELEVATION = ("elevation", "elevacion", "elevación", "elev", "ele", "el", "alt_angle", "beta")
_ZENITH = ("zenith", "zenit", "cenith", "cenit", "zen", "theta", "θ")
_ERROR = ("error", "err", "sigma", "σ", "uncertainty", "unc", "std", "stddev", "±")

#: Other names of quantities in tables of measurements.
_VALUES = {
    "thickness": ("thickness", "length", "path", "distance", "dist", "l"),
    "opacity": ("opacity", "rho_l", "densitylength"),
    "flux": ("flux", "intensity", "i"),
    "open_sky": ("open_sky", "opensky", "open sky", "flux", "intensity"),
    "transmission": ("transmission", "transmittance", "ratio", "t"),
    "counts": ("counts", "count", "muons", "events", "tracks", "n", "hits"),
    "density": ("density", "rho", "ρ"),
    "distance": ("distance", "dist", "range"),
    "exposure": ("exposure", "days", "time"),
    "minimum_energy": ("minimum_energy", "energy", "emin", "e"),
}


@dataclass(frozen=True)
class Columns:
    """Indices of the columns, and how the directions are meant."""

    azimuth: int
    vertical: int
    value: int
    error: int | None
    #: ``elevation`` or ``zenith``.
    vertical_angle: str
    #: ``degrees`` or ``radians``, as the names say; None if they do not.
    angle_unit: str | None


def choose_columns(
    table: TextTable,
    quantity: str,
    azimuth: str = "",
    vertical: str = "",
    value: str = "",
    error: str = "",
    vertical_angle: str = "auto",
) -> Columns:
    """Find the columns of azimuth, zenith or elevation, value and error.

    Parameters
    ----------
    table
        The table.
    quantity
        What the values are, whose name the value column may have.
    azimuth, vertical, value, error
        Name or number (from 1) of a column; empty to find it by its name, or by its
        place where the table names none: azimuth, vertical angle, value, error.
    vertical_angle
        ``elevation``, ``zenith``, or ``auto`` for what the column's name says.

    Raises
    ------
    MuyscError
        If a column cannot be found or told from others.
    """
    width = table.values.shape[1]
    if not table.names:
        return _by_place(table, width, (azimuth, vertical, value, error), vertical_angle)
    chosen: dict[str, int | None] = {
        role: _named(table, text, role)
        for role, text in (
            ("azimuth", azimuth), ("vertical", vertical), ("value", value), ("error", error),
        )
        if text
    }  # fmt: skip
    free = [n for n in range(width) if n not in chosen.values()]
    for role, names in (
        ("azimuth", _AZIMUTH),
        ("vertical", (*_ELEVATION, *_ZENITH)),
        ("error", _ERROR),
        ("value", _VALUES.get(quantity, (quantity,))),
    ):  # fmt: skip
        if role not in chosen:
            found = [n for n in free if _begins(table.names[n], names)]
            if role == "vertical" and len(found) > 1 and vertical_angle != "auto":
                # A table with both angles; the user has said which one counts.
                only = _ELEVATION if vertical_angle == "elevation" else _ZENITH
                found = [n for n in found if _begins(table.names[n], only)]
            if role == "error":
                found = found or [n for n in free if _is_error_of(table.names[n], quantity)]
            if role == "value" and not found and len(free) == 1:
                found = free
            if len(found) > 1 or (not found and role != "error"):
                raise MuyscError(_unclear(table, role, [table.names[n] for n in found]))
            chosen[role] = found[0] if found else None
            free = [n for n in free if n not in found]
    name = table.names[chosen["vertical"] or 0]
    if vertical_angle == "auto":
        vertical_angle = _vertical_angle(table, name)
    units = {_unit(table.names[chosen[role] or 0]) for role in ("azimuth", "vertical")} - {None}
    if len(units) > 1:
        raise MuyscError(
            f"The angles of {table.name} are in degrees and in radians by the names of their "
            f"columns ({', '.join(table.names)}); give both in one unit."
        )
    return Columns(
        chosen["azimuth"] or 0,
        chosen["vertical"] or 0,
        chosen["value"] or 0,
        chosen["error"],
        vertical_angle,
        units.pop() if units else None,
    )


def _by_place(table: TextTable, width: int, texts: Sequence[str], vertical_angle: str) -> Columns:
    """Return columns of a table without names."""
    if width < 3:
        raise MuyscError(
            f"{table.name} has {width} columns, and a table needs azimuth, zenith or elevation, "
            "and value; choose the layout matrix if it is a picture of values."
        )
    places: list[int | None] = [_numbered(table, text) for text in texts]
    for role in range(4):
        if places[role] is None:
            free = [n for n in range(width) if n not in places]
            if role == 3 and not (width == 4 and not any(texts)):
                # A further column might be anything; only a plain fourth one is the error.
                break
            places[role] = free[0]
    if vertical_angle == "auto":
        raise MuyscError(
            f"{table.name} does not name its columns, so elevation and zenith angles look alike; "
            "set the vertical angle to one of the two."
        )
    azimuth, vertical, value = (place or 0 for place in places[:3])
    return Columns(azimuth, vertical, value, places[3], vertical_angle, None)


def _numbered(table: TextTable, text: str) -> int | None:
    """Return the index for a column's number, None for an empty text."""
    if not text.strip():
        return None
    width = table.values.shape[1]
    if text.strip().isdigit() and 1 <= int(text) <= width:
        return int(text) - 1
    raise MuyscError(
        f"There is no column “{text}” in {table.name}; give a number from 1 to {width}"
        + (f", or one of {', '.join(table.names)}." if table.names else ".")
    )


def _named(table: TextTable, text: str, role: str) -> int | None:
    """Return the index of a column given by name or number."""
    wanted = text.strip().lower()
    for same in (lambda name: name.lower() == wanted, lambda name: _word(name) == wanted):
        found = [n for n, name in enumerate(table.names) if same(name)]
        if len(found) == 1:
            return found[0]
        if found:
            raise MuyscError(
                f"{len(found)} columns of {table.name} are called “{text}”; give the number of "
                f"the {role} column."
            )
    return _numbered(table, text)


def _word(name: str) -> str:
    """Return a column's name without its unit: “Azimuth (deg)” is azimuth."""
    return re.split(r"[\[(/]", name.lower())[0].strip(" _-:")


def _begins(name: str, words: Sequence[str]) -> bool:
    """Return whether a name is one of some words, or one of them and more after a break."""
    word = _word(name)
    # The longest first, so that “elevation” is not “el” and a rest.
    return any(re.match(rf"{re.escape(one)}(?![a-zα-ω])", word) for one in words)


def _is_error_of(name: str, quantity: str) -> bool:
    """Return whether a name says error and value in one: flux_error, dflux, sigma_N."""
    word = _word(name)
    values = _VALUES.get(quantity, (quantity,))
    return any(re.search(rf"[ _-]{one}s?$", word) for one in _ERROR) or any(
        word in (f"d{one}", f"d_{one}", f"delta_{one}") for one in values
    )


def _vertical_angle(table: TextTable, name: str) -> str:
    if _begins(name, _ELEVATION):
        return "elevation"
    if _begins(name, _ZENITH):
        return "zenith"
    raise MuyscError(
        f"The column “{name}” of {table.name} does not say whether it is an elevation or a "
        "zenith angle; set the vertical angle to one of the two."
    )


def _unit(name: str) -> str | None:
    rest = re.sub(r"^[a-zα-ω]+", "", name.lower())
    if re.search(r"(?<![a-z])(rad|radian|radians)(?![a-z])", rest):
        return "radians"
    if re.search(r"(?<![a-z])(deg|degree|degrees|grados?)(?![a-z])|°", rest):
        return "degrees"
    return None


def _unclear(table: TextTable, role: str, found: Sequence[str]) -> str:
    what = "vertical angle (elevation or zenith)" if role == "vertical" else role
    if found:
        return (
            f"{len(found)} columns of {table.name} could be the {what}: {', '.join(found)}; give "
            "the name or number of one."
        )
    return (
        f"No column of {table.name} is the {what} by its name (they are "
        f"{', '.join(table.names)}); give the name or number of one."
    )
