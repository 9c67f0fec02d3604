"""A measured muogram from a text file."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFile,
    QgsProcessingParameterPoint,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
)

from ..muysc_qgis.errors import MuyscError
from ..muysc_qgis.measurement.importing import Imported, import_muogram
from ..muysc_qgis.measurement.layout import (
    ANGLE_UNITS,
    LAYOUTS,
    SENSES,
    VERTICAL_ANGLES,
    TextLayout,
)
from ..muysc_qgis.muogram import Muogram, write_muogram
from ..muysc_qgis.quantities import QUANTITIES
from ..muysc_qgis.staging import Staging
from .base import MuyscAlgorithm
from .outputs.rasters import destination, stage_raster
from .parameters.muograms import read_muogram_layer
from .parameters.values import (
    choice,
    explained,
    given,
    number,
    read_choice,
    read_number,
    read_optional,
    switch,
)

#: What can be measured or brought in from elsewhere.
_QUANTITIES = (
    "counts", "flux", "transmission", "thickness", "opacity", "density", "open_sky", "exposure",
    "distance",
)  # fmt: skip
#: Metadata by parameter.
_NUMBERS = {
    "DETECTOR_ELEVATION": "DETECTOR_ELEVATION",
    "BORESIGHT_AZIMUTH": "BORESIGHT_AZIMUTH",
    "BORESIGHT_ELEVATION": "BORESIGHT_ELEVATION",
    "EXPOSURE": "DAYS",
    "ACCEPTANCE": "ACCEPTANCE",
}
_POINT = re.compile(r"^\s*[-+.\deE]+\s*,\s*[-+.\deE]+\s*(\[.*\])?\s*$")
_WGS84 = "EPSG:4326"


@dataclass(frozen=True)
class _Inputs:
    imported: Imported
    paths: tuple[str, ...]
    notes: tuple[str, ...]


class ImportMuogram(MuyscAlgorithm):
    """The way in for what was measured, or computed elsewhere."""

    NAME = "importmuogram"
    TITLE = "Import muogram"
    GROUP = "Radiography"
    GROUP_ID = "radiography"
    TAGS = ("muogram", "import", "table", "text", "csv", "counts", "measurement")
    NUMBERS = (
        ("PIXELS", "Pixels"),
        ("UNKNOWN_PIXELS", "Pixels without a value"),
        ("TOTAL", "Sum of the values"),
    )

    def declare(self) -> list[QgsProcessingParameterDefinition]:
        return [
            explained(
                QgsProcessingParameterFile("INPUT", "Text table or matrix"),
                "Text file: lines of azimuth, elevation or zenith angle, value and perhaps error "
                "in any order, a matrix of values, or a file of the first MUYSC. Tabs, "
                "semicolons, commas or blanks separate the numbers.",
            ),
            choice(
                "QUANTITY", "Quantity of the values",
                "What the values are. They must be in the unit of the quantity once multiplied by "
                "the factor: " + ", ".join(
                    f"{name} {QUANTITIES[name].unit}" for name in _QUANTITIES
                    if QUANTITIES[name].unit != "1"
                ) + ".",
                list(_QUANTITIES), "counts",
            ),
            choice(
                "LAYOUT", "Layout",
                "table: one line for each direction. matrix: one line for each row of pixels. "
                "auto: a table if columns are named or directions come again and again.",
                list(LAYOUTS), "auto",
            ),
            choice(
                "VERTICAL_ANGLE", "Vertical angle",
                "Whether the vertical angle is an elevation above the horizon or a zenith angle. "
                "auto takes what the column's name says.",
                list(VERTICAL_ANGLES), "auto",
            ),
            choice(
                "ANGLE_UNIT", "Unit of the angles",
                "Unit of the angles in the file, and of those of a matrix given below. auto takes "
                "what the names of the columns say, and else degrees.",
                list(ANGLE_UNITS), "auto",
            ),
            *(
                explained(
                    QgsProcessingParameterString(
                        f"{role.upper()}_COLUMN", f"Column of the {label}", None, False, True
                    ),
                    f"Name or number (from 1) of the column of the {label}. {rule}",
                    advanced=True,
                )
                for role, label, rule in (
                    ("azimuth", "azimuth", "Empty finds it by its name, else the first."),
                    ("vertical", "vertical angle", "Empty finds it by its name, else the second."),
                    ("value", "values", "Empty finds it by its name, else the third."),
                    ("error", "standard errors", "Empty finds it by its name, if there is one."),
                )
            ),
            number(
                "FACTOR", "Factor of the values",
                "Give the number that values and errors are multiplied by, other than 0: 86400 "
                "turns a flux per second into one per day, 1000 kilometres into metres.",
                1.0, advanced=True,
            ),
            number(
                "NO_DATA", "Number for no data (empty: none)",
                "Give the number that stands for a missing value. Words such as nan, and empty "
                "fields, always do.",
                None, advanced=True,
            ),
            switch(
                "RELATIVE", "Angles count from the boresight",
                "Whether the angles of the file are measured from the boresight rather than from "
                "north and the horizon.",
                False, advanced=True,
            ),
            choice(
                "AZIMUTH_SENSE", "Azimuth grows",
                "clockwise as seen from above (north, east, south), or counterclockwise.",
                list(SENSES), "clockwise", advanced=True,
            ),
            *(
                number(
                    f"{which}_{end.upper()}", f"Matrix: {label} of the {end} {line}",
                    f"Give the {label} of the pixel centres in the {end} {line} of a matrix, in "
                    "the unit of the angles. Not needed with a reference muogram of the same "
                    "size.",
                    None, advanced=True,
                )
                for which, label, line in (
                    ("AZIMUTH", "azimuth", "column"), ("VERTICAL", "vertical angle", "row"),
                )
                for end in ("first", "last")
            ),
            explained(
                QgsProcessingParameterFile("ERROR_INPUT", "Matrix of errors", optional=True),
                "Text file of the standard errors of a matrix, of the same size.",
                advanced=True,
            ),
            explained(
                QgsProcessingParameterRasterLayer("REFERENCE", "Reference muogram", None, True),
                "Muogram seen from the same place, such as the thickness: what it says of the "
                "detector is taken over, and its directions for a matrix without angles. What is "
                "given below counts more.",
            ),
            explained(
                QgsProcessingParameterPoint("DETECTOR", "Detector", None, True),
                "Where the telescope stood. As text: x,y [EPSG:code]; without a code longitude "
                "and latitude (EPSG:4326).",
            ),
            number(
                "DETECTOR_ELEVATION", "Detector elevation (m, empty: the reference's)",
                "Give the altitude of the detector in m, −1000 to 10000; later steps need it for "
                "the altitude correction.",
                None, -1000, 10_000,
            ),
            number(
                "BORESIGHT_AZIMUTH", "Boresight azimuth (°, empty: middle of the picture)",
                "Give the azimuth that the telescope pointed to, in degrees clockwise from north, "
                "−360 to 360.",
                None, -360, 360,
            ),
            number(
                "BORESIGHT_ELEVATION", "Boresight elevation (°, empty: middle of the picture)",
                "Give the elevation that the telescope pointed to, in degrees, −90 to 90.",
                None, -90, 90,
            ),
            number(
                "EXPOSURE", "Exposure (days, empty: not known)",
                "Give the days of counting, above 0; kept as DAYS in the muogram.",
                None, 0,
            ),
            number(
                "ACCEPTANCE", "Acceptance of a pixel (cm² sr, empty: not known)",
                "Give the acceptance of one pixel in cm² sr, above 0; kept in the muogram.",
                None, 0,
            ),
            explained(
                QgsProcessingParameterRasterDestination("OUTPUT", "Muogram"),
                "The values as a GeoTIFF with azimuth to the right and elevation upwards, degrees.",
            ),
            explained(
                QgsProcessingParameterRasterDestination("ERROR", "Errors", None, True, False),
                "The standard errors, where the file holds any, on the same directions.",
            ),
        ]  # fmt: skip

    def read(self, parameters: dict[str, Any], context: QgsProcessingContext) -> _Inputs:
        if not given(parameters, "INPUT"):
            raise MuyscError("INPUT is missing; choose a text table or matrix.")
        paths = [self.parameterAsFile(parameters, "INPUT", context)]
        metadata: dict[str, str | float] = {}
        reference, notes = None, []
        if given(parameters, "REFERENCE"):
            reference, path = read_muogram_layer(self, parameters, "REFERENCE", context)
            paths.append(path)
            metadata |= _place(reference)
        detector = self._detector(parameters, context, notes)
        metadata |= detector
        read = (self, parameters)
        for name, key in _NUMBERS.items():
            value = read_optional(*read, name, context)
            if value is not None:
                _check(name, value)
                metadata[key] = value
        error_path = None
        if given(parameters, "ERROR_INPUT"):
            error_path = self.parameterAsFile(parameters, "ERROR_INPUT", context)
            paths.append(error_path)
        imported = import_muogram(
            paths[0],
            read_choice(*read, "QUANTITY", context),
            self._layout(parameters, context),
            metadata,
            error_path,
            reference,
        )
        if given(parameters, "ERROR") and imported.error is None:
            raise MuyscError(
                f"ERROR is to be written, and no errors were found in {paths[0]}; name the column "
                "of errors, or leave ERROR out."
            )
        return _Inputs(imported, tuple(paths), tuple(notes))

    def compute(
        self,
        inputs: _Inputs,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        staging: Staging,
    ) -> dict[str, Any]:
        imported = inputs.imported
        for note in (*inputs.notes, *imported.notes):
            feedback.pushInfo(note)
        for warning in (*imported.warnings, *_missing(imported.muogram)):
            feedback.pushWarning(warning)
        results: dict[str, Any] = {}
        for name, muogram in (("OUTPUT", imported.muogram), ("ERROR", imported.error)):
            path = destination(self, parameters, name, context)
            if path is None or muogram is None:
                continue
            staged = stage_raster(
                staging, path, inputs.paths, context, muogram.values, muogram.kind
            )
            write_muogram(muogram, staged)
            results[name] = path
        values = imported.muogram.values
        return results | {
            "PIXELS": values.size,
            "UNKNOWN_PIXELS": int(np.count_nonzero(np.isnan(values))),
            "TOTAL": float(np.nansum(values)),
        }

    def _layout(self, parameters: dict[str, Any], context: QgsProcessingContext) -> TextLayout:
        read = (self, parameters)
        texts = {
            f"{role}_column": self.parameterAsString(parameters, f"{role.upper()}_COLUMN", context)
            for role in ("azimuth", "vertical", "value", "error")
        }
        ends = {
            f"{which}_{end}": read_optional(*read, f"{which}_{end}".upper(), context)
            for which in ("azimuth", "vertical")
            for end in ("first", "last")
        }
        factor = read_number(*read, "FACTOR", context)
        if not factor:
            raise MuyscError("FACTOR is 0, which leaves nothing of the values; give another one.")
        layout = TextLayout(
            layout=read_choice(*read, "LAYOUT", context),
            vertical_angle=read_choice(*read, "VERTICAL_ANGLE", context),
            angle_unit=read_choice(*read, "ANGLE_UNIT", context),
            azimuth_sense=read_choice(*read, "AZIMUTH_SENSE", context),
            relative=self.parameterAsBool(parameters, "RELATIVE", context),
            factor=factor,
            no_data=read_optional(*read, "NO_DATA", context),
        )
        return replace(layout, **texts, **ends)

    def _detector(
        self, parameters: dict[str, Any], context: QgsProcessingContext, notes: list[str]
    ) -> dict[str, str | float]:
        """Return where the detector is on WGS 84, as metadata; empty if it is not given."""
        if not given(parameters, "DETECTOR"):
            return {}
        value = parameters["DETECTOR"]
        if isinstance(value, str):
            match = _POINT.match(value)
            if not match:
                raise MuyscError(
                    f"DETECTOR is “{value}”, which is not a point; write x,y [EPSG:code]."
                )
            if not match.group(1):
                value = f"{value.strip()} [{_WGS84}]"
                notes.append(f"DETECTOR names no coordinate reference system; {_WGS84} is assumed.")
        point = self.parameterAsPoint(
            {**parameters, "DETECTOR": value},
            "DETECTOR",
            context,
            QgsCoordinateReferenceSystem(_WGS84),
        )
        if not (abs(point.x()) <= 360 and abs(point.y()) <= 90):
            raise MuyscError(
                f"DETECTOR lies at longitude {point.x():g}° and latitude {point.y():g}°, which is "
                "nowhere on Earth; write x,y [EPSG:code] with the code of its coordinates."
            )
        return {"DETECTOR_LON": float(point.x()), "DETECTOR_LAT": float(point.y())}


def _place(reference: Muogram) -> dict[str, str | float]:
    """Return what a reference says of where the detector stood and looked."""
    kept = ("DETECTOR_", "TARGET_", "BORESIGHT_")
    return {key: value for key, value in reference.metadata.items() if key.startswith(kept)}


def _check(name: str, value: float) -> None:
    low, high = {
        "DETECTOR_ELEVATION": (-1000.0, 10_000.0),
        "BORESIGHT_AZIMUTH": (-360.0, 360.0),
        "BORESIGHT_ELEVATION": (-90.0, 90.0),
    }.get(name, (0.0, np.inf))
    if not low <= value <= high or (high == np.inf and value == 0):
        limits = "above 0" if high == np.inf else f"from {low:g} to {high:g}"
        raise MuyscError(f"{name} is {value:g}; give a number {limits}.")


def _missing(muogram: Muogram) -> list[str]:
    """Return a warning if later steps will ask where the detector was."""
    keys = [
        key
        for key in ("DETECTOR_LON", "DETECTOR_LAT", "DETECTOR_ELEVATION")
        if key not in muogram.metadata
    ]
    if not keys:
        return []
    return [
        f"The muogram does not say {', '.join(keys)}, which draping and the altitude correction "
        "need; give the detector or a reference muogram."
    ]
