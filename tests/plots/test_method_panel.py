"""The picture and the report of compared methods."""

import numpy as np
import pytest

from muysc_qgis.plots.provenance import Provenance
from muysc_qgis.plots.style import png_bytes
from muysc_qgis.plots.tomography.method_documents import report
from muysc_qgis.plots.tomography.method_panel import LOOKS, method_panel
from muysc_qgis.tomography.method_comparison import COMPARABLE, compare_methods


@pytest.fixture(scope="module")
def comparison():
    return compare_methods(24, 20, noise_percent=2.0)


def test_every_method_has_a_look_of_its_own():
    assert set(LOOKS) == set(COMPARABLE)
    assert len(set(LOOKS.values())) == len(COMPARABLE)


def test_the_panel_holds_head_and_reconstructions_upright(comparison):
    figure = method_panel(comparison)
    pictures = [one for one in figure.axes[0].images if one.get_gid() == "reconstruction"]
    assert len(pictures) == 1 + len(COMPARABLE)
    head = np.asarray(pictures[0].get_array())[..., 0].astype(float)
    # The rows run from the top, where y is largest; grey 0.5 and more is white.
    expected = np.minimum(comparison.truth.T[::-1] / 0.5, 1.0) * 255
    assert np.abs(head - expected).max() < 2
    texts = [text.get_text() for text in figure.axes[0].texts]
    for one in comparison.results:
        assert one.method in texts
        assert any(text.startswith(f"ε {one.relative_error:.3g}  ·") for text in texts)
    assert "noise of 2 % of the largest projection" in "".join(
        text.get_text() for text in figure.texts
    )


def test_marks_stand_at_error_and_time_and_curves_at_the_misfits(comparison):
    _, errors, misfits = method_panel(comparison).axes
    marks = {tuple(map(float, line.get_xydata()[0])) for line in errors.lines}
    for one in comparison.results:
        assert (one.seconds, one.relative_error) in marks
    sirt = next(one for one in comparison.results if one.method == "sirt")
    curves = [line.get_ydata() for line in misfits.lines if len(line.get_xdata()) == 50]
    assert any(np.array_equal(curve, sirt.misfit[1:]) for curve in curves)


@pytest.mark.parametrize("methods", [["fbp"], ["fbp", "gridrec"], ["lsmr"]])
def test_few_methods_make_a_panel_too(methods):
    figure = method_panel(compare_methods(16, 8, methods))
    assert png_bytes(figure, 40).startswith(b"\x89PNG")


def test_the_report_tells_errors_and_times(comparison):
    told = report(comparison, Provenance())
    values = {row.label: row.value for row in told.results}
    assert values["Smallest relative error"] == round(comparison.best.relative_error, 4)
    assert values["SIRT: relative error"] == round(
        next(one.relative_error for one in comparison.results if one.method == "sirt"), 4
    )
    assert told.figures[0].is_panel
