"""One quantity over the trajectories of a telescope, and its GeoTIFF form."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from .errors import MuyscError
from .muogram import Grid, View, read_grid, read_muogram, write_grid
from .quantities import QUANTITIES
from .tables import write_table
from .telescope.acceptance import Trajectories
from .telescope.directions import Pointing
from .telescope.geometry import TelescopeGeometry

#: Value of PROJECTION in rasters whose axes are tangents.
TANGENT = "tangent"

#: What such a raster says about its axes.
_AXES = {
    "PROJECTION": TANGENT,
    "AXIS_X": "tangent of the angle from the boresight to the telescope's right",
    "AXIS_Y": "tangent of the angle from the boresight to the telescope's up",
}


@dataclass(frozen=True)
class TrajectoryMap(View):
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
        return self._nearest((x - self.x[0]) / step_x, (self.y[0] - y) / step_y)

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
    metadata = {**_AXES, **trajectories.metadata}
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
    metadata = {key: value for key, value in grid.metadata.items() if key not in _AXES}
    return TrajectoryMap(grid.quantity, grid.values, grid.x, grid.y, metadata)


def read_view(path: str | Path) -> View:
    """Read a muogram or a raster in telescope angles, whichever the file says it is.

    Raises
    ------
    MuyscError
        If the file is neither.
    """
    if read_grid(path).metadata.get("PROJECTION") == TANGENT:
        return read_trajectories(path)
    return read_muogram(path)


def describe_telescope(geometry: TelescopeGeometry, formula: str) -> dict[str, str | float]:
    """Return what later steps need to know about the telescope."""
    return {
        "BARS_X": float(geometry.bars_x),
        "BARS_Y": float(geometry.bars_y),
        "PIXEL_SIZE": geometry.pixel_size_cm,
        "SEPARATION": geometry.separation_cm,
        "PLANES": float(geometry.planes),
        "TANGENT_STEP": geometry.step,
        "FORMULA": formula,
    }


def maps_of(collected: Trajectories, name: str) -> dict[str, TrajectoryMap]:
    """Return what a telescope collects as rasters by quantity.

    Parameters
    ----------
    collected
        From `trajectories`.
    name
        Name of the telescope, for the metadata.
    """
    geometry = collected.geometry
    metadata = {"TELESCOPE": name, **describe_telescope(geometry, collected.formula)}
    x, y = geometry.step * geometry.offset_x, geometry.step * geometry.offset_y
    values = {
        "acceptance": collected.acceptance_cm2_sr,
        "solid_angle": collected.solid_angle_sr,
        "detection_area": collected.detection_area_cm2,
        "path_length": collected.path_length_cm,
        "angular_resolution": collected.angular_resolution_mrad,
    }
    return {key: TrajectoryMap(key, array, x, y, metadata) for key, array in values.items()}


def write_trajectory_table(maps: Mapping[str, TrajectoryMap], path: str | Path) -> None:
    """Write rasters on the same trajectories as a CSV table, units in the header.

    A row for each trajectory: its pixel offsets, its tangents, its direction where the
    telescope has one, and every quantity; unknown values are left empty.

    Raises
    ------
    MuyscError
        If the file cannot be written.
    """
    first = next(iter(maps.values()))
    step = float(first.metadata["TANGENT_STEP"])
    x, y = np.meshgrid(first.x, first.y)
    columns = {
        "offset to the right (pixels)": np.rint(x / step).astype(int),
        "offset upwards (pixels)": np.rint(y / step).astype(int),
        "tangent to the right": x,
        "tangent upwards": y,
    }
    if "BORESIGHT_AZIMUTH" in first.metadata:
        azimuth, elevation = first.directions_deg()
        columns |= {"azimuth (°)": azimuth % 360.0, "elevation (°)": elevation}
    columns |= {one.kind.label: one.values for one in maps.values()}
    write_table(path, list(columns), zip(*(values.ravel().tolist() for values in columns.values())))
