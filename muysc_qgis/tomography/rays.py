"""Straight muon paths, whatever instrument they belong to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError


@dataclass(frozen=True)
class Rays:
    """Half lines from detectors into the rock.

    Muons fly straight. In a frame whose heights are above sea level the Earth falls away below a
    ray by d²/2R, 0.08 m at 1 km and 2 m at 5 km: a caller to whom that matters raises the
    direction of each ray so that it meets the volume where it should.

    Raises
    ------
    MuyscError
        If the shapes do not fit, an origin is not finite or a direction is no unit vector.
    """

    #: (n, 3) east, north and up of the start, m.
    origin_m: np.ndarray
    #: (n, 3) unit vectors away from the detector.
    direction: np.ndarray
    #: (n,) number of the detector or projection that each ray belongs to.
    view: np.ndarray

    def __post_init__(self) -> None:
        shapes = self.origin_m.shape, self.direction.shape, self.view.shape
        if shapes != ((len(self.view), 3), (len(self.view), 3), (len(self.view),)):
            raise MuyscError(
                f"The rays have origins, directions and views of shapes {shapes}; give (n, 3), "
                "(n, 3) and (n,)."
            )
        length = np.linalg.norm(self.direction, axis=1)
        if not np.all(np.isfinite(self.origin_m)) or not np.all(np.abs(length - 1) < 1e-6):
            raise MuyscError(
                "A ray has an origin that is not finite or a direction that is no unit vector; "
                "give finite positions and directions of length 1."
            )

    def __len__(self) -> int:
        return len(self.view)

    def take(self, which: np.ndarray | slice) -> Rays:
        """Return some of the rays."""
        return Rays(self.origin_m[which], self.direction[which], self.view[which])


def unit_vectors(azimuth_deg: np.ndarray, elevation_deg: np.ndarray) -> np.ndarray:
    """Return (…, 3) east, north and up of directions.

    Parameters
    ----------
    azimuth_deg
        Clockwise from the frame's north.
    elevation_deg
        Above the horizontal; broadcasts with the azimuth.
    """
    azimuth, elevation = np.broadcast_arrays(np.radians(azimuth_deg), np.radians(elevation_deg))
    level = np.cos(elevation)
    return np.stack([level * np.sin(azimuth), level * np.cos(azimuth), np.sin(elevation)], axis=-1)


def rays_from_station(
    station_m: Sequence[float], azimuth_deg: np.ndarray, elevation_deg: np.ndarray, view: int = 0
) -> Rays:
    """Return the rays of one detector, in the order of a muogram's values.

    Parameters
    ----------
    station_m
        East, north and up of the detector.
    azimuth_deg, elevation_deg
        (n_azimuth,) and (n_elevation,) axes of the muogram.
    view
        Number of the detector.

    Returns
    -------
    Rays
        n_elevation · n_azimuth rays, the azimuth running fastest.
    """
    direction = unit_vectors(
        np.asarray(azimuth_deg)[None, :], np.asarray(elevation_deg)[:, None]
    ).reshape(-1, 3)
    origin = np.broadcast_to(np.asarray(station_m, float), direction.shape)
    return Rays(origin.copy(), direction, np.full(len(direction), view))


def joined(several: Sequence[Rays]) -> Rays:
    """Return the rays of several detectors as one, in their order."""
    return Rays(
        np.concatenate([rays.origin_m for rays in several]),
        np.concatenate([rays.direction for rays in several]),
        np.concatenate([rays.view for rays in several]),
    )
