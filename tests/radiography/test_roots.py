"""Many roots at once, against roots known in closed form."""

import numpy as np
import pytest

from muysc_qgis.radiography.roots import TOLERANCE, falling_roots


@pytest.mark.parametrize("halvings", [1, 3, 8])
def test_roots_of_different_functions_are_found_together(halvings):
    # 2 − x, ln(5/x) and 1 − x³ fall from above 0 to below it between 0.1 and 10.
    known = np.array([2.0, 5.0, 1.0])

    def excess(x):
        return np.array([2.0 - x[0], np.log(5.0 / x[1]), 1.0 - x[2] ** 3])

    low, high = np.full(3, 0.1), np.full(3, 10.0)
    found = falling_roots(
        excess, low, high, excess(low), excess(high), np.ones(3, dtype=bool), halvings
    )
    assert np.abs(excess(found)).max() <= TOLERANCE
    np.testing.assert_allclose(found, known, rtol=1e-6)


def test_it_does_not_wait_for_roots_that_are_not_there():
    asked = []

    def excess(x):
        asked.append(1)
        return np.array([1.0, 0.5 - x[1]])  # the first never reaches 0

    low, high = np.zeros(2), np.ones(2)
    found = falling_roots(
        excess, low, high, excess(low), excess(high), np.array([False, True]), halvings=1
    )
    assert found[1] == pytest.approx(0.5)
    assert len(asked) == 3
