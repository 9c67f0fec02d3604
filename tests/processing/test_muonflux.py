"""Flux from a muogram alone is the flux that radiography gives."""

import numpy as np
import pytest
from osgeo import gdal

gdal.UseExceptions()

SAME = ("MINIMUM_ENERGY", "FLUX", "OPEN_SKY", "TRANSMISSION", "EXPOSURE")


def read(path):
    return gdal.Open(str(path)).ReadAsArray().astype(float)


@pytest.fixture
def radiography(run, vesuvius, tmp_path):
    def simulate(**change):
        names = ("THICKNESS", "OPACITY", *SAME)
        paths = {name: str(tmp_path / f"first_{name}.tif") for name in names}
        return run("radiography", {**vesuvius, **change, **paths})

    return simulate


@pytest.mark.parametrize("source", ["THICKNESS", "OPACITY"])
@pytest.mark.parametrize(
    "physics",
    [
        {},
        {"FLUX_MODEL": "guan", "STRAGGLING": False, "ALTITUDE_CORRECTION": False},
        {"FLUX_MODEL": "reyna-bugaev", "ENERGY_LOSS": "lesparre", "DETECTION_THRESHOLD": 1},
        {"MATERIAL": "basalt", "DENSITY": 2.2, "MUONS": 100, "ACCEPTANCE": 12},
    ],
)
def test_the_same_physics_gives_the_same_flux(run, radiography, tmp_path, source, physics):
    first = radiography(**physics)
    paths = {name: str(tmp_path / f"second_{name}.tif") for name in SAME}
    second = run("muonflux", {source: first[source], **physics, **paths})
    for name in SAME:
        one, two = read(first[name]), read(second[name])
        assert np.array_equal(np.isnan(one), np.isnan(two))
        # Rasters hold 24 bits; the flux changes four times as fast as the opacity.
        np.testing.assert_allclose(two, one, rtol=2e-6)
    assert second["ROCK_PIXELS"] == first["ROCK_PIXELS"]


def test_documents_need_no_dem(run, radiography, tmp_path):
    first = radiography()
    results = run(
        "muonflux",
        {
            "THICKNESS": first["THICKNESS"],
            "FLUX": str(tmp_path / "f.tif"),
            "OPACITY_OUTPUT": str(tmp_path / "o.tif"),
            "PANEL": str(tmp_path / "p.png"),
            "REPORT": str(tmp_path / "r.html"),
        },
    )
    assert (tmp_path / "p.png").stat().st_size > 10_000
    assert "Peña-Rodríguez" in (tmp_path / "r.html").read_text(encoding="utf-8")
    np.testing.assert_allclose(read(results["OPACITY_OUTPUT"]), read(first["OPACITY"]), rtol=1e-6)


@pytest.mark.parametrize(
    ("inputs", "words"),
    [
        ((), "Neither THICKNESS nor OPACITY is given"),
        (("THICKNESS", "OPACITY"), "Both THICKNESS and OPACITY are given"),
    ],
)
def test_exactly_one_muogram_is_taken(run, radiography, tmp_path, inputs, words):
    from qgis.core import QgsProcessingException

    first = radiography()
    with pytest.raises(QgsProcessingException, match=words):
        run("muonflux", {name: first[name] for name in inputs} | {"FLUX": str(tmp_path / "f.tif")})
    assert not (tmp_path / "f.tif").exists()


def test_a_muogram_of_another_quantity_is_named(run, radiography, tmp_path):
    from qgis.core import QgsProcessingException

    first = radiography()
    with pytest.raises(QgsProcessingException, match="a muogram of flux; choose one of thickness"):
        run("muonflux", {"THICKNESS": first["FLUX"], "FLUX": str(tmp_path / "f.tif")})


def test_a_muogram_without_its_detector_needs_the_elevation(run, radiography, tmp_path):
    from qgis.core import QgsProcessingException

    first = radiography()
    bare = tmp_path / "bare.tif"
    gdal.Translate(str(bare), first["THICKNESS"])
    dataset = gdal.Open(str(bare), gdal.GA_Update)
    dataset.SetMetadata({"QUANTITY": "thickness"}, "MUYSC")
    del dataset
    with pytest.raises(QgsProcessingException, match="metadata key DETECTOR_ELEVATION"):
        run("muonflux", {"THICKNESS": str(bare), "FLUX": str(tmp_path / "f.tif")})
    run(
        "muonflux",
        {"THICKNESS": str(bare), "DETECTOR_ELEVATION": 604.04, "FLUX": str(tmp_path / "f.tif")},
    )
    np.testing.assert_allclose(read(tmp_path / "f.tif"), read(first["FLUX"]), rtol=1e-5)
