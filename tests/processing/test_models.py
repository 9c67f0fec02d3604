"""The models that come with the provider: what the algorithms give alone, in one run."""

import importlib

import pytest
from osgeo import gdal


@pytest.fixture
def place(vesuvius):
    return {name: vesuvius[name] for name in ("DEM", "DETECTOR", "TARGET")}


def files(folder, *names):
    return {
        name: str(folder / f"{name.lower().replace(':', '_')}.{suffix}")
        for name, suffix in (one.split(".") for one in names)
    }


def pixels(path):
    dataset = gdal.Open(path)
    return dataset.ReadAsArray()


def test_a_volcano_survey_gives_what_its_steps_give(run, vesuvius, tmp_path):
    outputs = files(
        tmp_path, "radiography:THICKNESS.tif", "radiography:FLUX.tif", "radiography:EXPOSURE.tif",
        "radiography:FIELD_OF_VIEW.gpkg", "radiography:REPORT.html", "thickness:OUTPUT.tif",
        "flux:OUTPUT.tif",
    )  # fmt: skip
    results = run("volcanosurvey", {**vesuvius, **outputs})
    assert {name: results[name] for name in outputs} == outputs
    alone = str(tmp_path / "alone.tif")
    run("radiography", {**vesuvius, "THICKNESS": str(tmp_path / "t.tif"), "FLUX": alone})
    assert pixels(outputs["radiography:FLUX"]) == pytest.approx(pixels(alone), nan_ok=True)
    draped = str(tmp_path / "draped.tif")
    run("drape", {"MUOGRAM": alone, "DEM": vesuvius["DEM"], "OUTPUT": draped})
    assert pixels(outputs["flux:OUTPUT"]) == pytest.approx(pixels(draped), nan_ok=True)
    for name in ("radiography_flux", "thickness_output", "flux_output"):
        assert (tmp_path / f"{name}.qml").is_file()


def test_an_exposure_plan_gives_what_its_steps_give(run, place, tmp_path):
    # A small piece of terrain, so that draping takes little.
    dem = str(tmp_path / "dem.tif")
    gdal.Translate(dem, place["DEM"], projWin=[14.405, 40.830, 14.430, 40.805])
    place = {**place, "DEM": dem, "PRESET": "lesparre2010", "DAYS": 10}
    outputs = files(
        tmp_path, "telescope:COUNTS.tif", "telescope:EXPOSURE.tif",
        "telescope:DENSITY_RESOLUTION.tif", "telescope:TABLE.csv", "exposure:OUTPUT.tif",
        "contrast:OUTPUT.tif",
    )  # fmt: skip
    results = run("exposureplan", {**place, **outputs})
    assert {name: results[name] for name in outputs} == outputs
    alone = {name: str(tmp_path / f"{name}_alone.tif") for name in ("COUNTS", "EXPOSURE")}
    run("expectedcounts", {**place, **alone})
    for name, path in alone.items():
        assert pixels(outputs[f"telescope:{name}"]) == pytest.approx(pixels(path), nan_ok=True)
    draped = str(tmp_path / "draped.tif")
    run("drape", {"MUOGRAM": alone["EXPOSURE"], "DEM": dem, "OUTPUT": draped})
    assert pixels(outputs["exposure:OUTPUT"]) == pytest.approx(pixels(draped), nan_ok=True)


def test_wrong_input_leaves_nothing(run, vesuvius, tmp_path):
    from qgis.core import QgsProcessingException

    wrong = {**vesuvius, "DETECTOR": "0,0 [EPSG:4326]"}
    with pytest.raises(QgsProcessingException):
        run("volcanosurvey", {**wrong, "radiography:FLUX": str(tmp_path / "flux.tif")})
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["volcanosurvey", "exposureplan"])
def test_a_model_is_complete_without_a_run(provider, name):
    model = provider.algorithm(name)
    assert model.validate() == (True, [])
    assert "From an elevation" in model.shortHelpString() or "Answers" in model.shortHelpString()
    # Their names stand in scripts, and are the steps' own.
    assert len(model.destinationParameterDefinitions()) == 7
    assert all(":" in one.name() for one in model.destinationParameterDefinitions())
    assert model.create().id() == f"muysc:{name}"


def test_the_files_are_what_the_script_makes(provider):
    # It loads the plugin itself; here it is loaded already.
    package = type(provider).__module__.split(".")[0]
    make_models = importlib.import_module("tools.make_models")
    models = importlib.import_module(f"{package}.processing_algorithms.models")
    assert {model.file.name for model in make_models.MODELS} == {path.name for path in models.FILES}
    from qgis.core import QgsProcessingModelAlgorithm

    def wiring(model):
        return {
            name: (
                step.algorithmId(),
                {
                    parameter: [one.friendlyIdentifier(model) for one in sources]
                    for parameter, sources in step.parameterSources().items()
                },
                sorted(step.modelOutputs()),
            )
            for name, step in model.childAlgorithms().items()
        }

    for model in make_models.MODELS:
        written, made = QgsProcessingModelAlgorithm(), make_models.build(model, provider)
        assert written.fromFile(str(model.file))
        # It would change the outputs' names, which stand in scripts.
        assert "internal_version" not in model.file.read_text(encoding="utf-8")
        assert wiring(made) == wiring(written), "out of date; run make models"
        assert made.helpContent() == written.helpContent(), "out of date; run make models"
