"""Disks that are full and folders that vanish: one sentence, and earlier results as they were."""

import contextlib
import resource
import shutil
import subprocess
import threading

import pytest
from osgeo import gdal, ogr

gdal.UseExceptions()

OLDER = b"older result"


@contextlib.contextmanager
def files_no_longer_than(size):
    """Let no file of this process grow past a size in bytes, as on a disk that is full."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


@pytest.fixture
def every_output(tmp_path):
    """Every kind of output, each over an older result."""
    folder = tmp_path / "outputs"
    folder.mkdir()
    names = {
        "THICKNESS": "thickness.tif", "FLUX": "flux.tif", "FIELD_OF_VIEW": "view.gpkg",
        "PANEL": "panel.png", "REPORT": "report.html",
    }  # fmt: skip
    for name in names.values():
        (folder / name).write_bytes(OLDER)
    return {name: str(folder / file) for name, file in names.items()}


@pytest.fixture
def fails(run, vesuvius, every_output, tmp_path):
    """Run radiography, which fails and leaves everything as it was; return its sentence."""
    from qgis.core import QgsProcessingException

    def sentence(feedback=None, **outputs):
        wanted = outputs or every_output
        with pytest.raises(QgsProcessingException) as failure:
            run("radiography", {**vesuvius, **wanted}, feedback)
        left = [path for path in tmp_path.rglob("*") if path.is_file()]
        assert {str(path) for path in left} <= set(every_output.values())
        assert all(path.read_bytes() == OLDER for path in left)
        said = str(failure.value)
        assert "partial" not in said
        return said

    return sentence


# What is cut short: rasters, styles, the layer, pictures.
@pytest.mark.parametrize("size", [1_000, 2_600, 95_000])
def test_a_full_disk_leaves_nothing(fails, size, capfd):
    with files_no_longer_than(size):
        said = fails()
    assert "cannot be" in said
    assert "Exception ignored" not in capfd.readouterr().err


@pytest.fixture
def small_disk(tmp_path):
    """Make a folder that holds so many KiB; needs the rights to mount."""
    folder = tmp_path / "small"
    folder.mkdir()

    def mount(kib):
        command = ["mount", "-t", "tmpfs", "-o", f"size={kib}k", "tmpfs", str(folder)]
        if subprocess.run(command, capture_output=True, check=False).returncode:
            pytest.skip("no right to mount a small disk")
        return folder

    yield mount
    subprocess.run(["umount", str(folder)], capture_output=True, check=False)


@pytest.mark.parametrize("kib", [8, 24, 100])
def test_a_small_disk_leaves_nothing(fails, small_disk, kib):
    folder = small_disk(kib)
    fails(
        THICKNESS=str(folder / "t.tif"), FLUX=str(folder / "f.tif"),
        FIELD_OF_VIEW=str(folder / "v.gpkg"),
    )  # fmt: skip
    assert not list(folder.iterdir())


@pytest.mark.parametrize("percent", [90, 95])
def test_a_folder_that_vanishes_midway(fails, recorder, tmp_path, percent):
    class Vandal(recorder):
        def note(self, now):
            if now >= percent:
                shutil.rmtree(tmp_path / "outputs", ignore_errors=True)

    assert "outputs" in fails(Vandal())


def test_one_output_that_cannot_be_moved_leaves_all_as_they_were(fails, recorder, tmp_path):
    flux = tmp_path / "outputs" / "flux.tif"

    class Vandal(recorder):
        def note(self, now):
            if now >= 90 and flux.is_file():
                flux.unlink()
                flux.mkdir()

    assert str(flux) in fails(Vandal())
    assert flux.is_dir()


def test_layers_appear_with_the_other_files_only(run, vesuvius, tmp_path, recorder):
    seen = set()

    class Observer(recorder):
        def note(self, now):
            seen.update(path.name for path in tmp_path.iterdir())

    run("radiography", {
        **vesuvius, "THICKNESS": str(tmp_path / "t.tif"), "FLUX": str(tmp_path / "f.tif"),
        "FIELD_OF_VIEW": str(tmp_path / "view.shp"),
    }, Observer())  # fmt: skip
    assert all(name.startswith(".") for name in seen)
    names = {path.name for path in tmp_path.iterdir()}
    assert {"t.tif", "f.tif", "view.shp", "view.shx", "view.dbf", "view.prj"} <= names
    layer = ogr.Open(str(tmp_path / "view.shp"))
    assert layer.GetLayer(0).GetFeatureCount() >= 2


def test_two_runs_of_one_process_write_to_one_file(provider, vesuvius, tmp_path, recorder):
    """Both at once, as background tasks of the desktop do."""
    from qgis.core import QgsProcessingContext

    done = []

    def radiography():
        algorithm = provider.algorithm("radiography").create()
        parameters = {
            **vesuvius, "THICKNESS": str(tmp_path / "t.tif"), "FLUX": str(tmp_path / "f.tif"),
            "FIELD_OF_VIEW": str(tmp_path / "v.gpkg"),
        }  # fmt: skip
        context = QgsProcessingContext()
        done.append(algorithm.processAlgorithm(parameters, context, recorder()))

    runs = [threading.Thread(target=radiography) for _ in range(3)]
    for one in runs:
        one.start()
    for one in runs:
        one.join()
    assert len(done) == 3
    assert {path.name for path in tmp_path.iterdir()} == {
        "t.tif", "t.qml", "f.tif", "f.qml", "v.gpkg",
    }  # fmt: skip
    assert gdal.Open(str(tmp_path / "t.tif")).ReadAsArray().max() > 100
