"""The field of view of a detector: a regular grid of ray directions."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError

#: Arrays of float64 alive at once per pixel of a simulation, for the estimate
#: in the refusal of absurd pixel counts.
_ARRAYS_PER_PIXEL = 24
#: Narrowest pixel (degrees): 0.2 mm at 10 km, far above the rounding of directions.
_NARROWEST_DEG = 1e-6
#: Largest memory (bytes) that a simulation may plan to take.
MEMORY_LIMIT = 8 * 2**30


@dataclass(frozen=True)
class Aperture:
    """Full widths (degrees) and pixel counts of a field of view.

    Raises
    ------
    MuyscError
        If a width or count cannot be used.
    """

    azimuth_width_deg: float
    elevation_width_deg: float
    azimuth_pixels: int
    elevation_pixels: int

    def __post_init__(self) -> None:
        _check_width("azimuth", self.azimuth_width_deg, 360.0)
        _check_width("elevation", self.elevation_width_deg, 180.0)
        for name, width, count in (
            ("azimuth", self.azimuth_width_deg, self.azimuth_pixels),
            ("elevation", self.elevation_width_deg, self.elevation_pixels),
        ):
            if count < 1:
                raise MuyscError(f"{count} {name} pixels make no muogram; give at least 1.")
            if width < count * _NARROWEST_DEG:
                raise MuyscError(
                    f"Pixels of {width / count:.3g}° in {name} are too narrow to tell apart (the "
                    f"least is {_NARROWEST_DEG:g}°); widen the aperture or use fewer pixels."
                )
        pixels = self.azimuth_pixels * self.elevation_pixels
        memory = pixels * _ARRAYS_PER_PIXEL * 8
        if memory > MEMORY_LIMIT:
            raise MuyscError(
                f"{self.azimuth_pixels} × {self.elevation_pixels} pixels would take about "
                f"{memory / 2**30:,.0f} GiB of memory and the limit is "
                f"{MEMORY_LIMIT / 2**30:.0f} GiB; use no more than "
                f"{math.isqrt(MEMORY_LIMIT // (_ARRAYS_PER_PIXEL * 8)):,} × as many."
            )

    def directions(
        self, boresight_azimuth_deg: float, boresight_elevation_deg: float
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the ray directions at the pixel centres.

        Parameters
        ----------
        boresight_azimuth_deg, boresight_elevation_deg
            Centre of the field of view.

        Returns
        -------
        tuple
            (azimuth_pixels,) azimuths increasing, continuous across north, and
            (elevation_pixels,) elevations decreasing, as the rows of a muogram.

        Raises
        ------
        MuyscError
            If the field of view reaches past the zenith or the nadir.
        """
        half = self.elevation_width_deg / 2
        if not -90 <= boresight_elevation_deg - half <= boresight_elevation_deg + half <= 90:
            largest = 2 * (90 - abs(boresight_elevation_deg))
            raise MuyscError(
                f"The field of view spans elevations {boresight_elevation_deg - half:.1f}° to "
                f"{boresight_elevation_deg + half:.1f}°, past ±90°; use an elevation aperture "
                f"of at most {largest:.1f}°."
            )
        azimuth = boresight_azimuth_deg + _centred(self.azimuth_pixels, self.azimuth_width_deg)
        elevation = boresight_elevation_deg - _centred(
            self.elevation_pixels, self.elevation_width_deg
        )
        return azimuth, elevation


def _centred(count: int, width: float) -> np.ndarray:
    """Return the centres of equal pixels across a width around 0, increasing."""
    return ((np.arange(count) + 0.5) / count - 0.5) * width


def _check_width(name: str, width: float, largest: float) -> None:
    if not 0 < width <= largest:
        raise MuyscError(
            f"An {name} aperture of {width:g}° is impossible; give a full width above 0° and "
            f"up to {largest:g}°."
        )
