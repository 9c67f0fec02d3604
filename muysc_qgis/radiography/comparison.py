"""Muon spectra, energy losses and what they leave behind rock, side by side.

The curves of the figures that compare models, and of the tables that go with them. Every
value is what `differential_flux`, `stopping_power`, `minimum_energy` and `attenuate` give.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..errors import MuyscError
from .altitude import altitude_factor
from .constants import G_CM2_PER_M_WATER_EQUIVALENT
from .energy_loss import ENERGY_LOSSES, csda_range, minimum_energy, stopping_power
from .envelope import model_holds
from .muon_sky import muon_sky
from .settings import Physics, check_altitude
from .spectra import MODELS, differential_flux, momentum_from_kinetic
from .transmission import attenuate
from .validity import OPEN_SKY_SLACK

#: Points per decade of every curve.
POINTS_PER_DECADE = 20

#: log10 of the kinetic energies in GeV of the spectra, and of the opacities in g/cm²; the
#: upper ends move up to hold whatever thickness is asked for.
_ENERGY_DECADES = (0, 5)
_OPACITY_DECADES = (2, 6)
#: log10 of the kinetic energies in GeV of the energy losses.
_LOSS_DECADES = (-1, 5)

#: Largest thickness accepted, m; more rock stops every muon of the tables.
MAXIMUM_THICKNESS_M = 20_000.0

#: More zenith angles than this make no readable figure.
MAXIMUM_ANGLES = 12


@dataclass(frozen=True)
class SpectrumCurve:
    """The differential spectrum of one model at one zenith angle."""

    model: str
    zenith_deg: float
    #: (n,) kinetic energy, GeV.
    kinetic_energy_gev: np.ndarray
    #: (n,) cm⁻² s⁻¹ sr⁻¹ GeV⁻¹ at the altitude of the detector.
    flux: np.ndarray
    #: (n,) whether the model was made for this energy and angle.
    holds: np.ndarray
    #: (n,) its relative standard error, NaN for a formula, which has none.
    error: np.ndarray


@dataclass(frozen=True)
class AttenuationCurve:
    """The flux that rock leaves of one model at one zenith angle."""

    model: str
    zenith_deg: float
    #: (n,) opacity, g/cm².
    opacity_g_cm2: np.ndarray
    #: (n,) kinetic energy that muons need, GeV; NaN where the energy loss has no answer.
    minimum_energy_gev: np.ndarray
    #: (n,) cm⁻² sr⁻¹ day⁻¹, behind the rock and without it.
    flux: np.ndarray
    open_sky: np.ndarray
    #: (n,) flux over open sky.
    transmission: np.ndarray
    #: (n,) whether the model was made for the energies that count behind the rock …
    holds: np.ndarray
    #: … and for the open sky, on which the transmission depends too.
    sky_holds: bool


@dataclass(frozen=True)
class LossCurve:
    """The energy loss in one material beside the polynomial for standard rock."""

    material: str
    #: (n,) kinetic energy, GeV.
    kinetic_energy_gev: np.ndarray
    #: (n,) stopping power of the material's table and of the polynomial, MeV cm²/g.
    stopping_power: np.ndarray
    polynomial: np.ndarray
    #: (n,) range in the continuous-slowing-down approximation, g/cm².
    csda_range: np.ndarray


@dataclass(frozen=True)
class MinimumEnergyCurve:
    """The energy that rock demands by one range law."""

    energy_loss: str
    #: (n,) thickness, m, and opacity, g/cm².
    thickness_m: np.ndarray
    opacity_g_cm2: np.ndarray
    #: (n,) kinetic energy, GeV; NaN where the law has no answer.
    minimum_energy_gev: np.ndarray


@dataclass(frozen=True)
class Comparison:
    """Everything that a comparison of spectra draws and tabulates."""

    physics: Physics
    altitude_m: float
    #: Thickness asked for, m.
    thickness_m: float
    #: Kinetic energy it demands, GeV; NaN where the energy loss has no answer.
    minimum_energy_gev: float
    models: tuple[str, ...]
    zenith_deg: tuple[float, ...]
    spectra: tuple[SpectrumCurve, ...]
    attenuations: tuple[AttenuationCurve, ...]
    #: The same at the thickness asked for alone, n = 1.
    behind: tuple[AttenuationCurve, ...]
    losses: tuple[LossCurve, ...]
    minimum_energies: tuple[MinimumEnergyCurve, ...]
    #: One sentence each.
    warnings: tuple[str, ...]

    @property
    def opacity_g_cm2(self) -> float:
        """Opacity of the thickness asked for, g/cm²."""
        return self.thickness_m * self.physics.density * G_CM2_PER_M_WATER_EQUIVALENT

    @property
    def largest_ratio(self) -> float:
        """Largest over smallest flux behind the rock among models that hold, at any one angle.

        NaN where fewer than two models hold at every angle.
        """
        ratios = []
        for angle in self.zenith_deg:
            fluxes = [
                float(one.flux[0])
                for one in self.behind
                if one.zenith_deg == angle and one.holds[0] and one.flux[0] > 0
            ]
            if len(fluxes) > 1:
                ratios.append(max(fluxes) / min(fluxes))
        return max(ratios, default=float("nan"))


def zenith_angles(text: str) -> tuple[float, ...]:
    """Return the zenith angles in degrees that a text lists, in its order, each once.

    Parameters
    ----------
    text
        Numbers separated by commas, semicolons or blanks.

    Raises
    ------
    MuyscError
        If there is no number, too many, one that cannot be read, or one outside 0° to
        below 90°.
    """
    words = text.replace(",", " ").replace(";", " ").replace("°", " ").split()
    angles: list[float] = []
    for word in words:
        try:
            angle = float(word)
        except ValueError:
            angle = math.nan
        if not math.isfinite(angle):
            raise MuyscError(
                f"The zenith angle “{word}” is no number; list degrees from 0 to below 90, such "
                "as “0, 30, 60”."
            )
        if angle not in angles:
            angles.append(angle)
    check_zenith_angles(angles)
    return tuple(angles)


def check_zenith_angles(angles: Sequence[float]) -> None:
    """Refuse zenith angles that no spectrum has an answer for, and lists that are too long.

    Raises
    ------
    MuyscError
        With the reason.
    """
    if not angles:
        raise MuyscError(
            "The list of zenith angles is empty; give at least one from 0° to below 90°, such as "
            "“0, 30, 60”."
        )
    if len(angles) > MAXIMUM_ANGLES:
        raise MuyscError(
            f"{len(angles)} zenith angles are more than a figure shows; give at most "
            f"{MAXIMUM_ANGLES}."
        )
    for angle in angles:
        if not 0 <= angle < 90:
            raise MuyscError(
                f"A zenith angle of {angle:g}° is not above the horizon; give angles from 0° "
                "(overhead) to below 90°."
            )


def check_thickness(thickness_m: float) -> None:
    """Refuse a thickness that no figure can mark.

    Raises
    ------
    MuyscError
        If it is not above 0 and up to `MAXIMUM_THICKNESS_M`.
    """
    if not 0 < thickness_m <= MAXIMUM_THICKNESS_M:
        raise MuyscError(
            f"A thickness of {thickness_m:g} m cannot be compared; give one above 0 and up to "
            f"{MAXIMUM_THICKNESS_M:g} m."
        )


def compare(
    models: Sequence[str],
    zenith_deg: Sequence[float],
    thickness_m: float,
    physics: Physics,
    altitude_m: float = 0.0,
    materials: Sequence[str] = (),
) -> Comparison:
    """Compute every curve of a comparison.

    Parameters
    ----------
    models
        Keys of `MODELS`.
    zenith_deg
        Zenith angles in degrees, from 0 to below 90.
    thickness_m
        Thickness of rock in m that the minimum energies are marked for.
    physics
        Material, density, energy loss and corrections; its flux model is not used.
    altitude_m
        Height of the detector above sea level, m.
    materials
        Keys of `MATERIALS` whose energy losses are compared; that of `physics` comes
        first in any case.

    Raises
    ------
    MuyscError
        If a name is unknown, a list is empty or a number is out of range.
    """
    if not models:
        raise MuyscError("No flux model is chosen; choose at least one.")
    every = [replace(physics, flux_model=model) for model in dict.fromkeys(models)]
    # One cut for all, where one of them has one behind rock.
    cut = max(one.threshold_gev for one in every)
    every = [replace(one, detection_threshold_gev=cut) for one in every]
    physics = every[0]
    check_zenith_angles(zenith_deg)
    check_altitude(altitude_m)
    check_thickness(thickness_m)
    opacity = thickness_m * physics.density * G_CM2_PER_M_WATER_EQUIVALENT
    needed = float(minimum_energy(np.array(opacity), physics))
    energy = grid(*_ENERGY_DECADES, at_least=3.0 * np.nan_to_num(needed))
    opacities = grid(*_OPACITY_DECADES, at_least=opacity)
    return Comparison(
        physics,
        altitude_m,
        thickness_m,
        needed,
        tuple(one.flux_model for one in every),
        tuple(zenith_deg),
        tuple(spectrum_curve(energy, a, one, altitude_m) for a in zenith_deg for one in every),
        tuple(
            attenuation_curve(opacities, a, one, altitude_m) for a in zenith_deg for one in every
        ),
        tuple(
            attenuation_curve(np.array([opacity]), a, one, altitude_m)
            for a in zenith_deg
            for one in every
        ),
        tuple(loss_curve(name) for name in dict.fromkeys((physics.material, *materials))),
        tuple(minimum_energy_curve(opacities, name, physics) for name in ENERGY_LOSSES),
        tuple(text for one in every for text in _warnings(opacity, zenith_deg, one, altitude_m)),
    )


def grid(first: int, last: int, at_least: float = 0.0) -> np.ndarray:
    """Return evenly spaced points on whole decades, `POINTS_PER_DECADE` in each.

    Parameters
    ----------
    first, last
        log10 of the first and the last point.
    at_least
        Value that the grid must reach; decades are added until it does.
    """
    if at_least > 10.0**last:
        last = math.ceil(math.log10(at_least))
    return np.logspace(first, last, (last - first) * POINTS_PER_DECADE + 1)


def spectrum_curve(
    kinetic_energy_gev: np.ndarray, zenith_deg: float, physics: Physics, altitude_m: float = 0.0
) -> SpectrumCurve:
    """Return the spectrum of the flux model of `physics`, altitude correction included."""
    cosine = np.array(math.cos(math.radians(zenith_deg)))
    flux = differential_flux(
        kinetic_energy_gev, cosine, physics.flux_model, physics.gaisser_parameters, altitude_m
    )
    tabulated = MODELS[physics.flux_model].tabulated
    if physics.altitude_correction and not tabulated:
        flux = flux * altitude_factor(momentum_from_kinetic(kinetic_energy_gev), altitude_m)
    return SpectrumCurve(
        physics.flux_model,
        zenith_deg,
        kinetic_energy_gev,
        flux,
        model_holds(physics, cosine, kinetic_energy_gev),
        muon_sky().relative_error(kinetic_energy_gev, cosine, altitude_m)
        if tabulated
        else np.full(kinetic_energy_gev.shape, np.nan),
    )


def attenuation_curve(
    opacity_g_cm2: np.ndarray, zenith_deg: float, physics: Physics, altitude_m: float = 0.0
) -> AttenuationCurve:
    """Return the flux of the flux model of `physics` behind a range of opacities."""
    muons = attenuate(opacity_g_cm2, np.array(90.0 - zenith_deg), physics, altitude_m)
    cosine = np.array(math.cos(math.radians(zenith_deg)))
    sky = np.array(physics.open_sky_start_gev)
    return AttenuationCurve(
        physics.flux_model,
        zenith_deg,
        opacity_g_cm2,
        muons.minimum_energy_gev,
        muons.flux,
        np.broadcast_to(muons.open_sky, opacity_g_cm2.shape),
        muons.transmission,
        np.isfinite(muons.flux)
        & model_holds(physics, cosine, np.fmax(muons.minimum_energy_gev, sky)),
        # As loosely as the warnings of a simulation have it.
        bool(model_holds(physics, cosine, sky, OPEN_SKY_SLACK)),
    )


def loss_curve(material: str) -> LossCurve:
    """Return the energy loss in a material beside the polynomial for standard rock."""
    energy = grid(*_LOSS_DECADES)
    per_mev = 1e3  # GeV to MeV
    return LossCurve(
        material,
        energy,
        per_mev * stopping_power(energy, material),
        per_mev * stopping_power(energy, material, "lesparre"),
        csda_range(energy, material),
    )


def minimum_energy_curve(
    opacity_g_cm2: np.ndarray, energy_loss: str, physics: Physics
) -> MinimumEnergyCurve:
    """Return the energy that rock of the material of `physics` demands by one range law."""
    return MinimumEnergyCurve(
        energy_loss,
        opacity_g_cm2 / (physics.density * G_CM2_PER_M_WATER_EQUIVALENT),
        opacity_g_cm2,
        minimum_energy(opacity_g_cm2, replace(physics, energy_loss=energy_loss)),
    )


def _warnings(
    opacity_g_cm2: float, zenith_deg: Sequence[float], physics: Physics, altitude_m: float
) -> list[str]:
    """Return what a simulation would say of each ray, as one sentence for equal ones."""
    angles: dict[str, list[str]] = {}
    for angle in zenith_deg:
        muons = attenuate(np.array([opacity_g_cm2]), np.array(90.0 - angle), physics, altitude_m)
        for text in muons.warnings:
            # “1 ray: …” counts pixels; here the ray has a name.
            angles.setdefault(text.partition(": ")[2], []).append(f"{angle:g}°")
    title = MODELS[physics.flux_model].title
    return [f"{title} at {', '.join(where)}: {text}" for text, where in angles.items()]
