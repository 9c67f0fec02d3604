"""Muograms from many sites: the same as one by one, named, indexed, together or not at all."""

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr, osr

gdal.UseExceptions()
ogr.UseExceptions()

#: Longitude and latitude around the Gran Cono, name and height above ground.
PLACES = [
    ((14.410686, 40.810561), "Casina Amelia", None),
    ((14.4390, 40.8150), "Cratere Sud-Est à l'ombre", 2.5),
    ((14.4100, 40.8300), None, 0.0),
]


def write_sites(path, places=PLACES, epsg=4326):
    """Write a GeoPackage of (place, name, height); None for a place is no geometry."""
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(epsg)
    reference.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    wgs84 = osr.SpatialReference()
    wgs84.ImportFromEPSG(4326)
    wgs84.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    to_own = osr.CoordinateTransformation(wgs84, reference)
    source = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
    layer = source.CreateLayer("sites", reference, ogr.wkbPoint)
    layer.CreateField(ogr.FieldDefn("label", ogr.OFTString))
    layer.CreateField(ogr.FieldDefn("above", ogr.OFTReal))
    for place, name, height in places:
        feature = ogr.Feature(layer.GetLayerDefn())
        if place is not None:
            point = ogr.Geometry(ogr.wkbPoint)
            point.AddPoint_2D(*to_own.TransformPoint(*place)[:2])
            feature.SetGeometry(point)
        for field, value in (("label", name), ("above", height)):
            if value is not None:
                feature[field] = value
        layer.CreateFeature(feature)
    return str(path)


def read(path):
    dataset = gdal.Open(str(path))
    return dataset.ReadAsArray().astype(float), dataset.GetMetadata("MUYSC")


def rows(path):
    source = ogr.Open(str(path))
    return [feature.items() for feature in source.GetLayer()]


@pytest.fixture
def survey(vesuvius, tmp_path):
    one = {name: value for name, value in vesuvius.items() if name != "DETECTOR"}
    return {
        **one,
        "SITES": write_sites(tmp_path / "sites.gpkg"),
        "FOLDER": str(tmp_path / "muograms"),
        "INDEX": str(tmp_path / "index.gpkg"),
    }


def test_each_site_is_the_radiography_of_its_own(run, vesuvius, survey, tmp_path):
    done = run("radiographyatsites", {**survey, "NAME_FIELD": "label", "HEIGHT_FIELD": "above"})
    stems = ["Casina_Amelia", "Cratere_Sud-Est_a_l_ombre", "site_03"]
    for (place, _, height), stem in zip(PLACES, stems):
        outputs = {name: str(tmp_path / f"{name}.tif") for name in ("THICKNESS", "FLUX", "OPACITY")}
        run(
            "radiography",
            {
                **vesuvius,
                **outputs,
                "DETECTOR": f"{place[0]},{place[1]} [EPSG:4326]",
                "DETECTOR_HEIGHT": height or 0.0,
            },
        )
        for quantity in ("thickness", "flux", "opacity"):
            values, metadata = read(Path(done["FOLDER"]) / f"{stem}_{quantity}.tif")
            expected, expected_metadata = read(tmp_path / f"{quantity.upper()}.tif")
            np.testing.assert_array_equal(values, expected)
            assert metadata == expected_metadata
    assert (done["SITES_DONE"], done["SITES_SKIPPED"], done["MUOGRAMS"]) == (3, 0, 9)


def test_the_index_names_files_that_exist_and_numbers_that_hold(run, survey):
    done = run("radiographyatsites", {**survey, "QUANTITIES": ["thickness", "exposure"]})
    index = rows(done["INDEX"])
    assert [row["site"] for row in index] == ["site_01", "site_02", "site_03"]
    for row in index:
        folder = Path(done["FOLDER"])
        thickness, metadata = read(folder / row["thickness"])
        exposure, _ = read(folder / row["exposure"])
        assert row["maximum_thickness_m"] == pytest.approx(np.nanmax(thickness), rel=1e-6)
        assert row["median_exposure_days"] == pytest.approx(
            np.nanmedian(exposure[thickness > 0]), rel=1e-5
        )
        assert row["detector_elevation_m"] == float(metadata["DETECTOR_ELEVATION"])
        assert row["distance_m"] == float(metadata["TARGET_DISTANCE"])
        assert row["unknown_pixels"] == np.count_nonzero(np.isnan(exposure))
    assert done["MAX_THICKNESS"] == max(row["maximum_thickness_m"] for row in index)
    assert done["MEDIAN_EXPOSURE"] == np.median([row["median_exposure_days"] for row in index])
    assert done["UNKNOWN_PIXELS"] == sum(row["unknown_pixels"] for row in index)
    assert len(list(folder.glob("*.tif"))) == len(list(folder.glob("*.qml"))) == 6


@pytest.mark.parametrize("named_by", ["path", "layer"])
def test_the_index_may_not_replace_the_sites(run, survey, named_by):
    from qgis.core import QgsProcessingException, QgsVectorLayer

    before = Path(survey["SITES"]).read_bytes()
    layer = QgsVectorLayer(survey["SITES"], "sites")
    sites = layer if named_by == "layer" else survey["SITES"]
    with pytest.raises(QgsProcessingException, match=r"sites\.gpkg is the input itself; choose"):
        run("radiographyatsites", {**survey, "SITES": sites, "INDEX": survey["SITES"]})
    assert Path(survey["SITES"]).read_bytes() == before


def test_the_index_lies_where_the_sites_are(run, survey, tmp_path):
    moved = write_sites(tmp_path / "utm.gpkg", epsg=32633)
    done = run("radiographyatsites", {**survey, "SITES": moved})
    source = ogr.Open(done["INDEX"])
    points = [feature.geometry().GetPoint_2D() for feature in source.GetLayer()]
    np.testing.assert_allclose(points, [place for place, _, _ in PLACES], atol=1e-8)


def test_sites_that_cannot_be_used_are_skipped_and_named(run, survey, tmp_path, feedback):
    places = [((20.0, 40.0), "far away", None), *PLACES, (None, "nowhere", None)]
    done = run(
        "radiographyatsites",
        {**survey, "SITES": write_sites(tmp_path / "some.gpkg", places), "NAME_FIELD": "label"},
        feedback,
    )
    assert (done["SITES_DONE"], done["SITES_SKIPPED"]) == (3, 2)
    said = " ".join(feedback.warnings)
    assert "Site far away was skipped. The detector (20, 40) is off the DEM" in said
    assert "Site nowhere was skipped because it has no place on the map." in said
    # Numbers of sites without a name count those that were skipped.
    assert "site_04" in [row["site"] for row in rows(done["INDEX"])]


def test_a_second_run_replaces_its_own_files_and_says_so(run, survey, feedback):
    run("radiographyatsites", survey)
    stale = Path(survey["FOLDER"]) / "site_03_flux.tif"
    stale.rename(stale.with_name("site_99_flux.tif"))
    run("radiographyatsites", {**survey, "DENSITY": 2.0}, feedback)
    assert float(read(stale)[1]["DENSITY"]) == 2.0
    said = " ".join(feedback.warnings)
    assert "8 muograms of an earlier run" in said
    assert "1 other rasters, such as site_99_flux.tif" in said


def test_a_file_of_others_is_never_replaced(run, survey):
    from qgis.core import QgsProcessingException

    kept = Path(survey["FOLDER"]) / "site_02_opacity.tif"
    kept.parent.mkdir()
    kept.write_bytes(b"something else")
    with pytest.raises(QgsProcessingException, match="no muogram of opacity"):
        run("radiographyatsites", survey)
    assert kept.read_bytes() == b"something else"
    assert list(kept.parent.iterdir()) == [kept]


@pytest.mark.parametrize("percent", [1, 60])
def test_cancelling_leaves_nothing_and_keeps_what_was(run, survey, recorder, percent):
    from qgis.core import QgsProcessingException

    run("radiographyatsites", survey)
    folder = Path(survey["FOLDER"])
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    with pytest.raises(QgsProcessingException, match="Cancelled"):
        run("radiographyatsites", {**survey, "DENSITY": 2.0}, recorder(cancel_at=percent))
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


def test_warnings_of_all_sites_are_said_once(run, survey, feedback):
    run("radiographyatsites", {**survey, "MAX_RANGE": 1500}, feedback)
    cut = [text for text in feedback.warnings if "maximum range of 1500 m" in text]
    assert len(cut) == 1
    assert cut[0].startswith("Site site_01 (and likewise site_02, site_03): ")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"SITES": None}, ("SITES is missing",)),
        ({"SITES": "/no/such.gpkg"}, ("/no/such.gpkg", "layer of points")),
        ({"NAME_FIELD": "colour"}, ("NAME_FIELD", "colour", "label, above")),
        ({"HEIGHT_FIELD": "label"}, ("Casina Amelia", "not a finite number")),
        ({"QUANTITIES": []}, ("QUANTITIES is empty", "thickness")),
        ({"QUANTITIES": ["colour"]}, ("QUANTITIES", "colour")),
        ({"TARGET": "20,40 [EPSG:4326]"}, ("target", "off the DEM")),
        ({"TARGET": None}, ("TARGET is missing",)),
        ({"MAX_RANGE": 0}, ("maximum range of 0 m",)),
        ({"ELEVATION_APERTURE": 178}, ("None of the 3 sites", "past ±90°")),
    ],
)
def test_values_that_cannot_be_used(run, survey, change, words):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException) as caught:
        run("radiographyatsites", {**survey, **change})
    said = str(caught.value).replace("Unable to execute algorithm\n", "")
    assert "\n" not in said.strip()
    for word in words:
        assert word in said
    assert not Path(survey["FOLDER"]).exists()


def test_a_layer_without_points_is_refused(run, survey, tmp_path):
    from qgis.core import QgsProcessingException

    empty = write_sites(tmp_path / "empty.gpkg", [])
    with pytest.raises(QgsProcessingException, match="is empty"):
        run("radiographyatsites", {**survey, "SITES": empty})


def test_metadata_and_help(provider):
    algorithm = provider.algorithm("radiographyatsites")
    assert algorithm.group() == "Survey"
    assert "index" in algorithm.shortHelpString()


def test_a_temporary_folder_will_do(run, survey):
    done = run("radiographyatsites", {**survey, "FOLDER": "TEMPORARY_OUTPUT", "INDEX": None})
    assert len(list(Path(done["FOLDER"]).glob("*.tif"))) == 9
    assert "INDEX" not in done


def test_worker_processes_change_nothing(run, survey, tmp_path):
    places = [((14.40 + 0.005 * step, 40.81), None, 1.0) for step in range(10)]
    many = {
        **survey,
        "SITES": write_sites(tmp_path / "many.gpkg", places),
        "AZIMUTH_PIXELS": 6,
        "ELEVATION_PIXELS": 4,
    }
    alone = run("radiographyatsites", {**many, "WORKERS": 0})
    shared = {"FOLDER": str(tmp_path / "shared"), "INDEX": str(tmp_path / "shared.gpkg")}
    together = run("radiographyatsites", {**many, "WORKERS": 2, **shared})
    assert rows(together["INDEX"]) == rows(alone["INDEX"])
    files = sorted(Path(alone["FOLDER"]).glob("*.tif"))
    assert len(files) == 30
    for file in files:
        values, metadata = read(file)
        others, other_metadata = read(Path(together["FOLDER"]) / file.name)
        np.testing.assert_array_equal(others, values)
        assert other_metadata == metadata


def test_a_single_site_tells_its_progress(run, survey, tmp_path, recorder):
    feedback = recorder()
    one = write_sites(tmp_path / "one.gpkg", PLACES[:1])
    run("radiographyatsites", {**survey, "SITES": one}, feedback)
    assert any(0 < percent < 80 for percent in feedback.percents)
