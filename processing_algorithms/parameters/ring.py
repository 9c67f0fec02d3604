"""Stations from a layer of points, or from a ring around the target."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsRasterLayer,
)

from ...muysc_qgis.survey.ring import Ring, RingPlaces, ring_places
from ...muysc_qgis.topography.dem import Dem
from ...muysc_qgis.workflows.sites import Site, file_stems
from .sites import read_sites, sites_parameters
from .values import given, number, read_count, read_number, read_optional, switch


def stations_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare the layer of sites, and the ring that stands in for it."""
    return [
        *sites_parameters("Sites (empty: a ring around the target)", optional=True),
        number(
            "RING_SITES", "Sites on the ring",
            "Give the number of sites on the ring, 1 or more, where no layer of sites is given.",
            12, 1, whole=True,
        ),
        number(
            "RING_RADIUS", "Radius of the ring (m)",
            "Give the horizontal distance of the sites from the target in m, above 0.",
            1000.0, 0,
        ),
        number(
            "RING_FROM", "Azimuth of the first site (°)",
            "Give the azimuth of the first site as seen from the target, in degrees clockwise from "
            "north. The others follow clockwise, evenly spaced.",
            0.0, -360, 360, advanced=True,
        ),
        number(
            "RING_TO", "Azimuth where the arc ends (°)",
            "Give the azimuth of the last site in degrees. A whole turn after the first is a full "
            "ring.",
            360.0, -360, 720, advanced=True,
        ),
        number(
            "RING_TOLERANCE", "Sites may be moved by (m)",
            "Give how far in m a site may be moved to flatter ground, 0 or more, less than the "
            "radius.",
            50.0, 0, advanced=True,
        ),
        number(
            "RING_SLOPE", "Steepest slope at a site (°, empty: any)",
            "Give the steepest ground in degrees, above 0 and up to 90, on which a site of the "
            "ring may lie. Sites without such ground nearby are left out.",
            None, 0, 90, advanced=True,
        ),
        switch(
            "RING_VIEW", "Sites of the ring see the target",
            "Whether sites are left out if ground rises above the line to the target on the "
            "nearest quarter of the way.",
            False, advanced=True,
        ),
    ]  # fmt: skip


def read_stations(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    dem: Dem,
    layer: QgsRasterLayer,
    target: tuple[float, float],
) -> tuple[list[Site], list[str], list[str]]:
    """Return the sites in the CRS of the DEM's layer, what was assumed, and who has no place.

    Raises
    ------
    MuyscError
        If the layer or the ring holds no place for a telescope.
    """
    read = (algorithm, parameters)
    if given(parameters, "SITES"):
        return read_sites(*read, context, dem, layer)
    ring = Ring(
        read_number(*read, "RING_RADIUS", context),
        read_count(*read, "RING_SITES", context),
        read_number(*read, "RING_FROM", context),
        read_number(*read, "RING_TO", context),
        read_number(*read, "RING_TOLERANCE", context),
        read_optional(*read, "RING_SLOPE", context),
        algorithm.parameterAsBool(parameters, "RING_VIEW", context),
    )
    places = ring_places(dem, target, ring)
    height = read_number(*read, "DETECTOR_HEIGHT", context)
    lost = [
        f"{count} of {ring.count} sites of the ring are left out: {why}."
        for why, count in places.missing.items()
    ]
    return _sites(places, ring, height), [], lost


def _sites(places: RingPlaces, ring: Ring, height_m: float) -> list[Site]:
    stems = file_stems([None] * ring.count)
    return [
        Site(stems[number], (float(x), float(y)), height_m, stems[number])
        for number, x, y in zip(places.number, places.x, places.y)
    ]
