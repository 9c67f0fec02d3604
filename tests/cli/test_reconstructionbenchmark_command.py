"""Reconstruction methods compared from a shell."""

import re


def test_methods_are_compared(qgis_process, tmp_path):
    folder = tmp_path / "métodos ñ"
    outputs = {
        "TABLE": folder / "métodos.csv",
        "PANEL": folder / "panel.png",
        "REPORT": folder / "informe.html",
    }
    done = qgis_process.run(
        "reconstructionbenchmark",
        {"SIZE": 32, "ANGLES": 30, "METHODS": "sirt,fbp,tv", "NOISE": 1, **outputs},
    )
    assert done.returncode == 0, done.stdout + done.stderr
    for path in outputs.values():
        assert path.stat().st_size > 100, path
    found = dict(re.findall(r"^(\w+):\s+(\S+)$", done.stdout, re.MULTILINE))
    assert found["BEST_METHOD"] in ("sirt", "fbp", "tv")
    assert 0 < float(found["BEST_ERROR"]) < float(found["GREY_ERROR"])


def test_a_method_that_does_not_exist_is_one_sentence(qgis_process, tmp_path):
    done = qgis_process.run(
        "reconstructionbenchmark", {"METHODS": "fdk", "TABLE": tmp_path / "t.csv"}
    )
    assert done.returncode != 0
    assert "METHODS names “fdk”" in done.stdout + done.stderr
    assert "Traceback" not in done.stderr
    assert not list(tmp_path.iterdir())
