"""From terrain or rock thickness to every quantity of a muogram.

The data flow one way: DEM → rays → thickness → opacity → minimum energy → flux
→ exposure. `simulate` starts at the DEM, `through_rock` at a muogram of
thickness or opacity, and both end in a `Simulation`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..forward.sub_rays import SubRays
from ..muogram import Muogram
from ..progress import Progress, part, report, silent
from ..radiography.aperture import Aperture
from ..radiography.constants import G_CM2_PER_M_WATER_EQUIVALENT
from ..radiography.counting import check_positive, exposure_days
from ..radiography.raytracing import Outcome, RockPaths
from ..radiography.settings import Physics
from ..radiography.transmission import attenuate
from ..telescope.acceptance import Trajectories
from ..telescope.directions import Pointing
from ..topography.footprint import Outline, aperture_outline, ground_seen
from ..topography.sight import Sight
from ..topography.tracing import trace_terrain
from ..trajectories import describe_telescope
from .provenance import altitude_of, describe_flux_error, describe_physics, describe_sight

#: What the log says of rays without a flux, by cause.
_CAUSES = {
    "opacity": "the thickness is unknown",
    "horizon": "the ray points at or below the horizon, where no flux model has an answer",
    "energy loss": "the energy loss has no answer for so much rock",
}

#: Shares of the progress bar.
_TRACED = 0.7

#: How much farther than what it shows a field of view is drawn.
_BEYOND = 1.1


@dataclass(frozen=True)
class Telescope:
    """What turns a flux into counts.

    Raises
    ------
    MuyscError
        If a number is not above 0 and finite.
    """

    #: cm² sr of one pixel.
    acceptance_cm2_sr: float = 6.0
    #: Muons wanted in each pixel.
    muons: float = 10.0
    #: Acceptance by direction of a telescope along the boresight, in place of the one above.
    trajectories: Trajectories | None = None
    #: What the user must know about the choice, one sentence each.
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        check_positive(self.acceptance_cm2_sr, "acceptance in cm² sr")
        check_positive(self.muons, "number of muons")

    def acceptance_toward(self, muogram: Muogram) -> float | np.ndarray:
        """Return the acceptance in cm² sr of each pixel of a muogram, or of all of them.

        With a telescope that of the trajectory in the pixel's direction; NaN outside its
        field of view.

        Raises
        ------
        MuyscError
            If the muogram does not say where its telescope points.
        """
        if self.trajectories is None:
            return self.acceptance_cm2_sr
        elevation = muogram.number("BORESIGHT_ELEVATION")
        pointing = Pointing(muogram.number("BORESIGHT_AZIMUTH") % 360.0, elevation)
        return self.trajectories.acceptance_toward(
            *pointing.plane(muogram.azimuth_deg[None, :], muogram.elevation_deg[:, None])
        )


@dataclass(frozen=True)
class Simulation:
    """Muograms by quantity, and what to say about them."""

    muograms: Mapping[str, Muogram]
    #: One sentence each, with the number of pixels concerned.
    warnings: tuple[str, ...]
    #: Number of pixels that cannot be known, by cause.
    unknown: Mapping[str, int]
    #: Number of pixels whose rays are still in rock at the maximum range.
    truncated_pixels: int = 0

    @property
    def rock_pixels(self) -> int:
        """Number of pixels with rock."""
        return int(np.count_nonzero(self.muograms["opacity"].values > 0))

    @property
    def unknown_pixels(self) -> int:
        """Number of pixels without a flux."""
        return int(np.count_nonzero(np.isnan(self.muograms["flux"].values)))

    @property
    def maximum_thickness_m(self) -> float:
        """Largest known thickness, NaN where none is known."""
        thickness = self.muograms["thickness"].values
        return float(np.nanmax(thickness)) if np.isfinite(thickness).any() else float("nan")

    @property
    def median_exposure_days(self) -> float:
        """Median exposure of the pixels behind rock, NaN where there is none."""
        exposure = self.muograms["exposure"].values[self.muograms["opacity"].values > 0]
        known = exposure[np.isfinite(exposure)]
        return float(np.median(known)) if known.size else float("nan")


def simulate(
    sight: Sight,
    aperture: Aperture,
    physics: Physics,
    telescope: Telescope,
    max_range_m: float | None = None,
    near_field_m: float = 0.0,
    progress: Progress = silent,
) -> Simulation:
    """Simulate a radiography from a detector through the terrain of a DEM.

    Parameters
    ----------
    sight
        Detector and target on the DEM.
    aperture
        Field of view around the line of sight.
    physics, telescope
        See there.
    max_range_m
        Largest horizontal distance looked at (m), None for as far as the DEM.
    near_field_m
        Terrain nearer than this (m) is ignored.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If a number cannot be used or the DEM cannot be read.
    Cancelled
        If `progress` asks for a stop.
    """
    check_range(max_range_m, near_field_m)
    azimuth, elevation = aperture.directions(
        sight.boresight_azimuth_deg, sight.boresight_elevation_deg
    )
    rock = trace_terrain(
        sight.frame,
        sight.detector_elevation_m,
        azimuth,
        elevation[::-1],
        max_range_m,
        near_field_m,
        part(progress, 0.0, _TRACED),
    )
    metadata = describe_sight(sight, max_range_m, near_field_m)
    thickness = Muogram("thickness", rock.thickness_m.T[::-1], azimuth, elevation, metadata)
    result = through_rock(thickness, physics, telescope, progress=part(progress, _TRACED, 1.0))
    distance = result.muograms["flux"].with_values("distance", rock.distance_m.T[::-1])
    return Simulation(
        {**result.muograms, "distance": distance},
        (*terrain_warnings(sight, rock, max_range_m), *result.warnings),
        {
            "the ray reaches the edge of the DEM in rock": rock.count(Outcome.EDGE),
            "the ray passes a gap in the DEM": rock.count(Outcome.NO_DATA),
            # The two above say why a thickness is unknown.
            **{k: n for k, n in result.unknown.items() if k != _CAUSES["opacity"]},
        },
        rock.count(Outcome.TRUNCATED),
    )


def through_rock(
    rock: Muogram,
    physics: Physics,
    telescope: Telescope,
    altitude_m: float | None = None,
    progress: Progress = silent,
) -> Simulation:
    """Compute what is left of the muon flux behind known rock.

    Parameters
    ----------
    rock
        Muogram of thickness or opacity.
    physics, telescope
        See there; the density turns thickness into opacity and back.
    altitude_m
        Altitude of the detector, None for the muogram's DETECTOR_ELEVATION.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If the muogram holds another quantity, lacks its DETECTOR_ELEVATION where
        that is needed, or a number cannot be used.
    Cancelled
        If `progress` asks for a stop.
    """
    opacity_of_1_m = physics.density * G_CM2_PER_M_WATER_EQUIVALENT
    if rock.quantity == "thickness":
        thickness, opacity = rock.values, rock.values * opacity_of_1_m
    elif rock.quantity == "opacity":
        thickness, opacity = rock.values / opacity_of_1_m, rock.values
    else:
        raise MuyscError(
            f"The muogram holds {rock.quantity}, and the flux follows from thickness or "
            "opacity; choose a muogram of one of these."
        )
    altitude_m = altitude_of(rock, physics, altitude_m)
    report(progress, 0.0)
    muons = attenuate(opacity, rock.elevation_deg[:, None], physics, altitude_m)
    acceptance = telescope.acceptance_toward(rock)
    exposure = exposure_days(muons.flux, acceptance, telescope.muons)
    report(progress, 1.0)
    metadata: dict[str, str | float] = {
        **describe_physics(physics),
        **describe_flux_error(muons, opacity, rock.elevation_deg[:, None], physics, altitude_m),
        "ACCEPTANCE": telescope.acceptance_cm2_sr,
        "MUONS": telescope.muons,
    }
    if telescope.trajectories is not None:
        # The acceptance on the axis, and all that it takes to get the others.
        metadata["ACCEPTANCE"] = float(telescope.trajectories.acceptance_cm2_sr.max())
        metadata |= describe_telescope(
            telescope.trajectories.geometry, telescope.trajectories.formula
        )
    values = {
        "thickness": thickness,
        "opacity": opacity,
        "minimum_energy": muons.minimum_energy_gev,
        "flux": muons.flux,
        "open_sky": np.broadcast_to(muons.open_sky, opacity.shape),
        "transmission": muons.transmission,
        "exposure": exposure,
    }
    warnings = (*telescope.notes, *muons.warnings)
    outside = int(np.count_nonzero(np.isnan(acceptance)))
    if outside:
        warnings = (
            f"{outside} of {opacity.size} pixels lie outside the telescope's field of view, so "
            "they have no exposure time; use a smaller aperture or another telescope.",
            *warnings,
        )
    known = np.isfinite(opacity)
    if known.any() and not np.any(opacity[known] > 0):
        warnings = (
            f"All {np.count_nonzero(known)} known pixels see only sky: check detector, target "
            "and elevation aperture.",
            *warnings,
        )
    return Simulation(
        {name: rock.with_values(name, array, **metadata) for name, array in values.items()},
        warnings,
        {_CAUSES[cause]: count for cause, count in muons.unanswered.items()},
    )


def check_range(max_range_m: float | None, near_field_m: float) -> None:
    """Refuse a range and a near field that leave no ground between them.

    Raises
    ------
    MuyscError
        With the reason.
    """
    if max_range_m is not None and not 0 < max_range_m < np.inf:
        raise MuyscError(
            f"A maximum range of {max_range_m:g} m is impossible; give a distance above 0 m, or "
            "none for as far as the DEM reaches."
        )
    if not 0 <= near_field_m < np.inf:
        raise MuyscError(
            f"A near field of {near_field_m:g} m is impossible; give a distance of 0 m or more."
        )
    if max_range_m is not None and near_field_m >= max_range_m:
        raise MuyscError(
            f"The near field of {near_field_m:g} m leaves nothing of the maximum range of "
            f"{max_range_m:g} m; make it shorter than the range."
        )


def terrain_warnings(
    sight: Sight, rock: RockPaths | SubRays, max_range_m: float | None
) -> tuple[str, ...]:
    """Return a sentence for whatever on the terrain limits the result.

    Parameters
    ----------
    sight, max_range_m
        What was looked at, and how far (m).
    rock
        What the rays met.
    """
    warnings = [*sight.frame.dem.doubts]
    if sight.detector_height_m < 0:
        warnings.append(
            f"The detector is {-sight.detector_height_m:g} m below ground: every ray starts in "
            "rock unless it is in the open by then."
        )
    pixels = rock.outcome.size
    edge, gaps, truncated = (
        rock.count(outcome) for outcome in (Outcome.EDGE, Outcome.NO_DATA, Outcome.TRUNCATED)
    )
    if edge:
        warnings.append(
            f"{edge} of {pixels} rays reach the edge of the DEM in rock, so their thickness is "
            "unknown: use a larger DEM, or set a maximum range to cut them."
        )
    if gaps:
        warnings.append(
            f"{gaps} of {pixels} rays pass a gap in the DEM lower than the highest ground, so "
            "their thickness is unknown: fill the gaps."
        )
    if truncated:
        warnings.append(
            f"{truncated} of {pixels} rays are still in rock at the maximum range of "
            f"{max_range_m:g} m: their thickness is cut there."
        )
    return tuple(warnings)


def outlines(
    simulation: Simulation, sight: Sight, aperture: Aperture
) -> tuple[Outline, list[Outline]]:
    """Return the sector of the field of view, and the ground seen in it.

    The sector reaches a little beyond the target and the farthest rock face.

    Parameters
    ----------
    simulation
        What was seen, with the distance of the first rock.
    sight, aperture
        From where, and in which field of view.
    """
    distance = simulation.muograms["distance"]
    level = distance.values * np.cos(np.radians(distance.elevation_deg))[:, None]
    width = aperture.azimuth_width_deg
    seen = ground_seen(distance.azimuth_deg, level, width)
    farthest = max([sight.target_distance_m, *(float(one.distance_m.max()) for one in seen)])
    return aperture_outline(distance.azimuth_deg, width, _BEYOND * farthest), seen
