"""What telescopes would count behind known rock, and the opacity that the counts say."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from ..errors import MuyscError
from ..measurement.density import Densities, Flag, check_minimum, measure_density
from ..measurement.observation import from_counts
from ..measurement.regions import errors_of_pixels, shares_of_pixels
from ..measurement.scene import Scene
from ..muogram import Muogram
from ..progress import Progress, silent
from ..radiography.aperture import Aperture
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.counting import check_positive
from ..radiography.settings import Physics
from ..radiography.transmission import attenuate
from ..telescope.directions import Pointing
from .measured_density import FLAG_MEANINGS
from .simulation import Telescope
from .sites import Station
from .station_data import StationData

#: Confidence of the limits of pixels without a muon, which are left out.
_CONFIDENCE = 0.95

#: Most muons of a pixel: whole numbers add up exactly to 9 times this (2⁵³).
_MOST_MUONS = 1e15

#: Flags of pixels whose counts say an opacity.
_SAID = (Flag.MEASURED, Flag.SKY)


@dataclass(frozen=True)
class Campaign:
    """How long is counted, with what, and how the counts are read.

    Raises
    ------
    MuyscError
        If a number is out of range.
    """

    #: Days of counting.
    days: float = 100.0
    telescope: Telescope = field(default_factory=Telescope)
    #: Counts up to which neighbouring pixels are merged, 0 for no merging.
    minimum_counts: float = 20.0
    #: Whether counts are drawn at all; without noise the opacity is known.
    noise: bool = True
    #: What the draws start from, 0 or more.
    seed: int = 1

    def __post_init__(self) -> None:
        check_positive(self.days, "time of counting in days")
        check_minimum(self.minimum_counts)
        if self.seed < 0:
            raise MuyscError(f"The seed is {self.seed}; give a whole number of 0 or more.")


@dataclass(frozen=True)
class Counted:
    """A station with the opacity that it counted, and from how many muons."""

    data: StationData
    muons: float
    #: Pixels with an opacity, and opacities that are independent of each other.
    pixels: int
    regions: int


def station_data(station: Station, aperture: Aperture) -> StationData:
    """Return the directions of a station, row by row as in its muogram, before it sees anything."""
    sight = station.sight
    azimuth, elevation = aperture.directions(
        sight.boresight_azimuth_deg, sight.boresight_elevation_deg
    )
    directions = np.broadcast_arrays(azimuth[None, :], elevation[:, None])
    return StationData(
        station.site.name,
        *sight.detector_wgs84,
        sight.detector_elevation_m,
        directions[0].ravel(),
        directions[1].ravel(),
        target=(*sight.target_wgs84, sight.target_elevation_m),
    )


def count_muons(
    data: StationData,
    station: Station,
    thickness_m: np.ndarray,
    aperture: Aperture,
    physics: Physics,
    campaign: Campaign,
    generator: np.random.Generator,
    progress: Progress = silent,
) -> Counted:
    """Return the opacities that a station reads from the muons it counts.

    Flux behind the known opacity → expected counts → Poisson draws → opacity and error by
    the inversion that measured muograms get. Pixels of one region share what it counted: each
    has its opacity, with an error larger by the root of their number, so that together
    they weigh as much as the region.

    Parameters
    ----------
    data
        Has the known opacity.
    station, thickness_m, aperture
        Its sight, and (n,) rock along its rays; NaN where a ray does not count.
    physics, campaign, generator
        How muons are stopped and counted, and what draws them.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If the opacity is not known, a number cannot be used, or a pixel would count more muons
        than can be drawn.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    if data.opacity is None:
        raise MuyscError(f"{data.name} has no opacity to count muons behind.")
    sight, shape = station.sight, (aperture.elevation_pixels, aperture.azimuth_pixels)
    view = Muogram(
        "thickness",
        thickness_m.reshape(shape),
        data.azimuth_deg[: shape[1]],
        data.elevation_deg[:: shape[1]],
        {
            "BORESIGHT_AZIMUTH": sight.boresight_azimuth_deg,
            "BORESIGHT_ELEVATION": sight.boresight_elevation_deg,
        },
    )
    elevation = view.elevation_deg[:, None]
    acceptance = campaign.telescope.acceptance_toward(view) * _pixel_share(campaign, view, aperture)
    flux = attenuate(data.opacity.reshape(shape), elevation, physics, data.elevation_m).flux
    with np.errstate(over="ignore"):
        expected = flux * acceptance * campaign.days
    most = np.max(expected, initial=0.0, where=~np.isnan(expected))
    if most > _MOST_MUONS:
        raise MuyscError(
            f"A pixel of {data.name} would count {most:.3g} muons in {campaign.days:g} days, "
            f"beyond the {_MOST_MUONS:g} that can be drawn; count for less time, or with a "
            "smaller acceptance."
        )
    known = np.isfinite(expected)
    counts = np.where(known, generator.poisson(np.where(known, expected, 0.0)), np.nan)
    found = measure_density(
        from_counts(counts, campaign.days, acceptance, _CONFIDENCE),
        Scene(view.values, elevation, physics, data.elevation_m),
        campaign.minimum_counts,
        progress,
    )
    said = np.isin(found.flags, _SAID) & known
    opacity = np.where(said, found.opacity(view.values), np.nan)
    error = np.where(said, _errors(found, view.values), np.nan)
    share = None if found.region is None else shares_of_pixels(found.region).ravel()
    lost = {
        FLAG_MEANINGS[flag]: (found.flags == flag).ravel() & ~np.isnan(thickness_m)
        for flag in Flag
        if flag not in _SAID
    }
    return Counted(
        replace(data, opacity=opacity.ravel(), error=error.ravel(), share=share, lost=lost),
        float(np.nansum(counts)),
        int(np.count_nonzero(found.flags == Flag.MEASURED)),
        found.regions,
    )


def _pixel_share(campaign: Campaign, view: Muogram, aperture: Aperture) -> float | np.ndarray:
    """Return the solid angle of pixels over that of a telescope's trajectories.

    What a telescope collects does not depend on the pixels that it is put into: neighbouring
    trajectories are d/D apart in the tangents, so that each stands for (d/D)² cos³ of the angle to
    the boresight. Without a telescope, the acceptance is that of a pixel whatever its size.
    """
    trajectories = campaign.telescope.trajectories
    if trajectories is None:
        return 1.0
    elevation = np.radians(view.elevation_deg[:, None])
    across = np.radians(aperture.azimuth_width_deg / aperture.azimuth_pixels)
    up = np.radians(aperture.elevation_width_deg / aperture.elevation_pixels)
    pointing = Pointing(
        view.number("BORESIGHT_AZIMUTH") % 360.0, view.number("BORESIGHT_ELEVATION")
    )
    x, y = pointing.plane(view.azimuth_deg[None, :], view.elevation_deg[:, None])
    own = trajectories.geometry.step**2 / (1.0 + x**2 + y**2) ** 1.5
    return np.asarray(across * up * np.cos(elevation) / own)


def _errors(found: Densities, thickness_m: np.ndarray) -> np.ndarray:
    """Return the standard errors of the opacities, g/cm²."""
    error = found.error * thickness_m * G_CM2_PER_M_WATER_EQUIVALENT
    if found.region is not None:
        error = errors_of_pixels(error, found.region)
    # The sky is no less sure than the thinnest rock that was measured.
    sky, measured = found.flags == Flag.SKY, found.flags == Flag.MEASURED
    if sky.any() and np.isfinite(error[measured]).any():
        error = np.where(sky, np.nanmin(error[measured]), error)
    return error
