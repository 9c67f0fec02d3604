"""Bad input: one sentence that names value, limit and remedy; no file left or changed."""

import numpy as np
import pytest
from osgeo import gdal, osr

gdal.UseExceptions()


@pytest.fixture
def refused(run, vesuvius, tmp_path):
    """Run radiography with one change and return the sentence it refuses with."""
    from qgis.core import QgsProcessingException

    def run_and_catch(algorithm="radiography", base=None, **change):
        kept = tmp_path / "outputs" / "thickness.tif"
        kept.parent.mkdir(exist_ok=True)
        kept.write_bytes(b"older result")
        outputs = {"THICKNESS": str(kept), "FLUX": str(kept.parent / "flux.tif")}
        with pytest.raises(QgsProcessingException) as caught:
            run(algorithm, {**(vesuvius if base is None else base), **outputs, **change})
        assert kept.read_bytes() == b"older result"
        assert [path.name for path in kept.parent.iterdir()] == ["thickness.tif"]
        return str(caught.value).replace("Unable to execute algorithm\n", "")

    return run_and_catch


def assert_one_sentence(said):
    assert said.endswith((".", ".)"))
    assert "\n" not in said.strip()
    for leak in ("Traceback", "Error:", "NoneType", "could not be wrapped"):
        assert leak not in said


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"DENSITY": 0}, ("0 g/cm³", "above 0")),
        ({"DENSITY": -2.65}, ("-2.65 g/cm³", "30 g/cm³")),
        ({"DENSITY": float("nan")}, ("DENSITY", "not a finite number")),
        ({"DENSITY": "dense"}, ("DENSITY", "dense", "not a finite number")),
        ({"ACCEPTANCE": 0}, ("acceptance", "is 0;")),
        ({"ACCEPTANCE": -6}, ("acceptance", "is -6;")),
        ({"ACCEPTANCE": float("inf")}, ("ACCEPTANCE", "not a finite number")),
        ({"MUONS": 0}, ("number of muons is 0;",)),
        ({"MUONS": -1}, ("number of muons is -1;",)),
        ({"AZIMUTH_APERTURE": 0}, ("azimuth aperture of 0°", "360°")),
        ({"AZIMUTH_APERTURE": 361}, ("azimuth aperture of 361°", "360°")),
        ({"AZIMUTH_APERTURE": 1e-300}, ("too narrow", "widen")),
        ({"ELEVATION_APERTURE": -5}, ("elevation aperture of -5°", "180°")),
        ({"ELEVATION_APERTURE": 170}, ("past ±90°", "at most")),
        ({"AZIMUTH_PIXELS": 0}, ("0 azimuth pixels", "at least 1")),
        ({"ELEVATION_PIXELS": -3}, ("-3 elevation pixels", "at least 1")),
        ({"AZIMUTH_PIXELS": 10**6, "ELEVATION_PIXELS": 10**6}, ("GiB", "no more than")),
        ({"FLUX_MODEL": "hebbeker"}, ("hebbeker", "reyna-hebbeker")),
        ({"MATERIAL": "cheese"}, ("cheese", "standard_rock")),
        ({"ENERGY_LOSS": "none"}, ("none", "lesparre")),
        ({"GAISSER_PARAMETERS": "x"}, ("“x”", "volkova")),
        ({"DETECTION_THRESHOLD": -1}, ("-1 GeV",)),
        ({"MAX_RANGE": 0}, ("maximum range of 0 m",)),
        ({"MAX_RANGE": 100, "NEAR_FIELD": 200}, ("near field of 200 m", "100 m")),
        ({"NEAR_FIELD": -1}, ("near field of -1 m",)),
        ({"DETECTOR_HEIGHT": 1e6}, ("1e+06 m",)),
        ({"BAND": 2}, ("Band 2", "1 to 1")),
        ({"BAND": 0}, ("Band 0",)),
        ({"DETECTOR": "20,40 [EPSG:4326]"}, ("detector", "off the DEM", "14.35")),
        ({"TARGET": "14.42,41.9 [EPSG:4326]"}, ("target", "off the DEM")),
        ({"TARGET": "14.410686,40.810561 [EPSG:4326]"}, ("same point",)),
        ({"DETECTOR": "somewhere"}, ("DETECTOR", "somewhere", "x,y")),
        ({"DETECTOR": None}, ("DETECTOR is missing",)),
        ({"DEM": "/no/such/dem.tif"}, ("/no/such/dem.tif",)),
        ({"DEM": None}, ("DEM is missing",)),
    ],
)  # fmt: skip
def test_values_that_cannot_be_used(refused, change, words):
    said = refused(**change)
    assert_one_sentence(said)
    for word in words:
        assert word in said


def test_files_that_are_no_elevation(refused, data_folder, tmp_path):
    empty = tmp_path / "empty.tif"
    empty.write_bytes(b"")
    assert "empty.tif" in refused(DEM=str(empty))

    text = tmp_path / "text.tif"
    text.write_text("elevation: high")
    assert "text.tif" in refused(DEM=str(text))

    whole = (data_folder / "vesuvius_srtmgl1.tif").read_bytes()
    corrupt = tmp_path / "corrupt.tif"
    corrupt.write_bytes(whole[:40_000])
    assert "corrupt.tif" in refused(DEM=str(corrupt))

    picture = tmp_path / "picture.tif"
    dataset = gdal.GetDriverByName("GTiff").Create(
        str(picture), 10, 10, 3, gdal.GDT_Byte, ["PHOTOMETRIC=RGB"]
    )
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(4326)
    dataset.SetProjection(reference.ExportToWkt())
    dataset.SetGeoTransform((14, 0.1, 0, 41, 0, -0.1))
    del dataset
    assert "picture" in refused(DEM=str(picture))


def test_a_number_beyond_what_a_raster_holds(refused, tmp_path):
    table = tmp_path / "table.csv"
    table.write_text("azimuth,elevation,flux\n1,2,1e300\n2,2,1\n")
    outputs = {"OUTPUT": str(tmp_path / "outputs" / "m.tif")}
    base = {"INPUT": str(table), "QUANTITY": "flux", **outputs}
    said = refused("importmuogram", base)
    assert_one_sentence(said)
    assert "1e+300" in said


def test_a_muogram_is_not_a_dem(refused, run, vesuvius, tmp_path):
    made = run(
        "radiography",
        {**vesuvius, "THICKNESS": str(tmp_path / "t.tif"), "FLUX": str(tmp_path / "f.tif")},
    )
    said = refused(DEM=made["THICKNESS"])
    assert_one_sentence(said)


def test_a_raster_that_gdal_would_turn_for_ever(refused, vesuvius, data_folder, tmp_path):
    dem = tmp_path / "far.tif"
    dem.write_bytes((data_folder / "vesuvius_srtmgl1.tif").read_bytes())
    dataset = gdal.Open(str(dem), gdal.GA_Update)
    dataset.SetGeoTransform((1.1e200, 2e16, 1e-9, 1e-9, -4.8e16, 5.3e16))
    del dataset
    said = refused(DEM=str(dem))
    assert_one_sentence(said)
    assert "1.1e+200" in said
    several = {"DEM": vesuvius["DEM"], "MUOGRAMS": [str(dem)]}
    assert_one_sentence(refused("tomography", several, DENSITY=str(tmp_path / "density.tif")))


def test_a_detector_on_no_data(refused, data_folder):
    dem = data_folder / "st_helens_usgs.tif"
    dataset = gdal.Open(str(dem))
    band = dataset.GetRasterBand(1)
    rows, columns = np.nonzero(band.ReadAsArray() == band.GetNoDataValue())
    middle = len(rows) // 2
    left, step_x, _, top, _, step_y = dataset.GetGeoTransform()
    x = left + step_x * (columns[middle] + 0.5)
    y = top + step_y * (rows[middle] + 0.5)
    said = refused(
        DEM=str(dem), DETECTOR=f"{x},{y} [EPSG:26710]", TARGET="562260,5115390 [EPSG:26710]"
    )
    assert_one_sentence(said)
    assert "no data" in said
    said = refused(
        DEM=str(dem), TARGET=f"{x},{y} [EPSG:26710]", DETECTOR="562260,5115390 [EPSG:26710]"
    )
    assert "target" in said
    assert "no data" in said


def test_destinations_that_cannot_be_written(refused, vesuvius, tmp_path):
    assert "no folder" in refused(OPACITY="/proc/version/opacity.tif")
    locked = tmp_path / "locked.tif"
    locked.write_bytes(b"keep me")
    locked.chmod(0o444)
    assert "read-only" in refused(OPACITY=str(locked))
    assert locked.read_bytes() == b"keep me"
    folder = tmp_path / "closed"
    folder.mkdir()
    folder.chmod(0o555)
    assert "read-only" in refused(OPACITY=str(folder / "opacity.tif"))
    assert "read-only" in refused(FIELD_OF_VIEW=str(folder / "view.gpkg"))
    assert "read-only" in refused(PANEL=str(folder / "panel.png"))
    folder.chmod(0o755)


def test_destinations_that_would_lose_something(refused, vesuvius, tmp_path):
    copy = tmp_path / "dem.tif"
    with open(vesuvius["DEM"], "rb") as source:
        copy.write_bytes(source.read())
    before = copy.read_bytes()
    assert "input itself" in refused(DEM=str(copy), OPACITY=str(copy))
    assert copy.read_bytes() == before
    twice = str(tmp_path / "twice.tif")
    assert "Two outputs" in refused(OPACITY=twice, EXPOSURE=twice)
    assert ".tif" in refused(OPACITY=str(tmp_path / "opacity.asc"))
    assert ".png" in refused(PANEL=str(tmp_path / "panel.txt"))


def test_a_missing_library_is_named_with_the_remedy(refused, monkeypatch):
    import sys

    # None makes every import of it fail, as where it is not installed.
    for name in [name for name in sys.modules if name.split(".")[0] == "pyproj"]:
        monkeypatch.setitem(sys.modules, name, None)
    monkeypatch.setitem(sys.modules, "pyproj", None)
    said = refused()
    assert "library pyproj is missing" in said
    assert_one_sentence(said)
    assert "python3-pyproj" in said
