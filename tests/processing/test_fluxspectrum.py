"""Comparing spectra as an algorithm: parameters, files, numbers, refusals."""

import csv
from pathlib import Path

import pytest

FILES = {
    "TABLE": "spectra.csv",
    "FLUX_TABLE": "fluxes.csv",
    "ENERGY_LOSS_TABLE": "losses.csv",
    "MINIMUM_ENERGY_TABLE": "energies.csv",
    "PANEL": "panel.png",
    "REPORT": "report.html",
}


@pytest.fixture
def algorithm(provider):
    return provider.algorithm("fluxspectrum")


@pytest.fixture
def files(tmp_path):
    return {name: str(tmp_path / file) for name, file in FILES.items()}


def table(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


#: Empty stands for the material's own, and the usual, value.
_OWN = ("DENSITY", "DETECTION_THRESHOLD")


def test_parameters_have_defaults(algorithm):
    for definition in algorithm.parameterDefinitions():
        if not definition.isDestination() and definition.name() not in _OWN:
            assert definition.defaultValue() is not None, definition.name()
    assert algorithm.parameterDefinition("FLUX_MODEL") is None
    models = algorithm.parameterDefinition("FLUX_MODELS")
    assert models.options() == models.defaultValue()
    assert {one.name() for one in algorithm.destinationParameterDefinitions()} == set(FILES)
    numbers = {one.name() for one in algorithm.outputDefinitions()} - set(FILES)
    assert numbers == {"OPACITY", "MINIMUM_ENERGY", "LARGEST_RATIO"}


def test_it_introduces_itself(algorithm):
    assert algorithm.id() == "muysc:fluxspectrum"
    assert algorithm.displayName() == "Compare muon spectra"
    assert "outside a model's range" in algorithm.shortHelpString()


def test_defaults_write_everything(run, files):
    results = run("fluxspectrum", files)
    for name, path in files.items():
        assert results[name] == path
    # 500 m of standard rock: 410 GeV from the range tables, and 2 GeV more for those that
    # have 0.9 GeV left.
    assert results["MINIMUM_ENERGY"] == pytest.approx(412.0, rel=5e-3)
    assert results["OPACITY"] == pytest.approx(132500.0)
    assert results["LARGEST_RATIO"] > 1
    spectra = table(files["TABLE"])
    assert {row["model"] for row in spectra} == {
        "gaisser", "gaisser-tang", "bugaev", "reyna-bugaev", "reyna-hebbeker", "guan",
        "gsf-sibyll",
    }  # fmt: skip
    assert {float(row["zenith_deg"]) for row in spectra} == {0, 30, 60, 75, 85}
    assert {row["within_validity"] for row in spectra} == {"0", "1"}


def test_chosen_values_reach_the_tables_and_the_log(run, recorder, files):
    feedback = recorder()
    run(
        "fluxspectrum",
        {
            **files,
            "FLUX_MODELS": ["bugaev", "guan"],
            "ZENITH_ANGLES": "80",
            "THICKNESS": 120,
            "MATERIAL": "basalt",
            "DENSITY": 2.5,
            "MATERIALS": ["ice"],
        },
        feedback,
    )
    fluxes = table(files["FLUX_TABLE"])
    assert {row["model"] for row in fluxes} == {"bugaev", "guan"}
    assert any(float(row["opacity_g_per_cm2"]) == pytest.approx(30000) for row in fluxes)
    assert [row["material"] for row in table(files["ENERGY_LOSS_TABLE"])][::121] == [
        "basalt",
        "ice",
    ]
    assert any(text.startswith("Bugaev at 80°: farther from") for text in feedback.warnings)
    report = Path(files["REPORT"]).read_text(encoding="utf-8")
    assert "Flux, Guan et al. at 80°" in report
    # Lists of choices are told in full, defaults too.
    assert "bugaev, guan" in report


def test_fluxes_are_those_of_muonflux(run, files, tmp_path, vesuvius):
    """A pixel of a muogram and the row of its opacity say the same."""
    import numpy as np
    from osgeo import gdal

    one = {
        **vesuvius,
        "FLUX_MODEL": "gaisser-tang",
        "AZIMUTH_PIXELS": 3,
        "ELEVATION_PIXELS": 3,
        "ALTITUDE_CORRECTION": False,
    }
    names = ("THICKNESS", "FLUX", "TRANSMISSION")
    paths = {name: str(tmp_path / f"{name}.tif") for name in names}
    run("radiography", {**one, **paths})
    rock, flux, transmission = (gdal.Open(paths[name]).ReadAsArray() for name in names)
    row, column = np.unravel_index(np.argmax(rock), rock.shape)
    dataset = gdal.Open(paths["FLUX"])
    origin = dataset.GetGeoTransform()
    zenith = 90 - (origin[3] + origin[5] * (row + 0.5))
    run(
        "fluxspectrum",
        {
            **files,
            "FLUX_MODELS": ["gaisser-tang"],
            "ZENITH_ANGLES": repr(float(zenith)),
            "THICKNESS": float(rock[row, column]),
        },
    )
    rows = table(files["FLUX_TABLE"])
    (same,) = (one for one in rows if abs(float(one["thickness_m"]) / rock[row, column] - 1) < 1e-6)
    assert float(same["flux_per_cm2_sr_day"]) == pytest.approx(flux[row, column], rel=1e-5)
    assert float(same["transmission"]) == pytest.approx(transmission[row, column], rel=1e-5)


def test_a_missing_minimum_energy_leaves_the_files_whole(run, recorder, files):
    feedback = recorder()
    results = run("fluxspectrum", {**files, "THICKNESS": 700, "ENERGY_LOSS": "paper"}, feedback)
    assert results["MINIMUM_ENERGY"] != results["MINIMUM_ENERGY"]
    assert any("“paper” has no answer" in text for text in feedback.warnings)
    assert "standard_rock, water, granite, basalt, limestone" in Path(files["REPORT"]).read_text(
        encoding="utf-8"
    )
    assert "unknown" in Path(files["REPORT"]).read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"ZENITH_ANGLES": "0, 90"}, "zenith angle of 90° is not above the horizon"),
        ({"ZENITH_ANGLES": ""}, "list of zenith angles is empty"),
        ({"ZENITH_ANGLES": "0, many"}, "“many” is no number"),
        ({"THICKNESS": 0}, "thickness of 0 m cannot be compared"),
        ({"THICKNESS": -3}, "thickness of -3 m cannot be compared"),
        ({"THICKNESS": "thick"}, "THICKNESS is “thick”"),
        ({"FLUX_MODELS": ["hebbeker"]}, "FLUX_MODELS names “hebbeker”; use some of gaisser"),
        ({"FLUX_MODELS": []}, "FLUX_MODELS is empty"),
        ({"MATERIALS": ["cheese"]}, "MATERIALS names “cheese”"),
        ({"DENSITY": -1}, "-1 g/cm³"),
        ({"ALTITUDE": 20000}, "20000"),
        ({"TABLE": "table.txt"}, "ends in .csv"),
    ],
)
def test_bad_input_is_refused_in_one_sentence_and_leaves_no_file(
    run, files, tmp_path, change, words
):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match=words):
        run("fluxspectrum", {**files, **change})
    assert list(tmp_path.iterdir()) == []
