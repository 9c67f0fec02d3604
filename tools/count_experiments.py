"""Densities of Vesuvius from what telescopes of finite width count; ``-m tools.count_experiments``.

What is counted is drawn by `mountain_counts`, which shares neither rays nor quadrature with the
product. The chain of one ray a pixel is run on the same counts, then the fit of counts: a uniform
mountain, a body, factors of stations and flux, a terrain that is known to 5 m, and draws from the
prior. Takes about half an hour; ``--quick`` has fewer bars, sub-rays and draws.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.tomography.counting import CountFit, CountPriors, fit_counts
from muysc_qgis.workflows.count_lines import CountLines, lay_counts, with_counts
from muysc_qgis.workflows.volume_frame import utm_zone
from tools.count_world import (
    CONTRAST,
    DAYS,
    DEM,
    ROCK,
    SPHERE_RADIUS_M,
    SUMMIT,
    TERRAIN_LENGTH_M,
    TERRAIN_M,
    World,
    build,
    one_ray_a_pixel,
    poisson,
    sphere_middle,
    terrain_off,
)
from tools.experiments import Figure, show
from tools.mountain_counts import Drawn, Site, Terrain, counted, rock_pieces

#: One station that counts less than it should.
FACTOR = 0.95

#: What is run.
PARTS = ("old", "uniform", "sphere", "factors", "terrain", "prior")


class Fits:
    """Counts of one survey, fitted again and again."""

    def __init__(self, world: World, terrain_length_m: float | None = None) -> None:
        nothing = [np.where(np.isfinite(one.total), 1.0, np.nan) for one in world.drawn]
        shapes = [trajectories(site.geometry).acceptance_cm2_sr.shape for site in world.sites]
        counts = [one.reshape(shape) for one, shape in zip(nothing, shapes)]
        self.laid: CountLines = lay_counts(
            world.stations(counts), world.dem, world.plan, utm_zone(*SUMMIT),
            terrain_length_m=terrain_length_m,
        )  # fmt: skip
        model = self.laid.model
        line = model.at(np.full(model.lattice.count, ROCK), ROCK)
        self.seen = np.asarray(abs(line.voxels).sum(axis=0)).ravel() > 0
        self.centres = self.laid.lines.paths.grid.all_centres_m()[model.lattice.active.ravel()]

    def fit(
        self, counts: Sequence[np.ndarray], priors: CountPriors, errors: bool = False
    ) -> CountFit:
        """Return the fit of what all stations counted."""
        values = np.concatenate([one.ravel() for one in counts])[self.laid.pixel]
        return fit_counts(with_counts(self.laid, values).model, priors, errors=errors)

    def body(self, terrain: Terrain) -> tuple[np.ndarray, np.ndarray]:
        """Return how far voxels are from the middle of the sphere, and where that is."""
        x, y, z = sphere_middle(terrain)
        east, north = self.laid.lines.frame.local(np.array(x), np.array(y))
        middle = np.array([float(east), float(north), z])
        return np.linalg.norm(self.centres - middle, axis=1), middle


def uniform(world: World, fits: Fits, means: Sequence[np.ndarray], draws: int) -> int:
    """Fit a mountain without a body; what structure comes out is noise."""
    rows = []
    for seed in range(draws):
        found = fits.fit(poisson(means, seed), CountPriors(ROCK))
        values = found.densities[fits.seen]
        rows.append((values.mean() - ROCK, values.std(), found.chi_squared))
    bias, spread, chi = np.mean(rows, axis=0)
    print(f"\nUniform mountain, {len(world.sites)} stations, {draws} draws")
    return show([
        Figure("Standard deviation of the densities (g/cm³)", spread, 0.05),
        Figure("Mean of the errors (g/cm³)", bias, 0.01),
        Figure("χ² per datum, less 1", chi - 1, 0.04),
    ])  # fmt: skip


def sphere(
    world: World, fits: Fits, means: Sequence[np.ndarray], terrain: Terrain, draws: int
) -> int:
    """Fit a light sphere under the summit."""
    rows = []
    distance, middle = fits.body(terrain)
    inside, around = distance < SPHERE_RADIUS_M, fits.seen & (distance > 2 * SPHERE_RADIUS_M)
    near = fits.seen & (distance < 4 * SPHERE_RADIUS_M)
    balls = np.stack([
        fits.seen & (np.linalg.norm(fits.centres - one, axis=1) < SPHERE_RADIUS_M)
        for one in fits.centres[near]
    ]).astype(float)  # fmt: skip
    counts = balls.sum(axis=1)
    for seed in range(draws):
        found = fits.fit(poisson(means, seed), CountPriors(ROCK))
        off = found.densities - found.densities[around].mean()
        # The middle of the ball of its size that is lightest on the mean.
        means_of = np.where(counts > 0.5 * counts.max(), balls @ off / np.maximum(counts, 1), 0.0)
        place = fits.centres[near][int(np.argmin(means_of))]
        rows.append((off[inside].mean() / CONTRAST, np.linalg.norm(place - middle)))
    contrast, apart = np.mean(rows, axis=0)
    print(f"\nSphere of {SPHERE_RADIUS_M:g} m, {len(world.sites)} stations, {draws} draws")
    return show([
        Figure("Contrast found over the true one, less 1", contrast - 1, 0.65),
        Figure("Middle of the body off by (m)", apart, 60.0),
    ])  # fmt: skip


def factors(world: World, fits: Fits, means: Sequence[np.ndarray], draws: int) -> int:
    """Fit stations that count less, and a sky that is brighter or darker."""
    wrong = 0
    for name, own, flux in (
        ("one station 5 % low", FACTOR, 1.0), ("flux 0.9", 1.0, 0.9), ("flux 1.1", 1.0, 1.1),
    ):  # fmt: skip
        rows = []
        for seed in range(draws):
            true = [flux * one * (own if n == 1 else 1.0) for n, one in enumerate(means)]
            found = fits.fit(poisson(true, seed), CountPriors(ROCK))
            bands = {(band.name, band.station): band.after for band in found.bands}
            flux_found = bands.get(("flux", -1), 1.0)
            rows.append([
                found.densities[fits.seen].mean() - ROCK,
                *(bands["factor", n] * flux_found for n in range(len(means))),
            ])  # fmt: skip
        bias, *found_factors = np.mean(rows, axis=0)
        expected_factors = [flux * (own if n == 1 else 1.0) for n in range(len(means))]
        print(f"\nFactors, {name}: {np.round(found_factors, 4)}")
        worst = np.abs(np.array(found_factors) - expected_factors).max()
        wrong += show([
            Figure("Largest error of a station's factor", float(worst), 0.01),
            Figure("Mean of the errors (g/cm³)", bias, 0.01),
        ])  # fmt: skip
    return wrong


def rough(world: World, draws: int) -> int:
    """Fit counts behind a terrain that is off by 5 m, over 100 m alike."""
    terrain = Terrain(str(DEM))
    fits = Fits(world, TERRAIN_LENGTH_M)
    rows, told = [], []
    for seed in range(draws):
        off = terrain_off(world, terrain, seed)
        means = world.expected(Terrain(str(DEM), off))
        counts = poisson(means, seed)
        for priors in (
            CountPriors(ROCK),
            CountPriors(ROCK, terrain_m=TERRAIN_M, terrain_length_m=TERRAIN_LENGTH_M),
        ):
            found = fits.fit(counts, priors)
            rows.append((found.densities[fits.seen].std(), found.chi_squared))
        told.append(rows[-1])
    known, uncertain = np.mean(rows[::2], axis=0), np.mean(told, axis=0)
    print(
        f"\nTerrain off by {TERRAIN_M:g} m over {TERRAIN_LENGTH_M:g} m: standard deviation "
        f"{known[0]:.3f} g/cm³ and χ² {known[1]:.3g} where that is not told, with it:"
    )
    return show([
        Figure("Standard deviation of the densities (g/cm³)", uncertain[0], 0.10),
        Figure("χ² per datum, less 1", uncertain[1] - 1, 0.2),
    ])  # fmt: skip


def coverage(world: World, fits: Fits, draws: int) -> int:
    """Fit densities drawn from the prior; 68 % of the errors must be within the stated ones."""
    terrain, priors = Terrain(str(DEM)), CountPriors(ROCK, 0.1)
    matrices = [voxel_paths(world, fits, site, terrain, one)
                for site, one in zip(world.sites, world.drawn)]  # fmt: skip
    lattice = fits.laid.model.lattice
    covariance = lattice.covariance(priors.deviation, priors.length_m)
    off, chi = [], []
    for seed in range(draws):
        generator = np.random.default_rng(seed)
        mean = ROCK + priors.mean_deviation * generator.standard_normal()
        own = mean + covariance.root(generator.standard_normal(covariance.root_size))
        # Rock outside the volume comes last.
        whole = np.append(own, mean)
        factor = np.exp(priors.station * generator.standard_normal(len(world.sites)))
        means = [
            times * counted(site, drawn, 100.0 * (matrix @ whole), world.physics, DAYS)
            for times, site, drawn, matrix in zip(factor, world.sites, world.drawn, matrices)
        ]
        found = fits.fit(
            poisson(means, seed), replace(priors, azimuth_deg=0, elevation_deg=0), True
        )
        errors = np.asarray(found.deviation)
        off.append(((found.densities - own) / errors)[fits.seen])
        chi.append(found.chi_squared)
    within = float(np.mean(np.abs(np.concatenate(off)) < 1))
    print(f"\nDraws from the prior, {draws}: {100 * within:.1f} % within the stated errors")
    return show([
        Figure("Share within one error, less 0.68", within - 0.68, 0.03),
        Figure("χ² per datum, less 1", float(np.mean(chi)) - 1, 0.04),
    ])  # fmt: skip


def voxel_paths(world: World, fits: Fits, site: Site, terrain: Terrain, drawn: Drawn) -> Any:
    """Return lengths of marched sub-rays in voxels, the rock outside as the last column."""
    from pyproj import Transformer
    from scipy import sparse

    lines, lattice = fits.laid.lines, fits.laid.model.lattice
    grid = lines.grid
    to_map = Transformer.from_crs("EPSG:4326", lines.frame.crs, always_xy=True)
    number = np.full(lattice.active.shape, lattice.count)
    number[lattice.active] = np.arange(lattice.count)
    shape = (len(drawn.azimuth_deg), lattice.count + 1)
    parts = []
    for ray, middle, length in rock_pieces(site, terrain, drawn.azimuth_deg, drawn.elevation_deg):
        x, y = to_map.transform(middle[0], middle[1])
        east, north = lines.frame.local(x, y)
        up = middle[2] - lines.frame.drop(east, north)
        cell = [
            np.floor((place - low) / size).astype(int)
            for place, low, size in zip((x, y, up), grid.origin_m, grid.size_m)
        ]
        inside = np.all([(one >= 0) & (one < n) for one, n in zip(cell, grid.shape)], axis=0)
        column = np.full(len(ray), lattice.count)
        column[inside] = number[tuple(one[inside] for one in cell)]
        block = sparse.coo_matrix((length, (ray, column)), shape=shape)
        parts.append(block.tocsr())
    return sum(parts[1:], parts[0])


def old_chain(world: World, means: Sequence[np.ndarray]) -> None:
    """Show what one ray a pixel makes of the same counts."""
    for name, counts in (
        ("without noise", [np.round(one) for one in means]),
        ("with noise", poisson(means, 0)),
    ):
        values, errors = one_ray_a_pixel(world, counts)
        off = values - ROCK
        print(
            f"One ray a pixel, uniform mountain, {name}: {values.min():.2f} to "
            f"{values.max():.2f} g/cm³, standard deviation {values.std():.3f}, mean "
            f"{off.mean():+.3f}; {100 * np.mean(np.abs(off) < errors):.0f} % within the stated "
            "errors"
        )


def main() -> int:
    """Run all; return how many numbers are beyond their limits."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="fewer bars and draws")
    parser.add_argument("--only", choices=PARTS, nargs="*", help="some of the parts")
    asked = parser.parse_args()
    quick, parts = asked.quick, asked.only or PARTS
    start = time.perf_counter()
    geometry = TelescopeGeometry(10, 10, 8.0, 115.0) if quick else TelescopeGeometry(
        16, 16, 5.0, 115.0
    )  # fmt: skip
    draws = 3 if quick else 12
    world = build(geometry, 5, 8)
    terrain = Terrain(str(DEM))
    means = world.expected(terrain)
    print(f"{len(means)} telescopes counted by independent means, "
          f"{time.perf_counter() - start:.0f} s")  # fmt: skip
    wrong, fits = 0, Fits(world)
    if "old" in parts:
        old_chain(world, means)
    if "uniform" in parts:
        wrong += uniform(world, fits, means, draws)
    if "sphere" in parts:
        wrong += sphere(world, fits, world.expected(terrain, CONTRAST), terrain, draws)
    if "factors" in parts:
        wrong += factors(world, fits, means, 2 if quick else 6)
    if "terrain" in parts:
        wrong += rough(world, 1 if quick else 3)
    if "prior" in parts:
        wrong += coverage(world, fits, 3 if quick else 8)
    print(f"\n{wrong} numbers are beyond their limits, {time.perf_counter() - start:.0f} s.")
    return 0 if quick else wrong


if __name__ == "__main__":
    sys.exit(1 if main() else 0)
