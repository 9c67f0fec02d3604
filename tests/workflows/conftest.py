"""A real mountain, and what telescopes all around it see."""

import numpy as np
import pytest
from pyproj import Geod

from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.named_view import NamedView
from muysc_qgis.workflows.simulation import Telescope, simulate

#: The crater of Vesuvius, and how far (m) from it the stations stand.
CRATER, AWAY_M, STATIONS = (14.4265, 40.8215), 1500.0, 6
#: g/cm³
DENSITY = 2.4


@pytest.fixture(scope="session")
def dem(data_folder):
    return open_dem(data_folder / "vesuvius_srtmgl1.tif")


@pytest.fixture(scope="session")
def views(dem):
    """Return a function from a quantity to the muograms of a cone of 2.4 g/cm³ from six sides."""
    target = from_wgs84(dem.crs, *CRATER)
    found = []
    for azimuth in np.arange(STATIONS) * 360.0 / STATIONS:
        place = Geod(ellps="WGS84").fwd(*CRATER, azimuth, AWAY_M)[:2]
        sight = take_sight(dem, from_wgs84(dem.crs, *place), target, 2.0, 60.0)
        physics = Physics(density_g_cm3=DENSITY)
        found.append(simulate(sight, Aperture(60, 24, 24, 14), physics, Telescope()))

    def named(quantity):
        return [
            NamedView(f"site_{number}_{quantity}", one.muograms[quantity])
            for number, one in enumerate(found)
        ]

    return named
