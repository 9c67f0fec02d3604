"""Markup in the names of files, sites and metadata stays text in every report."""

import csv
import io
import shutil
from html.parser import HTMLParser

import pytest
from osgeo import gdal, ogr

gdal.UseExceptions()
ogr.UseExceptions()

#: Legal as a folder's name; as HTML it would run a script.
EVIL = "<img src=x onerror=alert(1)>&\"'"
SCRIPT = "</p><script>alert(1)</script>"
VIEW = {
    "TARGET": "14.424745,40.823729 [EPSG:4326]", "AZIMUTH_APERTURE": 42, "ELEVATION_APERTURE": 22,
    "AZIMUTH_PIXELS": 9, "ELEVATION_PIXELS": 7,
}  # fmt: skip
DETECTOR = {"DETECTOR": "14.410686,40.810561 [EPSG:4326]"}


class Page(HTMLParser):
    """Collects what a page would load or run."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.attributes, self.text = set(), [], ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.add(tag)
        self.attributes += attributes

    def handle_data(self, data):
        self.text += data


@pytest.fixture
def folder(tmp_path):
    evil = tmp_path / EVIL
    evil.mkdir()
    return evil


@pytest.fixture
def terrain(folder, data_folder):
    return str(shutil.copy(data_folder / "vesuvius_srtmgl1.tif", folder / f"{EVIL}.tif"))


@pytest.fixture
def muograms(run, terrain, folder):
    """A thickness and a transmission whose metadata hold markup."""
    files = {name: str(folder / f"{name} {EVIL}.tif") for name in ("THICKNESS", "TRANSMISSION")}
    run("radiography", {"DEM": terrain, **DETECTOR, **VIEW, **files, "FLUX": f"{folder}/f.tif"})
    for path in files.values():
        dataset = gdal.Open(path, gdal.GA_Update)
        for key in ("MATERIAL", "DEM", "NAME"):
            dataset.SetMetadataItem(key, SCRIPT, "MUYSC")
        del dataset
    return files


@pytest.fixture
def sites(folder):
    path = folder / "sites.csv"
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["name", "wkt"])
        writer.writerow([SCRIPT, "POINT (14.410686 40.810561)"])
        writer.writerow([EVIL, "POINT (14.4265 40.8360)"])
    layer = folder / "sites.gpkg"
    gdal.VectorTranslate(str(layer), str(path), options=["-a_srs", "EPSG:4326", "-oo",
                         "GEOM_POSSIBLE_NAMES=wkt"])  # fmt: skip
    return str(layer)


@pytest.fixture
def jobs(terrain, muograms, sites):
    """Parameters of every algorithm with a report, by its name."""
    dem = {"DEM": terrain}
    volume = {"EXTENT": "450600,452700,4518000,4520100 [EPSG:32633]", "VOXEL_SIZE": 300,
              "ITERATIONS": 2}  # fmt: skip
    return {
        "radiography": {**dem, **DETECTOR, **VIEW},
        "muonflux": {"THICKNESS": muograms["THICKNESS"]},
        "density": {name: muograms[name] for name in ("THICKNESS", "TRANSMISSION")},
        "telescope": {"PRESET": "custom", "BARS_X": 4, "PIXEL_SIZE": 5, "SEPARATION": 90},
        "expectedcounts": {**dem, **DETECTOR, "TARGET": VIEW["TARGET"], "PRESET": "custom",
                           "BARS_X": 4, "PIXEL_SIZE": 5, "SEPARATION": 90},
        "fluxspectrum": {"FLUX_MODELS": ["gaisser"], "MATERIALS": ["standard_rock"]},
        "siteselection": {**dem, **VIEW, "CANDIDATES": sites, "MAX_DISTANCE": 2500,
                          "SPACING": 100, "WORKERS": 0},
        "tomography": {**dem, **volume, "MUOGRAMS": [muograms["THICKNESS"]]},
        "reconstructiontest": {**dem, **VIEW, **volume, "SITES": sites, "NAME_FIELD": "name"},
        "reconstructionbenchmark": {"SIZE": 16, "ANGLES": 8, "METHODS": ["sirt"]},
    }  # fmt: skip


@pytest.fixture
def undrawn(monkeypatch):
    """Pictures take most of the time and are not looked at here."""
    from matplotlib.figure import Figure

    empty = io.BytesIO()
    Figure(figsize=(0.1, 0.1)).savefig(empty, format="png")
    monkeypatch.setattr(Figure, "savefig", lambda self, file, **look: file.write(empty.getvalue()))


def names_with_a_report(provider):
    return {one.name() for one in provider.algorithms()
            if one.parameterDefinition("REPORT") and one.group() != "Models"}  # fmt: skip


@pytest.mark.usefixtures("undrawn")
def test_every_report_keeps_markup_as_text(provider, run, jobs, folder):
    assert set(jobs) == names_with_a_report(provider)
    for name, parameters in jobs.items():
        report = folder / f"{name} <i>.html"
        rasters = {
            one.name(): str(folder / f"{name} {one.name()}.tif")
            for one in provider.algorithm(name).parameterDefinitions()
            if one.type() == "rasterDestination" and one.createByDefault()
        }
        run(name, {**parameters, **rasters, "REPORT": str(report)})
        page = Page(report.read_text(encoding="utf-8"))
        assert not page.tags & {"script", "iframe", "object", "embed", "i"}, name
        for attribute, value in page.attributes:
            assert not attribute.startswith("on"), (name, attribute)
            assert attribute != "src" or value.startswith("data:image/png"), (name, value)
        # What is escaped reads as it was written.
        if "DEM" in parameters:
            assert EVIL in page.text, name
