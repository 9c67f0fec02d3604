"""A mountain whose skyline and thickness are known in closed form."""

import numpy as np
import pytest

from muysc_qgis.muogram import Muogram

#: Where the detector of the tests stands and looks.
METADATA = {
    "DETECTOR_LON": 14.410686,
    "DETECTOR_LAT": 40.810561,
    "DETECTOR_ELEVATION": 604.0,
    "BORESIGHT_AZIMUTH": 39.0,
    "BORESIGHT_ELEVATION": 15.0,
    "TARGET_DISTANCE": 1883.0,
    "DENSITY": 2.65,
    "FLUX_MODEL": "gaisser-tang",
    "ENERGY_LOSS": "csda",
}


def skyline_zenith_deg(azimuth_from_boresight_deg):
    """Zenith angle of the mountain's edge: a parabola with its top at 70°."""
    return 70.0 + azimuth_from_boresight_deg**2 / 40.0


@pytest.fixture
def make_mountain():
    """Return thickness, flux and open sky: 150 m of rock per degree below the skyline."""

    def make(
        columns=60, rows=40, width=42.0, height=22.0, azimuth=39.0, elevation=15.0, **metadata
    ):
        across = azimuth + ((np.arange(columns) + 0.5) / columns - 0.5) * width
        down = elevation - ((np.arange(rows) + 0.5) / rows - 0.5) * height
        depth = (90.0 - down)[:, None] - skyline_zenith_deg(across - 39.0)
        thickness = Muogram(
            "thickness",
            np.maximum(0.0, 150.0 * depth),
            across,
            down,
            {**METADATA, "BORESIGHT_AZIMUTH": azimuth, **metadata},
        )
        open_sky = np.repeat(200.0 * np.cos(np.radians(90.0 - down))[:, None] ** 2, columns, axis=1)
        flux = open_sky * np.exp(-thickness.values / 200.0)
        return {
            "thickness": thickness,
            "flux": thickness.with_values("flux", flux),
            "open_sky": thickness.with_values("open_sky", open_sky),
        }

    return make


@pytest.fixture
def mountain(make_mountain):
    return make_mountain()
