"""How well the flux is known, beside a simulation."""

from __future__ import annotations

from dataclasses import replace

from ..radiography.envelope import model_envelope
from ..radiography.settings import Physics
from .provenance import altitude_of
from .simulation import Simulation


def with_flux_spread(
    simulation: Simulation, physics: Physics, altitude_m: float | None = None
) -> Simulation:
    """Add how small and how large the flux of each ray may well be, see `model_envelope`.

    Parameters
    ----------
    simulation
        What was simulated with `physics`.
    physics
        With a formula, it is replaced by every other one.
    altitude_m
        Altitude of the detector in m, None for the muograms' DETECTOR_ELEVATION.

    Raises
    ------
    MuyscError
        If the altitude is needed and not known.
    """
    opacity = simulation.muograms["opacity"]
    altitude_m = altitude_of(opacity, physics, altitude_m)
    spread = model_envelope(opacity.values, opacity.elevation_deg[:, None], physics, altitude_m)
    names = [name for name, rays in spread.rays.items() if rays]
    models = ", ".join(names)
    added = {
        name: opacity.with_values(name, values, FLUX_MODEL=models)
        for name, values in (("flux_minimum", spread.minimum), ("flux_maximum", spread.maximum))
    }
    return replace(simulation, muograms={**simulation.muograms, **added})
