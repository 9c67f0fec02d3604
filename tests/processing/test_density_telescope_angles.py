"""Density from what a telescope counts along its own trajectories."""

import numpy as np
import pytest

from muysc_qgis.muogram import Muogram, write_muogram
from muysc_qgis.radiography.settings import Physics
from muysc_qgis.radiography.transmission import attenuate
from muysc_qgis.trajectories import TrajectoryMap, read_trajectories, write_trajectories

DENSITY = 2.2
X = np.linspace(-0.4, 0.4, 17)
Y = np.linspace(0.25, -0.2, 10)
#: Acceptance falls off towards the edges, as that of two planes does (cm² sr).
ACCEPTANCE = 12.0 * np.outer(1 - np.abs(Y) / 0.5, 1 - np.abs(X) / 0.8)
PLACE = {"DETECTOR_ELEVATION": 600.0, "BORESIGHT_AZIMUTH": 355.0, "ROLL": 3.0}
DAYS, SKY_DAYS = 80.0, 30.0


def telescope_map(quantity, values, elevation=14.0, **metadata):
    return TrajectoryMap(
        quantity, values, X, Y, {**PLACE, "BORESIGHT_ELEVATION": elevation, **metadata}
    )


def flux(thickness, elevation):
    return attenuate(thickness * DENSITY * 100, elevation, Physics(), 600.0).flux


@pytest.fixture
def files(tmp_path):
    generator = np.random.default_rng(31)
    empty = np.zeros(ACCEPTANCE.shape)
    elevation = telescope_map("thickness", empty).directions_deg()[1]
    # The sky was seen by the same telescope, turned up.
    up = telescope_map("thickness", empty, 65.0).directions_deg()[1]
    thickness = np.clip(21.0 - elevation, 0.0, None) * 70.0
    counted = generator.poisson(flux(thickness, elevation) * ACCEPTANCE * DAYS)
    sky = generator.poisson(flux(empty, up) * ACCEPTANCE * SKY_DAYS)
    maps = {
        "thickness": telescope_map("thickness", thickness),
        "counts": telescope_map("counts", counted.astype(float), DAYS=DAYS),
        "sky": telescope_map("counts", sky.astype(float), 65.0, DAYS=SKY_DAYS),
        "acceptance": TrajectoryMap("acceptance", ACCEPTANCE, X, Y),
    }
    paths = {name: str(tmp_path / f"{name}.tif") for name in maps}
    for name, one in maps.items():
        write_trajectories(one, paths[name])
    return paths


@pytest.mark.parametrize("normalised", [{"ACCEPTANCES": "acceptance"}, {"OPEN_SKY_COUNTS": "sky"}])
@pytest.mark.parametrize("minimum", [0, 40])
def test_counts_of_trajectories_give_the_density(run, files, tmp_path, normalised, minimum):
    results = run(
        "density",
        {
            "COUNTS": files["counts"], "THICKNESS": files["thickness"],
            **{name: files[value] for name, value in normalised.items()},
            "MINIMUM_COUNTS": minimum,
            "DENSITY": str(tmp_path / "d.tif"), "DENSITY_ERROR": str(tmp_path / "e.tif"),
        },
    )  # fmt: skip
    assert abs(results["MEAN_DENSITY"] - DENSITY) < 3.5 * results["MEAN_DENSITY_ERROR"]
    density = read_trajectories(results["DENSITY"])
    np.testing.assert_allclose(density.x, X, atol=1e-9)
    error = read_trajectories(results["DENSITY_ERROR"]).values
    if not minimum:
        pulls = ((density.values - DENSITY) / error)[np.isfinite(error)]
        assert np.mean(np.abs(pulls) <= 1) == pytest.approx(0.68, abs=0.12)


def test_panel_and_report_show_the_trajectories(run, files, tmp_path, recorder):
    matplotlib = pytest.importorskip("matplotlib.image")
    pytest.importorskip("jinja2")
    feedback = recorder()
    results = run(
        "density",
        {
            "COUNTS": files["counts"], "THICKNESS": files["thickness"],
            "ACCEPTANCES": files["acceptance"], "PANEL": str(tmp_path / "p.png"),
            "REPORT": str(tmp_path / "r.html"),
            "DENSITY": str(tmp_path / "d.tif"), "DENSITY_ERROR": str(tmp_path / "e.tif"),
        },
        feedback,
    )  # fmt: skip
    assert not any("azimuth and elevation" in warning for warning in feedback.warnings)
    assert matplotlib.imread(results["PANEL"]).std() > 0.1
    text = (tmp_path / "r.html").read_text(encoding="utf-8")
    assert text.count("data:image/png;base64,") == 2
    assert "skyline, azimuths and elevations" in text


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"THICKNESS": "muogram"}, ("17 × 10 pixels, tangent", "3 × 2 pixels, azimuth")),
        ({"ACCEPTANCES": "thickness"}, ("holds thickness", "acceptance")),
        ({"ACCEPTANCE": 5}, ("Both ACCEPTANCE and ACCEPTANCES",)),
        ({"THICKNESS": "turned"}, ("make both on the same directions",)),
    ],
)
def test_what_does_not_go_together_is_refused(run, files, tmp_path, change, words):
    from qgis.core import QgsProcessingException

    files["muogram"] = str(tmp_path / "muogram.tif")
    muogram = Muogram("thickness", np.ones((2, 3)), np.arange(3.0), np.array([5.0, 4.0]), PLACE)
    write_muogram(muogram, files["muogram"])
    files["turned"] = str(tmp_path / "turned.tif")
    turned = telescope_map("thickness", np.ones(ACCEPTANCE.shape), 15.0)
    write_trajectories(turned, files["turned"])
    parameters = {
        "COUNTS": "counts", "THICKNESS": "thickness", "ACCEPTANCES": "acceptance", **change,
    }  # fmt: skip
    outputs = {"DENSITY": str(tmp_path / "d.tif"), "DENSITY_ERROR": str(tmp_path / "e.tif")}
    with pytest.raises(QgsProcessingException) as caught:
        run("density", {name: files.get(v, v) for name, v in parameters.items()} | outputs)
    for word in words:
        assert word in str(caught.value)
