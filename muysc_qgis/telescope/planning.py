"""How long to count, and what the counts will show."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..radiography.counting import check_positive, exposure_days, feasibility_days
from .sky import check_rays
from .statistics import days_for_contrast, significant_excess

#: How the days for a contrast are computed.
STATISTICS = ("poisson", "lesparre")

#: Quantities that are computed only where wanted: they need the flux at other densities.
ON_REQUEST = ("density_resolution", "contrast_days")

#: Share of a response behind rock from which a trajectory counts as rock.
HALF = 0.5

#: Relative change of the density that tells how steeply the flux falls with it.
PROBE = 0.02


@dataclass(frozen=True)
class CountingPlan:
    """How long to count, and what is to be seen.

    Parameters
    ----------
    days
        Time of counting.
    muons
        Muons wanted along each trajectory, for the exposure time.
    sigma
        Significance in standard deviations with which a contrast is to be seen.
    contrast_percent
        Change of the density along the whole path to be seen, above −100 and not 0.
    merge
        Odd number of trajectories along a side that are taken together.
    efficiency
        Share of the muons through the telescope that it records.
    statistics
        One of `STATISTICS`: exact Poisson, or the feasibility formula of Lesparre.
    rays_per_bar
        Rays along a side for each step between two trajectories.

    Raises
    ------
    MuyscError
        If a value cannot be used.
    """

    days: float = 30.0
    muons: float = 10.0
    sigma: float = 3.0
    contrast_percent: float = -10.0
    merge: int = 1
    efficiency: float = 1.0
    statistics: str = "poisson"
    rays_per_bar: float = 3.0

    def __post_init__(self) -> None:
        check_positive(self.days, "number of days")
        check_positive(self.muons, "number of muons")
        check_positive(self.sigma, "significance in standard deviations")
        if not -100 < self.contrast_percent < np.inf or self.contrast_percent == 0:
            raise MuyscError(
                f"A density contrast of {self.contrast_percent:g} % cannot be seen or cannot be; "
                "give a percentage above −100 that is not 0, negative for lighter rock."
            )
        if not 0 < self.efficiency <= 1:
            raise MuyscError(
                f"An efficiency of {self.efficiency:g} is impossible; give a share above 0 and "
                "up to 1."
            )
        check_rays(self.rays_per_bar)
        if self.statistics not in STATISTICS:
            raise MuyscError(
                f"There are no statistics “{self.statistics}”; use {' or '.join(STATISTICS)}."
            )


@dataclass(frozen=True)
class Bins:
    """What trajectories, or bins of them, collect and see, (n_y, n_x) each."""

    acceptance_cm2_sr: np.ndarray
    #: Means over the responses, cm⁻² sr⁻¹ day⁻¹.
    flux: np.ndarray
    open_sky: np.ndarray
    #: Fluxes at other densities, in the order of those of `ON_REQUEST` that are wanted.
    changed: tuple[np.ndarray, ...]
    thickness_m: np.ndarray
    #: Share of the response behind rock.
    rock_share: np.ndarray


def planned_quantities(
    bins: Bins, plan: CountingPlan, wanted: tuple[str, ...]
) -> dict[str, np.ndarray]:
    """Return the values of every quantity by name.

    Parameters
    ----------
    bins
        What is seen.
    plan
        How long to count and what is to be seen.
    wanted
        Which of `ON_REQUEST` to compute.
    """
    acceptance = bins.acceptance_cm2_sr
    effective = acceptance * plan.efficiency
    flux, changed = bins.flux, [*bins.changed]
    rate = flux * effective
    counts = rate * plan.days
    values = {
        "counts": counts,
        "open_sky_counts": bins.open_sky * effective * plan.days,
        "relative_error": 100 / np.sqrt(np.where(counts > 0, counts, np.nan)),
        "exposure": exposure_days(flux, effective, plan.muons),
        "flux": flux,
        "thickness": bins.thickness_m,
        "rock_share": bins.rock_share,
        "acceptance": acceptance,
    }
    rock = bins.rock_share > HALF
    if "density_resolution" in wanted:
        lighter = changed.pop(0)
        values["density_resolution"] = np.where(
            rock, 100 * smallest_contrast(counts, flux, lighter, plan.sigma), np.nan
        )
    if "contrast_days" in wanted:
        if plan.statistics == "poisson":
            days = days_for_contrast(rate, changed.pop(0) * effective, plan.sigma)
        else:
            days = feasibility_days(flux, changed.pop(0), effective, plan.sigma)
        values["contrast_days"] = np.where(rock & np.isfinite(days), days, np.nan)
    return values


def smallest_contrast(
    counts: np.ndarray, flux: np.ndarray, lighter_flux: np.ndarray, sigma: float
) -> np.ndarray:
    """Return the smallest decrease of the mean density that counts show, as a share.

    The counts have to reach the exact Poisson excess n of `significant_excess`; the flux
    goes as a power s of the density, I ∝ ρ^s, so that the density is less by
    1 − (n/N)^(1/s). For many counts it is σ/(|s| √N).

    Parameters
    ----------
    counts
        Counts N expected without the contrast.
    flux, lighter_flux
        Muon flux, and the flux with the density less by the share `PROBE`.
    sigma
        Significance in standard deviations.
    """
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        slope = np.log(lighter_flux / flux) / np.log(1 - PROBE)
        contrast = 1 - (significant_excess(counts, sigma) / counts) ** (1 / slope)
    return np.where(slope < 0, contrast, np.nan)
