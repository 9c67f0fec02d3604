"""Cubic Hermite curves: values and slopes at knots, fourth-order accurate between."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


def hermite(
    t: np.ndarray, width: np.ndarray, y0: np.ndarray, y1: np.ndarray, d0: np.ndarray, d1: np.ndarray
) -> np.ndarray:
    """Return the cubic through two knots with given values and slopes.

    Parameters
    ----------
    t
        Position between the knots, 0 to 1.
    width
        Distance of the knots.
    y0, y1, d0, d1
        Values and slopes at the knots. All arguments broadcast.
    """
    rise = y1 - y0
    left = width * d0 - rise
    right = rise - width * d1
    return y0 + t * (rise + (1.0 - t) * (left + t * (right - left)))


def spline_slopes(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return the slopes at its knots of the cubic spline through points.

    The second derivative is continuous at every inner knot, and the third at the second
    and the last but one ("not a knot"): C. de Boor, A Practical Guide to Splines (2001),
    chapter IV. Rock and muons shall not need scipy, which some QGIS come without.

    Parameters
    ----------
    x, y
        (n,) knots, x increasing, n at least 4.
    """
    width = np.diff(x)
    secant = np.diff(y) / width
    left, right = width[:-1], width[1:]
    inner = np.arange(1, len(x) - 1)
    system, known = np.zeros((len(x), len(x))), np.empty(len(x))
    system[inner, inner - 1] = right
    system[inner, inner] = 2.0 * (left + right)
    system[inner, inner + 1] = left
    known[inner] = 3.0 * (right * secant[:-1] + left * secant[1:])
    # Both ends alike, seen from outside.
    for end, step, near, far in ((0, 1, 0, 1), (-1, -1, -1, -2)):
        both = width[near] + width[far]
        system[end, end], system[end, end + step] = width[far], both
        known[end] = (
            (width[near] + 2.0 * both) * width[far] * secant[near] + width[near] ** 2 * secant[far]
        ) / both
    return np.linalg.solve(system, known)


@dataclass(frozen=True)
class HermiteCurve:
    """A smooth curve through knots with known slopes."""

    #: (n,) increasing abscissas.
    x: np.ndarray
    #: (n,) ordinates.
    y: np.ndarray
    #: (n,) dy/dx.
    slope: np.ndarray

    @classmethod
    def through(cls, x: np.ndarray, y: np.ndarray) -> HermiteCurve:
        """Return the cubic spline through four or more points."""
        return cls(x, y, spline_slopes(x, y))

    def __call__(self, x: np.ndarray) -> np.ndarray:
        """Return y at abscissas of any shape; NaN outside the knots."""
        x = np.asarray(x, dtype=float)
        y = self.between(*self.locate(x))
        return np.where((x >= self.x[0]) & (x <= self.x[-1]), y, np.nan)

    def locate(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the knot before each abscissa and the position between it and the next."""
        k = np.clip(np.searchsorted(self.x, x, side="right") - 1, 0, len(self.x) - 2)
        return k, (x - self.x[k]) / (self.x[k + 1] - self.x[k])

    def between(self, k: np.ndarray, t: np.ndarray) -> np.ndarray:
        """Return y at positions that `locate` found, on this curve or one of the same knots."""
        width = self.x[k + 1] - self.x[k]
        return hermite(t, width, self.y[k], self.y[k + 1], self.slope[k], self.slope[k + 1])
