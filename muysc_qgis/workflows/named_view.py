"""A muogram with the name that messages call it by, and what its metadata say."""

from __future__ import annotations

from dataclasses import dataclass

from ..errors import MuyscError
from ..muogram import DOMAIN, finite_number
from ..radiography.settings import Physics
from ..views import View

_YES_OR_NO = {"yes": True, "no": False}


@dataclass(frozen=True)
class NamedView:
    """A muogram or raster in telescope angles, one of several."""

    name: str
    view: View

    def text(self, key: str) -> str:
        """Return a metadata entry.

        Raises
        ------
        MuyscError
            If it is missing, naming the file.
        """
        if key not in self.view.metadata:
            raise MuyscError(
                f"{self.name} lacks the metadata key {key} (domain {DOMAIN}), which a muogram of "
                f"{self.view.quantity} needs here; make it with a MUYSC algorithm or set the key."
            )
        return str(self.view.metadata[key])

    def number(self, key: str) -> float:
        """Return a metadata entry as a number.

        Raises
        ------
        MuyscError
            If it is missing or no finite number, naming the file.
        """
        text = self.text(key)
        try:
            return finite_number(text)
        except ValueError:
            raise MuyscError(
                f"The metadata key {key} of {self.name} is “{text}”, which is not a finite number; "
                "set it to one."
            ) from None

    def physics(self) -> Physics:
        """Return the physics that the muogram was made with.

        Raises
        ------
        MuyscError
            If the metadata do not say it.
        """
        return Physics(
            material=self.text("MATERIAL"),
            density_g_cm3=self.number("DENSITY") if "DENSITY" in self.view.metadata else None,
            flux_model=self.text("FLUX_MODEL"),
            gaisser_parameters=self.text("GAISSER_PARAMETERS"),
            energy_loss=self.text("ENERGY_LOSS"),
            straggling=self._flag("STRAGGLING"),
            altitude_correction=self._flag("ALTITUDE_CORRECTION"),
            detection_threshold_gev=self.number("DETECTION_THRESHOLD"),
        )

    def _flag(self, key: str) -> bool:
        word = self.text(key)
        if word not in _YES_OR_NO:
            raise MuyscError(
                f"The metadata key {key} of {self.name} is “{word}”; set it to yes or no."
            )
        return _YES_OR_NO[word]
