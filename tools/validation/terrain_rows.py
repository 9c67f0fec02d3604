"""Rows on real terrain: geometry, and the cases of the MUYSC paper."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from muysc_qgis.radiography.counting import exposure_days
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.sight import Sight, take_sight
from muysc_qgis.topography.tracing import trace_terrain

from . import first_muysc
from .physics_rows import PAPER
from .row import Row

DATA = Path(__file__).resolve().parents[2] / "tests" / "data"
_CASES = "Cases of the MUYSC paper"
_PAPER = "MUYSC paper (arXiv:2303.02627), text; for its 90°"
#: Acceptance (cm² sr) and muons of the exposures.
ACCEPTANCE, MUONS = 6.0, 10.0


@dataclass(frozen=True)
class Station:
    """A view of the paper on terrain that is public; points are (longitude, latitude)."""

    name: str
    dem: str
    detector: tuple[float, float]
    target: tuple[float, float]

    def sight(self) -> Sight:
        """Return detector and target on the terrain."""
        return take_sight(open_dem(DATA / self.dem), self.detector, self.target)


_MACHIN_TARGET = (-75.387880, 4.487717)
P1 = Station("Cerro Machín P1", "machin_digitised.tif", (-75.381092, 4.492298), _MACHIN_TARGET)
P4 = Station("Cerro Machín P4", "machin_digitised.tif", (-75.388110, 4.494946), _MACHIN_TARGET)
VESUVIUS = Station(
    "Vesuvius, Casina Amelia", "vesuvius_srtmgl1.tif", (14.410686, 40.810561),
    (14.424745, 40.823729),
)  # fmt: skip


def rows() -> Iterator[Row]:
    """Yield every row."""
    yield from _geometry()
    yield from _stations()


def _geometry() -> Iterator[Row]:
    section = "Geometry"
    sight = VESUVIUS.sight()
    yield Row(
        section, "Vesuvius, distance of detector and target", sight.target_distance_m, "m", 1883.0,
        "geodesic on the WGS 84 ellipsoid", 5e-4,
    )  # fmt: skip
    for distance, expected in ((5000.0, 1.96), (10000.0, 7.85)):
        yield Row(
            section, f"Drop of the level surface at {distance / 1000:g} km",
            float(sight.frame.drop(distance)), "m", expected, "d²/2R with R = 6371 km", 5e-3,
        )  # fmt: skip
    thickness = 1e-3 * thickness_m(P1, np.arange(-15.0, -9.5, 0.5), np.array([84.0]))
    yield Row(
        section, "Cerro Machín P1, zenith 84°, 10° to 15° left of the dome",
        float(thickness.min()), "km", 1.29, "a dense sampler on the same terrain",
        0.01, reference_to=1.32, ours_to=float(thickness.max()),
    )  # fmt: skip


def _stations() -> Iterator[Row]:
    """Yield thickness, flux, transmission and exposure at the paper's stations."""
    yield _stored_muogram()
    # The paper shows P1 as a picture; the figures it states for P4 are in `paper_rows`.
    yield from _station(P1, 84.0, (84.0,), None)
    yield from _station(P4, 84.0, (84.0,), None)
    # The paper's zenith angle of 90° is none from the vertical; see `paper_rows`.
    yield from _station(VESUVIUS, 77.0, (76.0, 78.0), 1450.0)


def _stored_muogram() -> Row:
    """Return the row on the one muogram that the authors of the paper have published.

    It holds horizontal lengths. Its rays end four times as far as the target, at
    z (1 + sin j) with z the height there of the line to the target: the row j = −0.14248
    rises by 6.0°.
    """
    left_rad = 0.1788072 + 0.01139807 * np.arange(8)
    stored_m = (1239.09, 1253.71, 1268.33, 1268.38, 1264.77, 1264.82, 1261.22, 1272.20)
    ours_m = thickness_m(P1, -np.degrees(left_rad)[::-1], np.array([84.0])) * np.cos(
        np.radians(6.0)
    )
    return Row(
        _CASES, "Cerro Machín P1, zenith 84°, 10.2° to 14.8° left: mean horizontal length",
        float(ours_m.mean()), "m", float(np.mean(stored_m)),
        "muogram of the first MUYSC (Jhosgun/PruebaMuysc, Prueba4.dat, commit 71bfdc3)", 0.06,
    )  # fmt: skip


def _station(
    station: Station, zenith_deg: float, looked_at: tuple[float, ...], reference_m: float | None
) -> Iterator[Row]:
    section = _CASES
    azimuth = np.arange(-20.0, 20.25, 0.25)
    largest = thickness_m(station, azimuth, np.array(looked_at)).max(axis=0)
    angles = " to ".join(f"{angle:g}°" for angle in looked_at)
    yield Row(
        section, f"{station.name}, zenith {angles}: largest thickness within 20° of the target",
        float(largest[0]), "m", reference_m,
        _PAPER if reference_m else "the paper shows a picture", None,
        ours_to=float(largest[-1]) if len(looked_at) > 1 else None,
    )  # fmt: skip
    thickness = thickness_m(station, azimuth, np.array([zenith_deg]))[:, 0]
    longest = int(np.argmax(thickness))
    side = "left" if azimuth[longest] < 0 else "right"
    where = f"{station.name}, zenith {zenith_deg:g}°, {abs(azimuth[longest]):g}° {side}"
    where += f", {thickness[longest]:.0f} m"
    altitude = station.sight().detector_elevation_m
    first = first_muysc.first_muons(float(thickness[longest]), zenith_deg)
    for title, physics in (
        ("as the paper chooses", PAPER),
        ("defaults", Physics()),
    ):
        muons = attenuate(
            thickness[longest : longest + 1] * physics.density * 100.0, 90.0 - zenith_deg, physics,
            altitude,
        )  # fmt: skip
        for what, value, unit, reference in (
            ("minimum energy", muons.minimum_energy_gev, "GeV", first.minimum_energy_gev),
            ("flux", muons.flux, "cm⁻² sr⁻¹ day⁻¹", first.flux),
            ("transmission", muons.transmission, "1", first.transmission),
            (
                f"exposure for {MUONS:g} muons, {ACCEPTANCE:g} cm² sr",
                exposure_days(muons.flux, ACCEPTANCE, MUONS),
                "days",
                MUONS / (ACCEPTANCE * first.flux),
            ),
        ):
            if what == "minimum energy" and title == "defaults":
                continue
            yield Row(
                section, f"{where}: {what} ({title})", float(value[0]), unit, reference,
                first_muysc.SOURCE, None,
            )  # fmt: skip


def thickness_m(station: Station, azimuth_deg: np.ndarray, zenith_deg: np.ndarray) -> np.ndarray:
    """Return (azimuth, zenith) rock thickness in m at azimuths from the target, zenith rising."""
    sight = station.sight()
    elevation = 90.0 - zenith_deg
    order = np.argsort(elevation)
    rock = trace_terrain(
        sight.frame,
        sight.detector_elevation_m,
        sight.boresight_azimuth_deg + azimuth_deg,
        elevation[order],
    )
    found = np.empty_like(rock.thickness_m)
    found[:, order] = rock.thickness_m
    return found
