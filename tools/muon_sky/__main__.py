"""Make the table of the muon sky, from primaries and interaction models to the file.

Needs what `requirements.txt` beside this file lists; `make sky` sets that up and runs::

    python -m tools.muon_sky [folder for what takes long, build/muon_sky]
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from muysc_qgis.radiography.measured_spectra import Spectra, vertical_spectra

from .cascade import AMPLITUDES, Matter
from .fit import Fit, fit, predicted
from .primaries import nucleons
from .table import Cascades, interpolation_error, write_table
from .yields import make_yields

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "muysc_qgis" / "radiography" / "data"


def main(folder: Path) -> None:
    """Simulate collisions unless that was done, fit, write the table, say how good it is."""
    folder.mkdir(parents=True, exist_ok=True)
    collisions = folder / "yields.npz"
    if not collisions.exists():
        make_yields(collisions)
    cascades = Cascades(Matter.read(collisions), nucleons())
    spectra = vertical_spectra()
    fitted = fit(spectra, cascades.muons)
    notes = _notes(spectra, fitted, predicted(spectra, cascades.muons))
    print("\n".join(notes))
    table = DATA / "muon_sky.csv"
    write_table(table, cascades, fitted, notes)
    worst, (altitude, zenith, energy) = interpolation_error(table, cascades, fitted)
    print(
        f"Largest error halfway between nodes: {100 * worst:.2f} %, at {altitude:g} m, "
        f"{zenith:.4g}° and {energy:.3g} GeV."
    )


def _notes(spectra: Spectra, fitted: Fit, parts: np.ndarray) -> list[str]:
    error = np.sqrt(np.diag(fitted.covariance))
    factors = ", ".join(
        f"{name} {value:.3f} +- {one:.3f}"
        for name, value, one in zip(AMPLITUDES, fitted.amplitude, error)
    )
    ratio = fitted.flux(parts) / spectra.flux
    normalised = spectra.experiment == "L3+C"
    ratio[normalised] *= fitted.normalisation
    rms = [
        f"{name} {100 * np.sqrt(np.mean((ratio[spectra.experiment == name] - 1) ** 2)):.1f} %"
        for name in np.unique(spectra.experiment)
    ]
    return [
        f"Fitted to {fitted.points} points of vertical spectra: chi2 {fitted.chi2:.1f}, rms "
        f"{', '.join(rms)}, L3+C normalised by {1 / fitted.normalisation:.3f}.",
        f"Factors on mesons made by nucleons: {factors}.",
    ]


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / "muon_sky")
