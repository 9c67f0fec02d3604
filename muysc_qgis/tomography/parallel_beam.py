"""Parallel rays all around an image: their paths, and the two direct reconstructions.

For comparing methods on the Shepp–Logan head only; muograms are no parallel projections.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from .lattice import Lattice
from .libraries import scipy_part
from .projector import Paths, paths_through
from .rays import Rays
from .voxels import VoxelGrid

#: Width of the gridding kernel, in samples.
_KERNEL = 4

#: Points per detector at which filtered projections are looked up.
_FINENESS = 16


@dataclass(frozen=True)
class ParallelBeam:
    """Square image of unit pixels and detectors of unit width, both around the origin.

    Lengths count in pixels; images are [x, y], projections [angle, detector], and a ray is the
    line x cos θ + y sin θ = s.

    Raises
    ------
    MuyscError
        If there is nothing to project.
    """

    #: Pixels along an edge.
    size: int
    #: (n_angles,) θ.
    angle_deg: np.ndarray
    detectors: int

    def __post_init__(self) -> None:
        if self.size < 2 or self.detectors < 2 or len(self.angle_deg) < 1:
            raise MuyscError(
                f"The beam has {len(self.angle_deg)} angles and {self.detectors} detectors for "
                f"{self.size} pixels; give at least 1, 2 and 2."
            )

    @classmethod
    def around(cls, size: int, angles: int) -> ParallelBeam:
        """Return a beam of evenly spaced angles over 180°, wide enough for the whole image."""
        return cls(size, 180.0 * np.arange(angles) / max(angles, 1), int(np.ceil(size * 2**0.5)))

    @property
    def offset(self) -> np.ndarray:
        """(detectors,) s of each."""
        return np.arange(self.detectors) - (self.detectors - 1) / 2

    @property
    def centres(self) -> np.ndarray:
        """(size,) x or y of the pixels' centres."""
        return np.arange(self.size) - (self.size - 1) / 2

    def paths(self) -> Paths:
        """Return the paths of all rays, one angle after the other; a view is an angle."""
        angle = np.repeat(np.radians(self.angle_deg), self.detectors)
        offset = np.tile(self.offset, len(self.angle_deg))
        cosine, sine = np.cos(angle), np.sin(angle)
        level = np.zeros(len(angle))
        direction = np.stack([-sine, cosine, level], axis=1)
        origin = np.stack([offset * cosine, offset * sine, level], axis=1)
        origin -= 2.0 * self.size * direction
        view = np.repeat(np.arange(len(self.angle_deg)), self.detectors)
        low = -self.size / 2
        grid = VoxelGrid((low, low, -0.5), (1.0, 1.0, 1.0), (self.size, self.size, 1))
        return paths_through(grid, Rays(origin, direction, view))

    def lattice(self) -> Lattice:
        """Return the neighbourhoods of the pixels."""
        return Lattice((1.0, 1.0), np.ones((self.size, self.size), bool))

    def _filtered(self, projections: np.ndarray) -> tuple[np.ndarray, int]:
        """Return the transforms of filtered projections and their padded length.

        The ramp is that of Ramachandran & Lakshminarayanan 1971, limited to the detectors' band
        in space (Kak & Slaney 1988, equation 3.61), which leaves the mean as it is. A reading
        stands for the whole width of its detector, with the transform sinc f, and a pixel holds
        the mean over its square, sinc u sinc v; both come on top.
        """
        if projections.shape != (len(self.angle_deg), self.detectors):
            raise MuyscError(
                f"The projections are {projections.shape} for {len(self.angle_deg)} angles and "
                f"{self.detectors} detectors; give one value for each."
            )
        fft = scipy_part("fft")
        length = 2 * fft.next_fast_len(max(self.detectors, self.size), real=True)
        place = np.arange(length)
        place = np.minimum(place, length - place)
        kernel = np.zeros(length)
        kernel[0] = 0.25
        odd = place % 2 == 1
        kernel[odd] = -1.0 / (np.pi * place[odd]) ** 2
        ramp = fft.rfft(kernel).real
        transform = fft.rfft(projections, length, axis=1) * ramp
        frequency = np.arange(transform.shape[1]) / length
        angle = np.radians(self.angle_deg)[:, None]
        square = np.sinc(frequency * np.cos(angle)) * np.sinc(frequency * np.sin(angle))
        transform *= np.sinc(frequency) * square
        return transform, length


def fbp(beam: ParallelBeam, projections: np.ndarray) -> np.ndarray:
    """Return the filtered back-projection, (size, size).

    Each filtered projection is refined sixteenfold by Fourier transform and looked up at the
    nearest point. Cost: O(angles · size²).

    Raises
    ------
    MuyscError
        If the projections do not fit the beam.
    """
    fft = scipy_part("fft")
    transform, length = beam._filtered(projections)
    fine = fft.irfft(transform, length * _FINENESS, axis=1).astype(np.float32) * _FINENESS
    image = np.zeros((beam.size, beam.size), np.float32)
    # The image's corners may lie before the first detector, in the padding's end.
    ahead = int(np.ceil(max(0.0, beam.size * 2**-0.5 + beam.offset[0]))) + 1
    fine = np.roll(fine, ahead * _FINENESS, axis=1)
    first = beam.offset[0] - ahead
    for angle, projection in zip(np.radians(beam.angle_deg), fine):
        x = ((beam.centres * np.cos(angle) - first) * _FINENESS + 0.5).astype(np.float32)
        y = (beam.centres * np.sin(angle) * _FINENESS).astype(np.float32)
        image += projection.take((x[:, None] + y).astype(np.intp), mode="clip")
    return image.astype(float) * (np.pi / len(beam.angle_deg))


def gridrec(beam: ParallelBeam, projections: np.ndarray) -> np.ndarray:
    """Return the reconstruction by gridding in the frequency plane, (size, size).

    The filtered projections' transforms are samples of the image's on rays through the origin;
    spread onto a regular grid with a Kaiser–Bessel kernel (O'Sullivan 1985,
    doi:10.1109/TMI.1985.4307723; its shape after Beatty, Nishimura & Pauly 2005,
    doi:10.1109/TMI.2005.848376), one inverse transform gives the image, from which the kernel's
    own transform is divided out. Cost: O(angles · detectors + size² log size).

    Raises
    ------
    MuyscError
        If the projections do not fit the beam.
    """
    fft = scipy_part("fft")
    half, length = beam._filtered(projections)
    # The projections are real: twice the real part of one half gives both.
    number = np.arange(half.shape[1])
    both = np.full(half.shape[1], 2.0)
    both[0] = both[-1] = 1.0
    angle = np.radians(beam.angle_deg)[:, None]
    u, v = number * np.cos(angle), number * np.sin(angle)
    # Detectors start at offset[0], pixels at centres[0] instead of at a whole number.
    start = int(np.floor(beam.centres[0]))
    shift = beam.centres[0] - start
    phase = (u + v) * shift - number * beam.offset[0]
    samples = half * both * np.exp(2j * np.pi * phase / length)

    oversampling = length / beam.size
    shape = np.pi * np.sqrt((_KERNEL / oversampling * (oversampling - 0.5)) ** 2 - 0.8)
    total = np.zeros(length * length, complex)
    columns, across = _spread(u, length, shape)
    rows, along = _spread(v, length, shape)
    for column, weight in zip(columns, across):
        for row, other in zip(rows, along):
            part = (samples * (weight * other)).ravel()
            where = (column * length + row).ravel()
            total.real += np.bincount(where, part.real, length * length)
            total.imag += np.bincount(where, part.imag, length * length)
    image = fft.ifft2(total.reshape(length, length)).real * length**2
    pixels = start + np.arange(beam.size)
    taper = _kernel_transform(pixels / length, shape)
    image = image[np.ix_(pixels % length, pixels % length)]
    image /= taper[:, None] * taper[None, :]
    return image * (np.pi / len(beam.angle_deg) / length)


def _spread(
    place: np.ndarray, length: int, shape: float
) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Return the grid points around places and the kernel's weights there."""
    first = np.ceil(place - _KERNEL / 2).astype(np.int64)
    points, weights = [], []
    for step in range(_KERNEL):
        point = first + step
        inner = np.maximum(1 - ((point - place) * 2 / _KERNEL) ** 2, 0.0)
        points.append(point % length)
        weights.append(np.i0(shape * np.sqrt(inner)))
    return points, weights


def _kernel_transform(x: np.ndarray, shape: float) -> np.ndarray:
    """Return the Fourier transform of the kernel."""
    root = np.sqrt(shape**2 - (np.pi * _KERNEL * x) ** 2)
    return _KERNEL * np.sinh(root) / root


#: The direct reconstructions by name.
DIRECT: dict[str, Callable[[ParallelBeam, np.ndarray], np.ndarray]] = {
    "fbp": fbp,
    "gridrec": gridrec,
}
