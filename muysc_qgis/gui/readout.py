"""What a pixel of the muogram says, as text."""

from __future__ import annotations

import numpy as np

from ..muogram import Muogram
from ..plots.ticks import compass_points
from .preview import Preview
from .texts import days, metres, tr, with_unit

#: Half the angle between two of the sixteen compass points.
_HALF_POINT_DEG = 11.25


def describe_pixel(preview: Preview, row: int, column: int) -> str:
    """Return direction and values of a pixel, a line each."""
    flux = preview.muogram("flux")
    azimuth, elevation = float(flux.azimuth_deg[column]), float(flux.elevation_deg[row])
    letters = compass_points(azimuth - _HALF_POINT_DEG, azimuth + _HALF_POINT_DEG)[0][1]
    direction = tr("Azimuth {azimuth}° {letters}, elevation {elevation}°, zenith {zenith}°")

    def value(muogram: Muogram) -> float:
        return float(muogram.values[row, column])

    opacity = preview.muogram("opacity")
    if value(opacity) == 0:
        rock = tr("Open sky")
    elif np.isnan(value(opacity)):
        rock = tr("Rock of unknown thickness")
    else:
        rock = tr("Rock {thickness}, opacity {opacity}").format(
            thickness=metres(value(preview.muogram("thickness"))),
            opacity=with_unit(value(opacity), opacity.kind),
        )
    lines = [
        direction.format(
            azimuth=_angle(azimuth % 360.0), letters=letters, elevation=_angle(elevation),
            zenith=_angle(90.0 - elevation),
        ),
        rock,
        tr("Flux {flux}").format(flux=with_unit(value(flux), flux.kind)),
        tr("Exposure {exposure}").format(exposure=days(value(preview.muogram("exposure")))),
    ]  # fmt: skip
    return "\n".join(lines)


def describe_preview(preview: Preview) -> str:
    """Return what is to be said of a whole muogram: the sight, and what limits it."""
    sight = preview.inputs.sight
    lines = [
        tr("Target {distance} away, azimuth {azimuth}°, elevation {elevation}°").format(
            distance=metres(sight.target_distance_m),
            azimuth=_angle(sight.boresight_azimuth_deg),
            elevation=_angle(sight.boresight_elevation_deg),
        )
    ]
    if np.isfinite(preview.simulation.maximum_thickness_m):
        lines.append(
            tr("Up to {thickness} of rock, median exposure {exposure}").format(
                thickness=metres(preview.simulation.maximum_thickness_m),
                exposure=days(preview.simulation.median_exposure_days),
            )
        )
    return "\n".join(lines)


def _angle(angle_deg: float) -> str:
    return f"{angle_deg:.1f}".replace("-", "−")
