"""Muons in each pixel of a simulated muogram, and what a detector is compared by."""

from __future__ import annotations

from dataclasses import dataclass

from ..muogram import Muogram
from ..progress import Progress, part, silent
from ..radiography.aperture import Aperture
from ..radiography.counting import check_positive
from ..radiography.settings import Physics
from ..topography.sight import Sight
from .simulation import Simulation, Telescope, simulate

#: Width (degrees) of a field of view for one ray; its direction is that of the boresight.
_ONE_RAY_DEG = 0.01


def counts_in(days: float, simulation: Simulation, telescope: Telescope) -> Muogram:
    """Return the muons that each pixel counts in some days: I·𝒯·t.

    Parameters
    ----------
    days
        Time t of counting.
    simulation
        Has the flux I.
    telescope
        Has the acceptance 𝒯; outside its field of view counts are NaN.

    Raises
    ------
    MuyscError
        If the time is not above 0 and finite.
    """
    check_positive(days, "time of counting in days")
    flux = simulation.muograms["flux"]
    counts = flux.values * telescope.acceptance_toward(flux) * days
    return flux.with_values("counts", counts, DAYS=days)


@dataclass(frozen=True)
class SiteFigures:
    """What a place for a detector is compared by."""

    #: Horizontal distance of the target, m.
    target_distance_m: float
    #: Largest known thickness in the field of view (m), NaN where none is known.
    maximum_thickness_m: float
    #: Rock on the ray to the target (m), NaN where unknown.
    target_thickness_m: float
    #: Days until the pixel towards the target has its muons, NaN where unknown.
    target_days: float
    #: Pixels that cannot be known, and all.
    unknown_pixels: int
    pixels: int


def figures_of_site(
    sight: Sight,
    aperture: Aperture,
    physics: Physics,
    telescope: Telescope,
    progress: Progress = silent,
) -> SiteFigures:
    """Return what a place for a detector is compared by.

    Parameters
    ----------
    sight
        Detector and target on the DEM.
    aperture, physics, telescope
        As in `simulate`.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If a number cannot be used or the DEM cannot be read.
    Cancelled
        If `progress` asks for a stop.
    """
    view = simulate(sight, aperture, physics, telescope, progress=part(progress, 0.0, 0.9))
    towards = simulate(
        sight,
        Aperture(_ONE_RAY_DEG, _ONE_RAY_DEG, 1, 1),
        physics,
        telescope,
        progress=part(progress, 0.9, 1.0),
    )
    return SiteFigures(
        sight.target_distance_m,
        view.maximum_thickness_m,
        float(towards.muograms["thickness"].values[0, 0]),
        float(towards.muograms["exposure"].values[0, 0]),
        view.unknown_pixels,
        aperture.azimuth_pixels * aperture.elevation_pixels,
    )
