"""Parameters of a telescope: its planes, where it points, how long it counts."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
)

from ...muysc_qgis.telescope.acceptance import FORMULAS
from ...muysc_qgis.telescope.directions import Pointing
from ...muysc_qgis.telescope.geometry import MAXIMUM_BARS, TelescopeGeometry
from ...muysc_qgis.telescope.planning import STATISTICS, CountingPlan
from ...muysc_qgis.telescope.presets import CUSTOM, PRESETS, telescope_of
from ...muysc_qgis.topography.sight import Sight
from .values import choice, number, read_choice, read_count, read_number, read_optional

#: The choice of radiography for an acceptance given as a number.
NONE = "none"

#: Parameters that a preset replaces.
SIZES = ("BARS_X", "BARS_Y", "PIXEL_SIZE", "SEPARATION", "PLANES")


def geometry_parameters(optional: bool = False) -> list[QgsProcessingParameterDefinition]:
    """Declare the telescope; `optional` adds the choice of none and makes all advanced."""
    lead = (
        "A telescope in place of ACCEPTANCE: each pixel then has the acceptance of the telescope "
        f"in its direction, and none outside its field of view. {NONE} takes ACCEPTANCE. "
        if optional
        else ""
    )
    built = "; ".join(
        f"{preset.name}: {preset.geometry.bars_x} × {preset.geometry.bars_y} bars of "
        f"{preset.geometry.pixel_size_cm:g} cm, {preset.geometry.separation_cm:g} cm"
        for preset in PRESETS.values()
    )
    return [
        choice(
            "PRESET", "Telescope",
            f"{lead}A telescope that was built, or {CUSTOM} for the numbers below. A preset wins "
            f"over numbers, and the log says which were not used. {built}.",
            [*([NONE] if optional else []), CUSTOM, *PRESETS],
            NONE if optional else "mute", advanced=optional,
        ),
        number(
            "BARS_X", "Bars across (custom telescope)",
            f"Give the number of bars side by side, 1 to {MAXIMUM_BARS}.",
            None, 1, MAXIMUM_BARS, whole=True, advanced=optional,
        ),
        number(
            "BARS_Y", "Bars up (empty: as many as across)",
            f"Give the number of bars one above another, 1 to {MAXIMUM_BARS}.",
            None, 1, MAXIMUM_BARS, whole=True, advanced=True,
        ),
        number(
            "PIXEL_SIZE", "Width of a bar (cm, custom telescope)",
            "Give the width of a bar in cm, above 0: the side of a pixel.",
            None, 0, advanced=optional,
        ),
        number(
            "SEPARATION", "Separation of the planes (cm, custom telescope)",
            "Give the distance between the front and the back plane in cm, above 0.",
            None, 0, advanced=optional,
        ),
        *(
            []
            if optional
            else [
                number(
                    "PLANES", "Planes (empty: 2)",
                    "Give the number of planes, 2 to 20, the outer two included. Those in between "
                    "change neither directions nor acceptance: a straight track through the outer "
                    "ones crosses them too. They are drawn.",
                    None, 2, 20, whole=True, advanced=True,
                )
            ]
        ),
        choice(
            "FORMULA", "Acceptance formula",
            "exact: full integral over two pixels. paper: pixel area squared over the squared "
            "distance, as MUYSC was published; it leaves out the obliquity of the planes and is "
            "too high at large angles, by 7 % to 47 % in total.",
            list(FORMULAS), "exact", advanced=True,
        ),
    ]  # fmt: skip


def read_geometry(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> tuple[TelescopeGeometry | None, str, tuple[str, ...]]:
    """Return the telescope (None for none), the formula, and numbers that were not used.

    Raises
    ------
    MuyscError
        If a value is missing or cannot be used.
    """
    read = (algorithm, parameters)
    preset = read_choice(*read, "PRESET", context)
    formula = read_choice(*read, "FORMULA", context)
    bars_x, bars_y, size, separation, planes = (
        None if algorithm.parameterDefinition(name) is None
        else read_optional(*read, name, context)
        for name in SIZES
    )  # fmt: skip
    if preset == NONE:
        notes = tuple(
            f"{name} is not used, because no telescope is chosen; choose the PRESET {CUSTOM}."
            for name, value in zip(SIZES, (bars_x, bars_y, size, separation))
            if value is not None
        )
        return None, formula, notes
    geometry, notes = telescope_of(preset, bars_x, bars_y, size, separation, planes)
    return geometry, formula, notes


def pointing_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare where the telescope points, other than at the target."""
    return [
        number(
            "BORESIGHT_AZIMUTH", "Boresight azimuth (°, empty: towards the target)",
            "Give the azimuth of the telescope's axis in degrees clockwise from true north, −360 "
            "to 360. Empty points at the target.",
            None, -360, 360, advanced=True,
        ),
        number(
            "BORESIGHT_ELEVATION", "Boresight elevation (°, empty: towards the target)",
            "Give the elevation of the telescope's axis above the horizontal in degrees, −90 to "
            "90. Empty points at the target.",
            None, -90, 90, advanced=True,
        ),
        number(
            "ROLL", "Roll (°)",
            "Give the angle in degrees, −360 to 360, by which the telescope is turned clockwise "
            "about its axis, seen looking along it. With 0 its bars are level.",
            0.0, -360, 360, advanced=True,
        ),
    ]  # fmt: skip


def read_pointing(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    sight: Sight,
) -> Pointing:
    """Return where the telescope points.

    Raises
    ------
    MuyscError
        If an angle cannot be used.
    """
    read = (algorithm, parameters)
    azimuth = read_optional(*read, "BORESIGHT_AZIMUTH", context)
    elevation = read_optional(*read, "BORESIGHT_ELEVATION", context)
    return Pointing(
        sight.boresight_azimuth_deg if azimuth is None else azimuth,
        sight.boresight_elevation_deg if elevation is None else elevation,
        read_number(*read, "ROLL", context),
    )


def plan_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare how long to count and what is to be seen."""
    return [
        number(
            "DAYS", "Days of counting (days)", "Give the time of counting in days, above 0.",
            30.0, 0,
        ),
        number(
            "MUONS", "Muons along a trajectory",
            "Give the number of muons wanted along each trajectory, above 0, for the exposure "
            "time. 10 muons give the flux to about 32 %, 100 to 10 %.",
            10.0, 0,
        ),
        number(
            "SIGMA", "Significance (standard deviations)",
            "Give the significance in standard deviations with which a contrast is to be seen, "
            "above 0 and up to 30; one-sided.",
            3.0, 0, 30,
        ),
        number(
            "CONTRAST", "Density contrast to see (%)",
            "Give the change of the mean density along the whole path in percent, above −100 and "
            "not 0: −10 for rock that is 10 % lighter.",
            -10.0, -100,
        ),
        number(
            "MERGE", "Trajectories merged along a side",
            "Give an odd number of trajectories to take together across and up, from 1: larger "
            "bins count more muons and see less detail.",
            1, 1, whole=True,
        ),
        number(
            "EFFICIENCY", "Efficiency",
            "Give the share of the muons through all planes that is recorded, above 0 and up to 1.",
            1.0, 0, 1, advanced=True,
        ),
        choice(
            "STATISTICS", "Statistics of the contrast",
            "poisson: exact, for few counts as for many. lesparre: the feasibility formula of "
            "Lesparre et al. (2010), for many counts. They agree from about a hundred counts.",
            list(STATISTICS), "poisson", advanced=True,
        ),
        number(
            "RAYS_PER_BAR", "Rays for each bar",
            "Give the number of rays along a side, 1 to 50, for each step from one trajectory to "
            "the next. Errors fall with its square; where they matter beside those of counting, "
            "up to four times as many are traced.",
            3.0, 1, 50, advanced=True,
        ),
    ]  # fmt: skip


def read_plan(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> CountingPlan:
    """Return how long to count and what is to be seen.

    Raises
    ------
    MuyscError
        If a value cannot be used.
    """
    read = (algorithm, parameters)
    days, muons, sigma, contrast, efficiency, rays = (
        read_number(*read, name, context)
        for name in ("DAYS", "MUONS", "SIGMA", "CONTRAST", "EFFICIENCY", "RAYS_PER_BAR")
    )
    return CountingPlan(
        days, muons, sigma, contrast, read_count(*read, "MERGE", context), efficiency,
        read_choice(*read, "STATISTICS", context), rays,
    )  # fmt: skip
