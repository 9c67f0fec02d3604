"""Files with bytes flipped, cut and blanked, and rasters with absurd metadata."""

from pathlib import Path

import pytest
from hypothesis import strategies as st

from tools.fuzzing.mutations import claims, edits, misstate, mutate
from tools.fuzzing.scene import FOOT, MIDDLE

SIGHT = {"DETECTOR": FOOT, "TARGET": MIDDLE, "ELEVATION_APERTURE": 16, "AZIMUTH_PIXELS": 6,
         "ELEVATION_PIXELS": 5}  # fmt: skip
RASTERS = {"THICKNESS": "*t.tif", "FLUX": "*f.tif"}


@pytest.fixture
def with_bytes_changed(tmp_path, explore, attempt):
    """Try an algorithm on files with their bytes changed."""

    def try_files(sources, parameters_of, name=None):
        def case(drawn):
            source, changes = drawn
            target = tmp_path / (name or Path(source).name)
            mutate(Path(source), target, changes)
            attempt(*parameters_of(str(target)))

        explore(st.tuples(st.sampled_from(sources), edits), case)

    return try_files


@pytest.fixture
def with_claims_changed(tmp_path, explore, attempt):
    """Try an algorithm on rasters that say other things of themselves."""

    def try_rasters(sources, parameters_of):
        def case(drawn):
            source, claim = drawn
            target = tmp_path / Path(source).name
            misstate(Path(source), target, claim)
            attempt(*parameters_of(str(target)))

        explore(st.tuples(st.sampled_from(sources), claims), case)

    return try_rasters


def _radiography(dem):
    return "radiography", {"DEM": dem, **SIGHT, **RASTERS}


def test_terrain_in_geotiff(with_bytes_changed, scene):
    with_bytes_changed([*scene.dems, *scene.odd_dems], _radiography)


def test_terrain_that_claims_absurd_things(with_claims_changed, scene):
    with_claims_changed(scene.dems, _radiography)


def test_terrain_in_hgt(with_bytes_changed, scene):
    with_bytes_changed([scene.tile], _radiography, name="N40E014.hgt")


def test_tiles_to_download(with_bytes_changed, scene):
    def download(tile):
        return "downloadsrtm", {
            "EXTENT": "14.41,14.43,40.81,40.83 [EPSG:4326]", "CACHE": "*cache", "DEM": "*dem.tif",
            "SOURCE": f"file://{Path(tile).parent}/{{tile}}.hgt.gz",
        }  # fmt: skip

    with_bytes_changed([scene.packed_tile], download)


def test_text_tables(with_bytes_changed, scene):
    def imported(table):
        return "importmuogram", {
            "INPUT": table, "QUANTITY": "flux", "VERTICAL_ANGLE": "zenith", "OUTPUT": "*m.tif",
            "AZIMUTH_FIRST": 0, "AZIMUTH_LAST": 20, "VERTICAL_FIRST": 60, "VERTICAL_LAST": 80,
        }  # fmt: skip

    with_bytes_changed([*scene.tables, *scene.odd_files], imported)


def test_layers_of_sites(with_bytes_changed, scene):
    def at_sites(layer):
        view = {name: value for name, value in SIGHT.items() if name != "DETECTOR"}
        return "radiographyatsites", {
            "DEM": scene.dems[0], "SITES": layer, **view, "FOLDER": "*folder",
        }  # fmt: skip

    with_bytes_changed(scene.layers["points"], at_sites)


def _uses(scene):
    """Return who takes a muogram of each quantity, with the other parameters."""
    dem = {"DEM": scene.dems[0]}
    volume = {"EXTENT": "451000,452000,4518400,4519400 [EPSG:32633]", "VOXELS": 8}
    of_density = {"TRANSMISSION": scene.muograms["transmission"][0], "DENSITY": "*d.tif"}
    return {
        "thickness": [
            ("muonflux", "THICKNESS", {"FLUX": "*f.tif"}),
            ("density", "THICKNESS", of_density),
            ("drape", "MUOGRAM", {**dem, "OUTPUT": "*o.tif"}),
            ("importmuogram", "REFERENCE", {"INPUT": scene.tables[0], "OUTPUT": "*m.tif"}),
            ("tomography", "MUOGRAMS", {**dem, **volume, "DENSITY": "*d.tif"}),
        ],
        "opacity": [("muonflux", "OPACITY", {"FLUX": "*f.tif"})],
        "counts": [
            ("density", "COUNTS", {
                "THICKNESS": scene.muograms["thickness"][2], "DENSITY": "*d.tif",
            }),
            ("drape", "MUOGRAM", {**dem, "OUTPUT": "*o.tif"}),
        ],
        "transmission": [
            ("density", "TRANSMISSION", {
                "THICKNESS": scene.muograms["thickness"][0], "DENSITY": "*d.tif",
            }),
        ],
    }  # fmt: skip


@pytest.mark.parametrize("quantity", ["thickness", "opacity", "counts", "transmission"])
def test_muograms(with_bytes_changed, with_claims_changed, scene, quantity):
    source = scene.muograms[quantity][:1]
    for algorithm, parameter, others in _uses(scene)[quantity]:

        def use(path, algorithm=algorithm, parameter=parameter, others=others):
            return algorithm, {**others, parameter: path}

        with_bytes_changed(source, use)
        with_claims_changed(source, use)
