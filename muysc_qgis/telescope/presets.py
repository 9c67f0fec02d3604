"""Telescopes that were built, by the short names of their publications.

Numbers of bars, widths and separations are those by which Peña-Rodríguez et al. compare
the instruments (MUYSC, Geophysical Journal International 237, 540–556, 2024); for
MURAVES those of the example that MUYSC shipped.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..errors import MuyscError
from .geometry import TelescopeGeometry


@dataclass(frozen=True)
class Preset:
    """A telescope with its name and the work that describes it."""

    name: str
    title: str
    geometry: TelescopeGeometry
    citation: str
    url: str = ""


def _square(
    bars: int, pixel_size_cm: float, separation_cm: float, planes: int = 2
) -> TelescopeGeometry:
    return TelescopeGeometry(bars, bars, pixel_size_cm, separation_cm, planes)


PRESETS = {
    preset.name: preset
    for preset in (
        Preset(
            "mute", "MuTe (2020)", _square(30, 4.0, 250.0),
            "Peña-Rodríguez, J., et al. (2020). Design and construction of MuTe: a hybrid Muon "
            "Telescope to study Colombian volcanoes. Journal of Instrumentation, 15, P09006.",
            "https://arxiv.org/abs/2004.09364",
        ),
        Preset(
            "gibert2010", "Gibert et al. (2010)", _square(32, 5.0, 100.0),
            "Gibert, D., et al. (2010). Muon tomography: Plans for observations in the Lesser "
            "Antilles. Earth, Planets and Space, 62(2), 153–165.",
        ),
        Preset(
            "carbone2014", "Carbone et al. (2014)", _square(16, 5.0, 170.0),
            "Carbone, D., et al. (2014). An experiment of muon radiography at Mt Etna (Italy). "
            "Geophysical Journal International, 196(2), 633–643.",
        ),
        Preset(
            "lopresti2020", "Lo Presti et al. (2020)", _square(99, 1.0, 97.0, 3),
            "Lo Presti, D., et al. (2020). Muographic monitoring of the volcano-tectonic "
            "evolution of Mount Etna. Scientific Reports, 10, 11351.",
        ),
        Preset(
            "lesparre2012", "Lesparre et al. (2012)", _square(16, 5.0, 115.0, 3),
            "Lesparre, N., et al. (2012). Density muon radiography of La Soufrière of Guadeloupe "
            "volcano: comparison with geological, electrical resistivity and gravity data. "
            "Geophysical Journal International, 190(2), 1008–1019.",
        ),
        Preset(
            "lesparre2010", "Lesparre et al. (2010)", _square(16, 5.0, 80.0),
            "Lesparre, N., et al. (2010). Geophysical muon imaging: feasibility and limits. "
            "Geophysical Journal International, 183(3), 1348–1361.",
            "https://doi.org/10.1111/j.1365-246X.2010.04790.x",
        ),
        Preset(
            "uchida2009", "Uchida et al. (2009)", _square(12, 7.0, 100.0),
            "Uchida, T., Tanaka, H. K. M. & Tanaka, M. (2009). Space saving and power efficient "
            "readout system for cosmic-ray muon radiography. IEEE Transactions on Nuclear "
            "Science, 56(2), 448–452.",
        ),
        Preset(
            "muraves", "MURAVES (2017)", _square(60, 3.4, 200.0, 4),
            "Saracino, G., et al. (2017). The MURAVES muon telescope: technology and expected "
            "performances. Annals of Geophysics, 60(1), S0103.",
            "https://doi.org/10.4401/ag-7378",
        ),
    )
}  # fmt: skip

#: Name of the choice that takes the user's own numbers.
CUSTOM = "custom"


def telescope_of(
    preset: str,
    bars_x: int | None = None,
    bars_y: int | None = None,
    pixel_size_cm: float | None = None,
    separation_cm: float | None = None,
    planes: int | None = None,
) -> tuple[TelescopeGeometry, tuple[str, ...]]:
    """Return the telescope of a preset or of given numbers.

    A preset wins over numbers: those that differ from it are named in a note.

    Parameters
    ----------
    preset
        Key of `PRESETS`, or `CUSTOM`.
    bars_x, bars_y, pixel_size_cm, separation_cm, planes
        Numbers of a custom telescope; `bars_y` is `bars_x` and `planes` 2 unless given.

    Returns
    -------
    tuple
        The telescope, and a sentence for each number that was not used.

    Raises
    ------
    MuyscError
        If there is no such preset, or a number is missing or impossible.
    """
    values = {
        "bars across": bars_x, "bars up": bars_y, "pixel size (cm)": pixel_size_cm,
        "separation (cm)": separation_cm, "planes": planes,
    }  # fmt: skip
    if preset == CUSTOM:
        if bars_x is None or pixel_size_cm is None or separation_cm is None:
            missing = next(
                name for name, value in values.items()
                if value is None and name not in ("bars up", "planes")
            )  # fmt: skip
            raise MuyscError(
                f"A custom telescope needs bars across, pixel size and separation, and the "
                f"{missing} {'are' if missing.startswith('bars') else 'is'} missing; give all "
                "three or choose a preset."
            )
        geometry = TelescopeGeometry(
            bars_x,
            bars_x if bars_y is None else bars_y,
            pixel_size_cm,
            separation_cm,
            2 if planes is None else planes,
        )
        return geometry, ()
    if preset not in PRESETS:
        raise MuyscError(
            f"There is no telescope “{preset}”; use one of {', '.join([CUSTOM, *PRESETS])}."
        )
    geometry = PRESETS[preset].geometry
    own = (
        geometry.bars_x, geometry.bars_y, geometry.pixel_size_cm, geometry.separation_cm,
        geometry.planes,
    )  # fmt: skip
    notes = tuple(
        f"{name} {given:g} is not used, because the preset {preset} has {its:g}; choose the "
        f"preset {CUSTOM} for numbers of your own."
        for (name, given), its in zip(values.items(), own)
        if given is not None and given != its
    )
    return geometry, notes
