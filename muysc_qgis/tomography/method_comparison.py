"""Every method on the Shepp–Logan head: seconds and errors side by side."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, part, report, silent
from .figures_of_merit import relative_error
from .libraries import scipy_part
from .operators import StoredPaths
from .parallel_beam import DIRECT, ParallelBeam
from .phantoms import SHEPP_LOGAN, ellipse_image, ellipse_projections
from .projector import MEMORY_LIMIT, path_matrix
from .solvers import METHODS, PARALLEL_ONLY, Options, reconstruct
from .system import System

#: Every method by name, with its title.
COMPARABLE = {**{name: method.title for name, method in METHODS.items()}, **PARALLEL_ONLY}

#: Pixels along an edge, projections, and noise in percent that can be asked for.
SIZES, ANGLES, NOISES = (16, 1024), (2, 2000), (0.0, 100.0)

#: Pixel edges that a ray crosses per unit of length, |cos θ| + |sin θ| on average over all
#: directions, and the bytes that each crossing takes in the path matrix.
_CROSSINGS, _BYTES = 4 / np.pi, 8

#: What the Bayesian method must know besides, in pixels: the standard deviation of what the
#: pixels' edges make of the projections (0.33 to 0.43 from 32² to 256²), and the prior's range.
_EDGE_ERROR, _RANGE = 0.4, 4.0

#: Columns of the table of a comparison.
COLUMNS = (
    "method", "title", "iterations", "seconds", "relative_error", "mean_absolute_error",
    "data_misfit", "matrix_seconds",
)  # fmt: skip


@dataclass(frozen=True)
class MethodResult:
    """What one method makes of the head."""

    method: str
    #: Wall time, without that of the path matrix, which is shared.
    seconds: float
    #: ‖R − T‖₂ / ‖T‖₂.
    relative_error: float
    iterations: int
    #: (size, size) [x, y].
    image: np.ndarray
    #: Misfit before each iteration and after the last, over that of an empty image; empty where
    #: the method knows none on its way.
    misfit: np.ndarray


@dataclass(frozen=True)
class Comparison:
    """All results, and what they have in common."""

    truth: np.ndarray
    results: tuple[MethodResult, ...]
    #: Wall time of building the path matrix; 0 where no method needs it.
    matrix_seconds: float
    angles: int
    #: Standard deviation of the data's errors in percent of their largest value.
    noise_percent: float

    @property
    def best(self) -> MethodResult:
        """The result of the smallest relative error."""
        return min(self.results, key=lambda result: result.relative_error)

    @property
    def grey_error(self) -> float:
        """Relative error of one grey level, which a method must beat to have seen anything."""
        return relative_error(np.full(self.truth.shape, self.truth.mean()), self.truth)

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a reader must know before drawing conclusions, a sentence each."""
        blind = [one.method for one in self.results if one.relative_error >= self.grey_error]
        if not blind:
            return ()
        return (
            f"No better than one grey level: {', '.join(blind)}; more iterations or another "
            "regularisation may help.",
        )


def rows(comparison: Comparison) -> list[tuple[object, ...]]:
    """Return the rows of the table, in the order of `COLUMNS`."""
    return [
        (
            result.method, COMPARABLE[result.method], result.iterations, result.seconds,
            result.relative_error, float(np.abs(result.image - comparison.truth).mean()),
            float(result.misfit[-1]) if len(result.misfit) else float("nan"),
            comparison.matrix_seconds,
        )
        for result in comparison.results
    ]  # fmt: skip


def check_setting(
    size: int, angles: int, methods: Sequence[str], noise_percent: float = 0.0
) -> None:
    """Refuse what cannot be compared, before anything is computed.

    Parameters
    ----------
    size, angles, methods, noise_percent
        As in `compare_methods`.

    Raises
    ------
    MuyscError
        If a method is unknown or none is given, a number is out of its range, or the path matrix
        does not fit the memory.
    """
    unknown = [name for name in methods if name not in COMPARABLE]
    if unknown:
        raise MuyscError(
            f"“{', '.join(unknown)}” cannot be compared; choose among {', '.join(COMPARABLE)}."
        )
    if not methods:
        raise MuyscError(
            f"There is no method to compare; choose at least one of {', '.join(COMPARABLE)}."
        )
    for what, value, (low, high) in (
        ("image's edge in pixels", size, SIZES),
        ("number of projections", angles, ANGLES),
        ("noise in percent", noise_percent, NOISES),
    ):
        if not low <= value <= high:
            raise MuyscError(f"The {what} is {value:g}; give one from {low:g} to {high:g}.")
    need = angles * size**2 * _CROSSINGS * _BYTES
    if need > MEMORY_LIMIT and any(name in METHODS for name in methods):
        fits = int((size**2 * MEMORY_LIMIT / need) ** 0.5)
        raise MuyscError(
            f"The paths of {angles} projections through {size} × {size} pixels need "
            f"{need / 2**30:.3g} GiB, more than the limit of {MEMORY_LIMIT / 2**30:.3g} GiB; use "
            f"at most {fits} pixels along the edge, or fewer projections."
        )


def compare_methods(
    size: int,
    angles: int,
    methods: Sequence[str] = tuple(COMPARABLE),
    options: Options | None = None,
    noise_percent: float = 0.0,
    progress: Progress = silent,
) -> Comparison:
    """Reconstruct the head from its exact projections by several methods.

    Parameters
    ----------
    size, angles
        Pixels along an edge, and projections evenly spaced over 180°.
    methods
        Keys of `COMPARABLE`.
    options
        What to change of the methods' defaults.
    noise_percent
        Standard deviation of the data's errors in percent of their largest value; 0 for none.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If the setting cannot be compared (`check_setting`).
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    check_setting(size, angles, methods, noise_percent)
    options = options or Options()
    # Loaded before the first method is timed.
    scipy_part("fft")
    beam = ParallelBeam.around(size, angles)
    truth = ellipse_image(SHEPP_LOGAN, size)
    noise = noise_percent / 100
    data = _projections(beam, noise, options.seed)
    system, matrix_seconds, ready = None, 0.0, 0.0
    if any(name in METHODS for name in methods):
        ready = 0.1
        start = time.perf_counter()
        system = _system(beam, data, part(progress, 0.0, ready))
        matrix_seconds = time.perf_counter() - start
    results = []
    for number, name in enumerate(methods):
        begin, end = (ready + (1 - ready) * (number + n) / len(methods) for n in (0, 1))
        share = part(progress, begin, end)
        report(share, 0.0)
        start = time.perf_counter()
        # There is no system where all methods are direct.
        if system is None or name in DIRECT:
            image, iterations, misfit = DIRECT[name](beam, data), 1, np.empty(0)
        else:
            one, changed = _prepared(name, system, options, noise)
            result = reconstruct(name, one, changed, share)
            image, iterations = result.values.reshape(size, size), result.iterations_done
            misfit = result.misfit * _misfit_scale(one)
        seconds = time.perf_counter() - start
        error = relative_error(image, truth)
        results.append(MethodResult(name, seconds, error, iterations, image, misfit))
    return Comparison(truth, tuple(results), matrix_seconds, angles, noise_percent)


def _projections(beam: ParallelBeam, noise: float, seed: int) -> np.ndarray:
    """Return the (angles, detectors) line integrals of the head, with noise on them."""
    # Pixels are units here, and the head's square is two wide.
    offset = beam.offset * 2 / beam.size
    data = ellipse_projections(SHEPP_LOGAN, beam.angle_deg, offset) * beam.size / 2
    if noise:
        draws = np.random.default_rng(seed).standard_normal(data.shape)
        data = data + noise * data.max() * draws
    return data


def _system(beam: ParallelBeam, data: np.ndarray, progress: Progress) -> System:
    paths = beam.paths()
    matrix = path_matrix(paths, progress=progress)
    return System(StoredPaths(matrix), data.ravel(), beam.lattice(), paths.rays.view)


def _prepared(name: str, system: System, options: Options, noise: float) -> tuple[System, Options]:
    """Return system and options with what the Bayesian method needs besides."""
    if name != "bayes":
        return system, options
    error = np.hypot(noise * float(system.data.max()), _EDGE_ERROR)
    return (
        replace(system, errors=np.full(len(system.data), error)),
        replace(options, correlation_length_m=_RANGE),
    )


def _misfit_scale(system: System) -> float:
    """Return what takes a misfit to that over the root mean square of the data."""
    if system.errors is None:
        return 1.0
    # Rays that miss the image count in neither.
    return float(system.errors[0] / np.sqrt(np.mean(np.square(system.usable().data))))
