"""Tomography of a volcano's size, and the Shepp–Logan head side by side with ASTRA."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

import numpy as np
from measure import ROOT, Row, in_fresh_process, print_table

from muysc_qgis.tomography.figures_of_merit import relative_error
from muysc_qgis.tomography.ground import HeightField, holds_rock
from muysc_qgis.tomography.lattice import Lattice
from muysc_qgis.tomography.operators import StoredPaths
from muysc_qgis.tomography.parallel_beam import ParallelBeam, fbp, gridrec
from muysc_qgis.tomography.phantoms import SHEPP_LOGAN, ellipse_image, ellipse_projections
from muysc_qgis.tomography.projector import Paths, most_entries, path_matrix, paths_through
from muysc_qgis.tomography.rays import Rays, joined, rays_from_station
from muysc_qgis.tomography.rock import rock_along
from muysc_qgis.tomography.solvers import Options, reconstruct
from muysc_qgis.tomography.system import System
from muysc_qgis.tomography.voxels import VoxelGrid

#: The survey of the figures: stations around a dome, full apertures in degrees, pixels, voxels.
_STATIONS, _AZIMUTH_DEG, _ZENITH_DEG, _PIXELS, _VOXELS = 42, 100.0, 28.0, 100, 100
#: Half width and height of the dome, m.
_RADIUS_M, _HEIGHT_M = 1000.0, 800.0


def survey_rays() -> Rays:
    """Return the rays of stations on a circle at three heights, looking at the axis."""
    fans = []
    for view in range(_STATIONS):
        azimuth = 360.0 * view / _STATIONS
        towards = np.radians(azimuth)
        distance = 1.2 * _RADIUS_M
        station = (-distance * np.sin(towards), -distance * np.cos(towards), 50.0 * (view % 3))
        fans.append(
            rays_from_station(
                station,
                azimuth + np.linspace(-0.5, 0.5, _PIXELS) * _AZIMUTH_DEG,
                1.0 + np.linspace(1.0, 0.0, _PIXELS) * _ZENITH_DEG,
                view,
            )
        )
    return joined(fans)


def dome() -> HeightField:
    axis = np.arange(-60, 61) * 20.0
    square = (axis[:, None] ** 2 + axis[None, :] ** 2) / _RADIUS_M**2
    return HeightField((axis[0], axis[0]), (20.0, 20.0), _HEIGHT_M * np.exp(-1.5 * square))


def survey_paths(whole: bool) -> Paths:
    """Return the paths through the whole volume, or through the dome's rock alone."""
    size = (2 * _RADIUS_M / _VOXELS, 2 * _RADIUS_M / _VOXELS, _HEIGHT_M / _VOXELS)
    grid = VoxelGrid((-_RADIUS_M, -_RADIUS_M, 0.0), size, (_VOXELS,) * 3)
    rays = survey_rays()
    if whole:
        return paths_through(grid, rays)
    ground = dome()
    return paths_through(grid, rays, rock_along(grid, rays, ground), holds_rock(grid, ground))


def run_survey(whole: bool) -> None:
    """Print the seconds of paths, matrix, SIRT and ART, the entries, and the worst row sum."""
    times = [time.perf_counter()]

    def lap() -> None:
        times.append(time.perf_counter())

    paths = survey_paths(whole)
    lap()
    matrix = path_matrix(paths)
    lap()
    total = np.asarray(matrix.sum(axis=1, dtype=float)).ravel()
    length = paths.lengths_m()
    worst = np.max(np.abs(total - length)[length > 1] / length[length > 1])
    projector = StoredPaths(matrix)
    count = matrix.shape[1]
    density = np.random.default_rng(0).uniform(2.0, 3.0, count)
    system = System(
        projector, projector.forward(density), Lattice((1.0,), np.ones(count, bool)),
        paths.rays.view,
    )  # fmt: skip
    lap()
    sirt = reconstruct("sirt", system, Options(iterations=50))
    lap()
    art = reconstruct("art", system, Options(iterations=1))
    lap()
    steps = np.diff(times)
    print(
        steps[0], steps[1], steps[3], steps[4], matrix.nnz, most_entries(paths), worst,
        sirt.misfit[-1] / sirt.misfit[0], art.misfit[-1] / art.misfit[0],
    )  # fmt: skip


def time_survey() -> None:
    for whole in (True, False):
        words = in_fresh_process(
            "from tomography import *\nfrom measure import *\n"
            f"run_survey({whole}); print(peak_mib())"
        )
        paths, matrix, sirt, art, entries, most, worst, by_sirt, by_art, peak = map(float, words)
        print_table(
            f"{_STATIONS} stations × {_PIXELS}² rays, {_VOXELS}³ voxels, "
            + ("all of them rock" if whole else "rock below a dome"),
            [
                Row("rays, rock along them, voxels with rock", paths),
                Row("path matrix", matrix, f"{entries / 1e6:.1f} million entries of at most "
                    f"{most / 1e6:.1f}; rows within {worst:.1e} (limit 90 s)"),
                Row("50 iterations of SIRT", sirt, f"misfit × {by_sirt:.3g} (limit 60 s)"),
                Row("1 sweep of ART, ray by ray", art, f"misfit × {by_art:.3g} (limit 60 s)"),
                Row("everything", paths + matrix + sirt + art, "limit 6144 MiB", peak),
            ],
        )  # fmt: skip


#: Method, sweeps, and the name and number of iterations per sweep that ASTRA gives it.
_SHARED = (("art", 3, "ART"), ("sart", 3, "SART"), ("sirt", 50, "SIRT"))


def compare_with_astra(size: int = 256, angles: int = 180) -> None:
    """Reconstruct the head from the same exact projections at the same number of iterations.

    Ours should take no more than ASTRA's time, at an error of no more than 1.05 times its.
    """
    try:
        import astra
    except ImportError:
        astra = None
        print(
            "\nastra-toolbox is not installed, so nothing is compared with it; it comes with "
            f"`{sys.executable} -m pip install astra-toolbox==2.5.0` (440 MB)"
        )
    beam = ParallelBeam.around(size, angles)
    truth = ellipse_image(SHEPP_LOGAN, size)
    data = ellipse_projections(SHEPP_LOGAN, beam.angle_deg, beam.offset * 2 / size) * size / 2
    start = time.perf_counter()
    paths = beam.paths()
    stored = StoredPaths(path_matrix(paths))
    rows = [Row("path matrix, once", time.perf_counter() - start)]
    system = System(stored, data.ravel(), beam.lattice(), paths.rays.view)
    steps = {"ART": data.size, "SART": angles, "SIRT": 1}
    for name, sweeps, peer in _SHARED:
        options = Options(iterations=sweeps, relaxation=1.0, start=0.0, nonnegative=False)
        seconds, result = _timed(lambda n=name, o=options: reconstruct(n, system, o))
        error = relative_error(result.values.reshape(size, size), truth)
        rows.append(Row(f"{name}, {sweeps} sweeps", seconds, f"error {error:.4f}"))
        if astra:
            # The same rays: line integrals by Siddon's paths.
            theirs, image = _astra(astra, beam, data, peer, sweeps * steps[peer], "line")
            rows.append(_beside(f"  ASTRA {peer}", theirs, image, truth, seconds, error))
    for name, direct in (("fbp", fbp), ("gridrec", gridrec)):
        seconds, image = _timed(lambda d=direct: d(beam, data))
        error = relative_error(image, truth)
        rows.append(Row(name, seconds, f"error {error:.4f}"))
        if astra and name == "fbp":
            for kernel in ("line", "linear", "strip"):
                theirs, image = _astra(astra, beam, data, "FBP", 1, kernel)
                label = f"  ASTRA FBP, {kernel}"
                rows.append(_beside(label, theirs, image, truth, seconds, error))
    print_table(f"Shepp–Logan head, {size}², {angles} angles, exact projections", rows)


def _timed(function: Callable[[], object], repeats: int = 2) -> tuple[float, object]:
    """Return the shortest time of a few runs, and the result."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        result = function()
        times.append(time.perf_counter() - start)
    return min(times), result


def _beside(
    label: str, theirs: float, image: np.ndarray, truth: np.ndarray, seconds: float, error: float
) -> Row:
    other = relative_error(image, truth)
    time_share, error_share = seconds / theirs, error / other
    note = f"error {other:.4f}; ours takes {time_share:.2f} of its time at {error_share:.3f} of its"
    return Row(label, theirs, f"{note} error")


def _astra(
    astra: object, beam: ParallelBeam, data: np.ndarray, name: str, iterations: int, kernel: str
) -> tuple[float, np.ndarray]:
    """Return seconds and image [x, y] of one of ASTRA's methods on the processor."""
    volume = astra.create_vol_geom(beam.size, beam.size)
    geometry = astra.create_proj_geom("parallel", 1.0, beam.detectors, np.radians(beam.angle_deg))
    projector = astra.create_projector(kernel, geometry, volume)
    projections = astra.data2d.create("-sino", geometry, data)

    def run() -> np.ndarray:
        image = astra.data2d.create("-vol", volume, 0.0)
        settings = astra.astra_dict(name)
        settings.update(
            ReconstructionDataId=image, ProjectionDataId=projections, ProjectorId=projector
        )
        if name == "ART":
            settings["option"] = {"Lambda": 1.0}
        algorithm = astra.algorithm.create(settings)
        astra.algorithm.run(algorithm, iterations)
        result = astra.data2d.get(image)
        astra.algorithm.delete(algorithm)
        astra.data2d.delete(image)
        return result

    seconds, image = _timed(run)
    astra.data2d.delete(projections)
    astra.projector.delete(projector)
    # Its rows run from the top.
    return seconds, image[::-1].T


if __name__ == "__main__":
    print(f"Benchmarks of {ROOT.name}; in one process, two cores")
    time_survey()
    compare_with_astra()
