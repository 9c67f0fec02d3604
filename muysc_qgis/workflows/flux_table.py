"""The flux behind rock, tabulated over opacity and elevation: fast, with its slope."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..radiography.settings import Physics
from ..radiography.transmission import attenuate

#: Opacities of the table: evenly spaced in ln(ϱ + 30 g/cm²).
_OFFSET, _HIGHEST_G_CM2, _OPACITIES = 30.0, 3e6, 500

#: Elevations, denser towards the horizon.
_ELEVATIONS = 140

#: ln of a flux that no telescope sees, where the range law has no answer.
_NOTHING = -80.0


@dataclass(frozen=True)
class FluxTable:
    """ln I(ϱ, θ) of one altitude, bilinear in ln(ϱ + 30 g/cm²) and √elevation.

    Within 3·10⁻⁴ of `attenuate` from 1° of elevation on. The slope is that of the table's own
    differences, smoothed over one step.
    """

    #: Elevations of the table, degrees, from just above the horizon.
    root_deg: np.ndarray
    #: (n_elevation, n_opacity) ln I and d ln I / d ln(ϱ + offset).
    logarithm: np.ndarray
    slope: np.ndarray

    @classmethod
    def of(
        cls, lowest_deg: float, highest_deg: float, physics: Physics, altitude_m: float
    ) -> FluxTable:
        """Tabulate the flux.

        Parameters
        ----------
        lowest_deg, highest_deg
            Elevations in between; degrees, above 0 and up to 90.
        physics, altitude_m
            As in `attenuate`.

        Raises
        ------
        MuyscError
            If the altitude is not on land.
        """
        root = np.linspace(np.sqrt(max(lowest_deg, 1e-3)), np.sqrt(highest_deg), _ELEVATIONS)
        opacity = np.exp(_nodes()) - _OFFSET
        opacity[0] = 0.0
        elevation = np.minimum(root**2, 90.0)[:, None]
        flux = attenuate(opacity[None, :], elevation, physics, altitude_m).flux
        with np.errstate(divide="ignore"):
            logarithm = np.where(flux > 0, np.log(flux), np.nan)
        logarithm = np.where(np.isfinite(logarithm), logarithm, _NOTHING)
        slope = np.gradient(logarithm, _nodes(), axis=1)
        return cls(root, logarithm, slope)

    def __call__(
        self, opacity_g_cm2: np.ndarray, elevation_deg: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return flux (cm⁻² sr⁻¹ day⁻¹) and its derivative over opacity, (n,) each.

        Parameters
        ----------
        opacity_g_cm2
            (n,) 0 or more.
        elevation_deg
            (n,) within the table.
        """
        nodes, root = _nodes(), self.root_deg
        place = (np.log(opacity_g_cm2 + _OFFSET) - nodes[0]) / (nodes[1] - nodes[0])
        place = np.clip(place, 0, len(nodes) - 1)
        column = np.minimum(place.astype(int), len(nodes) - 2)
        right = place - column
        height = (np.sqrt(np.maximum(elevation_deg, 0.0)) - root[0]) / (root[1] - root[0])
        height = np.clip(height, 0, len(root) - 1)
        row = np.minimum(height.astype(int), len(root) - 2)
        up = height - row

        def looked_up(table: np.ndarray) -> np.ndarray:
            low = (1 - right) * table[row, column] + right * table[row, column + 1]
            high = (1 - right) * table[row + 1, column] + right * table[row + 1, column + 1]
            return np.asarray((1 - up) * low + up * high)

        flux = np.exp(looked_up(self.logarithm))
        return flux, flux * looked_up(self.slope) / (opacity_g_cm2 + _OFFSET)


def _nodes() -> np.ndarray:
    return np.linspace(np.log(_OFFSET), np.log(_HIGHEST_G_CM2 + _OFFSET), _OPACITIES)
