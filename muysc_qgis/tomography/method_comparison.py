"""Every method on the Shepp–Logan head: seconds and errors side by side."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import MuyscError
from ..progress import Progress, part, report, silent
from .figures_of_merit import relative_error
from .operators import StoredPaths
from .parallel_beam import DIRECT, ParallelBeam
from .phantoms import SHEPP_LOGAN, ellipse_image, ellipse_projections
from .projector import path_matrix
from .solvers import METHODS, Options, reconstruct
from .system import System

#: Methods that are compared unless others are asked for: all that need no prior of their own.
COMPARABLE = (*(name for name in METHODS if name != "bayes"), *DIRECT)


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


@dataclass(frozen=True)
class Comparison:
    """All results, and what they have in common."""

    truth: np.ndarray
    results: tuple[MethodResult, ...]
    #: Wall time of building the path matrix; 0 where no method needs it.
    matrix_seconds: float


def compare_methods(
    size: int,
    angles: int,
    methods: Sequence[str] = COMPARABLE,
    options: Options | None = None,
    noise: float = 0.0,
    progress: Progress = silent,
) -> Comparison:
    """Reconstruct the head from its exact projections by several methods.

    Parameters
    ----------
    size, angles
        Pixels along an edge, and projections evenly spaced over 180°.
    methods
        Names out of `COMPARABLE`.
    options
        What to change of the methods' defaults.
    noise
        Standard deviation of the data's errors over their largest value; 0 for none.
    progress
        Told the share done.

    Raises
    ------
    MuyscError
        If a method is not comparable or the path matrix does not fit the memory.
    Cancelled
        If the receiver of the progress asks for a stop.
    """
    unknown = [name for name in methods if name not in COMPARABLE]
    if unknown or not methods:
        raise MuyscError(
            f"“{', '.join(unknown)}” cannot be compared; choose among {', '.join(COMPARABLE)}."
        )
    beam = ParallelBeam.around(size, angles)
    truth = ellipse_image(SHEPP_LOGAN, size)
    # Pixels are units here, and the head's square is two wide.
    data = ellipse_projections(SHEPP_LOGAN, beam.angle_deg, beam.offset * 2 / size) * size / 2
    if noise:
        seed = options.seed if options else 1
        data = data + noise * data.max() * np.random.default_rng(seed).standard_normal(data.shape)
    system, matrix_seconds = None, 0.0
    if any(name in METHODS for name in methods):
        start = time.perf_counter()
        paths = beam.paths()
        matrix = path_matrix(paths, progress=part(progress, 0.0, 0.2))
        matrix_seconds = time.perf_counter() - start
        system = System(StoredPaths(matrix), data.ravel(), beam.lattice(), paths.rays.view)
    results = []
    for number, name in enumerate(methods):
        share = part(
            progress, 0.2 + 0.8 * number / len(methods), 0.2 + 0.8 * (number + 1) / len(methods)
        )
        report(share, 0.0)
        start = time.perf_counter()
        if name in DIRECT:
            image, iterations = DIRECT[name](beam, data), 1
        else:
            assert system is not None  # noqa: S101 - made above for every such method
            result = reconstruct(name, system, options, share)
            image, iterations = result.values.reshape(size, size), result.iterations_done
        seconds = time.perf_counter() - start
        results.append(MethodResult(name, seconds, relative_error(image, truth), iterations, image))
    return Comparison(truth, tuple(results), matrix_seconds)
