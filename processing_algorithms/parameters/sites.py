"""A point layer of sites for telescopes."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from qgis.core import (
    QgsFeature,
    QgsFeatureSource,
    QgsGeometry,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsRasterLayer,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.topography.dem import Dem
from ...muysc_qgis.workflows.sites import Site, file_stems
from ..compat import NUMERIC_FIELD, VECTOR_POINT
from .transformation import Passage, passage
from .values import explained, given, read_number
from .view import detector_height_parameter


def sites_parameters(
    label: str = "Sites", optional: bool = False
) -> list[QgsProcessingParameterDefinition]:
    """Declare the layer of sites, its fields, and the height where it has none."""
    return [
        explained(
            QgsProcessingParameterFeatureSource("SITES", label, [VECTOR_POINT], None, optional),
            "Layer of points where telescopes stand, on the DEM, in any coordinate reference "
            "system. Sites off the DEM are skipped with a warning.",
        ),
        explained(
            QgsProcessingParameterField("NAME_FIELD", "Field of the names", None, "SITES",
                                        optional=True),
            "Field with the name of each site, which its files begin with. Empty: site_01, "
            "site_02 and so on, by the order in the layer.",
        ),
        detector_height_parameter(),
        explained(
            QgsProcessingParameterField("HEIGHT_FIELD", "Field of the heights above ground", None,
                                        "SITES", NUMERIC_FIELD, optional=True),
            "Field with the height of each telescope above the ground in m, −10000 to 10000. Where "
            "it is empty the detector height above counts.",
            advanced=True,
        ),
    ]  # fmt: skip


def read_sites(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    dem: Dem,
    layer: QgsRasterLayer,
) -> tuple[list[Site], list[str], list[str]]:
    """Return the sites in the CRS of the DEM's layer, what was assumed, and who has no place.

    The last is a sentence for each point that cannot be brought on the map.

    Raises
    ------
    MuyscError
        If there is no layer of points, or a field does not exist or hold numbers.
    """
    read = (algorithm, parameters)
    source = point_source(*read, "SITES", context)
    name_field = _field(*read, "NAME_FIELD", context, source)
    height_field = _field(*read, "HEIGHT_FIELD", context, source)
    height = read_number(*read, "DETECTOR_HEIGHT", context)
    way, notes = way_to(dem, layer, source, "SITES", context)
    # Each point of a multipoint is a site.
    places = [
        (feature, point)
        for feature in source.getFeatures()
        for point in points_of(feature.geometry(), way)
    ]
    names = [_text(feature, name_field) for feature, _ in places]
    sites, lost = [], []
    for (feature, point), name, stem in zip(places, names, file_stems(names)):
        if point is None:
            lost.append(f"Site {name or stem} was skipped because it has no place on the map.")
            continue
        own = _number(feature, height_field, name or stem)
        sites.append(Site(name or stem, point, height if own is None else own, stem))
    return sites, notes, lost


def _field(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
    source: QgsFeatureSource,
) -> int | None:
    """Return the index of a field that is asked for."""
    if not given(parameters, name):
        return None
    wanted = algorithm.parameterAsString(parameters, name, context)
    index = int(source.fields().lookupField(wanted))
    if index < 0:
        known = ", ".join(field.name() for field in source.fields())
        raise MuyscError(f"{name} is “{wanted}”, and SITES has only the fields {known}.")
    return index


def _text(feature: QgsFeature, index: int | None) -> str | None:
    value = None if index is None else feature.attribute(index)
    # A null of QGIS is no None, but reads like nothing.
    text = "" if value is None else str(value).strip()
    return None if text in ("", "NULL") else text


def _number(feature: QgsFeature, index: int | None, name: str) -> float | None:
    text = _text(feature, index)
    if text is None:
        return None
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise MuyscError(
            f"The height of site {name} is “{text}”, which is not a finite number; correct it or "
            "leave it empty."
        )
    return value


def points_of(geometry: QgsGeometry, way: Passage) -> list[tuple[float, float] | None]:
    """Return the points of a geometry in the DEM's CRS, None for one that has no place."""
    return placed(geometry.vertices(), way) or [None]


def placed(points: Iterable[Any], way: Passage) -> list[tuple[float, float] | None]:
    """Return points of QGIS in the DEM's CRS, None for one that has no place there."""
    return [way.to_dem(point.x(), point.y()) for point in points]


def point_source(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    name: str,
    context: QgsProcessingContext,
) -> QgsFeatureSource:
    """Return a layer of points that is not empty.

    Raises
    ------
    MuyscError
        If there is none.
    """
    if not given(parameters, name):
        raise MuyscError(f"{name} is missing; choose a layer of points.")
    source = algorithm.parameterAsSource(parameters, name, context)
    if source is None:
        raise MuyscError(f"{name} “{parameters[name]}” is no layer; choose a layer of points.")
    if source.featureCount() == 0:
        raise MuyscError(f"{name} “{source.sourceName()}” is empty; add at least one point.")
    return source


def way_to(
    dem: Dem,
    layer: QgsRasterLayer,
    source: QgsFeatureSource,
    name: str,
    context: QgsProcessingContext,
) -> tuple[Passage, list[str]]:
    """Return the way from a layer to the CRS of the DEM's layer, and what was assumed for it."""
    crs, notes = source.sourceCrs(), []
    if not crs.isValid():
        crs = layer.crs()
        notes.append(f"{name} has no coordinate reference system; {crs.authid()} was assumed.")
    way = passage(name, crs, dem, layer.crs(), context)
    return way, [*notes, *way.notes]
