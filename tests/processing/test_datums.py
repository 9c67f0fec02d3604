"""Points in, points out: a DEM on another datum, and the transformation that QGIS chose."""

import re
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr, osr
from pyproj import Geod, Transformer

gdal.UseExceptions()
ogr.UseExceptions()

WGS84 = Geod(ellps="WGS84")

#: Around Mount St. Helens, WGS 84: flanks and the crater.
PLACES = [(-122.2, 46.18), (-122.21, 46.195), (-122.178, 46.2)]
CRATER = (-122.1944, 46.1910)

#: How far (m) a point may come out from where it went in.
CLOSE_M = 0.1

#: From NAD27 / UTM zone 10N, by what the register of PROJ calls NAD27 to WGS 84 (13).
_CHOSEN = (
    "+proj=pipeline +step +inv +proj=utm +zone=10 +ellps=clrk66 +step +proj=push +v_3 "
    "+step +proj=cart +ellps=clrk66 +step +proj=helmert +x=4 +y=159 +z=188 "
    "+step +inv +proj=cart +ellps=WGS84 +step +proj=pop +v_3 "
)
CHOSEN = _CHOSEN + "+step +proj=unitconvert +xy_in=rad +xy_out=deg"
#: What QGIS takes where nothing was chosen, NAD27 to WGS 84 (3).
QGIS_OPERATION = Transformer.from_pipeline(
    CHOSEN.replace("x=4 ", "x=-10 ").replace("y=159", "y=158").replace("z=188", "z=187")
)
CHOSEN_TO_MAP = _CHOSEN + "+step +proj=webmerc +lat_0=0 +lon_0=0 +x_0=0 +y_0=0 +ellps=WGS84"
CHOSEN_BACK = (
    "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=push +v_3 "
    "+step +proj=cart +ellps=WGS84 +step +proj=helmert +x=-4 +y=-159 +z=-188 "
    "+step +inv +proj=cart +ellps=clrk66 +step +proj=pop +v_3 "
    "+step +proj=utm +zone=10 +ellps=clrk66"
)


def text(place, crs="EPSG:4326"):
    """Return a WGS 84 place as Processing reads it, in another system."""
    x, y = Transformer.from_crs(4326, crs, always_xy=True).transform(*place)
    return f"{x!r},{y!r} [{crs}]"


def metres(one, other):
    return WGS84.inv(*one, *other)[2]


def told(path):
    return gdal.Open(str(path)).GetMetadata("MUYSC")


def place_of(path, what="DETECTOR"):
    metadata = told(path)
    return float(metadata[f"{what}_LON"]), float(metadata[f"{what}_LAT"])


@pytest.fixture
def helens(data_folder, tmp_path):
    """The main job on terrain in NAD27 / UTM, few rays."""
    return {
        "DEM": str(data_folder / "st_helens_usgs.tif"),
        "DETECTOR": text(PLACES[0]),
        "TARGET": text(CRATER),
        "AZIMUTH_PIXELS": 3,
        "ELEVATION_PIXELS": 3,
        "THICKNESS": str(tmp_path / "thickness.tif"),
        "FLUX": str(tmp_path / "flux.tif"),
    }


@pytest.fixture
def run_in(provider, recorder):
    """Run in a context of its own: a project, and pairs of systems with their operations."""
    import processing
    from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingContext, QgsProject

    def run(name, parameters, project_crs="", operations=()):
        project = QgsProject()
        project.setCrs(QgsCoordinateReferenceSystem(project_crs))
        chosen = project.transformContext()
        for source, target, operation in operations:
            ends = map(QgsCoordinateReferenceSystem, (source, target))
            assert chosen.addCoordinateOperation(*ends, operation)
        project.setTransformContext(chosen)
        context = QgsProcessingContext()
        context.setProject(project)
        feedback = recorder()
        done = processing.run(f"muysc:{name}", parameters, feedback=feedback, context=context)
        return done, feedback

    return run


# NAD83 counts as WGS 84 to some metres, and is on the way to it the same.
@pytest.mark.parametrize("crs", ["EPSG:4326", "EPSG:3857", "EPSG:32610", "EPSG:4269"])
def test_a_point_comes_out_where_it_went_in(run, helens, crs):
    done = run(
        "radiography", {**helens, "DETECTOR": text(PLACES[0], crs), "TARGET": text(CRATER, crs)}
    )
    for output in ("THICKNESS", "FLUX"):
        assert metres(place_of(done[output]), PLACES[0]) < CLOSE_M
        assert metres(place_of(done[output], "TARGET"), CRATER) < CLOSE_M


@pytest.mark.parametrize("crs", ["EPSG:26710", "EPSG:4267", "EPSG:26711"])
def test_points_on_the_datum_of_the_dem_are_not_touched(run, helens, crs):
    # Wherever the same ground is named in, the muogram is the same.
    place = (561_816.0, 5_114_156.0)
    x, y = Transformer.from_crs(26710, crs, always_xy=True).transform(*place)
    done = run("radiography", {**helens, "DETECTOR": f"{x!r},{y!r} [{crs}]"})
    metadata = told(done["FLUX"])
    longitude, latitude = place_of(done["FLUX"])
    # By what the muogram says of itself, looked up in the register.
    assert metadata["TRANSFORMATION"] == "NAD27 to WGS 84 (3)"
    assert metres((longitude, latitude), QGIS_OPERATION.transform(*place)) < 0.001


def test_metadata_and_report_name_the_operation_of_qgis_and_its_accuracy(run, helens, tmp_path):
    from qgis.core import (
        QgsCoordinateReferenceSystem,
        QgsCoordinateTransform,
        QgsCoordinateTransformContext,
    )  # fmt: skip

    report = tmp_path / "report.html"
    done = run("radiography", {**helens, "REPORT": str(report)})
    ends = map(QgsCoordinateReferenceSystem, ("EPSG:26710", "EPSG:4326"))
    transform = QgsCoordinateTransform(*ends, QgsCoordinateTransformContext())
    qgis = transform.instantiatedCoordinateOperationDetails()
    metadata = told(done["FLUX"])
    assert metadata["TRANSFORMATION"] in qgis.name
    assert "NAD27 to WGS 84" in metadata["TRANSFORMATION"]
    assert float(metadata["TRANSFORMATION_ACCURACY"]) == qgis.accuracy
    html = report.read_text(encoding="utf-8")
    assert metadata["TRANSFORMATION"] in html
    accuracy = re.search(r"Accuracy of the transformation</th><td[^>]*>(\S+)</td><td>m<", html)
    assert float(accuracy[1]) == qgis.accuracy


def test_on_wgs84_nothing_is_said(run, vesuvius, tmp_path):
    report = tmp_path / "report.html"
    outputs = {"THICKNESS": tmp_path / "t.tif", "FLUX": tmp_path / "f.tif", "REPORT": report}
    done = run("radiography", {**vesuvius, **{name: str(path) for name, path in outputs.items()}})
    assert not [key for key in told(done["FLUX"]) if key.startswith("TRANSF")]
    assert "ransformation" not in report.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("project_crs", "operation"),
    [
        ("", ("EPSG:26710", "EPSG:4326", CHOSEN)),
        ("", ("EPSG:4326", "EPSG:26710", CHOSEN_BACK)),
        ("EPSG:3857", ("EPSG:26710", "EPSG:4326", CHOSEN)),
        # So QGIS keeps what the user chose when the layer was added to the map.
        ("EPSG:3857", ("EPSG:26710", "EPSG:3857", CHOSEN_TO_MAP)),
    ],
)
@pytest.mark.parametrize("crs", ["EPSG:4326", "EPSG:3857"])
def test_what_the_project_chose_counts_in_both_directions(
    run_in, helens, project_crs, operation, crs
):
    job = {**helens, "DETECTOR": text(PLACES[0], crs), "TARGET": text(CRATER, crs)}
    chosen, _ = run_in("radiography", job, project_crs, [operation])
    metadata = told(chosen["FLUX"])
    assert metadata["TRANSFORMATION"].endswith("NAD27 to WGS 84 (13)")
    assert float(metadata["TRANSFORMATION_ACCURACY"]) == 8
    assert metres(place_of(chosen["FLUX"]), PLACES[0]) < CLOSE_M
    # The detector stands on other ground than without the choice: what it sees differs.
    there = Transformer.from_pipeline(CHOSEN).transform(*PLACES[0], direction="INVERSE")
    job = {**helens, "DETECTOR": f"{there[0]!r},{there[1]!r} [EPSG:26710]"}
    same, _ = run_in("radiography", job, project_crs, [operation])
    assert same["DETECTOR_ELEVATION"] == pytest.approx(chosen["DETECTOR_ELEVATION"], abs=0.01)
    assert metres(place_of(same["FLUX"]), PLACES[0]) < CLOSE_M


def test_a_chosen_grid_that_is_missing_gives_way_for_both_directions(run_in, helens):
    gone = CHOSEN.partition("+step +proj=push")[0] + (
        "+step +proj=hgridshift +grids=no_such_grid.tif "
        "+step +proj=unitconvert +xy_in=rad +xy_out=deg"
    )
    done, _ = run_in("radiography", helens, "", [("EPSG:26710", "EPSG:4326", gone)])
    assert "no_such_grid" not in told(done["FLUX"])["TRANSFORMATION"]
    assert metres(place_of(done["FLUX"]), PLACES[0]) < CLOSE_M


def test_a_grid_in_a_folder_of_the_user_counts(run_in, helens, tmp_path):
    folder = tmp_path / "grids of mine"
    folder.mkdir()
    grid = folder / "here.gsb"
    # 3.6″ to the north everywhere, and 7.2″ to the west.
    shift = gdal.GetDriverByName("NTv2").Create(str(grid), 9, 9, 4, gdal.GDT_Float32)
    shift.SetGeoTransform((-124.5, 0.5, 0, 48.5, 0, -0.5))
    for band, seconds in ((1, 3.6), (2, 7.2), (3, 0.0), (4, 0.0)):
        shift.GetRasterBand(band).Fill(seconds)
    shift = None
    operation = CHOSEN.partition("+step +proj=push")[0] + (
        f'+step +proj=hgridshift +grids="{grid}" +step +proj=unitconvert +xy_in=rad +xy_out=deg'
    )
    done, _ = run_in("radiography", helens, "", [("EPSG:26710", "EPSG:4326", operation)])
    assert told(done["FLUX"])["TRANSFORMATION_ACCURACY"] == "unknown"
    assert metres(place_of(done["FLUX"]), PLACES[0]) < CLOSE_M
    # 111 m to the north: the ground that it stands on lies south of where it would else.
    there = Transformer.from_pipeline(operation).transform(*PLACES[0], direction="INVERSE")
    plain = Transformer.from_crs(4267, 26710, always_xy=True).transform(*PLACES[0])
    assert plain[1] - there[1] == pytest.approx(111, abs=5)


def test_an_operation_of_unknown_accuracy_is_warned_of(run_in, helens, tmp_path):
    ballpark = CHOSEN.partition("+step +proj=push")[0] + (
        "+step +proj=unitconvert +xy_in=rad +xy_out=deg"
    )
    report = tmp_path / "report.html"
    done, feedback = run_in(
        "radiography", {**helens, "REPORT": str(report)}, "",
        [("EPSG:26710", "EPSG:4326", ballpark)],
    )  # fmt: skip
    metadata = told(done["FLUX"])
    assert metadata["TRANSFORMATION"] == "Ballpark geographic offset from NAD27 to WGS 84"
    assert metadata["TRANSFORMATION_ACCURACY"] == "unknown"
    assert [one for one in feedback.warnings if "Ballpark" in one and "unknown" in one]
    assert "is unknown" in report.read_text(encoding="utf-8")
    assert metres(place_of(done["FLUX"]), PLACES[0]) < CLOSE_M


def test_a_point_without_a_code_is_in_the_system_of_the_project(run_in, helens):
    bare = {
        name: text(place, "EPSG:3857").partition(" ")[0]
        for name, place in (("DETECTOR", PLACES[0]), ("TARGET", CRATER))
    }
    done, feedback = run_in("radiography", {**helens, **bare}, "EPSG:3857")
    assert metres(place_of(done["FLUX"]), PLACES[0]) < CLOSE_M
    assert [one for one in feedback.infos if "EPSG:3857 was assumed" in one]


def test_a_point_of_a_third_datum_says_how_it_came(run, helens, vesuvius, feedback, tmp_path):
    run("radiography", {**helens, "DETECTOR": text(PLACES[0], "EPSG:4269")}, feedback)
    (note,) = [one for one in feedback.infos if one.startswith("DETECTOR")]
    assert "EPSG:4269" in note
    assert "NAD83 to WGS 84 (1), accurate to 4 m" in note
    job = {**vesuvius, "THICKNESS": str(tmp_path / "t.tif"), "FLUX": str(tmp_path / "f.tif")}
    run("radiography", {**job, "TARGET": text((14.424745, 40.823729), "EPSG:25833")}, feedback)
    (note,) = [one for one in feedback.infos if one.startswith("TARGET")]
    assert "to the DEM by ETRS89 to WGS 84 (1), accurate to 1 m" in note


def test_a_point_that_is_nowhere_is_told_in_a_sentence(run, helens):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match=r"DETECTOR \(.*cannot be transformed"):
        run("radiography", {**helens, "DETECTOR": "1e9,1e9 [EPSG:32610]"})


def write_points(path, places, epsg=4326):
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(epsg)
    source = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
    layer = source.CreateLayer("places", reference, ogr.wkbPoint)
    to_own = Transformer.from_crs(4326, epsg, always_xy=True)
    for place in places:
        feature = ogr.Feature(layer.GetLayerDefn())
        point = ogr.Geometry(ogr.wkbPoint)
        point.AddPoint_2D(*to_own.transform(*place))
        feature.SetGeometry(point)
        layer.CreateFeature(feature)
    return str(path)


# One process, and two that are handed the terrain.
@pytest.mark.parametrize(("epsg", "workers"), [(4326, 0), (32610, 2)])
def test_sites_of_a_layer_come_out_where_they_went_in(run, helens, tmp_path, epsg, workers):
    folder = tmp_path / "muograms"
    run(
        "radiographyatsites",
        {
            **{name: helens[name] for name in helens if name not in ("DETECTOR", "FLUX")},
            "SITES": write_points(tmp_path / "sites.gpkg", PLACES, epsg),
            "QUANTITIES": ["flux"],
            "WORKERS": workers,
            "FOLDER": str(folder),
        },
    )
    files = sorted(folder.glob("site_*.tif"))
    assert len(files) == len(PLACES)
    for file, place in zip(files, PLACES):
        assert metres(place_of(file), place) < CLOSE_M
        assert told(file)["TRANSFORMATION"] == "NAD27 to WGS 84 (3)"


def test_a_muogram_that_is_draped_lies_where_its_detector_looks(run, helens, tmp_path):
    # From the north into the crater; half a degree a pixel.
    place = (-122.19, 46.22)
    view = {
        "DETECTOR": text(place), "DETECTOR_HEIGHT": 3, "AZIMUTH_APERTURE": 20,
        "ELEVATION_APERTURE": 10, "AZIMUTH_PIXELS": 40, "ELEVATION_PIXELS": 20,
    }  # fmt: skip
    done = run("radiography", {**helens, **view, "DISTANCE": str(tmp_path / "distance.tif")})
    muogram = gdal.Open(done["DISTANCE"])
    assert metres(place_of(done["DISTANCE"]), place) < CLOSE_M
    draped = run(
        "drape",
        {"MUOGRAM": done["DISTANCE"], "DEM": helens["DEM"], "OUTPUT": str(tmp_path / "d.tif")},
    )
    raster = gdal.Open(draped["OUTPUT"])
    left, step_x, _, top, _, step_y = raster.GetGeoTransform()
    values = raster.ReadAsArray()
    row, column = np.nonzero(np.isfinite(values))
    assert len(row) == draped["CELLS"] > 0
    # Cells that carry a value lie in the aperture, seen from WGS 84 by the same operation.
    cells = QGIS_OPERATION.transform(left + step_x * (column + 0.5), top + step_y * (row + 0.5))
    origin = [np.full(len(row), one) for one in place]
    azimuth, _, distance = WGS84.inv(*origin, *cells)
    first, width = muogram.GetGeoTransform()[:2]
    across = (azimuth - first) % 360 / width
    assert 0 <= across.min() <= across.max() <= muogram.RasterXSize
    # Slant distances, along the ray of the pixel's centre: some cells beside.
    level = distance / np.cos(np.radians(float(told(done["DISTANCE"])["BORESIGHT_ELEVATION"])))
    assert np.median(np.abs(level - values[row, column])) < 60


def test_counts_in_a_telescope_stand_where_the_point_was(run, helens, tmp_path):
    counts = run(
        "expectedcounts",
        {
            **{name: helens[name] for name in ("DEM", "DETECTOR", "TARGET")},
            "BARS_X": 4, "COUNTS": str(tmp_path / "counts.tif"),
            "REPORT": str(tmp_path / "counts.html"),
        },
    )  # fmt: skip
    assert metres(place_of(counts["COUNTS"]), PLACES[0]) < CLOSE_M
    assert "NAD27 to WGS 84 (3)" in Path(counts["REPORT"]).read_text(encoding="utf-8")


def test_candidates_of_a_survey_come_out_where_they_went_in(run, helens, tmp_path):
    done = run(
        "siteselection",
        {
            **{name: helens[name] for name in ("DEM", "TARGET", "AZIMUTH_PIXELS")},
            "ELEVATION_PIXELS": 3,
            "CANDIDATES": write_points(tmp_path / "candidates.gpkg", PLACES),
            "MIN_DISTANCE": 0, "MAX_DISTANCE": 4000, "SPACING": 50, "MAXIMUM_THICKNESS": 5000,
            "SITES_WANTED": len(PLACES), "SITES_APART": 0, "WORKERS": 0,
            "SCORE": str(tmp_path / "score.tif"), "BEST_SITES": str(tmp_path / "best.gpkg"),
            "REPORT": str(tmp_path / "report.html"),
        },
    )  # fmt: skip
    assert "NAD27 to WGS 84 (3)" in Path(done["REPORT"]).read_text(encoding="utf-8")
    assert told(done["SCORE"])["TRANSFORMATION"] == "NAD27 to WGS 84 (3)"
    # The layer is on the terrain's datum, in metres; the operation's own pipeline leads back.
    source = ogr.Open(done["BEST_SITES"])
    layer = source.GetLayer()
    assert "NAD27" in layer.GetSpatialRef().GetName()
    found = [QGIS_OPERATION.transform(*feature.geometry().GetPoint_2D()) for feature in layer]
    assert found
    for place in found:
        assert min(metres(place, one) for one in PLACES) < CLOSE_M
