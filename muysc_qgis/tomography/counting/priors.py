"""What is known before any muon of densities, and of all else that the counts depend on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...errors import MuyscError
from .model import CountModel, Linearisation


@dataclass(frozen=True)
class CountPriors:
    """Standard deviations before any muon; 0 stands for what is known exactly.

    Raises
    ------
    MuyscError
        If a number is negative or not finite.
    """

    #: Density (g/cm³) around which all densities scatter.
    mean: float
    #: Of that density itself.
    mean_deviation: float = 0.3
    #: Of the densities of voxels around it, g/cm³, and over which distance they are alike, m.
    deviation: float = 0.2
    length_m: float = 200.0
    #: Of the factor of each station.
    station: float = 0.1
    #: Of the factor of the flux, and of how it falls with opacity.
    flux: float = 0.1
    flux_fall: float = 0.0
    #: Of azimuth and elevation of each boresight, degrees.
    azimuth_deg: float = 0.3
    elevation_deg: float = 0.3
    #: Of the heights of the terrain, m, and over which distance they are alike, m.
    terrain_m: float = 0.0
    terrain_length_m: float = 100.0
    #: Densities that none is below or above, g/cm³; None for no bound.
    lowest: float | None = 0.0
    highest: float | None = None

    def __post_init__(self) -> None:
        for name in ("mean_deviation", "station", "flux", "flux_fall", "azimuth_deg",
                     "elevation_deg", "terrain_m"):  # fmt: skip
            value = getattr(self, name)
            if not 0 <= value < np.inf:
                raise MuyscError(
                    f"The {name.replace('_', ' ')} of the prior is {value:g}; give 0 or more."
                )
        low, high = self.bounds
        if not low < self.mean < high:
            raise MuyscError(
                f"A prior density of {self.mean:g} g/cm³ is not within the bounds {low:g} to "
                f"{high:g} g/cm³; move the bounds or the density."
            )

    @property
    def bounds(self) -> tuple[float, float]:
        """Least and largest density, infinite for none."""
        return (
            -np.inf if self.lowest is None else self.lowest,
            np.inf if self.highest is None else self.highest,
        )


@dataclass(frozen=True)
class Band:
    """One number beside the densities, with what is known of it before and after."""

    name: str
    #: Number of the station that it belongs to, −1 for all.
    station: int
    before: float
    before_error: float
    after: float
    after_error: float


#: Softness of bounds on densities, g/cm³.
_SOFT = 0.03


def bounded(values: np.ndarray, low: float, high: float) -> tuple[np.ndarray, np.ndarray]:
    """Return values brought smoothly within bounds, and the derivative.

    η + s ln(1 + e^{(a − η)/s}) − s ln(1 + e^{(η − b)/s}) is η within the bounds a and b, and
    never beyond them; s is 0.03 g/cm³. A prior on η is so one on densities that keep bounds.
    """
    result, slope = values.astype(float), np.ones(values.shape)
    if np.isfinite(low):
        off = (low - values) / _SOFT
        result = result + _SOFT * np.logaddexp(0.0, off)
        slope = slope - _logistic(off)
    if np.isfinite(high):
        off = (values - high) / _SOFT
        result = result - _SOFT * np.logaddexp(0.0, off)
        slope = slope - _logistic(off)
    return np.clip(result, low, high), np.maximum(slope, 0.0)


def _logistic(values: np.ndarray) -> np.ndarray:
    return 0.5 * (1.0 + np.tanh(0.5 * values))


@dataclass(frozen=True)
class Nuisances:
    """What is estimated beside the densities: names, stations and prior deviations."""

    names: tuple[str, ...]
    stations: np.ndarray
    deviations: np.ndarray

    @classmethod
    def of(cls, model: CountModel, priors: CountPriors) -> Nuisances:
        """Return those that are uncertain; the mean density comes first."""
        rows: list[tuple[str, int, float]] = [("mean", -1, priors.mean_deviation)]
        rows += [("flux", -1, priors.flux), ("flux_fall", -1, priors.flux_fall)]
        for station in range(model.stations):
            rows.append(("factor", station, priors.station))
            if model.turned is not None:
                rows.append(("azimuth", station, priors.azimuth_deg))
            if model.tilted is not None:
                rows.append(("elevation", station, priors.elevation_deg))
        rows = [row for row in rows if row[2] > 0 or row[0] == "mean"]
        names, stations, deviations = zip(*rows)
        return cls(tuple(names), np.array(stations), np.array(deviations))

    def columns(self, model: CountModel, line: Linearisation, bend: np.ndarray) -> np.ndarray:
        """Return ∂ ln μ over each, (n_data, n).

        Parameters
        ----------
        model, line
            What is counted, and its linearisation.
        bend
            (n_unknowns,) derivative of densities over what the prior is of (`bounded`).
        """
        everywhere: dict[str, Any] = {
            "mean": line.outside + line.voxels @ bend,
            "flux": np.ones(model.size),
            "flux_fall": line.steeper,
            "factor": np.ones(model.size),
            "azimuth": line.turned,
            "elevation": line.tilted,
        }
        result = np.empty((model.size, len(self.names)))
        for column, (name, station) in enumerate(zip(self.names, self.stations)):
            own = (model.station == station) | (station < 0)
            result[:, column] = np.where(own, everywhere[name], 0.0)
        return result

    def effect(self, columns: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Return what all but the mean add to ln μ, (n_data,)."""
        return columns[:, 1:] @ values[1:]
