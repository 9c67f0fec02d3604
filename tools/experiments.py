"""Two reconstructions of known mountains; run from the root as ``-m tools.experiments``.

(a) The shape of Cerro Machín without knowing its terrain, as in the paper. (b) A conduit in
Vesuvius, and no conduit, with the noise of 100 days. Numbers are printed beside the targets, and
pictures go into build/experiments, that of the conduit into docs too. Takes about half an hour;
``--quick`` does less of all.
"""

from __future__ import annotations

import argparse
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from muysc_qgis.plots.style import png_bytes
from muysc_qgis.plots.tomography.known_model_panel import known_model_panel
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.survey.ring import Ring, ring_places
from muysc_qgis.tomography.solvers import Options
from muysc_qgis.tomography.voxels import VoxelGrid
from muysc_qgis.topography.dem import Dem, open_dem
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.workflows.known_model import KnownModel
from muysc_qgis.workflows.reconstruction_test import KnownModelResult, find_known_model
from muysc_qgis.workflows.sightlines import lay_sightlines
from muysc_qgis.workflows.simulated_counts import Campaign, station_data
from muysc_qgis.workflows.simulation import Telescope
from muysc_qgis.workflows.sites import Site, Station, stations_of
from muysc_qgis.workflows.station_data import rock_of_all
from muysc_qgis.workflows.tomography import TomographyChoices
from muysc_qgis.workflows.view_errors import paper_errors
from muysc_qgis.workflows.volume_frame import VolumeFrame, utm_zone

ROOT = Path(__file__).resolve().parents[1]
DATA = ROOT / "tests" / "data"
OUTPUT = ROOT / "build" / "experiments"
IMAGES = ROOT / "docs" / "images"

#: Resolution of the picture in docs, dots per inch.
_DOCUMENT_DPI = 80

#: Rock of both mountains, g/cm³.
ROCK = 2.65
STATIONS, PIXELS, VOXELS = 42, 100, 100
AZIMUTH_DEG, ZENITH_DEG = 100.0, 28.0

#: Cerro Machín: middle of the stations, their distances, and the box of the dome: inside the
#: ring, from the valley floor to above the highest ground.
MACHIN = (-75.388788, 4.486667)
MACHIN_RADIUS_M, MACHIN_TOLERANCE_M = 1059.0, 40.0
MACHIN_HALF_M, MACHIN_BASE_M, MACHIN_TOP_M = 750.0, 2400.0, 2760.0
#: North-north-east over east to south-south-east: 150°.
MACHIN_ARC = (22.5, 172.5)

#: Vesuvius: the highest cell of the elevation model, a ring at the foot of the cone, and the box
#: of the cone.
VESUVIUS = (14.429444, 40.822222)
VESUVIUS_RADIUS_M, VESUVIUS_TOLERANCE_M = 800.0, 50.0
VESUVIUS_HALF_M, VESUVIUS_BASE_M, VESUVIUS_TOP_M = 500.0, 900.0, 1270.0
CONDUIT_RADIUS_M, CONTRAST = 100.0, -0.5
DAYS, ACCEPTANCE_CM2_SR = 100.0, 10.0


@dataclass(frozen=True)
class Figure:
    """A number, what it should not exceed, and what the paper has."""

    what: str
    value: float
    limit: float
    paper: float | None = None

    @property
    def holds(self) -> bool:
        """Whether the number is within its limit."""
        return abs(self.value) <= self.limit


@dataclass(frozen=True)
class Setup:
    """A mountain and the stations around it."""

    dem: Dem
    stations: list[Station]
    aperture: Aperture
    frame: VolumeFrame
    grid: VoxelGrid


def setup(
    name: str,
    target: tuple[float, float],
    ring: Ring,
    half_m: float,
    base_m: float,
    top_m: float,
    pixels: int,
    shape: tuple[int, int, int],
) -> Setup:
    """Return the stations of a ring and a box of voxels around its middle."""
    dem = open_dem(DATA / name)
    place = from_wgs84(dem.crs, *target)
    places = ring_places(dem, place, ring)
    sites = [
        Site(f"site_{number + 1:02d}", (float(x), float(y)), 0.0, f"site_{number + 1:02d}")
        for number, x, y in zip(places.number, places.x, places.y)
    ]
    aperture = Aperture(AZIMUTH_DEG, ZENITH_DEG, pixels, pixels)
    stations, _ = stations_of(dem, sites, place, 0.0, aperture)
    crs = utm_zone(*target)
    x, y = from_wgs84(crs, *target)
    size = (2 * half_m / shape[0], 2 * half_m / shape[1], (top_m - base_m) / shape[2])
    grid = VoxelGrid((x - half_m, y - half_m, base_m), size, shape)
    return Setup(dem, stations, aperture, VolumeFrame.around(crs, (x, y)), grid)


def run(
    what: str, scene: Setup, model: KnownModel, campaign: Campaign, choices: TomographyChoices
) -> KnownModelResult:
    """Return what is found, and say how."""
    start = time.perf_counter()
    data = [station_data(station, scene.aperture) for station in scene.stations]
    rock = rock_of_all(data, scene.dem)
    lines = lay_sightlines(data, rock, scene.grid, scene.frame, scene.dem, choices.mask)
    found = find_known_model(
        lines, scene.stations, scene.aperture, scene.dem, model, Physics(density_g_cm3=ROCK),
        campaign, choices,
    )  # fmt: skip
    seconds = time.perf_counter() - start
    result = found.tomography
    print(
        f"\n{what}: {len(scene.stations)} stations, {result.rays} rays, "
        f"{' × '.join(map(str, scene.grid.shape))} voxels, {choices.method}, "
        f"{result.reconstruction.iterations_done} iterations, {seconds:.0f} s; "
        f"{result.unseen_voxels} of {result.rock_voxels} voxels are passed by no ray"
    )
    return found


def show(figures: list[Figure]) -> int:
    """Print numbers beside their limits; return how many do not hold."""
    for one in figures:
        paper = "" if one.paper is None else f"  (paper {one.paper:g})"
        verdict = "" if one.holds else "  NOT REACHED"
        print(f"  {one.what:<44} {one.value:8.4f}  limit {one.limit:g}{paper}{verdict}")
    return sum(not one.holds for one in figures)


def machin(pixels: int, voxels: int, iterations: int) -> int:
    """Reconstruct the shape of the dome from an arc and from a ring; all voxels are unknown."""
    wrong = 0
    choices = TomographyChoices(
        # No voxel is denser than the rock, which is all that is known of the mountain.
        "sirt", Options(iterations=iterations, highest=ROCK), ROCK, mask=False,
    )  # fmt: skip
    for name, ends in (("arc", MACHIN_ARC), ("ring", (0.0, 360.0))):
        ring = Ring(
            MACHIN_RADIUS_M, STATIONS, *ends, tolerance_m=MACHIN_TOLERANCE_M, sees_target=False
        )
        scene = setup(
            "machin_digitised.tif", MACHIN, ring, MACHIN_HALF_M, MACHIN_BASE_M, MACHIN_TOP_M,
            pixels, (voxels, voxels, voxels),
        )  # fmt: skip
        found = run(
            f"Cerro Machín from {name} of stations", scene, KnownModel("uniform", ROCK),
            Campaign(noise=False), choices,
        )  # fmt: skip
        errors = paper_errors(found.tomography, found.truth)
        wrong += show([
            Figure("Top view, normalised: mean |ε|", errors["top"].mean, 0.06, 0.105),
            Figure("Top view, normalised: σ of |ε|", errors["top"].deviation, 0.06, 0.099),
            Figure("Front view: mean |ε| (km)", errors["front"].mean, 0.08, 0.158),
        ])  # fmt: skip
        print(
            f"  {'Front view: σ of |ε| (km)':<44} {errors['front'].deviation:8.4f}  (paper 0.077)"
        )
        save(found, f"machin_{name}.png")
    return wrong


def vesuvius(pixels: int, voxels: int) -> int:
    """Reconstruct a conduit, and a mountain without one, with the default prior."""
    wrong = 0
    ring = Ring(VESUVIUS_RADIUS_M, STATIONS, tolerance_m=VESUVIUS_TOLERANCE_M, sees_target=False)
    scene = setup(
        "vesuvius_srtmgl1.tif", VESUVIUS, ring, VESUVIUS_HALF_M, VESUVIUS_BASE_M,
        VESUVIUS_TOP_M, pixels, (voxels, voxels, voxels),
    )  # fmt: skip
    choices = TomographyChoices(
        "bayes", Options(prior_deviation=0.2, correlation_length_m=200.0), ROCK, length_error_m=2.0
    )
    campaign = Campaign(DAYS, Telescope(ACCEPTANCE_CM2_SR))
    for kind in ("conduit", "uniform"):
        model = KnownModel(
            kind,
            ROCK,
            ROCK + CONTRAST,
            CONDUIT_RADIUS_M,
            centre=from_wgs84(scene.frame.crs, *VESUVIUS),
        )
        found = run(f"Vesuvius, {kind}", scene, model, campaign, choices)
        if kind == "conduit":
            wrong += show(
                [Figure("Contrast found over the true one, less 1", found.contrast - 1, 0.2)]
            )
        else:
            wrong += show(
                [Figure("Standard deviation of the densities (g/cm³)", found.spread, 0.05)]
            )
        print(f"  {'Mean of the errors (g/cm³)':<44} {found.bias:8.4f}")
        save(found, f"vesuvius_{kind}.png")
        if kind == "conduit" and voxels == VOXELS:
            picture = png_bytes(known_model_panel(found.tomography, found.truth), _DOCUMENT_DPI)
            (IMAGES / "known_conduit.png").write_bytes(picture)
    return wrong


def save(found: KnownModelResult, name: str) -> None:
    """Draw original, reconstruction and error."""
    OUTPUT.mkdir(parents=True, exist_ok=True)
    picture = png_bytes(known_model_panel(found.tomography, found.truth))
    (OUTPUT / name).write_bytes(picture)


def main() -> int:
    """Run both; return how many numbers are beyond their limits."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="a sixth of the rays, fewer voxels")
    quick = parser.parse_args().quick
    pixels, voxels, iterations = (40, 40, 150) if quick else (PIXELS, VOXELS, 300)
    wrong = machin(pixels, voxels, iterations) + vesuvius(pixels, voxels)
    print(f"\nPictures are in {OUTPUT.relative_to(ROOT)}; {wrong} numbers are beyond their limits.")
    if quick:
        print("The limits are for the full size; a sixth of the muons need not reach them.")
        return 0
    return wrong


if __name__ == "__main__":
    sys.exit(1 if main() else 0)
