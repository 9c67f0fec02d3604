"""Error figures against values worked out by hand."""

import numpy as np
import pytest

from muysc_qgis.errors import MuyscError
from muysc_qgis.tomography.figures_of_merit import contrast_recovered, relative_error, view_error
from muysc_qgis.tomography.voxels import VoxelGrid

GRID = VoxelGrid((0, 0, 0), (1, 1, 10), (2, 1, 2))
TRUTH = np.array([[[2.0, 2.0]], [[1.0, np.nan]]])


def test_the_relative_error_is_that_of_known_values():
    model = np.array([[[2.0, 2.3]], [[1.0, 99.0]]])
    assert relative_error(model, TRUTH) == pytest.approx(0.3 / 3)


def test_the_error_of_a_view():
    """Top views 40 and 10 against 43 and 10; over their largest, 1 and 0.25 against 1 and 10/43."""
    model = np.array([[[2.0, 2.3]], [[1.0, np.nan]]])
    plain = view_error(GRID, model, TRUTH, "top", normalised=False)
    assert plain.difference == pytest.approx(np.array([[3.0], [0.0]]))
    assert (plain.mean, plain.deviation) == (pytest.approx(1.5), pytest.approx(1.5))
    over = view_error(GRID, model, TRUTH, "top")
    assert over.mean == pytest.approx((0.25 - 10 / 43) / 2)


def test_a_scaled_model_has_no_error_of_shape():
    assert view_error(GRID, 0.5 * TRUTH, TRUTH, "front").mean == pytest.approx(0, abs=1e-12)


def test_the_contrast_recovered():
    truth = np.array([2.0, 2.0, 1.0, np.nan])
    inside = np.array([False, False, True, True])
    assert contrast_recovered(truth, truth, inside) == pytest.approx(1)
    assert contrast_recovered(np.array([2.0, 2, 1.6, 5]), truth, inside) == pytest.approx(0.4)
    assert contrast_recovered(np.full(4, 1.8), truth, inside) == pytest.approx(0)


@pytest.mark.parametrize(
    ("compute", "message"),
    [
        (lambda: relative_error(np.ones(2), np.ones(3)), "models of one grid"),
        (lambda: relative_error(np.ones(2), np.zeros(2)), "0 everywhere"),
        (lambda: relative_error(np.full(2, np.nan), np.ones(2)), "share no known value"),
        (lambda: contrast_recovered(np.ones(2), np.ones(2), np.zeros(2, bool)), "covers 0 of 2"),
        (lambda: contrast_recovered(np.ones(2), np.ones(2), np.array([True, False])),
         "no contrast"),
    ],
)  # fmt: skip
def test_meaningless_comparisons_are_refused(compute, message):
    with pytest.raises(MuyscError, match=message):
        compute()
