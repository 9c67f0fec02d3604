"""What expected counts gives comes back as the density that made it, through the same terrain."""

import numpy as np
import pytest
from osgeo import gdal

from muysc_qgis.muogram import Muogram, read_muogram, write_muogram
from muysc_qgis.trajectories import read_trajectories, write_trajectories
from muysc_qgis.views import like

gdal.UseExceptions()

DENSITY = 2.4
MODEL = {"FLUX_MODEL": "gaisser-tang"}


@pytest.fixture(scope="module")
def dem(data_folder):
    return str(data_folder / "vesuvius_srtmgl1.tif")


@pytest.fixture
def counted(run, dem, tmp_path):
    """Return the rasters that a small telescope at Vesuvius is expected to count."""
    outputs = {
        name: str(tmp_path / f"{name}.tif")
        for name in ("COUNTS", "FLUX", "ROCK_SHARE", "THICKNESS", "ACCEPTANCE")
    }
    results = run(
        "expectedcounts",
        {
            "DEM": dem, "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
            "TARGET": "14.424745,40.823729 [EPSG:4326]", "PRESET": "custom", "BARS_X": 8,
            "BARS_Y": 8, "PIXEL_SIZE": 10, "SEPARATION": 200, "BORESIGHT_ELEVATION": 22,
            "DAYS": 200, "DENSITY": DENSITY, **MODEL, **outputs,
        },
    )  # fmt: skip
    return {name: results[name] for name in (*outputs, "QUADRATURE_ERROR")}


@pytest.fixture
def measure(run, dem, tmp_path):
    def run_density(feedback=None, **parameters):
        outputs = {
            name: str(tmp_path / f"out_{name}.tif")
            for name in ("DENSITY", "DENSITY_ERROR", "FLAGS", "THICKNESS_SEEN", "REGION_NUMBERS")
        }
        return run("density", {**outputs, "DEM": dem, **MODEL, **parameters}, feedback)

    return run_density


def values(path):
    return read_trajectories(path).values


@pytest.mark.parametrize("minimum", [0, 20])
def test_expected_counts_come_back_as_the_density_that_made_them(measure, counted, minimum):
    # Neither a thickness nor acceptance nor days: the counts say what they are of.
    results = measure(COUNTS=counted["COUNTS"], MINIMUM_COUNTS=minimum)
    share = values(counted["ROCK_SHARE"])
    density = values(results["DENSITY"])
    rock = (share >= 0.1) & np.isfinite(density)
    assert rock.sum() > 40
    assert results["MEAN_DENSITY"] == pytest.approx(DENSITY, abs=1e-3)
    assert np.percentile(np.abs(density[rock] - DENSITY), 95) < 0.003
    assert results["MIXED_PIXELS"] == 0
    assert results["SKY_RATIO"] == pytest.approx(1, abs=1e-3)
    assert np.isnan(density[share == 0]).all()
    np.testing.assert_allclose(
        values(results["THICKNESS_SEEN"]), values(counted["THICKNESS"]), rtol=1e-4
    )
    assert 0 < counted["QUADRATURE_ERROR"] < 0.4


def test_a_flux_comes_back_too(measure, counted):
    results = measure(FLUX=counted["FLUX"])
    assert results["MEAN_DENSITY"] == pytest.approx(DENSITY, abs=1e-3)


def test_without_terrain_the_skyline_is_left_out_and_the_remedy_told(measure, counted, recorder):
    feedback = recorder()
    results = measure(feedback, COUNTS=counted["COUNTS"], THICKNESS=counted["THICKNESS"], DEM=None)
    flags, share = values(results["FLAGS"]), values(counted["ROCK_SHARE"])
    skyline = (share > 0) & (share < 1)
    assert np.all(flags[skyline] == 7)
    assert np.isnan(values(results["DENSITY"])[skyline]).all()
    assert np.count_nonzero(flags == 7) == results["MIXED_PIXELS"]
    (said,) = [one for one in feedback.warnings if "give DEM" in one]
    assert f"{results['MIXED_PIXELS']:.0f} pixels" in said


def test_an_acceptance_that_is_wrong_by_two_is_seen_in_the_sky(measure, counted, recorder):
    feedback = recorder()
    acceptance = read_trajectories(counted["ACCEPTANCE"])
    twice = counted["ACCEPTANCE"].replace(".tif", "_twice.tif")
    write_trajectories(
        like(acceptance, "acceptance", 2 * acceptance.values, acceptance.metadata), twice
    )
    results = measure(feedback, COUNTS=counted["COUNTS"], ACCEPTANCES=twice)
    assert results["SKY_RATIO"] == pytest.approx(0.5, abs=0.01)
    (said,) = [one for one in feedback.warnings if "open sky saw 0.50" in one]
    assert "acceptance" in said
    assert "densities are high" in said


def test_impossible_densities_and_their_scatter_are_warned_of(measure, counted, recorder):
    feedback = recorder()
    counts = read_trajectories(counted["COUNTS"])
    path = counted["COUNTS"].replace(".tif", "_bright.tif")
    # Muons that did not come through the rock in the lower half.
    row = np.arange(len(counts.y))[:, None]
    more = np.where(row > 9, counts.values + 500.0, counts.values)
    write_trajectories(like(counts, "counts", np.rint(more), counts.metadata), path)
    results = measure(feedback, COUNTS=path)
    assert results["CHI_SQUARED"] > 1.5
    assert any("χ²" in one and "per datum" in one for one in feedback.warnings)
    assert any("lighter than 0.5" in one for one in feedback.warnings)


def test_a_muogram_of_azimuth_and_elevation_is_seen_through_its_pixels(run, measure, dem, tmp_path):
    # Fine rays through the pixels, and their mean: what boxes of one degree see.
    flux = str(tmp_path / "fine.tif")
    fine = 12
    run(
        "radiography",
        {
            "DEM": dem, "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
            "TARGET": "14.424745,40.823729 [EPSG:4326]", "AZIMUTH_APERTURE": 12,
            "ELEVATION_APERTURE": 10, "AZIMUTH_PIXELS": 12 * fine, "ELEVATION_PIXELS": 10 * fine,
            "DENSITY": DENSITY, **MODEL, "FLUX": flux, "THICKNESS": str(tmp_path / "t.tif"),
        },
    )  # fmt: skip
    one = read_muogram(flux)
    weight = np.cos(np.radians(one.elevation_deg))[:, None] * np.ones(one.values.shape)

    def boxes(array):
        return array.reshape(10, fine, 12, fine).sum(axis=(1, 3))

    coarse = boxes(one.values * weight) / boxes(weight)
    azimuth = one.azimuth_deg.reshape(12, fine).mean(axis=1)
    elevation = one.elevation_deg.reshape(10, fine).mean(axis=1)
    path = str(tmp_path / "coarse.tif")
    write_muogram(Muogram("flux", coarse, azimuth, elevation, one.metadata), path)
    results = measure(FLUX=path)
    density = read_muogram(results["DENSITY"]).values
    known = np.isfinite(density)
    assert known.sum() > 60
    assert np.median(np.abs(density[known] - DENSITY)) < 0.01
    assert results["MEAN_DENSITY"] == pytest.approx(DENSITY, abs=0.02)


def test_what_is_missing_is_asked_for(measure, counted, tmp_path):
    from qgis.core import QgsProcessingException

    counts = read_trajectories(counted["COUNTS"])
    bare = {key: value for key, value in counts.metadata.items() if key != "DETECTOR_LON"}
    path = str(tmp_path / "bare.tif")
    write_trajectories(like(counts, "counts", counts.values, bare), path)
    with pytest.raises(QgsProcessingException, match="give DETECTOR, a point on the DEM"):
        measure(COUNTS=path)
    place = "14.410686,40.810561 [EPSG:4326]"
    assert measure(COUNTS=path, DETECTOR=place)["MEAN_DENSITY"] == pytest.approx(DENSITY, abs=1e-3)
    with pytest.raises(QgsProcessingException, match="Neither DEM nor THICKNESS"):
        measure(COUNTS=path, DEM=None)


def test_merged_trajectories_come_back(run, measure, dem, tmp_path):
    path = str(tmp_path / "merged.tif")
    run(
        "expectedcounts",
        {
            "DEM": dem, "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
            "TARGET": "14.424745,40.823729 [EPSG:4326]", "PRESET": "custom", "BARS_X": 10,
            "BARS_Y": 10, "PIXEL_SIZE": 8, "SEPARATION": 200, "BORESIGHT_ELEVATION": 22,
            "MERGE": 3, "EFFICIENCY": 0.8, "DENSITY": DENSITY, "COUNTS": path, **MODEL,
        },
    )  # fmt: skip
    assert measure(COUNTS=path)["MEAN_DENSITY"] == pytest.approx(DENSITY, abs=1e-3)


def test_the_error_of_the_thickness_grows_with_that_of_the_terrain(run, dem, tmp_path):
    place = {
        "DEM": dem, "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
        "TARGET": "14.424745,40.823729 [EPSG:4326]",
    }  # fmt: skip
    outputs = {name: str(tmp_path / f"{name}.tif") for name in ("THICKNESS", "THICKNESS_ERROR")}
    pixels = {"AZIMUTH_PIXELS": 12, "ELEVATION_PIXELS": 10, "FLUX": str(tmp_path / "f.tif")}
    errors = []
    for metres in (2, 4):
        results = run("radiography", {**place, **pixels, **outputs, "TERRAIN_ERROR": metres})
        one = read_muogram(results["THICKNESS_ERROR"])
        assert one.metadata["TERRAIN_ERROR"] == str(float(metres))
        thickness = read_muogram(results["THICKNESS"]).values
        errors.append(np.median(one.values[thickness > 0]))
    assert errors[1] == pytest.approx(2 * errors[0], rel=0.2)
    outputs["COUNTS"] = str(tmp_path / "c.tif")
    telescope = {"PRESET": "custom", "BARS_X": 4, "BARS_Y": 4, "PIXEL_SIZE": 20, "SEPARATION": 200}
    wide = []
    for metres in (0, 50):
        correlated = {**outputs, "TERRAIN_CORRELATION": metres}
        results = run("expectedcounts", {**place, **telescope, **correlated})
        wide.append(np.nanmedian(values(results["THICKNESS_ERROR"])))
    assert wide[1] < 0.6 * wide[0]
