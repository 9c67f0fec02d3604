"""What the plugin adds to the window of QGIS."""

from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsProject
from qgis.gui import QgisInterface
from qgis.PyQt.QtCore import Qt

from . import sites
from .compat import QAction
from .icons import icon
from .texts import tr

if TYPE_CHECKING:
    from .dock import PlanningDock

_MENU = "MUYSC"

#: Name of the dock of Processing.
_TOOLBOX = "ProcessingToolbox"


class Desktop:
    """The toolbar button, the menu entry and the dock that they open."""

    def __init__(self, iface: QgisInterface) -> None:
        self._iface = iface
        self.dock: PlanningDock | None = None
        self.action = QAction(icon("dock"), tr("Plan a muon telescope"), iface.mainWindow())
        self.action.setObjectName("MuyscPlan")
        self.action.setCheckable(True)
        self.action.toggled.connect(self.show_dock)
        iface.addToolBarIcon(self.action)
        iface.addPluginToMenu(_MENU, self.action)
        # The layer of sites is filled and kept whether the dock is open or not.
        project = QgsProject.instance()
        project.readProject.connect(self._restore)
        project.writeProject.connect(self._store)
        sites.restore_sites()

    def show_dock(self, shown: bool) -> None:
        """Open or close the dock, which is made when it is first needed."""
        if self.dock is None:
            if not shown:
                return
            # Loading it takes a while, which no start of QGIS has to wait for.
            from .dock import PlanningDock

            self.dock = PlanningDock(self._iface, self._iface.mainWindow())
            self.dock.openedStateChanged.connect(self.action.setChecked)
            # Behind the toolbox the dock has the whole height of the window.
            area = Qt.DockWidgetArea.RightDockWidgetArea
            self._iface.addTabifiedDockWidget(area, self.dock, [_TOOLBOX], True)
        self.dock.setUserVisible(shown)

    def remove(self) -> None:
        """Take everything out of the window again."""
        project = QgsProject.instance()
        project.readProject.disconnect(self._restore)
        project.writeProject.disconnect(self._store)
        self._iface.removePluginMenu(_MENU, self.action)
        self._iface.removeToolBarIcon(self.action)
        if self.dock is not None:
            self.dock.release()
            self._iface.removeDockWidget(self.dock)
            self.dock.deleteLater()
            self.dock = None
        self.action.deleteLater()

    def _restore(self, *_: object) -> None:
        sites.restore_sites()

    def _store(self, *_: object) -> None:
        sites.store_sites()
