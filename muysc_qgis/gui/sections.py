"""One ray through the terrain: where it runs in rock, for the map and for the section."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..plots.profile import section_panel
from ..plots.rays import Ray, rock_intervals
from ..plots.style import png_bytes
from ..plots.ticks import azimuth_label
from ..topography.section import terrain_section
from .preview import Preview
from .texts import tr


@dataclass(frozen=True)
class RaySection:
    """The terrain along a ray, and where the ray is in rock."""

    preview: Preview
    azimuth_deg: float
    elevation_deg: float
    #: (n,) increasing horizontal distances and ground heights in the straight-ray frame.
    distance_m: np.ndarray
    ground_m: np.ndarray
    #: (k, 2) horizontal distances at which the ray enters and leaves rock.
    rock_m: np.ndarray

    def figure_png(self) -> bytes:
        """Draw the section.

        Raises
        ------
        MuyscError
            If matplotlib is missing or too little of the ground is known.
        """
        sight = self.preview.inputs.sight
        figure = section_panel(
            self.distance_m,
            self.ground_m,
            sight.detector_elevation_m,
            [Ray(tr("through the pixel"), self.elevation_deg, main=True)],
            azimuth_deg=self.azimuth_deg,
            title=tr("Section along azimuth {azimuth}").format(
                azimuth=azimuth_label(round(self.azimuth_deg, 1))
            ),
        )
        return png_bytes(figure)


def section_of(preview: Preview, row: int, column: int) -> RaySection:
    """Return the section along the ray of a pixel.

    Raises
    ------
    MuyscError
        If the DEM cannot be read.
    """
    flux = preview.simulation.muograms["flux"]
    azimuth, elevation = float(flux.azimuth_deg[column]), float(flux.elevation_deg[row])
    sight = preview.inputs.sight
    eye = sight.detector_elevation_m
    distance, ground = terrain_section(sight.frame, eye, azimuth, elevation)
    return RaySection(
        preview, azimuth, elevation, distance, ground,
        rock_intervals(distance, ground, eye, elevation),
    )  # fmt: skip
