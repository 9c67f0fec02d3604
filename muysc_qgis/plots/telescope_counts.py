"""What a telescope counts on the mountain, and what the counts show."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..workflows.expected_counts import TelescopeCounts
from .directions import describe
from .telescope_panel import telescope_title
from .ticks import number_label
from .trajectory_page import aimed_at_target, trajectory_page

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Quantities of the panel, and of the report's second figure.
PANEL = ("counts", "relative_error", "density_resolution", "contrast_days")
FURTHER = ("exposure", "open_sky_counts", "flux", "thickness")


def counts_panel(counts: TelescopeCounts, name: str, quantities: tuple[str, ...] = PANEL) -> Figure:
    """Return maps of what a telescope counts, with skyline, horizon and target.

    Parameters
    ----------
    counts
        From `expected_counts`.
    name
        Name of the telescope.
    quantities
        Which to show, two in a row.

    Raises
    ------
    MuyscError
        If matplotlib is missing.
    """
    maps = [counts.maps[key] for key in quantities]
    return trajectory_page(
        maps,
        [_title(one.quantity, counts) for one in maps],
        f"{telescope_title(name)}: {counts.plan.days:g} days of counting",
        [*_told(counts), *describe(aimed_at_target(maps[0]))],
        counts.rock_share,
    )


def _title(quantity: str, counts: TelescopeCounts) -> str:
    plan = counts.plan
    if quantity == "density_resolution":
        return f"Smallest density contrast seen at {plan.sigma:g} σ"
    if quantity == "contrast_days":
        return f"Days to see {plan.contrast_percent:+g} % of density".replace("-", "−")
    return counts.maps[quantity].kind.title


def _told(counts: TelescopeCounts) -> list[str]:
    geometry, plan = counts.geometry, counts.plan
    merged = "" if plan.merge == 1 else f"  ·  {plan.merge} × {plan.merge} trajectories merged"
    pointing, aim = counts.pointing, counts.maps["counts"].metadata
    boresight = ""
    if (pointing.azimuth_deg, pointing.elevation_deg) != (
        aim["TARGET_AZIMUTH"],
        aim["TARGET_ELEVATION_ANGLE"],
    ):
        boresight = (
            f"  ·  boresight {pointing.azimuth_deg % 360:.1f}°, {pointing.elevation_deg:.1f}° up"
        )
    roll = f"  ·  roll {counts.pointing.roll_deg:g}°" if counts.pointing.roll_deg else ""
    total, rock = (
        number_label(float(f"{counts.rate_per_day(behind_rock=one):.4g}")) for one in (False, True)
    )
    rates = f"{total} muons a day along known trajectories, {rock} of them behind rock"
    return [
        f"{geometry.bars_x} × {geometry.bars_y} bars of {geometry.pixel_size_cm:g} cm, planes "
        f"{geometry.separation_cm:g} cm apart{merged}{boresight}{roll}",
        rates,
    ]
