"""Where a muogram's pixels stand in a panel, and what its metadata says.

Needs numpy alone.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..muogram import Described, Muogram
from ..radiography.spectra import MODELS

#: How the values of FLUX_MODEL and ENERGY_LOSS are written in text.
_NAMES = {
    **{name: model.title for name, model in MODELS.items()},
    "csda": "tabulated CSDA",
    "lesparre": "Lesparre",
    "paper": "MUYSC paper",
}

#: Directions this evenly spaced (as a share of the step) count as a regular grid.
_EVEN = 1e-3

#: Pixels across the picture of unevenly spaced directions.
_RESAMPLED = 600


@dataclass(frozen=True)
class Directions:
    """The pixel grid of a muogram in panel coordinates.

    Parameters
    ----------
    azimuth_deg
        (n_azimuth,) increasing, from `origin_deg`.
    zenith_deg
        (n_elevation,) increasing.
    azimuth_edges_deg, zenith_edges_deg
        (n + 1,) pixel edges.
    origin_deg
        Azimuth of panel coordinate 0: the boresight's, or north if the
        metadata names none.
    target_deg
        Panel azimuth and zenith of the target; None if not known.
    """

    azimuth_deg: np.ndarray
    zenith_deg: np.ndarray
    azimuth_edges_deg: np.ndarray
    zenith_edges_deg: np.ndarray
    origin_deg: float
    target_deg: tuple[float, float] | None

    @property
    def width_deg(self) -> float:
        """Angle from the left to the right edge of the picture."""
        return float(self.azimuth_edges_deg[-1] - self.azimuth_edges_deg[0])

    @property
    def height_deg(self) -> float:
        """Angle from the top to the bottom edge of the picture."""
        return float(self.zenith_edges_deg[-1] - self.zenith_edges_deg[0])

    @property
    def extent_deg(self) -> tuple[float, float, float, float]:
        """Left, right, bottom and top edge of the picture."""
        azimuth, zenith = self.azimuth_edges_deg, self.zenith_edges_deg
        return float(azimuth[0]), float(azimuth[-1]), float(zenith[-1]), float(zenith[0])

    @property
    def frame_deg(self) -> np.ndarray:
        """Points along the four edges of the picture, (n, 2)."""
        left, right, bottom, top = self.extent_deg
        share = np.linspace(0.0, 1.0, 50)
        across, down = left + share * (right - left), top + share * (bottom - top)
        return np.concatenate(
            [
                *(np.column_stack([np.full_like(down, x), down]) for x in (left, right)),
                *(np.column_stack([across, np.full_like(across, y)]) for y in (top, bottom)),
            ]
        )


def metadata_number(muogram: Described, key: str) -> float | None:
    """Return a metadata entry as a finite number, None if it is not one."""
    try:
        value = muogram.number(key)
    except MuyscError:
        return None
    return value if np.isfinite(value) else None


def pixel_edges(centres: np.ndarray) -> np.ndarray:
    """Return the (n + 1,) edges of pixels: midway between the (n,) centres.

    A single pixel is one degree wide, as in a muogram raster.
    """
    centres = np.asarray(centres, dtype=float)
    if len(centres) == 1:
        return np.array([centres[0] - 0.5, centres[0] + 0.5])
    middle = (centres[1:] + centres[:-1]) / 2
    return np.concatenate([[2 * centres[0] - middle[0]], middle, [2 * centres[-1] - middle[-1]]])


def directions_of(muogram: Muogram) -> Directions:
    """Return the pixel grid of a muogram in panel coordinates."""
    azimuth = np.asarray(muogram.azimuth_deg, dtype=float)
    zenith = 90.0 - np.asarray(muogram.elevation_deg, dtype=float)
    boresight = metadata_number(muogram, "BORESIGHT_AZIMUTH")
    elevation = metadata_number(muogram, "BORESIGHT_ELEVATION")
    origin, target = 0.0, None
    if boresight is not None:
        # 350° and −10° are one direction: take the turn that the picture is in.
        middle = (azimuth[0] + azimuth[-1]) / 2
        origin = boresight + 360.0 * round((middle - boresight) / 360.0)
        target = None if elevation is None else (0.0, 90.0 - elevation)
    relative = azimuth - origin
    return Directions(relative, zenith, pixel_edges(relative), pixel_edges(zenith), origin, target)


def even_picture(picture: np.ndarray, directions: Directions) -> np.ndarray:
    """Return a picture with pixels of one size, as an image needs them.

    Unevenly spaced directions (a telescope's tangents) are looked up by the
    pixel that holds each new centre, so that no value is made up.
    """
    for axis, edges in ((0, directions.zenith_edges_deg), (1, directions.azimuth_edges_deg)):
        steps = np.diff(edges)
        if np.ptp(steps) > _EVEN * steps.mean():
            count = max(_RESAMPLED, 2 * len(steps))
            centres = edges[0] + (np.arange(count) + 0.5) / count * (edges[-1] - edges[0])
            picture = picture.take(np.searchsorted(edges, centres) - 1, axis=axis)
    return picture


def describe(muogram: Described) -> list[str]:
    """Return what the metadata says, a line on the place and one on the physics."""
    place = [_detector(muogram), _target(muogram)]
    physics = [
        _named(muogram, "FLUX_MODEL", "flux model") + _flux_error(muogram),
        _named(muogram, "ENERGY_LOSS", "energy loss"),
    ]
    density = metadata_number(muogram, "DENSITY")
    if density is not None:
        material = str(muogram.metadata.get("MATERIAL", "rock")).replace("_", " ")
        physics.append(f"{material} of {density:.4g} g/cm³")
    lines = ["  ·  ".join(part for part in parts if part) for parts in (place, physics)]
    return [line[0].upper() + line[1:] for line in lines if line]


def _detector(muogram: Described) -> str:
    longitude = metadata_number(muogram, "DETECTOR_LON")
    latitude = metadata_number(muogram, "DETECTOR_LAT")
    elevation = metadata_number(muogram, "DETECTOR_ELEVATION")
    parts = []
    if longitude is not None and latitude is not None:
        parts.append(
            f"{abs(latitude):.5f}° {'S' if latitude < 0 else 'N'} "
            f"{abs(longitude):.5f}° {'W' if longitude < 0 else 'E'}"
        )
    if elevation is not None:
        parts.append(f"elevation {elevation:.0f} m".replace("-", "−"))
    return f"detector {', '.join(parts)}" if parts else ""


def _target(muogram: Described) -> str:
    distance = metadata_number(muogram, "TARGET_DISTANCE")
    azimuth = metadata_number(muogram, "BORESIGHT_AZIMUTH")
    elevation = metadata_number(muogram, "BORESIGHT_ELEVATION")
    parts = []
    if distance is not None:
        parts.append(
            f"{distance:.0f} m away" if distance < 1e4 else f"{distance / 1e3:.1f} km away"
        )
    if azimuth is not None:
        parts.append(f"azimuth {azimuth % 360:.1f}°")
    if elevation is not None:
        parts.append(f"{elevation:.1f}° above the horizon".replace("-", "−"))
    return f"target {', '.join(parts)}" if parts else ""


def _flux_error(muogram: Described) -> str:
    error = metadata_number(muogram, "FLUX_ERROR")
    return "" if error is None else f" (±{error:.0f} %)"


def _named(muogram: Described, key: str, what: str) -> str:
    value = str(muogram.metadata.get(key, "")).strip()
    return f"{_NAMES.get(value, value)} {what}" if value else ""
