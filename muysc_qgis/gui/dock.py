"""The dock: settings, muogram, candidate sites, and the way to Processing."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from qgis.gui import QgisInterface, QgsDockWidget, QgsMapTool
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import (
    QApplication,
    QFrame,
    QHBoxLayout,
    QMenu,
    QScrollArea,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from . import commands
from .icons import icon
from .muogram_pane import MuogramPane
from .plan import Plan
from .planner import Planner
from .settings_form import SettingsForm
from .sites_pane import SitesPane
from .texts import tr
from .widgets import folded_box

#: Width (dots) that a button may shrink to.
_NARROWEST = 60

#: How long (s) a message stays.
_SECONDS = 5


class PlanningDock(QgsDockWidget):
    """Plans a telescope on the map."""

    def __init__(self, iface: QgisInterface, parent: QWidget | None = None) -> None:
        super().__init__(tr("Plan a muon telescope"), parent)
        self.setObjectName("MuyscPlanning")
        self._iface = iface
        self._canvas = iface.mapCanvas()
        self.planner = Planner(self._canvas, self)
        self.form = SettingsForm()
        self.muogram = MuogramPane(self.planner)
        self.sites = SitesPane(self.planner, self._canvas)
        self.places = folded_box(tr("Candidate sites"))
        inside = QVBoxLayout(self.places)
        inside.setContentsMargins(0, 0, 0, 0)
        inside.addWidget(self.sites)
        self.run = self._button("run", tr("Run…"), self.open_dialog)
        self.run.setToolTip(tr("Open the Processing dialog with these values"))
        self.copy = self._button("copy", tr("Copy as command"), self.copy_command)
        self.copy.setToolTip(tr("A qgis_process line that computes the same in a terminal"))
        self.setWidget(self._content())
        self._connect()
        self.planner.load()

    def release(self) -> None:
        """Leave nothing behind, on the map or in the background."""
        self._canvas.mapToolSet.disconnect(self._show_tool)
        self.muogram.release()
        self.sites.release()
        self.planner.close()

    # The way to Processing.

    def open_dialog(self, algorithm: str) -> None:
        """Open the dialog of an algorithm with the plan filled in."""
        commands.open_dialog(algorithm, self._parameters(algorithm, self.planner.plan.dem))

    def copy_command(self, algorithm: str) -> None:
        """Put the line that runs an algorithm in a terminal on the clipboard."""
        layer = self.planner.layer
        if layer is None:
            return
        line = commands.command_line(algorithm, self._parameters(algorithm, layer.source()))
        QApplication.clipboard().setText(line)
        told = tr("The command is on the clipboard; its files appear where it is run.")
        own = layer.dataProvider().crs()
        if layer.crs() != own:
            told = tr(
                "The command is on the clipboard; it reads the DEM in the system of its file, "
                "{own}, in place of {given}: assign that to the file first."
            ).format(own=own.authid() or own.description(), given=layer.crs().authid())
        self._iface.messageBar().pushMessage(self.windowTitle(), told, duration=_SECONDS)

    def _parameters(self, algorithm: str, dem: str) -> dict[str, Any]:
        plan = self.planner.plan
        if algorithm == commands.RADIOGRAPHY:
            return plan.radiography(dem)
        return plan.expected_counts(dem)

    # How it is put together.

    def _content(self) -> QWidget:
        actions = QHBoxLayout()
        # By the lengths of their texts, and narrower than these where there is no room.
        for button in (self.run, self.copy):
            button.setMinimumWidth(_NARROWEST)
            actions.addWidget(button, button.sizeHint().width())
        content = QWidget()
        layout = QVBoxLayout(content)
        layout.setContentsMargins(4, 4, 4, 4)
        layout.addWidget(self.form)
        layout.addWidget(self.muogram, 1)
        layout.addLayout(actions)
        layout.addWidget(self.places)
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setWidget(content)
        return area

    def _button(self, name: str, text: str, do: Callable[[str], None]) -> QToolButton:
        """Return a button that asks for one of the two algorithms."""
        menu = QMenu(self)
        for algorithm, title in (
            (commands.RADIOGRAPHY, tr("Muon radiography")),
            (commands.EXPECTED_COUNTS, tr("Expected counts in a telescope")),
        ):
            menu.addAction(title, partial(do, algorithm))
        button = QToolButton()
        button.setText(text)
        button.setIcon(icon(name))
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        button.setMenu(menu)
        return button

    def _connect(self) -> None:
        self.form.edited.connect(self.planner.edit)
        self.planner.plan_changed.connect(self._show_plan)
        for role, button in self._pick_buttons().items():
            button.clicked.connect(self._picker(role))
        self._canvas.mapToolSet.connect(self._show_tool)
        self.openedStateChanged.connect(self.planner.set_shown)

    def _pick_buttons(self) -> dict[str, QToolButton]:
        return {"detector": self.form.pick_detector, "target": self.form.pick_target}

    def _picker(self, role: str) -> Callable[[bool], None]:
        tool = self.planner.tools[role]

        def pick(checked: bool) -> None:
            if checked:
                self._canvas.setMapTool(tool)
            else:
                self._canvas.unsetMapTool(tool)

        return pick

    def _show_tool(self, tool: QgsMapTool | None, *_: Any) -> None:
        for role, button in self._pick_buttons().items():
            button.setChecked(tool is self.planner.tools[role])

    def _show_plan(self, plan: Plan) -> None:
        self.form.show_plan(plan)
        self.copy.setEnabled(bool(plan.dem and plan.detector and plan.target))
