"""The spread of the flux models beside a simulation."""

from __future__ import annotations

from dataclasses import replace

from ..radiography.envelope import model_envelope
from ..radiography.settings import Physics
from .simulation import Simulation


def with_flux_spread(
    simulation: Simulation, physics: Physics, altitude_m: float | None = None
) -> Simulation:
    """Add the smallest and largest flux over the models that hold for each ray.

    Parameters
    ----------
    simulation
        What was simulated with `physics`.
    physics
        Its flux model is replaced by every other one.
    altitude_m
        Altitude of the detector, None for the muograms' DETECTOR_ELEVATION.

    Raises
    ------
    MuyscError
        If the altitude is needed and not known.
    """
    opacity = simulation.muograms["opacity"]
    if altitude_m is None:
        correct = physics.altitude_correction
        altitude_m = opacity.number("DETECTOR_ELEVATION") if correct else 0.0
    spread = model_envelope(opacity.values, opacity.elevation_deg[:, None], physics, altitude_m)
    names = [name for name, rays in spread.rays.items() if rays]
    models = ", ".join(names)
    added = {
        name: opacity.with_values(name, values, FLUX_MODEL=models)
        for name, values in (("flux_minimum", spread.minimum), ("flux_maximum", spread.maximum))
    }
    return replace(simulation, muograms={**simulation.muograms, **added})
