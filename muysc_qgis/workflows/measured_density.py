"""From measured muograms to density: what is read, what comes out, what to say about it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..errors import MuyscError
from ..forward.sub_rays import SubRays, error_in_counting_errors
from ..measurement.density import (
    Densities,
    Flag,
    check_minimum,
    measure_density,
    model_densities,
)
from ..measurement.judgement import SkyCheck
from ..measurement.mean import Mean, mean_density
from ..measurement.mixed import BOX_VARIANCE, HAT_VARIANCE, beside_sky, mixed_pixels
from ..measurement.observation import Observation, check_transmission
from ..measurement.scene import Scene, check_uncertainty
from ..progress import Progress, part, report, silent
from ..radiography.settings import Physics
from ..trajectories import TrajectoryMap
from ..views import (
    View,
    elevation_of,
    like,
    metres_apart,
    require_quantity,
    require_same_directions,
)
from .density_warnings import Judged
from .measured import Measurement
from .provenance import altitude_of, describe_physics
from .view_rays import Ground, see_through

#: Detectors of two muograms farther apart than this (m) are worth a warning.
_SAME_PLACE_M = 30.0

#: Share of the progress bar for the model chosen, where all others follow.
_OWN = 0.25

#: Share of the progress bar when all rays are traced.
_TRACED = 0.4

#: Relative error of a flux that its rays need not be better than.
_BEST = 0.01

#: What the values of a raster of flags mean, as its metadata says it.
FLAG_MEANINGS = {
    Flag.MEASURED: "density measured",
    Flag.SKY: "no rock",
    Flag.LOWER_LIMIT: "no muon counted: density is a lower limit",
    Flag.BRIGHT: "as bright as the open sky: density 0",
    Flag.NOT_MEASURED: "measurement or thickness missing",
    Flag.NO_ANSWER: "no density explains the flux",
    Flag.TOO_THIN: "too little rock to dim the flux",
    Flag.MIXED: "skyline or rock of many lengths in it, of which one ray says too little",
}

#: Flags of pixels of which nothing is known.
UNKNOWN = (Flag.NOT_MEASURED, Flag.NO_ANSWER, Flag.TOO_THIN, Flag.MIXED)

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

    #: Relative uncertainty of the flux model, None for what the model says of itself.
    model_uncertainty: float | None = None
    #: Counts up to which neighbouring pixels are merged, 0 for no merging.
    minimum_counts: float = 0.0
    #: Confidence of the lower limits, between 0.5 and 1.
    limit_confidence: float = 0.95
    #: Whether the spread over the flux models is wanted.
    model_spread: bool = False
    #: Whether pixels are left out of which one ray says too little; counts without terrain.
    single_rays_checked: bool = True

    def __post_init__(self) -> None:
        if self.model_uncertainty is not None:
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
    #: χ² per datum of the densities about their mean, NaN where it is not known.
    chi_squared: float
    #: What the pixels without rock saw over what they should have seen.
    sky: SkyCheck

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
    thickness: View | None,
    physics: Physics,
    choices: DensityChoices,
    altitude_m: float | None = None,
    progress: Progress = silent,
    ground: Ground | None = None,
) -> DensityResult:
    """Return the mean density of the rock that each pixel of a measured muogram sees.

    Parameters
    ----------
    measured
        What was measured.
    thickness
        Rock thickness on the same directions; needed where there is no terrain, and not used
        where there is.
    physics
        How muons are produced and stopped; its density is not used.
    choices
        Uncertainty, merging, limits.
    altitude_m
        Altitude of the detector in m, None for DETECTOR_ELEVATION of the measured muogram, or
        of the thickness where that lacks it; with terrain see `see_through`.
    progress
        Told the share done.
    ground
        Terrain that every pixel is seen through with all its rays.

    Raises
    ------
    MuyscError
        If the muograms do not go together or a value cannot be used.
    Cancelled
        If `progress` asks for a stop.
    """
    report(progress, 0.0)
    start = 0.0
    if ground is not None:
        start = _TRACED
        scene, kept, notes = _through_terrain(
            measured, physics, choices, altitude_m, ground, part(progress, 0.0, start)
        )
        basis = measured.values
    elif thickness is not None:
        scene, kept, notes = _through_thickness(measured, thickness, physics, choices, altitude_m)
        basis = thickness
    else:
        raise MuyscError(
            "Neither a DEM nor a muogram of the rock's thickness is given; give DEM, or THICKNESS "
            "on the directions of the measurement."
        )
    if choices.model_uncertainty is None:
        scene = replace(scene, model_uncertainty=scene.flux_error)
    rest = part(progress, start, 1.0)
    if measured.values.quantity == "transmission":
        errors = None if measured.errors is None else measured.errors.values
        check_transmission(measured.values.values, errors, scene.thickness_m)
    seen = measured.observation(choices.limit_confidence)
    report(rest, 0.0)
    own = _OWN if choices.model_spread else 1.0
    found = measure_density(seen, scene, choices.minimum_counts, part(rest, 0.0, 0.4 * own))
    if ground is None and choices.single_rays_checked:
        scene, found = _without_mixed(
            seen, scene, found, basis, choices, part(rest, 0.4 * own, 0.7 * own)
        )
    mean = mean_density(seen, scene, found, part(rest, 0.7 * own, 0.9 * own))
    told = Judged(
        seen,
        scene,
        found,
        mean,
        choices.limit_confidence,
        scene.model_uncertainty,
        part(rest, 0.9 * own, own),
    )
    warnings = (*notes, *told.warnings())
    values = {
        "thickness": scene.thickness_m,
        "opacity": found.opacity(scene.thickness_m),
        "density": found.density,
        "density_error": found.error,
        "density_lower": found.lower,
        "density_upper": found.upper,
        "density_flags": found.flags.astype(float),
        "density_regions": _region_numbers(found),
    }
    if choices.model_spread:
        spread = model_densities(seen, scene, choices.minimum_counts, part(rest, own, 1.0))
        values |= {"density_minimum": spread.minimum, "density_maximum": spread.maximum}
    report(progress, 1.0)
    kept = {key: value for key, value in kept.items() if key not in _NOT_MEASURED}
    metadata = {**kept, **_metadata(measured, scene, choices, mean)}
    muograms = {name: like(basis, name, array, metadata) for name, array in values.items()}
    return DensityResult(muograms, found, mean, warnings, told.chi_squared, told.sky)


def _through_thickness(
    measured: Measurement,
    thickness: View,
    physics: Physics,
    choices: DensityChoices,
    altitude_m: float | None,
) -> tuple[Scene, Mapping[str, str | float], tuple[str, ...]]:
    """Return what is seen by one ray a pixel, the metadata that stay, and what to say."""
    require_quantity(thickness, ("thickness",), "The thickness muogram")
    require_same_directions(measured.values, measured.values.quantity, thickness, "thickness")
    placed = measured.values if "DETECTOR_ELEVATION" in measured.values.metadata else thickness
    mixed = None
    if choices.single_rays_checked:
        # A trajectory reaches as far as the middles of its neighbours.
        reach = 2 if isinstance(thickness, TrajectoryMap) else 1
        mixed = beside_sky(thickness.values, reach)
    scene = Scene(
        thickness.values,
        elevation_of(thickness),
        physics,
        altitude_of(placed, physics, altitude_m),
        choices.model_uncertainty or 0.0,
        mixed=mixed,
    )
    notes: tuple[str, ...] = ()
    apart = metres_apart(measured.values, thickness)
    if apart > _SAME_PLACE_M:
        notes = (
            f"The detectors of the measurement and of the thickness are {apart:.0f} m apart; the "
            "thickness must be that seen from where the muons were counted.",
        )
    return scene, thickness.metadata, notes


def _through_terrain(
    measured: Measurement,
    physics: Physics,
    choices: DensityChoices,
    altitude_m: float | None,
    ground: Ground,
    progress: Progress,
) -> tuple[Scene, Mapping[str, str | float], tuple[str, ...]]:
    """Return what is seen by all rays of each pixel, the metadata, and what to say."""
    seen = measured.observation(choices.limit_confidence)

    def altitude(eye_m: float) -> float:
        return eye_m if physics.altitude_counts else 0.0

    def excess(rays: SubRays, eye_m: float) -> np.ndarray:
        muons = rays.muons(physics.density, physics, altitude(eye_m))
        flux, error = rays.mean_and_error(muons.flux)
        if seen.exposure is not None and seen.sky_elevation_deg is None:
            return error_in_counting_errors(flux, error, seen.exposure)
        relative = (seen.ln_down + seen.ln_up) / 2.0
        return np.asarray(error / flux / np.where(relative > _BEST, relative, _BEST))

    through = see_through(measured.values, ground, altitude_m, excess, progress)
    rays = through.rays
    scene = Scene(
        rays.mean_thickness_m,
        np.broadcast_to(elevation_of(measured.values), rays.shape),
        physics,
        altitude(through.eye_m),
        choices.model_uncertainty or 0.0,
        rays,
    )
    place: dict[str, str | float] = {
        "DETECTOR_LON": through.detector_wgs84[0],
        "DETECTOR_LAT": through.detector_wgs84[1],
        "DETECTOR_ELEVATION": through.eye_m,
        "DEM": ground.dem.name,
    }
    return scene, {**measured.values.metadata, **place}, through.warnings


def _without_mixed(
    seen: Observation,
    scene: Scene,
    found: Densities,
    view: View,
    choices: DensityChoices,
    progress: Progress,
) -> tuple[Scene, Densities]:
    """Leave out the pixels whose one ray makes them worse than their error."""
    variance = HAT_VARIANCE if isinstance(view, TrajectoryMap) else BOX_VARIANCE
    more = mixed_pixels(found, scene, variance, part(progress, 0.0, 0.2))
    if not more.any():
        return scene, found
    scene = scene.without(more)
    return scene, measure_density(seen, scene, choices.minimum_counts, part(progress, 0.2, 1.0))


def _region_numbers(found: Densities) -> np.ndarray:
    """Return the number of each pixel's region from 1, NaN for none."""
    measured = found.flags == Flag.MEASURED
    number = (
        np.cumsum(measured).reshape(measured.shape) if found.region is None else found.region + 1
    )
    inside = measured if found.region is None else found.region >= 0
    return np.where(inside, number, np.nan)


def _metadata(
    measured: Measurement, scene: Scene, choices: DensityChoices, mean: Mean
) -> dict[str, str | float]:
    physics = describe_physics(scene.physics)
    used = {key: value for key, value in physics.items() if key != "DENSITY"}
    return {
        **used,
        "MEASURED": measured.values.quantity,
        "MODEL_UNCERTAINTY": scene.model_uncertainty,
        "MINIMUM_COUNTS": choices.minimum_counts,
        "LIMIT_CONFIDENCE": choices.limit_confidence,
        "MEAN_DENSITY": mean.density,
        "MEAN_DENSITY_ERROR": mean.error,
        "FLAGS": "; ".join(f"{int(flag)} {text}" for flag, text in FLAG_MEANINGS.items()),
    }
