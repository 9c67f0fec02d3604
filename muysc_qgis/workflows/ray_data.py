"""What is known of the rays through a volume: opacities, errors, and why some are left out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from .sightlines import Sightlines

#: Why a ray through the volume does not count.
NO_VALUE = "the muogram has no value"
NO_ERROR = "the error is not known"

#: Assumed errors are at least those of this share of the mean opacity: of no rock at all, nothing
#: is known without error.
_LEAST = 0.1


@dataclass(frozen=True)
class RayData:
    """Rays with an opacity, and what it is."""

    #: (n,) which rays.
    used: np.ndarray
    #: (n,) opacity along the whole ray and its standard error, g/cm²; None where none is known.
    opacity: np.ndarray
    error: np.ndarray | None
    #: (n,) share of an independent datum that each is.
    share: np.ndarray
    #: Density (g/cm³) of rock of which nothing else is known.
    reference_density: float
    #: Pixels that say nothing, by cause.
    lost: Mapping[str, int]


def ray_data(
    lines: Sightlines,
    reference_density: float | None,
    relative_error: float | None,
    length_error_m: float,
) -> RayData:
    """Gather the opacities of stations whose rays are laid.

    Parameters
    ----------
    lines
        Stations and their rays.
    reference_density
        g/cm³; None takes the mean that the opacities say.
    relative_error
        Of opacities whose stations have no errors; None where that is not known.
    length_error_m
        Error of the lengths in rock, which adds to known errors.

    Raises
    ------
    MuyscError
        If a station has no opacities, only some have errors, or no ray is left.
    """
    opacity, error = _gathered(lines)
    known = np.isfinite(opacity)
    rock_m = lines.thickness_m[known].sum()
    if reference_density is None and rock_m > 0:
        reference_density = float(opacity[known].sum() / (G_CM2_PER_M_WATER_EQUIVALENT * rock_m))
    if not known.any() or not reference_density:
        raise MuyscError(
            f"None of the {len(opacity)} rays through the volume has an opacity above 0; choose an "
            "extent where the muograms have values."
        )
    lost = _without_opacity(lines, ~known)
    if error is None and relative_error:
        least = _LEAST * opacity[known].mean()
        error = relative_error * np.maximum(opacity, least)
    if error is not None:
        error = np.hypot(error, G_CM2_PER_M_WATER_EQUIVALENT * reference_density * length_error_m)
        certain = known & ~(np.isfinite(error) & (error > 0))
        lost[NO_ERROR] = int(np.count_nonzero(certain))
        known &= ~certain
        if not known.any():
            raise MuyscError(
                f"None of the {len(opacity)} rays through the volume has an error above 0; check "
                "the rasters of errors, or leave them out."
            )
    used = np.flatnonzero(known)
    share = np.concatenate([
        np.ones(len(one)) if one.share is None else one.share for one in lines.stations
    ])[lines.pixel]  # fmt: skip
    return RayData(
        used, opacity[used], None if error is None else error[used], share[used],
        reference_density,
        {cause: count for cause, count in lost.items() if count},
    )  # fmt: skip


def _gathered(lines: Sightlines) -> tuple[np.ndarray, np.ndarray | None]:
    """Return opacity and error of each ray, as the stations know them."""
    opacities, errors = [], []
    for station in lines.stations:
        if station.opacity is None:
            raise MuyscError(f"{station.name} has no opacities; simulate or read them first.")
        opacities.append(station.opacity)
        if station.error is not None:
            errors.append(station.error)
    if errors and len(errors) < len(opacities):
        raise MuyscError(
            f"{len(errors)} of {len(opacities)} stations have errors of their opacities; give "
            "those of all, or of none."
        )
    error = np.concatenate(errors)[lines.pixel] if errors else None
    return np.concatenate(opacities)[lines.pixel], error


def _without_opacity(lines: Sightlines, missing: np.ndarray) -> dict[str, int]:
    """Return the pixels that are no ray or have no opacity, by cause."""
    lost = dict(lines.lost)
    missing = missing.copy()
    for cause in sorted({cause for station in lines.stations for cause in station.lost}):
        because = np.concatenate(
            [station.lost.get(cause, np.zeros(len(station), bool)) for station in lines.stations]
        )[lines.pixel]
        lost[cause] = int(np.count_nonzero(missing & because))
        missing &= ~because
    lost[NO_VALUE] = int(np.count_nonzero(missing))
    return lost
