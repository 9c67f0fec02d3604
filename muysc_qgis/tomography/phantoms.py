"""Known models: the Shepp–Logan head, and bodies in rock."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from .voxels import VoxelGrid

#: Points per voxel edge at which a body's share of the voxel is sampled.
_SAMPLES = 4


@dataclass(frozen=True)
class Ellipse:
    """An ellipse in the square from −1 to 1, whose value is added to what it covers."""

    value: float
    #: Half axes along x and y before turning.
    a: float
    b: float
    x: float
    y: float
    #: Anticlockwise.
    turn_deg: float


#: The head of Shepp & Logan 1974 (doi:10.1109/TNS.1974.6499235), table 1, with the values of
#: Toft 1996 (The Radon Transform, table B.3), whose soft tissue can be told apart.
SHEPP_LOGAN = (
    Ellipse(1.0, 0.69, 0.92, 0.0, 0.0, 0.0),
    Ellipse(-0.8, 0.6624, 0.874, 0.0, -0.0184, 0.0),
    Ellipse(-0.2, 0.11, 0.31, 0.22, 0.0, -18.0),
    Ellipse(-0.2, 0.16, 0.41, -0.22, 0.0, 18.0),
    Ellipse(0.1, 0.21, 0.25, 0.0, 0.35, 0.0),
    Ellipse(0.1, 0.046, 0.046, 0.0, 0.1, 0.0),
    Ellipse(0.1, 0.046, 0.046, 0.0, -0.1, 0.0),
    Ellipse(0.1, 0.046, 0.023, -0.08, -0.605, 0.0),
    Ellipse(0.1, 0.023, 0.023, 0.0, -0.606, 0.0),
    Ellipse(0.1, 0.023, 0.046, 0.06, -0.605, 0.0),
)


def ellipse_image(ellipses: Sequence[Ellipse], size: int) -> np.ndarray:
    """Return ellipses on (size, size) pixels [x, y], each the mean over 4 × 4 points."""
    fine = size * _SAMPLES
    axis = (2 * np.arange(fine) + 1) / fine - 1
    image = np.zeros((fine, fine), np.float32)
    for one in ellipses:
        x, y = axis[:, None] - one.x, axis[None, :] - one.y
        cosine, sine = np.cos(np.radians(one.turn_deg)), np.sin(np.radians(one.turn_deg))
        inside = ((x * cosine + y * sine) / one.a) ** 2 + ((y * cosine - x * sine) / one.b) ** 2
        image += np.float32(one.value) * (inside <= 1)
    blocks = image.reshape(size, _SAMPLES, size, _SAMPLES)
    return blocks.mean(axis=(1, 3), dtype=float)


def ellipse_projections(
    ellipses: Sequence[Ellipse], angle_deg: np.ndarray, offset: np.ndarray
) -> np.ndarray:
    """Return the integrals of ellipses along lines x cos θ + y sin θ = s, in closed form.

    Parameters
    ----------
    ellipses
        What is projected.
    angle_deg
        (n_angles,) θ.
    offset
        (n_offsets,) s.

    Returns
    -------
    numpy.ndarray
        (n_angles, n_offsets): Σ value · 2ab √(w² − (s − s₀)²)/w², w² = a² cos²(θ − φ) +
        b² sin²(θ − φ) (Kak & Slaney 1988, equation 3.5).
    """
    angle = np.radians(np.asarray(angle_deg, float))[:, None]
    total = np.zeros((len(angle), len(offset)))
    for one in ellipses:
        turned = angle - np.radians(one.turn_deg)
        width = (one.a * np.cos(turned)) ** 2 + (one.b * np.sin(turned)) ** 2
        aside = offset - one.x * np.cos(angle) - one.y * np.sin(angle)
        half = np.sqrt(np.maximum(width - aside**2, 0.0))
        total += one.value * 2 * one.a * one.b * half / width
    return total


#: From east, north and up, which broadcast, to whether a point is in a body.
Body = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


def share_inside(grid: VoxelGrid, body: Body) -> np.ndarray:
    """Return the share of each voxel that is in a body, (east, north, up), of 4³ points."""
    total = np.zeros(grid.shape)
    steps = (np.arange(_SAMPLES) + 0.5) / _SAMPLES
    lows = [grid.edges_m(axis)[:-1] for axis in range(3)]
    for index in np.ndindex(_SAMPLES, _SAMPLES, _SAMPLES):
        east, north, up = (
            low + steps[place] * size for low, place, size in zip(lows, index, grid.size_m)
        )
        total += body(east[:, None, None], north[None, :, None], up[None, None, :])
    return total / _SAMPLES**3


def with_body(background: np.ndarray | float, share: np.ndarray, density: float) -> np.ndarray:
    """Return a background with a body of another density in it, by its share of each voxel.

    Parameters
    ----------
    background
        Density around the body, one for all or one for each voxel.
    share
        Share of the body in each voxel, 0 to 1, any shape.
    density
        Of the body, in the background's unit.
    """
    return background * (1 - share) + density * share


def sphere(centre_m: Sequence[float], radius_m: float) -> Body:
    """Return a sphere around (east, north, up), all in m.

    Raises
    ------
    MuyscError
        If the radius is not above 0.
    """
    _positive("radius of the sphere", radius_m)
    x, y, z = centre_m
    return lambda east, north, up: (east - x) ** 2 + (north - y) ** 2 + (up - z) ** 2 <= radius_m**2


def conduit(centre_m: Sequence[float], radius_m: float, base_m: float, top_m: float) -> Body:
    """Return an upright cylinder around (east, north) between two heights, all in m.

    Raises
    ------
    MuyscError
        If the radius or the height is not above 0.
    """
    _positive("radius of the conduit", radius_m)
    _positive("height of the conduit", top_m - base_m)
    x, y = centre_m
    return lambda east, north, up: (
        ((east - x) ** 2 + (north - y) ** 2 <= radius_m**2) & (up >= base_m) & (up <= top_m)
    )


def prism(rings_m: Sequence[np.ndarray], base_m: float, top_m: float) -> Body:
    """Return what stands upright on a polygon between two heights.

    Parameters
    ----------
    rings_m
        (n, 2) east and north of the corners of each ring; within an even number of rings, as in
        a hole, is outside.
    base_m, top_m
        Heights.

    Raises
    ------
    MuyscError
        If the height is not above 0.
    """
    _positive("height of the polygon's body", top_m - base_m)

    def body(east: np.ndarray, north: np.ndarray, up: np.ndarray) -> np.ndarray:
        inside = np.zeros(np.broadcast(east, north).shape, bool)
        for ring in rings_m:
            for (x, y), (next_x, next_y) in zip(ring, np.roll(ring, -1, axis=0)):
                if y != next_y:
                    # Edges that a line to the east crosses: an odd number of them is inside.
                    passes = (y > north) != (next_y > north)
                    inside ^= passes & (east < x + (next_x - x) * (north - y) / (next_y - y))
        return inside & (up >= base_m) & (up <= top_m)

    return body


def checkerboard(origin_m: Sequence[float], edge_m: float) -> Body:
    """Return every other cube of a space filled with them, all in m.

    The one whose lowest corner is `origin_m` (east, north, up) is left out.

    Raises
    ------
    MuyscError
        If the edge is not above 0.
    """
    _positive("edge of the checkerboard", edge_m)
    x, y, z = origin_m

    def body(east: np.ndarray, north: np.ndarray, up: np.ndarray) -> np.ndarray:
        number = (
            np.floor((east - x) / edge_m)
            + np.floor((north - y) / edge_m)
            + np.floor((up - z) / edge_m)
        )
        return number % 2 == 1

    return body


def _positive(what: str, value: float) -> None:
    if not value > 0:
        raise MuyscError(f"The {what} is {value:g} m; give one above 0.")
