"""Each algorithm where a library is missing: it does what it can, or says what to install."""

import sys
from pathlib import Path

import pytest
from osgeo import ogr, osr

from muysc_qgis.muogram import write_muogram
from muysc_qgis.radiography.aperture import Aperture
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.topography.dem import open_dem
from muysc_qgis.topography.frame import from_wgs84
from muysc_qgis.topography.sight import take_sight
from muysc_qgis.workflows.simulation import Telescope, simulate

DEM = Path(__file__).resolve().parent.parent / "data" / "vesuvius_srtmgl1.tif"
DETECTOR, TARGET = (14.410686, 40.810561), (14.424745, 40.823729)
SIGHT = {
    "DEM": str(DEM),
    "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
    "TARGET": "14.424745,40.823729 [EPSG:4326]",
}
COARSE = {"AZIMUTH_PIXELS": 8, "ELEVATION_PIXELS": 6}
AROUND = {name: SIGHT[name] for name in ("DEM", "TARGET")} | COARSE
CONE = {
    "EXTENT": "450600,452700,4518000,4520100 [EPSG:32633]",
    "VOXEL_SIZE": 300, "BASE": 700, "TOP": 1300, "ITERATIONS": 2,
}  # fmt: skip

#: Inputs by algorithm; a word that names a prepared file stands for it.
JOBS = {
    "radiography": {**SIGHT, **COARSE},
    "muonflux": {"THICKNESS": "thickness.tif"},
    "drape": {"DEM": str(DEM), "MUOGRAM": "flux.tif"},
    "importmuogram": {"INPUT": "table.csv"},
    "density": {"FLUX": "flux.tif", "THICKNESS": "thickness.tif"},
    "telescope": {"PRESET": "custom", "BARS_X": 4, "PIXEL_SIZE": 10, "SEPARATION": 200},
    "expectedcounts": {
        **SIGHT, "PRESET": "custom", "BARS_X": 4, "PIXEL_SIZE": 10, "SEPARATION": 200,
    },
    "fluxspectrum": {"FLUX_MODELS": ["gaisser-tang", "guan"]},
    "radiographyatsites": {**AROUND, "SITES": "sites.gpkg"},
    "siteselection": {
        **AROUND, "MIN_DISTANCE": 1500, "MAX_DISTANCE": 2500, "SPACING": 1000, "WORKERS": 0,
    },
    "tomography": {"MUOGRAMS": ["opacity.tif"], "DEM": str(DEM), **CONE},
    "reconstructiontest": {
        **AROUND, "RING_SITES": 3, "RING_RADIUS": 800, "VOXEL_SIZE": 300, "BASE": 900,
        "ITERATIONS": 2,
    },
    "reconstructionbenchmark": {"SIZE": 16, "ANGLES": 8, "METHODS": ["art", "sirt"]},
}  # fmt: skip
#: The files or the folder that say that an algorithm did its work.
RESULTS = {
    "radiography": ["THICKNESS.tif", "FLUX.tif"],
    "muonflux": ["FLUX.tif"],
    "drape": ["OUTPUT.tif"],
    "importmuogram": ["OUTPUT.tif"],
    "density": ["DENSITY.tif", "DENSITY_ERROR.tif"],
    "telescope": ["ACCEPTANCE.tif"],
    "expectedcounts": ["COUNTS.tif"],
    "fluxspectrum": ["TABLE.csv"],
    "radiographyatsites": ["FOLDER"],
    "siteselection": ["SCORE.tif"],
    "tomography": ["DENSITY.tif"],
    "reconstructiontest": ["DENSITY.tif"],
    "reconstructionbenchmark": ["TABLE.csv"],
}
PICTURES = ["PANEL.png", "REPORT.html"]
#: What has no panel and no report.
UNPICTURED = {"drape", "importmuogram", "radiographyatsites"}
#: Nothing can be done without Poisson's probabilities, sparse matrices and transforms.
NEEDS_SCIPY = {"expectedcounts", "tomography", "reconstructiontest", "reconstructionbenchmark"}


@pytest.fixture(scope="module")
def prepared(tmp_path_factory):
    """Return files by name, made while every library is there."""
    folder = tmp_path_factory.mktemp("prepared")
    dem = open_dem(str(DEM))
    sight = take_sight(dem, from_wgs84(dem.crs, *DETECTOR), from_wgs84(dem.crs, *TARGET))
    seen = simulate(sight, Aperture(42, 22, 8, 6), Physics(), Telescope())
    for name in ("thickness", "flux", "opacity"):
        write_muogram(seen.muograms[name], folder / f"{name}.tif")
    (folder / "table.csv").write_text("azimuth,zenith,flux\n1,80,4\n2,80,5\n1,79,6\n2,79,7\n")
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(4326)
    source = ogr.GetDriverByName("GPKG").CreateDataSource(str(folder / "sites.gpkg"))
    layer = source.CreateLayer("sites", reference, ogr.wkbPoint)
    feature = ogr.Feature(layer.GetLayerDefn())
    feature.SetGeometry(ogr.CreateGeometryFromWkt("POINT ({} {})".format(*DETECTOR)))
    layer.CreateFeature(feature)
    return {path.name: str(path) for path in folder.iterdir()}


@pytest.fixture
def without(monkeypatch):
    """Make a library fail to be imported, as where it is not installed."""

    def remove(library):
        for name in [name for name in sys.modules if name.split(".")[0] == library]:
            monkeypatch.delitem(sys.modules, name)
        monkeypatch.setitem(sys.modules, library, None)

    return remove


@pytest.fixture
def job(provider, prepared, tmp_path):
    """Return the inputs of an algorithm, with files of these names as outputs."""

    def parameters(name, files):
        def found(value):
            if isinstance(value, list):
                return [found(one) for one in value]
            return prepared.get(value, value)

        inputs = {key: found(value) for key, value in JOBS[name].items()}
        return {**inputs, **{file.partition(".")[0]: str(tmp_path / file) for file in files}}

    return parameters


@pytest.fixture
def written(tmp_path):
    """Say whether everything was written that an algorithm is for."""
    return lambda name: all((tmp_path / file).exists() for file in RESULTS[name])


def test_every_algorithm_is_tried(provider):
    # The download needs none of these libraries, and a server; models are made of the rest.
    models = {one.name() for one in provider.algorithms() if hasattr(one, "childAlgorithms")}
    names = {one.name() for one in provider.algorithms()}
    assert names - models - {"downloadsrtm"} == set(JOBS) == set(RESULTS)


@pytest.mark.parametrize(
    ("library", "name"),
    [
        *(("matplotlib", name) for name in JOBS if name not in UNPICTURED),
        # Reports are written by the same code, but for these.
        *(("jinja2", name) for name in ("radiography", "telescope", "fluxspectrum")),
    ],
)
def test_without_pictures_everything_else_is_written(
    run, recorder, job, without, written, tmp_path, library, name
):
    feedback, parameters = recorder(), job(name, RESULTS[name] + PICTURES)
    without(library)
    run(name, parameters, feedback)
    assert written(name)
    assert not (tmp_path / "REPORT.html").exists()
    assert (tmp_path / "PANEL.png").exists() == (library == "jinja2")
    assert len([warning for warning in feedback.warnings if library in warning]) == 1


@pytest.mark.parametrize("name", sorted(JOBS.keys() - NEEDS_SCIPY))
def test_without_scipy_the_main_job_is_done(run, job, without, written, name):
    parameters = job(name, RESULTS[name])
    without("scipy")
    run(name, parameters)
    assert written(name)


@pytest.mark.parametrize("name", sorted(NEEDS_SCIPY))
def test_what_needs_scipy_says_how_to_get_it(run, job, without, tmp_path, name):
    from qgis.core import QgsProcessingException

    parameters = job(name, RESULTS[name])
    without("scipy")
    with pytest.raises(QgsProcessingException, match="python3-scipy") as refused:
        run(name, parameters)
    said = str(refused.value).replace("Unable to execute algorithm\n", "").strip()
    assert len(said.splitlines()) == 1
    assert "Traceback" not in said
    assert list(tmp_path.iterdir()) == []
