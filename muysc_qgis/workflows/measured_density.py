"""From measured muograms to density: what is read, what comes out, what to say about it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..measurement.density import (
    Densities,
    Flag,
    Scene,
    check_minimum,
    check_uncertainty,
    measure_density,
    model_densities,
)
from ..measurement.mean import Mean, mean_density
from ..measurement.observation import Observation, check_transmission, pixels
from ..progress import Progress, part, report, silent
from ..radiography.settings import Physics
from ..views import (
    View,
    elevation_of,
    like,
    metres_apart,
    require_quantity,
    require_same_directions,
)
from .measured import Measurement
from .provenance import altitude_of, describe_physics

#: Detectors of two muograms farther apart than this (m) are worth a warning.
_SAME_PLACE_M = 30.0

#: Share of the progress bar for the model chosen, where all others follow.
_OWN = 0.25

#: What the values of a raster of flags mean, as its metadata says it.
FLAG_MEANINGS = {
    Flag.MEASURED: "density measured",
    Flag.SKY: "no rock",
    Flag.LOWER_LIMIT: "no muon counted: density is a lower limit",
    Flag.BRIGHT: "as bright as the open sky: density 0",
    Flag.NOT_MEASURED: "measurement or thickness missing",
    Flag.NO_ANSWER: "no density explains the flux",
    Flag.TOO_THIN: "too little rock to dim the flux",
}

#: Flags of pixels of which nothing is known.
UNKNOWN = (Flag.NOT_MEASURED, Flag.NO_ANSWER, Flag.TOO_THIN)

#: Metadata of a simulation that says nothing of a measurement.
_NOT_MEASURED = ("DENSITY", "MUONS", "ACCEPTANCE")


@dataclass(frozen=True)
class DensityChoices:
    """What the user decides on the way to a density.

    Raises
    ------
    MuyscError
        If a number is out of range.
    """

    #: Relative uncertainty of the flux model.
    model_uncertainty: float = 0.0
    #: Counts up to which neighbouring pixels are merged, 0 for no merging.
    minimum_counts: float = 0.0
    #: Confidence of the lower limits, between 0.5 and 1.
    limit_confidence: float = 0.95
    #: Whether the spread over the flux models is wanted.
    model_spread: bool = False

    def __post_init__(self) -> None:
        check_uncertainty(self.model_uncertainty)
        check_minimum(self.minimum_counts)
        if not 0.5 < self.limit_confidence < 1:
            raise MuyscError(
                f"A confidence of {100 * self.limit_confidence:g} % cannot be used; give one above "
                "50 % and below 100 %."
            )


@dataclass(frozen=True)
class DensityResult:
    """Muograms by quantity, numbers, and what to say about them."""

    muograms: Mapping[str, View]
    densities: Densities
    mean: Mean
    warnings: tuple[str, ...]

    @property
    def median_density(self) -> float:
        """Median of the pixels with a density, NaN where there is none."""
        measured = self.densities.density[self.densities.flags == Flag.MEASURED]
        return float(np.median(measured)) if measured.size else float("nan")

    @property
    def unknown(self) -> Mapping[str, int]:
        """Number of pixels without a density of their own, by cause."""
        return {
            FLAG_MEANINGS[flag]: self.densities.count(flag)
            for flag in (Flag.LOWER_LIMIT, Flag.BRIGHT, *UNKNOWN)
        }

    @property
    def rock_pixels(self) -> int:
        """Number of pixels with rock."""
        return int(np.count_nonzero(self.muograms["thickness"].values > 0))


def density_behind(
    measured: Measurement,
    thickness: View,
    physics: Physics,
    choices: DensityChoices,
    altitude_m: float | None = None,
    progress: Progress = silent,
) -> DensityResult:
    """Return the mean density along each ray of a measured muogram.

    Parameters
    ----------
    measured
        What was measured.
    thickness
        Rock thickness on the same directions.
    physics
        How muons are produced and stopped; its density is not used.
    choices
        Uncertainty, merging, limits.
    altitude_m
        Altitude of the detector in m, None for DETECTOR_ELEVATION of the measured muogram, or
        of the thickness where that lacks it.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If the muograms do not go together or a value cannot be used.
    Cancelled
        If `progress` asks for a stop.
    """
    require_quantity(thickness, ("thickness",), "The thickness muogram")
    require_same_directions(measured.values, measured.values.quantity, thickness, "thickness")
    placed = measured.values if "DETECTOR_ELEVATION" in measured.values.metadata else thickness
    scene = Scene(
        thickness.values,
        elevation_of(thickness),
        physics,
        altitude_of(placed, physics, altitude_m),
        choices.model_uncertainty,
    )
    if measured.values.quantity == "transmission":
        errors = None if measured.errors is None else measured.errors.values
        check_transmission(measured.values.values, errors, thickness.values)
    report(progress, 0.0)
    seen = measured.observation(choices.limit_confidence)
    report(progress, 0.0)
    own = _OWN if choices.model_spread else 1.0
    found = measure_density(seen, scene, choices.minimum_counts, part(progress, 0.0, 0.5 * own))
    mean = mean_density(seen, scene, found, part(progress, 0.5 * own, own))
    values = {
        "thickness": thickness.values,
        "opacity": found.opacity(thickness.values),
        "density": found.density,
        "density_error": found.error,
        "density_lower": found.lower,
        "density_upper": found.upper,
        "density_flags": found.flags.astype(float),
    }
    if choices.model_spread:
        spread = model_densities(seen, scene, choices.minimum_counts, part(progress, own, 1.0))
        values |= {"density_minimum": spread.minimum, "density_maximum": spread.maximum}
    report(progress, 1.0)
    kept = {key: value for key, value in thickness.metadata.items() if key not in _NOT_MEASURED}
    metadata = {**kept, **_metadata(measured, physics, choices, mean)}
    muograms = {name: like(thickness, name, array, metadata) for name, array in values.items()}
    return DensityResult(
        muograms, found, mean, _warnings(measured, thickness, found, choices, seen)
    )


def _metadata(
    measured: Measurement, physics: Physics, choices: DensityChoices, mean: Mean
) -> dict[str, str | float]:
    used = {key: value for key, value in describe_physics(physics).items() if key != "DENSITY"}
    return {
        **used,
        "MEASURED": measured.values.quantity,
        "MODEL_UNCERTAINTY": choices.model_uncertainty,
        "MINIMUM_COUNTS": choices.minimum_counts,
        "LIMIT_CONFIDENCE": choices.limit_confidence,
        "MEAN_DENSITY": mean.density,
        "MEAN_DENSITY_ERROR": mean.error,
        "FLAGS": "; ".join(f"{int(flag)} {text}" for flag, text in FLAG_MEANINGS.items()),
    }


def _warnings(
    measured: Measurement,
    thickness: View,
    found: Densities,
    choices: DensityChoices,
    seen: Observation,
) -> tuple[str, ...]:
    warnings = []
    limits, bright = found.count(Flag.LOWER_LIMIT), found.count(Flag.BRIGHT)
    no_answer = found.count(Flag.NO_ANSWER)
    if limits:
        warnings.append(
            f"{pixels(limits)}: no muon was counted, so the density is a lower limit "
            f"({100 * choices.limit_confidence:g} % confidence) without an error, flagged "
            f"{int(Flag.LOWER_LIMIT)}; merge pixels, or count longer."
        )
    if bright:
        warnings.append(
            f"{pixels(bright)}: there is rock, yet the flux is that of the open sky or more, so "
            f"the density is 0, flagged {int(Flag.BRIGHT)}; check the pointing, the background "
            "and the normalisation."
        )
    if no_answer:
        warnings.append(
            f"{pixels(no_answer)}: no density of any matter explains the flux, or the ray is at "
            f"or below the horizon, so there is none, flagged {int(Flag.NO_ANSWER)}."
        )
    measurable = found.flags == Flag.MEASURED
    open_ended = int(np.count_nonzero(measurable & np.isnan(found.upper)))
    if not np.isfinite(found.lower[measurable]).any() and measurable.any():
        warnings.append(
            "The densities have no errors, because the measurement has none; give a muogram of "
            "its errors, or a flux-model uncertainty."
        )
    elif open_ended:
        warnings.append(
            f"{pixels(open_ended)}: the error of the measurement is as large as its value, so the "
            "density has no upper end and no error."
        )
    if seen.sky_counts is not None:
        empty = int(np.count_nonzero((seen.sky_counts == 0) & (thickness.values > 0)))
        if empty:
            warnings.append(
                f"{pixels(empty)}: no muon was counted in the open sky, so nothing is known."
            )
    apart = metres_apart(measured.values, thickness)
    if apart > _SAME_PLACE_M:
        warnings.append(
            f"The detectors of the measurement and of the thickness are {apart:.0f} m apart; the "
            "thickness must be that seen from where the muons were counted."
        )
    return tuple(warnings)
