"""Rows of the figures that the MUYSC paper states, each beside ours and none a target.

They were read in the text of Peña-Rodríguez et al., MUYSC: An end-to-end muography
simulation toolbox (arXiv:2303.02627); its maps are pictures without numbers. No row has a
tolerance: the paper's method has the errors that docs/physics.md lists.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from muysc_qgis.radiography.counting import exposure_days
from muysc_qgis.radiography.energy_loss import minimum_energy
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import Attenuation, attenuate
from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.presets import PRESETS

from .physics_rows import PAPER, ROCK
from .row import Row
from .terrain_rows import ACCEPTANCE, MUONS, P1, P4, VESUVIUS, Station, thickness_m

SECTION = "Figures that the MUYSC paper states"
SOURCE = "MUYSC paper (arXiv:2303.02627), text"
_ELSEWHERE = f"{SOURCE}; terrain not in the project"
_TELESCOPES = "Telescopes of the MUYSC paper"
_FLUX = "cm⁻² sr⁻¹ day⁻¹"
#: Zenith angles in degrees along which rims and thicknesses are looked for.
_ZENITH_DEG = np.arange(60.0, 90.1, 0.25)

#: Acceptance on the axis (cm² sr), half aperture (degrees), solid angle (sr) as stated.
STATED_TELESCOPES = {
    "gibert2010": (64.0, 57.0, None),
    "carbone2014": (5.54, None, None),
    "lopresti2020": (1.04, 45.0, 4.25e-4),
    "lesparre2012": (12.1, 34.0, 7.56e-3),
    "lesparre2010": (25.0, 45.0, 15.6e-3),
    "uchida2009": (34.57, 40.0, 19.6e-3),
    "mute": (3.6, None, 1.02e-3),
}


def rows() -> Iterator[Row]:
    """Yield every row."""
    yield from _minimum_energy()
    yield from _thicknesses()
    for title, physics in (("as the paper chooses", PAPER), ("defaults", Physics())):
        yield from _machin(title, physics)
        yield from _vesuvius(title, physics)
    yield from _elsewhere()
    yield from _telescopes()


def _stated(
    what: str,
    ours: float | None,
    unit: str,
    stated: float,
    stated_to: float | None = None,
    ours_to: float | None = None,
    source: str = SOURCE,
) -> Row:
    return Row(SECTION, what, ours, unit, stated, source, None, stated_to, ours_to)


def _minimum_energy() -> Iterator[Row]:
    recipe = Physics(
        material="standard_rock", density_g_cm3=2.65, flux_model="reyna-bugaev", energy_loss="paper"
    )
    yield _stated(
        "Minimum energy behind 100 m of standard rock (paper)",
        float(minimum_energy(np.array(ROCK * 100.0), recipe)), "GeV", 68.97, 68.98,
    )  # fmt: skip


def _thicknesses() -> Iterator[Row]:
    right = np.arange(16.0, 19.1, 0.25)
    yield _span(
        f"{P4.name}, zenith 84°, 16° to 19° right: thickness",
        thickness_m(P4, right, np.array([84.0]))[:, 0], "m", 1300.0,
    )  # fmt: skip
    view = thickness_m(P4, np.arange(-15.0, 15.25, 0.25), np.array([84.0]))
    yield _stated(
        f"{P4.name}, zenith 84°: largest thickness within 15° of the target", float(view.max()),
        "m", 1300.0,
    )  # fmt: skip
    base = np.arange(-3.0, 9.25, 0.25)
    for title, zenith in (
        ("zenith 90° as printed", 90.0),
        ("zenith 75.7°, the lowest of 22° in its frame", 75.7),
    ):
        yield _stated(
            f"{VESUVIUS.name}, {title}, 3° left to 9° right: largest thickness",
            float(thickness_m(VESUVIUS, base, np.array([zenith])).max()), "m", 1450.0,
        )  # fmt: skip


def _machin(title: str, physics: Physics) -> Iterator[Row]:
    yield _span(
        f"{P4.name}, open sky above the rim within 15° of the target: flux ({title})",
        _rim(P4, np.arange(-15.0, 15.5, 0.5), physics)[0].flux, _FLUX, 100.0,
    )  # fmt: skip
    # Where the target's dome is looked at, a ray of each length is found for each azimuth.
    for length, stated in ((10.0, 2.0), (1000.0, 1000.0)):
        zenith = _zenith_of(P1, np.arange(-10.0, 5.5, 0.5), length)
        muons = attenuate(
            np.full(zenith.shape, length * physics.density * 100.0), 90.0 - zenith, physics,
            P1.sight().detector_elevation_m,
        )  # fmt: skip
        yield _span(
            f"{P1.name}, {length:g} m of rock: exposure for {MUONS:g} muons, {ACCEPTANCE:g} cm² sr "
            f"({title})",
            exposure_days(muons.flux, ACCEPTANCE, MUONS), "days", stated,
        )  # fmt: skip


def _vesuvius(title: str, physics: Physics) -> Iterator[Row]:
    sky, rim = _rim(VESUVIUS, np.arange(-10.0, 20.5, 0.5), physics)
    name = VESUVIUS.name
    yield _span(f"{name}, open sky above the rim: flux ({title})", sky.flux, _FLUX, 10.0, 20.0)
    yield _span(
        f"{name}, first quarter of a degree of rock: flux ({title})", rim.flux, _FLUX, 10.0, 20.0
    )
    yield _span(
        f"{name}, first quarter of a degree of rock: transmission ({title})", rim.transmission,
        "1", 5e-2,
    )  # fmt: skip
    behind = attenuate(
        1450.0 * physics.density * 100.0, 14.0, physics, VESUVIUS.sight().detector_elevation_m
    )
    yield _stated(
        f"{name}, 1450 m of rock, zenith 76°: transmission ({title})", float(behind.transmission),
        "1", 1e-3,
    )  # fmt: skip


def _rim(
    station: Station, azimuth_deg: np.ndarray, physics: Physics
) -> tuple[Attenuation, Attenuation]:
    """Return the lowest open sky and the highest rock of each azimuth."""
    thickness = thickness_m(station, azimuth_deg, _ZENITH_DEG)
    first = np.argmax(thickness > 0, axis=1)
    opacity = thickness[np.arange(azimuth_deg.size), first] * physics.density * 100.0
    altitude = station.sight().detector_elevation_m
    sky = attenuate(np.zeros(first.size), 90.0 - _ZENITH_DEG[first - 1], physics, altitude)
    return sky, attenuate(opacity, 90.0 - _ZENITH_DEG[first], physics, altitude)


def _zenith_of(station: Station, azimuth_deg: np.ndarray, length_m: float) -> np.ndarray:
    """Return, for each azimuth that has one, the zenith angle where rock is first so thick."""
    thickness = thickness_m(station, azimuth_deg, _ZENITH_DEG)
    found = []
    for lengths in thickness:
        after = int(np.argmax(lengths >= length_m))
        if after:
            ends = [after - 1, after]
            found.append(np.interp(length_m, lengths[ends], _ZENITH_DEG[ends]))
    return np.array(found)


def _span(
    what: str, values: np.ndarray, unit: str, stated: float, stated_to: float | None = None
) -> Row:
    return _stated(
        what, float(values.min()), unit, stated, stated_to, float(values.max()), source=SOURCE
    )


def _elsewhere() -> Iterator[Row]:
    for what, unit, stated, stated_to in (
        ("Mount Etna, zenith 82°, 25° left: largest thickness", "m", 1700.0, None),
        ("Mount Etna, “in the mountain borderland”: flux", _FLUX, 20.0, 30.0),
        ("Puy de Dôme, Col de Ceyssat, zenith 89°, 3° right: largest thickness", "m", 1200.0, None),
        ("Puy de Dôme, Col de Ceyssat, at the top: flux", _FLUX, 20.0, 30.0),
    ):
        yield _stated(what, None, unit, stated, stated_to, source=_ELSEWHERE)


def _telescopes() -> Iterator[Row]:
    for name, (acceptance, aperture, solid_angle) in STATED_TELESCOPES.items():
        preset = PRESETS[name]
        geometry = preset.geometry
        axis = geometry.bars_y - 1, geometry.bars_x - 1
        for title, formula in (("its formula", "paper"), ("exact", "exact")):
            found = trajectories(geometry, formula)
            for what, value, unit, stated in (
                ("acceptance on the axis", found.acceptance_cm2_sr, "cm² sr", acceptance),
                ("solid angle on the axis", found.solid_angle_sr, "sr", solid_angle),
            ):
                if stated is not None:
                    yield Row(
                        _TELESCOPES, f"{preset.title}: {what} ({title})", float(value[axis]), unit,
                        stated, SOURCE, None,
                    )  # fmt: skip
        if aperture is not None:
            yield Row(
                _TELESCOPES, f"{preset.title}: half aperture", geometry.half_aperture_deg[0], "°",
                aperture, SOURCE, None,
            )  # fmt: skip
