"""One quantity over the trajectories of a telescope, and its GeoTIFF form."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from .errors import MuyscError
from .muogram import Grid, Muogram, read_grid, read_muogram, write_grid
from .quantities import QUANTITIES, Quantity
from .telescope.directions import Pointing

#: Value of PROJECTION in rasters whose axes are tangents.
TANGENT = "tangent"


@dataclass(frozen=True)
class TrajectoryMap:
    """Values of one quantity on the evenly spaced tangents of a telescope.

    The trajectory with the tangents x and y runs along b + x r + y u, with the boresight
    b, the telescope's right r and up u (see `Pointing`). Tangents are what a telescope
    measures, offset over separation, so pixels are of one size there; azimuth and
    elevation follow from them, and from boresight and roll in the metadata.

    Parameters
    ----------
    quantity
        Key of `QUANTITIES`.
    values
        (n_y, n_x), in the quantity's unit; NaN where unknown.
    x, y
        (n_x,) tangents to the right, increasing, and (n_y,) upwards, decreasing.
    metadata
        As in a muogram. With ``BORESIGHT_AZIMUTH``, ``BORESIGHT_ELEVATION`` and ``ROLL``
        the telescope has a direction.

    Raises
    ------
    MuyscError
        If the quantity is unknown or the shapes do not fit.
    """

    quantity: str
    values: np.ndarray
    x: np.ndarray
    y: np.ndarray
    metadata: Mapping[str, str | float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.quantity not in QUANTITIES:
            raise MuyscError(
                f"“{self.quantity}” is not a quantity of a telescope's raster; use one of "
                f"{', '.join(QUANTITIES)}."
            )
        if self.values.shape != (len(self.y), len(self.x)):
            raise MuyscError(
                f"The raster has {self.values.shape} values for {(len(self.y), len(self.x))} "
                "trajectories (up, right); give one value for each."
            )

    @property
    def kind(self) -> Quantity:
        """Title, unit and colours of the quantity."""
        return QUANTITIES[self.quantity]

    @property
    def pointing(self) -> Pointing:
        """Where the telescope points.

        Raises
        ------
        MuyscError
            If the metadata do not say it.
        """
        try:
            return Pointing(
                *(
                    float(self.metadata[key])
                    for key in ("BORESIGHT_AZIMUTH", "BORESIGHT_ELEVATION", "ROLL")
                )
            )
        except (KeyError, ValueError):
            raise MuyscError(
                f"The {self.quantity} raster has no direction in the sky: its metadata lack a "
                "boresight; make it with Expected counts in a telescope."
            ) from None

    def directions_deg(self) -> tuple[np.ndarray, np.ndarray]:
        """Return azimuth and elevation of every pixel, (n_y, n_x) each, in degrees.

        Raises
        ------
        MuyscError
            If the metadata do not say where the telescope points.
        """
        return self.pointing.sky(*np.meshgrid(self.x, self.y))

    def pixel_of(self, azimuth_deg: np.ndarray, elevation_deg: np.ndarray) -> np.ndarray:
        """Return the flat index of the pixel in each direction, −1 outside.

        Raises
        ------
        MuyscError
            If the metadata do not say where the telescope points.
        """
        x, y = self.pointing.plane(azimuth_deg, elevation_deg)
        step_x, step_y = self.pixel_size
        with np.errstate(invalid="ignore"):
            column = np.floor((x - self.x[0]) / step_x + 0.5)
            row = np.floor((self.y[0] - y) / step_y + 0.5)
            inside = (column >= 0) & (column < len(self.x)) & (row >= 0) & (row < len(self.y))
            return np.where(inside, row * len(self.x) + column, -1).astype(np.int64)

    @property
    def pixel_size(self) -> tuple[float, float]:
        """Width and height of a pixel in the tangent."""
        lonely = float(self.metadata.get("TANGENT_STEP", 1.0))
        return (
            float(self.x[-1] - self.x[0]) / (len(self.x) - 1) if len(self.x) > 1 else lonely,
            float(self.y[0] - self.y[-1]) / (len(self.y) - 1) if len(self.y) > 1 else lonely,
        )


def write_trajectories(trajectories: TrajectoryMap, path: str | Path) -> None:
    """Write a raster in telescope angles: a self-describing single-band GeoTIFF.

    x is the tangent to the right and y the tangent upwards, without a unit, pixel
    centres on the trajectories, top row highest; PROJECTION is ``tangent``.

    Raises
    ------
    MuyscError
        If the file cannot be written.
    """
    metadata = {
        "PROJECTION": TANGENT,
        "AXIS_X": "tangent of the angle from the boresight to the telescope's right",
        "AXIS_Y": "tangent of the angle from the boresight to the telescope's up",
        **trajectories.metadata,
    }
    write_grid(
        Grid(trajectories.quantity, trajectories.values, trajectories.x, trajectories.y, metadata),
        path,
        ("right", "up"),
        max(trajectories.pixel_size),
    )


def read_trajectories(path: str | Path) -> TrajectoryMap:
    """Read a raster in telescope angles.

    Raises
    ------
    MuyscError
        If the file is none.
    """
    grid = read_grid(path)
    if grid.metadata.get("PROJECTION") != TANGENT:
        raise MuyscError(
            f"{path} is no raster in telescope angles (PROJECTION {TANGENT}); choose one made by "
            "Expected counts in a telescope."
        )
    return TrajectoryMap(grid.quantity, grid.values, grid.x, grid.y, grid.metadata)


def read_view(path: str | Path) -> Muogram | TrajectoryMap:
    """Read a muogram or a raster in telescope angles, whichever the file says it is.

    Raises
    ------
    MuyscError
        If the file is neither.
    """
    if read_grid(path).metadata.get("PROJECTION") == TANGENT:
        return read_trajectories(path)
    return read_muogram(path)
