"""Density from a measurement: what it declares, a round trip, and what it refuses."""

import numpy as np
import pytest
from osgeo import gdal

from muysc_qgis.measurement.density import Flag
from muysc_qgis.muogram import Muogram, read_muogram, write_muogram
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate

gdal.UseExceptions()

DENSITY = 2.2
MODEL = "gaisser-tang"
PHYSICS = Physics(flux_model=MODEL)
AZIMUTH = np.linspace(20.0, 50.0, 16)
ELEVATION = np.linspace(24.0, 3.0, 12)
PLACE = {
    "DETECTOR_LON": 14.41, "DETECTOR_LAT": 40.81, "DETECTOR_ELEVATION": 600.0,
    "BORESIGHT_AZIMUTH": 35.0, "BORESIGHT_ELEVATION": 13.5, "DENSITY": 2.65,
}  # fmt: skip
DAYS, ACCEPTANCE = 50.0, 20.0


@pytest.fixture
def files(tmp_path):
    """Write a hill and what a telescope would measure of it; return paths by name."""
    hill = np.clip(20.0 - np.abs(AZIMUTH - 33.3) / 2 - ELEVATION[:, None], 0, None) * 150.0
    muons = attenuate(hill * DENSITY * 100, ELEVATION[:, None], PHYSICS, 600.0)
    generator = np.random.default_rng(11)
    expected = muons.flux * DAYS * ACCEPTANCE
    up = attenuate(np.zeros_like(hill), ELEVATION[:, None] + 50, PHYSICS, 600.0).flux
    quantities = {
        "thickness": ("thickness", hill),
        "flux": ("flux", muons.flux),
        "flux_error": ("flux_error", 0.05 * muons.flux),
        "transmission": ("transmission", muons.transmission),
        "counts": ("counts", generator.poisson(expected).astype(float)),
        "sky": ("counts", generator.poisson(up * 20 * ACCEPTANCE).astype(float)),
    }
    paths = {}
    for name, (quantity, values) in quantities.items():
        paths[name] = str(tmp_path / f"{name}.tif")
        elevation = ELEVATION + 50 if name == "sky" else ELEVATION
        write_muogram(Muogram(quantity, values, AZIMUTH, elevation, PLACE), paths[name])
    return paths


@pytest.fixture
def measure(run, files, tmp_path):
    """Run the algorithm on files by name, with every raster written."""

    def run_density(feedback=None, **parameters):
        outputs = {
            name: str(tmp_path / f"out_{name}.tif")
            for name in (
                "DENSITY", "DENSITY_ERROR", "OPACITY", "DENSITY_LOWER", "DENSITY_UPPER", "FLAGS",
                "REGION_NUMBERS",
            )
        }  # fmt: skip
        chosen = {name: files.get(value, value) for name, value in parameters.items()}
        given = {"THICKNESS": files["thickness"], "FLUX_MODEL": MODEL, **outputs, **chosen}
        return run("density", given, feedback)

    return run_density


COUNTS = {"COUNTS": "counts", "EXPOSURE": DAYS, "ACCEPTANCE": ACCEPTANCE}


def values(path):
    return read_muogram(path).values


@pytest.mark.parametrize("name", ["FLUX", "TRANSMISSION"])
def test_without_noise_the_density_comes_back(measure, files, name):
    results = measure(**{name: name.lower(), "MODEL_UNCERTAINTY": 0})
    rock, flags = values(files["thickness"]) > 0, values(results["FLAGS"])
    # One ray says too little of the pixels at the skyline, and where the rock is steep.
    plain = rock & (flags != Flag.MIXED)
    assert np.count_nonzero(rock & ~plain) == results["MIXED_PIXELS"] > 20
    assert results["MIXED_PIXELS"] < plain.sum()
    np.testing.assert_allclose(values(results["DENSITY"])[plain], DENSITY, rtol=2e-3)
    assert np.isnan(values(results["DENSITY"])[~plain]).all()
    assert np.all(values(results["OPACITY"])[~rock] == 0)
    assert results["MEAN_DENSITY"] == pytest.approx(DENSITY, rel=2e-3)
    assert results["ROCK_PIXELS"] == np.count_nonzero(rock)
    assert results["DENSITY_PIXELS"] == np.count_nonzero(plain)
    assert np.isnan(results["MEAN_DENSITY_STATISTICAL_ERROR"])


def test_without_a_number_the_flux_models_own_error_counts(measure):
    # The flux is that of a formula, which counts as known to 15 %; as the muon sky's own it
    # is known better.
    formula = read_muogram(measure(FLUX="flux")["DENSITY"]).metadata
    assert float(formula["MODEL_UNCERTAINTY"]) == 0.15
    results = measure(FLUX="flux", FLUX_MODEL="gsf-sibyll")
    known = np.isfinite(values(results["DENSITY"]))
    error = values(results["DENSITY_ERROR"])[known] / values(results["DENSITY"])[known]
    # 5 to 12 % of the flux behind rock, for slopes of 1 to 7.
    assert np.all((error > 0.007) & (error < 0.15))
    told = read_muogram(results["DENSITY"]).metadata
    assert 0.05 <= float(told["MODEL_UNCERTAINTY"]) <= 0.12
    # It is the same for all pixels, so that the mean is known no better.
    assert results["MEAN_DENSITY_ERROR"] > 0.5 * DENSITY * np.median(error)


def test_errors_of_a_flux_become_errors_of_the_density(measure):
    results = measure(FLUX="flux", ERROR="flux_error")
    density, error = values(results["DENSITY"]), values(results["DENSITY_ERROR"])
    known = np.isfinite(density)
    assert np.all((error > 0)[known])
    # 5 % of the flux are 0.7 to 5 % of the density, for slopes of 1 to 7.
    assert np.all((error / density)[known] > 0.007)
    assert np.median((error / density)[known]) < 0.05


def test_counts_with_exposure_and_acceptance(measure, recorder):
    feedback = recorder()
    results = measure(feedback, **COUNTS, MINIMUM_COUNTS=0)
    pull = (results["MEAN_DENSITY"] - DENSITY) / results["MEAN_DENSITY_ERROR"]
    assert abs(pull) < 3.5
    known = results["LIMIT_PIXELS"] + results["DENSITY_PIXELS"]
    assert known + results["MIXED_PIXELS"] == results["ROCK_PIXELS"]
    flags, density = values(results["FLAGS"]), values(results["DENSITY"])
    assert np.count_nonzero(flags == 2) == results["LIMIT_PIXELS"] > 0
    assert np.isfinite(density[flags == 2]).all()
    assert np.isnan(values(results["DENSITY_ERROR"])[flags == 2]).all()
    assert any("lower limit" in warning for warning in feedback.warnings)
    metadata = read_muogram(results["DENSITY"]).metadata
    assert metadata["MEASURED"] == "counts"
    assert "DENSITY" not in metadata  # 2.65 was what the thickness was simulated with
    assert "2 no muon counted" in metadata["FLAGS"]


def test_the_open_sky_replaces_the_acceptance(measure):
    results = measure(COUNTS="counts", OPEN_SKY_COUNTS="sky", EXPOSURE=DAYS, OPEN_SKY_EXPOSURE=20.0)
    assert abs(results["MEAN_DENSITY"] - DENSITY) < 3.5 * results["MEAN_DENSITY_ERROR"]


def test_merged_pixels_have_no_limits(measure):
    results = measure(**COUNTS, MINIMUM_COUNTS=25)
    assert results["LIMIT_PIXELS"] == 0
    assert results["DENSITY_PIXELS"] + results["MIXED_PIXELS"] == results["ROCK_PIXELS"]
    density = values(results["DENSITY"])
    assert results["REGIONS"] == len(np.unique(density[np.isfinite(density)]))
    assert results["REGIONS"] < results["DENSITY_PIXELS"]
    number = values(results["REGION_NUMBERS"])
    assert len(np.unique(number[np.isfinite(number)])) == results["REGIONS"]
    # As they are by default, up to 20.
    assert measure(**COUNTS)["REGIONS"] >= results["REGIONS"]


def test_the_uncertainty_of_the_model_widens_the_mean(measure):
    plain, wide = (measure(**COUNTS, MODEL_UNCERTAINTY=percent) for percent in (0, 15))
    assert wide["MEAN_DENSITY_ERROR"] > 3 * plain["MEAN_DENSITY_ERROR"]
    assert wide["MEAN_DENSITY_STATISTICAL_ERROR"] < wide["MEAN_DENSITY_ERROR"] / 3


def test_the_spread_of_the_models_encloses_the_density(measure, tmp_path):
    ends = {name: str(tmp_path / f"{name}.tif") for name in ("DENSITY_MINIMUM", "DENSITY_MAXIMUM")}
    results = measure(FLUX="flux", **ends)
    low, middle, high = (
        values(results[name]) for name in ("DENSITY_MINIMUM", "DENSITY", "DENSITY_MAXIMUM")
    )
    known = np.isfinite(low)
    assert np.all((low <= high)[known])
    # The thinnest rock may be outside the range of the model chosen.
    inside = (low <= middle * (1 + 1e-6)) & (middle * (1 - 1e-6) <= high) & (low < high)
    assert np.mean(inside[np.isfinite(middle)]) > 0.95


def test_panel_and_report_tell_the_mean_and_the_limits(measure, tmp_path):
    panel, report = tmp_path / "p.png", tmp_path / "r.html"
    measure(**COUNTS, MINIMUM_COUNTS=0, PANEL=str(panel), REPORT=str(report))
    assert panel.stat().st_size > 20_000
    said = report.read_text(encoding="utf-8")
    for words in ("Mean density", "lower limit", "Garwood", "flag 2", "counts.tif"):
        assert words in said


def test_exposure_and_acceptance_may_stand_in_the_counts(measure, files):
    dataset = gdal.Open(files["counts"], gdal.GA_Update)
    dataset.SetMetadataItem("DAYS", str(DAYS), "MUYSC")
    dataset.SetMetadataItem("ACCEPTANCE", str(ACCEPTANCE), "MUYSC")
    del dataset
    written = measure(COUNTS="counts")["MEAN_DENSITY"]
    assert written == pytest.approx(measure(**COUNTS)["MEAN_DENSITY"], rel=1e-12)


def test_an_algorithm_as_models_and_dialogs_see_it(provider):
    algorithm = provider.algorithm("density")
    names = [one.name() for one in algorithm.parameterDefinitions()]
    assert set(names) >= {"THICKNESS", "COUNTS", "OPEN_SKY_COUNTS", "FLUX", "TRANSMISSION"}
    assert names.count("DENSITY") == 1
    outputs = {one.name() for one in algorithm.outputDefinitions()}
    assert outputs >= {"MEAN_DENSITY", "MEAN_DENSITY_ERROR", "DENSITY", "DENSITY_ERROR", "OPACITY"}
    assert "lower limit" in algorithm.shortHelpString()


def change_counts(path, value):
    dataset = gdal.Open(path, gdal.GA_Update)
    array = dataset.ReadAsArray()
    array[8, 8] = value
    dataset.GetRasterBand(1).WriteArray(array)
    del dataset


@pytest.fixture
def refused(measure, tmp_path):
    from qgis.core import QgsProcessingException

    def run_and_catch(**parameters):
        with pytest.raises(QgsProcessingException) as caught:
            measure(**parameters)
        assert not list(tmp_path.glob("out_*"))
        said = str(caught.value).replace("Unable to execute algorithm\n", "")
        assert said.endswith((".", ".)"))
        assert "\n" not in said.strip()
        assert "Traceback" not in said
        return said

    return run_and_catch


@pytest.mark.parametrize(
    ("parameters", "words"),
    [
        ({}, ("None of COUNTS, FLUX and TRANSMISSION is given", "exactly one")),
        ({"FLUX": "flux", "TRANSMISSION": "transmission"}, ("FLUX and TRANSMISSION are given",)),
        ({"FLUX": "transmission"}, ("FLUX is a muogram of transmission",)),
        ({"COUNTS": "counts"}, ("exposure in days", "DAYS")),
        ({"COUNTS": "counts", "EXPOSURE": 5}, ("acceptance in cm² sr", "ACCEPTANCE")),
        ({**COUNTS, "EXPOSURE": 0}, ("exposure in days is 0",)),
        ({**COUNTS, "ACCEPTANCE": -3}, ("acceptance in cm² sr is -3",)),
        (
            {"COUNTS": "counts", "OPEN_SKY_COUNTS": "sky", "EXPOSURE": 5},
            ("exposure of the open sky in days", "DAYS"),
        ),
        ({"FLUX": "flux", "OPEN_SKY_COUNTS": "sky"}, ("open sky", "flux")),
        ({"FLUX": "flux", "ERROR": "flux"}, ("errors holds flux", "flux_error")),
        ({**COUNTS, "ERROR": "flux_error"}, ("follow from the counts",)),
        ({"FLUX": "flux", "MINIMUM_COUNTS": 20}, ("merged", "muons were counted")),
        ({**COUNTS, "MINIMUM_COUNTS": -1}, ("-1 counts",)),
        ({"FLUX": "flux", "MODEL_UNCERTAINTY": 100}, ("100 %", "0 to below 100")),
        ({**COUNTS, "LIMIT_CONFIDENCE": 40}, ("40 %", "50 %")),
        ({"FLUX": "flux", "THICKNESS": "flux"}, ("thickness muogram holds flux",)),
        (
            {"FLUX": "flux", "THICKNESS": None},
            ("Neither DEM nor THICKNESS", "give the elevation model"),
        ),
        ({"FLUX": "/no/such/flux.tif"}, ("/no/such/flux.tif", "cannot be opened")),
        ({"FLUX": "flux", "FLUX_MODEL": "hebbeker"}, ("hebbeker",)),
    ],
)
def test_what_does_not_go_together_is_refused(refused, parameters, words):
    said = refused(**parameters)
    for word in words:
        assert word in said


@pytest.mark.parametrize(
    ("value", "words"),
    [(-2.0, ("negative", "-2")), (0.5, ("fractional", "0.5", "whole numbers"))],
)
def test_counts_that_no_telescope_gives_are_refused(refused, files, value, words):
    change_counts(files["counts"], value)
    said = refused(**COUNTS)
    for word in words:
        assert word in said


@pytest.mark.parametrize(("value", "words"), [(1.3, ("above 1", "1.3")), (-0.2, ("-0.2",))])
def test_a_transmission_is_a_share(refused, files, value, words):
    change_counts(files["transmission"], value)
    said = refused(TRANSMISSION="transmission")
    for word in words:
        assert word in said


def test_grids_that_do_not_match_are_both_told(refused, files, tmp_path):
    other = tmp_path / "other.tif"
    write_muogram(Muogram("thickness", np.ones((3, 4)), AZIMUTH[:4], ELEVATION[:3], PLACE), other)
    said = refused(FLUX="flux", THICKNESS=str(other))
    assert "16 × 12 pixels" in said
    assert "4 × 3 pixels" in said


def test_a_detector_that_is_not_known_is_asked_for_by_its_key(refused, measure, files):
    bare = {key: value for key, value in PLACE.items() if key != "DETECTOR_ELEVATION"}
    for name in ("thickness", "flux"):
        old = read_muogram(files[name])
        write_muogram(Muogram(name, old.values, AZIMUTH, ELEVATION, bare), files[name])
    assert "metadata key DETECTOR_ELEVATION" in refused(FLUX="flux")
    assert measure(FLUX="flux", DETECTOR_ELEVATION=600)["MEAN_DENSITY"] == pytest.approx(
        DENSITY, rel=2e-3
    )


def test_detectors_apart_are_noticed(measure, files, recorder):
    old = read_muogram(files["flux"])
    moved = {**PLACE, "DETECTOR_LAT": 40.82}
    write_muogram(Muogram("flux", old.values, AZIMUTH, ELEVATION, moved), files["flux"])
    feedback = recorder()
    measure(feedback, FLUX="flux")
    # A hundredth of a degree of latitude is 1.11 km.
    assert any("1112 m apart" in warning for warning in feedback.warnings)
