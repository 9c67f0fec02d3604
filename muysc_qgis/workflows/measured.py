"""What a telescope measured, as muograms that go together."""

from __future__ import annotations

from dataclasses import dataclass

from ..errors import MuyscError
from ..measurement.observation import (
    Observation,
    from_count_ratio,
    from_counts,
    from_values,
)
from ..quantities import ERROR_SUFFIX
from ..radiography.counting import check_positive
from ..views import (
    View,
    elevation_of,
    require_quantity,
    require_same_directions,
    require_same_pixels,
)
from .view_rays import acceptance_of

#: What counts say that were not counted but are expected (metadata key COUNTED).
EXPECTED = "expected"


@dataclass(frozen=True)
class Measurement:
    """Muograms of a measurement: of counts, flux or transmission.

    Raises
    ------
    MuyscError
        If what is given does not go together.
    """

    #: Muogram of counts, flux or transmission.
    values: View
    #: Standard errors of a flux or transmission.
    errors: View | None = None
    #: Counts of the same telescope in the open sky.
    open_sky: View | None = None
    #: Days of counting; None for what the muogram says (DAYS).
    days: float | None = None
    #: Days of counting in the open sky; None for what its muogram says (DAYS).
    open_sky_days: float | None = None
    #: cm² sr of a pixel, one for all or a raster on the same pixels; None for what the
    #: muogram says (ACCEPTANCE, or the telescope that it describes).
    acceptance_cm2_sr: float | View | None = None

    def __post_init__(self) -> None:
        for number, name in (
            (self.days, "exposure in days"),
            (self.open_sky_days, "exposure of the open sky in days"),
            (self.acceptance_cm2_sr, "acceptance in cm² sr"),
        ):
            if isinstance(number, (float, int)):
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
            require_quantity(self.open_sky, ("counts", "open_sky_counts"), "The open-sky muogram")
            require_same_pixels(self.open_sky, "open-sky counts", self.values, "counts")
        if not isinstance(self.acceptance_cm2_sr, (float, int, type(None))):
            require_quantity(self.acceptance_cm2_sr, ("acceptance",), "The raster of acceptances")
            require_same_pixels(self.acceptance_cm2_sr, "acceptances", self.values, "counts")
        if self.errors is not None:
            if quantity == "counts":
                raise MuyscError(
                    "The errors of counts follow from the counts themselves; leave the muogram of "
                    "errors out."
                )
            require_quantity(self.errors, (quantity + ERROR_SUFFIX,), "The muogram of errors")
            require_same_directions(self.errors, "errors", self.values, quantity)

    def observation(self, confidence: float) -> Observation:
        """Return the flux seen, with limits of a confidence where there is no muon.

        Raises
        ------
        MuyscError
            If an exposure or the acceptance is not known, or a value cannot be used.
        """
        values, quantity = self.values.values, self.values.quantity
        errors = None if self.errors is None else self.errors.values
        if quantity == "flux":
            return from_values(values, errors, confidence)
        if quantity == "transmission":
            return from_values(values, errors, confidence, elevation_of(self.values))
        days = _known(self.days, self.values, "DAYS", "exposure in days")
        if self.open_sky is None:
            acceptance = self.acceptance_cm2_sr
            expected = self.values.metadata.get("COUNTED") == EXPECTED
            if acceptance is None and "ACCEPTANCE" not in self.values.metadata:
                told = acceptance_of(self.values)
                if told is not None:
                    return from_counts(values, days, told, confidence, expected)
            if isinstance(acceptance, (float, int, type(None))):
                each = _known(acceptance, self.values, "ACCEPTANCE", "acceptance in cm² sr")
                return from_counts(values, days, each, confidence, expected)
            return from_counts(values, days, acceptance.values, confidence, expected)
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
            elevation_of(self.open_sky),
            confidence,
        )


def _known(value: float | None, view: View, key: str, name: str) -> float:
    """Return a number that was given or that the counts say."""
    if value is not None:
        return value
    if key not in view.metadata:
        raise MuyscError(
            f"The {name} is neither given nor in the counts' metadata (key {key}); give it here, "
            "or when the counts are imported."
        )
    return view.number(key)
