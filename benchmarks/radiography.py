"""Radiography of Vesuvius: ours, the naive way, and mulder, in one run."""

from __future__ import annotations

import numpy as np
from measure import (
    DEM,
    DETECTOR,
    ROOT,
    TARGET,
    Row,
    in_fresh_process,
    print_table,
    seconds_of,
)

from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.sight import Sight, take_sight
from muysc_qgis.topography.tracing import trace_terrain
from muysc_qgis.workflows.simulation import Telescope, simulate

#: Length (m) of the steps of the naive way.
_NAIVE_STEP_M = 10.0
#: Kinetic energies of the peer's integrated flux.
_ENERGIES = 48


def sight_on_vesuvius() -> Sight:
    return take_sight(open_dem(DEM), DETECTOR, TARGET)


def naive_thickness(sight: Sight, azimuth: np.ndarray, elevation: np.ndarray) -> np.ndarray:
    """Step along every ray and look the ground up by nearest cell: the textbook way."""
    dem = sight.frame.dem
    heights = dem.read(0, 0, dem.columns, dem.rows)
    distance = np.arange(_NAIVE_STEP_M / 2, 16_000.0, _NAIVE_STEP_M)
    thickness = np.zeros((len(azimuth), len(elevation)))
    for i, angle in enumerate(azimuth):
        column, row = sight.frame.ground_positions(np.full(len(distance), angle), distance)
        inside = dem.contains(column, row)
        ground = np.full(len(distance), -np.inf)
        ground[inside] = heights[
            np.rint(row[inside]).astype(int), np.rint(column[inside]).astype(int)
        ]
        for j, rise in enumerate(np.radians(elevation)):
            ray = sight.detector_elevation_m + distance * np.tan(rise) + sight.frame.drop(distance)
            thickness[i, j] = np.count_nonzero(ray < ground) * _NAIVE_STEP_M / np.cos(rise)
    return thickness


def peer_grid(sight: Sight) -> object:
    """Return the DEM for mulder, with its values at the cell centres.

    Read from the file, mulder 0.3.7 stretches them to the raster's outer edges,
    which moves the terrain by up to half a cell.
    """
    import mulder

    dem = sight.frame.dem
    left, top = dem.crs_position(0, 0)
    right, bottom = dem.crs_position(dem.columns - 1, dem.rows - 1)
    return mulder.Grid(
        dem.read(0, 0, dem.columns, dem.rows)[::-1].copy(),
        xlim=(float(left), float(right)), ylim=(float(bottom), float(top)), crs=4326,
    )  # fmt: skip


def compare_thickness(pixels: int = 100) -> None:
    import mulder

    sight = sight_on_vesuvius()
    azimuth, elevation = Aperture(42, 22, pixels, pixels).directions(
        sight.boresight_azimuth_deg, sight.boresight_elevation_deg
    )
    rising = elevation[::-1]

    def ours() -> np.ndarray:
        return trace_terrain(sight.frame, sight.detector_elevation_m, azimuth, rising).thickness_m

    geometry = mulder.EarthGeometry(mulder.Layer(peer_grid(sight), material="Rock"))
    azimuths, elevations = (grid.ravel() for grid in np.meshgrid(azimuth, rising, indexing="ij"))

    def peer() -> np.ndarray:
        return geometry.scan(
            latitude=DETECTOR[1], longitude=DETECTOR[0],
            altitude=sight.detector_elevation_m + 0.01,
            azimuth=azimuths, elevation=elevations,
        )[:, 0]  # fmt: skip

    mine, theirs = ours(), peer().reshape(len(azimuth), -1)
    naive = naive_thickness(sight, azimuth[::10], rising)
    t_ours = seconds_of(ours, 7)
    t_peer = seconds_of(peer, 3)
    t_naive = 10 * seconds_of(lambda: naive_thickness(sight, azimuth[::10], rising), 1)
    rock = (mine > 50) & (theirs > 50)
    off = np.median(np.abs(mine - theirs)[rock] / theirs[rock])
    off_naive = np.median(np.abs(mine[::10] - naive)[rock[::10]] / mine[::10][rock[::10]])
    print_table(
        f"Thickness of {pixels} × {pixels} rays, geographic DEM of 612 × 504 cells",
        [
            Row("this library, exact", t_ours),
            Row("mulder scan", t_peer, f"{t_peer / t_ours:.0f} times slower; median "
                f"difference {100 * off:.2f} %"),
            Row(f"naive, {_NAIVE_STEP_M:g} m steps", t_naive, f"{t_naive / t_ours:.0f} times "
                f"slower; median difference {100 * off_naive:.2f} %"),
        ],
    )  # fmt: skip


def compare_flux(pixels: int = 100, peer_pixels: int = 10) -> None:
    import mulder

    sight = sight_on_vesuvius()
    azimuth, elevation = Aperture(42, 22, pixels, pixels).directions(
        sight.boresight_azimuth_deg, sight.boresight_elevation_deg
    )
    thickness = trace_terrain(
        sight.frame, sight.detector_elevation_m, azimuth, elevation[::-1]
    ).thickness_m.T[::-1]
    opacity = thickness * 265.0
    physics = Physics(flux_model="guan", straggling=False)
    t_ours = seconds_of(lambda: attenuate(opacity, elevation[:, None], physics, 604.0), 7)

    meter = mulder.Fluxmeter(mulder.Layer(peer_grid(sight), material="Rock"))
    energies = np.geomspace(1.0, 1e6, _ENERGIES)
    every = pixels // peer_pixels
    azimuths, elevations, energy = (
        grid.ravel()
        for grid in np.meshgrid(azimuth[::every], elevation[::every], energies, indexing="ij")
    )

    def peer() -> np.ndarray:
        return meter.flux(
            latitude=DETECTOR[1], longitude=DETECTOR[0],
            altitude=sight.detector_elevation_m + 0.01,
            azimuth=azimuths, elevation=elevations, energy=energy,
        )  # fmt: skip

    t_peer = seconds_of(peer, 1) * (pixels / peer_pixels) ** 2
    print_table(
        f"Flux integrated over energy behind {pixels} × {pixels} pixels",
        [
            Row("this library, from thickness", t_ours),
            Row(f"mulder, continuous, {_ENERGIES} energies", t_peer, f"{t_peer / t_ours:.0f} times "
                f"slower (measured on {peer_pixels}², scaled)"),
        ],
    )  # fmt: skip


def time_everything() -> None:
    rows = []
    for pixels, limit in ((100, "limit 0.15 s"), (1000, "limit 10 s and 1536 MiB")):
        words = in_fresh_process(
            "from radiography import *\n"
            "from measure import *\n"
            f"print(run_all({pixels}, {7 if pixels < 500 else 1}), peak_mib())"
        )
        rows.append(Row(f"all quantities, {pixels} × {pixels}", float(words[0]), limit,
                        float(words[1])))  # fmt: skip
    words = in_fresh_process(
        "import time; start = time.perf_counter()\n"
        "import numpy\nimported = time.perf_counter()\n"
        "from radiography import *\n"
        "begin = time.perf_counter(); run_all(100, 0); end = time.perf_counter()\n"
        "print(end - begin)"
    )
    rows.append(Row("all quantities, 100 × 100, first run of a process", float(words[0])))
    print_table("From DEM file to every quantity, in process", rows)


def run_all(pixels: int, repeats: int) -> float:
    """Return the time from opening the DEM to the last quantity."""

    def run() -> object:
        return simulate(
            sight_on_vesuvius(), Aperture(42, 22, pixels, pixels), Physics(), Telescope()
        )

    if not repeats:
        return run() is not None
    return seconds_of(run, repeats)


if __name__ == "__main__":
    print(f"Benchmarks of {ROOT.name}; medians, warm unless said otherwise")
    time_everything()
    compare_thickness()
    compare_flux()
