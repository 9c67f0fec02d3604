"""Which transformation between datums counts, and the way of points to the DEM by it."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from qgis.core import (
    Qgis,
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsDatumTransform,
    QgsPointXY,
    QgsProcessingContext,
)

from ...muysc_qgis.topography.datum import (
    Transformation,
    described,
    known_accuracy,
    leads,
    name_of_operation,
)
from ...muysc_qgis.topography.dem import Dem

WGS84 = "EPSG:4326"


@dataclass(frozen=True)
class Passage:
    """The way of points from a coordinate reference system to that of a DEM, and back."""

    #: To the DEM's system, or to WGS 84 where `by` leads on.
    step: QgsCoordinateTransform
    by: Transformation | None
    #: A sentence where the step itself is not exact, such as from a third datum.
    notes: tuple[str, ...]

    def to_dem(self, x: float, y: float) -> tuple[float, float] | None:
        """Return a point in the DEM's system, None where it has no place there."""
        try:
            moved = self.step.transform(x, y)
        except QgsCsException:
            return None
        place = (moved.x(), moved.y())
        if self.by is not None:
            place = self.by.from_wgs84(*place)
        return _finite(*place)

    def from_dem(self, x: np.ndarray, y: np.ndarray) -> list[QgsPointXY]:
        """Return where points (n,) of the DEM are, none if one of them has no place there."""
        if self.by is not None:
            x, y = self.by.to_wgs84(x, y)
        back = Qgis.TransformDirection.Reverse
        try:
            return [
                self.step.transform(QgsPointXY(px, py), back)
                for px, py in zip(x.tolist(), y.tolist())
            ]
        except QgsCsException:
            return []


def passage(
    name: str,
    crs: QgsCoordinateReferenceSystem,
    dem: Dem,
    dem_crs: QgsCoordinateReferenceSystem,
    context: QgsProcessingContext,
) -> Passage:
    """Return the way from a system to the DEM's.

    Between two datums it goes by WGS 84 and from there by the DEM's transformation, so that points
    come out where they went in.

    Parameters
    ----------
    name
        Of the parameter, for the note.
    crs, dem_crs
        Of the points, and of the DEM as QGIS has it.
    dem
        Terrain.
    context
        Whose transformations count.
    """
    step, by = QgsCoordinateTransform(crs, dem_crs, context.transformContext()), None
    if dem.transformation is not None and not _is_exact(step):
        by = dem.transformation
        step = QgsCoordinateTransform(
            crs, QgsCoordinateReferenceSystem(WGS84), context.transformContext()
        )
    notes: tuple[str, ...] = ()
    if crs.isValid() and not _is_exact(step):
        used = described(*_operation(step))
        target = "WGS 84" if by else "the DEM"
        notes = (f"{name} went from {crs.authid() or crs.description()} to {target} by {used}.",)
    return Passage(step, by, notes)


def with_transformation(
    dem: Dem, crs: QgsCoordinateReferenceSystem, context: QgsProcessingContext
) -> Dem:
    """Return a DEM with the transformation to WGS 84 that QGIS has chosen for the project.

    Where the user chose one from the DEM to the map, and the map is on WGS 84, it is that one. A
    DEM on WGS 84 has none.

    Parameters
    ----------
    dem
        Terrain with PROJ's own choice, which stays where that of QGIS cannot be repeated.
    crs
        Of the DEM as QGIS has it.
    context
        Whose transformations count.
    """
    if dem.transformation is None or not crs.isValid():
        return dem
    found = _choice(dem, crs, context)
    if isinstance(found, Transformation):
        return replace(dem, transformation=found)
    text = (
        f"QGIS goes from {crs.authid() or crs.description()} to WGS 84 by {found}, which the PROJ "
        f"of Python cannot do; {dem.transformation.name} was used instead, in both directions."
    )
    return replace(dem, assumptions=(*dem.assumptions, text))


def _choice(
    dem: Dem, crs: QgsCoordinateReferenceSystem, context: QgsProcessingContext
) -> Transformation | str:
    """Return QGIS's transformation, or its name where it cannot be repeated."""
    x, y = (float(one) for one in dem.crs_position(dem.columns / 2, dem.rows / 2))
    steps, names, accuracies = [], [], []
    systems = _by_way_of(crs, context)
    for source, target in zip(systems, systems[1:]):
        transform = QgsCoordinateTransform(source, target, context.transformContext())
        name, accuracy = _operation(transform)
        try:
            moved = transform.transform(x, y)
        except QgsCsException:
            return name
        end = moved.x(), moved.y()
        step = next((one for one in _forms(transform) if leads(one, (x, y), end)), None)
        if step is None:
            return name
        steps.append(step)
        if not _is_exact(transform):
            names.append(name)
            accuracies.append(accuracy)
        x, y = end
    known = [one for one in accuracies if one is not None]
    return Transformation(
        dem.crs,
        tuple(steps),
        " + ".join(names),
        sum(known) if len(known) == len(accuracies) else None,
    )


def _by_way_of(
    crs: QgsCoordinateReferenceSystem, context: QgsProcessingContext
) -> list[QgsCoordinateReferenceSystem]:
    """Return the systems that a way to WGS 84 goes through."""
    wgs84 = QgsCoordinateReferenceSystem(WGS84)
    chosen, project = context.transformContext(), context.project()
    if project is not None and project.crs().isValid() and not chosen.hasTransform(crs, wgs84):
        on_map = QgsCoordinateTransform(project.crs(), wgs84, chosen)
        if chosen.hasTransform(crs, project.crs()) and _is_exact(on_map):
            return [crs, project.crs(), wgs84]
    return [crs, wgs84]


def _forms(transform: QgsCoordinateTransform) -> list[tuple[str, bool]]:
    """Return the forms in which Python's PROJ may know what QGIS does.

    QGIS also has grids in a folder of its own, and keeps an operation that was chosen for the
    other direction as it is.
    """
    details = transform.instantiatedCoordinateOperationDetails()
    in_folder = details.proj
    for grid in details.grids:
        if grid.fullName:
            in_folder = in_folder.replace(f"={grid.shortName}", f'="{grid.fullName}"')
    return [(text, backwards) for text in (details.proj, in_folder) for backwards in (False, True)]


def _operation(transform: QgsCoordinateTransform) -> tuple[str, float | None]:
    """Return name and accuracy (m, None where unknown) of an operation."""
    details = transform.instantiatedCoordinateOperationDetails()
    if details.accuracy < 0 and transform.coordinateOperation():
        # What the user chose comes as a pipeline alone; the register knows more of it.
        ends = transform.sourceCrs(), transform.destinationCrs()
        listed = [*QgsDatumTransform.operations(*ends), *QgsDatumTransform.operations(*ends[::-1])]
        details = next((one for one in listed if one.proj == details.proj), details)
    return name_of_operation(details.name), known_accuracy(details.accuracy)


def _is_exact(transform: QgsCoordinateTransform) -> bool:
    """Return whether no datum changes."""
    return bool(
        transform.isShortCircuited()
        or transform.instantiatedCoordinateOperationDetails().accuracy == 0
    )


def _finite(x: float, y: float) -> tuple[float, float] | None:
    return (float(x), float(y)) if math.isfinite(x) and math.isfinite(y) else None
