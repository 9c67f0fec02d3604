"""The spread of the flux models is one in radiography and in muonflux."""

import numpy as np

from muysc_qgis.muogram import read_muogram


def test_radiography_and_muonflux_tell_the_same_spread(run, vesuvius, tmp_path):
    names = ("FLUX", "FLUX_MINIMUM", "FLUX_MAXIMUM")
    thickness = str(tmp_path / "t.tif")
    first = {name: str(tmp_path / f"first_{name}.tif") for name in names}
    second = {name: str(tmp_path / f"second_{name}.tif") for name in names}
    run("radiography", {**vesuvius, "THICKNESS": thickness, **first})
    run("muonflux", {"THICKNESS": thickness, "FLUX_MODEL": "guan", **second})
    for name in names[1:]:
        one, two = read_muogram(first[name]), read_muogram(second[name])
        # The model chosen does not matter to the spread.
        np.testing.assert_allclose(two.values, one.values, rtol=2e-5)
        assert one.quantity == name.lower()
        assert "guan" in str(one.metadata["FLUX_MODEL"])
        assert "bugaev, " not in str(one.metadata["FLUX_MODEL"]).replace("reyna-bugaev", "")
    low, middle, high = (read_muogram(first[n]).values for n in (names[1], names[0], names[2]))
    assert np.all(low <= high)
    assert np.mean((low <= middle * 1.001) & (middle * 0.999 <= high)) > 0.95
    assert np.median(high / low) > 1.05


def test_a_spread_that_is_not_wanted_costs_nothing(run, vesuvius, tmp_path):
    results = run(
        "radiography",
        {**vesuvius, "THICKNESS": str(tmp_path / "t.tif"), "FLUX": str(tmp_path / "f.tif")},
    )
    assert "FLUX_MINIMUM" not in results
    assert sorted(path.suffix for path in tmp_path.iterdir()) == [".qml", ".qml", ".tif", ".tif"]
