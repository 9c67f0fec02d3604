"""Bodies that a reconstruction is tried on."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsFeature,
    QgsFeatureSource,
    QgsGeometry,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterPoint,
    QgsRasterLayer,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.radiography.settings import MAXIMUM_DENSITY_G_CM3
from ...muysc_qgis.topography.dem import Dem
from ...muysc_qgis.topography.frame import transformed
from ...muysc_qgis.workflows.known_model import MODELS, KnownModel, Prism
from ..compat import VECTOR_POLYGON
from .values import choice, explained, given, number, read_choice, read_number, read_optional
from .view import read_point

if TYPE_CHECKING:
    from pyproj import CRS

#: Fields that a polygon needs.
_FIELDS = ("density", "base", "top")


def model_parameters() -> list[QgsProcessingParameterDefinition]:
    """Declare the model and the sizes of its bodies."""
    return [
        choice(
            "MODEL", "Known model",
            "uniform: rock of one density. conduit: an upright cylinder. sphere. checkerboard: "
            "every other cube. polygons: what a layer holds.",
            list(MODELS), "conduit",
        ),
        number(
            "ROCK_DENSITY", "Density of the rock around (g/cm³, empty: the material's own)",
            f"Give the density of the rock around the bodies in g/cm³, above 0 and up to "
            f"{MAXIMUM_DENSITY_G_CM3:g}.",
            None, 0, MAXIMUM_DENSITY_G_CM3,
        ),
        number(
            "BODY_DENSITY", "Density of the body (g/cm³)",
            "Give the density of conduit, sphere or every other cube in g/cm³, above 0 and up to "
            f"{MAXIMUM_DENSITY_G_CM3:g}.",
            2.15, 0, MAXIMUM_DENSITY_G_CM3,
        ),
        number(
            "BODY_RADIUS", "Radius of conduit or sphere (m)",
            "Give the radius in m, above 0.",
            100.0, 0,
        ),
        number(
            "BODY_EDGE", "Edge of the checkerboard's cubes (m)",
            "Give the edge of a cube in m, above 0.",
            200.0, 0,
        ),
        explained(
            QgsProcessingParameterPoint("BODY_POSITION", "Position of the body (empty: the target)",
                                        None, True),
            "Axis of the conduit or middle of the sphere, on the DEM.",
        ),
        number(
            "BODY_BASE", "Base of the conduit (m, empty: the volume's)",
            "Give the height of the conduit's lower end in m above sea level.",
            None, -12_000, 12_000, advanced=True,
        ),
        number(
            "BODY_TOP", "Top of the conduit (m, empty: the volume's)",
            "Give the height of the conduit's upper end in m above sea level; above the ground "
            "there is none of it.",
            None, -12_000, 12_000, advanced=True,
        ),
        number(
            "BODY_MIDDLE", "Middle of the sphere (m, empty: the volume's)",
            "Give the height of the sphere's middle in m above sea level.",
            None, -12_000, 12_000, advanced=True,
        ),
        explained(
            QgsProcessingParameterFeatureSource("POLYGONS", "Polygons of the model",
                                                [VECTOR_POLYGON], None, True),
            "Layer of bodies for the model polygons, with the fields density (g/cm³), base and top "
            "(m above sea level); in any coordinate reference system. Later ones replace earlier "
            "ones.",
        ),
    ]  # fmt: skip


def read_model(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    dem: Dem,
    layer: QgsRasterLayer,
    target: tuple[float, float],
    crs: CRS,
    own_density: float,
) -> tuple[KnownModel, list[str]]:
    """Return the known model in the CRS of the volume, and what was assumed for it.

    `own_density` is that of the material.

    Raises
    ------
    MuyscError
        If a value cannot be used, or the polygons lack a field or a value.
    """
    read = (algorithm, parameters)
    kind = read_choice(*read, "MODEL", context)
    density = read_optional(*read, "ROCK_DENSITY", context)
    place = target
    notes: list[str] = []
    if given(parameters, "BODY_POSITION"):
        place, notes = read_point(*read, "BODY_POSITION", context, dem, layer)
    prisms: tuple[Prism, ...] = ()
    if kind == "polygons":
        prisms, assumed = _prisms(*read, context, crs)
        notes = [*notes, *assumed]
    x, y = transformed(
        dem.crs, crs, np.array([place[0]]), np.array([place[1]]), by=dem.transformation
    )
    model = KnownModel(
        kind=kind,
        density=own_density if density is None else density,
        body_density=read_number(*read, "BODY_DENSITY", context),
        radius_m=read_number(*read, "BODY_RADIUS", context),
        edge_m=read_number(*read, "BODY_EDGE", context),
        base_m=read_optional(*read, "BODY_BASE", context),
        top_m=read_optional(*read, "BODY_TOP", context),
        middle_m=read_optional(*read, "BODY_MIDDLE", context),
        centre=(float(x[0]), float(y[0])),
        prisms=prisms,
    )
    return model, notes


def _prisms(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    crs: CRS,
) -> tuple[tuple[Prism, ...], list[str]]:
    """Return the polygons of the layer in the CRS of the volume, and what was assumed for it."""
    if not given(parameters, "POLYGONS"):
        raise MuyscError(
            "MODEL is polygons and POLYGONS is missing; choose a layer of polygons with the fields "
            f"{', '.join(_FIELDS)}, or another model."
        )
    source = algorithm.parameterAsSource(parameters, "POLYGONS", context)
    if source is None:
        raise MuyscError(
            f"POLYGONS “{parameters['POLYGONS']}” is no layer; choose a layer of polygons."
        )
    fields = _fields(source)
    own, target = source.sourceCrs(), QgsCoordinateReferenceSystem.fromWkt(crs.to_wkt())
    notes = []
    if not own.isValid():
        own = target
        notes.append(
            f"POLYGONS has no coordinate reference system; that of the volume, {crs.name}, was "
            "assumed."
        )
    transform = QgsCoordinateTransform(own, target, context.transformContext())
    prisms = []
    for number_, feature in enumerate(source.getFeatures(), 1):
        values = [_value(feature, fields[name], name, number_) for name in _FIELDS]
        if feature.geometry().isEmpty():
            continue
        # Curves become straight pieces.
        geometry = QgsGeometry(feature.geometry().constGet().segmentize())
        geometry.transform(transform)
        prisms.append(Prism(str(number_), _rings(geometry), values[1], values[2], values[0]))
    if not prisms:
        raise MuyscError("POLYGONS holds no polygon; add one, or choose another model.")
    return tuple(prisms), notes


def _fields(source: QgsFeatureSource) -> dict[str, int]:
    found = {name: int(source.fields().lookupField(name)) for name in _FIELDS}
    missing = [name for name, index in found.items() if index < 0]
    if missing:
        known = ", ".join(field.name() for field in source.fields()) or "none"
        raise MuyscError(
            f"POLYGONS lacks the field{'s' * (len(missing) > 1)} {', '.join(missing)} (it has "
            f"{known}); add density (g/cm³), base and top (m above sea level)."
        )
    return found


def _value(feature: QgsFeature, index: int, name: str, number_: int) -> float:
    try:
        value = float(feature.attribute(index))
    except (TypeError, ValueError):
        value = math.nan
    if not math.isfinite(value):
        raise MuyscError(
            f"Polygon {number_} has the {name} “{feature.attribute(index)}”, which is not a finite "
            "number; correct it."
        )
    return value


def _rings(geometry: QgsGeometry) -> tuple[np.ndarray, ...]:
    """Return the corners of all rings of all parts."""
    parts = geometry.asMultiPolygon() if geometry.isMultipart() else [geometry.asPolygon()]
    return tuple(
        np.array([(point.x(), point.y()) for point in ring]) for part in parts for ring in part
    )
