"""The main job through processing.run: numbers, files, styles, documents."""

import base64
import re
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr

gdal.UseExceptions()

QUANTITIES = (
    "THICKNESS", "OPACITY", "MINIMUM_ENERGY", "FLUX", "OPEN_SKY", "TRANSMISSION", "EXPOSURE",
    "DISTANCE",
)  # fmt: skip
#: What later steps, and scripts of users, find in every muogram.
KEYS = {
    "QUANTITY", "UNIT", "DETECTOR_LON", "DETECTOR_LAT", "DETECTOR_ELEVATION", "BORESIGHT_AZIMUTH",
    "BORESIGHT_ELEVATION", "DENSITY", "FLUX_MODEL", "ENERGY_LOSS", "VERSION",
}  # fmt: skip


def read(path):
    return gdal.Open(str(path)).ReadAsArray().astype(float)


@pytest.fixture
def everything(vesuvius, tmp_path):
    return {
        **vesuvius,
        **{name: str(tmp_path / f"{name.lower()}.tif") for name in QUANTITIES},
        "FIELD_OF_VIEW": str(tmp_path / "field_of_view.gpkg"),
        "PANEL": str(tmp_path / "panel.png"),
        "REPORT": str(tmp_path / "report.html"),
    }


@pytest.mark.parametrize(
    ("parameter", "value"),
    [
        ("AZIMUTH_PIXELS", 100), ("ELEVATION_PIXELS", 100), ("MAX_RANGE", None), ("DENSITY", None),
        ("FLUX_MODEL", "gsf-sibyll"), ("ENERGY_LOSS", "csda"), ("ACCEPTANCE", 6), ("MUONS", 10),
    ],
)  # fmt: skip
def test_scripts_rely_on_the_defaults(provider, parameter, value):
    definition = provider.algorithm("radiography").parameterDefinition(parameter)
    assert definition.defaultValue() == value


def test_every_output_is_written_and_declared(run, provider, everything):
    results = run("radiography", everything)
    for name in (*QUANTITIES, "PANEL", "REPORT"):
        assert Path(results[name]).stat().st_size > 0
    declared = {output.name() for output in provider.algorithm("radiography").outputDefinitions()}
    assert set(results) <= declared


def test_quantities_are_consistent_with_each_other(run, everything):
    results = run("radiography", everything)
    values = {name: read(results[name]) for name in QUANTITIES}
    rock = values["THICKNESS"] > 0
    assert rock.any()
    assert (~rock).any()
    # 2.65 g/cm³ is standard rock; 100 cm in 1 m.
    np.testing.assert_allclose(values["OPACITY"], values["THICKNESS"] * 265, rtol=1e-6)
    np.testing.assert_allclose(
        values["TRANSMISSION"], values["FLUX"] / values["OPEN_SKY"], rtol=1e-5
    )
    # 10 muons in 6 cm² sr, the defaults.
    np.testing.assert_allclose(values["EXPOSURE"], 10 / (6 * values["FLUX"]), rtol=1e-5)
    assert np.all(values["TRANSMISSION"][~rock] == 1)
    assert np.all(np.isnan(values["DISTANCE"][~rock]))
    assert np.all(values["DISTANCE"][rock] > 0)


def test_numbers_agree_with_the_rasters(run, everything):
    results = run("radiography", everything)
    thickness = read(results["THICKNESS"])
    assert results["MAX_THICKNESS"] == pytest.approx(np.nanmax(thickness), rel=1e-6)
    assert results["ROCK_PIXELS"] == np.count_nonzero(thickness > 0)
    assert results["UNKNOWN_PIXELS"] == np.count_nonzero(np.isnan(read(results["FLUX"])))
    assert results["MEDIAN_EXPOSURE"] == pytest.approx(
        np.median(read(results["EXPOSURE"])[thickness > 0]), rel=1e-5
    )
    assert all(type(value) in (int, float, str) for value in results.values())


def test_muogram_rasters_describe_themselves(run, everything):
    results = run("radiography", everything)
    dataset = gdal.Open(results["FLUX"])
    band = dataset.GetRasterBand(1)
    assert band.GetDescription() == "Muon flux (cm⁻² sr⁻¹ day⁻¹)"
    assert band.GetUnitType() == "cm⁻² sr⁻¹ day⁻¹"
    assert np.isnan(band.GetNoDataValue())
    assert band.DataType == gdal.GDT_Float32
    metadata = dataset.GetMetadata("MUYSC")
    assert metadata.keys() >= KEYS
    assert metadata["QUANTITY"] == "flux"
    assert metadata["FLUX_MODEL"] == "gsf-sibyll"
    assert metadata["ENERGY_LOSS"] == "csda"
    assert float(metadata["DENSITY"]) == 2.65
    assert float(metadata["DETECTOR_LON"]) == pytest.approx(14.410686, abs=1e-9)
    assert float(metadata["DETECTOR_LAT"]) == pytest.approx(40.810561, abs=1e-9)
    # Pixel centres lie on the rays: the middle pixel of an odd grid on the boresight.
    left, step_x, _, top, _, step_y = dataset.GetGeoTransform()
    assert left + step_x * 10.5 == pytest.approx(float(metadata["BORESIGHT_AZIMUTH"]), abs=1e-9)
    assert top + step_y * 5.5 == pytest.approx(float(metadata["BORESIGHT_ELEVATION"]), abs=1e-9)
    assert (step_x, step_y) == (pytest.approx(2.0), pytest.approx(-2.0))


def test_only_what_is_asked_for_is_written(run, vesuvius, tmp_path):
    run(
        "radiography",
        {**vesuvius, "THICKNESS": str(tmp_path / "t.tif"), "FLUX": str(tmp_path / "f.tif")},
    )
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "f.qml", "f.tif", "t.qml", "t.tif",
    ]  # fmt: skip


def test_rasters_open_styled_with_units_in_the_legend(run, everything):
    from qgis.core import QgsRasterLayer, QgsSingleBandPseudoColorRenderer

    results = run("radiography", everything)
    for name in QUANTITIES:
        layer = QgsRasterLayer(results[name], name)
        assert isinstance(layer.renderer(), QgsSingleBandPseudoColorRenderer), name
        items = layer.renderer().shader().rasterShaderFunction().colorRampItemList()
        assert len(items) >= 9
        assert [item.value for item in items] == sorted(item.value for item in items)
    layer = QgsRasterLayer(results["THICKNESS"], "thickness")
    labels = [
        item.label for item in layer.renderer().shader().rasterShaderFunction().colorRampItemList()
    ]
    assert labels[0] == "sky"
    assert all(label.endswith(" m") for label in labels[1:])


def test_field_of_view_lies_on_the_map(run, everything):
    results = run("radiography", everything)
    dataset = ogr.Open(results["FIELD_OF_VIEW"])
    layer = dataset.GetLayer()
    assert layer.GetSpatialRef().GetAuthorityCode(None) == "4326"
    parts = {feature["part"]: feature.geometry().Clone() for feature in layer}
    assert set(parts) == {"aperture", "ground seen"}
    target, detector = ogr.Geometry(ogr.wkbPoint), ogr.Geometry(ogr.wkbPoint)
    target.AddPoint(14.424745, 40.823729)
    detector.AddPoint(14.410686, 40.810561)
    assert parts["aperture"].Contains(target)
    assert parts["aperture"].Distance(detector) < 1e-9
    assert parts["ground seen"].IsValid()
    # The outline is drawn in straight chords: a sliver may lie outside.
    outside = parts["ground seen"].Difference(parts["aperture"]).Area()
    assert outside < 1e-3 * parts["ground seen"].Area()


def test_panel_and_report_hold_what_they_promise(run, everything):
    results = run("radiography", everything)
    panel = gdal.Open(results["PANEL"])
    assert panel.RasterXSize >= 1000
    assert np.std(panel.ReadAsArray()[:3]) > 20
    report = Path(results["REPORT"]).read_text(encoding="utf-8")
    pictures = re.findall(r'src="data:image/png;base64,([^"]+)"', report)
    assert len(pictures) == 4
    for picture in pictures:
        assert base64.b64decode(picture).startswith(b"\x89PNG")
    for words in ("vesuvius_srtmgl1.tif", "SIBYLL", "Peña-Rodríguez", "Median exposure", "g/cm³"):
        assert words in report
    assert "<script" not in report


def test_every_warning_is_in_the_log_and_in_the_report(run, everything, feedback):
    results = run("radiography", {**everything, "MAX_RANGE": 1500, "DETECTOR_HEIGHT": -5}, feedback)
    said = " ".join(feedback.warnings)
    assert "maximum range of 1500 m" in said
    assert "5 m below ground" in said
    report = Path(results["REPORT"]).read_text(encoding="utf-8")
    assert "maximum range of 1500 m" in report


def test_all_sky_is_done_with_a_warning(run, vesuvius, tmp_path, feedback):
    results = run(
        "radiography",
        {
            **vesuvius,
            "TARGET_HEIGHT": 3000,
            "THICKNESS": str(tmp_path / "t.tif"),
            "FLUX": str(tmp_path / "f.tif"),
            "PANEL": str(tmp_path / "p.png"),
        },
        feedback,
    )
    assert results["ROCK_PIXELS"] == 0
    assert results["MAX_THICKNESS"] == 0
    assert any("231 known pixels see only sky" in warning for warning in feedback.warnings)


def test_rays_below_the_horizon_keep_their_thickness(run, vesuvius, tmp_path, feedback):
    results = run(
        "radiography",
        {
            **vesuvius,
            "TARGET_HEIGHT": -600,
            "MAX_RANGE": 3000,
            "THICKNESS": str(tmp_path / "t.tif"),
            "FLUX": str(tmp_path / "f.tif"),
        },
        feedback,
    )
    below = np.isfinite(read(results["THICKNESS"])) & np.isnan(read(results["FLUX"]))
    assert below.any()
    assert results["UNKNOWN_PIXELS"] == below.sum()
    assert any("horizon" in text for text in feedback.infos)


@pytest.mark.parametrize("percent", [1, 60])
def test_cancelling_raises_and_leaves_nothing(run, everything, tmp_path, recorder, percent):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match="Cancelled"):
        run("radiography", everything, recorder(cancel_at=percent))
    assert list(tmp_path.iterdir()) == []


def test_a_parameter_that_does_not_exist_is_named(run, vesuvius, tmp_path, feedback):
    run(
        "radiography",
        {**vesuvius, "DENSITIY": 2, "THICKNESS": str(tmp_path / "t.tif"),
         "FLUX": str(tmp_path / "f.tif")},
        feedback,
    )  # fmt: skip
    assert any("DENSITIY is no parameter" in warning for warning in feedback.warnings)


def test_a_detector_in_another_crs_is_the_same_place(run, vesuvius, tmp_path):
    from pyproj import Transformer

    move = Transformer.from_crs(4326, 32633, always_xy=True).transform
    metres = {
        name: "{:.4f},{:.4f} [EPSG:32633]".format(*move(*point))
        for name, point in (
            ("DETECTOR", (14.410686, 40.810561)),
            ("TARGET", (14.424745, 40.823729)),
        )
    }
    outputs = {"FLUX": str(tmp_path / "f.tif")}
    first = run("radiography", {**vesuvius, **outputs, "THICKNESS": str(tmp_path / "1.tif")})
    second = run(
        "radiography", {**vesuvius, **metres, **outputs, "THICKNESS": str(tmp_path / "2.tif")}
    )
    assert second["TARGET_DISTANCE"] == pytest.approx(first["TARGET_DISTANCE"], abs=1e-3)
    assert np.nanmax(np.abs(read(tmp_path / "1.tif") - read(tmp_path / "2.tif"))) < 0.5


def test_layers_arrive_styled_in_a_project(provider, everything, recorder):
    """What the desktop does: run with a project, then post-process the loaded layers."""
    from qgis.core import (
        QgsProcessingContext,
        QgsProcessingOutputLayerDefinition,
        QgsProcessingUtils,
        QgsProject,
    )

    project = QgsProject()
    context = QgsProcessingContext()
    context.setProject(project)
    feedback = recorder()
    names = ("THICKNESS", "FLUX", "FIELD_OF_VIEW")
    wanted = {name: QgsProcessingOutputLayerDefinition(everything[name], project) for name in names}
    algorithm = provider.algorithm("radiography").create()
    parameters = {**everything, **wanted, "PANEL": None, "REPORT": None}
    _, done = algorithm.run(parameters, context, feedback)
    assert done
    looks = {}
    for identifier, details in context.layersToLoadOnCompletion().items():
        layer = QgsProcessingUtils.mapLayerFromString(identifier, context)
        details.postProcessor().postProcessLayer(layer, context, feedback)
        looks[details.outputName] = layer.renderer().type()
    assert looks == {
        "THICKNESS": "singlebandpseudocolor",
        "FLUX": "singlebandpseudocolor",
        "FIELD_OF_VIEW": "categorizedSymbol",
    }
