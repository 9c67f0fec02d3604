"""Comparing spectra from a shell."""

import re

import pytest


def test_a_run_writes_tables_panel_and_numbers(qgis_process, tmp_path):
    folder = tmp_path / "espectros ñ"
    outputs = {
        "TABLE": folder / "espectros μ.csv",
        "FLUX_TABLE": folder / "flujos.csv",
        "PANEL": folder / "panel.png",
        "REPORT": folder / "informe.html",
    }
    done = qgis_process.run(
        "fluxspectrum",
        {"ZENITH_ANGLES": "0, 80", "FLUX_MODELS": "guan", "THICKNESS": 1000, **outputs},
    )
    assert done.returncode == 0, done.stdout + done.stderr
    for path in outputs.values():
        assert path.stat().st_size > 500, path
    numbers = dict(re.findall(r"^(\w+):\s+([-\d.e+]+)$", done.stdout, re.MULTILINE))
    # 1 km of standard rock, from the range tables.
    assert float(numbers["MINIMUM_ENERGY"]) == pytest.approx(1138, rel=5e-3)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"ZENITH_ANGLES": "95"}, "zenith angle of 95°"),
        ({"FLUX_MODELS": "hebbeker"}, "hebbeker"),
        ({"THICKNESS": "0"}, "thickness of 0 m"),
    ],
)
def test_bad_input_is_one_sentence(qgis_process, tmp_path, change, words):
    done = qgis_process.run("fluxspectrum", {"TABLE": tmp_path / "t.csv", **change})
    assert done.returncode != 0
    assert words in done.stdout + done.stderr
    assert "Traceback" not in done.stderr
    assert not list(tmp_path.iterdir())
