"""Vector layers that appear together with the other files, whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsFeatureSink,
    QgsFields,
    QgsMapLayer,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingOutputLayerDefinition,
    QgsProcessingUtils,
    QgsProperty,
    QgsVectorLayer,
    QgsWkbTypes,
)

from ...muysc_qgis.errors import MuyscError
from ...muysc_qgis.staging import Staging

#: Longer ones quote whole commands of the database.
_LONGEST_REASON = 150


def write_layer(
    algorithm: QgsProcessingAlgorithm,
    output: str,
    fields: QgsFields,
    kind: QgsWkbTypes.Type,
    crs: QgsCoordinateReferenceSystem,
    features: Iterable[QgsFeature],
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    staging: Staging,
) -> str:
    """Write a layer and return what QGIS finds it by.

    A file is staged; what goes to memory or into a database is written at once, so this is
    called last.

    Parameters
    ----------
    algorithm, parameters, context, staging
        Of the run.
    output
        Name of the sink.
    fields, kind, crs, features
        What the layer holds.

    Raises
    ------
    MuyscError
        If the layer cannot be written.
    """
    value = parameters[output]
    target = file_of(value)
    staged = None if target is None else staging.add_layer(target)
    chosen = value if staged is None else _redirected(value, staged)
    try:
        sink, identifier = algorithm.parameterAsSink(
            {**parameters, output: chosen}, output, context, fields, kind, crs
        )
    except QgsProcessingException as error:
        raise _refusal(output, target or value, str(error)) from error
    if sink is None:
        raise _refusal(output, target or value, "it is no place for a layer")
    count = 0
    for feature in features:
        sink.addFeature(feature, QgsFeatureSink.Flag.FastInsert)
        count += 1
    whole, said = sink.flushBuffer(), sink.lastError()
    # Closes the file.
    del sink
    if target is None or staged is None:
        return str(identifier)
    # A full disk may show only now.
    layer = QgsVectorLayer(identifier, output, "ogr")
    if not whole or not layer.isValid() or layer.featureCount() != count:
        raise _refusal(output, target, said or "it is not complete")
    written = str(target.with_name(Path(identifier).name))
    if isinstance(value, QgsProcessingOutputLayerDefinition) and value.destinationProject:
        title = value.destinationName or algorithm.parameterDefinition(output).description()
        details = QgsProcessingContext.LayerDetails(
            title, value.destinationProject, output, QgsProcessingUtils.LayerHint.Vector
        )
        context.addLayerToLoadOnCompletion(written, details)
    return written


def file_of(value: Any) -> Path | None:
    """Return the file that a destination names, None for memory and databases."""
    if isinstance(value, QgsProcessingOutputLayerDefinition):
        value = value.sink.staticValue()
    if not isinstance(value, str):
        return None
    path = Path(value)
    return path.absolute() if path.is_absolute() or path.suffix else None


def files_read(value: Any, context: QgsProcessingContext) -> list[str]:
    """Return the files that an input parameter names, by path or by layer."""
    if isinstance(value, list):
        return [file for one in value for file in files_read(one, context)]
    if isinstance(value, QgsProcessingFeatureSourceDefinition):
        value = value.source.staticValue()
    if isinstance(value, str) and context.project() is not None:
        # The toolbox names layers by their identifiers.
        value = context.project().mapLayer(value) or value
    source = value.source() if isinstance(value, QgsMapLayer) else value
    path = source.partition("|")[0] if isinstance(source, str) else ""
    return [path] if os.path.isfile(path) else []


def _redirected(value: Any, path: Path) -> Any:
    """Return a destination at another path, with all its options."""
    if not isinstance(value, QgsProcessingOutputLayerDefinition):
        return str(path)
    other = QgsProcessingOutputLayerDefinition(value)
    other.sink = QgsProperty.fromValue(str(path))
    # Loaded from where it will stand.
    other.destinationProject = None
    return other


def _refusal(output: str, place: Any, reason: str) -> MuyscError:
    reason = " ".join(reason.split()).rstrip(".")
    if len(reason) > _LONGEST_REASON:
        reason = "its database cannot be made"
    return MuyscError(
        f"{output} cannot be written to {place} ({reason}); make room on the disk or choose "
        "another place."
    )
