"""How directions are written in a text file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError

LAYOUTS = ("auto", "table", "matrix")
VERTICAL_ANGLES = ("auto", "elevation", "zenith")
ANGLE_UNITS = ("auto", "degrees", "radians")
SENSES = ("clockwise", "counterclockwise")


@dataclass(frozen=True)
class TextLayout:
    """How a text file is to be read; empty texts and None stand for “find out”."""

    #: One of `LAYOUTS`: rows of azimuth, vertical angle and value, or a picture of values.
    layout: str = "auto"
    azimuth_column: str = ""
    vertical_column: str = ""
    value_column: str = ""
    error_column: str = ""
    #: One of `VERTICAL_ANGLES`.
    vertical_angle: str = "auto"
    #: One of `ANGLE_UNITS`.
    angle_unit: str = "auto"
    #: One of `SENSES`, in which azimuths grow.
    azimuth_sense: str = "clockwise"
    #: Whether angles count from the boresight.
    relative: bool = False
    #: Of a matrix: angles of the first and last column, and row, in the angle unit.
    azimuth_first: float | None = None
    azimuth_last: float | None = None
    vertical_first: float | None = None
    vertical_last: float | None = None
    #: Values (and errors) are multiplied by this.
    factor: float = 1.0
    #: Number that stands for a missing value.
    no_data: float | None = None

    @property
    def has_ends(self) -> bool:
        """Whether an angle of the first or last column or row is given."""
        ends = (self.azimuth_first, self.azimuth_last, self.vertical_first, self.vertical_last)
        return any(end is not None for end in ends)


def directions_of(
    across_deg: np.ndarray,
    vertical_deg: np.ndarray,
    vertical_angle: str,
    layout: TextLayout,
    metadata: Mapping[str, str | float],
) -> tuple[np.ndarray, np.ndarray]:
    """Return azimuth and elevation in degrees of angles as they are written.

    Parameters
    ----------
    across_deg, vertical_deg
        Angles in degrees, as in the file.
    vertical_angle
        ``elevation`` or ``zenith``.
    layout
        Sense of the azimuth, and whether angles count from the boresight.
    metadata
        Holds the boresight if they do.

    Raises
    ------
    MuyscError
        If the boresight is needed and not known.
    """
    azimuth = across_deg if layout.azimuth_sense == "clockwise" else -across_deg
    if not layout.relative:
        elevation = vertical_deg if vertical_angle == "elevation" else 90.0 - vertical_deg
        return azimuth, elevation
    missing = [key for key in ("BORESIGHT_AZIMUTH", "BORESIGHT_ELEVATION") if key not in metadata]
    if missing:
        raise MuyscError(
            f"The angles count from the boresight, and {' and '.join(missing)} is not known; "
            "give it, or a reference muogram that holds it."
        )
    # From the boresight, a zenith angle is an angle downwards.
    elevation = vertical_deg if vertical_angle == "elevation" else -vertical_deg
    return (
        azimuth + float(metadata["BORESIGHT_AZIMUTH"]),
        elevation + float(metadata["BORESIGHT_ELEVATION"]),
    )
