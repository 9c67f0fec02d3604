"""What a telescope measured, as muograms that go together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .errors import MuyscError
from .measurement.observation import (
    Observation,
    from_count_ratio,
    from_counts,
    from_values,
)
from .muogram import Muogram
from .quantities import ERROR_SUFFIX
from .radiography.counting import check_positive

#: Directions of two muograms may differ by this share of a pixel.
_SAME_PIXEL = 1e-3

_METRES_PER_DEGREE = 111_200.0


@dataclass(frozen=True)
class Measurement:
    """Muograms of a measurement: of counts, flux or transmission.

    Raises
    ------
    MuyscError
        If what is given does not go together.
    """

    #: Muogram of counts, flux or transmission.
    values: Muogram
    #: Standard errors of a flux or transmission.
    errors: Muogram | None = None
    #: Counts of the same telescope in the open sky.
    open_sky: Muogram | None = None
    #: Days of counting; None for what the muogram says (DAYS).
    days: float | None = None
    #: Days of counting in the open sky; None for what its muogram says (DAYS).
    open_sky_days: float | None = None
    #: cm² sr of a pixel; None for what the muogram says (ACCEPTANCE).
    acceptance_cm2_sr: float | None = None

    def __post_init__(self) -> None:
        for number, name in (
            (self.days, "exposure in days"),
            (self.open_sky_days, "exposure of the open sky in days"),
            (self.acceptance_cm2_sr, "acceptance in cm² sr"),
        ):
            if number is not None:
                check_positive(number, name)
        quantity = self.values.quantity
        if quantity not in ("counts", "flux", "transmission"):
            raise MuyscError(
                f"The measured muogram holds {quantity}, and density follows from counts, flux or "
                "transmission; choose a muogram of one of these."
            )
        if self.open_sky is not None:
            if quantity != "counts":
                raise MuyscError(
                    f"Counts in the open sky go with counts behind rock, and a muogram of "
                    f"{quantity} was given; leave them out."
                )
            require_quantity(self.open_sky, "counts", "The open-sky muogram")
            if self.open_sky.values.shape != self.values.values.shape:
                raise MuyscError(
                    f"The open-sky counts have {_grid(self.open_sky)} and the counts "
                    f"{_grid(self.values)}; give both of the same telescope pixels."
                )
        if self.errors is not None:
            if quantity == "counts":
                raise MuyscError(
                    "The errors of counts follow from the counts themselves; leave the muogram of "
                    "errors out."
                )
            require_quantity(self.errors, quantity + ERROR_SUFFIX, "The muogram of errors")
            require_same_directions(self.errors, "errors", self.values, quantity)

    def observation(self, confidence: float) -> Observation:
        """Return the flux seen, with limits of a confidence where there is no muon.

        Raises
        ------
        MuyscError
            If an exposure or the acceptance is not known, or a value cannot be used.
        """
        values, quantity = self.values.values, self.values.quantity
        elevation = self.values.elevation_deg[:, None]
        errors = None if self.errors is None else self.errors.values
        if quantity == "flux":
            return from_values(values, errors, confidence)
        if quantity == "transmission":
            return from_values(values, errors, confidence, elevation)
        days = _known(self.days, self.values, "DAYS", "exposure in days")
        if self.open_sky is None:
            acceptance = _known(
                self.acceptance_cm2_sr, self.values, "ACCEPTANCE", "acceptance in cm² sr"
            )
            return from_counts(values, days, acceptance, confidence)
        sky_days = _known(
            self.open_sky_days, self.open_sky, "DAYS", "exposure of the open sky in days"
        )
        if not (days > 0 and sky_days > 0):
            raise MuyscError(
                f"Exposures of {days:g} and {sky_days:g} days cannot be compared; give days above "
                "0 for both runs."
            )
        return from_count_ratio(
            values,
            self.open_sky.values,
            days / sky_days,
            self.open_sky.elevation_deg[:, None],
            confidence,
        )


def require_same_directions(one: Muogram, name: str, other: Muogram, other_name: str) -> None:
    """Refuse two muograms that are not on the same directions.

    Raises
    ------
    MuyscError
        With the directions of both.
    """
    same = one.values.shape == other.values.shape
    if same:
        for first, second in (
            (one.azimuth_deg, other.azimuth_deg),
            (one.elevation_deg, other.elevation_deg),
        ):
            step = abs(second[-1] - second[0]) / max(1, len(second) - 1) or 1.0
            # 350° and −10° are one direction.
            apart = (first - second + 180.0) % 360.0 - 180.0
            same &= bool(np.all(np.abs(apart) <= _SAME_PIXEL * step))
    if not same:
        raise MuyscError(
            f"The muogram of {name} has {_grid(one)} and that of {other_name} {_grid(other)}; "
            "make both on the same directions."
        )


def _grid(muogram: Muogram) -> str:
    azimuth, elevation = muogram.azimuth_deg, muogram.elevation_deg
    return (
        f"{len(azimuth)} × {len(elevation)} pixels, azimuth {azimuth[0]:g}° to "
        f"{azimuth[-1]:g}°, elevation {elevation[-1]:g}° to {elevation[0]:g}°"
    )


def require_quantity(muogram: Muogram, quantity: str, name: str) -> None:
    """Refuse a muogram of another quantity.

    Raises
    ------
    MuyscError
        With the quantity that it holds.
    """
    if muogram.quantity != quantity:
        raise MuyscError(
            f"{name} holds {muogram.quantity}; choose a muogram of the quantity {quantity}."
        )


def _known(value: float | None, muogram: Muogram, key: str, name: str) -> float:
    """Return a number that was given or that the muogram says."""
    if value is not None:
        return value
    if key not in muogram.metadata:
        raise MuyscError(
            f"The {name} is neither given nor in the counts' metadata (key {key}); give it."
        )
    return muogram.number(key)


def metres_apart(one: Muogram, other: Muogram) -> float:
    """Return the rough distance of two detectors (m), NaN where one is not known."""
    try:
        (lon, lat), (other_lon, other_lat) = (
            (muogram.number("DETECTOR_LON"), muogram.number("DETECTOR_LAT"))
            for muogram in (one, other)
        )
    except MuyscError:
        return float("nan")
    east = ((lon - other_lon + 180.0) % 360.0 - 180.0) * np.cos(np.radians(lat))
    return float(_METRES_PER_DEGREE * np.hypot(east, lat - other_lat))
