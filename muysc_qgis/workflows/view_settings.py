"""What a radiography looks with, as plain data for other processes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from ..progress import Progress, silent
from ..radiography.aperture import Aperture
from ..radiography.settings import Physics
from ..telescope.acceptance import trajectories
from ..telescope.geometry import TelescopeGeometry
from ..topography.sight import Sight
from .simulation import Simulation, Telescope, simulate


@dataclass(frozen=True)
class ViewSettings:
    """Everything but detector and target that a simulation needs; see `simulate`."""

    aperture: Aperture
    physics: Physics
    telescope: Telescope
    max_range_m: float | None = None
    near_field_m: float = 0.0

    def simulate(self, sight: Sight, progress: Progress = silent) -> Simulation:
        """Simulate a radiography along a line of sight, see `simulate`.

        Raises
        ------
        MuyscError
            If a number cannot be used or the DEM cannot be read.
        Cancelled
            If `progress` asks for a stop.
        """
        return simulate(
            sight,
            self.aperture,
            self.physics,
            self.telescope,
            self.max_range_m,
            self.near_field_m,
            progress,
        )

    def plain(self) -> dict[str, Any]:
        """Return everything as what JSON can hold."""
        known = self.telescope.trajectories
        return {
            "aperture": asdict(self.aperture),
            "physics": asdict(self.physics),
            "acceptance_cm2_sr": self.telescope.acceptance_cm2_sr,
            "muons": self.telescope.muons,
            "notes": list(self.telescope.notes),
            "geometry": None if known is None else asdict(known.geometry),
            "formula": None if known is None else known.formula,
            "max_range_m": self.max_range_m,
            "near_field_m": self.near_field_m,
        }

    @classmethod
    def of(cls, plain: Mapping[str, Any]) -> ViewSettings:
        """Return the settings that `plain` gave away."""
        geometry = plain["geometry"]
        telescope = Telescope(
            plain["acceptance_cm2_sr"],
            plain["muons"],
            None
            if geometry is None
            else trajectories(TelescopeGeometry(**geometry), plain["formula"]),
            tuple(plain["notes"]),
        )
        return cls(
            Aperture(**plain["aperture"]),
            Physics(**plain["physics"]),
            telescope,
            plain["max_range_m"],
            plain["near_field_m"],
        )
