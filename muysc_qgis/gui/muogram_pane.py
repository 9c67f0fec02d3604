"""The muogram in the dock: choice of quantity, picture, and what a pixel says."""

from __future__ import annotations

from qgis.PyQt.QtCore import Qt, QTimer
from qgis.PyQt.QtWidgets import QComboBox, QHBoxLayout, QVBoxLayout, QWidget

from ..quantities import QUANTITIES
from .muogram_layout import Scene
from .muogram_view import MuogramView
from .picture_actions import copy_picture, save_picture
from .planner import Planner
from .preview import SHOWN, Preview
from .readout import describe_pixel, describe_preview
from .section_window import SectionWindow
from .texts import tr
from .widgets import folded_box, icon_button, wrapping_label

#: Lines that a pixel takes.
_READOUT_LINES = 6


class MuogramPane(QWidget):
    """Shows the muogram of a planner."""

    def __init__(self, planner: Planner, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._planner = planner
        self._preview: Preview | None = None
        self.quantity = QComboBox()
        for name in SHOWN:
            self.quantity.addItem(tr(QUANTITIES[name].title), name)
        self.copy = icon_button("copy", tr("Copy picture"), self._copy)
        self.save = icon_button("save", tr("Save picture…"), self._save)
        self.view = MuogramView()
        self.readout = wrapping_label()
        self.readout.setAlignment(Qt.AlignmentFlag.AlignTop)
        # Room for all lines of a pixel, so that the picture does not jump.
        self.readout.setMinimumHeight(_READOUT_LINES * self.fontMetrics().lineSpacing())
        self.notes = folded_box()
        self.warnings = wrapping_label()
        QVBoxLayout(self.notes).addWidget(self.warnings)
        self.section: SectionWindow | None = None
        top = QHBoxLayout()
        top.addWidget(self.quantity, 1)
        top.addWidget(self.copy)
        top.addWidget(self.save)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(top)
        layout.addWidget(self.view, 1)
        layout.addWidget(self.readout)
        layout.addWidget(self.notes)
        # A mouse that crosses many pixels asks for the last one only.
        self._pause = QTimer(self)
        self._pause.setSingleShot(True)
        self._pause.setInterval(0)
        self._pause.timeout.connect(self._show_ray)
        self._pixel: tuple[int, int] | None = None
        self._connect()
        self._empty("")

    def release(self) -> None:
        """Close the section for good."""
        self._pause.stop()
        if self.section is not None:
            self.section.release()

    def _connect(self) -> None:
        self._planner.previewed.connect(self._take)
        self._planner.emptied.connect(self._empty)
        self.quantity.currentIndexChanged.connect(self._show_quantity)
        self.view.hovered.connect(self._hover)
        self.view.left.connect(self._leave)
        self.view.clicked.connect(self._click)

    def _take(self, preview: Preview) -> None:
        self._preview = preview
        self._pixel = None
        self.view.mark(None)
        self._show_quantity()
        self._describe()
        for button in (self.copy, self.save):
            button.setEnabled(True)

    def _empty(self, reason: str) -> None:
        self._preview, self._pixel = None, None
        self.view.show_reason(reason)
        self.readout.clear()
        self._show_notes(())
        for button in (self.copy, self.save):
            button.setEnabled(False)

    def _show_quantity(self, *_: object) -> None:
        if self._preview is not None:
            muogram = self._preview.muogram(self.quantity.currentData())
            self.view.show_scene(Scene.of(muogram, self._preview.muogram("opacity")))

    def _describe(self) -> None:
        """Say what there is to say of the whole muogram."""
        if self._preview is None:
            return
        self.readout.setText(describe_preview(self._preview))
        self._show_notes(self._preview.simulation.warnings)

    def _show_notes(self, notes: tuple[str, ...]) -> None:
        self.notes.setVisible(bool(notes))
        self.notes.setTitle(tr("Notes ({number})").format(number=len(notes)))
        self.warnings.setText("\n".join(f"• {note}" for note in notes))

    def _hover(self, row: int, column: int) -> None:
        if self._preview is None:
            return
        self._pixel = row, column
        self.readout.setText(
            describe_pixel(self._preview, row, column, self.quantity.currentData())
        )
        self._pause.start()

    def _show_ray(self) -> None:
        if self._pixel is not None:
            self._planner.section(*self._pixel)

    def _leave(self) -> None:
        self._pixel = None
        self._planner.items.hide_ray()
        self._describe()

    def _click(self, row: int, column: int) -> None:
        section = self._planner.section(row, column)
        if section is None:
            return
        if self.section is None:
            self.section = SectionWindow(self)
        self.section.show_section(section)

    def _copy(self) -> None:
        picture = self.view.picture()
        if picture is not None:
            copy_picture(picture)

    def _save(self) -> None:
        picture = self.view.picture()
        if picture is not None:
            save_picture(self, picture)
