"""The live muogram: a plan read as the algorithm reads it, and what is computed from it."""

from __future__ import annotations

from dataclasses import dataclass, replace

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingContext, QgsProject

from ...processing_algorithms.radiography import Inputs, Radiography
from ..muogram import Muogram
from ..progress import Progress
from ..workflows.planning import counts_in
from ..workflows.simulation import Simulation
from .plan import Plan

#: Pixels along each side while something is dragged.
COARSE_PIXELS = 40

#: The quantities that the dock shows, in the order of its list.
SHOWN = ("thickness", "flux", "transmission", "exposure", "counts")


@dataclass(frozen=True)
class Preview:
    """A muogram, and what it was computed from."""

    inputs: Inputs
    #: Coordinate reference system of the DEM.
    crs: QgsCoordinateReferenceSystem
    simulation: Simulation
    #: Muons in the days of the plan.
    counts: Muogram
    coarse: bool

    def muogram(self, quantity: str) -> Muogram:
        """Return one of the quantities `SHOWN`, or any other of the simulation."""
        return self.counts if quantity == "counts" else self.simulation.muograms[quantity]


@dataclass(frozen=True)
class Request:
    """A muogram to compute."""

    inputs: Inputs
    crs: QgsCoordinateReferenceSystem
    days: float
    #: Whether a rough picture will do, because the next request is near.
    coarse: bool = False

    def compute(self, progress: Progress) -> Preview:
        """Simulate the radiography.

        Raises
        ------
        MuyscError
            If something cannot be computed.
        Cancelled
            If `progress` asks for a stop.
        """
        inputs = self.inputs
        if self.coarse:
            aperture = replace(
                inputs.aperture, azimuth_pixels=COARSE_PIXELS, elevation_pixels=COARSE_PIXELS
            )
            inputs = replace(inputs, aperture=aperture)
        simulation = inputs.simulate(progress)
        counts = counts_in(self.days, simulation, inputs.telescope)
        return Preview(inputs, self.crs, simulation, counts, self.coarse)


def request_for(plan: Plan, coarse: bool = False) -> Request:
    """Read a plan as the algorithm reads its parameters, so that both compute the same.

    Raises
    ------
    MuyscError
        If something is missing or cannot be used.
    """
    algorithm = Radiography()
    algorithm.initAlgorithm()
    context = QgsProcessingContext()
    context.setProject(QgsProject.instance())
    inputs = algorithm.read(plan.radiography(plan.dem), context)
    return Request(inputs, inputs.layer.crs(), plan.days, coarse)
