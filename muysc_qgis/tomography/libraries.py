"""The parts of scipy that tomography needs, loaded on first use."""

from __future__ import annotations

import importlib
from typing import Any

from ..errors import MuyscError


def scipy_part(name: str) -> Any:
    """Return a module of scipy, as ``scipy_part("sparse")``.

    Raises
    ------
    MuyscError
        If scipy is not installed.
    """
    try:
        return importlib.import_module(f"scipy.{name}")
    except ImportError as error:
        raise MuyscError(
            "Tomography needs the Python package scipy, which is not installed; install it "
            "(python3-scipy on Debian, scipy in the OSGeo4W setup) and start QGIS again."
        ) from error
