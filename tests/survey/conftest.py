"""Small surveys of Vesuvius."""

import numpy as np
import pytest

from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.workflows.simulation import Telescope
from muysc_qgis.workflows.site_assessment import SurveyPlan
from muysc_qgis.workflows.view_settings import ViewSettings

TARGET = (14.424745, 40.823729)


@pytest.fixture
def plan(data_folder):
    """Return a function that makes a coarse plan, with changes."""

    def make(**change):
        view = {
            "aperture": Aperture(50, 30, 10, 6),
            "physics": Physics(),
            "telescope": Telescope(),
            "max_range_m": None,
            "near_field_m": 0.0,
        }
        own = {name: change.pop(name, value) for name, value in view.items()}
        return SurveyPlan(
            **{
                "dem": open_dem(data_folder / "vesuvius_srtmgl1.tif"),
                "target": TARGET,
                "target_height_m": 0.0,
                "detector_height_m": 1.0,
                "view": ViewSettings(**own),
                **change,
            }
        )

    return make


@pytest.fixture
def places():
    """Return a function that gives places on a circle around the target, 2 km or so away."""

    def around(count):
        turn = np.linspace(0, 2 * np.pi, count, endpoint=False)
        return np.column_stack([TARGET[0] + 0.025 * np.cos(turn), TARGET[1] + 0.019 * np.sin(turn)])

    return around
