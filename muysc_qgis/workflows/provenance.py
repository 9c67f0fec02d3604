"""What muograms say of how they were made, and the altitude that later steps take from it."""

from __future__ import annotations

import numpy as np

from ..radiography.envelope import typical_flux_error
from ..radiography.settings import Physics
from ..radiography.spectra import MODELS
from ..radiography.transmission import Attenuation
from ..topography.dem import Dem
from ..topography.sight import Sight
from ..views import View


def describe_sight(
    sight: Sight, max_range_m: float | None, near_field_m: float
) -> dict[str, str | float]:
    """Return the metadata of a muogram that say what was looked at, and how far.

    Degrees, and heights and distances in m; ``MAX_RANGE`` only where there is one.
    """
    dem = sight.frame.dem
    description: dict[str, str | float] = {
        "DETECTOR_LON": sight.detector_wgs84[0],
        "DETECTOR_LAT": sight.detector_wgs84[1],
        "DETECTOR_ELEVATION": sight.detector_elevation_m,
        "DETECTOR_HEIGHT": sight.detector_height_m,
        "TARGET_LON": sight.target_wgs84[0],
        "TARGET_LAT": sight.target_wgs84[1],
        "TARGET_ELEVATION": sight.target_elevation_m,
        "TARGET_DISTANCE": sight.target_distance_m,
        "BORESIGHT_AZIMUTH": sight.boresight_azimuth_deg,
        "BORESIGHT_ELEVATION": sight.boresight_elevation_deg,
        "NEAR_FIELD": near_field_m,
        "DEM": dem.name,
        "DEM_CRS": dem.crs.name,
    }
    if max_range_m is not None:
        description["MAX_RANGE"] = max_range_m
    return {**description, **describe_transformation(dem)}


def describe_transformation(dem: Dem) -> dict[str, str | float]:
    """Return the metadata that say how positions on a DEM are tied to WGS 84.

    The name of the operation and its accuracy in m, or “unknown”; nothing where the DEM is on
    WGS 84.
    """
    by = dem.transformation
    if by is None:
        return {}
    accuracy = "unknown" if by.accuracy_m is None else by.accuracy_m
    return {"TRANSFORMATION": by.name, "TRANSFORMATION_ACCURACY": accuracy}


def describe_physics(physics: Physics) -> dict[str, str | float]:
    """Return the metadata of a muogram that say how muons are made and stopped.

    `NamedView.physics` reads them. Density in g/cm³, threshold in GeV.
    """
    return {
        "MATERIAL": physics.material,
        "DENSITY": physics.density,
        "FLUX_MODEL": physics.flux_model,
        "GAISSER_PARAMETERS": physics.gaisser_parameters,
        "ENERGY_LOSS": physics.energy_loss,
        "STRAGGLING": "yes" if physics.straggling else "no",
        "ALTITUDE_CORRECTION": "yes" if physics.altitude_correction else "no",
        "DETECTION_THRESHOLD": physics.threshold_gev,
    }


def describe_flux_error(
    muons: Attenuation,
    opacity_g_cm2: np.ndarray,
    elevation_deg: np.ndarray,
    physics: Physics,
    altitude_m: float,
) -> dict[str, str | float]:
    """Return the metadata that say how well the flux model knows what is behind the rock.

    FLUX_ERROR, the median standard error in %, where the model has one of its own.

    Parameters
    ----------
    muons
        What came through.
    opacity_g_cm2, elevation_deg, physics, altitude_m
        As in `attenuate`.
    """
    if not MODELS[physics.flux_model].tabulated:
        return {}
    error = typical_flux_error(
        muons.minimum_energy_gev, opacity_g_cm2, elevation_deg, physics, altitude_m
    )
    return {"FLUX_ERROR": 100.0 * error} if np.isfinite(error) else {}


def altitude_of(view: View, physics: Physics, altitude_m: float | None = None) -> float:
    """Return the altitude of a detector in m, as the flux needs it.

    Parameters
    ----------
    view
        Its DETECTOR_ELEVATION counts where no altitude is given.
    physics
        Without a correction for altitude 0 serves as well as any.
    altitude_m
        What the user gives, None for nothing.

    Raises
    ------
    MuyscError
        If the altitude is needed, and neither given nor in the metadata.
    """
    if altitude_m is not None:
        return altitude_m
    return view.number("DETECTOR_ELEVATION") if physics.altitude_counts else 0.0
