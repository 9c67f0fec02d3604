"""The dock: from a click on the map to its muogram on the screen."""

from __future__ import annotations

import importlib
import importlib.util
import os
import sys
import tempfile
import time
from dataclasses import replace
from types import ModuleType
from typing import Any

from measure import DEM, DETECTOR, ROOT, TARGET, Row, print_table, seconds_of

#: Steps (degrees) by which the detector is moved, so that nothing is known before.
_STEP_DEG = 1e-5


def desktop_modules() -> tuple[ModuleType, ...]:
    """Load the plugin as QGIS does, under a name of its own; return what is measured."""
    spec = importlib.util.spec_from_file_location(
        "plugin", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    sys.modules["plugin"] = importlib.util.module_from_spec(spec)
    names = ("plan", "planner", "muogram_view", "muogram_layout")
    return tuple(importlib.import_module(f"plugin.muysc_qgis.gui.{name}") for name in names)


class Clicks:
    """A plan whose detector moves on with every click."""

    def __init__(self, planner: Any, plan: Any, application: Any) -> None:
        self.planner, self.plan, self.application = planner, plan, application
        self.blocked = 0.0

    def click(self, coarse: bool = False) -> None:
        """Move the detector and wait for the muogram."""
        place = self.plan.detector
        self.plan = replace(self.plan, detector=replace(place, x=place.x + _STEP_DEG))
        start = time.perf_counter()
        self.planner.change(self.plan, coarse)
        self.blocked = time.perf_counter() - start
        while self.planner.busy:
            self.application.processEvents()

    def map_is_blocked(self) -> float:
        """Return how long the click kept the map from answering."""
        self.click()
        return self.blocked


def main() -> None:
    from qgis.core import QgsApplication, QgsProject, QgsRasterLayer
    from qgis.gui import QgsMapCanvas

    application = QgsApplication([], True, tempfile.mkdtemp())
    application.initQgis()
    plans, planners, views, layouts = desktop_modules()
    layer = QgsRasterLayer(str(DEM), "Vesuvius")
    QgsProject.instance().addMapLayer(layer)
    canvas = QgsMapCanvas()
    planner = planners.Planner(canvas)
    planner.set_shown(True)
    plan = plans.Plan(
        dem=layer.id(),
        detector=plans.Place(*DETECTOR, "EPSG:4326"),
        target=plans.Place(*TARGET, "EPSG:4326"),
    )
    clicks = Clicks(planner, plan, application)
    clicks.click()
    view = views.MuogramView()
    view.resize(380, 360)

    def paint() -> None:
        preview = planner.preview
        view.show_scene(layouts.Scene.of(preview.muogram("flux"), preview.muogram("opacity")))
        view.grab()

    rows = [
        Row("from click to muogram, 100 × 100 pixels", seconds_of(clicks.click, 15)),
        Row("while dragging, 40 × 40 pixels", seconds_of(lambda: clicks.click(coarse=True), 15)),
        Row("of that the map is kept waiting", clicks.map_is_blocked()),
        Row("painting the muogram", seconds_of(paint, 15)),
        Row("section under the mouse", seconds_of(lambda: planner.section(60, 50), 15)),
    ]
    print_table("Live muogram of Vesuvius", rows)
    planner.close()


if __name__ == "__main__":
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    main()
