"""Parameters over their whole range and beyond, from what the algorithms declare."""

from pathlib import Path

import pytest
from hypothesis import strategies as st

from tools.fuzzing.strategies import parameters

ALGORITHMS = Path(__file__).parents[2] / "processing_algorithms"
NAMES = sorted(
    path.stem for path in [*ALGORITHMS.glob("help/*.html"), *ALGORITHMS.glob("models/*.model3")]
)


def test_every_algorithm_is_tried(fuzz_client):
    assert sorted(fuzz_client.catalogue) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_results_or_one_sentence(name, fuzz_client, scene, explore, attempt):
    cases = st.tuples(parameters(name, fuzz_client.catalogue[name], scene), st.booleans())
    explore(cases, lambda case: attempt(name, *case))
