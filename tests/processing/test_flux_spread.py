"""The spread of the flux models is one in radiography and in muonflux."""

import numpy as np
import pytest

from muysc_qgis.muogram import read_muogram


def test_radiography_and_muonflux_tell_the_same_spread(run, vesuvius, tmp_path):
    names = ("FLUX", "FLUX_MINIMUM", "FLUX_MAXIMUM")
    thickness = str(tmp_path / "t.tif")
    first = {name: str(tmp_path / f"first_{name}.tif") for name in names}
    second = {name: str(tmp_path / f"second_{name}.tif") for name in names}
    formula = {"FLUX_MODEL": "gaisser-tang"}
    run("radiography", {**vesuvius, **formula, "THICKNESS": thickness, **first})
    run("muonflux", {"THICKNESS": thickness, "FLUX_MODEL": "guan", **second})
    for name in names[1:]:
        one, two = read_muogram(first[name]), read_muogram(second[name])
        # The formula chosen does not matter to the spread.
        np.testing.assert_allclose(two.values, one.values, rtol=2e-5)
        assert one.quantity == name.lower()
        assert "guan" in str(one.metadata["FLUX_MODEL"])
        assert "bugaev, " not in str(one.metadata["FLUX_MODEL"]).replace("reyna-bugaev", "")
    low, middle, high = (read_muogram(first[n]).values for n in (names[1], names[0], names[2]))
    assert np.all(low <= high)
    assert np.mean((low <= middle * 1.001) & (middle * 0.999 <= high)) > 0.95
    assert np.median(high / low) > 1.05


def test_the_muon_sky_tells_its_own_error(run, vesuvius, tmp_path):
    paths = {n: str(tmp_path / f"{n}.tif") for n in ("FLUX", "FLUX_MINIMUM", "FLUX_MAXIMUM")}
    run("radiography", {**vesuvius, "THICKNESS": str(tmp_path / "t.tif"), **paths})
    flux, low, high = (read_muogram(paths[name]) for name in paths)
    np.testing.assert_allclose((low.values + high.values) / 2, flux.values, rtol=1e-5)
    error = (high.values - low.values) / 2 / flux.values
    assert np.all((error > 0.04) & (error < 0.3))
    assert low.metadata["FLUX_MODEL"] == "gsf-sibyll"
    behind = read_muogram(str(tmp_path / "t.tif")).values > 0
    assert float(flux.metadata["FLUX_ERROR"]) / 100 == pytest.approx(
        np.median(error[behind]), rel=0.02
    )


def test_a_spread_that_is_not_wanted_costs_nothing(run, vesuvius, tmp_path):
    results = run(
        "radiography",
        {**vesuvius, "THICKNESS": str(tmp_path / "t.tif"), "FLUX": str(tmp_path / "f.tif")},
    )
    assert "FLUX_MINIMUM" not in results
    assert sorted(path.suffix for path in tmp_path.iterdir()) == [".qml", ".qml", ".tif", ".tif"]
