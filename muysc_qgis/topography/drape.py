"""A muogram put back on the terrain."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..muogram import View
from ..progress import Progress, part, report, silent
from .dem import Dem
from .frame import LocalFrame, from_wgs84, local_frame
from .relief import dem_cell_m
from .tracing import trace_terrain

#: Which surface of the rock a muogram is draped on.
SIDES = ("near", "far")

#: DEM rows looked at in one go.
_ROWS = 256
#: Cells whose rays are traced in one go.
_CELLS = 20_000
#: How far (in cells) a ray may meet the ground from the cell that it aims at.
_CLOSE_CELLS = 0.05


@dataclass(frozen=True)
class DrapedBlock:
    """Values for a run of whole DEM rows."""

    first_row: int
    #: (n_rows, n_columns of the DEM), NaN where the detector sees nothing.
    values: np.ndarray


def drape(
    muogram: View, dem: Dem, side: str = "near", progress: Progress = silent
) -> Iterator[DrapedBlock]:
    """Give each DEM cell that a detector sees the muogram's value in that direction.

    A cell is seen on the near side when the ray from the detector to the terrain
    at the cell's centre meets no ground before it, and on the far side when it
    meets none after it and leaves the rock there.

    Parameters
    ----------
    muogram
        Any quantity; says where its detector stands.
    dem
        Terrain, the one of the muogram or a better one of the same place.
    side
        One of `SIDES`.
    progress
        Told the share of rows done.

    Yields
    ------
    DrapedBlock
        Blocks of rows that hold a value, from the top. O(cells in the field of
        view × length of a profile) in time.

    Raises
    ------
    MuyscError
        If the detector is off the DEM or the muogram does not say where it is.
    Cancelled
        If `progress` asks for a stop.
    """
    if side not in SIDES:
        raise MuyscError(f"There is no “{side}” side of the rock; use {' or '.join(SIDES)}.")
    frame, eye = check_detector(muogram, dem)
    near_field = float(muogram.metadata.get("NEAR_FIELD", 0.0))
    for first in range(0, dem.rows, _ROWS):
        share = part(progress, first / dem.rows, min(first + _ROWS, dem.rows) / dem.rows)
        report(share, 0.0)
        values = _drape_rows(muogram, frame, eye, near_field, side, first, share)
        if np.isfinite(values).any():
            yield DrapedBlock(first, values)


def check_detector(muogram: View, dem: Dem) -> tuple[LocalFrame, float]:
    """Return the frame of a muogram's detector on a DEM, and the detector's height (m).

    Raises
    ------
    MuyscError
        If the detector is off the DEM or the muogram does not say where it is.
    """
    position = from_wgs84(
        dem.crs, muogram.number("DETECTOR_LON"), muogram.number("DETECTOR_LAT"), dem.transformation
    )
    return local_frame(dem, *position, "detector"), muogram.number("DETECTOR_ELEVATION")


def _drape_rows(
    muogram: View,
    frame: LocalFrame,
    eye: float,
    near_field: float,
    side: str,
    first: int,
    progress: Progress,
) -> np.ndarray:
    dem = frame.dem
    rows = min(_ROWS, dem.rows - first)
    heights = dem.read(0, first, dem.columns, rows)
    row, column = np.mgrid[first : first + rows, 0 : dem.columns]
    azimuth, distance = frame.polar(column, row)
    with np.errstate(divide="ignore", invalid="ignore"):
        tangent = (heights - eye - frame.drop(distance)) / distance
    elevation = np.degrees(np.arctan(tangent))
    pixel = muogram.pixel_of(azimuth, elevation)
    candidates = np.flatnonzero((pixel >= 0) & (distance > near_field) & np.isfinite(tangent))
    values = np.full(heights.size, np.nan)
    # By azimuth, so that rays traced together need a narrow window of the DEM.
    candidates = candidates[np.argsort(azimuth.ravel()[candidates])]
    tolerance = _CLOSE_CELLS * dem_cell_m(frame)
    for start in range(0, len(candidates), _CELLS):
        report(progress, start / len(candidates))
        cells = candidates[start : start + _CELLS]
        range_m = distance.ravel()[cells]
        rock = trace_terrain(
            frame,
            eye,
            azimuth.ravel()[cells],
            elevation.ravel()[cells, None],
            float(range_m.max()) + tolerance if side == "near" else None,
            near_field,
        )
        level = np.cos(np.radians(elevation.ravel()[cells]))
        if side == "near":
            # Without any rock on its way the ray grazes the cell: a crest.
            meets = rock.distance_m[:, 0] * level
            seen = ~(meets < range_m - tolerance)
        else:
            seen = np.abs(rock.exit_m[:, 0] * level - range_m) <= tolerance
        values[cells[seen]] = muogram.values.ravel()[pixel.ravel()[cells[seen]]]
    return values.reshape(heights.shape)
