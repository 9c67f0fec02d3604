"""The physics a user chooses is checked once, with a sentence that helps."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.radiography.energy_loss import ENERGY_LOSSES
from muysc_qgis.radiography.gaisser import GAISSER_PARAMETERS
from muysc_qgis.radiography.materials import MATERIALS
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.spectra import MODELS


def test_names_are_those_of_the_interface():
    assert {"standard_rock", "water", "ice", "limestone", "granite", "basalt"} <= set(MATERIALS)
    assert tuple(MODELS) == (
        "gaisser", "gaisser-tang", "bugaev", "reyna-bugaev", "reyna-hebbeker", "guan",
        "gsf-sibyll",
    )  # fmt: skip
    assert tuple(GAISSER_PARAMETERS) == (
        "volkova", "gaisser", "klimushin", "aglietta", "ambrosio",
    )  # fmt: skip
    assert tuple(ENERGY_LOSSES) == ("csda", "lesparre", "paper")


def test_density_is_the_materials_own_unless_given():
    assert Physics().density == 2.65
    assert Physics(material="ice").density == 0.918
    assert Physics(material="ice", density_g_cm3=0.85).density == 0.85


@pytest.mark.parametrize(
    ("field", "choices"),
    [
        ("material", MATERIALS),
        ("flux_model", MODELS),
        ("gaisser_parameters", GAISSER_PARAMETERS),
        ("energy_loss", ENERGY_LOSSES),
    ],
)
@pytest.mark.parametrize("value", ["cheese", "", None, 3])
def test_unknown_names_list_the_choices(field, choices, value):
    with pytest.raises(MuyscError) as caught:
        Physics(**{field: value})
    assert all(choice in str(caught.value) for choice in choices)


@pytest.mark.parametrize("density", [0.0, 5e-324, 9e-7, -2.65, np.nan, np.inf, 2650.0, 30.1])
def test_impossible_densities_are_refused(density):
    with pytest.raises(MuyscError, match=f"{density:g} g/cm³"):
        Physics(density_g_cm3=density)


@pytest.mark.parametrize("threshold", [-1.0, np.nan, np.inf, 1e5])
def test_impossible_thresholds_are_refused(threshold):
    with pytest.raises(MuyscError, match="detection threshold"):
        Physics(detection_threshold_gev=threshold)


@pytest.mark.parametrize("field", ["straggling", "altitude_correction"])
def test_switches_are_true_or_false(field):
    with pytest.raises(MuyscError, match=field):
        Physics(**{field: "no"})
