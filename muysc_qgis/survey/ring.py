"""Places for telescopes on a ring or an arc around a target, on ground that suits them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..topography.dem import Dem
from ..topography.frame import LocalFrame, ground_height, local_frame
from ..topography.relief import dem_cell_m
from ..topography.sampling import heights_at
from .candidates import check_slope

#: Share of the way to the target, from the telescope, on which no ground may be in the way: on
#: the rest it is the mountain itself that hides the target.
_FREE_SHARE = 0.25

#: Height of a telescope above its ground, m: on level ground the line of sight is not the ground.
_EYE_M = 2.0

#: Points at which that part of the way is looked at.
_PROBES = 40

#: Places tried to each side of where a telescope should stand.
_TRIED = 5

#: Why a place does not suit, in the order in which the reasons are looked at.
_OFF, _STEEP, _HIDDEN = (
    "off the DEM or in a gap of it",
    "too steep",
    "without a view of the target",
)


@dataclass(frozen=True)
class Ring:
    """Evenly spaced places around a target.

    Raises
    ------
    MuyscError
        If a number leaves no place.
    """

    radius_m: float
    count: int
    #: Azimuths of the first and the last place, clockwise; a whole turn apart for a full ring.
    from_deg: float = 0.0
    to_deg: float = 360.0
    #: How far a place may be moved to ground that suits better.
    tolerance_m: float = 0.0
    #: Steepest slope, degrees; None for any.
    slope_deg: float | None = None
    #: Whether places need a view of the target.
    sees_target: bool = True

    def __post_init__(self) -> None:
        if not 0 < self.radius_m < np.inf:
            raise MuyscError(
                f"A ring radius of {self.radius_m:g} m holds no place; give one above 0."
            )
        if self.count < 1:
            raise MuyscError(f"{self.count} places make no ring; give 1 or more.")
        if not 0 <= self.tolerance_m < self.radius_m:
            raise MuyscError(
                f"Places on a ring of {self.radius_m:g} m cannot be moved by "
                f"{self.tolerance_m:g} m; give 0 or more, less than the radius."
            )
        check_slope(self.slope_deg)
        if not (np.isfinite(self.from_deg) and np.isfinite(self.to_deg)):
            raise MuyscError("The azimuths of an arc must be finite; give degrees.")
        if self.count > 1 and self.width_deg == 0:
            raise MuyscError(
                f"An arc from {self.from_deg:g}° to {self.to_deg:g}° has no width for "
                f"{self.count} places; give another end."
            )

    @property
    def width_deg(self) -> float:
        """Width of the arc clockwise, above 0 and up to 360; 0 for an arc without any."""
        if self.to_deg == self.from_deg:
            return 0.0
        width = (self.to_deg - self.from_deg) % 360.0
        return width if width else 360.0

    def azimuths(self) -> np.ndarray:
        """Return the (count,) azimuths of the places, degrees from the target."""
        whole = self.width_deg == 360.0
        return np.linspace(
            self.from_deg, self.from_deg + self.width_deg, self.count, endpoint=not whole
        )

    @property
    def spacing_deg(self) -> float:
        """Angle between neighbours."""
        steps = self.count if self.width_deg == 360.0 else max(self.count - 1, 1)
        return self.width_deg / steps


@dataclass(frozen=True)
class RingPlaces:
    """Places that suit. Arrays have shape (n,)."""

    #: Number of each on the ring, from 0.
    number: np.ndarray
    #: Positions in the DEM's CRS.
    x: np.ndarray
    y: np.ndarray
    #: From the target: azimuth (degrees) and horizontal distance (m).
    azimuth_deg: np.ndarray
    distance_m: np.ndarray
    #: Of the ground, degrees.
    slope_deg: np.ndarray
    #: Places of the ring around which nothing suits, by cause.
    missing: Mapping[str, int]

    def __len__(self) -> int:
        return len(self.number)


def ring_places(dem: Dem, target: tuple[float, float], ring: Ring) -> RingPlaces:
    """Return the flattest places near those of a ring, with a view of the target if asked for.

    A place is moved along its radius and its azimuth by no more than the tolerance, and by no
    more than half the way to its neighbour. It sees the target if no ground rises above the
    straight line to it on the nearest quarter of the way. Among equally flat places the one least
    moved is taken.

    Parameters
    ----------
    dem
        Terrain.
    target
        (x, y) in the DEM's CRS, on the ground.
    ring
        What is asked for.

    Raises
    ------
    MuyscError
        If the target is off the DEM, or no place suits.
    """
    aim = ground_height(dem, *target, "target")
    frame = local_frame(dem, *target, "target")
    azimuth, distance, moved = _tried(ring)
    height = heights_at(dem, *frame.ground_positions(azimuth, distance))
    slope = _slope_deg(frame, azimuth, distance)
    known = np.isfinite(height) & np.isfinite(slope)
    flat = known if ring.slope_deg is None else known & (slope <= ring.slope_deg)
    suits = flat
    if ring.sees_target:
        suits = flat & _sees(frame, azimuth, distance, height, aim)
    found = suits.any(axis=1)
    missing = {
        _OFF: int(np.count_nonzero(~known.any(axis=1))),
        _STEEP: int(np.count_nonzero(known.any(axis=1) & ~flat.any(axis=1))),
        _HIDDEN: int(np.count_nonzero(flat.any(axis=1) & ~found)),
    }
    if not found.any():
        reasons = ", ".join(f"{count} are {why}" for why, count in missing.items() if count)
        raise MuyscError(
            f"None of the {ring.count} places at {ring.radius_m:g} m from the target suits a "
            f"telescope: {reasons}; change the radius, or allow steeper ground or a larger "
            "tolerance."
        )
    # Slopes that differ by less than a tenth of a degree are alike.
    rank = np.where(suits, np.round(slope, 1) + 1e-3 * moved / max(ring.tolerance_m, 1.0), np.inf)
    number = np.flatnonzero(found)
    best = number, np.argmin(rank[number], axis=1)
    column, row = frame.ground_positions(azimuth[best], distance[best])
    x, y = dem.crs_position(column, row)
    return RingPlaces(
        number, x, y, azimuth[best] % 360.0, distance[best], slope[best],
        {why: count for why, count in missing.items() if count},
    )  # fmt: skip


def _tried(ring: Ring) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return azimuth, distance and displacement of the places tried, (count, n) each."""
    shift = np.linspace(-1.0, 1.0, 2 * _TRIED + 1) if ring.tolerance_m else np.zeros(1)
    along, across = (one.ravel() * ring.tolerance_m for one in np.meshgrid(shift, shift))
    half_gap = np.radians(ring.spacing_deg) * ring.radius_m / 2 if ring.count > 1 else np.inf
    kept = (np.hypot(along, across) <= ring.tolerance_m) & (np.abs(across) <= half_gap)
    along, across = along[kept], across[kept]
    distance = np.broadcast_to(ring.radius_m + along, (ring.count, len(along)))
    azimuth = ring.azimuths()[:, None] + np.degrees(across / ring.radius_m)
    return azimuth, distance, np.hypot(along, across)


def _slope_deg(frame: LocalFrame, azimuth: np.ndarray, distance: np.ndarray) -> np.ndarray:
    """Return the slope over one cell of the DEM to each side, degrees."""
    step = dem_cell_m(frame)
    turn = np.degrees(step / distance)

    def height(azimuth: np.ndarray, distance: np.ndarray) -> np.ndarray:
        return heights_at(frame.dem, *frame.ground_positions(azimuth, distance))

    outwards = height(azimuth, distance + step) - height(azimuth, np.maximum(distance - step, 0.0))
    around = height(azimuth + turn, distance) - height(azimuth - turn, distance)
    return np.degrees(np.arctan(np.hypot(outwards, around) / (2 * step)))


def _sees(
    frame: LocalFrame, azimuth: np.ndarray, distance: np.ndarray, height: np.ndarray, aim: float
) -> np.ndarray:
    """Return whether the nearer part of the way to the target is free."""
    # From the foot of the telescope, which would be in its own way.
    share = 1 - _FREE_SHARE * (np.arange(_PROBES) + 1) / _PROBES
    way = distance[..., None] * share
    ground = heights_at(frame.dem, *frame.ground_positions(azimuth[..., None], way))
    line = aim + (height + _EYE_M - aim)[..., None] * share
    # The ground bulges above the chord between the two points.
    bulge = way * (distance[..., None] - way) / (2 * frame.radius_m)
    return np.asarray(np.all(ground + bulge <= line, axis=-1))
