"""How long muons are counted, with what, and how the counts are read."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
)

from ...muysc_qgis.telescope.acceptance import trajectories
from ...muysc_qgis.workflows.simulated_counts import Campaign
from ...muysc_qgis.workflows.simulation import Telescope
from .physics import telescope_parameters
from .telescope import read_geometry
from .values import number, read_count, read_number, switch


def campaign_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare the time of counting, the telescope and the noise."""
    telescope = [one for one in telescope_parameters() if one.name() != "MUONS"]
    telescope[0].setHelp(
        "Give the acceptance of one pixel in cm² sr, above 0. Counts grow with it and with the "
        "days."
    )
    return [
        number(
            "DAYS", "Days of counting",
            "Give the days that each station counts, above 0.",
            100.0, 0,
        ),
        *telescope,
        switch(
            "NOISE", "Counting noise",
            "Whether muons are counted. If not, every opacity is known, with the error given "
            "below: what the geometry alone can show.",
            True,
        ),
        number(
            "MINIMUM_COUNTS", "Merge pixels up to this many counts",
            "Give the counts up to which neighbouring pixels are merged, 0 or more; 0 merges none. "
            "Pixels without a muon say no density, and leaving them out would make the rock look "
            "lighter than it is.",
            20.0, 0, advanced=True,
        ),
        number(
            "SEED", "Seed of the noise",
            "Give a whole number, 0 or more; the same seed draws the same counts.",
            1, 0, advanced=True, whole=True,
        ),
    ]  # fmt: skip


def survey_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare what a survey that counts along trajectories needs beside."""
    return [
        number(
            "EFFICIENCY", "Detection efficiency (%)",
            "Give the share of the muons that are counted, in %, above 0 and up to 100; for the "
            "method counts.",
            100.0, 0, 100, advanced=True,
        ),
        number(
            "DRAWS", "Surveys drawn",
            "Give how many surveys are drawn for the verdict of the method counts, 1 to 1000; the "
            "densities are those of the first.",
            3, 1, 1000, advanced=True, whole=True,
        ),
    ]  # fmt: skip


def read_campaign(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Campaign:
    """Return how muons are counted.

    Raises
    ------
    MuyscError
        If a value cannot be used.
    """
    read = (algorithm, parameters)
    geometry, formula, notes = read_geometry(*read, context)
    telescope = Telescope(
        read_number(*read, "ACCEPTANCE", context),
        trajectories=None if geometry is None else trajectories(geometry, formula),
        notes=notes,
    )
    return Campaign(
        read_number(*read, "DAYS", context),
        telescope,
        read_number(*read, "MINIMUM_COUNTS", context),
        algorithm.parameterAsBool(parameters, "NOISE", context),
        read_count(*read, "SEED", context),
    )
