"""Muon tomography as an algorithm: from muograms of Vesuvius to layers on the map."""

import csv
import re
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr
from pyproj import Geod

from muysc_qgis.muogram import write_muogram
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.volume import read_volume
from muysc_qgis.workflows.simulation import Telescope, simulate

gdal.UseExceptions()
ogr.UseExceptions()

CRATER, DENSITY = (14.4265, 40.8215), 2.5
#: The cone in the UTM zone, and its heights.
CONE = {
    "EXTENT": "450600,452700,4518000,4520100 [EPSG:32633]",
    "VOXEL_SIZE": 150, "BASE": 700, "TOP": 1300,
}  # fmt: skip


@pytest.fixture(scope="module")
def dem_path(data_folder):
    return str(data_folder / "vesuvius_srtmgl1.tif")


@pytest.fixture(scope="module")
def sights(dem_path):
    dem = open_dem(dem_path)
    places = [Geod(ellps="WGS84").fwd(*CRATER, azimuth, 1500.0)[:2] for azimuth in (30, 150, 270)]
    target = from_wgs84(dem.crs, *CRATER)
    return [take_sight(dem, from_wgs84(dem.crs, *place), target, 2.0, 60.0) for place in places]


@pytest.fixture(scope="module")
def muograms(sights, tmp_path_factory):
    """Files by quantity, in a folder with accents and a space."""
    folder = tmp_path_factory.mktemp("tomografía ñ")
    files = {}
    for number, sight in enumerate(sights):
        seen = simulate(
            sight, Aperture(60, 24, 20, 12), Physics(density_g_cm3=DENSITY), Telescope()
        )
        for name in ("opacity", "flux", "counts"):
            one = seen.muograms["flux" if name == "counts" else name]
            path = folder / f"site {number} {name}.tif"
            write_muogram(one.with_values(name, one.values), path)
            files.setdefault(name, []).append(str(path))
    return files


@pytest.fixture
def setting(muograms, dem_path, tmp_path):
    return {
        "MUOGRAMS": muograms["opacity"], "DEM": dem_path, **CONE,
        "DENSITY": str(tmp_path / "density.tif"), "COVERAGE": str(tmp_path / "rays.tif"),
    }  # fmt: skip


def test_a_uniform_mountain_on_the_map(run, setting, tmp_path):
    results = run("tomography", setting)
    volume = read_volume(results["DENSITY"])
    assert volume.grid.shape == (14, 14, 4)
    assert volume.grid.origin_m == (450_600, 4_518_000, 700)
    np.testing.assert_allclose(volume.values[volume.known], DENSITY, rtol=1e-3)
    assert results["MEAN_DENSITY"] == pytest.approx(DENSITY, rel=1e-4)
    assert results["REFERENCE"] == pytest.approx(DENSITY, rel=1e-4)
    assert results["VOXELS_SEEN"] == np.count_nonzero(volume.known)
    rays = read_volume(results["COVERAGE"])
    assert rays.values[np.isfinite(rays.values)].max() <= results["RAYS"]
    assert results["RESIDUAL"] < 1e-4
    assert results["ITERATIONS_DONE"] >= 0
    assert volume.metadata["METHOD"] == "bayes"


def test_the_style_shows_the_slice_of_the_target_about_the_reference(run, setting, tmp_path):
    results = run("tomography", setting)
    style = Path(results["DENSITY"]).with_suffix(".qml").read_text(encoding="utf-8")
    band = int(re.search(r'band="(\d+)"', style).group(1))
    low, high = (float(re.search(rf'classification{end}="([\d.]+)"', style).group(1))
                 for end in ("Min", "Max"))  # fmt: skip
    assert 0.5 * (low + high) == pytest.approx(DENSITY, abs=1e-3)
    bands = gdal.Open(results["DENSITY"])
    shown = bands.GetRasterBand(band).GetDescription()
    # The crater floor and 60 m is at about 1060 m, in the third slice of 150 m from 700 m.
    assert shown == "z = 1075 m"


def test_qgis_loads_the_slices_as_bands_of_one_layer(run, setting):
    from qgis.core import QgsRasterLayer

    results = run("tomography", setting)
    layer = QgsRasterLayer(results["DENSITY"], "density")
    assert layer.isValid()
    assert layer.bandCount() == 4
    assert layer.crs().authid() == "EPSG:32633"
    assert layer.renderer().type() == "singlebandpseudocolor"
    assert "z = 775 m" in layer.bandName(1)


def test_the_slices_know_their_elevations_where_qgis_does(monkeypatch, tmp_path, provider):
    """QGIS from 3.38 on, whose classes are stood in for here."""
    import importlib

    name = provider.algorithm("tomography").__class__.__module__.rsplit(".", 1)[0]
    styles = importlib.import_module(f"{name}.outputs.styles")
    said = {}

    class Properties:
        def __init__(self, parent):
            pass

        def setEnabled(self, on):  # noqa: N802
            said["on"] = on

        def setMode(self, mode):  # noqa: N802
            said["mode"] = mode

        def setFixedRangePerBand(self, ranges):  # noqa: N802
            said["ranges"] = ranges

        def writeXml(self, element, document, context):  # noqa: N802
            element.appendChild(document.createElement("elevation"))

    class Modes:
        FixedRangePerBand = "per band"

    monkeypatch.setattr(styles.core, "QgsRasterLayerElevationProperties", Properties, raising=False)
    monkeypatch.setattr(styles.Qgis, "RasterElevationMode", Modes, raising=False)
    quantity = importlib.import_module(f"{name.rsplit('.', 1)[0]}.muysc_qgis.volume")
    styles.write_style(
        tmp_path / "a.qml", np.array([2.0, 3.0]), quantity.VOLUME_QUANTITIES["density"],
        elevations=np.array([700.0, 850.0, 1000.0]),
    )  # fmt: skip
    assert said["mode"] == "per band"
    assert {band: (one.lower(), one.upper()) for band, one in said["ranges"].items()} == {
        1: (700, 850), 2: (850, 1000),
    }  # fmt: skip
    assert "<elevation" in (tmp_path / "a.qml").read_text(encoding="utf-8")


def test_points_table_section_and_errors(run, setting, tmp_path):
    line = tmp_path / "line.geojson"
    line.write_text(
        '{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {},'
        '"geometry": {"type": "LineString", "coordinates": [[14.41, 40.82], [14.44, 40.822]]}}]}',
        encoding="utf-8",
    )
    results = run("tomography", {
        **setting, "POINTS": str(tmp_path / "voxels.gpkg"), "RESIDUALS": str(tmp_path / "r.csv"),
        "DENSITY_ERROR": str(tmp_path / "error.tif"), "SECTION_LINE": str(line),
        "SECTION": str(tmp_path / "section.png"),
    })  # fmt: skip
    volume, error = read_volume(results["DENSITY"]), read_volume(results["DENSITY_ERROR"])
    source = ogr.Open(results["POINTS"])
    layer = source.GetLayer()
    assert layer.GetGeomType() == ogr.wkbPoint25D
    assert layer.GetFeatureCount() == np.count_nonzero(volume.known)
    feature = layer.GetNextFeature()
    point = np.array([[getattr(feature.geometry(), f"Get{axis}")() for axis in "XYZ"]])
    place = tuple(((point[0] - volume.grid.origin_m) / volume.grid.size_m).astype(int))
    assert feature.GetField("density") == pytest.approx(volume.values[place], rel=1e-6)
    assert feature.GetField("density_error") == pytest.approx(error.values[place], rel=1e-6)
    assert np.all(error.values[error.known] > 0)
    # The prior's standard deviation is the most that an error can be.
    assert np.nanmax(error.values) <= 0.2 + 1e-6
    with open(results["RESIDUALS"], encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["muogram"] for row in rows] == [f"site {number} opacity" for number in range(3)]
    assert sum(int(row["rays"]) for row in rows) == results["RAYS"]
    assert Path(results["SECTION"]).read_bytes().startswith(b"\x89PNG")


def test_flux_gives_the_density_that_opacity_does(run, setting, muograms):
    results = run("tomography", {**setting, "MUOGRAMS": muograms["flux"], "METHOD": "lsmr"})
    volume = read_volume(results["DENSITY"])
    np.testing.assert_allclose(volume.values[volume.known], DENSITY, rtol=1e-3)


def test_the_projection_can_be_chosen(run, setting):
    """UTM 32 is 3.6° west of its zone here, where it stretches lengths by 0.2 %."""
    results = run("tomography", {**setting, "CRS": "EPSG:32632"})
    volume = read_volume(results["DENSITY"])
    assert "32632" in volume.crs
    np.testing.assert_allclose(volume.values[volume.known], DENSITY, rtol=1e-3)


def test_cancelling_leaves_nothing(run, setting, recorder, tmp_path):
    from qgis.core import QgsProcessingException

    for percent in (5, 40):
        with pytest.raises(QgsProcessingException, match="Cancelled; no output was written"):
            run("tomography", {**setting, "METHOD": "tv"}, recorder(cancel_at=percent))
        assert list(tmp_path.iterdir()) == []


def test_the_log_counts_what_was_not_used(run, setting, recorder):
    said = recorder()
    results = run("tomography", {**setting, "MUOGRAMS": setting["MUOGRAMS"][:1]}, said)
    assert any("one station only" in text for text in said.warnings)
    lost = [int(re.search(r": (\d+) rays", text).group(1))
            for text in said.infos if "not used because" in text]  # fmt: skip
    assert sum(lost) + results["RAYS"] == 240


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"METHOD": "fbp"}, r"Filtered back-projection needs parallel rays .* such as sirt"),
        ({"METHOD": "magic"}, r"METHOD is “magic”; use one of art, bart"),
        ({"BASE": 1300}, r"base of the volume at 1300 m is not below its top at 1300 m"),
        (
            {"EXTENT": "13,14,40,40.5 [EPSG:4326]"},
            r"is off the elevation model|No ray meets rock|reaches beyond",
        ),
        (
            {"EXTENT": "400000,452700,4518000,4520100 [EPSG:32633]"},
            r"reaches beyond the elevation model",
        ),
        ({"CRS": "EPSG:4326"}, r"EPSG:4326 \(WGS 84\) is no projection in metres"),
        ({"CRS": "EPSG:3857"}, r"stretches lengths by 32 %"),
        ({"VOXEL_SIZE": 2, "MEMORY": 0.01}, r"use voxels of \d+(\.\d+)? m or larger"),
        ({"RELATIVE_ERROR": 0}, r"Bayesian .* needs the standard errors"),
        ({"METHOD": "sirt", "DENSITY_ERROR": "error.tif"}, r"sirt tells no errors"),
        ({"SECTION": "section.png"}, r"SECTION is asked for without SECTION_LINE"),
        ({"RELAXATION": 2.5, "METHOD": "art"}, r"(?i)relaxation"),
        ({"MUOGRAMS": []}, r"(?i)muogram"),
    ],
)
def test_what_cannot_be_used_is_said_in_a_sentence(run, setting, tmp_path, change, sentence):
    from qgis.core import QgsProcessingException

    for name in ("DENSITY_ERROR", "SECTION"):
        if name in change:
            change = {**change, name: str(tmp_path / change[name])}
    with pytest.raises(QgsProcessingException, match=sentence):
        run("tomography", {**setting, **change})
    assert list(tmp_path.iterdir()) == []


def test_other_quantities_are_refused(run, setting, muograms):
    from qgis.core import QgsProcessingException

    mixed = [muograms["opacity"][0], muograms["flux"][1]]
    with pytest.raises(QgsProcessingException, match=r"different quantities: opacity .* flux"):
        run("tomography", {**setting, "MUOGRAMS": mixed})
    with pytest.raises(QgsProcessingException, match=r"lacks the metadata key DAYS"):
        run("tomography", {**setting, "MUOGRAMS": muograms["counts"]})
    with pytest.raises(QgsProcessingException, match=r"lacks the metadata key QUANTITY"):
        run("tomography", {**setting, "MUOGRAMS": [setting["DEM"]]})
