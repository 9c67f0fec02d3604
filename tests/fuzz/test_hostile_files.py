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


def _radiography(dem):
    return "radiography", {"DEM": dem, **SIGHT, **RASTERS}


def test_terrain_in_geotiff(with_bytes_changed, scene):
    with_bytes_changed([*scene.dems, *scene.odd_dems], _radiography)


def test_terrain_that_claims_absurd_things(tmp_path, explore, attempt, scene):
    def case(drawn):
        source, claim = drawn
        misstate(Path(source), tmp_path / "dem.tif", claim)
        attempt(*_radiography(str(tmp_path / "dem.tif")))

    explore(st.tuples(st.sampled_from(scene.dems), claims), case)


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


#: Algorithms, the parameter that takes a muogram, its quantity, and the other parameters.
USES = [
    ("muonflux", "THICKNESS", "thickness", {"FLUX": "*f.tif"}),
    ("muonflux", "OPACITY", "opacity", {"FLUX": "*f.tif"}),
    ("drape", "MUOGRAM", "thickness", {"DEM": "dem", "OUTPUT": "*o.tif"}),
    ("importmuogram", "REFERENCE", "thickness", {"INPUT": "table", "OUTPUT": "*m.tif"}),
    ("density", "THICKNESS", "thickness", {"TRANSMISSION": "transmission", "DENSITY": "*d.tif"}),
    ("density", "TRANSMISSION", "transmission", {"THICKNESS": "thickness", "DENSITY": "*d.tif"}),
    ("density", "COUNTS", "counts", {"THICKNESS": "in tangents", "DENSITY": "*d.tif"}),
    ("tomography", "MUOGRAMS", "thickness", {
        "DEM": "dem", "EXTENT": "451000,452000,4518400,4519400 [EPSG:32633]", "VOXELS": 8,
        "DENSITY": "*d.tif",
    }),
]  # fmt: skip


@pytest.mark.parametrize(
    ("algorithm", "parameter", "quantity", "others"), USES, ids=[f"{a}-{p}" for a, p, *_ in USES]
)
def test_muograms(tmp_path, explore, attempt, scene, algorithm, parameter, quantity, others):
    files = {
        "dem": scene.dems[0],
        "table": scene.tables[0],
        "in tangents": scene.muograms["thickness"][2],
        "thickness": scene.muograms["thickness"][0],
        "transmission": scene.muograms["transmission"][0],
    }
    others = {name: files.get(value, value) for name, value in others.items()}
    source = Path(scene.muograms[quantity][0])
    target = tmp_path / source.name

    def case(drawn):
        change, how = drawn
        change(source, target, how)
        attempt(algorithm, {**others, parameter: str(target)})

    cases = st.one_of(
        st.tuples(st.just(mutate), edits), *[st.tuples(st.just(misstate), claims)] * 2
    )
    explore(cases, case)
