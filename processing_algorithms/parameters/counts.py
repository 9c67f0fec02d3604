"""Parameters of how densities are found from counts."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
)

from ...muysc_qgis.tomography.counting import CountPriors
from ...muysc_qgis.workflows.count_tomography import INNER, CountChoices
from ...muysc_qgis.workflows.tomography import TomographyChoices
from .values import number, read_number


def count_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare what is known before of all that counts depend on beside densities."""
    priors = CountPriors(1.0)
    return [
        number(
            "MEAN_DEVIATION", "Error of the reference density (g/cm³)",
            "Give how far the mean density may be from the reference before any muon, in g/cm³, 0 "
            "or more; for counts, where it is estimated with the densities.",
            priors.mean_deviation, 0, advanced=True,
        ),
        number(
            "STATION_ERROR", "Error of each station's counts (%)",
            "Give the standard error, in %, of the factor between what a station counts and what "
            "acceptance, efficiency and days say, 0 or more; for counts, which estimate it.",
            100 * priors.station, 0, 1000, advanced=True,
        ),
        number(
            "FLUX_ERROR", "Error of the flux (%)",
            "Give the standard error, in %, of the factor of the flux model that all stations "
            "share, 0 or more; for counts, which estimate it.",
            100 * priors.flux, 0, 1000, advanced=True,
        ),
        number(
            "POINTING_ERROR", "Error of the boresights (°)",
            "Give the standard error, in °, of azimuth and elevation of each boresight, 0 or more; "
            "for counts, which estimate both.",
            priors.azimuth_deg, 0, 10, advanced=True,
        ),
        number(
            "TERRAIN_ERROR", "Error of the terrain's heights (m)",
            "Give the standard error of the elevation model's heights in m, 0 or more; for counts, "
            "which estimate where it is too high or too low. About 5 m for SRTM.",
            TERRAIN_ERROR_M, 0, 1000, advanced=True,
        ),
        number(
            "TERRAIN_LENGTH", "Distance over which terrain errors are alike (m)",
            "Give the correlation length of the errors of the terrain's heights in m, above 0.",
            priors.terrain_length_m, 1, 100_000, advanced=True,
        ),
    ]  # fmt: skip


#: Error of the terrain's heights unless the user says otherwise, m.
TERRAIN_ERROR_M = 2.0


def read_counting(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    choices: TomographyChoices,
) -> CountChoices:
    """Return how densities are to be found from counts.

    Parameters
    ----------
    choices
        What holds for all methods.

    Raises
    ------
    MuyscError
        If a value cannot be used.
    """

    def value(name: str) -> float:
        return read_number(algorithm, parameters, name, context)

    options = choices.options
    mean = choices.reference_density
    priors = CountPriors(
        1e-3 + max(options.highest or 2.65, 1e-2) / 2 if mean is None else mean,
        value("MEAN_DEVIATION"),
        options.prior_deviation,
        options.correlation_length_m,
        value("STATION_ERROR") / 100,
        value("FLUX_ERROR") / 100,
        azimuth_deg=value("POINTING_ERROR"),
        elevation_deg=value("POINTING_ERROR"),
        terrain_m=value("TERRAIN_ERROR"),
        terrain_length_m=value("TERRAIN_LENGTH"),
        lowest=0.0 if options.nonnegative else None,
        highest=options.highest,
    )
    return CountChoices(
        mean,
        priors,
        choices.length_error_m,
        options.iterations or INNER,
        options.deviation,
        choices.memory_bytes,
    )
