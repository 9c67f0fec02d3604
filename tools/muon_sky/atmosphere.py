"""Air along a straight line that comes down to a detector on a round Earth.

U.S. Standard Atmosphere 1976 (NOAA, NASA, USAF, NOAA-S/T 76-1562): temperatures at the
ends of layers of even lapse rate, hydrostatic in between.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

#: Radius of the Earth of that standard, km, and of the sphere that rays are drawn on.
_GEOPOTENTIAL_RADIUS_KM = 6356.766
EARTH_RADIUS_KM = 6371.0
#: Geopotential heights in km of the layers, lapse rates in K/km, and the temperature at sea.
_BASE_KM = np.array([0.0, 11.0, 20.0, 32.0, 47.0, 51.0, 71.0, 84.852])
_LAPSE = np.array([-6.5, 0.0, 1.0, 2.8, 0.0, -2.8, -2.0])
_SEA_KELVIN, _SEA_PASCAL = 288.15, 101_325.0
#: g M/R in K/km, and M/R in kg K/J for the density.
_HYDROSTATIC = 34.163195
_GAS = 0.0289644 / 8.31432
#: The top of the air, km; 10⁻⁶ of it is above.
TOP_KM = 100.0


def density_g_cm3(height_km: np.ndarray) -> np.ndarray:
    """Return the density of air in g/cm³ at heights above sea level in km, any shape."""
    height = np.asarray(height_km, dtype=float)
    potential = _GEOPOTENTIAL_RADIUS_KM * height / (_GEOPOTENTIAL_RADIUS_KM + height)
    kelvin, pascal = [_SEA_KELVIN], [_SEA_PASCAL]
    for lapse, low, high in zip(_LAPSE, _BASE_KM[:-1], _BASE_KM[1:]):
        _append(kelvin, pascal, lapse, high - low)
    layer = np.clip(np.searchsorted(_BASE_KM, potential, side="right") - 1, 0, len(_LAPSE) - 1)
    above = potential - _BASE_KM[layer]
    lapse, base = _LAPSE[layer], np.array(kelvin)[layer]
    temperature = np.maximum(base + lapse * above, 100.0)
    even = lapse == 0
    safe = np.where(even, 1.0, lapse)
    ratio = np.where(
        even,
        np.exp(-_HYDROSTATIC * above / base),
        (base / temperature) ** (_HYDROSTATIC / safe),
    )
    return np.array(pascal)[layer] * ratio / temperature * _GAS * 1e-3


def _append(kelvin: list[float], pascal: list[float], lapse: float, thickness: float) -> None:
    base = kelvin[-1]
    top = base + lapse * thickness
    ratio = (
        np.exp(-_HYDROSTATIC * thickness / base)
        if lapse == 0
        else (base / top) ** (_HYDROSTATIC / lapse)
    )
    kelvin.append(top)
    pascal.append(pascal[-1] * float(ratio))


@dataclass(frozen=True)
class AirPath:
    """A line from a detector up to the top of the air."""

    #: (n,) distance from the detector, cm, increasing.
    distance_cm: np.ndarray
    #: (n,) air between the top and that point, g/cm², decreasing.
    depth: np.ndarray
    #: (n,) density there, g/cm³.
    density: np.ndarray

    @property
    def total(self) -> float:
        """Air over the detector along the line, g/cm²."""
        return float(self.depth[0])

    def at_depth(self, depth: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return distance in cm and density in g/cm³ where so much air lies above."""
        order = slice(None, None, -1)
        known = np.log(np.maximum(self.depth[order], 1e-12))
        sought = np.log(depth)
        return (
            np.interp(sought, known, self.distance_cm[order]),
            np.exp(np.interp(sought, known, np.log(self.density[order]))),
        )


def air_path(altitude_m: float, cos_zenith: float, points: int = 4000) -> AirPath:
    """Return the line of a zenith angle at the detector.

    Parameters
    ----------
    altitude_m
        Height of the detector above sea level, m.
    cos_zenith
        Cosine of the zenith angle at the detector's place.
    points
        Along the line, even in height squared near the detector.
    """
    foot = EARTH_RADIUS_KM + altitude_m / 1e3
    top = EARTH_RADIUS_KM + TOP_KM
    length = np.sqrt(top**2 - foot**2 * (1 - cos_zenith**2)) - foot * cos_zenith
    s = length * np.linspace(0.0, 1.0, points) ** 1.5
    height = np.sqrt(foot**2 + s**2 + 2 * foot * s * cos_zenith) - EARTH_RADIUS_KM
    rho = density_g_cm3(height)
    s_cm = s * 1e5
    pieces = np.diff(s_cm) * _logarithmic_mean(rho[:-1], rho[1:])
    # What is above the top presses with the scale height of the last piece.
    fall = np.log(rho[-2] / rho[-1]) / (s_cm[-1] - s_cm[-2])
    depth = np.append(np.cumsum(pieces[::-1])[::-1], 0.0) + rho[-1] / fall
    return AirPath(s_cm, depth, rho)


def _logarithmic_mean(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Return the mean of an exponential between its ends."""
    ratio = np.log(first / second)
    small = np.abs(ratio) < 1e-6
    return np.where(small, 0.5 * (first + second), (first - second) / np.where(small, 1, ratio))
