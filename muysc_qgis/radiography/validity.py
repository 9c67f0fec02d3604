"""Counting the rays that leave the range in which a formula holds, and saying so."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

import numpy as np

from . import muon_sky
from .altitude import MAXIMUM_ALTITUDE_M, MINIMUM_MOMENTUM_GEV
from .constants import MUON_MASS_GEV
from .energy_loss import LESPARRE_LIMIT_GEV
from .gaisser import GAISSER_PARAMETERS, GaisserParameters
from .materials import MATERIALS
from .settings import Physics
from .spectra import AGREED_WITHIN, MODELS, SpectrumModel, kinetic_from_momentum
from .straggling import maximum_opacity_g_cm2

#: A spectrum asked just below its range is off by its own uncertainty, one asked from
#: this factor below by tens of percent; the open sky is named only then.
OPEN_SKY_SLACK = 4.0

#: Zenith angle in degrees up to which the altitude correction, a law for vertical muons, is
#: taken. An inclined muon crosses 1/cosθ times the air and gains more from less of it: at
#: 2500 m and 80° the flux above 1 GeV/c is 1.41 times that at sea level, and the law has 1.19.
ALTITUDE_ZENITH_DEG = 60.0


def count_departures(
    opacity_g_cm2: np.ndarray,
    cos_zenith: np.ndarray,
    minimum_energy_gev: np.ndarray,
    open_sky_start_gev: float,
    physics: Physics,
    altitude_m: float,
) -> Counter[str]:
    """Count the rays outside what the chosen formulas were made for.

    Parameters
    ----------
    opacity_g_cm2, cos_zenith, minimum_energy_gev
        Opacity in g/cm², cosine of the zenith angle and minimum kinetic energy in GeV;
        arrays that broadcast. Rays without an answer are not counted.
    open_sky_start_gev
        Kinetic energy in GeV from which the open sky counts.
    physics
        The formulas.
    altitude_m
        Height of the detector above sea level, m.
    """
    model = MODELS[physics.flux_model]
    answered = (cos_zenith > 0) & np.isfinite(minimum_energy_gev)
    rock = answered & (opacity_g_cm2 > 0)
    start = np.fmax(minimum_energy_gev, open_sky_start_gev)
    cosine = np.where(cos_zenith > 0, cos_zenith, 1.0)
    lower, upper = model.agreed_range_gev(cosine, GAISSER_PARAMETERS[physics.gaisser_parameters])
    open_sky = open_sky_start_gev + MUON_MASS_GEV
    conditions = {
        "zenith": answered & _farther(cosine, model.agreed_zenith_deg),
        "below": rock & (start + MUON_MASS_GEV < lower),
        "above": rock & (start + MUON_MASS_GEV > upper),
        "open sky": answered & (OPEN_SKY_SLACK * open_sky < lower),
    }
    if model.tabulated:
        inside = muon_sky.LOWEST_LAND_M <= altitude_m <= muon_sky.MAXIMUM_ALTITUDE_M
        if not inside:
            conditions["altitude table"] = answered
    elif physics.altitude_correction and altitude_m != 0:
        conditions["altitude momentum"] = answered & (
            start < kinetic_from_momentum(np.array(MINIMUM_MOMENTUM_GEV))
        )
        conditions["altitude zenith"] = answered & _farther(cosine, ALTITUDE_ZENITH_DEG)
        if altitude_m > MAXIMUM_ALTITUDE_M:
            conditions["altitude"] = answered
    if physics.energy_loss != "csda":
        conditions["lesparre"] = rock & (minimum_energy_gev > LESPARRE_LIMIT_GEV)
        if physics.material != "standard_rock":
            conditions["lesparre material"] = rock
    if physics.straggling:
        conditions["straggling"] = rock & (opacity_g_cm2 > maximum_opacity_g_cm2(physics.material))
    return Counter({name: int(np.count_nonzero(where)) for name, where in conditions.items()})


def _farther(cos_zenith: np.ndarray, zenith_deg: float) -> np.ndarray:
    """Return where rays are farther from the zenith than an angle in degrees."""
    return np.asarray(cos_zenith < np.cos(np.radians(zenith_deg + 1e-9)))


def _limits(model: SpectrumModel, parameters: GaisserParameters) -> tuple[str, str]:
    """Return the lowest and highest energy in which a model holds as text."""
    if not model.agreement:
        lower, upper = (float(end) for end in model.energy_range_gev(np.array(1.0), parameters))
        per_cosine = f"/{model.limiting_cosine_sign}"
        return (
            f"{lower:g} GeV" + per_cosine * model.lower_per_cosine,
            f"{upper:g} GeV" + per_cosine * model.upper_per_cosine,
        )
    angles = [part.zenith_deg for part in model.agreement]
    texts = []
    for values in model.agreed_range_gev(np.cos(np.radians(angles)), parameters):
        first, last = float(values[0]), float(values[-1])
        text = f"{first:g} GeV"
        if last != first:
            text += f" (up to {angles[0]:g}°; {last:g} GeV at {angles[-1]:g}°)"
        texts.append(text)
    return texts[0], texts[1]


def sentences(counts: Mapping[str, int], physics: Physics, altitude_m: float) -> tuple[str, ...]:
    """Return one sentence for every kind of departure that was counted."""
    model = MODELS[physics.flux_model]
    parameters = GAISSER_PARAMETERS[physics.gaisser_parameters]
    title = model.title
    if model.takes_parameters:
        title += f" ({parameters.title})"
    lower_text, upper_text = _limits(model, parameters)
    agrees = f"stays within {100 * AGREED_WITHIN:g} % of measurements"
    holds = agrees if model.agreement else "holds"
    loss = "polynomial of Lesparre et al."
    straggling_limit = maximum_opacity_g_cm2(physics.material)
    texts = {
        "opacity": "{}: the opacity is unknown, so there is no flux.",
        "horizon": "{}: at or below the horizon no flux model has an answer, so there is no flux.",
        "energy loss": f"{{}}: the energy loss “{physics.energy_loss}” has no answer for so much "
        "rock, so there is no minimum energy and no flux.",
        "zenith": f"{{}}: farther from the zenith than the {model.agreed_zenith_deg:g}° up to "
        f"which the flux model {title} {holds}.",
        "below": f"{{}}: the minimum energy is below the {lower_text} from which the flux model "
        f"{title} {holds}.",
        "above": f"{{}}: the minimum energy is above the {upper_text} up to which the flux model "
        f"{title} {holds}.",
        "open sky": f"{{}}: the open sky starts far below the {lower_text} from which the flux "
        f"model {title} {holds}, so open sky and transmission are rough; set a detection threshold "
        "or choose another model.",
        "altitude": f"{{}}: the altitude correction is made for up to {MAXIMUM_ALTITUDE_M:g} m and "
        f"the detector is at {altitude_m:.0f} m.",
        "altitude zenith": f"{{}}: farther from the zenith than the {ALTITUDE_ZENITH_DEG:g}° up to "
        "which the altitude correction, a law for vertical muons, holds; inclined muons gain more "
        "(at 2500 m and 80° the open sky 41 % where it says 19 %).",
        "altitude momentum": "{}: the muons counted start below the "
        f"{MINIMUM_MOMENTUM_GEV:g} GeV/c from which the altitude correction holds.",
        "altitude table": f"{{}}: the flux model {title} is tabulated from "
        f"{muon_sky.MINIMUM_ALTITUDE_M:g} m to {muon_sky.MAXIMUM_ALTITUDE_M:g} m above sea level "
        f"and the detector is at {altitude_m:.0f} m, so its slope there is carried on.",
        "lesparre": f"{{}}: the minimum energy is above the {LESPARRE_LIMIT_GEV:g} GeV up to which "
        f"the {loss} holds.",
        "lesparre material": f"{{}}: the rock is {MATERIALS[physics.material].title.lower()}, and "
        f"the {loss} is made for standard rock.",
        "straggling": f"{{}}: the opacity is above the {straggling_limit:.3g} g/cm² up to which "
        "the straggling correction is known.",
    }
    return tuple(
        text.format("1 ray" if counts[name] == 1 else f"{counts[name]} rays")
        for name, text in texts.items()
        if counts.get(name, 0) > 0
    )
