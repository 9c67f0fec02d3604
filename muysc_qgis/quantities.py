"""The quantities a muogram can hold: names, units and how each is coloured.

Rasters, map styles, panels and reports all read this one table, so that a
quantity has the same title, unit and colours wherever it appears.
"""

from __future__ import annotations

from dataclasses import dataclass

#: Nine evenly spaced stops of perceptually uniform, colour-blind-safe maps
#: (van der Walt & Smith 2015, CC0; cividis: Nuñez et al. 2018,
#: doi:10.1371/journal.pone.0199239).
COLOUR_STOPS = {
    "viridis": (
        "#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c",
        "#28ae80", "#5ec962", "#addc30", "#fde725",
    ),
    "cividis": (
        "#00224e", "#1a386f", "#434e6c", "#61656f", "#7d7c78",
        "#9b9476", "#bcae6c", "#dec958", "#fee838",
    ),
    "magma": (
        "#000004", "#1d1147", "#51127c", "#832681", "#b73779",
        "#e75263", "#fc8961", "#fec488", "#fcfdbf",
    ),
    "plasma": (
        "#0d0887", "#4c02a1", "#7e03a8", "#aa2395", "#cc4778",
        "#e66c5c", "#f89540", "#fdc527", "#f0f921",
    ),
    # About a middle: Brewer's RdBu with its ends (Harrower & Brewer 2003,
    # doi:10.1179/000870403235002042).
    "blue_red": (
        "#053061", "#2166ac", "#4393c3", "#92c5de", "#d1e5f0", "#f7f7f7",
        "#fddbc7", "#f4a582", "#d6604d", "#b2182b", "#67001f",
    ),
}  # fmt: skip


@dataclass(frozen=True)
class Quantity:
    """One physical quantity of a muogram."""

    name: str
    title: str
    unit: str
    #: Key of `COLOUR_STOPS`.
    colours: str
    #: Whether colours follow the logarithm of the value.
    logarithmic: bool

    @property
    def label(self) -> str:
        """Title with unit, for axes, legends and band descriptions."""
        return self.title if self.unit == "1" else f"{self.title} ({self.unit})"


#: What the name of a quantity's standard error ends in.
ERROR_SUFFIX = "_error"

QUANTITIES = {
    quantity.name: quantity
    for quantity in (
        Quantity("thickness", "Rock thickness", "m", "viridis", True),
        Quantity("opacity", "Opacity", "g/cm²", "viridis", True),
        Quantity("minimum_energy", "Minimum muon energy", "GeV", "cividis", True),
        Quantity("flux", "Muon flux", "cm⁻² sr⁻¹ day⁻¹", "magma", True),
        Quantity("open_sky", "Open-sky muon flux", "cm⁻² sr⁻¹ day⁻¹", "magma", True),
        Quantity("transmission", "Transmission", "1", "magma", True),
        Quantity("exposure", "Exposure time", "days", "plasma", True),
        Quantity("counts", "Muon counts", "1", "magma", True),
        Quantity("density", "Mean density", "g/cm³", "cividis", False),
        Quantity("distance", "Distance to the first rock", "m", "cividis", False),
        Quantity("thickness_error", "Error of the rock thickness", "m", "plasma", True),
        Quantity("opacity_error", "Error of the opacity", "g/cm²", "plasma", True),
        Quantity("flux_error", "Error of the muon flux", "cm⁻² sr⁻¹ day⁻¹", "plasma", True),
        Quantity("transmission_error", "Error of the transmission", "1", "plasma", True),
        Quantity("counts_error", "Error of the muon counts", "1", "plasma", True),
        Quantity("density_error", "Error of the mean density", "g/cm³", "plasma", False),
        Quantity("density_lower", "Lower end of the mean density", "g/cm³", "cividis", False),
        Quantity("density_upper", "Upper end of the mean density", "g/cm³", "cividis", False),
        Quantity("density_flags", "Flags of the mean density", "1", "viridis", False),
        Quantity("density_regions", "Regions of merged pixels", "1", "viridis", False),
        # Over the flux models that hold.
        Quantity("flux_minimum", "Smallest muon flux", "cm⁻² sr⁻¹ day⁻¹", "magma", True),
        Quantity("flux_maximum", "Largest muon flux", "cm⁻² sr⁻¹ day⁻¹", "magma", True),
        Quantity("density_minimum", "Smallest mean density", "g/cm³", "cividis", False),
        Quantity("density_maximum", "Largest mean density", "g/cm³", "cividis", False),
        Quantity("acceptance", "Acceptance", "cm² sr", "viridis", False),
        Quantity("solid_angle", "Solid angle", "sr", "cividis", False),
        Quantity("detection_area", "Detection area", "cm²", "plasma", False),
        Quantity("path_length", "Path between the planes", "cm", "magma", False),
        Quantity("angular_resolution", "Angular resolution", "mrad", "cividis", False),
        Quantity("open_sky_counts", "Open-sky muon counts", "1", "magma", True),
        Quantity("rock_share", "Share of the response behind rock", "1", "viridis", False),
        Quantity("relative_error", "Counting error", "%", "viridis", True),
        Quantity("density_resolution", "Smallest visible density contrast", "%", "viridis", True),
        Quantity("contrast_days", "Days to see the density contrast", "days", "plasma", True),
        Quantity("residual", "Residual over its error", "1", "blue_red", False),
        # Of places for telescopes, on the map.
        Quantity("site_score", "Score of the site", "1", "viridis", False),
        Quantity("share_seen", "Share of the target seen", "1", "viridis", False),
        Quantity("free_sky", "Share of free sky", "1", "cividis", False),
    )
}
