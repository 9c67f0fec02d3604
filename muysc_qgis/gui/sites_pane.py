"""Candidate sites side by side."""

from __future__ import annotations

from collections.abc import Callable

from qgis.core import QgsProject, QgsVectorLayer
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QShowEvent
from qgis.PyQt.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ..errors import MuyscError
from ..workflows.planning import SiteFigures
from . import sites
from .comparison import Comparison, plan_at
from .planner import Planner
from .sites import Site
from .texts import bare_metres, metres, rounded, tr
from .widgets import icon_button, wrapping_label

#: Denominator of the scale in which a site that is zoomed to is seen at least.
_SITE_SCALE = 25_000

#: Columns beside the name.
_FIGURES = 3

#: Rows that the table shows at least.
_ROWS = 4


class SitesPane(QWidget):
    """Lists candidate sites with what they are compared by."""

    def __init__(
        self, planner: Planner, canvas: QgsMapCanvas, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._planner, self._canvas = planner, canvas
        #: The sites in the order of the rows.
        self.listed: list[Site] = []
        self.comparison = Comparison(self)
        self.comparison.answered.connect(self._show_figures)
        self.table = _table()
        self.table.itemChanged.connect(self._rename)
        self.table.itemDoubleClicked.connect(lambda item: self.use_chosen())
        self.table.itemSelectionChanged.connect(self._enable)
        self.add = icon_button("site_add", tr("Add the detector as a site"), self.add_detector)
        self.use = icon_button("detector", tr("Use the site as detector"), self.use_chosen)
        self.zoom = icon_button("zoom", tr("Zoom to the site"), self.zoom_to_chosen)
        self.remove = icon_button("site_remove", tr("Remove the sites chosen"), self.remove_chosen)
        self.told = wrapping_label()
        buttons = QHBoxLayout()
        for button in (self.add, self.use, self.zoom, self.remove):
            buttons.addWidget(button)
        buttons.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(buttons)
        layout.addWidget(self.table)
        layout.addWidget(self.told)
        planner.previewed.connect(self._compare)
        planner.emptied.connect(self._compare)
        project = QgsProject.instance()
        project.layersAdded.connect(self.reload)
        project.layersRemoved.connect(self.reload)
        project.readProject.connect(self.reload)
        self._watched: str | None = None
        self.reload()

    def release(self) -> None:
        """Stop for good."""
        project = QgsProject.instance()
        project.layersAdded.disconnect(self.reload)
        project.layersRemoved.disconnect(self.reload)
        project.readProject.disconnect(self.reload)
        self._watch(None)
        self.comparison.close()

    # What the buttons do.

    def add_detector(self) -> None:
        """Add the detector's place to the sites."""
        place, height = self._planner.plan.detector, self._planner.plan.detector_height_m
        if place is None:
            return
        layer = sites.find_layer() or sites.make_layer(self._canvas.mapSettings().destinationCrs())
        taken = {site.name for site in self.listed}
        number = next(n for n in range(1, len(taken) + 2) if sites.numbered(n) not in taken)
        self._change(lambda: sites.add_site(layer, sites.numbered(number), place, height))

    def use_chosen(self) -> None:
        """Put the detector at the site chosen."""
        for site in self._chosen()[:1]:
            self._planner.change(plan_at(self._planner.plan, site))

    def zoom_to_chosen(self) -> None:
        """Show the site chosen in the middle of the map."""
        for site in self._chosen()[:1]:
            try:
                middle = site.place.point_in(self._canvas.mapSettings().destinationCrs())
            except MuyscError as error:
                self.told.setText(str(error))
                return
            self._canvas.setCenter(middle)
            self._canvas.zoomScale(min(self._canvas.scale(), _SITE_SCALE))

    def remove_chosen(self) -> None:
        """Remove the sites chosen from their layer."""
        layer, chosen = sites.find_layer(), [site.identifier for site in self._chosen()]
        if layer is not None and chosen:
            self._change(lambda: sites.remove_sites(layer, chosen))

    def reload(self, *_: object) -> None:
        """Show the sites that the layer holds now."""
        layer = sites.find_layer()
        self._watch(layer)
        self.listed = [] if layer is None else sites.sites_of(layer)
        self._show_sites()
        self._compare()

    # What happens elsewhere.

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._compare()

    def _watch(self, layer: QgsVectorLayer | None) -> None:
        """Follow what the user does to the layer by other means."""
        if layer is None or layer.id() != self._watched:
            previous = QgsProject.instance().mapLayer(self._watched or "")
            if previous is not None:
                previous.afterCommitChanges.disconnect(self.reload)
            self._watched = None if layer is None else layer.id()
            if layer is not None:
                layer.afterCommitChanges.connect(self.reload)

    def _change(self, change: Callable[[], None]) -> None:
        try:
            change()
        except MuyscError as error:
            self.told.setText(str(error))
            return
        QgsProject.instance().setDirty(True)
        self.reload()

    def _rename(self, item: QTableWidgetItem) -> None:
        layer, name = sites.find_layer(), item.text().strip()
        site = self.listed[item.row()]
        if item.column() == 0 and layer is not None and name and name != site.name:
            self._change(lambda: sites.rename_site(layer, site.identifier, name))

    def _chosen(self) -> list[Site]:
        rows = sorted({index.row() for index in self.table.selectionModel().selectedRows()})
        return [self.listed[row] for row in rows]

    def _compare(self, *_: object) -> None:
        preview = self._planner.preview
        if preview is None or not preview.coarse:
            self._show_figures()
            # Nobody needs figures that are folded away.
            if self._planner.can_compare and self.isVisible():
                self.comparison.compare(self._planner.plan, self.listed)
            else:
                self.comparison.stop()

    def _show_sites(self) -> None:
        self.table.blockSignals(True)
        self.table.setRowCount(len(self.listed))
        for row, site in enumerate(self.listed):
            for column in range(1 + _FIGURES):
                self.table.setItem(row, column, _item("", editable=column == 0))
            self.table.item(row, 0).setText(site.name)
        self.table.blockSignals(False)
        self._enable()

    def _show_figures(self) -> None:
        plan = self._planner.plan
        self.table.blockSignals(True)
        for row, site in enumerate(self.listed):
            figures = self.comparison.figures(plan, site)
            problem = self.comparison.problem(plan, site)
            for column, text in enumerate(_row(figures, bool(problem)), start=1):
                self.table.item(row, column).setText(text)
            for column in range(1 + _FIGURES):
                self.table.item(row, column).setToolTip(problem or _details(figures))
        self.table.blockSignals(False)
        self.told.setText(self._note())

    def _note(self) -> str:
        """Return what the columns mean, or what to do first."""
        if not self.listed:
            return tr("Pick a detector and add it here to compare places.")
        problems = [self.comparison.problem(self._planner.plan, site) for site in self.listed]
        failed = [f"{site.name}: {why}" for site, why in zip(self.listed, problems) if why]
        muons = rounded(self._planner.plan.muons)
        meaning = tr("Days: until the pixel towards the target has {muons} muons.")
        return "\n".join([meaning.format(muons=muons), *failed])

    def _enable(self) -> None:
        chosen = bool(self._chosen())
        for button in (self.use, self.zoom, self.remove):
            button.setEnabled(chosen)


def _row(figures: SiteFigures | None, failed: bool) -> tuple[str, ...]:
    if figures is None:
        return ("–" if failed else "…",) * _FIGURES
    return (
        bare_metres(figures.target_distance_m),
        bare_metres(figures.maximum_thickness_m),
        rounded(figures.target_days),
    )


def _details(figures: SiteFigures | None) -> str:
    if figures is None:
        return tr("Being computed")
    return tr(
        "Distance of the target {distance}\nLargest thickness {thickness}\n"
        "Rock towards the target {rock}\nPixels unknown {unknown} of {pixels}"
    ).format(
        distance=metres(figures.target_distance_m),
        thickness=metres(figures.maximum_thickness_m),
        rock=metres(figures.target_thickness_m),
        unknown=figures.unknown_pixels,
        pixels=figures.pixels,
    )


def _item(text: str, editable: bool) -> QTableWidgetItem:
    item = QTableWidgetItem(text)
    if not editable:
        item.setFlags(item.flags() & ~Qt.ItemFlag.ItemIsEditable)
        item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    return item


def _table() -> QTableWidget:
    table = QTableWidget(0, 1 + _FIGURES)
    for column, (title, meaning) in enumerate(
        (
            (tr("Site"), tr("Name; press F2 to change it")),
            (tr("Away (m)"), tr("Horizontal distance of the target")),
            (tr("Rock (m)"), tr("Largest thickness in the field of view")),
            (tr("Days"), tr("Time until the pixel towards the target has its muons")),
        )
    ):
        # One word a line keeps columns narrow.
        header = QTableWidgetItem(title.replace(" ", "\n"))
        header.setToolTip(meaning)
        table.setHorizontalHeaderItem(column, header)
    table.verticalHeader().setVisible(False)
    triggers = QAbstractItemView.EditTrigger
    # A double click uses a site.
    table.setEditTriggers(triggers.SelectedClicked | triggers.EditKeyPressed)
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    header = table.horizontalHeader()
    header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
    line = table.fontMetrics().lineSpacing()
    table.setMinimumHeight(int(line * (2.5 + 1.6 * _ROWS)))
    return table
