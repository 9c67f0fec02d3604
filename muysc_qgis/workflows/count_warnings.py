"""What to say where densities from counts cannot be right, with cause and remedy."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..tomography.counting import CountFit
from .count_lines import CountLines, CountStation
from .tomography_result import MOST_CHI_SQUARED, beyond_rock

#: Prior errors by which a number may be off its prior.
_FAR = 3.0

#: χ² of one station above which it is named.
_MOST_STATION = 2.0


def warnings_of(
    stations: Sequence[CountStation], laid: CountLines, fit: CountFit, densities: np.ndarray
) -> list[str]:
    """Return one sentence for each thing that is wrong, or limits what is found.

    Parameters
    ----------
    stations, laid, fit
        What was counted, and what was found.
    densities
        (n,) densities of the voxels that a trajectory passes, g/cm³.
    """
    said = []
    if len(stations) == 1:
        said.append(
            "There is one station only, so that nothing tells near rock from far: densities are "
            "smeared along its rays; add stations that look from other sides."
        )
    if not fit.converged:
        said.append(
            f"counts did not settle within {fit.iterations} steps and {fit.inner_iterations} "
            "iterations, so that the densities are not yet what counts and priors say; give more "
            "iterations."
        )
    if fit.chi_squared > MOST_CHI_SQUARED:
        said.append(_unexplained(stations, laid, fit))
    said += beyond_rock(densities)
    said += _far_off(stations, fit)
    share = 1 - laid.lines.inside_m.sum() / laid.lines.thickness_m.sum()
    if share > 0.5:
        said.append(
            f"{100 * share:.0f} % of the rock on the rays is outside the volume and taken for "
            f"rock of {fit.mean:.3g} g/cm³; choose a larger extent or a lower base."
        )
    return said


def _unexplained(stations: Sequence[CountStation], laid: CountLines, fit: CountFit) -> str:
    """Return the sentence on a misfit, with the stations and the kind of trajectory it is of."""
    off = fit.residuals(laid.model.counts)
    square = off**2
    rim = (laid.rock_share > 0.02) & (laid.rock_share < 0.98)
    sky = laid.rock_share <= 0.02
    kinds = {
        "in the sky": (sky, "check acceptance, efficiency, days and flux model"),
        "at the skyline": (rim, "check pointing and elevation model, or give a larger terrain "
                           "error (TERRAIN_ERROR)"),
        "behind rock": (~rim & ~sky, "check background and flux model, or give a larger "
                        "deviation of the prior (PRIOR_DEVIATION)"),
    }  # fmt: skip
    where, (which, remedy) = max(kinds.items(), key=lambda kind: float(square[kind[1][0]].sum()))
    bad = [
        one.name
        for number, one in enumerate(stations)
        if np.mean(square[laid.model.station == number]) > _MOST_STATION
    ]
    of = f", most of all {', '.join(bad)}" if 0 < len(bad) < len(stations) else ""
    return (
        f"The densities do not explain the counts (χ² is {fit.chi_squared:.3g} per datum, where 1 "
        f"is perfect{of}); {100 * square[which].sum() / square.sum():.0f} % of it is from the "
        f"{int(which.sum())} trajectories {where}: {remedy}."
    )


def _far_off(stations: Sequence[CountStation], fit: CountFit) -> list[str]:
    """Return a sentence on each number that is far from what was known of it."""
    what = {
        "factor": ("counts {0:.3g} times what is expected", "check its acceptance, efficiency and "
                   "days"),
        "flux": ("The flux is {0:.3g} times that of the model", "check the flux model"),
        "flux_fall": ("The flux falls off otherwise than the model by {0:.2g} in ln", "check the "
                      "flux model and the energy loss"),
        "azimuth": ("points {0:.2g}° off in azimuth", "check its boresight"),
        "elevation": ("points {0:.2g}° off in elevation", "check its boresight"),
        "mean": ("The mean density is {0:.3g} g/cm³", "check acceptance, flux model and reference "
                 "density"),
    }  # fmt: skip
    said = []
    for band in fit.bands:
        off = abs(np.log(band.after) if band.name in ("factor", "flux") else
                  band.after - band.before)  # fmt: skip
        if off <= _FAR * band.before_error:
            continue
        text, remedy = what[band.name]
        name = "" if band.station < 0 else f"{stations[band.station].name} "
        said.append(
            f"{name}{text.format(band.after)}, {off / band.before_error:.2g} times its prior's "
            f"error away from it; {remedy}."
        )
    return said
