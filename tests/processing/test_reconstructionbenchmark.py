"""Comparing reconstruction methods as an algorithm: parameters, files, numbers, refusals."""

import csv
import sys
from pathlib import Path

import pytest

FILES = {"TABLE": "methods.csv", "PANEL": "panel.png", "REPORT": "report.html"}
SMALL = {"SIZE": 32, "ANGLES": 40}


@pytest.fixture
def algorithm(provider):
    return provider.algorithm("reconstructionbenchmark")


@pytest.fixture
def files(tmp_path):
    return {name: str(tmp_path / file) for name, file in FILES.items()}


def table(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_parameters_have_defaults(algorithm):
    own = {"ITERATIONS", "RELAXATION", "REGULARIZATION"}
    for definition in algorithm.parameterDefinitions():
        if not definition.isDestination():
            assert (definition.defaultValue() is None) == (definition.name() in own)
    methods = algorithm.parameterDefinition("METHODS")
    assert methods.options() == methods.defaultValue()
    assert len(methods.options()) == 17
    assert {"art", "bayes", "fbp", "gridrec"} <= set(methods.options())
    assert {one.name() for one in algorithm.destinationParameterDefinitions()} == set(FILES)
    numbers = {one.name() for one in algorithm.outputDefinitions()} - set(FILES)
    assert numbers == {
        "BEST_METHOD", "BEST_ERROR", "BEST_SECONDS", "GREY_ERROR", "MATRIX_SECONDS",
    }  # fmt: skip


def test_it_introduces_itself(algorithm):
    assert algorithm.id() == "muysc:reconstructionbenchmark"
    assert algorithm.displayName() == "Compare reconstruction methods"
    assert algorithm.group() == "Tomography"
    assert "Shepp–Logan" in algorithm.shortHelpString()


def test_every_method_stands_in_table_panel_and_report(run, recorder, files):
    feedback = recorder()
    results = run("reconstructionbenchmark", {**SMALL, **files}, feedback)
    for name, path in files.items():
        assert results[name] == path
    rows = {row["method"]: row for row in table(files["TABLE"])}
    assert len(rows) == 17
    best = min(rows.values(), key=lambda row: float(row["relative_error"]))
    assert results["BEST_METHOD"] == best["method"]
    assert results["BEST_ERROR"] == pytest.approx(float(best["relative_error"]), rel=1e-6)
    assert results["BEST_ERROR"] < 0.5 * results["GREY_ERROR"]
    assert results["MATRIX_SECONDS"] > 0
    assert rows["fbp"]["data_misfit"] == ""
    assert Path(files["PANEL"]).read_bytes().startswith(b"\x89PNG")
    report = Path(files["REPORT"]).read_text(encoding="utf-8")
    assert "Penalised likelihood by subsets, hybrid: relative error" in report
    assert sum(text.endswith(" s") for text in feedback.infos) == 17


def test_the_table_loads_with_numbers(run, files):
    from qgis.core import QgsVectorLayer

    run("reconstructionbenchmark", {**SMALL, "METHODS": ["fbp"], "TABLE": files["TABLE"]})
    layer = QgsVectorLayer(files["TABLE"], "methods", "ogr")
    assert layer.isValid()
    kinds = {field.name(): field.isNumeric() for field in layer.fields()}
    assert {name for name, numeric in kinds.items() if not numeric} == {"method", "title"}
    (feature,) = layer.getFeatures()
    assert 0 < feature["relative_error"] < 1


def test_iterations_noise_and_seed_count(run):
    def errors(**change):
        parameters = {**SMALL, "METHODS": "sirt,fbp", "TABLE": "TEMPORARY_OUTPUT", **change}
        path = run("reconstructionbenchmark", parameters)["TABLE"]
        assert path.endswith(".csv")
        return [(row["iterations"], row["relative_error"]) for row in table(path)]

    plain, few = errors(), errors(ITERATIONS=3)
    assert [row[0] for row in few] == ["3", "1"]
    assert float(few[0][1]) > float(plain[0][1])
    noisy = errors(NOISE=3)
    assert float(noisy[1][1]) > float(plain[1][1])
    assert noisy == errors(NOISE=3)
    assert noisy != errors(NOISE=3, SEED=2)


def test_a_method_that_sees_nothing_is_warned_of(run, recorder):
    feedback = recorder()
    # So strong a penalty leaves one grey level.
    strong = {"METHODS": "pml-quad,fbp", "ITERATIONS": 1, "REGULARIZATION": 1e9}
    run("reconstructionbenchmark", {**SMALL, **strong}, feedback)
    assert [text for text in feedback.warnings if "than one grey level: pml-quad;" in text]


@pytest.mark.parametrize(("library", "output"), [("matplotlib", "PANEL"), ("jinja2", "REPORT")])
def test_without_a_library_for_drawing_the_table_is_written(
    run, recorder, files, tmp_path, monkeypatch, library, output
):
    for name in [name for name in sys.modules if name.split(".")[0] == library]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, library, None)
    feedback = recorder()
    wanted = {name: files[name] for name in ("TABLE", output)}
    run("reconstructionbenchmark", {**SMALL, "METHODS": "fbp", **wanted}, feedback)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["methods.csv", "methods.csvt"]
    assert [text for text in feedback.warnings if f"Python library {library}" in text]


def test_stopping_leaves_no_file(run, recorder, files, tmp_path):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match="Cancelled"):
        run("reconstructionbenchmark", {**SMALL, **files}, recorder(cancel_at=20))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"SIZE": 8}, "edge in pixels is 8; give one from 16 to 1024"),
        ({"SIZE": 2000}, "from 16 to 1024"),
        ({"SIZE": 30.5}, "SIZE is 30.5, which is not a whole number"),
        ({"SIZE": 1024, "ANGLES": 2000}, "19.9 GiB, more than the limit of 4 GiB; use at most 459"),
        ({"ANGLES": 1}, "number of projections is 1; give one from 2 to 2000"),
        ({"METHODS": []}, "no method to compare"),
        ({"METHODS": "fdk"}, "METHODS names “fdk”"),
        ({"NOISE": -1}, "noise in percent is -1; give one from 0 to 100"),
        ({"NOISE": "loud"}, "NOISE is “loud”"),
        ({"ITERATIONS": 0}, "number of iterations is 0; give at least 1"),
        ({"RELAXATION": 2}, "relaxation is 2"),
        ({"REGULARIZATION": -1}, "regularisation is -1"),
        ({"SEED": -1}, "SEED"),
        ({"TABLE": "table.txt"}, "txt"),
    ],
)
def test_bad_input_is_refused_in_one_sentence_and_leaves_no_file(
    run, files, tmp_path, change, words
):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match=words):
        run("reconstructionbenchmark", {**SMALL, **files, **change})
    assert list(tmp_path.iterdir()) == []
