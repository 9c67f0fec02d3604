"""The muon sky as tabulated: flux over altitude, zenith angle and energy, and its error.

The table comes from primaries and interaction models by a one-dimensional cascade that is
fitted to measured vertical spectra; `tools/muon_sky` makes it and `docs/physics.md` says
how well it meets measurements. Between its nodes ln flux is a cubic spline along each axis.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path

import numpy as np

from .interpolation import hermite, spline_slopes

_TABLE = Path(__file__).parent / "data" / "muon_sky.csv"

#: Range of the table: altitude in m, zenith angle in degrees, kinetic energy in GeV.
MINIMUM_ALTITUDE_M = 0.0
#: Land that lies lower than this, m, is told; down to there the slope at the sea carries on.
LOWEST_LAND_M = -100.0
MAXIMUM_ALTITUDE_M = 6000.0
MAXIMUM_ZENITH_DEG = 89.5
LOWEST_GEV = 0.25
HIGHEST_GEV = 1e6


@dataclass(frozen=True)
class Axis:
    """Knots along one axis of the table, and cubic splines through any values on them."""

    #: (n,) increasing coordinates.
    knots: np.ndarray

    @cached_property
    def slopes(self) -> np.ndarray:
        """(n, n) slope at each knot (first axis) of the spline through each knot's unit value."""
        return np.stack([spline_slopes(self.knots, one) for one in np.eye(len(self.knots))], 1)

    def locate(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the knot before each coordinate, the position from it to the next, the width.

        Beyond the last knots the position is that of the end.
        """
        inside = np.clip(x, self.knots[0], self.knots[-1])
        k = np.clip(np.searchsorted(self.knots, inside, side="right") - 1, 0, len(self.knots) - 2)
        width = self.knots[k + 1] - self.knots[k]
        return k, (inside - self.knots[k]) / width, width

    def along(self, x: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return the splines through values at coordinates, straight on beyond the knots.

        Parameters
        ----------
        x
            Coordinates, of one dimension or none.
        values
            (n, …) values at the knots.

        Returns
        -------
        numpy.ndarray
            Shape of `x`, then what of the values' shape comes after their first axis.
        """
        k, t, width = self.locate(x)
        rows = np.tensordot(self.slopes, values, 1)
        extra = (...,) + (None,) * (values.ndim - 1)
        curve = hermite(t[extra], width[extra], values[k], values[k + 1], rows[k], rows[k + 1])
        beyond = x - np.clip(x, self.knots[0], self.knots[-1])
        return np.asarray(curve + beyond[extra] * np.where(t[extra] < 0.5, rows[k], rows[k + 1]))


def zenith_coordinate(cos_zenith: np.ndarray) -> np.ndarray:
    """Return the coordinate along which ln flux runs smoothly to the horizon.

    Parameters
    ----------
    cos_zenith
        Cosine of the zenith angle, any shape.
    """
    return np.sqrt(np.maximum(cos_zenith, 0.0) + 0.01)


@dataclass(frozen=True)
class MuonSky:
    """The table, ready to be interpolated."""

    altitude: Axis
    zenith: Axis
    ln_energy: Axis
    #: (n_altitude, n_zenith, n_energy) ln of dI/dE in cm⁻² s⁻¹ sr⁻¹ GeV⁻¹.
    ln_flux: np.ndarray
    #: The same shape: relative standard error of the flux.
    error: np.ndarray

    def flux(
        self, kinetic_energy_gev: np.ndarray, cos_zenith: np.ndarray, altitude_m: float
    ) -> np.ndarray:
        """Return dI/dE in cm⁻² s⁻¹ sr⁻¹ GeV⁻¹.

        Parameters
        ----------
        kinetic_energy_gev
            Kinetic energy in GeV, above 0.
        cos_zenith
            Cosine of the zenith angle at the detector; broadcasts with the energy.
        altitude_m
            Height of the detector above sea level, m.
        """
        return np.exp(self._at(self.ln_flux, kinetic_energy_gev, cos_zenith, altitude_m))

    def relative_error(
        self, kinetic_energy_gev: np.ndarray, cos_zenith: np.ndarray, altitude_m: float
    ) -> np.ndarray:
        """Return the relative standard error of the flux, as for `flux`; NaN stays NaN.

        Beyond the table it is that of its edge, because a slope says nothing of ignorance.
        """
        lowest, highest = (float(np.exp(self.ln_energy.knots[end])) for end in (0, -1))
        return self._at(
            self.error,
            np.clip(kinetic_energy_gev, lowest, highest),
            np.maximum(cos_zenith, np.cos(np.radians(MAXIMUM_ZENITH_DEG))),
            min(max(altitude_m, MINIMUM_ALTITUDE_M), MAXIMUM_ALTITUDE_M),
        )

    def _at(
        self,
        values: np.ndarray,
        kinetic_energy_gev: np.ndarray,
        cos_zenith: np.ndarray,
        altitude_m: float,
    ) -> np.ndarray:
        # Curves over the energy at the altitude, one for each distinct angle …
        there = self.altitude.along(np.array(altitude_m, dtype=float), values)
        cosine, row = np.unique(np.asarray(cos_zenith, dtype=float), return_inverse=True)
        curves = self.zenith.along(zenith_coordinate(cosine), there)
        slopes = curves @ self.ln_energy.slopes.T
        # … from which every ray reads its own at its energy.
        x = np.log(np.maximum(kinetic_energy_gev, np.finfo(float).tiny))
        k, t, width = self.ln_energy.locate(np.where(np.isnan(x), self.ln_energy.knots[0], x))
        here = row.reshape(np.shape(cos_zenith)) * len(self.ln_energy.knots) + k
        value, slope = curves.ravel(), slopes.ravel()
        first, second = slope[here], slope[here + 1]
        curve = hermite(t, width, value[here], value[here + 1], first, second)
        beyond = x - np.clip(x, self.ln_energy.knots[0], self.ln_energy.knots[-1])
        return np.asarray(curve + beyond * np.where(t < 0.5, first, second))


@cache
def muon_sky() -> MuonSky:
    """Return the table that ships with the library, read when it is first asked for."""
    return read_muon_sky(_TABLE)


def read_muon_sky(path: Path) -> MuonSky:
    """Return a table from its file.

    The first line gives the cosines of the zenith angle, twice; each of the others altitude
    in m and kinetic energy in GeV, then for each cosine ln of dI/dE in cm⁻² s⁻¹ sr⁻¹ GeV⁻¹,
    then its standard error in %.

    Parameters
    ----------
    path
        Text with commas; lines that start with # are comments.
    """
    lines = np.loadtxt(path, delimiter=",", comments="#")
    count = (lines.shape[1] - 2) // 2
    cosine = lines[0, 2 : 2 + count]
    altitude, energy = np.unique(lines[1:, 0]), np.unique(lines[1:, 1])
    values = lines[1:, 2:].reshape(len(altitude), len(energy), 2, count)
    ln_flux, error = np.moveaxis(values, (2, 3), (0, 2))
    return MuonSky(
        Axis(altitude),
        Axis(zenith_coordinate(cosine)),
        Axis(np.log(energy)),
        ln_flux,
        error / 100.0,
    )
