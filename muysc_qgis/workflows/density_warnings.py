"""What to say of measured densities: limits, errors, and what cannot be."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..measurement.density import Densities, Flag
from ..measurement.judgement import (
    DENSEST_G_CM3,
    LIGHTEST_G_CM3,
    SkyCheck,
    check_sky,
    chi_squared,
    impossible,
)
from ..measurement.mean import Mean
from ..measurement.observation import Observation, pixels
from ..measurement.pooling import flux_and_slope
from ..measurement.scene import Scene
from ..progress import Progress, part, silent

#: χ² per datum from which densities scatter more than their errors say.
_SCATTER = 1.5

#: The flux models' uncertainty in the open sky where none is given, and how many standard errors of
#: both are worth a warning.
_MODEL, _ERRORS = 0.1, 2.0


@dataclass(frozen=True)
class Judged:
    """Measured densities, and what they followed from."""

    seen: Observation
    scene: Scene
    found: Densities
    mean: Mean
    limit_confidence: float
    model_uncertainty: float
    #: Told the share done.
    progress: Progress = silent

    @cached_property
    def chi_squared(self) -> float:
        """χ² per datum of the densities about their mean."""
        return chi_squared(self.found, self.mean.density)

    @cached_property
    def sky(self) -> SkyCheck:
        """What the pixels without rock saw."""
        return check_sky(
            self.seen, self.scene, self.scene.thickness_m == 0, part(self.progress, 0.0, 0.5)
        )

    def warnings(self) -> tuple[str, ...]:
        """Return one sentence for each thing to know, what is wrong first."""
        return (*self._wrong(), *self._limited())

    def _limited(self) -> list[str]:
        warnings = []
        limits, bright = self.found.count(Flag.LOWER_LIMIT), self.found.count(Flag.BRIGHT)
        no_answer = self.found.count(Flag.NO_ANSWER)
        if limits:
            warnings.append(
                f"{pixels(limits)}: no muon was counted, or fewer than come past the rock, so "
                f"the density is a lower limit ({100 * self.limit_confidence:g} % confidence) "
                f"without an error, flagged {int(Flag.LOWER_LIMIT)}; merge pixels, or count longer."
            )
        if bright:
            warnings.append(
                f"{pixels(bright)}: there is rock, yet the flux is that of the open sky or more, "
                f"so the density is 0, flagged {int(Flag.BRIGHT)}; check the pointing, the "
                "background and the normalisation."
            )
        if no_answer:
            warnings.append(
                f"{pixels(no_answer)}: no density of any matter explains the flux, or the ray is "
                f"at or below the horizon, so there is none, flagged {int(Flag.NO_ANSWER)}."
            )
        measurable = self.found.flags == Flag.MEASURED
        open_ended = int(np.count_nonzero(measurable & np.isnan(self.found.upper)))
        if not np.isfinite(self.found.lower[measurable]).any() and measurable.any():
            warnings.append(
                "The densities have no errors, because the measurement has none; give a muogram of "
                "its errors, or a flux-model uncertainty."
            )
        elif open_ended:
            warnings.append(
                f"{pixels(open_ended)}: the error of the measurement is as large as its value, so "
                "the density has no upper end and no error."
            )
        if self.seen.sky_counts is not None:
            empty = int(
                np.count_nonzero((self.seen.sky_counts == 0) & (self.scene.thickness_m > 0))
            )
            if empty:
                warnings.append(
                    f"{pixels(empty)}: no muon was counted in the open sky, so nothing is known."
                )
        return warnings

    def _wrong(self) -> list[str]:
        """Return what cannot be, with cause and remedy."""
        warnings = []
        sky = self.sky
        model = max(self.model_uncertainty, _MODEL)
        off = abs(sky.ratio - 1.0)
        if off > _ERRORS * np.hypot(np.nan_to_num(sky.error), model):
            _, slope = flux_and_slope(
                self.scene, self.scene.physics.density, part(self.progress, 0.5, 1.0)
            )
            steep = slope[self.scene.rock & (slope > 0)]
            shift = ""
            if steep.size and sky.ratio > 0:
                factor = sky.ratio ** (1.0 / float(np.median(steep)))
                shift = f" and the densities are {'low' if factor > 1 else 'high'} by a factor of "
                shift += f"about {max(factor, 1 / factor):.2g}"
            warnings.append(
                f"{pixels(sky.pixels)} of open sky saw {sky.ratio:.2f} ± {sky.error:.2g} times "
                f"what the flux model promises, so acceptance, efficiency, days or normalisation "
                f"are wrong{shift}; check them, or give the counts of a run in the open sky."
            )
        light, dense = impossible(self.found)
        for number, what, limit, cause in (
            (light, "lighter", LIGHTEST_G_CM3, "muons that did not come through the rock, or too "
             "large a thickness"),
            (dense, "denser", DENSEST_G_CM3, "too small a thickness or too large an acceptance"),
        ):  # fmt: skip
            if number:
                warnings.append(
                    f"{pixels(number)}: {what} than {limit:g} g/cm³ beyond the errors, as no rock "
                    f"is; the cause may be {cause}, or a wrong pointing: check acceptance, "
                    "pointing and elevation model."
                )
        if self.chi_squared > _SCATTER:
            warnings.append(
                f"The densities scatter about their mean by χ² = {self.chi_squared:.2g} per "
                "datum, more than their errors say, so that the error of the mean is too "
                "small: the rock is of several densities, or terrain, pointing or acceptance are "
                "off; see where on the muogram it is, and give a model uncertainty for what all "
                "pixels share."
            )
        mixed = self.found.count(Flag.MIXED)
        if mixed:
            warnings.append(
                f"{pixels(mixed)}: the skyline crosses them, or the thickness changes so much "
                f"within them that one ray says too little; they are flagged {int(Flag.MIXED)} and "
                "have no density: give DEM, with which every pixel is seen with all its rays."
            )
        return warnings
