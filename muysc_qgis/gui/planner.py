"""The plan in hand: kept in step with map, muogram and project."""

from __future__ import annotations

from dataclasses import replace

from qgis.core import QgsPointXY, QgsProject, QgsRasterLayer
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ..errors import MuyscError
from .background import Background
from .map_items import MapItems
from .map_tools import PlaceTool
from .plan import Place, Plan
from .preview import Preview, request_for
from .sections import RaySection, section_of
from .texts import tr

#: Where the project file keeps the plan.
SCOPE, ENTRY = "muysc", "/plan"


class Planner(QObject):
    """Holds the plan, computes its muogram and draws it on the map."""

    plan_changed = pyqtSignal(object)
    previewed = pyqtSignal(object)
    #: There is no muogram, and why.
    emptied = pyqtSignal(str)

    def __init__(self, canvas: QgsMapCanvas, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.plan = Plan()
        self.preview: Preview | None = None
        self._canvas = canvas
        self._shown = False
        self.items = MapItems(canvas)
        self.tools = {role: PlaceTool(canvas, role, self.items) for role in ("detector", "target")}
        for tool in self.tools.values():
            tool.moved.connect(self._move)
        self._background = Background(self)
        self._background.computed.connect(self._take)
        self._background.failed.connect(self._empty)
        project = QgsProject.instance()
        project.readProject.connect(self.load)
        project.cleared.connect(self._forget)
        project.writeProject.connect(self._store)
        canvas.destinationCrsChanged.connect(self._redraw)

    @property
    def layer(self) -> QgsRasterLayer | None:
        """The elevation model of the plan, None without one."""
        return QgsProject.instance().mapLayer(self.plan.dem) if self.plan.dem else None

    @property
    def can_compare(self) -> bool:
        """Whether candidate sites have a terrain and a target."""
        return self._shown and self.layer is not None and self.plan.target is not None

    @property
    def busy(self) -> bool:
        """Whether a muogram is being computed."""
        return self._background.busy

    def change(self, plan: Plan, coarse: bool = False) -> None:
        """Take another plan and compute its muogram, a rough one while something moves."""
        if plan != self.plan:
            QgsProject.instance().setDirty(True)
            self.plan = plan
            self.plan_changed.emit(plan)
        self._refresh(coarse)

    def edit(self, settings: Plan) -> None:
        """Take everything of a plan but the two points."""
        plan = self.plan
        self.change(replace(settings, detector=plan.detector, target=plan.target))

    def put(self, role: str, place: Place, coarse: bool = False) -> None:
        """Put the detector or the target somewhere."""
        self.change(self.plan.with_place(role, place), coarse)

    def set_shown(self, shown: bool) -> None:
        """Draw and compute, or stop doing so."""
        self._shown = shown
        if shown:
            self._suggest_terrain()
            self._refresh()
            return
        self._background.cancel()
        self._unset_tools()
        self._hide()

    def section(self, row: int, column: int) -> RaySection | None:
        """Return the section along the ray of a pixel, and draw the ray on the map."""
        if self.preview is None:
            return None
        try:
            section = section_of(self.preview, row, column)
        except MuyscError:
            self.items.hide_ray()
            return None
        self.items.show_ray(section)
        return section

    def load(self, *_: object) -> None:
        """Take the plan that the project keeps."""
        text, _found = QgsProject.instance().readEntry(SCOPE, ENTRY)
        self.plan = Plan.from_json(text)
        self.plan_changed.emit(self.plan)
        self._refresh()

    def close(self) -> None:
        """Leave nothing behind on the map, in the project or in the background."""
        project = QgsProject.instance()
        project.readProject.disconnect(self.load)
        project.cleared.disconnect(self._forget)
        project.writeProject.disconnect(self._store)
        self._canvas.destinationCrsChanged.disconnect(self._redraw)
        self._unset_tools()
        for tool in self.tools.values():
            tool.release()
        self._background.close()
        self.items.remove()

    def _store(self, *_: object) -> None:
        if self.plan != Plan():
            QgsProject.instance().writeEntry(SCOPE, ENTRY, self.plan.to_json())

    def _forget(self) -> None:
        self._unset_tools()
        self.plan = Plan()
        self.plan_changed.emit(self.plan)
        self._refresh()

    def _move(self, role: str, point: QgsPointXY, dragging: bool) -> None:
        crs = self._canvas.mapSettings().destinationCrs()
        if not crs.isValid() and self.layer is not None:
            # A map without a system shows layers in their own.
            crs = self.layer.crs()
        self.put(role, Place.of(point, crs), coarse=dragging)
        if role == "detector" and not dragging and self.plan.target is None:
            self._canvas.setMapTool(self.tools["target"])

    def _suggest_terrain(self) -> None:
        """Take the only raster file of the project, where none is chosen."""
        layers = QgsProject.instance().mapLayers().values()
        rasters = [one for one in layers if isinstance(one, QgsRasterLayer)]
        if self.layer is None and len({one.source() for one in rasters}) == 1:
            self.plan = replace(self.plan, dem=rasters[0].id())
            self.plan_changed.emit(self.plan)

    def _unset_tools(self) -> None:
        for tool in self.tools.values():
            self._canvas.unsetMapTool(tool)

    def _redraw(self) -> None:
        """Draw again what stands on the map, in its new system."""
        self.items.hide_ray()
        if self._shown:
            self._show_places()
            if self.preview is not None:
                self.items.show_view(self.preview)

    def _refresh(self, coarse: bool = False) -> None:
        if not self._shown:
            return
        self._show_places()
        lacking = self._lacking()
        if lacking:
            self._background.cancel()
            self._empty(lacking)
            return
        plan = self.plan
        self._background.submit(lambda: request_for(plan, coarse).compute, coarse)

    def _lacking(self) -> str:
        """Return what the user has to do next, empty where nothing is lacking."""
        if self.layer is None:
            return tr("Choose an elevation model (DEM); add one to the project if there is none.")
        if self.plan.detector is None:
            return tr("Pick the detector: press the button and click where the telescope stands.")
        if self.plan.target is None:
            return tr("Pick the target: press the button and click what the telescope points at.")
        return ""

    def _show_places(self) -> None:
        self.items.show_place("detector", self.plan.detector)
        self.items.show_place("target", self.plan.target)

    def _take(self, preview: Preview) -> None:
        self.preview = preview
        self.items.show_view(preview)
        self.items.hide_ray()
        self.previewed.emit(preview)

    def _empty(self, reason: str) -> None:
        self.preview = None
        self.items.hide_view()
        self.emptied.emit(reason)

    def _hide(self) -> None:
        self.items.hide_view()
        self.items.show_place("detector", None)
        self.items.show_place("target", None)
