"""What several muograms say about the opacity of a mountain."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..errors import MuyscError
from ..measurement.density import Flag
from ..measurement.regions import shares_of_pixels
from ..muogram import DOMAIN, Muogram
from ..progress import Progress, part, report, silent
from ..quantities import ERROR_SUFFIX
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.transmission import attenuate
from ..topography.dem import Dem
from ..topography.frame import from_wgs84, ground_height
from ..views import elevation_of, like, metres_apart, require_same_directions
from .measured import Measurement
from .measured_density import FLAG_MEANINGS, DensityChoices, density_behind
from .named_view import NamedView
from .station_data import RockSeen, StationData, rock_of_all

#: Quantities that an opacity follows from.
DATA_QUANTITIES = ("density", "opacity", "flux", "transmission", "thickness")

#: Detectors of a muogram and of its errors farther apart (m) than this are two.
_SAME_PLACE_M = 1.0

#: A detector farther (m) from where its height above ground puts it is on another terrain.
_SAME_GROUND_M = 20.0

#: Thicknesses of muogram and DEM that differ by more than this share are not of one terrain.
_SAME_TERRAIN = 0.05

#: Relative change of an opacity over which the slope of the flux is taken.
_PROBE = 0.01

#: Share of an error that is its own at least, whatever is taken off it.
_LEAST_OWN = 0.1

#: Flags of pixels whose flux says no opacity.
_NO_OPACITY = (Flag.LOWER_LIMIT, Flag.BRIGHT, Flag.NO_ANSWER, Flag.TOO_THIN, Flag.MIXED)


@dataclass(frozen=True)
class SurveyData:
    """Stations with their opacities, and where their rays are in rock."""

    stations: tuple[StationData, ...]
    rock: tuple[RockSeen, ...]
    #: What the muograms hold, one of `DATA_QUANTITIES`.
    quantity: str
    #: One sentence each.
    warnings: tuple[str, ...]


def read_survey(
    muograms: Sequence[NamedView],
    errors: Sequence[NamedView],
    dem: Dem,
    density: float | None = None,
    progress: Progress = silent,
) -> SurveyData:
    """Return opacities from muograms of one quantity.

    Parameters
    ----------
    muograms
        Of one of `DATA_QUANTITIES`.
    errors
        Standard errors of some of them: from the same detector in the same directions.
    dem
        Terrain, for the thickness that turns densities and fluxes into opacities.
    density
        g/cm³ that turns thicknesses into opacities where the file does not say it.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If the muograms do not go together or lack what is needed.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    quantity = _one_quantity(muograms)
    matched = _matched(muograms, errors, quantity)
    bare = bare_stations(muograms)
    rock = rock_of_all(bare, dem, part(progress, 0.0, 0.6))
    stations, warnings = [], list(_general_warnings(muograms, errors, quantity))
    for number, (one, station, seen) in enumerate(zip(muograms, bare, rock)):
        filled, more = _filled(one, matched[number], station, seen, density)
        stations.append(filled)
        warnings += [*_other_ground(one, station, dem), *more]
        report(progress, 0.6 + 0.4 * (number + 1) / len(muograms))
    return SurveyData(tuple(stations), tuple(rock), quantity, tuple(dict.fromkeys(warnings)))


def bare_stations(muograms: Sequence[NamedView]) -> list[StationData]:
    """Return places and directions of muograms, without opacities."""
    return [_station(one) for one in muograms]


def _one_quantity(muograms: Sequence[NamedView]) -> str:
    """Return the quantity of all muograms."""
    if not muograms:
        raise MuyscError("No muogram is given; choose those of one station or more.")
    found: dict[str, str] = {}
    for one in muograms:
        found.setdefault(one.view.quantity, one.name)
    if len(found) > 1:
        told = " and ".join(f"{quantity} ({name})" for quantity, name in found.items())
        raise MuyscError(
            f"The muograms hold different quantities: {told}; choose muograms of one quantity."
        )
    quantity = next(iter(found))
    if quantity not in DATA_QUANTITIES:
        raise MuyscError(
            f"The muograms hold {quantity}, and opacity follows from {', '.join(DATA_QUANTITIES)}; "
            "choose muograms of one of these."
        )
    return quantity


def _matched(
    muograms: Sequence[NamedView], errors: Sequence[NamedView], quantity: str
) -> list[NamedView | None]:
    """Return the errors of each muogram, from the same place in the same directions."""
    result: list[NamedView | None] = [None] * len(muograms)
    for error in errors:
        if error.view.quantity != quantity + ERROR_SUFFIX:
            raise MuyscError(
                f"{error.name} holds {error.view.quantity}, and the errors of muograms of "
                f"{quantity} are {quantity + ERROR_SUFFIX}; choose such rasters."
            )
        fits = [
            number
            for number, one in enumerate(muograms)
            if result[number] is None and _belong_together(one, error)
        ]
        if not fits:
            raise MuyscError(
                f"The errors {error.name} belong to none of the muograms: none has its detector "
                "and directions; leave them out or choose their muogram too."
            )
        result[fits[0]] = error
    if errors and None in result:
        name = muograms[result.index(None)].name
        raise MuyscError(
            f"{name} has no errors, which {len(errors)} of {len(muograms)} muograms have; choose "
            "the errors of all, or of none."
        )
    return result


def _belong_together(one: NamedView, error: NamedView) -> bool:
    if not metres_apart(one.view, error.view) < _SAME_PLACE_M:
        return False
    try:
        require_same_directions(error.view, "errors", one.view, one.view.quantity)
    except MuyscError:
        return False
    return True


def _general_warnings(
    muograms: Sequence[NamedView], errors: Sequence[NamedView], quantity: str
) -> tuple[str, ...]:
    if quantity == "thickness":
        return (
            "The muograms hold thickness, not what muons measured: the densities will show where "
            "the terrain is, of one density everywhere.",
        )
    if quantity == "density" and not errors and any("FLAGS" in one.view.metadata
                                                    for one in muograms):  # fmt: skip
        return (
            "The densities were measured and may be lower limits where no muon was counted; give "
            "their errors too, so that such pixels are left out.",
        )
    return ()


def _station(one: NamedView) -> StationData:
    """Return place and directions of a muogram."""
    view = one.view
    if isinstance(view, Muogram):
        azimuth, elevation = np.meshgrid(view.azimuth_deg, view.elevation_deg)
    else:
        azimuth, elevation = view.directions_deg()
    target = None
    if {"TARGET_LON", "TARGET_LAT", "TARGET_ELEVATION"} <= set(view.metadata):
        target = (
            one.number("TARGET_LON"), one.number("TARGET_LAT"),
            one.number("TARGET_ELEVATION"),
        )  # fmt: skip
    return StationData(
        one.name,
        one.number("DETECTOR_LON"),
        one.number("DETECTOR_LAT"),
        one.number("DETECTOR_ELEVATION"),
        azimuth.ravel(),
        elevation.ravel(),
        near_field_m=one.number("NEAR_FIELD") if "NEAR_FIELD" in view.metadata else 0.0,
        max_range_m=one.number("MAX_RANGE") if "MAX_RANGE" in view.metadata else None,
        target=target,
    )


def _filled(
    one: NamedView, errors: NamedView | None, station: StationData, seen: RockSeen,
    density: float | None,
) -> tuple[StationData, list[str]]:  # fmt: skip
    """Return a station with its opacities, and what to say about them."""
    view, thickness = one.view, seen.thickness_m
    values = view.values.ravel()
    spread = None if errors is None else errors.view.values.ravel()
    per_unit: np.ndarray | float = 1.0
    lost: Mapping[str, np.ndarray] = {}
    warnings: list[str] = []
    share: np.ndarray | None = None
    if view.quantity == "thickness":
        if "DENSITY" in view.metadata:
            density = one.number("DENSITY")
        if density is None:
            raise MuyscError(
                f"{one.name} holds thickness and lacks the metadata key DENSITY (domain {DOMAIN}), "
                "so that its opacity is not known; give a reference density or set the key."
            )
        per_unit = density * G_CM2_PER_M_WATER_EQUIVALENT
        warnings = _other_terrain(one, values, thickness)
    elif view.quantity in ("flux", "transmission"):
        values, spread, lost = _inverted(one, errors, thickness)
        per_unit = thickness * G_CM2_PER_M_WATER_EQUIVALENT
    elif view.quantity == "density":
        per_unit = thickness * G_CM2_PER_M_WATER_EQUIVALENT
        if spread is not None:
            warnings += _zeros_left_out(one, values, spread)
            share = _shares_if_merged(one, values, spread)
            spread, said = _without_common(one, values, spread, thickness)
            spread = spread / np.sqrt(share)
            warnings += said
    # In the sky, a density is not known and an opacity is.
    opacity = np.where(thickness == 0, 0.0, values * per_unit)
    error = None if spread is None else spread * per_unit
    return replace(station, opacity=opacity, error=error, share=share, lost=lost), warnings


def _shares_if_merged(one: NamedView, values: np.ndarray, errors: np.ndarray) -> np.ndarray:
    """Return shares of a datum, less than 1 where several pixels carry one measurement.

    The files do not say which pixels were merged. A region is known by its density and error,
    the same in each of its pixels; two regions that agree in both to the last digit count as
    one, which makes their errors too large rather than too small.
    """
    if "MINIMUM_COUNTS" not in one.view.metadata or one.number("MINIMUM_COUNTS") <= 0:
        return np.ones(values.shape)
    known = np.isfinite(values) & np.isfinite(errors)
    pairs = np.stack([values[known], errors[known]], axis=1)
    region = np.full(values.shape, -1)
    region[known] = np.unique(pairs, axis=0, return_inverse=True)[1].ravel()
    return shares_of_pixels(region)


def _without_common(
    one: NamedView, values: np.ndarray, errors: np.ndarray, thickness_m: np.ndarray
) -> tuple[np.ndarray, list[str]]:
    """Return errors of densities without the flux model's, which all pixels share.

    In `density` the uncertainty u of the flux is ρ u/|d ln I/d ln ϱ| of a density, in quadrature
    with the counting error. As independent noise it would average out, and it does not.
    """
    if "MODEL_UNCERTAINTY" not in one.view.metadata or one.number("MODEL_UNCERTAINTY") <= 0:
        return errors, []
    share, physics = one.number("MODEL_UNCERTAINTY"), one.physics()
    altitude = one.number("DETECTOR_ELEVATION") if physics.altitude_counts else 0.0
    opacity = np.where(values > 0, values * thickness_m, np.nan) * G_CM2_PER_M_WATER_EQUIVALENT
    elevation = elevation_of(one.view) * np.ones(one.view.values.shape)
    low, high = (
        np.log(attenuate(opacity * times, elevation.ravel(), physics, altitude).flux)
        for times in (1 - _PROBE, 1 + _PROBE)
    )
    common = values * share * 2 * _PROBE / np.abs(high - low)
    own = np.sqrt(np.maximum(errors**2 - common**2, (_LEAST_OWN * errors) ** 2))
    shift = float(np.nanmedian(common)) if np.isfinite(common).any() else 0.0
    return np.where(np.isfinite(common), own, errors), [
        f"The uncertainty of the flux model ({100 * share:g} %) is common to all pixels and is not "
        f"in the errors of a tomography; it shifts all densities together, by about {shift:.2g} "
        "g/cm³."
    ]


def _zeros_left_out(one: NamedView, values: np.ndarray, errors: np.ndarray) -> list[str]:
    """Return a warning where pixels without a muon are left out, which are the thickest."""
    limits = int(np.count_nonzero(np.isfinite(values) & ~np.isfinite(errors)))
    merged = "MINIMUM_COUNTS" in one.view.metadata and one.number("MINIMUM_COUNTS") > 0
    if not limits or merged or "FLAGS" not in one.view.metadata:
        return []
    return [
        f"{one.name}: {limits} pixels counted no muon and are left out, which makes thick rock "
        "look light; merge pixels in Density from a measured muogram (MINIMUM_COUNTS, such as "
        "20), or give the counts themselves (method counts)."
    ]


def _inverted(
    one: NamedView, errors: NamedView | None, thickness_m: np.ndarray
) -> tuple[np.ndarray, np.ndarray | None, Mapping[str, np.ndarray]]:
    """Return densities from flux or transmission, their errors, and why there is none."""
    view = one.view
    rock = like(view, "thickness", thickness_m.reshape(view.values.shape), view.metadata)
    found = density_behind(
        Measurement(view, None if errors is None else errors.view),
        rock,
        one.physics(),
        # What the flux model does not know is common to all pixels, and no noise of each.
        DensityChoices(model_uncertainty=0.0),
        one.number("DETECTOR_ELEVATION"),
    ).densities
    flags = found.flags.ravel()
    known = flags == Flag.MEASURED
    density = np.where(known, found.density.ravel(), np.nan)
    error = None if errors is None else np.where(known, found.error.ravel(), np.nan)
    return density, error, {FLAG_MEANINGS[flag]: flags == flag for flag in _NO_OPACITY}


def _other_ground(one: NamedView, station: StationData, dem: Dem) -> list[str]:
    """Return a warning where the detector is not as high above the DEM as its muogram says."""
    if "DETECTOR_HEIGHT" not in one.view.metadata:
        return []
    place = from_wgs84(dem.crs, station.longitude, station.latitude, dem.transformation)
    ground = ground_height(dem, *place, "detector")
    off = station.elevation_m - one.number("DETECTOR_HEIGHT") - ground
    if abs(off) < _SAME_GROUND_M:
        return []
    return [
        f"{one.name}: its detector stands {abs(off):.0f} m {'above' if off > 0 else 'below'} the "
        f"ground of {dem.name}; check that both are of one terrain and height system."
    ]


def _other_terrain(one: NamedView, values: np.ndarray, thickness: np.ndarray) -> list[str]:
    """Return a warning where muogram and DEM do not show the same mountain."""
    both = (values > 0) & (thickness > 0)
    if not both.any():
        return []
    apart = float(np.median(np.abs(values[both] / thickness[both] - 1)))
    if apart < _SAME_TERRAIN:
        return []
    return [
        f"{one.name}: its thickness and that through the elevation model differ by "
        f"{100 * apart:.2g} % (median); check that both are of one terrain."
    ]
