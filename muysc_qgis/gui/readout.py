"""What a pixel of the muogram says, as text."""

from __future__ import annotations

import numpy as np

from ..quantities import QUANTITIES
from ..radiography.envelope import flux_error
from ..radiography.spectra import MODELS
from .preview import Preview
from .texts import NO_BREAK, days, metres, tr, with_unit

#: Quantities that are told only where they are shown.
_FURTHER = ("transmission", "counts")


def describe_pixel(preview: Preview, row: int, column: int, quantity: str) -> str:
    """Return direction and values of a pixel as a small table in HTML.

    Parameters
    ----------
    preview, row, column
        The muogram, and which of its pixels.
    quantity
        The one that is shown, told as well.
    """

    def told(name: str) -> str:
        muogram = preview.muogram(name)
        return with_unit(float(muogram.values[row, column]), muogram.kind)

    flux, opacity = preview.muogram("flux"), preview.muogram("opacity").values[row, column]
    azimuth, elevation = float(flux.azimuth_deg[column]), float(flux.elevation_deg[row])
    thickness = metres(float(preview.muogram("thickness").values[row, column]))
    rock = tr("Open sky") if opacity == 0 else tr("Rock {thickness}").format(thickness=thickness)
    cells = [
        tr("Azimuth {angle}°").format(angle=_angle(azimuth % 360.0)),
        rock,
        tr("Elevation {angle}°").format(angle=_angle(elevation)),
        tr("Opacity {opacity}").format(opacity=told("opacity")),
        tr("Zenith {angle}°").format(angle=_angle(90.0 - elevation)),
        tr("Exposure {exposure}").format(
            exposure=days(float(preview.muogram("exposure").values[row, column]))
        ),
    ]
    lines = [tr("Flux {flux}").format(flux=told("flux")) + _flux_error(preview, row, column)]
    if quantity in _FURTHER:
        lines.append(f"{tr(QUANTITIES[quantity].title)} {told(quantity)}")
    rows = [
        # Angles stay on one line, and values have the rest of the width.
        f"<td style='padding-right: 6px'>{left.replace(' ', NO_BREAK)}</td><td>{right}</td>"
        for left, right in zip(cells[::2], cells[1::2])
    ]
    rows += [f"<td colspan='2'>{line}</td>" for line in lines]
    # In HTML lines break at narrow spaces, even at those that must not.
    table = "".join(f"<tr>{cell}</tr>" for cell in rows).replace("\u202f", NO_BREAK)
    return f"<table width='100%' cellspacing='0'>{table}</table>"


def _flux_error(preview: Preview, row: int, column: int) -> str:
    """Return the standard error of a pixel's flux in percent, nothing for a formula's."""
    physics = preview.inputs.physics
    if not MODELS[physics.flux_model].tabulated:
        return ""
    energy = preview.muogram("minimum_energy")
    error = flux_error(
        energy.values[row, column],
        np.sin(np.radians(energy.elevation_deg[row])),
        physics,
        preview.inputs.sight.detector_elevation_m,
    )
    return f" ± {100 * float(error):.0f} %".replace(" ", NO_BREAK) if np.isfinite(error) else ""


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
