"""The upper part of the dock: everything that a plan is made of."""

from __future__ import annotations

from dataclasses import replace

from qgis.core import QgsMapLayer, QgsRasterLayer
from qgis.gui import QgsMapLayerComboBox
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtWidgets import (
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ...processing_algorithms.parameters.telescope import NONE
from ..radiography.materials import MATERIALS
from ..radiography.settings import MAXIMUM_DENSITY_G_CM3
from ..radiography.spectra import MODELS
from ..telescope.presets import PRESETS
from .compat import RASTER_LAYERS
from .icons import icon
from .plan import Plan
from .texts import tr
from .widgets import folded_box

#: Largest acceptance (cm² sr), number of muons and of days that can be typed.
_LARGEST = 1e9

#: Height (m) above or below ground that can be typed.
_HIGHEST_M = 10_000.0

#: Characters that lists show at least.
_LIST_CHARACTERS = 10


class SettingsForm(QWidget):
    """Edits a plan but for its two points, which are picked on the map."""

    #: The plan that the form now shows, but for its points.
    edited = pyqtSignal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._plan = Plan()
        self.dem = QgsMapLayerComboBox()
        self.dem.setFilters(RASTER_LAYERS)
        self.dem.setAllowEmptyLayer(True, tr("Choose an elevation model"))
        self.dem.setToolTip(tr("Raster of terrain heights that holds detector, target and rock"))
        _narrow(self.dem)
        self.pick_detector = _pick_button(tr("Pick detector"), "detector")
        self.pick_detector.setToolTip(
            tr("Click on the map where the telescope stands, or drag its marker")
        )
        self.pick_target = _pick_button(tr("Pick target"), "target")
        self.pick_target.setToolTip(
            tr("Click on the map what the telescope points at, or drag its marker")
        )
        self.detector_height = _number(-_HIGHEST_M, _HIGHEST_M, 1, " m")
        self.detector_height.setToolTip(tr("Height of the detector above ground, negative below"))
        self.target_height = _number(-_HIGHEST_M, _HIGHEST_M, 1, " m")
        self.target_height.setToolTip(tr("Height of the target above ground, negative inside"))
        self.preset = _choice({NONE: tr("Free aperture"), **_titles(PRESETS)})
        self.azimuth = _number(0.1, 360.0, 1, "°")
        self.azimuth.setToolTip(tr("Full width of the field of view in azimuth"))
        self.elevation = _number(0.1, 180.0, 1, "°")
        self.elevation.setToolTip(tr("Full height of the field of view in elevation"))
        self.material = _choice(
            {
                name: f"{tr(material.title)} ({material.density_g_cm3:g} g/cm³)"
                for name, material in MATERIALS.items()
            }
        )
        self.density = _number(0.0, MAXIMUM_DENSITY_G_CM3, 3, " g/cm³")
        self.density.setSpecialValueText(tr("as material"))
        self.density.setSingleStep(0.05)
        self.model = _choice(_titles(MODELS))
        self.acceptance = _number(0.001, _LARGEST, 3, " cm² sr")
        self.acceptance.setToolTip(tr("Acceptance of one pixel; a telescope has its own"))
        self.muons = _number(1.0, _LARGEST, 0, tr(" per pixel"))
        self.muons.setToolTip(tr("Number of muons that the exposure time is for"))
        self.days = _number(0.001, _LARGEST, 1, tr(" days"))
        self.days.setToolTip(tr("Time of counting that the muon counts are for"))
        self._lay_out()
        self._connect()
        self.show_plan(self._plan)

    def _lay_out(self) -> None:
        terrain = _form()
        terrain.addRow(tr("DEM"), self.dem)
        terrain.addRow(_side_by_side(self.pick_detector, self.pick_target))
        heights = _side_by_side(self.detector_height, self.target_height)
        terrain.addRow(tr("Above ground"), heights)
        terrain.addRow(tr("Telescope"), self.preset)
        field = _side_by_side(self.azimuth, QLabel("×"), self.elevation)
        terrain.addRow(tr("Field of view"), field)
        self.physics = folded_box(tr("Rock, muons and time"))
        rock = _form(self.physics)
        for label, widget in (
            (tr("Material"), self.material),
            (tr("Density"), self.density),
            (tr("Flux model"), self.model),
            (tr("Acceptance"), self.acceptance),
            (tr("Muons"), self.muons),
            (tr("Counting time"), self.days),
        ):
            rock.addRow(label, widget)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(terrain)
        layout.addWidget(self.physics)

    def _connect(self) -> None:
        self.dem.layerChanged.connect(self._edit)
        for spin in self.findChildren(QDoubleSpinBox):
            spin.valueChanged.connect(self._edit)
        for box in (self.material, self.model):
            box.currentIndexChanged.connect(self._edit)
        self.preset.currentIndexChanged.connect(self._choose_preset)

    def show_plan(self, plan: Plan) -> None:
        """Show a plan without telling that something was edited."""
        self._plan = plan
        lists = (self.dem, self.preset, self.material, self.model)
        widgets = [*self.findChildren(QDoubleSpinBox), *lists]
        for widget in widgets:
            widget.blockSignals(True)
        self._show_layer(plan.dem)
        self.detector_height.setValue(plan.detector_height_m)
        self.target_height.setValue(plan.target_height_m)
        _choose(self.preset, plan.preset)
        self.azimuth.setValue(plan.azimuth_aperture_deg)
        self.elevation.setValue(plan.elevation_aperture_deg)
        _choose(self.material, plan.material)
        self.density.setValue(plan.density_g_cm3 or 0.0)
        _choose(self.model, plan.flux_model)
        self.acceptance.setValue(plan.acceptance_cm2_sr)
        self.acceptance.setEnabled(plan.preset == NONE)
        self.muons.setValue(plan.muons)
        self.days.setValue(plan.days)
        for widget in widgets:
            widget.blockSignals(False)

    @property
    def layer(self) -> QgsRasterLayer | None:
        """The elevation model chosen."""
        return self.dem.currentLayer()

    def _show_layer(self, identifier: str) -> None:
        layers = (self.dem.layer(index) for index in range(self.dem.count()))
        found = next((one for one in layers if _is(one, identifier)), None)
        # Without a layer the entry that says so, rather than none at all.
        self.dem.setCurrentIndex(0) if found is None else self.dem.setLayer(found)

    def _edit(self, *_: object) -> None:
        layer = self.layer
        self._plan = replace(
            self._plan,
            dem=layer.id() if layer is not None else "",
            detector_height_m=self.detector_height.value(),
            target_height_m=self.target_height.value(),
            azimuth_aperture_deg=self.azimuth.value(),
            elevation_aperture_deg=self.elevation.value(),
            material=self.material.currentData(),
            density_g_cm3=self.density.value() or None,
            flux_model=self.model.currentData(),
            acceptance_cm2_sr=self.acceptance.value(),
            muons=self.muons.value(),
            days=self.days.value(),
        )
        self.edited.emit(self._plan)

    def _choose_preset(self, *_: object) -> None:
        self.show_plan(self._plan.with_preset(self.preset.currentData()))
        self.edited.emit(self._plan)


def _is(layer: QgsMapLayer | None, identifier: str) -> bool:
    return layer is not None and layer.id() == identifier


def _titles(table: dict) -> dict[str, str]:
    return {name: tr(entry.title) for name, entry in table.items()}


def _form(parent: QWidget | None = None) -> QFormLayout:
    form = QFormLayout(parent)
    form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
    form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapLongRows)
    form.setContentsMargins(0, 0, 0, 0)
    return form


def _side_by_side(*widgets: QWidget) -> QHBoxLayout:
    layout = QHBoxLayout()
    layout.setSpacing(4)
    for widget in widgets:
        layout.addWidget(widget)
    return layout


def _narrow(box: QComboBox) -> None:
    """Let a list be narrower than its longest entry."""
    box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(_LIST_CHARACTERS)
    box.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)


def _choice(entries: dict[str, str]) -> QComboBox:
    box = QComboBox()
    _narrow(box)
    for name, title in entries.items():
        box.addItem(title, name)
    return box


def _choose(box: QComboBox, name: str) -> None:
    box.setCurrentIndex(max(0, box.findData(name)))


def _number(low: float, high: float, decimals: int, unit: str) -> QDoubleSpinBox:
    spin = QDoubleSpinBox()
    spin.setDecimals(decimals)
    spin.setRange(low, high)
    spin.setSuffix(unit)
    spin.setMinimumWidth(60)
    spin.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
    # One muogram for a number typed, not one for each digit.
    spin.setKeyboardTracking(False)
    return spin


def _pick_button(text: str, name: str) -> QToolButton:
    button = QToolButton()
    button.setText(text)
    button.setIcon(icon(name))
    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
    button.setCheckable(True)
    button.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
    return button
