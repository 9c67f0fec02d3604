"""What a telescope will count behind a mountain, and what the counts will show.

DEM → rays on a fine grid → flux → mean flux over each trajectory → counts, errors and
the density contrasts that can be seen.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from ..progress import Progress, part, report, silent
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.raytracing import Outcome, RockPaths
from ..radiography.settings import Physics
from ..radiography.transmission import Attenuation, attenuate
from ..telescope.acceptance import trajectories
from ..telescope.directions import Pointing
from ..telescope.geometry import TelescopeGeometry
from ..telescope.merging import check_merge, merge_sum, merged_offsets
from ..telescope.planning import (
    HALF,
    ON_REQUEST,
    PROBE,
    CountingPlan,
    merged_bins,
    planned_quantities,
)
from ..telescope.quadrature import trajectory_means
from ..telescope.sky_table import (
    FINE_ROWS,
    Layers,
    SkyGrid,
    SkyTable,
    abrupt_steps,
    grid_around,
    reaches_horizon,
)
from ..topography.sight import Sight
from ..topography.tracing import trace_terrain
from ..trajectories import TrajectoryMap, describe_telescope
from .provenance import describe_physics, describe_sight
from .simulation import check_range, terrain_warnings

#: Share of the progress bar when all rays are traced.
_TRACED = 0.6


@dataclass(frozen=True)
class TelescopeCounts:
    """Rasters by quantity, and what to say about them."""

    maps: Mapping[str, TrajectoryMap]
    #: (n_y, n_x) share of each trajectory's response behind rock; unknown counts as rock.
    rock_share: np.ndarray
    #: One sentence each.
    warnings: tuple[str, ...]
    #: Number of trajectories that cannot be known, by cause.
    unknown: Mapping[str, int]
    geometry: TelescopeGeometry
    pointing: Pointing
    plan: CountingPlan
    #: Rays traced.
    rays: int = 0
    grid: SkyGrid | None = field(default=None, repr=False)

    @property
    def trajectories(self) -> int:
        """Number of trajectories, or bins of them."""
        return int(self.rock_share.size)

    @property
    def behind_rock(self) -> np.ndarray:
        """(n_y, n_x), true where most of the response is behind rock, and counts are known."""
        return np.asarray(self.rock_share > HALF) & np.isfinite(self.maps["counts"].values)

    @property
    def rock_trajectories(self) -> int:
        """Number of trajectories behind rock."""
        return int(np.count_nonzero(self.behind_rock))

    @property
    def unknown_trajectories(self) -> int:
        """Number of trajectories without counts."""
        return int(np.count_nonzero(np.isnan(self.maps["counts"].values)))

    def rate_per_day(self, behind_rock: bool = False) -> float:
        """Return the muons a day along all known trajectories, or along those behind rock."""
        counts = self.maps["counts"].values
        chosen = self.behind_rock if behind_rock else np.ones(counts.shape, dtype=bool)
        return float(np.nansum(counts[chosen]) / self.plan.days)

    def median(self, quantity: str) -> float:
        """Return the median of a quantity behind rock, NaN where there is none."""
        values = self.maps[quantity].values[self.behind_rock]
        known = values[np.isfinite(values)]
        return float(np.median(known)) if known.size else float("nan")


def expected_counts(
    sight: Sight,
    geometry: TelescopeGeometry,
    pointing: Pointing,
    physics: Physics,
    plan: CountingPlan,
    formula: str = "exact",
    max_range_m: float | None = None,
    near_field_m: float = 0.0,
    wanted: tuple[str, ...] = ON_REQUEST,
    progress: Progress = silent,
) -> TelescopeCounts:
    """Compute what a telescope counts along each of its trajectories.

    The mean flux over a trajectory's response, times its acceptance.

    Parameters
    ----------
    sight
        Detector on the DEM, and target.
    geometry, pointing
        The telescope and where it points.
    physics
        Muon flux and rock.
    plan
        How long to count and what is to be seen.
    formula
        One of `FORMULAS` for the acceptance.
    max_range_m, near_field_m
        As for `simulate`.
    wanted
        Which of `ON_REQUEST` to compute as well.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If a value cannot be used or the DEM cannot be read.
    Cancelled
        If `progress` asks for a stop.
    """
    check_range(max_range_m, near_field_m)
    for bars in (geometry.bars_x, geometry.bars_y):
        check_merge(bars, plan.merge)
    grid = grid_around(geometry, pointing, plan.rays_per_bar)
    rock = trace_terrain(
        sight.frame,
        sight.detector_elevation_m,
        grid.azimuth_deg,
        grid.fine_elevation_deg,
        max_range_m,
        near_field_m,
        part(progress, 0.0, _TRACED),
    )
    altitude = sight.detector_elevation_m if physics.altitude_counts else 0.0
    changes = [1.0]
    if "density_resolution" in wanted:
        changes.append(1.0 - PROBE)
    if "contrast_days" in wanted:
        changes.append(1.0 + plan.contrast_percent / 100)
    thickness, sky = rock.thickness_m.T, rock.thickness_m.T == 0
    coarse = thickness[::FINE_ROWS]
    muons, logarithmic = _fluxes(
        coarse, grid.elevation_deg[:, None], changes, physics, altitude, progress
    )
    steps = abrupt_steps(grid, sky, logarithmic)
    report(progress, 0.75)
    detail = grid.fine_part(steps, thickness)
    elevation = grid.fine_part(
        steps, np.broadcast_to(grid.fine_elevation_deg[:, None], thickness.shape)
    )
    _, fine = _fluxes(detail, elevation, changes, physics, altitude, progress)
    table = SkyTable(
        grid,
        pointing,
        _layers(coarse, logarithmic),
        steps,
        _layers(detail, fine),
    )
    rough = table.rough_cells(geometry)
    means = trajectory_means(geometry, table, rough)
    below = reaches_horizon(geometry, pointing)
    means[:, below] = np.nan
    report(progress, 0.9)
    collected = trajectories(geometry, formula)
    bins = merged_bins(means, collected, plan)
    values = planned_quantities(bins, len(logarithmic), plan, wanted)
    report(progress, 1.0)
    metadata = {
        **describe_sight(sight, max_range_m, near_field_m),
        **describe_physics(physics),
        **describe_telescope(geometry, formula),
        **_describe_aim(sight, pointing),
        **_describe_plan(plan),
    }
    x = geometry.step * merged_offsets(geometry.bars_x, plan.merge)
    y = geometry.step * merged_offsets(geometry.bars_y, plan.merge)[::-1]
    return TelescopeCounts(
        {name: TrajectoryMap(name, array, x, y, metadata) for name, array in values.items()},
        bins.means[-1],
        (
            *_all_sky(bins.means[-1]),
            *terrain_warnings(sight, rock, max_range_m),
            *muons.warnings,
        ),
        _unknown(rock, table, geometry, rough, below, plan.merge),
        geometry,
        pointing,
        plan,
        thickness.size,
        grid,
    )


def _describe_aim(sight: Sight, pointing: Pointing) -> dict[str, str | float]:
    """Return the metadata that say where the telescope points, and where the target is; degrees."""
    return {
        "BORESIGHT_AZIMUTH": pointing.azimuth_deg,
        "BORESIGHT_ELEVATION": pointing.elevation_deg,
        "ROLL": pointing.roll_deg,
        "TARGET_AZIMUTH": sight.boresight_azimuth_deg,
        "TARGET_ELEVATION_ANGLE": sight.boresight_elevation_deg,
    }


def _describe_plan(plan: CountingPlan) -> dict[str, str | float]:
    """Return the metadata that say how long is counted and what is to be seen."""
    return {
        "DAYS": plan.days,
        "MUONS": plan.muons,
        "SIGMA": plan.sigma,
        "CONTRAST": plan.contrast_percent,
        "STATISTICS": plan.statistics,
        "EFFICIENCY": plan.efficiency,
        "MERGE": float(plan.merge),
    }


def _all_sky(rock_share: np.ndarray) -> tuple[str, ...]:
    known = np.isfinite(rock_share)
    if not known.any() or np.any(rock_share[known] > 0):
        return ()
    return (
        f"All {np.count_nonzero(known)} known trajectories see only sky: check detector, target "
        "and boresight.",
    )


def _fluxes(
    thickness_m: np.ndarray,
    elevation_deg: np.ndarray,
    changes: list[float],
    physics: Physics,
    altitude_m: float,
    progress: Progress,
) -> tuple[Attenuation, np.ndarray]:
    """Return the muons behind rock; and flux, open sky and the fluxes at changed densities."""
    opacity = thickness_m * (physics.density * G_CM2_PER_M_WATER_EQUIVALENT)
    results = []
    for change in changes:
        report(progress, _TRACED)
        results.append(attenuate(opacity * change, elevation_deg, physics, altitude_m))
    first, *others = results
    sky = np.broadcast_to(first.open_sky, opacity.shape)
    return first, np.stack([first.flux, sky, *(other.flux for other in others)])


def _layers(thickness_m: np.ndarray, logarithmic: np.ndarray) -> Layers:
    sky = thickness_m == 0
    return Layers(sky, logarithmic, np.stack([thickness_m, np.where(sky, 0.0, 1.0)]))


def _unknown(
    rock: RockPaths,
    table: SkyTable,
    geometry: TelescopeGeometry,
    rough: np.ndarray,
    below: np.ndarray,
    merge: int,
) -> dict[str, int]:
    """Count the trajectories of which a part cannot be known, by cause."""
    horizon = "part of it looks at or below the horizon, where no flux model has an answer"
    touched = {horizon: merge_sum(below.astype(float), merge) > 0}
    if any(np.isnan(layers.logarithmic[0]).any() for layers in (table.coarse, table.fine)):
        touched |= _unknown_rock(rock, table, geometry, rough, merge)
    return {cause: int(np.count_nonzero(one)) for cause, one in touched.items() if one.any()}


def _unknown_rock(
    rock: RockPaths,
    table: SkyTable,
    geometry: TelescopeGeometry,
    rough: np.ndarray,
    merge: int,
) -> dict[str, np.ndarray]:
    """Return the trajectories along which the rock or its flux is unknown, by cause."""
    outcome = rock.outcome.T
    causes = {
        "a ray reaches the edge of the DEM in rock": Outcome.EDGE,
        "a ray passes a gap in the DEM": Outcome.NO_DATA,
        "the energy loss has no answer for so much rock": None,
    }

    def marked(layers: Layers, outcome: np.ndarray) -> Layers:
        lost = np.isnan(layers.linear[0])
        masks = [lost & (outcome == code) for code in causes.values() if code is not None]
        masks.append(np.isnan(layers.logarithmic[0]) & ~lost)
        nothing = np.empty((0, *lost.shape))
        return Layers(layers.sky, nothing, np.stack(masks).astype(float))

    masks = replace(
        table,
        coarse=marked(table.coarse, outcome[::FINE_ROWS]),
        fine=marked(table.fine, table.grid.fine_part(table.steps, outcome)),
    )

    def reasons(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return np.nan_to_num(masks(x, y))

    return dict(zip(causes, merge_sum(trajectory_means(geometry, reasons, rough), merge) > 0))
