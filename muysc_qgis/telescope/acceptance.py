"""How much a telescope collects from each direction.

With the offset (x, y) between a point of the front and a point of the back plane, the
acceptance of two facing areas is ∫∫ cos²θ/r² dA dA' = ∫∫ D²/(D² + x² + y²)² dA dA'. For
two squares of side d, displaced by (m d, n d), the four integrals become two over the
offset with triangular weights d − |x − m d|, and have a closed form.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from .geometry import TelescopeGeometry

#: How acceptance and solid angle are computed.
FORMULAS = ("exact", "paper")

#: Sullivan, J. D. (1971); Thomas, G. R. & Willis, D. M. (1972).
CITATIONS = (
    "Sullivan, J. D. (1971). Geometric factor and directional response of single and "
    "multi-element particle telescopes. Nuclear Instruments and Methods, 95(1), 5–11.",
    "Thomas, G. R. & Willis, D. M. (1972). Analytical derivation of the geometric factor of a "
    "particle detector having circular or rectangular geometry. Journal of Physics E: "
    "Scientific Instruments, 5(3), 260–263.",
)

#: Nodes of Gauss–Legendre quadrature on each side of a triangular weight. The integrand
#: is smooth over many pixels where it is used (pixels up to a tenth of the separation).
_NODES = 6

#: Pixels smaller than this part of the separation are integrated by quadrature: the
#: closed form is a fourth difference and loses (D/d)⁴ of its digits.
_SMALL = 0.1


@dataclass(frozen=True)
class Trajectories:
    """What a telescope collects along each of its trajectories.

    Arrays have shape (2 N_y − 1, 2 N_x − 1): the top row looks highest, the right
    column farthest to the right.
    """

    geometry: TelescopeGeometry
    #: One of `FORMULAS`.
    formula: str
    #: Acceptance 𝒯, cm² sr: counts per time are 𝒯 times the flux.
    acceptance_cm2_sr: np.ndarray
    #: Solid angle of all directions that belong to the trajectory, sr.
    solid_angle_sr: np.ndarray
    #: Area of the front plane from which the trajectory reaches the back plane, cm².
    detection_area_cm2: np.ndarray
    #: Length between the planes along the trajectory, cm.
    path_length_cm: np.ndarray

    @property
    def angular_resolution_mrad(self) -> np.ndarray:
        """Side √Ω of the solid angle, mrad.

        The response falls linearly from the middle to zero at the sides, so that half
        of this is its full width at half maximum.
        """
        return 1e3 * np.sqrt(self.solid_angle_sr)

    def acceptance_toward(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Return the acceptance of the trajectory in a direction, cm² sr.

        Linear between the trajectories, and towards 0 at the rim of the field of view.

        Parameters
        ----------
        x, y
            Tangents of the angles to the right and upwards; arrays that broadcast.

        Returns
        -------
        numpy.ndarray
            NaN outside the field of view.
        """
        padded = np.pad(self.acceptance_cm2_sr, 1)
        rows, columns = padded.shape
        with np.errstate(invalid="ignore"):
            column = self.geometry.bars_x + x / self.geometry.step
            row = self.geometry.bars_y - y / self.geometry.step
            seen = (column > 0) & (column < columns - 1) & (row > 0) & (row < rows - 1)
        column, row = np.where(seen, column, 0.5), np.where(seen, row, 0.5)
        i, j = row.astype(int), column.astype(int)
        down, right = row - i, column - j
        upper = (1 - right) * padded[i, j] + right * padded[i, j + 1]
        lower = (1 - right) * padded[i + 1, j] + right * padded[i + 1, j + 1]
        return np.where(seen, (1 - down) * upper + down * lower, np.nan)

    @property
    def etendue_cm2_sr(self) -> float:
        """Sum of all acceptances, cm² sr."""
        return float(self.acceptance_cm2_sr.sum())


def trajectories(geometry: TelescopeGeometry, formula: str = "exact") -> Trajectories:
    """Compute acceptance, solid angle, area and length of every trajectory.

    With r² = D² + d²(m² + n²) and N_P = (N_x − |m|)(N_y − |n|) pairs of pixels:

    ========  ==========================================  ============
    formula   acceptance                                  solid angle
    ========  ==========================================  ============
    exact     N_P times the full integral over two        that of the directions that
              squares, `pair_acceptance`                  two pixels share, exactly
    paper     N_P d⁴/r²                                   4 d²/r²
    ========  ==========================================  ============

    ``paper`` leaves out the obliquity cos²θ = D²/r² and so collects too much at large
    angles. The detection area N_P d² and the length r are the same in both.

    Parameters
    ----------
    geometry
        The telescope.
    formula
        One of `FORMULAS`.

    Raises
    ------
    MuyscError
        If there is no such formula.
    """
    if formula not in FORMULAS:
        raise MuyscError(f"There is no formula “{formula}”; use {' or '.join(FORMULAS)}.")
    d = geometry.pixel_size_cm
    m, n = np.abs(geometry.offset_x)[None, :], np.abs(geometry.offset_y)[:, None]
    pairs = (geometry.bars_x - m) * (geometry.bars_y - n)
    squared = geometry.separation_cm**2 + d**2 * (m**2 + n**2)
    if formula == "paper":
        pair, solid_angle = d**4 / squared, 4.0 * d**2 / squared
    else:
        # Symmetric in the signs: one quadrant serves all four.
        quadrant = np.arange(geometry.bars_x)[None, :], np.arange(geometry.bars_y)[:, None]
        pair = pair_acceptance(geometry, *quadrant)[n, m]
        solid_angle = _shared_solid_angle(geometry, *quadrant)[n, m]
    return Trajectories(
        geometry,
        formula,
        pairs * pair,
        solid_angle,
        pairs * d**2,
        np.sqrt(squared),
    )


def pair_acceptance(geometry: TelescopeGeometry, m: np.ndarray, n: np.ndarray) -> np.ndarray:
    """Return the acceptance of one pixel in front and one behind, exactly.

    By the closed form of two parallel rectangles (Thomas & Willis 1972) where it keeps
    its digits, else by Gauss–Legendre quadrature with triangular weights.

    Parameters
    ----------
    geometry
        The telescope.
    m, n
        Offsets of the pixels across and up; arrays that broadcast.

    Returns
    -------
    numpy.ndarray
        cm² sr.
    """
    step = geometry.step
    m, n = np.asarray(m, dtype=float), np.asarray(n, dtype=float)
    if step < _SMALL:
        node, weight = np.polynomial.legendre.leggauss(_NODES)
        offset = np.concatenate([(node - 1) / 2, (node + 1) / 2])
        triangle = np.concatenate([weight, weight]) / 2 * (1 - np.abs(offset))
        total = np.zeros(np.broadcast_shapes(m.shape, n.shape))
        for u, weight_u in zip(offset, triangle):
            for v, weight_v in zip(offset, triangle):
                squared = step**2 * ((m + u) ** 2 + (n + v) ** 2)
                total += weight_u * weight_v / (1.0 + squared) ** 2
        return np.asarray(step**4 * total * geometry.separation_cm**2)
    pair = sum(
        sign_x * sign_y * _primitive(step * (m + x), step * (n + y))
        for x, sign_x in _SECOND_DIFFERENCE
        for y, sign_y in _SECOND_DIFFERENCE
    )
    return np.asarray(pair) * geometry.separation_cm**2


#: Offsets and factors of a second difference.
_SECOND_DIFFERENCE = ((-1.0, 1.0), (0.0, -2.0), (1.0, 1.0))


def _primitive(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return H with ∂⁴H/∂x²∂y² = 1/(1 + x² + y²)², lengths in separations.

    H = ½ [x √(1+y²) atan(x/√(1+y²)) + y √(1+x²) atan(y/√(1+x²)) − ½ ln(1+x²+y²)]: π
    times the sum of the textbook view factor of parallel rectangles.
    """
    root_x, root_y = np.sqrt(1 + x**2), np.sqrt(1 + y**2)
    return 0.5 * (
        x * root_y * np.arctan(x / root_y)
        + y * root_x * np.arctan(y / root_x)
        - 0.5 * np.log(1 + x**2 + y**2)
    )


def plane_etendue(geometry: TelescopeGeometry) -> float:
    """Return the acceptance of the two whole planes, cm² sr: Sullivan's closed form.

    G = D² ln[…] + … for two equal parallel rectangles (Sullivan 1971, for sides a and b
    at a distance D), written as the second difference of one primitive. The exact
    acceptances of all trajectories add up to it.
    """
    a, b = (bars * geometry.step for bars in (geometry.bars_x, geometry.bars_y))
    zero = np.zeros(())
    corner = _primitive(zero + a, zero + b)
    sides = _primitive(zero + a, zero) + _primitive(zero, zero + b)
    return float(4 * (corner - sides + _primitive(zero, zero)) * geometry.separation_cm**2)


def _shared_solid_angle(geometry: TelescopeGeometry, m: np.ndarray, n: np.ndarray) -> np.ndarray:
    """Return the solid angle of all directions from one pixel to another, sr.

    They fill the rectangle (m ± 1) d × (n ± 1) d at the distance D, seen from a point.
    """
    step = geometry.step

    def corner(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return np.asarray(np.arctan(x * y / np.sqrt(1 + x**2 + y**2)))

    left, right = step * (m - 1), step * (m + 1)
    low, high = step * (n - 1), step * (n + 1)
    return corner(right, high) - corner(left, high) - corner(right, low) + corner(left, low)
