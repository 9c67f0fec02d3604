"""What every report tells of its run, whatever was computed."""

from __future__ import annotations

import platform
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from .. import __version__
from ..radiography.energy_loss import ENERGY_LOSSES
from ..radiography.spectra import MODELS
from .report import Citation, OutputFile, Report, Row


@dataclass(frozen=True)
class Provenance:
    """Where results come from."""

    #: What was given to the algorithm.
    parameters: Sequence[Row] = ()
    #: File by label.
    outputs: Mapping[str, str] = field(default_factory=dict)
    #: When, as text.
    date: str = ""
    #: Versions of other software by name.
    versions: Mapping[str, str] = field(default_factory=dict)

    def added_to(self, report: Report) -> Report:
        """Return a report that tells this as well."""
        own = {
            "MUYSC for QGIS": __version__,
            "Python": platform.python_version(),
            "numpy": np.__version__,
        }
        return replace(
            report,
            date=self.date,
            parameters=self.parameters,
            outputs=[OutputFile(label, Path(path).name) for label, path in self.outputs.items()],
            versions={**own, **self.versions},
        )


def transformation_rows(metadata: Mapping[str, str | float]) -> list[Row]:
    """Return how positions are tied to WGS 84, from metadata; nothing where they are on it."""
    if "TRANSFORMATION" not in metadata:
        return []
    accuracy = metadata.get("TRANSFORMATION_ACCURACY", "unknown")
    unit = "" if accuracy == "unknown" else "m"
    return [
        Row("Transformation between the elevation model and WGS 84", metadata["TRANSFORMATION"]),
        Row("Accuracy of the transformation", accuracy, unit),
    ]


def physics_citations(flux_model: str, energy_loss: str) -> list[Citation]:
    """Return the works behind a choice of physics, by the names of its parameters."""
    return [
        Citation(f"Muon flux model: {MODELS[flux_model].citation}"),
        Citation(f"Energy loss: {ENERGY_LOSSES[energy_loss]}"),
    ]


def physics_of(metadata: Mapping[str, str | float]) -> list[Citation]:
    """Return the works behind the physics that a muogram's metadata name."""
    return physics_citations(str(metadata["FLUX_MODEL"]), str(metadata["ENERGY_LOSS"]))
