"""From a text table to a density in a shell: simulate, import, invert."""

import re

import numpy as np
import pytest
from osgeo import gdal

from muysc_qgis.trajectories import read_trajectories

gdal.UseExceptions()


@pytest.fixture(scope="module")
def survey(qgis_process, data_folder, tmp_path_factory):
    """Simulate Vesuvius at 2.2 g/cm³; write what a telescope counts as a text table."""
    folder = tmp_path_factory.mktemp("medición ñ")
    thickness, flux = folder / "thickness.tif", folder / "flux.tif"
    spread = {name: folder / f"{name}.tif" for name in ("FLUX_MINIMUM", "FLUX_MAXIMUM")}
    done = qgis_process.run(
        "radiography",
        {
            "DEM": data_folder / "vesuvius_srtmgl1.tif",
            "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
            "TARGET": "14.424745,40.823729 [EPSG:4326]",
            "AZIMUTH_APERTURE": 40, "ELEVATION_APERTURE": 20,
            "AZIMUTH_PIXELS": 20, "ELEVATION_PIXELS": 16,
            "DENSITY": 2.2, "THICKNESS": thickness, "FLUX": flux, **spread,
        },
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    dataset = gdal.Open(str(flux))
    left, step_x, _, top, _, step_y = dataset.GetGeoTransform()
    expected = dataset.ReadAsArray().astype(float)
    counts = np.random.default_rng(8).poisson(expected * 100 * 20)
    table = folder / "counts.tsv"
    with table.open("w") as file:
        print("zenith\tazimuth\tcounts", file=file)
        for i, j in np.ndindex(counts.shape):
            zenith, azimuth = 90 - (top + (i + 0.5) * step_y), left + (j + 0.5) * step_x
            print(f"{zenith:.5f}\t{azimuth:.5f}\t{counts[i, j]}", file=file)
    return {"table": table, "thickness": thickness, "flux": flux, **spread}


def numbers(said):
    return {
        name: float(value)
        for name, value in re.findall(r"^(\w+):\s+([-\d.e+]+)$", said, re.MULTILINE)
    }


def test_a_table_becomes_a_density(qgis_process, survey, tmp_path):
    counts = tmp_path / "cuentas.tif"
    done = qgis_process.run(
        "importmuogram",
        {"INPUT": survey["table"], "REFERENCE": survey["thickness"], "OUTPUT": counts},
    )
    assert done.returncode == 0, done.stdout + done.stderr
    outputs = {
        "DENSITY": tmp_path / "densidad.tif", "DENSITY_ERROR": tmp_path / "error.tif",
        "PANEL": tmp_path / "panel.png", "REPORT": tmp_path / "informe.html",
    }  # fmt: skip
    measured = {
        "COUNTS": counts, "THICKNESS": survey["thickness"], "EXPOSURE": 100, "ACCEPTANCE": 20,
        "MINIMUM_COUNTS": 30,
    }  # fmt: skip
    done = qgis_process.run("density", {**measured, **outputs})
    assert done.returncode == 0, done.stdout + done.stderr
    for path in outputs.values():
        assert path.stat().st_size > 500
    found = numbers(done.stdout)
    assert abs(found["MEAN_DENSITY"] - 2.2) < 3.5 * found["MEAN_DENSITY_ERROR"]
    # One ray says too little of the pixels at the skyline.
    assert found["DENSITY_PIXELS"] + found["MIXED_PIXELS"] == found["ROCK_PIXELS"] > 100
    assert found["DENSITY_PIXELS"] > 100


def test_the_models_enclose_the_flux(survey):
    low, middle, high = (
        gdal.Open(str(survey[name])).ReadAsArray()
        for name in ("FLUX_MINIMUM", "flux", "FLUX_MAXIMUM")
    )
    assert np.all(low <= high)
    # The thinnest rock may be outside the range of the model chosen.
    assert np.mean((low <= middle * 1.001) & (middle * 0.999 <= high)) > 0.95
    assert np.median(high / low) > 1.05


@pytest.mark.parametrize(
    ("algorithm", "change", "words"),
    [
        ("density", {"FLUX": "thickness"}, ["FLUX is a muogram of thickness"]),
        ("density", {}, ["None of COUNTS, FLUX and TRANSMISSION"]),
        ("importmuogram", {"INPUT": "thickness"}, ["no text file"]),
        ("importmuogram", {"INPUT": "table", "VALUE_COLUMN": "rate"}, ["rate", "zenith, azimuth"]),
    ],
)
def test_bad_input_is_refused_in_one_sentence_and_leaves_no_file(
    qgis_process, survey, tmp_path, algorithm, change, words
):
    outputs = {
        "density": {
            "THICKNESS": survey["thickness"],
            "DENSITY": tmp_path / "d.tif",
            "DENSITY_ERROR": tmp_path / "e.tif",
        },
        "importmuogram": {"OUTPUT": tmp_path / "o.tif"},
    }[algorithm]
    given = {name: survey.get(value, value) for name, value in change.items()}
    done = qgis_process.run(algorithm, {**outputs, **given})
    assert done.returncode != 0
    for word in words:
        assert word in done.stdout + done.stderr
    assert "Traceback" not in done.stderr
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("terrain", "detector", "target", "preset", "boresight"),
    [
        ("vesuvius_srtmgl1", (14.410686, 40.810561), (14.424745, 40.823729), "mute", 24),
        ("vesuvius_srtmgl1", (14.410686, 40.810561), (14.424745, 40.823729), "lesparre2012", 26),
        ("st_helens_usgs", (-122.205, 46.215), (-122.1885, 46.2), "lesparre2012", 18),
    ],
)
def test_counts_come_back_as_the_density_that_made_them(
    qgis_process, data_folder, tmp_path, terrain, detector, target, preset, boresight
):
    place = {
        "DEM": data_folder / f"{terrain}.tif",
        "DETECTOR": f"{detector[0]},{detector[1]} [EPSG:4326]",
    }
    counts, share = tmp_path / "counts.tif", tmp_path / "share.tif"
    done = qgis_process.run(
        "expectedcounts",
        {
            **place, "TARGET": f"{target[0]},{target[1]} [EPSG:4326]", "PRESET": preset,
            "BORESIGHT_ELEVATION": boresight, "DAYS": 100, "FLUX_MODEL": "gaisser-tang",
            "COUNTS": counts, "ROCK_SHARE": share,
        },
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    density = tmp_path / "density.tif"
    done = qgis_process.run(
        "density",
        {
            "COUNTS": counts, "DEM": place["DEM"], "FLUX_MODEL": "gaisser-tang",
            "DENSITY": density, "DENSITY_ERROR": tmp_path / "error.tif",
        },
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    assert abs(numbers(done.stdout)["MEAN_DENSITY"] - 2.65) < 0.01
    found, rock = read_trajectories(density).values, read_trajectories(share).values >= 0.1
    known = rock & np.isfinite(found)
    assert known.sum() > 0.95 * rock.sum() > 150
    assert np.percentile(np.abs(found[known] - 2.65), 95) < 0.03
