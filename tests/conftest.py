"""Shared fixtures: the library on the path and the real terrain."""

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))


@pytest.fixture(scope="session")
def data_folder():
    return ROOT / "tests" / "data"
