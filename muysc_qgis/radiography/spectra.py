"""The catalogue of sea-level muon spectra, and the one way to evaluate any of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from . import muon_sky
from .constants import MUON_MASS_GEV
from .gaisser import (
    GAISSER_PARAMETERS,
    GaisserParameters,
    cos_zenith_at_production,
    gaisser,
    gaisser_tang,
    guan,
)
from .reyna import BUGAEV_BREAKS_GEV, bugaev, reyna_bugaev, reyna_hebbeker

#: How close to measured spectra a formula stays within its `agreement`.
AGREED_WITHIN = 0.15


@dataclass(frozen=True)
class Agreement:
    """Where a formula stays within `AGREED_WITHIN` of measured muons, as far as a zenith angle.

    Found by ``python -m tools.validation.formula_ranges``: BESS-TeV and L3+C overhead, carried
    to other angles by calculations, because inclined measurements differ by more than that.
    """

    #: Zenith angle in degrees up to which the energies count, from that of the one before.
    zenith_deg: float
    #: Energies in GeV from which muons may be counted: all above one of these agree.
    lower_gev: float
    upper_gev: float


@dataclass(frozen=True)
class SpectrumModel:
    """A parametrised spectrum, what it was made for and where it comes from.

    Two ranges stand side by side. That of its publication (`energy_range_gev`,
    `maximum_zenith_deg`) chooses the models of an envelope; that in which it agrees with
    measurements (`agreed_range_gev`, `agreed_zenith_deg`) is what warnings are about.
    """

    name: str
    title: str
    citation: str
    #: dI/dE in cm⁻² s⁻¹ sr⁻¹ GeV⁻¹ of total energy (GeV), momentum (GeV/c), cosine of the
    #: zenith angle, Gaisser's constants and altitude (m); what a model has no use for it
    #: ignores.
    evaluate: Callable[[np.ndarray, np.ndarray, np.ndarray, GaisserParameters, float], np.ndarray]
    #: Range of total energy in GeV that its publication gives the model …
    lower_gev: float
    upper_gev: float
    #: … and whether these limits are to be divided by the cosine of the zenith angle.
    lower_per_cosine: bool
    upper_per_cosine: bool
    #: Largest zenith angle in degrees that its publication gives the model.
    maximum_zenith_deg: float
    #: Whether the constants of Gaisser's formula can be chosen.
    takes_parameters: bool = False
    #: The cosine that limits are divided by, of the cosine of the zenith angle, and its sign.
    limiting_cosine: Callable[[np.ndarray], np.ndarray] = np.asarray
    limiting_cosine_sign: str = "cosθ"
    #: Momenta in GeV/c at which the spectrum is continuous but not smooth.
    breaks_gev: tuple[float, ...] = ()
    #: Whether it is a table of measured accuracy over altitude, angle and energy, with an
    #: error of its own, instead of a formula for sea level.
    tabulated: bool = False
    #: Where it agrees with measurements, by rising zenith angle; empty for a model that
    #: does so wherever it was made for.
    agreement: tuple[Agreement, ...] = ()

    @property
    def agreed_zenith_deg(self) -> float:
        """Largest zenith angle in degrees at which the model agrees with measurements."""
        return self.agreement[-1].zenith_deg if self.agreement else self.maximum_zenith_deg

    def agreed_range_gev(
        self, cos_zenith: np.ndarray, parameters: GaisserParameters
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return from which and up to which energy, GeV, the model agrees with measurements.

        Beyond `agreed_zenith_deg` it does nowhere; what is returned there is that at it.

        Parameters
        ----------
        cos_zenith
            Cosine of the zenith angle, any shape, above 0.
        parameters
            Constants of Gaisser's formula. The ranges were found with those of Gaisser;
            others do not hold below or above what they were fitted to either.
        """
        if not self.agreement:
            return self.energy_range_gev(cos_zenith, parameters)
        ends = np.array([part.zenith_deg for part in self.agreement[:-1]])
        cosine = np.asarray(cos_zenith, dtype=float)
        part = np.sum(cosine[..., None] < np.cos(np.radians(ends + 1e-9)), axis=-1)
        lower = np.array([each.lower_gev for each in self.agreement])[part]
        upper = np.array([each.upper_gev for each in self.agreement])[part]
        if self.takes_parameters:
            if parameters.fitted_from_gev > GAISSER_PARAMETERS["gaisser"].fitted_from_gev:
                lower = np.maximum(lower, parameters.fitted_from_gev)
            upper = np.minimum(upper, parameters.fitted_to_gev)
        return lower, upper

    def energy_range_gev(
        self, cos_zenith: np.ndarray, parameters: GaisserParameters
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the lowest and the highest total energy, GeV, of the model's publication.

        Parameters
        ----------
        cos_zenith
            Cosine of the zenith angle, any shape, above 0.
        parameters
            Constants of Gaisser's formula, whose own range counts where they are used.
        """
        lower, upper = self.lower_gev, self.upper_gev
        if self.takes_parameters:
            upper = parameters.fitted_to_gev
            # The low-energy extension of the modified form belongs to constants that
            # hold from 100 GeV; sets fitted higher up do not hold below their fit.
            if parameters.fitted_from_gev > GAISSER_PARAMETERS["gaisser"].fitted_from_gev:
                lower = max(lower, parameters.fitted_from_gev)
        cosine = self.limiting_cosine(np.asarray(cos_zenith, dtype=float))
        one = np.ones_like(cosine)
        return (
            lower / cosine if self.lower_per_cosine else lower * one,
            upper / cosine if self.upper_per_cosine else upper * one,
        )


#: The model that everything uses where none is named.
DEFAULT_MODEL = "gsf-sibyll"


#: Every spectrum by its name in the interface.
MODELS = {
    model.name: model
    for model in (
        SpectrumModel(
            "gaisser",
            "Gaisser",
            "Gaisser (1990), Cosmic Rays and Particle Physics, Cambridge University Press",
            lambda energy, momentum, cosine, parameters, _: gaisser(energy, cosine, parameters),
            lower_gev=100.0,
            upper_gev=1e5,
            lower_per_cosine=True,
            upper_per_cosine=False,
            maximum_zenith_deg=70.0,
            takes_parameters=True,
            agreement=(
                Agreement(30.0, 150.0, 1e5),
                Agreement(60.0, 200.0, 1e5),
                Agreement(70.0, 350.0, 1e5),
            ),
        ),
        SpectrumModel(
            "gaisser-tang",
            "Gaisser (MUSIC/MUSUN)",
            "Kudryavtsev (2009), doi:10.1016/j.cpc.2008.10.013, after Dar (1983), "
            "doi:10.1103/PhysRevLett.51.227",
            lambda energy, momentum, cosine, parameters, _: gaisser_tang(
                energy, cosine, parameters
            ),
            # Below 1 GeV/cosθ* Tang et al. (2006) change the formula once more; this one runs
            # on. The name is the first that it had here, and is kept for projects.
            lower_gev=1.0,
            upper_gev=1e5,
            lower_per_cosine=True,
            upper_per_cosine=False,
            maximum_zenith_deg=90.0,
            takes_parameters=True,
            limiting_cosine=cos_zenith_at_production,
            limiting_cosine_sign="cosθ*",
            agreement=(
                Agreement(30.0, 50.0, 1e5),
                Agreement(60.0, 70.0, 1e5),
                Agreement(75.0, 130.0, 1e5),
                Agreement(80.0, 200.0, 1e5),
                Agreement(85.0, 450.0, 1e5),
            ),
        ),
        SpectrumModel(
            "bugaev",
            "Bugaev",
            "Bugaev et al. (1998), doi:10.1103/PhysRevD.58.054001",
            lambda energy, momentum, cosine, parameters, _: (
                bugaev(momentum) * energy / momentum * np.ones_like(cosine)
            ),
            lower_gev=1.0,
            upper_gev=np.inf,
            lower_per_cosine=False,
            upper_per_cosine=False,
            # A spectrum of vertical muons; cos²θ falls by 3 % over 10°.
            maximum_zenith_deg=10.0,
            breaks_gev=BUGAEV_BREAKS_GEV,
            agreement=(Agreement(10.0, 50.0, np.inf),),
        ),
        SpectrumModel(
            "reyna-bugaev",
            "Reyna–Bugaev",
            "Reyna (2006), arXiv:hep-ph/0604145",
            lambda energy, momentum, cosine, parameters, _: (
                reyna_bugaev(momentum, cosine) * energy / momentum
            ),
            lower_gev=1.0,
            upper_gev=2000.0,
            lower_per_cosine=False,
            upper_per_cosine=True,
            maximum_zenith_deg=90.0,
            agreement=(
                Agreement(30.0, 1.0, 100.0),
                Agreement(60.0, 6.0, 100.0),
                Agreement(75.0, 8.0, 50.0),
                Agreement(80.0, 8.0, 40.0),
                Agreement(85.0, 8.0, 25.0),
            ),
        ),
        SpectrumModel(
            "reyna-hebbeker",
            "Reyna–Hebbeker",
            "Hebbeker & Timmermans (2002), doi:10.1016/S0927-6505(01)00180-3, inclined as "
            "in Reyna (2006), arXiv:hep-ph/0604145",
            lambda energy, momentum, cosine, parameters, _: (
                reyna_hebbeker(momentum, cosine) * energy / momentum
            ),
            lower_gev=10.0,
            upper_gev=1e4,
            lower_per_cosine=True,
            upper_per_cosine=True,
            maximum_zenith_deg=90.0,
            agreement=(
                Agreement(30.0, 5.0, 500.0),
                Agreement(60.0, 5.0, 50.0),
                Agreement(75.0, 9.0, 30.0),
                Agreement(80.0, 10.0, 30.0),
                Agreement(85.0, 10.0, 25.0),
            ),
        ),
        SpectrumModel(
            "guan",
            "Guan et al.",
            "Guan et al. (2015), arXiv:1509.06176",
            lambda energy, momentum, cosine, parameters, _: guan(energy, cosine),
            lower_gev=1.0,
            upper_gev=1e5,
            lower_per_cosine=False,
            upper_per_cosine=False,
            maximum_zenith_deg=90.0,
            agreement=(Agreement(80.0, 1.0, 1e5), Agreement(85.0, 70.0, 1e5)),
        ),
        SpectrumModel(
            DEFAULT_MODEL,
            "GSF–SIBYLL",
            "primaries of Dembinski et al. (2017), arXiv:1711.11432, hadrons by SIBYLL 2.3d, "
            "Riehn et al. (2020), doi:10.1103/PhysRevD.102.063002, and UrQMD 3.4; fitted to "
            "BESS-TeV and L3+C",
            lambda energy, momentum, cosine, parameters, altitude: muon_sky.muon_sky().flux(
                # Without the rounding of what is left of the total energy.
                kinetic_from_momentum(momentum),
                cosine,
                altitude,
            ),
            lower_gev=muon_sky.LOWEST_GEV + MUON_MASS_GEV,
            upper_gev=muon_sky.HIGHEST_GEV + MUON_MASS_GEV,
            lower_per_cosine=False,
            upper_per_cosine=False,
            maximum_zenith_deg=muon_sky.MAXIMUM_ZENITH_DEG,
            tabulated=True,
        ),
    )
}


def momentum_from_kinetic(kinetic_energy_gev: np.ndarray) -> np.ndarray:
    """Return the momentum in GeV/c of muons of a kinetic energy in GeV: p² = T (T + 2m)."""
    return np.sqrt(kinetic_energy_gev * (kinetic_energy_gev + 2.0 * MUON_MASS_GEV))


def kinetic_from_momentum(momentum_gev: np.ndarray) -> np.ndarray:
    """Return the kinetic energy in GeV of muons of a momentum in GeV/c."""
    # p²/(E + m) = E − m, without the cancellation at low momentum.
    return np.square(momentum_gev) / (np.hypot(momentum_gev, MUON_MASS_GEV) + MUON_MASS_GEV)


def differential_flux(
    kinetic_energy_gev: np.ndarray,
    cos_zenith: np.ndarray,
    model: str = DEFAULT_MODEL,
    gaisser_parameters: str = "gaisser",
    altitude_m: float = 0.0,
) -> np.ndarray:
    """Return the differential muon flux, the formulas' at sea level.

    Parameters
    ----------
    kinetic_energy_gev
        Kinetic energy in GeV, above 0.
    cos_zenith
        Cosine of the zenith angle, above 0; broadcasts with the energy.
    model
        Key of `MODELS`.
    gaisser_parameters
        Key of `GAISSER_PARAMETERS`, for the models that take them.
    altitude_m
        Height above sea level in m, for models that are tabulated; the formulas know
        nothing of it.

    Returns
    -------
    numpy.ndarray
        dI/dE in cm⁻² s⁻¹ sr⁻¹ GeV⁻¹, of the broadcast shape. Spectra defined in
        momentum are converted by dI/dE = dI/dp · E/p.
    """
    kinetic_energy_gev = np.asarray(kinetic_energy_gev, dtype=float)
    return MODELS[model].evaluate(
        kinetic_energy_gev + MUON_MASS_GEV,
        momentum_from_kinetic(kinetic_energy_gev),
        np.asarray(cos_zenith, dtype=float),
        GAISSER_PARAMETERS[gaisser_parameters],
        altitude_m,
    )
