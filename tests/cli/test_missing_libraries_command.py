"""QGIS as it comes on some systems: without scipy, matplotlib, jinja2 and distributed."""

from dataclasses import replace

import pytest

LIBRARIES = ("scipy", "matplotlib", "jinja2", "dask", "distributed")


@pytest.fixture
def bare(qgis_process, tmp_path):
    """Run qgis_process where none of the libraries can be imported."""
    stubs = tmp_path / "stubs"
    for library in LIBRARIES:
        (stubs / library).mkdir(parents=True)
        (stubs / library / "__init__.py").write_text(
            f"raise ModuleNotFoundError(\"No module named '{library}'\", name={library!r})\n"
        )
    return replace(qgis_process, environment={**qgis_process.environment, "PYTHONPATH": str(stubs)})


def test_the_toolbox_lists_the_same(qgis_process, bare):
    def names(process):
        return {word for word in process("list").stdout.split() if word.startswith("muysc:")}

    assert names(bare) == names(qgis_process)
    assert {"muysc:radiography", "muysc:tomography", "muysc:siteselection"} <= names(bare)


def test_the_main_job_is_done_but_for_the_pictures(bare, data_folder, tmp_path):
    files = {
        "THICKNESS": tmp_path / "thickness.tif",
        "FLUX": tmp_path / "flux.tif",
        "PANEL": tmp_path / "panel.png",
    }
    done = bare.run(
        "radiography",
        {
            "DEM": data_folder / "vesuvius_srtmgl1.tif",
            "DETECTOR": "14.410686,40.810561 [EPSG:4326]",
            "TARGET": "14.424745,40.823729 [EPSG:4326]",
            "AZIMUTH_PIXELS": 10,
            "ELEVATION_PIXELS": 10,
            **files,
        },
    )
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    assert files["THICKNESS"].is_file()
    assert files["FLUX"].is_file()
    assert not files["PANEL"].exists()
    assert "matplotlib, which is missing" in said
