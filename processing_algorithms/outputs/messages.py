"""What the log says about a simulation."""

from __future__ import annotations

from collections.abc import Iterable

from qgis.core import QgsProcessingFeedback

from ...muysc_qgis.workflows.simulation import Simulation


def say(feedback: QgsProcessingFeedback, simulation: Simulation, notes: Iterable[str] = ()) -> None:
    """Log notes, the pixels that cannot be known by cause, and every warning."""
    for note in notes:
        feedback.pushInfo(note)
    pixels = simulation.muograms["flux"].values.size
    feedback.pushInfo(
        f"{simulation.rock_pixels} of {pixels} pixels see rock, "
        f"{simulation.unknown_pixels} cannot be known."
    )
    for cause, count in simulation.unknown.items():
        if count:
            feedback.pushInfo(f"  unknown because {cause}: {count} pixels")
    for warning in simulation.warnings:
        feedback.pushWarning(warning)
