"""Bodies in rock that a reconstruction is tried on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..radiography.settings import MAXIMUM_DENSITY_G_CM3
from ..tomography.phantoms import (
    Body,
    checkerboard,
    conduit,
    prism,
    share_inside,
    sphere,
    with_body,
)
from ..tomography.voxels import VoxelGrid
from .volume_frame import VolumeFrame

#: Known models by their name in scripts.
MODELS = ("uniform", "checkerboard", "conduit", "sphere", "polygons")


@dataclass(frozen=True)
class Prism:
    """A polygon on the map with a density between two heights."""

    name: str
    #: (n, 2) corners of each ring in the CRS of the volume.
    rings: tuple[np.ndarray, ...]
    base_m: float
    top_m: float
    density: float


@dataclass(frozen=True)
class KnownModel:
    """Rock of one density with bodies of others in it.

    Raises
    ------
    MuyscError
        If there is no such model or a density is that of no rock.
    """

    #: One of `MODELS`.
    kind: str = "conduit"
    #: Of the rock around, g/cm³.
    density: float = 2.65
    #: Of the body, g/cm³; polygons have their own.
    body_density: float = 2.15
    #: Of conduit and sphere, m.
    radius_m: float = 100.0
    #: Edge of the checkerboard's cubes, m.
    edge_m: float = 200.0
    #: Heights of the conduit's ends, and of the sphere's middle; None for those of the volume.
    base_m: float | None = None
    top_m: float | None = None
    middle_m: float | None = None
    #: Position of conduit and sphere in the CRS of the volume.
    centre: tuple[float, float] = (0.0, 0.0)
    prisms: tuple[Prism, ...] = ()

    def __post_init__(self) -> None:
        if self.kind not in MODELS:
            raise MuyscError(f"“{self.kind}” is not a model; use one of {', '.join(MODELS)}.")
        if self.kind == "polygons" and not self.prisms:
            raise MuyscError(
                "The model polygons needs a layer of polygons with the fields density, base and "
                "top; choose one, or another model."
            )
        check_density(self.density, "The density of the rock")
        check_density(self.body_density, "The density of the body")

    def bodies(self, frame: VolumeFrame, grid: VoxelGrid) -> tuple[PlacedBody, ...]:
        """Return the bodies in the frame's true metres, for a volume in the same.

        Raises
        ------
        MuyscError
            If a length is not above 0 or a polygon's density is that of no matter.
        """
        if self.kind == "uniform":
            return ()
        if self.kind == "polygons":
            return tuple(_placed(one, frame) for one in self.prisms)
        low, high = grid.origin_m[2], grid.end_m[2]
        east, north = (float(one) for one in frame.local(*np.array(self.centre)))
        if self.kind == "checkerboard":
            body = checkerboard(grid.origin_m, self.edge_m)
        elif self.kind == "conduit":
            base = low if self.base_m is None else self.base_m
            top = high if self.top_m is None else self.top_m
            body = conduit((east, north), self.radius_m, base, top)
        else:
            middle = 0.5 * (low + high) if self.middle_m is None else self.middle_m
            body = sphere((east, north, middle), self.radius_m)
        return (PlacedBody(self.kind, body, self.body_density),)


@dataclass(frozen=True)
class PlacedBody:
    """A body in the true metres of a volume's frame."""

    name: str
    inside: Body
    density: float


def check_density(value: float, what: str) -> None:
    """Refuse a density that no matter has.

    Raises
    ------
    MuyscError
        If it is not above 0 and at most that of the densest matter.
    """
    if not 0 < value <= MAXIMUM_DENSITY_G_CM3:
        raise MuyscError(
            f"{what} is {value:g} g/cm³; give one above 0 and up to {MAXIMUM_DENSITY_G_CM3:g}."
        )


def density_in(
    grid: VoxelGrid, bodies: Sequence[PlacedBody], rock_density: float
) -> tuple[np.ndarray, list[np.ndarray]]:
    """Return the density of each voxel of rock, and the share of it that is in each body.

    A later body replaces an earlier one.

    Parameters
    ----------
    grid
        The voxels, in the true metres that the bodies are placed in.
    bodies
        What is in the rock.
    rock_density
        Of the rock around, g/cm³.

    Returns
    -------
    tuple
        (east, north, up) density in g/cm³, and for each body its share of each voxel, 0 to 1.
    """
    density = np.full(grid.shape, float(rock_density))
    shares: list[np.ndarray] = []
    for body in bodies:
        share = share_inside(grid, body.inside)
        density = with_body(density, share, body.density)
        shares.append(share)
    return density, shares


def _placed(one: Prism, frame: VolumeFrame) -> PlacedBody:
    if not one.base_m < one.top_m:
        raise MuyscError(
            f"Polygon {one.name} reaches from {one.base_m:g} m up to {one.top_m:g} m; give it a "
            "top above its base."
        )
    check_density(one.density, f"The density of polygon {one.name}")
    rings = [np.stack(frame.local(ring[:, 0], ring[:, 1]), axis=1) for ring in one.rings]
    return PlacedBody(one.name, prism(rings, one.base_m, one.top_m), one.density)
