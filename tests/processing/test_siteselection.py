"""Where to put the telescope: maps, sites, limits, going on after a stop, bad input."""

import json
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr, osr

gdal.UseExceptions()
ogr.UseExceptions()

MAPS = (
    "SCORE", "EXPOSURE", "SHARE_SEEN", "THICKNESS", "SMALLEST_THICKNESS", "LARGEST_THICKNESS",
    "FREE_SKY",
)  # fmt: skip


def read(path):
    return gdal.Open(str(path)).ReadAsArray().astype(float)


def rows(path):
    source = ogr.Open(str(path))
    return [
        {**feature.items(), "place": feature.geometry().GetPoint_2D()}
        for feature in source.GetLayer()
    ]


@pytest.fixture
def survey(vesuvius, tmp_path):
    """A ring of some 50 candidates around the Gran Cono, coarse rays, in this process."""
    plain = {name: value for name, value in vesuvius.items() if name != "DETECTOR"}
    return {
        **plain,
        "MIN_DISTANCE": 1500,
        "MAX_DISTANCE": 2500,
        "SPACING": 500,
        "WORKERS": 0,
        "SITES_WANTED": 4,
        "SITES_APART": 600,
        "SCORE": str(tmp_path / "score.tif"),
    }


@pytest.fixture
def everything(survey, tmp_path):
    return {
        **survey,
        **{name: str(tmp_path / f"{name.lower()}.tif") for name in MAPS},
        "BEST_SITES": str(tmp_path / "best.gpkg"),
        "TELESCOPE_SITES": str(tmp_path / "telescopes.gpkg"),
    }


def test_panel_and_report_are_written(run, survey, tmp_path):
    documents = {"PANEL": str(tmp_path / "panel.png"), "REPORT": str(tmp_path / "report.html")}
    done = run("siteselection", {**survey, "SPACING": 700, **documents})
    assert gdal.Open(done["PANEL"]).RasterXSize >= 1200
    report = Path(done["REPORT"]).read_text(encoding="utf-8")
    for words in ("Where to put the telescope", "Radius of the target body", "Telescope 1"):
        assert words in report


def test_maps_lie_on_one_metric_grid_with_a_cell_for_each_candidate(run, everything):
    done = run("siteselection", everything)
    score = read(done["SCORE"])
    assert np.isfinite(score).sum() == done["CANDIDATES_DONE"] > 20
    for name in MAPS:
        dataset = gdal.Open(done[name])
        # The DEM is geographic: the map is in the UTM zone of the target.
        assert dataset.GetSpatialRef().GetAuthorityCode(None) == "32633"
        left, step_x, _, top, _, step_y = dataset.GetGeoTransform()
        assert (step_x, step_y, left % 500, top % 500) == (500, -500, 0, 0)
        assert Path(done[name]).with_suffix(".qml").exists()
    for name in ("SCORE", "SHARE_SEEN", "FREE_SKY"):
        values = read(done[name])
        assert np.nanmin(values) >= 0
        assert np.nanmax(values) <= 1
    assert np.all(score[np.isfinite(score)] <= read(done["SHARE_SEEN"])[np.isfinite(score)])
    known = np.isfinite(read(done["THICKNESS"]))
    order = [read(done[f"{word}THICKNESS"])[known] for word in ("SMALLEST_", "", "LARGEST_")]
    assert np.all(np.diff(order, axis=0) >= 0)
    assert done["CANDIDATES_SEEING"] == np.count_nonzero(read(done["SHARE_SEEN"]) > 0)


def test_best_sites_are_the_highest_scores_and_apart(run, everything):
    done = run("siteselection", everything)
    best = rows(done["BEST_SITES"])
    assert [row["rank"] for row in best] == [1, 2, 3, 4]
    assert [row["site"] for row in best] == ["site_01", "site_02", "site_03", "site_04"]
    scores = [row["score"] for row in best]
    assert scores == sorted(scores, reverse=True)
    assert scores[0] == done["BEST_SCORE"] == pytest.approx(np.nanmax(read(done["SCORE"])), 1e-6)
    places = np.array([row["place"] for row in best])
    apart = np.hypot(*(places[:, None] - places[None]).T)
    assert np.all(apart[~np.eye(4, dtype=bool)] >= 600)
    assert all(1500 <= row["distance_m"] <= 2500 for row in best)
    assert all(row["slope_deg"] <= 30 for row in best)


def test_the_telescopes_are_sites_for_muograms(run, everything, vesuvius, tmp_path):
    done = run("siteselection", everything)
    together = rows(done["TELESCOPE_SITES"])
    assert [row["site"] for row in together] == ["telescope_01", "telescope_02", "telescope_03"]
    assert np.all(np.diff([row["coverage"] for row in together]) > 0)
    assert done["COVERAGE"] == together[-1]["coverage"]
    plain = {name: value for name, value in vesuvius.items() if name != "DETECTOR"}
    muograms = run(
        "radiographyatsites",
        {
            **plain,
            "SITES": done["TELESCOPE_SITES"],
            "NAME_FIELD": "site",
            "FOLDER": str(tmp_path / "muograms"),
            "INDEX": str(tmp_path / "index.gpkg"),
        },
    )
    assert (muograms["SITES_DONE"], muograms["SITES_SKIPPED"]) == (3, 0)
    index = rows(muograms["INDEX"])
    for row, site in zip(index, together):
        assert row["detector_elevation_m"] == pytest.approx(site["detector_elevation_m"], abs=1e-3)
        assert row["distance_m"] == pytest.approx(site["distance_m"], abs=1e-2)


def test_worker_processes_change_nothing(run, everything, tmp_path):
    alone = run("siteselection", everything)
    values = {name: read(alone[name]) for name in MAPS}
    with_workers = run("siteselection", {**everything, "WORKERS": 2})
    for name in MAPS:
        np.testing.assert_array_equal(read(with_workers[name]), values[name])
    assert not list(tmp_path.glob("*.partial"))


def test_a_survey_that_was_stopped_goes_on(run, survey, tmp_path, recorder, feedback):
    from qgis.core import QgsProcessingException

    survey["SPACING"] = 350
    with pytest.raises(QgsProcessingException, match="Cancelled"):
        run("siteselection", survey, recorder(cancel_at=60))
    partial = Path(f"{survey['SCORE']}.partial")
    kept = {path: path.stat().st_mtime_ns for path in partial.glob("block_*.json")}
    assert kept
    assert not Path(survey["SCORE"]).exists()
    done = run("siteselection", survey, feedback)
    said = " ".join(feedback.infos)
    assert f"{32 * len(kept)} of {done['CANDIDATES_DONE']} candidates were finished" in said
    assert not partial.exists()
    fresh = run("siteselection", {**survey, "SCORE": str(tmp_path / "fresh.tif")})
    np.testing.assert_array_equal(read(done["SCORE"]), read(fresh["SCORE"]))


def test_other_parameters_start_anew(run, survey, recorder, feedback):
    from qgis.core import QgsProcessingException

    survey["SPACING"] = 350
    with pytest.raises(QgsProcessingException, match="Cancelled"):
        run("siteselection", survey, recorder(cancel_at=60))
    run("siteselection", {**survey, "DENSITY": 2.0}, feedback)
    assert not any("earlier run" in text for text in feedback.infos)


def write_lines(path, lines):
    """Write a GeoJSON of lines given by longitude and latitude; None is no geometry."""
    features = [
        {
            "type": "Feature",
            "properties": {},
            "geometry": line and {"type": "LineString", "coordinates": line},
        }
        for line in lines
    ]
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
    return str(path)


def test_roads_and_mask_leave_what_is_near_and_inside(run, everything, tmp_path, feedback):
    road = write_lines(tmp_path / "road.geojson", [None, [[14.40, 40.80], [14.40, 40.85]]])
    mask = str(tmp_path / "mask.tif")
    dataset = gdal.GetDriverByName("GTiff").Create(mask, 2, 2, 1, gdal.GDT_Byte)
    dataset.SetGeoTransform((14.35, 0.1, 0, 40.823729, 0, -0.1))
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(4326)
    dataset.SetSpatialRef(reference)
    dataset.GetRasterBand(1).WriteArray(np.array([[1, 1], [0, 0]]))
    dataset = None
    done = run(
        "siteselection",
        {**everything, "ROADS": road, "ROAD_DISTANCE": 400, "MASK": mask, "SITES_APART": 0},
        feedback,
    )
    for row in rows(done["BEST_SITES"]):
        assert row["road_m"] <= 400
        assert 180 < row["azimuth_deg"] < 360  # the road runs west of the target
    said = " ".join(feedback.infos)
    assert "outside the mask" in said
    assert "farther than 400 m from a road" in said


def test_candidates_may_be_points(run, everything, tmp_path):
    places = [[14.410686, 40.810561], [14.4390, 40.8150], [14.4247, 40.8240]]
    path = tmp_path / "points.geojson"
    features = [
        {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": place}}
        for place in places
    ]
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
    done = run("siteselection", {**everything, "CANDIDATES": str(path), "MAX_SLOPE": None})
    # The third lies in the middle of the target, nearer than the limit allows.
    assert done["CANDIDATES_DONE"] == 2
    assert np.isfinite(read(done["SCORE"])).sum() == 2


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"TARGET": "20,40 [EPSG:4326]"}, ("target", "off the DEM")),
        ({"MIN_DISTANCE": 3000}, ("from 3000 to 2500 m",)),
        ({"SPACING": 0}, ("spacing of 0 m",)),
        ({"SPACING": 0.5}, ("0.5 m", "1,000,000", "at least")),
        ({"MAX_SLOPE": 0.01}, ("None of", "steeper than 0.01°", "loosen")),
        ({"ABOVE_TARGET": -2000}, ("more than -2000 m above the target",)),
        ({"TARGET_RADIUS": 0}, ("radius of 0 m",)),
        ({"MINIMUM_THICKNESS": 2000}, ("from 2000 to 1000 m",)),
        ({"MINIMUM_THICKNESS": 4000, "MAXIMUM_THICKNESS": 4001}, ("None of", "sees", "median")),
        ({"DAYS": 0}, ("days of the campaign is 0",)),
        ({"SITES_WANTED": 0}, ("0 best sites",)),
        ({"COVERED_ANGLE": 0}, ("angle of 0°",)),
        ({"WORKERS": -1}, ("-1 worker",)),
        ({"ELEVATION_APERTURE": 178}, ("candidates can be used", "past ±90°")),
        ({"SCORE": "score.png"}, ("score.png", ".tif")),
    ],
)  # fmt: skip
def test_values_that_cannot_be_used(run, survey, change, words):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException) as caught:
        run("siteselection", {**survey, **change})
    said = str(caught.value).replace("Unable to execute algorithm\n", "")
    assert "\n" not in said.strip()
    for word in words:
        assert word in said
    assert not Path(survey["SCORE"]).exists()


def test_it_stands_among_the_surveys(provider):
    assert provider.algorithm("siteselection").group() == "Survey"


def test_sites_arrive_marked_and_named_in_a_project(provider, everything, recorder):
    """What the desktop does: run with a project, then post-process the loaded layers."""
    from qgis.core import (
        QgsProcessingContext,
        QgsProcessingOutputLayerDefinition,
        QgsProcessingUtils,
        QgsProject,
    )

    project, context, feedback = QgsProject(), QgsProcessingContext(), recorder()
    context.setProject(project)
    names = ("SCORE", "BEST_SITES", "TELESCOPE_SITES")
    wanted = {name: QgsProcessingOutputLayerDefinition(everything[name], project) for name in names}
    algorithm = provider.algorithm("siteselection").create()
    _, done = algorithm.run({**everything, **wanted, "SPACING": 700}, context, feedback)
    assert done
    looks = {}
    for identifier, details in context.layersToLoadOnCompletion().items():
        layer = QgsProcessingUtils.mapLayerFromString(identifier, context)
        details.postProcessor().postProcessLayer(layer, context, feedback)
        looks[details.outputName] = layer.renderer().type()
        if details.outputName != "SCORE":
            assert layer.labelsEnabled()
            assert layer.labeling().settings().fieldName == "site"
    assert looks == {
        "SCORE": "singlebandpseudocolor",
        "BEST_SITES": "singleSymbol",
        "TELESCOPE_SITES": "singleSymbol",
    }
