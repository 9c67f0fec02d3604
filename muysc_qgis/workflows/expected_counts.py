"""What a telescope will count behind a mountain, and what the counts will show.

DEM → sub-rays of every trajectory → flux → mean flux over its response → counts, errors and
the density contrasts that can be seen.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..forward.responses import TelescopeResponses
from ..forward.sub_rays import SubRays, error_in_counting_errors
from ..progress import Progress, part, report, silent
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.raytracing import Outcome
from ..radiography.settings import Physics
from ..telescope.acceptance import trajectories
from ..telescope.directions import Pointing
from ..telescope.geometry import TelescopeGeometry
from ..telescope.merging import check_merge, merge_sum, merged_bins, merged_offsets
from ..telescope.planning import (
    HALF,
    ON_REQUEST,
    PROBE,
    Bins,
    CountingPlan,
    planned_quantities,
)
from ..topography.sight import Sight
from ..trajectories import TrajectoryMap, describe_telescope
from .forward_model import converged, first_rays, trace_sub_rays
from .measured import EXPECTED
from .provenance import describe_flux_error, describe_physics, describe_sight
from .simulation import check_range, terrain_warnings

#: Share of the progress bar when all rays are traced.
_TRACED = 0.6


@dataclass(frozen=True)
class TelescopeCounts:
    """Rasters by quantity, and what to say about them."""

    maps: Mapping[str, TrajectoryMap]
    #: (n_y, n_x) share of each trajectory's response behind rock; unknown counts as rock.
    rock_share: np.ndarray
    #: (n_y, n_x) error of the sums over rays, in counting errors.
    quadrature_sigma: np.ndarray
    #: One sentence each.
    warnings: tuple[str, ...]
    #: Number of trajectories that cannot be known, by cause.
    unknown: Mapping[str, int]
    geometry: TelescopeGeometry
    pointing: Pointing
    plan: CountingPlan
    #: Rays traced.
    rays: int = 0

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

    @property
    def quadrature_error(self) -> float:
        """Error of the sums over rays that 95 % of the trajectories stay below, counting errors."""
        known = self.quadrature_sigma[np.isfinite(self.quadrature_sigma)]
        return float(np.percentile(known, 95)) if known.size else float("nan")

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
    refine: bool = True,
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
    refine
        Whether rays are added where the plan's are too few for the counts expected.

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
    altitude = sight.detector_elevation_m if physics.altitude_counts else 0.0
    collected = trajectories(geometry, formula).acceptance_cm2_sr
    acceptance = merge_sum(collected, plan.merge)
    shape, bins = merged_bins(geometry, plan.merge)
    responses = TelescopeResponses(geometry, pointing)

    def trace(rays_per_bar: float, progress: Progress) -> SubRays:
        rays = trace_sub_rays(
            sight.frame, sight.detector_elevation_m, responses, rays_per_bar,
            max_range_m, near_field_m, progress,
        )  # fmt: skip
        if plan.merge == 1:
            return rays
        return rays.taken_together(shape, bins, collected.ravel())

    def excess(rays: SubRays) -> np.ndarray:
        flux, error = rays.mean_and_error(rays.muons(physics.density, physics, altitude).flux)
        return error_in_counting_errors(flux, error, acceptance * plan.efficiency * plan.days)

    if refine:
        rays = converged(
            trace,
            excess,
            first_rays(plan.rays_per_bar, responses.window.step_deg[0]),
            part(progress, 0.0, _TRACED),
        )
    else:
        rays = trace(plan.rays_per_bar, part(progress, 0.0, _TRACED))
    changes = [1.0]
    if "density_resolution" in wanted:
        changes.append(1.0 - PROBE)
    if "contrast_days" in wanted:
        changes.append(1.0 + plan.contrast_percent / 100)
    muons = []
    for number, change in enumerate(changes):
        done = _TRACED + (1 - _TRACED) * number / len(changes)
        report(progress, done)
        muons.append(rays.muons(physics.density * change, physics, altitude))
    flux, error = rays.mean_and_error(muons[0].flux)
    seen = Bins(
        acceptance,
        flux,
        rays.mean(np.broadcast_to(muons[0].open_sky, rays.thickness_m.shape)),
        tuple(rays.mean(one.flux) for one in muons[1:]),
        rays.mean_thickness_m,
        rays.rock_share,
    )
    values = planned_quantities(seen, plan, wanted)
    report(progress, 1.0)
    metadata = {
        **describe_sight(sight, max_range_m, near_field_m),
        **describe_physics(physics),
        **describe_flux_error(
            muons[0],
            rays.thickness_m * (physics.density * G_CM2_PER_M_WATER_EQUIVALENT),
            rays.elevation_deg,
            physics,
            altitude,
        ),
        **describe_telescope(geometry, formula),
        **_describe_aim(sight, pointing),
        **_describe_plan(plan),
        "COUNTED": EXPECTED,
    }
    x = geometry.step * merged_offsets(geometry.bars_x, plan.merge)
    y = geometry.step * merged_offsets(geometry.bars_y, plan.merge)[::-1]
    return TelescopeCounts(
        {name: TrajectoryMap(name, array, x, y, metadata) for name, array in values.items()},
        rays.rock_share,
        error_in_counting_errors(flux, error, acceptance * plan.efficiency * plan.days),
        (
            *_all_sky(rays.rock_share),
            *terrain_warnings(sight, rays, max_range_m),
            *muons[0].warnings,
        ),
        _unknown(rays, muons[0].flux),
        geometry,
        pointing,
        plan,
        len(rays.azimuth_deg),
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


def _unknown(rays: SubRays, flux: np.ndarray) -> dict[str, int]:
    """Count the trajectories of which a part cannot be known, by cause."""
    lost = np.isnan(flux)
    causes = {
        "part of it looks at or below the horizon, where no flux model has an answer": (
            rays.below.reshape(rays.shape)
        ),
        "a ray reaches the edge of the DEM in rock": (
            rays.touched(lost & (rays.outcome == Outcome.EDGE))
        ),
        "a ray passes a gap in the DEM": rays.touched(lost & (rays.outcome == Outcome.NO_DATA)),
        "the energy loss has no answer for so much rock": (
            rays.touched(lost & np.isfinite(rays.thickness_m))
        ),
    }
    return {cause: int(np.count_nonzero(one)) for cause, one in causes.items() if one.any()}
