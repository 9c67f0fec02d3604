"""The sub-rays of trajectories and pixels, traced through the terrain of a DEM."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..errors import MuyscError
from ..forward.nodes import (
    FINE_ROWS,
    ROW_PARTS,
    NodeGrid,
    Nodes,
    even_nodes,
    finer_nodes,
    uneven_blocks,
)
from ..forward.responses import Responses
from ..forward.sub_rays import SubRays
from ..progress import Progress, part, silent
from ..radiography.aperture import MEMORY_LIMIT
from ..radiography.raytracing import RockPaths
from ..telescope.sky import MAXIMUM_RAYS, check_rays
from ..topography.frame import LocalFrame
from ..topography.tracing import trace_terrain

#: Columns and rows for each ray asked for along a side: the quadrature is of second order, and
#: with three rays a bar its errors are then below those of counting.
_FINENESS = 2

#: Directions traced at a time, and memory that a direction of the grid may take in the end:
#: four elements see it, and a ninth of the rows is kept as a rule.
_BLOCK = 1 << 21
_BYTES_PER_NODE = 40

#: Columns whose skylines are traced together.
_NEIGHBOURS = 32

#: Error of the quadrature, as it is told, that calls for more rays, in counting errors; the
#: true one is half of it or less as a rule.
TOLERANCE_SIGMA = 0.4
#: Share of the trajectories that may have more.
_EXCEPT = 0.05
#: Width of a bar (degrees) that terrain of some 30 m has few features in.
_NARROW_DEG = 1.5
#: How many times as many rays a bar are tried, and directions that are still cheap.
_FINEST = 4.0
_AFFORDABLE = 1 << 25

_Trace = Callable[[np.ndarray, np.ndarray, Progress], RockPaths]


def trace_sub_rays(
    frame: LocalFrame,
    eye_m: float,
    responses: Responses,
    rays_per_bar: float = 3.0,
    max_range_m: float | None = None,
    near_field_m: float = 0.0,
    progress: Progress = silent,
) -> SubRays:
    """Trace the sub-rays of trajectories or pixels through a DEM.

    On a grid of azimuths and elevations, twice as many a bar as asked for. One ray in nine
    rows stands for rock or sky that is even, each row has its own where the rock is uneven,
    and the rows at the skyline are cut in eight.

    Parameters
    ----------
    frame, eye_m
        Detector, and its height in the DEM's heights.
    responses
        What the trajectories or pixels see.
    rays_per_bar
        Rays along a side for each step between trajectories or pixels, 1 to 50.
    max_range_m, near_field_m
        As in `trace_terrain`.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If a number cannot be used, so many rays take too much memory, or the DEM cannot be
        read.
    Cancelled
        If `progress` asks for a stop.
    """
    check_rays(rays_per_bar)
    grid = NodeGrid.over(responses.window, _FINENESS * rays_per_bar)
    if grid.size * _BYTES_PER_NODE > MEMORY_LIMIT:
        raise MuyscError(
            f"{len(grid.elevation_deg):,} × {len(grid.azimuth_deg):,} rays would take more than "
            f"the {MEMORY_LIMIT / 2**30:.0f} GiB of memory allowed; use fewer rays a bar or a "
            "telescope with fewer bars."
        )

    def trace(azimuth: np.ndarray, elevation: np.ndarray, progress: Progress) -> RockPaths:
        return trace_terrain(frame, eye_m, azimuth, elevation, max_range_m, near_field_m, progress)

    columns = len(grid.azimuth_deg)
    step = max(1, _BLOCK // len(grid.elevation_deg))
    found = []
    for first in range(0, columns, step):
        last = min(first + step, columns)
        done = part(progress, first / columns, last / columns)
        # With a neighbour on either side, to be compared with.
        wide = slice(max(first - 1, 0), min(last + 1, columns))
        rock = trace(grid.azimuth_deg[wide], grid.elevation_deg, part(done, 0.0, 0.5))
        inner = slice(first - wide.start, last - wide.start)
        uneven = uneven_blocks(rock.thickness_m)[inner]
        thickness, outcome = rock.thickness_m[inner], rock.outcome[inner]
        found.append(even_nodes(grid, first, thickness, outcome, uneven))
        found += _finer(grid, first, uneven, trace, part(done, 0.5, 1.0))
    return SubRays.of(Nodes.joined(found), responses)


def _finer(
    grid: NodeGrid, start: int, uneven: np.ndarray, trace: _Trace, progress: Progress
) -> list[Nodes]:
    """Return the rays of uneven blocks, which are cut into finer columns.

    Parameters
    ----------
    grid, start
        The directions, and the number of the first column.
    uneven
        (n_azimuth, n_block) of bool.
    """
    nodes = []
    columns = len(uneven)
    parts = np.arange(FINE_ROWS * ROW_PARTS)
    for first in range(0, columns, _NEIGHBOURS):
        column, block = np.nonzero(uneven[first : first + _NEIGHBOURS])
        if not len(column):
            continue
        own, ray = np.unique(column, return_inverse=True)
        band, level = np.unique(block, return_inverse=True)
        azimuth = grid.finer_azimuth_deg(start + first + own)
        rock = trace(
            azimuth.ravel(),
            grid.finer_elevation_deg((band[:, None] * len(parts) + parts).ravel()),
            part(progress, first / columns, min(1.0, (first + _NEIGHBOURS) / columns)),
        )
        shape = (len(own), grid.finer_columns, len(band), FINE_ROWS, ROW_PARTS)
        thickness, outcome = (
            one.reshape(shape)[ray, :, level].reshape(-1, FINE_ROWS, ROW_PARTS)
            for one in (rock.thickness_m, rock.outcome)
        )
        nodes.append(
            finer_nodes(
                grid,
                np.repeat(start + first + column, grid.finer_columns),
                np.repeat(block, grid.finer_columns),
                azimuth[ray].ravel(),
                thickness,
                outcome,
            )
        )
    return nodes


def first_rays(rays_per_bar: float, bar_deg: float) -> float:
    """Return the rays a bar to begin with: more for wide bars, in which terrain has more room."""
    return min(MAXIMUM_RAYS, rays_per_bar * max(1.0, min(_FINEST / 2, bar_deg / _NARROW_DEG)))


def converged(
    trace: Callable[[float, Progress], SubRays],
    excess: Callable[[SubRays], np.ndarray],
    rays_per_bar: float,
    progress: Progress = silent,
) -> SubRays:
    """Double the rays until the quadrature is good enough for what was or will be counted.

    Parameters
    ----------
    trace
        Returns the sub-rays for some rays a bar.
    excess
        Returns the error of their quadrature in counting errors, NaN where unknown.
    rays_per_bar
        What to begin with; four times as many are the end.
    progress
        Told the share done.
    """
    first, finest = rays_per_bar, min(_FINEST * rays_per_bar, MAXIMUM_RAYS)
    while True:
        rays = trace(rays_per_bar, part(progress, 1 - first / rays_per_bar, 1.0))
        errors = excess(rays)
        known = errors[np.isfinite(errors)]
        uneven = len(rays.azimuth_deg) * 4 * FINE_ROWS > _AFFORDABLE
        if (
            uneven
            or 2 * rays_per_bar > finest
            or np.count_nonzero(known > TOLERANCE_SIGMA) <= _EXCEPT * known.size
        ):
            return rays
        rays_per_bar *= 2
