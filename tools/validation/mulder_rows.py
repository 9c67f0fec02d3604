"""Rows against mulder, an independent code, where it is installed."""

from __future__ import annotations

from collections.abc import Iterator
from types import ModuleType

import numpy as np

from muysc_qgis.radiography.constants import SECONDS_PER_DAY
from muysc_qgis.radiography.energy_loss import csda_range, minimum_energy, stopping_power
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.spectra import differential_flux
from muysc_qgis.radiography.transmission import attenuate

from . import sky_rows
from .row import Row
from .terrain_rows import VESUVIUS, thickness_m

_ROCK = 265.0
_SECTION = "Against mulder"
_SOURCE = "mulder 0.3.7 (Niess 2022): "
#: Muons followed for each intensity; they give it to 1 %.
_MUONS = 30_000


def load() -> ModuleType | None:
    """Return mulder, None where it is not installed."""
    try:
        import mulder
    except ImportError:
        return None
    return mulder


def rows(monte_carlo: bool = True) -> Iterator[Row]:
    """Yield every row, or all but those that follow muons; none without mulder."""
    mulder = load()
    if mulder is None:
        return
    yield from _energy_loss(mulder)
    yield from _spectrum(mulder)
    yield from sky_rows.altitude_rows(mulder)
    if monte_carlo:
        yield from _intensity(mulder)
    yield from _thickness(mulder)


def _row(what: str, ours: float, unit: str, theirs: float, source: str, tolerance: float) -> Row:
    return Row(_SECTION, what, ours, unit, theirs, _SOURCE + source, tolerance, mulder=True)


def _energy_loss(mulder: ModuleType) -> Iterator[Row]:
    rock = mulder.Physics().compile("Rock")
    for energy in (1.0, 1e2, 1e4):
        at = np.array([energy])
        yield _row(
            f"Stopping power of standard rock, {energy:g} GeV",
            1e3 * float(stopping_power(at)[0]), "MeV cm²/g",
            1e3 * float(np.ravel(rock.stopping_power(at))[0]) / _ROCK, "tables", 1e-3,
        )  # fmt: skip
        yield _row(
            f"CSDA range in standard rock, {energy:g} GeV", float(csda_range(at)[0]), "g/cm²",
            float(np.ravel(rock.range(at))[0]) * _ROCK, "tables", 1e-3,
        )  # fmt: skip
    for length in (10.0, 300.0, 3000.0):
        yield _row(
            f"Minimum energy behind {length:g} m of standard rock",
            float(minimum_energy(np.array(_ROCK * length), Physics(flux_model="guan"))), "GeV",
            float(np.ravel(rock.inverse_range(np.array([length])))[0]), "tables", 5e-3,
        )  # fmt: skip


def _spectrum(mulder: ModuleType) -> Iterator[Row]:
    reference = mulder.Reference("GCCLY15")
    for energy, elevation in ((1.0, 90.0), (100.0, 15.0), (1e4, 2.0)):
        theirs = np.ravel(reference.flux(energy=np.array([energy]), elevation=elevation))[0]
        ours = differential_flux(energy, np.sin(np.radians(elevation)), "guan")
        yield _row(
            f"Guan et al., {energy:g} GeV, zenith {90 - elevation:g}°", float(ours),
            "cm⁻² s⁻¹ sr⁻¹ GeV⁻¹", float(theirs) * 1e-4, "its reference flux", 1e-3,
        )  # fmt: skip


def _intensity(mulder: ModuleType) -> Iterator[Row]:
    for depth, zenith in ((0.3, 0.0), (1.0, 60.0), (2.0, 75.5), (5.0, 84.3), (8.0, 0.0)):
        for mode, straggling, title, tolerance in (
            ("continuous", False, "mean losses", 4e-3),
            ("mixed", True, "all losses", 0.04),
        ):
            physics = Physics(flux_model="guan", straggling=straggling)
            ours = attenuate(depth * 1e5, 90.0 - zenith, physics).flux / SECONDS_PER_DAY
            yield _row(
                f"Intensity at {depth:g} km w.e., zenith {zenith:g}°, {title}", float(ours),
                "cm⁻² s⁻¹ sr⁻¹", intensity(mulder, mode, depth, zenith),
                "backward transport through a slab", tolerance,
            )  # fmt: skip


def intensity(mulder: ModuleType, mode: str, depth_km_we: float, zenith_deg: float) -> float:
    """Return the intensity under a slab of standard rock by mulder, cm⁻² s⁻¹ sr⁻¹."""
    length_m, zenith = depth_km_we * 1e5 / _ROCK, np.radians(zenith_deg)
    # The slab follows the Earth, so that a slanting path in it starts a little deeper.
    depth_m = length_m * np.cos(zenith) + (length_m * np.sin(zenith)) ** 2 / (2 * 6.371e6)
    meter = mulder.Fluxmeter(
        mulder.Layer(0.0, material="Rock"), mode=mode, reference=mulder.Reference("GCCLY15"),
        random=mulder.Random(11),
    )  # fmt: skip
    count = 4000 if mode == "continuous" else _MUONS
    edges = np.linspace(np.log(1e-3), np.log(3e5), count + 1)
    energy = np.exp(0.5 * (edges[1:] + edges[:-1]))
    events = {} if mode == "continuous" else {"events": 1}
    flux = meter.flux(energy=energy, altitude=-depth_m, elevation=90.0 - zenith_deg, **events)
    flux = np.asarray(flux).reshape(count, -1)[:, 0]
    return float(np.sum(flux * energy) * (edges[1] - edges[0])) * 1e-4  # m⁻² to cm⁻²


def _thickness(mulder: ModuleType) -> Iterator[Row]:
    sight = VESUVIUS.sight()
    dem = sight.frame.dem
    azimuth, zenith = np.arange(-20.0, 21.0, 1.0), np.arange(70.0, 87.0, 1.0)
    ours = thickness_m(VESUVIUS, azimuth, zenith)
    left, top = dem.crs_position(0, 0)
    right, bottom = dem.crs_position(dem.columns - 1, dem.rows - 1)
    grid = mulder.Grid(
        dem.read(0, 0, dem.columns, dem.rows)[::-1].copy(),
        xlim=(float(left), float(right)), ylim=(float(bottom), float(top)), crs=4326,
    )  # fmt: skip
    azimuths, elevations = np.meshgrid(
        sight.boresight_azimuth_deg + azimuth, 90.0 - zenith, indexing="ij"
    )
    theirs = mulder.EarthGeometry(mulder.Layer(grid, material="Rock")).scan(
        latitude=VESUVIUS.detector[1], longitude=VESUVIUS.detector[0],
        altitude=sight.detector_elevation_m + 0.01, azimuth=azimuths.ravel(),
        elevation=elevations.ravel(),
    )[:, 0].reshape(ours.shape)  # fmt: skip
    for angle in (72.0, 77.0, 84.0):
        at = int(np.flatnonzero(zenith == angle)[0])
        yield _row(
            f"Vesuvius, mean thickness over 40° of azimuth, zenith {angle:g}°",
            float(ours[:, at].mean()), "m", float(theirs[:, at].mean()), "its ray tracer", 3e-3,
        )  # fmt: skip
