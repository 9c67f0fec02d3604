"""A telescope's acceptance by direction in place of one number."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.muogram import Muogram
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.telescope.acceptance import trajectories
from muysc_qgis.telescope.geometry import TelescopeGeometry
from muysc_qgis.workflows.simulation import Telescope, through_rock

COLLECTED = trajectories(TelescopeGeometry(6, 4, 10.0, 100.0))
ROCK = Muogram(
    "thickness",
    np.full((3, 4), 100.0),
    np.array([0.0, 10.0, 20.0, 50.0]),
    np.array([30.0, 20.0, 10.0]),
    {"BORESIGHT_AZIMUTH": 10.0, "BORESIGHT_ELEVATION": 20.0, "DETECTOR_ELEVATION": 0.0},
)


def test_between_trajectories_the_acceptance_is_linear():
    x, y = COLLECTED.geometry.step * COLLECTED.geometry.offset_x, np.zeros(11)
    np.testing.assert_allclose(COLLECTED.acceptance_toward(x, y), COLLECTED.acceptance_cm2_sr[3])
    middle = COLLECTED.acceptance_toward(np.array([0.05]), np.array([0.0]))
    assert middle == pytest.approx(COLLECTED.acceptance_cm2_sr[3, 5:7].mean())
    # Towards 0 at the rim, and nothing beyond.
    rim = COLLECTED.acceptance_toward(np.array([0.599, 0.6, 0.7, np.nan]), np.zeros(4))
    assert rim[0] == pytest.approx(0.01 * COLLECTED.acceptance_cm2_sr[3, -1])
    assert np.all(np.isnan(rim[1:]))


def test_each_pixel_has_the_exposure_of_its_direction():
    result = through_rock(ROCK, Physics(), Telescope(6.0, 10.0, COLLECTED))
    exposure, flux = (result.muograms[name].values for name in ("exposure", "flux"))
    # The pixel on the boresight looks along the axis.
    assert exposure[1, 1] == pytest.approx(10 / (flux[1, 1] * COLLECTED.acceptance_cm2_sr.max()))
    assert exposure[1, 2] > 10 / (flux[1, 2] * COLLECTED.acceptance_cm2_sr.max())
    # 40° to the right is outside ±31°.
    assert np.all(np.isnan(exposure[:, 3]))
    assert np.all(np.isfinite(exposure[:, :3]))
    assert "3 of 12 pixels lie outside the telescope's field of view" in result.warnings[0]
    metadata = result.muograms["exposure"].metadata
    assert metadata["ACCEPTANCE"] == pytest.approx(COLLECTED.acceptance_cm2_sr.max())
    assert metadata["BARS_X"] == 6


def test_what_must_be_known_of_the_telescope_is_among_the_warnings():
    result = through_rock(ROCK, Physics(), Telescope(6.0, 10.0, notes=("Planes are 10 cm thick.",)))
    assert result.warnings[0] == "Planes are 10 cm thick."


def test_without_a_boresight_the_telescope_has_no_direction():
    bare = Muogram("thickness", ROCK.values, ROCK.azimuth_deg, ROCK.elevation_deg, {})
    with pytest.raises(MuyscError, match="BORESIGHT_ELEVATION"):
        through_rock(bare, Physics(), Telescope(6.0, 10.0, COLLECTED), 0.0)
    through_rock(bare, Physics(), Telescope(6.0, 10.0), 0.0)
